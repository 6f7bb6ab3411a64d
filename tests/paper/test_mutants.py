"""Mutants: a sign, an index, a power changed. False ones are refuted at points that are checked here."""

from itertools import islice, pairwise

import pytest
from kowalevski_cas.proof.evidence import load_evidence
from kowalevski_cas.stage import StageError

from kowalevski_cas.cli.formats.json import counterexample as in_tex
from kowalevski_cas.library import load
from kowalevski_cas.notation import Constant, Name, NotationError, Power, Relation
from kowalevski_cas.paper.claims import (
    ChangedEquation,
    Coefficient,
    Equivalence,
    FirstIntegral,
    Identity,
    Implication,
)
from kowalevski_cas.verify.run import Session
from tests.paper.plain import close, complex_motion, evaluate, motion, value

DERIVATION = load("kharlamov2002")
CLAIMS = {claim.id: claim for claim in DERIVATION.claims}
ENOUGH = 8

NOT_BY_HAND = {
    # their points satisfy relations that the equations written by hand do not know
    "eq9.i", "eq22", "redundant-integral", "appelrot-squares.1", "appelrot-squares.2",
}  # fmt: skip


@pytest.fixture(scope="module")
def session(folder):
    """The paper, with its misprints corrected."""
    session = Session(DERIVATION, ["flint"], False, load_evidence(folder))
    for claim in DERIVATION.claims:
        session.decide(claim)
    return session


def refuted_mutants(session, claim):
    """Mutants that are refuted, with the finding."""
    for neighbour in islice(claim.neighbours(session.texts), 60):
        bench = session._bench("flint", session.texts).with_texts(neighbour.texts)
        try:
            finding = neighbour.claim.decide(bench)
        except (StageError, NotationError, ZeroDivisionError):
            continue
        if finding.verdict == "refuted":
            yield neighbour, finding


@pytest.mark.parametrize("id", [id for id in CLAIMS if id not in {"critical-set", "equilibria"}])
def test_a_mutant_is_refuted_at_an_exact_point(session, id):
    _, finding = next(refuted_mutants(session, CLAIMS[id]))
    assert finding.counterexample.left != finding.counterexample.right
    assert finding.counterexample.point.values


def on_by_hand(claim):
    kinds = (Identity, ChangedEquation, FirstIntegral, Equivalence, Implication)
    if not isinstance(claim, kinds) or isinstance(claim, Coefficient) or claim.id in NOT_BY_HAND:
        return False
    return (
        claim.scene.name not in {"any body", "general body"}
        and getattr(claim, "root", None) is None
    )


def is_level(formula, names):
    """Whether a member is a name, or a square of one, that only stands for a value."""
    base = formula.base if isinstance(formula, Power) else formula
    return isinstance(base, Name) and base.name not in names


@pytest.mark.parametrize("id", [id for id, claim in CLAIMS.items() if on_by_hand(claim)])
def test_the_two_values_are_those_that_plain_python_finds(session, id):
    claim, checked = CLAIMS[id], 0
    for neighbour, finding in refuted_mutants(session, claim):
        found = finding.counterexample
        shown = in_tex(found)
        point = shown["point"]
        by_hand = complex_motion if claim.scene.time == r"\tau" else motion
        names = by_hand(point)
        if "w_3" in point:
            names["w_3"] = value(point["w_3"]) + names["i"] * 0
        names |= {k: value(tex) + names["i"] * 0 for k, tex in point.items() if k not in names}
        formula = neighbour.texts.formula(neighbour.printed)
        members = formula.members if isinstance(formula, Relation) else (formula,)
        members = [m for m in members if not isinstance(m, Constant)]
        if isinstance(claim, FirstIntegral):
            # Of a chain, the member that moves; bare names stand for the value, or move too.
            rates = [evaluate(m, names).rate for m in members if not is_level(m, names)]
            assert any(close(rate, value(shown["left"])) for rate in rates)
            assert value(shown["right"]) == 0 != value(shown["left"])
        elif isinstance(claim, Identity):
            values = [evaluate(member, names).value for member in members]
            pairs = [*pairwise(values)]
            if isinstance(formula.members[-1], Constant):
                pairs.append((evaluate(members[0], names).rate, 0))
            sides = value(shown["left"]), value(shown["right"])
            assert any(close(a, sides[0]) and close(b, sides[1]) for a, b in pairs)
            assert not close(*sides)
        else:
            other = session.texts.formula(claim.to) if isinstance(claim, Equivalence) else None
            given = [other] if other else [neighbour.texts.formula(p) for p in claim.given]
            sides = [[evaluate(m, names).value for m in f.members[:2]] for f in given]
            own = [evaluate(m, names).value for m in (*members, *members[:1])[:2]]
            if len(members) == 1:
                own = [own[0], 0]
            holds, fails = (all(close(*s) for s in sides), not close(*own))
            assert (holds and fails) or (other is not None and not fails and not holds)
        checked += 1
        if checked == ENOUGH:
            break
    assert checked


@pytest.mark.parametrize("id", ["eq10.1", "eq10.5", "theta-prime", "eq12", "U1-prime", "eq14", "F2-prime", "eq13.conjugate"])  # fmt: skip
def test_no_single_edit_of_an_identity_in_the_complex_variables_is_true(session, id):
    claim = CLAIMS[id]
    for neighbour in islice(claim.neighbours(session.texts), 80):
        bench = session._bench("flint", session.texts).with_texts(neighbour.texts, refute=False)
        try:
            assert not neighbour.claim.decide(bench).verdict.green, neighbour.words
        except (StageError, NotationError):
            continue
