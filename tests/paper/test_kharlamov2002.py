"""The paper: every claim has its verdict, in each arithmetic; the errata are these and no others."""

import json

import pytest

from kowalevski_cas.algebra import EXACT
from kowalevski_cas.library import find, load
from kowalevski_cas.notation import Number, to_latex
from kowalevski_cas.paper.claims import Claim
from kowalevski_cas.paper.derivation import Derivation
from kowalevski_cas.verify.outcome import in_latex
from kowalevski_cas.verify.record import differences, load_record
from kowalevski_cas.verify.run import Session
from kowalevski_cas.verify.statement import Statement

IDS = """
eq4.1 eq4.2 eq4.3 energy eq5.1 eq5.2 eq5.3 time-unit eq6 eq7 J3 M4-dimension M4-independence
linear-in-w3 eq9.i eq9 eq10.1 eq10.2 eq10.3 eq10.4 eq10.5 eq10.6 eq10.7 eq10.8 eq10.9 theta-prime
Q1-prime ansatz-coefficient ansatz-exponents eq12 c1 c2 eq13.conjugate U1-prime U2-prime eq14
F1-prime F2-prime eq15 N4-dimension reality real-form.1 real-form.2 eq16.1 eq16.2 eq16.invariance
eq17.1 eq17.2 N4-independence equilibria last-multiplier eq18 eq19 ratio eq20.1 eq20.2 area eq21
eq22 critical-set appelrot-dimension redundant-integral kowalevski-variable limit
""".split()
"""The list of CLAIMS.md."""

ERRATA = {
    "eq9.i": "i^2 = -1",
    "eq10.1": r"x_1' = -x_1\omega_3 + z_1w_1",
    "eq10.2": r"x_2' = x_2\omega_3 - z_2w_2",
    "eq10.3": r"y_1' = -y_1\omega_3 + z_2w_1",
    "eq10.4": r"y_2' = y_2\omega_3 - z_1w_2",
    "eq10.7": r"2w_1' = -(w_1\omega_3 + z_1)",
    "eq10.8": r"2w_2' = w_2\omega_3 + z_2",
    "eq14": r"\frac{d}{d\tau}(U_1 - U_2) = \sqrt{x_1x_2}",
    "eq21": r"2\alpha_3\frac{\alpha_1\omega_1 + \alpha_2\omega_2}{\alpha_1^2 + \alpha_2^2}",
}
"""Misprints, with what stands in the correct formula."""

CONDITIONS = {
    "M4-dimension": ["(a^2 - b^2)^2 + 4c^2"],
    "N4-dimension": ["x_1x_2", "(a^2 - b^2)^2 + 4c^2"],
    "N4-independence": ["x_1x_2", "w_1^2 + x_1"],
    "appelrot-dimension": [r"\alpha_1^2 + \alpha_2^2"],
    "eq15": ["x_1x_2"],
    "eq16.invariance": [r"\xi_1^2 + \xi_2^2"],
    "equilibria": ["(a^2 - b^2)^2 + 4c^2"],
    "eq12": ["x_1x_2"],
    "U1-prime": ["x_1"],
    "U2-prime": ["x_2"],
    "ratio": [r"\alpha_1^2 - \alpha_2^2", r"\alpha_1", r"\alpha_2"],
}
RECORD = load_record(find("kharlamov2002"))


def test_every_claim_of_the_list_has_its_verdict(outcomes):
    assert set(IDS) <= set(outcomes)
    assert set(outcomes) - set(IDS) <= {
        "eq1",
        "appelrot-squares.1",
        "appelrot-squares.2",
        "appelrot-area",
    }
    assert len(IDS) == len(set(IDS)) == 64


def test_the_claims_stand_in_the_order_of_the_paper(derivation):
    ids = [claim.id for claim in derivation.claims]
    assert len(ids) == len(set(ids))
    assert [section.number for section in derivation.sections] == ["1", "2", "3"]


def test_the_run_does_not_differ_from_the_record_in_any_arithmetic(run):
    assert differences(run, RECORD) == []
    for outcome in run.outcomes:
        assert outcome.verdicts == dict.fromkeys(EXACT, RECORD[outcome.claim]["verdict"])


def test_the_errata_are_these_and_no_others(outcomes):
    wrong = {id for id, outcome in outcomes.items() if outcome.verdict == "refuted"}
    assert wrong == set(ERRATA) | {"critical-set"}
    assert all(o.verdict.green for id, o in outcomes.items() if id not in wrong)


@pytest.mark.parametrize("id", ERRATA)
def test_a_misprint_is_refuted_at_a_point_and_mended(outcomes, id):
    outcome = outcomes[id]
    assert outcome.correction.verdict.green
    shown = (
        in_latex(outcome.correction.formulas)
        .replace(" ", "")
        .replace(r"\left", "")
        .replace(r"\right", "")
    )
    wanted = ERRATA[id].replace(" ", "")
    if id != "eq21":
        assert shown.startswith(wanted)
    assert r"\alpha_3" in shown or id != "eq21"
    assert outcome.counterexample is not None
    assert outcome.counterexample.left != outcome.counterexample.right


@pytest.mark.parametrize("id", CONDITIONS)
def test_the_conditions_are_named(outcomes, id):
    assert outcomes[id].verdict == "conditional"
    assert [to_latex(condition.expression) for condition in outcomes[id].conditions] == CONDITIONS[
        id
    ]


@pytest.mark.slow
def test_conditions_that_are_not_stated_come_with_a_point_where_it_fails(derivation, certificates):
    ids = ["M4-dimension", "N4-dimension", "appelrot-dimension", "eq16.invariance", "equilibria"]
    session = Session(derivation, ["flint"], explain=True, certificates=certificates)
    found = session.run(ids).outcomes
    assert all(any(c.witness is not None for c in outcome.conditions) for outcome in found)


def test_the_critical_set_is_not_exact(outcomes):
    found = outcomes["critical-set"]
    values = found.counterexample.point.values
    point = {to_latex(name) for name, value in values.items() if value != Number(0)}
    assert len(point) == 1 and point < {r"\alpha_1", r"\alpha_2", r"\alpha_3"}


def test_what_rests_on_the_accepted_correction_says_so(outcomes):
    """The unit of (9) is misprinted; the derivation accepts the one with which (10) holds."""
    corrected = {id: outcome.corrected for id, outcome in outcomes.items() if outcome.corrected}
    assert {"eq10.5", "eq12", "N4-dimension"} <= corrected.keys()
    assert corrected.pop("kowalevski-variable") == ("eq10.1", "eq10.2", "eq10.7", "eq10.8")
    assert set(corrected.values()) == {("eq9.i",)}
    assert not {"eq9.i", "eq4.1", "eq17.1", "critical-set"} & corrected.keys()


def test_a_claim_rests_on_claims_before_it(derivation):
    session, before, rests = Session(derivation, ["flint"]), set(), {}
    for claim in derivation.claims:
        rests[claim.id] = session.interpretation.rests_on(Statement(claim, session.on(claim)))
        assert set(rests[claim.id]) <= before
        before.add(claim.id)
    assert "eq9.i" in rests["eq10.1"]
    assert rests["eq4.1"] == ()


def test_the_derivation_is_a_derivation_of_claims(derivation):
    assert isinstance(derivation, Derivation)
    assert all(isinstance(claim, Claim) for claim in derivation.claims)
    assert load("kharlamov2002") is not derivation


def test_the_record_is_json_and_counts_what_it_holds(folder):
    data = json.loads((folder / "record.json").read_text(encoding="utf-8"))
    assert data["derivation"] == "kharlamov2002"
    assert list(data["claims"]) == list(RECORD)


def test_what_is_refuted_stands_on_orthonormal_axes():
    """Only the first claims leave the axes free, and of these none is wrong."""
    derivation, record = load("kharlamov2002"), load_record(find("kharlamov2002"))
    free = {"e_{11}", "e_{12}", "e_{21}", "e_{22}"}
    scenes = {claim.id: {*claim.scene.names()} for claim in derivation.claims}
    refuted = {claim for claim, entry in record.items() if entry["verdict"] == "refuted"}
    assert free <= scenes["energy"] and len(refuted) == 10
    assert all(free.isdisjoint(scenes[claim]) for claim in refuted)
