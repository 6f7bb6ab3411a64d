"""What words say of coordinates and momenta: that one is cyclic, that the other is an integral."""

import pytest

from kowalevski_cas.audit.reading import ReadingSession, uncovered
from tests.reading.test_reading import reading, verdicts

LAGRANGIAN = r"""The Lagrangian of a spherical pendulum of length $l$ is
\[L=\frac{ml^2}{2}\left(\dot\theta^2+\sin^2\theta\,\dot\varphi^2\right)+mgl\cos\theta .\] """
HAMILTONIAN = r"Let $H=\frac12\left(p_1^2+p_2^2\right)+q_1^2+bq_1q_2^3$. "


def in_words(text: str) -> list[bool]:
    """What is claimed by words alone, in their order."""
    found = reading(text)
    outcomes = ReadingSession(found, timeout=10).outcomes
    printed = {f.claim.id for f in found.formulas if f.claim is not None}
    return [one.verdict.green for claim, one in outcomes.items() if claim not in printed]


@pytest.mark.parametrize(
    ("words", "found"),
    [
        (r"The coordinate $\varphi$ is cyclic.", [True]),
        (r"The coordinate $\theta$ is cyclic.", [False]),
        (r"Since $\varphi$ is ignorable, there is an integral.", [True]),
        (r"Координата $\varphi$ циклическая.", [True]),
        (r"Координата $\theta$ циклическая.", [False]),
        (r"The coordinate $\varphi$ is not cyclic.", []),
        (r"If $\theta$ is cyclic, all is easy.", []),
    ],
)
def test_a_cyclic_coordinate_does_not_stand_in_the_lagrangian(words, found):
    assert in_words(LAGRANGIAN + words) == found


def test_nor_does_it_stand_in_the_hamiltonian():
    assert in_words(HAMILTONIAN + "Then $q_2$ is cyclic.") == [False]
    assert in_words(HAMILTONIAN.replace("bq_1q_2^3", "q_1p_2") + "Then $q_2$ is cyclic.") == []


@pytest.mark.slow
@pytest.mark.parametrize(
    ("momentum", "found"),
    [
        (r"p_\varphi=ml^2\sin^2\theta\,\dot\varphi$ conjugate to $\varphi", [True, True]),
        (r"p_\varphi=2ml^2\sin^2\theta\,\dot\varphi$ conjugate to $\varphi", [False, True]),
        (r"p_\theta=ml^2\dot\theta$ conjugate to $\theta", [True, False]),
    ],
)
def test_a_momentum_may_be_called_an_integral_too(momentum, found):
    text = rf"{LAGRANGIAN}The momentum ${momentum}$ is an integral of motion."
    assert [one.green for one in verdicts(text).values()] == found[:1]
    assert in_words(text) == found[1:]
    assert not uncovered(reading(text))


FLOW = r"Consider the flow \[\dot x=yz,\quad\dot y=-2xz,\quad\dot z=xy .\] "


@pytest.mark.parametrize(
    ("words", "found"),
    [
        (r"It conserves $F=x^2-z^2$ and $G=y^2+2z^2$.", [True, True]),
        (r"It conserves the functions $F=x^2+z^2$ and $G=y^2+2z^2$.", [False, True]),
        (r"The equations conserve both $x^2-z^2$ and $y^2+z^2$.", [True, False]),
        (r"It does not conserve $F=x^2+z^2$, and conserves $G=y^2+2z^2$.", [True]),
        (r"An exact invariant of the motion is $F=y^2+2z^2$.", [True]),
        (r"The function $F=x^2+z^2$ is an invariant.", [False]),
        (r"The function $F=x^2+z^2$ is an adiabatic invariant.", []),
        (r"The Casimir-like invariant is $F=x^2-z^2$.", [True]),
    ],
)
def test_what_is_conserved_or_an_invariant_is_an_integral(words, found):
    assert [one.green for one in verdicts(FLOW + words).values()] == found
