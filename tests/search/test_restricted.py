"""Integrals on invariant sets: the classical ones are found, and nothing that follows from them."""

import pytest

from kowalevski_cas import System
from kowalevski_cas.problem import checker
from kowalevski_cas.verify.outcome import Verdict
from kowalevski_cas.verify.run import Session
from tests.paper.small import derivation

pytestmark = pytest.mark.usefixtures("here")

CHAPLYGIN = (
    r"4\dot p=3qr,\quad 4\dot q=-3pr-cn,\quad \dot r=cm,\quad "
    r"\dot l=rm-qn,\quad \dot m=pn-rl,\quad \dot n=ql-pm"
)


def found(motion, degree, *relations):
    """What is found is green, and certified."""
    system = System(motion)
    answers = system.find_integrals(degree, on=relations)
    assert all(one.verdict in (Verdict.PROVED, Verdict.CONDITIONAL) for one in answers)
    session = Session(derivation(system.section), ["flint"])
    for claim in session.derivation.claims:
        assert all(
            checker.check(t).sign == "holds" for t in session.outcome(claim).certificates.values()
        )
    return [repr(one).partition("; ")[2] for one in answers]


def test_goryachev_and_chaplygin():
    *general, own = found(CHAPLYGIN, 3, "4pl+4qm+rn=0")
    assert general == ["l² + m² + n²", "4p² + 4q² + r² − 2lc"]
    assert own == "p²r + pnc + q²r"


@pytest.mark.parametrize(
    ("motion", "relations", "expected"),
    [
        (r"\dot x=x,\quad \dot y=xy+z,\quad \dot z=-y", ["x=0"], ["y² + z²"]),
        (r"\dot x=y,\quad \dot y=-x,\quad \dot z=z(x^2+y^2-a)", ["x^2+y^2=a"], ["z"]),
        (r"\dot x=yz,\quad \dot y=zx,\quad \dot z=xy", ["x=y"], ["y² − z²"]),
        (r"\dot x=x(1-y),\quad \dot y=y(x-1)", ["x=0"], []),
    ],
)
def test_what_is_constant_on_a_set_only(motion, relations, expected):
    assert found(motion, 2, *relations) == expected


@pytest.mark.parametrize(
    ("relations", "why"),
    [
        (["p=0"], "are no combinations of them"),
        (["p=p"], "hold everywhere"),
        (["r=0", "m=0", "r=1"], "hold nowhere"),
        (["p"], "is no equation"),
    ],
)
def test_what_is_no_invariant_set_is_refused(relations, why):
    with pytest.raises(ValueError, match=why):
        found(CHAPLYGIN, 2, *relations)


def test_what_excludes_each_other_is_refused():
    top = System(CHAPLYGIN)
    with pytest.raises(ValueError, match="either --on or --weighted"):
        top.find_integrals(2, weighted=True, on=["p=0"])
    with pytest.raises(ValueError, match="--cofactor or --special"):
        top.find_darboux(1, special=True, cofactor="r")
