"""What is constant on an invariant set: by the motion, which is a theorem, or by its equations."""

import pytest

from kowalevski_cas import System
from tests.laws.falsehoods import Maker
from tests.laws.test_false_systems import cross, gradient

pytestmark = pytest.mark.usefixtures("uncorrected", "here")

FEW, MANY = 2, 40
MARKS = [FEW, pytest.param(MANY, marks=pytest.mark.slow)]
REMARK = "it is constant along the motions off this set, too"


class Kept:
    """A motion along which two polynomials are constant, and the set where the second is zero."""

    def __init__(self, maker):
        while True:
            self.point = maker.point()
            self.function, self.set = maker.polynomial(), maker.zero_at(self.point)
            rates = cross(gradient(self.function), gradient(self.set))
            if any(rate(self.point) for rate in rates):  # so the differentials are independent
                break
        x, y, z = (rate.tex for rate in rates)
        self.other = maker.polynomial()
        self.system = System(rf"\dot x={x}, \dot y={y}, \dot z={z}")
        self.system.seconds = 10

    def claimed(self, function):
        return self.system.integral(function, given=f"{self.set.tex}=0")


def kept(many):
    maker = Maker(2002)
    return (Kept(maker) for _ in range(many))


@pytest.mark.parametrize("many", MARKS)
def test_what_is_constant_along_all_motions_is_constant_on_the_set(many):
    for one in kept(many):
        stated = one.claimed(one.function.tex)
        assert (stated.verdict, stated.outcome.message) == ("proved", REMARK), stated


@pytest.mark.slow
@pytest.mark.parametrize("many", MARKS)
def test_what_is_constant_by_itself_or_by_the_equations_of_the_set_is_none(many):
    for one in kept(many):
        by_the_set = (one.set * one.other + 5).tex
        for function in (
            f"{one.set.tex}",
            by_the_set,
            "5",
            "x-x",
            f"{one.other.tex}-({one.other.tex})",
        ):
            stated = one.claimed(function)
            assert stated.verdict == "refuted", stated
            itself = "constant by itself" in stated.outcome.message
            assert itself == (function not in (one.set.tex, by_the_set)), stated


@pytest.mark.parametrize("many", MARKS)
def test_equations_that_are_given_twice_refute_nothing(many):
    """Their differentials depend on each other, whatever the function is."""
    for one in kept(many):
        twice = (f"{one.set.tex}=0", f"{(one.set * one.other).tex}=0")
        stated = one.system.integral(one.function.tex, given=twice)
        assert stated.verdict in ("proved", "undecided"), stated
