"""Integrals of motions with sines, exponentials and roots are found; those of mutants are not."""

import pytest

from kowalevski_cas import System

pytestmark = pytest.mark.usefixtures("uncorrected", "here")

PENDULUM = r"\dot\theta=\omega,\ \dot\omega=-\sin\theta"
KEPLER = r"\dot x=u,\ \dot y=v,\ \dot u=-\frac{\mu x}{r^3},\ \dot v=-\frac{\mu y}{r^3}"
TODA = r"\dot q_1=p_1,\ \dot q_2=p_2,\ \dot p_1=-e^{q_1-q_2},\ \dot p_2=e^{q_1-q_2}"
SLEIGH = r"\dot x=v\cos\phi,\ \dot y=v\sin\phi,\ \dot\phi=\omega,\ \dot v=a\omega^2,\ \dot\omega=-b\omega v"
RADIUS = "r^2=x^2+y^2"
MOTIONS = [
    (PENDULUM, "", 2, 1),
    (PENDULUM.replace(r"-\sin", r"-c\omega-\sin"), "", 2, 0),
    (
        PENDULUM.replace(r"-\sin\theta", r"-\sin^2\theta"),
        "",
        3,
        0,
    ),  # an angle alone is in its energy
    (KEPLER, RADIUS, 2, 2),
    (KEPLER.replace(r"\mu y", "y"), RADIUS, 2, 1),  # with another mass in one direction
    (KEPLER.replace("u=-", "u=-cu-").replace("v=-", "v=-cv-"), RADIUS, 2, 0),
    (TODA, "", 4, 2),
    (TODA.replace("p_2=e", "p_2=-e"), "", 4, 2),  # the difference is constant then
    (TODA.replace("p_2=e", "p_2=2e"), "", 4, 2),
    (SLEIGH, "", 2, 1),
    (SLEIGH.replace("-b", "c-b"), "", 2, 0),
]


@pytest.mark.parametrize(("motion", "given", "degree", "number"), MOTIONS)
def test_integrals_in_functions(motion, given, degree, number):
    system = System(motion)
    found = (system.where(given) if given else system).find_integrals(degree)
    assert len(found) == number
    assert all(one.verdict.green for one in found)


def test_functions_have_no_weights():
    with pytest.raises(ValueError, match="have no weights"):
        System(PENDULUM).find_integrals(2, weighted=True)
