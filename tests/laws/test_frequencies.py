"""Equations for frequencies: those of random linear systems, and of others that are near."""

import random

import pytest

from tests.laws.test_prints import FEW
from tests.reading.test_usual_statements import verdicts


def matrix(chance):
    """Stiffnesses; the edges are equal frequencies, a zero one, and growth."""
    a, b, c, d = (chance.randint(-3, 4) for _ in range(4))
    return chance.choice([(a, b, c, d), (a, 0, 0, a), (0, b, 0, d), (a, 0, 0, -a)])


def text(a, b, c, d, damping, equation):
    force = [f"-({p})x-({q})y-{damping}\\dot {z}" for p, q, z in ((a, b, "x"), (c, d, "y"))]
    return (
        rf"Consider \[ \ddot x={force[0]},\qquad\ddot y={force[1]} . \] "
        rf"The frequency equation is $\omega^4-({equation[0]})\omega^2+({equation[1]})=0$."
    )


@FEW
def test_the_equation_of_the_frequencies_is_proved_and_a_near_one_is_not(seed):
    chance = random.Random(seed)
    a, b, c, d = matrix(chance)
    right = (a + d, a * d - b * c)
    assert verdicts(text(a, b, c, d, 0, right))[-1].green
    wrong = (right[0] + chance.choice([-1, 1]), right[1])
    assert not verdicts(text(a, b, c, d, 0, wrong))[-1].green
    assert not verdicts(text(a, b, c, d, 2, right))[-1].green  # with damping it is another one


@pytest.mark.parametrize(
    "equation", [r"\omega^2=1", r"(\omega^2-1)^2=0", r"\omega(\omega^3-\omega)=0"]
)
def test_an_equation_of_another_degree_or_other_roots_is_not_theirs(equation):
    law = r"Consider \[ \ddot x=-x,\qquad\ddot y=-4y . \] "
    found = verdicts(law + rf"The frequency equation is ${equation}$.")
    assert not any(one.green for one in found)
