"""Screening a derivation at points: nothing is proved, what is false is refuted."""

import pytest

from kowalevski_cas.algebra import POINTS
from kowalevski_cas.verify.outcome import Verdict
from kowalevski_cas.verify.record import contradictions
from kowalevski_cas.verify.run import Session

BEYOND = {
    "ansatz-exponents", "equilibria", "critical-set", "last-multiplier",
    "M4-dimension", "N4-dimension", "appelrot-dimension",
}  # fmt: skip
"""Claims that say what no point can show, or on which no random points are found."""


@pytest.fixture(
    scope="module",
    params=[pytest.param(p, marks=[] if p == "modular" else pytest.mark.slow) for p in POINTS],
)
def screening(request, derivation, certificates, record):
    return Session(derivation, (request.param,), certificates=certificates, record=record).run()


def test_the_paper_is_screened_as_it_is_recorded(screening, record):
    assert contradictions(screening, record) == []
    for outcome in screening.outcomes:
        recorded = record[outcome.claim]["verdict"]
        if outcome.claim in BEYOND:
            assert outcome.verdict is Verdict.UNDECIDED and outcome.message
        elif recorded == "refuted":
            assert outcome.verdict is Verdict.REFUTED, outcome
            assert outcome.counterexample is not None and outcome.counterexample.point.values
        elif (outcome.claim, str(outcome.verdict)) == ("N4-independence", "undecided"):
            assert "Singular matrix" in outcome.message  # in floating point, where (15) is solved
        else:
            assert outcome.verdict in (Verdict.PROBABLE, Verdict.ENCLOSED), outcome
            assert not outcome.verdict.green


def test_corrections_are_proved_whoever_screens(screening):
    mended = [o for o in screening.outcomes if o.correction is not None]
    assert len(mended) >= 8
    assert all(o.correction.verdict.green and not o.verdict.likely for o in mended)
