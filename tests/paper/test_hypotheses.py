"""What is claimed of nothing is never green: settings and hypotheses that no real point satisfies."""

from dataclasses import replace
from functools import cache

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kowalevski_cas.library import available, find, load
from kowalevski_cas.notation import Number
from kowalevski_cas.paper.claims import (
    DoubleZero,
    FirstIntegral,
    Identity,
    Implication,
    InvariantRelations,
)
from kowalevski_cas.problem.accept import Judge
from kowalevski_cas.problem.evidence import Found
from kowalevski_cas.problem.examine import Unproved
from kowalevski_cas.problem.finder import finder_of
from kowalevski_cas.problem.goals import Exists
from kowalevski_cas.verify.certificate import load_certificates
from kowalevski_cas.verify.run import Session
from kowalevski_cas.verify.statement import Statement
from tests.paper.small import Oscillator, decide

pytestmark = pytest.mark.usefixtures("uncorrected", "here")

NOTHING = "no real point is known that satisfies the hypotheses"

few = settings(max_examples=settings.default.max_examples // 3)
"""A search that has to come to its end is dear."""

whole = st.integers(-3, 3)
polynomials = st.builds(
    "{0:+d}x{1:+d}v{2:+d}".format, whole.filter(bool), whole, whole
) | st.sampled_from(["x^2-v", "xv+1", "x^3+v", "2xv"])
conclusions = st.sampled_from(["x=x", "x=v", "v=v+1", "x^2=x", "xv=0", r"\frac{x}{2}=v-1"])


def empty_given(p, q, n):
    """Equations that no real point solves."""
    return st.sampled_from(
        [[f"({p})^2+({q})^2={-n}"], [p + "=0", f"{p}={n}"], [f"({p})^4={-n}", "x=0"], [f"0={n}"]]
    )


def printed(small, equations):
    return tuple(small(tex) for tex in equations)


@st.composite
def hypotheses(draw):
    """A small scene, with a set of given equations that are solved nowhere in it, and words."""
    small = Oscillator()
    p, q, n = draw(polynomials), draw(polynomials), draw(st.integers(1, 5))
    scene = replace(small.scene, roots={})
    kind = draw(st.sampled_from(["contradictory", "assumed not to vanish", "no root", "excluded"]))
    if kind == "contradictory":
        return small, scene, draw(empty_given(p, q, n)), kind
    if kind == "assumed not to vanish":
        return small, replace(scene, nonzero=(p,)), [f"{p}=0"], kind
    if kind == "no root":
        root = small(f"R^2=-({p})^2-({q})^2-{n}")
        return small, scene.adjoining(root), ["x=1", "R^2+R=v"], kind
    return small, scene, [f"{p}=0", rf"\frac{{v+1}}{{{p}}}=v"], kind


def claims(small, scene, given_ones, conclusion):
    """Claims of several kinds about what is given; the implication comes first."""
    places, own = printed(small, given_ones), small(conclusion)
    member = small("E=xv")
    return [
        Implication("implication", scene, "", printed=own, given=places),
        FirstIntegral("integral", scene, "", printed=member, given=places),
        DoubleZero("double-zero", scene, "", printed=small("x^2v^2"), given=places),
        InvariantRelations("invariant", scene, "", relations=places),
    ]


@few
@given(hypotheses(), conclusions)
def test_nothing_follows_from_hypotheses_that_no_real_point_satisfies(drawn, conclusion):
    small, scene, given_ones, kind = drawn
    outcomes = decide(small.section, *claims(small, scene, given_ones, conclusion))
    for outcome in outcomes:
        assert not outcome.verdict.green, (kind, given_ones, outcome.claim)
    refused = kind == "no root" and outcomes[0].verdict == "error"  # it is seen before any search
    assert refused or (outcomes[0].verdict, outcomes[0].message) == ("undecided", NOTHING)


@few
@given(st.integers(-4, 4), st.integers(-4, 4), whole.filter(bool), conclusions)
def test_the_same_conclusions_are_decided_on_a_line_through_a_point(a, b, k, conclusion):
    """The hypotheses hold at (a, b), and the conclusion does or does not."""
    small = Oscillator()
    scene = replace(small.scene, roots={})
    line = printed(small, [f"x={a}", f"{k}v={k * b}"])
    outcome = small.outcome(Implication, conclusion, scene, given=line)
    left, right = (side.replace("^2", "**2").replace("xv", "x*v").replace(r"\frac{x}{2}", "x/2")
                   for side in conclusion.split("="))  # fmt: skip
    holds = eval(left, {"x": a, "v": b}) == eval(right, {"x": a, "v": b})
    assert outcome.verdict == ("proved" if holds else "refuted")


@few
@given(polynomials, polynomials, st.integers(1, 5))
def test_an_identity_in_a_setting_without_a_real_point(p, q, n):
    small = Oscillator()
    root = small(f"R^2=-({p})^2-({q})^2-{n}")
    scene = replace(small.scene, roots={}).adjoining(root)
    outcome = small.outcome(Identity, "R^2+v=v+R^2", scene)
    refused = outcome.verdict == "error" and "R is real" in outcome.message
    assert refused or (outcome.verdict, outcome.message) == ("undecided", NOTHING)


@pytest.mark.parametrize("sign", ["", "-"])
def test_a_root_is_real(sign):
    """The root of x² + v² is that of a real number; the root of its opposite is none."""
    small = Oscillator()
    scene = replace(small.scene, roots={}).adjoining(small(f"R^2={sign}(x^2+v^2+1)"))
    verdict = small.verdict(Identity, r"\frac{d}{dt}(R^2)=0", scene)
    assert verdict == ("error" if sign else "proved")


@cache
def existing(papers):
    """What is said to exist in papers: statement, goal, and what was found."""
    found = []
    for name in papers:
        session = Session(load(name), ["flint"], certificates=load_certificates(find(name)))
        for claim in session.derivation.claims:
            statement = Statement(claim, session.on(claim))
            if any(isinstance(goal, Exists) for goal in statement.goals):
                pairs = zip(
                    statement.goals,
                    session.decider.archive.evidence(statement, claim.id),
                    strict=True,
                )
                found += [(statement, g, e) for g, e in pairs if isinstance(g, Exists)]
    return found


@pytest.mark.slow
@pytest.mark.parametrize(
    "papers", [("kharlamov2002",), pytest.param(tuple(available()), marks=pytest.mark.slow)]
)
def test_what_exists_is_not_zero(papers):
    """A transformation, a cofactor matrix, a root that is zero shows nothing."""
    for _, goal, found in existing(papers):
        judge = Judge(finder_of)
        judge.holds(goal, found)
        for name in (None, *goal.bound):
            values = {n: Number(0) if name in (n, None) else v for n, v in found.values.items()}
            if values != found.values:
                with pytest.raises(Unproved):
                    judge.holds(goal, found._replace(values=values))
    assert {statement.claim.id for statement, _, _ in existing(papers)} >= {"limit", "eq7", "eq15"}


def test_what_exists_is_used():
    """A value for a name that stands in no goal is none."""
    _, goal, found = existing(("kharlamov2002",))[0]
    more = replace(goal, expressions=(*goal.expressions, "unused"))
    with pytest.raises(Unproved, match="not used"):
        Judge(finder_of).holds(more, Found({**found.values, "unused": Number(1)}, found.evidence))


def test_a_root_of_a_root_of_what_is_complex():
    """All roots of which nothing else is said are real: so z is, and at least 1."""
    small = Oscillator()
    first, second = small("p^2=z_1"), small("q^2=p-1")
    scene = replace(small.new, definitions={}).adjoining(first, second)
    outcome = small.outcome(Identity, "q^4=z_1-2p+1", scene)
    assert outcome.verdict == "proved"
