"""Where the motion is not defined nothing is said of it, whatever a claim divides by itself."""

import random

import pytest

from kowalevski_cas import System
from kowalevski_cas.paper.derivation import Derivation
from kowalevski_cas.problem import checker
from kowalevski_cas.verify.run import Session

FEW, MANY = 2, 25
pytestmark = pytest.mark.usefixtures("uncorrected", "here")


class Divided:
    """A motion with z' = az + …, that keeps z = 0, y and y = k, where x' is divided by something.

    What it is divided by vanishes where the first of two equations holds, and beside the other.
    """

    def __init__(self, seed):
        choose = random.Random(seed)
        number, k = choose.randint(1, 3), choose.randint(-2, 2)
        self.divisor = choose.choice(["y-k", "(y-k)^2", "(y-k)(z+1)", "(y-k)(z^2+1)", "k-y"])
        self.divisor = self.divisor.replace("k", f"({k})")
        above = choose.choice(["1", "x", "z+2", "x+y+3"])
        self.inside, self.beside = f"y={k}", choose.choice(["z=0", f"y={k + 1}", "z=0,y=7"])
        rates = rf"\dot x=\frac{{{above}}}{{{self.divisor}}},\quad \dot y=0,\quad \dot z={number}z"
        self.system = System(rates)
        self.system.seconds = 10
        self.rate = number

    def claims(self, relation):
        """What would be true of the set if the motion were defined there."""
        given = tuple(relation.split(","))
        yield self.system.invariant(*given)
        yield self.system.integral(f"(y+z)^2({given[0].replace('=', '-(')}))+xz(y+1)", given=given)


def verdict_of(stated):
    """The verdict, which is certified if it is green."""
    verdict = stated.verdict
    if verdict.green:
        derivation = Derivation("", "", "", "", (stated.section,))
        (_, text), *_ = Session(derivation, ("flint",)).certificates(stated.claim)
        assert checker.check(text).sign == "holds"
    return str(verdict)


MARKS = [FEW, pytest.param(MANY, marks=pytest.mark.slow)]


@pytest.mark.parametrize("many", MARKS)
def test_nothing_is_said_of_a_set_inside_the_zeros(many):
    for seed in range(many):
        divided = Divided(seed)
        for stated in divided.claims(divided.inside):
            assert verdict_of(stated) in ("undecided", "refuted"), stated
        invariant = divided.system.invariant(divided.inside)
        assert "is divided by" in invariant.outcome.message


@pytest.mark.parametrize("many", MARKS)
def test_beside_them_the_divisor_is_a_condition(many):
    for seed in range(many):
        divided = Divided(seed)
        invariant = divided.system.invariant(*divided.beside.split(","))
        assert verdict_of(invariant) == "conditional", invariant
        equation = divided.system.identity(rf"\dot z={divided.rate}z")
        assert verdict_of(equation) == "conditional", equation


@pytest.mark.parametrize("many", MARKS)
def test_what_is_not_about_the_motion_needs_no_condition(many):
    for seed in range(many):
        divided = Divided(seed)
        left, right = divided.inside.split("=")
        stated = divided.system.implication(f"x({left}-({right}))=0", given=divided.inside)
        assert verdict_of(stated) == "proved", stated
