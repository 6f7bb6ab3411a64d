"""Small oscillations: an equation that holds near a point up to what vanishes there twice."""

from random import Random

import pytest

from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import reading, verdicts
from tests.sample import sampled

PENDULUM = (
    r"The pendulum moves by \[ \ddot\theta=-\omega^2\sin\theta-2\gamma\dot\theta+\dot\theta^2 . \]"
)
DOUBLE = r"""The Lagrangian is
\[ L=\dot\varphi^2+\tfrac12\dot\psi^2+\dot\varphi\dot\psi\cos(\varphi-\psi)+2\cos\varphi+\cos\psi . \]"""


@pytest.mark.parametrize(
    "words",
    sampled(
        [
            r"Near the equilibrium $\theta=0$ the linearised equation is",
            "For small angles this becomes",
            "Small oscillations obey",
            r"Малые колебания описываются уравнением",
        ],
        1,
    ),
)
@pytest.mark.parametrize(
    ("right", "green"),
    [(r"-\omega^2\theta-2\gamma\dot\theta", True), (r"-\omega^2\theta+2\gamma\dot\theta", False),
     (r"-2\omega^2\theta-2\gamma\dot\theta", False), (r"\omega-\omega^2\theta-2\gamma\dot\theta", False)],
)  # fmt: skip
def test_small_oscillations_obey_the_linear_equation(words, right, green):
    found = verdicts(rf"{PENDULUM} {words} \[ \ddot\theta={right} . \]")
    assert found[rf"\ddot\theta={right}"].green is green
    assert Verdict.REFUTED not in found.values()  # another point may be meant


def test_a_point_that_is_at_rest_is_told():
    found = reading(
        PENDULUM + r"For small angles \[ \ddot\theta=-\omega^2\theta-2\gamma\dot\theta . \]"
    )
    (claim,) = [one for one in found.formulas if one.claim is not None]
    assert [one.printed.tex for one in claim.on] == [r"\theta=0", r"\dot{\theta}=0"]


@pytest.mark.slow
@pytest.mark.parametrize(("factor", "green"), [("2", True), ("3", False)])
def test_the_equations_of_a_lagrangian_are_made_linear(factor, green):
    text = rf"""{DOUBLE} For small angles \[ \ddot\varphi=-2\varphi+\psi,\qquad
    \ddot\psi=2\varphi-{factor}\psi . \]"""
    assert [one.green for one in verdicts(text).values()] == [True, green]


def test_where_nothing_is_small_an_equation_is_exact():
    text = PENDULUM + r"Hence \[ \ddot\theta=-\omega^2\theta-2\gamma\dot\theta . \]"
    assert [one.green for one in verdicts(text).values()] == [False]


@pytest.mark.parametrize("seed", sampled(range(20), 2))
def test_the_linear_part_of_any_law_with_angles_is_proved_and_no_other(seed):
    a, b, c, d, e, f = (Random(seed + 100 * k).randint(-3, 3) for k in range(6))
    law = (
        rf"\ddot\theta={a}\sin\theta{b:+}\dot\theta{c:+}\theta\cos\theta{d:+}\dot\theta^2"
        rf"{e:+}(1-\cos\theta){f:+}\sin2\theta"
    )
    for wrong, damped in ((0, 0), (1, 0), (0, 1)):
        claim = rf"\ddot\theta={a + c + 2 * f + wrong}\theta{b + damped:+}\dot\theta"
        found = verdicts(rf"The law is \[ {law} . \] For small angles \[ {claim} . \]")
        assert [one.green for one in found.values()] == [not wrong + damped], (law, claim)
