"""Products of printed roots: they are equal where their squares are, and none is negative."""

import random
from math import isqrt

import pytest

from kowalevski_cas import System
from tests.laws.test_prints import FEW
from tests.sample import sampled

pytestmark = pytest.mark.usefixtures("uncorrected")

FLOW = r"\dot a=bc, \dot b=ca, \dot c=ab, \dot d=a"


def monomial(powers):
    return "".join(f"{letter}^{e}" for letter, e in powers.items() if e) or "1"


def product_of_roots(seed):
    """Letters that a root says to be positive, a number, a monomial in these, and its square."""
    chance = random.Random(seed)
    positive = chance.sample("abc", chance.randint(1, 3))
    number = chance.randint(2, 5)
    outside = {letter: chance.randint(0, 3) for letter in positive} | {
        "d": 2 * chance.randint(0, 1)
    }
    over = chance.choice([letter for letter in positive])
    whole = {letter: 2 * e for letter, e in outside.items()}
    for letter in positive:
        whole[letter] += 1
    left = rf"\sqrt{{\frac{{{number**2}{monomial(whole)}}}{{{over}^2}}}}"
    roots = "".join(rf"\sqrt{{{letter}}}" for letter in positive)
    return left, number, outside, over, roots


@pytest.mark.slow
@FEW
def test_the_sign_of_a_root_is_that_of_what_others_say(seed):
    left, number, outside, over, roots = product_of_roots(seed)
    flow, right = System(FLOW), rf"\frac{{{monomial(outside)}{roots}}}{{{over}}}"
    assert flow.identity(f"{left}={number}{right}").verdict == "conditional", left
    for false in (f"{left}=-{number}{right}", f"{left}={number + 1}{right}"):
        assert flow.identity(false).verdict == "refuted", false
    odd = {**outside, "d": outside["d"] + 1}
    whole = rf"\sqrt{{d^2}}{left}={number}\frac{{{monomial(odd)}{roots}}}{{{over}}}"
    assert flow.identity(whole).verdict == "refuted", whole


@FEW
def test_roots_of_what_is_manifestly_positive(seed):
    chance = random.Random(seed)
    a, b = chance.randint(1, 4), chance.randint(1, 4)
    inner = f"{a}a^2+{b}b^4+{chance.randint(1, 3)}"
    flow = System(FLOW)
    assert flow.identity(rf"\sqrt{{({inner})^2}}={inner}").verdict == "proved"
    assert flow.identity(rf"\sqrt{{({inner})^2}}=-({inner})").verdict == "refuted"
    other = inner.replace("b^4", "b^3")
    assert flow.identity(rf"\sqrt{{({other})^2}}={other}").verdict == "refuted"
    square = a * a * b
    root = isqrt(square) if isqrt(square) ** 2 == square else None
    value = str(root) if root else rf"{a}\sqrt{{{b}}}"
    assert flow.identity(rf"\sqrt{{{square}a^2}}={value}\sqrt{{a^2}}").verdict == "proved"


@pytest.mark.parametrize(
    ("tex", "verdict"),
    sampled(
        [
            (r"\sqrt{a^4}=a^2", "proved"),
            (r"\sqrt{a^6}=a^3", "refuted"),
            (r"\sqrt{\cosh^2a}=\cosh a", "proved"),
            (r"\sqrt{\sinh^2a}=\sinh a", "refuted"),
            (r"\sqrt{\cos^2a}=\cos a", "refuted"),
            (r"\sqrt{ab}=\sqrt{-a}\sqrt{-b}", "proved"),
            (r"\sqrt a\sqrt b=\sqrt{ab}", "proved"),
            (r"\sqrt a\sqrt b=-\sqrt{ab}", "refuted"),
            (r"\sqrt{\frac ab}=\frac{\sqrt{ab}}{b}", "refuted"),
            (r"\sqrt{\frac{a}{b}}\sqrt{\frac{b}{a}}=1", "conditional"),
            (r"\lvert ab\rvert=\lvert a\rvert\lvert b\rvert", "proved"),
        ],
        1,
    ),
)
def test_the_edges(tex, verdict):
    assert System(FLOW).identity(tex).verdict == verdict
