"""What follows from an energy, near a place, on a circle: true, and with one number changed."""

from random import Random

import pytest
from sympy import Rational, diff, expand, integrate, latex, symbols

from tests.reading.test_reading import verdicts

x = symbols("x")


def _force(chosen: Random):
    return sum(chosen.choice([-3, -2, -1, 1, 2, 3]) * x**k for k in (1, 2, 3))


def by_the_energy(chosen: Random) -> tuple[str, str, str]:
    """A velocity by the energy, with its coefficient."""
    force = _force(chosen)
    potential = latex(integrate(-force, x))
    text = (
        rf"A point moves by \[\ddot x={latex(force)}.\] The energy is"
        rf" $h=\frac12\dot x^2+({potential})$. Then $\dot x^2=%s h-2({potential})$."
    )
    return text, "2", latex(2 + chosen.choice([-1, Rational(1, 2), 1, 2]))


def of_separation(chosen: Random) -> tuple[str, str, str]:
    """Two equations with one new constant, in a sentence or in two."""
    a, b = chosen.sample([1, 2, 3, 5], 2)
    joined = chosen.choice([", ", " and ", ". Similarly, "])
    text = (
        rf"Two oscillators move by \[\ddot x=-{a}x,\quad\ddot y=-{b}y.\] The energy is"
        rf" $h=\frac12(\dot x^2+\dot y^2+{a}x^2+{b}y^2)$. We have"
        rf" $\dot x^2=\alpha-{a}x^2${joined}$\dot y^2=2h%s\alpha-{b}y^2$."
    )
    return text, "-", chosen.choice(["+", "-2", "-3"])


def near_a_place(chosen: Random) -> tuple[str, str, str]:
    """A linear equation near a point of rest that is not the origin."""
    place = chosen.choice([1, 2, 3])
    force = expand((x - place) * (_force(chosen) + 100))
    slope = diff(force, x).subs(x, place)
    text = (
        rf"A point moves by \[\ddot x={latex(force)}.\] Near $x={place}$ we have"
        rf" $\ddot x=(%s)(x-{place})$."
    )
    return text, latex(slope), latex(slope + chosen.choice([-1, 1, 2]))


def on_a_circle(chosen: Random) -> tuple[str, str, str]:
    """The acceleration of an angle that gives two variables."""
    a = chosen.choice([1, 2, 3])
    pull, by_angle = chosen.choice([(r"\gamma_1", r"\cos\theta"), (r"\gamma_2", r"\sin\theta")])
    text = (
        rf"Consider \[\dot\gamma_1=-{a}r\gamma_2,\quad\dot\gamma_2={a}r\gamma_1,\quad"
        rf"\dot r=k{pull}.\] We put $\gamma_1=\cos\theta$, $\gamma_2=\sin\theta$."
        rf" Then $\ddot\theta=%sk{by_angle}$."
    )
    return text, str(a), str(a + chosen.choice([1, 2]))


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("kind", [by_the_energy, of_separation, near_a_place, on_a_circle])
def test_a_consequence_is_green_as_it_is_and_not_with_another_number(kind, seed):
    text, right, wrong = kind(Random(seed))
    assert all(one.green for one in verdicts(text % right).values()), text % right
    assert not all(one.green for one in verdicts(text % wrong).values()), text % wrong
