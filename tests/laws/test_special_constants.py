r"""Relations of constants that hold in several ways, as :math:`a^2=b^2`, or of which one follows.

What is so in each way is green, and what fails in one is red. The truth is looked up on a grid.
"""

import random
from itertools import product

import pytest

from kowalevski_cas import System
from tests.laws.test_prints import FEW

pytestmark = pytest.mark.usefixtures("uncorrected")

FACTORS = {
    "a": lambda a, b, c: a,
    "a-b": lambda a, b, c: a - b,
    "b+c": lambda a, b, c: b + c,
    "a-1": lambda a, b, c: a - 1,
    "2c-b": lambda a, b, c: 2 * c - b,
    "a^2+b^2": lambda a, b, c: a**2 + b**2,
    "a^2+1": lambda a, b, c: a**2 + 1,
    "(b-c)^2": lambda a, b, c: b - c,
}
GRID = [*product(range(-2, 3), repeat=3)]


def plane():
    return System(r"\dot x=y,\quad \dot y=-ax+b-c")


@FEW
def test_a_product_vanishes_where_a_factor_does(seed):
    chance = random.Random(seed)
    factors = chance.sample([*FACTORS], chance.choice([1, 2, 3]))
    claimed = chance.sample([*FACTORS], chance.choice([1, 2]))
    relation = "".join(f"({one})" for one in factors) + "=0"
    there = [p for p in GRID if any(FACTORS[one](*p) == 0 for one in factors)]
    if not there:
        with pytest.raises(ValueError, match="no real constants"):
            plane().where(relation)
        return
    true = all(any(FACTORS[one](*p) == 0 for one in claimed) for p in there)
    verdict = (
        plane().where(relation).identity("".join(f"({one})" for one in claimed) + "=0").verdict
    )
    assert verdict.green if true else verdict == "refuted", (relation, claimed, verdict)


@pytest.mark.parametrize(
    ("relation", "true", "false"),
    [
        ("a^2=b^2", r"a=\pm b", "a=b"),
        ("a^3=b^3", "a=b", "a=-b"),
        ("a^2+b^2=2ab", "a=b", "a=0"),
        ("a^2+b^2=0", "a=b", "a=1"),
    ],
)
def test_and_other_relations_in_each_way(relation, true, false):
    assert plane().where(relation).identity(true).verdict == "proved"
    assert plane().where(relation).identity(false).verdict == "refuted"


def test_what_is_known_is_said_twice_or_contradicted():
    assert plane().where("a=b", "b=a").identity("a=b").verdict == "proved"
    assert plane().where("a=b", "b=a").identity("a=1").verdict == "refuted"
    assert plane().where("a=b").where("b=2a").identity("a=0").verdict == "proved"
    for contradiction in ("b=a+1", "(a-b)^2+1=0"):
        with pytest.raises(ValueError, match="no real constants"):
            plane().where("a=b").where(contradiction)


@pytest.mark.parametrize(
    ("relations", "true", "false"),
    [
        (["ab=0", r"a\ne0"], "b=0", "a=0"),
        ([r"a\ne0", "ab=0"], "b=0", "a=0"),
        (["a>0", "b>0", "a^2=b^2"], "a=b", "a=-b"),
        (["abc=0", "a=1"], "bc=0", "b=0"),
    ],
)
def test_a_way_that_contradicts_what_is_supposed_is_none(relations, true, false):
    system = plane()
    for relation in relations:
        system = system.where(relation)
    assert system.identity(true).verdict == "proved"
    assert system.identity(false).verdict == "refuted"


def test_the_root_that_gives_a_constant_is_real():
    assert plane().where(r"a=\sqrt b").inequality(r"b\ge0").verdict == "proved"
    assert plane().where(r"a=\sqrt b").inequality("b>0").verdict == "refuted"
    assert plane().where(r"a=\sqrt b").inequality("a>0").verdict == "refuted"
