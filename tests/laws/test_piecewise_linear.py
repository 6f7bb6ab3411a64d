r"""Sums of absolute values, maxima and minima: what is true of them is proved, and nothing else.

The truth is found without the program: such a function of x and y that has no constant term is
linear between two neighbours of the lines on which something between bars vanishes, so that it is
decided by its values at these lines and between them.
"""

import random
from fractions import Fraction
from itertools import pairwise

import pytest

from kowalevski_cas import System
from tests.laws.test_prints import FEW
from tests.reading.test_reading import verdicts

pytestmark = pytest.mark.usefixtures("uncorrected")


def plane():
    return System(r"\dot x=y,\ \dot y=-x")


def linear(a, b):
    return f"({a}x+({b})y)", lambda x, y: a * x + b * y


def rays(lines):
    """Points of all lines through the origin that some forms give, and one between each two."""
    ends = [(-b, a) for a, b in lines] + [(b, -a) for a, b in lines] + [(1, 0), (-1, 0)]

    def turn(point):
        x, y = point
        upper = y > 0 or (y == 0 and x > 0)
        size = abs(x) + abs(y)
        return (not upper, -Fraction(x, size) if upper else Fraction(x, size))

    ends = sorted(ends, key=turn)
    between = [(a + c, b + d) for (a, b), (c, d) in pairwise([*ends, ends[0]])]
    return [*ends, *between]


@FEW
def test_a_sum_of_absolute_values_is_compared_with_nothing(seed):
    chance = random.Random(seed)
    pick = lambda: (chance.randint(-2, 2), chance.choice([-2, -1, 1, 2]))  # noqa: E731
    forms = [pick() for _ in range(chance.randint(2, 3))]
    factors = [chance.choice([-1, 1, 1, 2]) for _ in forms]
    rest = pick()
    tex = "+".join(f"({c})|{linear(*form)[0]}|" for c, form in zip(factors, forms, strict=True))

    def value(x, y):
        sums = (c * abs(linear(*form)[1](x, y)) for c, form in zip(factors, forms, strict=True))
        return sum(sums) + linear(*rest)[1](x, y)

    true = all(value(x, y) >= 0 for x, y in rays(forms))
    claim = plane().inequality(rf"{tex}+{linear(*rest)[0]}\ge0")
    assert claim.verdict == ("proved" if true else "refuted"), claim
    above = plane().inequality(rf"{tex}+{linear(*rest)[0]}+1>0")
    assert above.verdict == ("proved" if true else "refuted"), above


TRUE = [
    r"|x+y|\le|x|+|y|",
    r"||x|-|y||\le|x-y|",
    r"|x-1|+|x+1|\ge2",
    r"\min(x,y)\le\frac{x+y}2\le\max(x,y)",
    r"\max\{x,y\}\ge\min\{x,y,1\}",
    r"\max(x,0)\ge x",
]
FALSE = [
    r"|x+y|\ge|x|+|y|",
    r"||x|-|y||\ge|x-y|",
    r"|x-1|+|x+1|>2",
    r"\min(x,y)<\max(x,y)",
    r"\max(x,0)\ge|x|",
    r"\max(x,y)\ge1",
]


@pytest.mark.parametrize("tex", TRUE)
def test_what_is_true_everywhere_is_proved(tex):
    assert plane().inequality(tex).verdict == "proved"


@pytest.mark.parametrize("tex", FALSE)
def test_what_fails_somewhere_is_refuted(tex):
    assert plane().inequality(tex).verdict == "refuted"


@pytest.mark.parametrize(
    ("left", "right"),
    [
        (r"\max(x,y)", r"\frac{x+y+|x-y|}2"),
        (r"\max(x,y)+\min(x,y)", "x+y"),
        (r"\max(x,y)\min(x,y)", "xy"),
        (r"\max(x,\max(y,1))", r"\max(\max(x,y),1)"),
        (r"\max(x,\min(y,1))", r"\min(\max(x,y),\max(x,1))"),
        (r"\min\{x,y,1\}", r"-\max\{-x,-y,-1\}"),
        ("||x|-x|", "|x|-x"),
    ],
)
def test_maxima_and_minima_obey_their_laws(left, right):
    assert plane().identity(f"{left}={right}").verdict == "proved"
    assert plane().identity(f"{left}={right}+1").verdict == "refuted"


def test_what_holds_where_something_is_supposed():
    system = plane().supposing(r"x\le y")
    assert system.identity(r"\max(x,y)=y").verdict == "proved"
    assert system.identity(r"\max(x,y)=x").verdict == "refuted"
    assert plane().identity(r"\max(x,y)=y").verdict == "refuted"


def test_a_maximum_of_one_number_is_refused():
    claim = plane().identity(r"\max(x)=x")
    assert claim.verdict == "error" and "no meaning" in claim.outcome.message


def test_maxima_are_read_in_papers():
    text = (
        r"The equations of motion are $$\dot x=y,\qquad \dot y=-x.$$ It is easy to see that "
        r"$$\max(x,y)+\min(x,y)=x+%s.$$"
    )
    (true,), (false,) = (verdicts(text % name).values() for name in ("y", "2y"))
    assert true == "proved" and not false.green


@FEW
def test_bars_within_bars_are_read(seed):
    chance = random.Random(seed)
    a, b, c = (chance.randint(1, 4) for _ in range(3))
    nested = rf"||{a}x|-|{b}y||"
    named = System(rf"\dot x=y,\ \dot y=-x,\ p=|{a}x|,\ q={b}|y|,\ r=p-q")
    assert named.identity(f"{nested}=|r|").verdict == "proved"
    assert named.identity(f"{nested}+{c}=|r|").verdict == "refuted"
    assert named.identity(rf"\left||{a}x|-{b}|y|\right|=|r|").verdict == "proved"
    claim = named.identity(f"||{a}x|-{b}|y|+{c}|=|r|")  # it may be ||x|-b| times y times |c|
    assert claim.verdict == "error" and "belong together" in claim.outcome.message
