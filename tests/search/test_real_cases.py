"""What holds at the real points of equations, though not at the complex ones: proofs by cases."""

import pytest

from kowalevski_cas import System
from kowalevski_cas.algebra import EXACT
from kowalevski_cas.paper.claims import Union
from kowalevski_cas.problem import checker
from kowalevski_cas.verify.run import Session
from tests.paper.small import derivation
from tests.sample import sampled

pytestmark = pytest.mark.usefixtures("uncorrected")


def plane():
    return System(r"\dot x=0,\quad \dot y=0,\quad \dot z=0")


@pytest.mark.parametrize(
    ("given", "sets", "verdict"),
    sampled(
        [
            (["x^2+y^2=0"], [["x=0", "y=0"]], "proved"),
            (["2x^2+3y^2+5z^2=0"], [["x=0", "y=0", "z=0"]], "proved"),
            (["x^2y+y=0"], [["y=0"]], "proved"),
            (["x^2+xy+y^2=0"], [["x=y"]], "proved"),
            (["x=y+1", "yz=x", "zx=-y"], [], "proved"),
            (["x^2y^2+1=0"], [], "proved"),
            (["xy=0", "yz=0"], [["y=0"], ["x=0", "z=0"]], "proved"),
            (["x^3-x=0", "x^2+y^2=1"], [["x=0"], ["y=0"]], "proved"),
            (["(x^2+y^2)^2=0"], [["x=0", "y=0"]], "proved"),
            (["x^2-y^2=0"], [["x=y"]], "conditional"),
            (["xy=0", "yz=0"], [["y=0"], ["x=0"]], "proved"),
            (["xy=0"], [["x=0", "z=0"], ["y=0"]], "refuted"),
        ],
        2,
    ),
)
def test_a_union_is_decided_over_the_real_numbers(given, sets, verdict):
    system = plane()
    system.states(Union, "union", "", given=tuple(given), sets=tuple(map(tuple, sets)))
    claimed = derivation(system.section)
    (outcome,) = Session(claimed, EXACT).run().outcomes
    assert str(outcome.verdict) == verdict
    (claim,) = claimed.claims
    text = Session(claimed, ["flint"]).outcome(claim).certificate
    assert checker.check(text).sign == ("denied" if verdict == "refuted" else "holds")
