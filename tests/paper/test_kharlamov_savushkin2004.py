"""The motions on N⁴: every formula is proved as printed, and a wrong one would be refuted."""

import sys

import pytest

from kowalevski_cas.algebra import EXACT
from kowalevski_cas.library import find, load
from kowalevski_cas.notation import to_latex
from kowalevski_cas.verify.certificate import load_certificates
from kowalevski_cas.verify.record import differences, load_record
from kowalevski_cas.verify.run import Session

NAME = "kharlamov_savushkin2004"
DERIVATION = load(NAME)
RECORD = load_record(find(NAME))

CONDITIONS = {
    "m": [],
    "point.alpha": [],
    "fields.1": [r"\ell - 2ms_1", r"\ell - 2ms_2"],
    "solution.1": [r"1 - \kappa\mathrm{sn}(n(t - t_1), k)^2"],
}


@pytest.fixture(scope="module", params=[["flint"], pytest.param(EXACT, marks=pytest.mark.slow)])
def run(request):
    """What has a certificate is searched for no more, nor are corrections on which this rests."""
    stored = load_certificates(find(NAME))
    with pytest.MonkeyPatch.context() as patch:
        patch.setitem(sys.modules, "kowalevski_cas.search.find", None)
        return Session(DERIVATION, request.param, certificates=stored, record=RECORD).run()


@pytest.fixture(scope="module")
def outcomes(run):
    return {outcome.claim: outcome for outcome in run.outcomes}


@pytest.mark.slow
def test_the_run_does_not_differ_from_the_record_in_any_arithmetic(run):
    assert differences(run, RECORD) == []
    for outcome in run.outcomes:
        assert outcome.verdicts == dict.fromkeys(run.arithmetics, outcome.verdict)


def test_every_formula_is_right_as_printed(outcomes):
    assert all(outcome.verdict.green for outcome in outcomes.values())
    assert all(outcome.correction is None for outcome in outcomes.values())


@pytest.mark.parametrize("id", CONDITIONS)
def test_the_conditions_are_named(outcomes, id):
    assert [to_latex(condition.expression) for condition in outcomes[id].conditions] == CONDITIONS[
        id
    ]


def test_every_printed_formula_is_claimed():
    claimed = {printed for claim in DERIVATION.claims for printed in claim.places()}
    for section in DERIVATION.sections:
        for display in section.displays:
            if not display.source and display.id not in GIVEN:
                count = len(DERIVATION.texts().statements(display))
                missing = {k for k in range(1, count + 1) if display[k] not in claimed}
                assert not missing - GIVEN_IN_PART.get(display.id, set()), display.id


GIVEN = {"no-c", "r-of-a-b", "B-D.1", "B-D.2", "bracket"}
"""Displays that say what a scene is."""

GIVEN_IN_PART = {"G": {2}}
"""The same in a display that holds a claim as well."""


@pytest.mark.slow
def test_without_evidence_the_searches_come_to_the_same(outcomes):
    ids = ["m", "m-real", "g", "combined", "curve.1"]
    found = Session(DERIVATION, ["flint"]).run(ids)
    assert {o.claim: o.verdict for o in found.outcomes} == {i: outcomes[i].verdict for i in ids}


@pytest.mark.slow
def test_the_claims_rest_on_those_that_establish_their_formulas():
    ids = ["point.g", "point.F2", "l"]
    stored = load_certificates(find(NAME))
    run = Session(DERIVATION, ["flint"], explain=True, certificates=stored).run(ids)
    rests = {outcome.claim: outcome.rests_on for outcome in run.outcomes}
    assert "G" in rests["point.g"]
    assert {"point.x1", "point.c1"} <= set(rests["point.F2"])
    assert {"eq10.1", "m", "m-conjugate"} <= set(rests["l"])
