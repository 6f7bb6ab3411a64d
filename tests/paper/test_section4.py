"""Section 4 of the first paper: the Lax pair, the critical set, O⁴; all of it proved as printed."""

import pytest

from kowalevski_cas.algebra import EXACT
from kowalevski_cas.library import find, load
from kowalevski_cas.paper.claims import Union
from kowalevski_cas.problem.evidence import Denial
from kowalevski_cas.verify.certificate import load_certificates
from kowalevski_cas.verify.record import load_record
from kowalevski_cas.verify.run import Session, verify
from kowalevski_cas.verify.statement import Statement

PAPERS = ("bobenko_reyman_semenov1989", "kharlamov2005", "kharlamov2007")

RINGS = [pytest.param(ring, marks=[] if ring == "flint" else [pytest.mark.slow]) for ring in EXACT]

ASIDE = {
    # what scenes are made of, and what is claimed of its parts
    "surface", "K-alone", "epsilon", "kappa", "radicals-O4", "parts", "fields-by-u",
    "velocity-by-u", "rates-of-u", "one-variable", "hats", "hatted-parts", "hatted-fields",
    "hatted-velocity", "hatted-rates", "forces", "R", "quadratic", "abbreviations",
}  # fmt: skip


@pytest.mark.parametrize("ring", RINGS)
@pytest.mark.parametrize("name", PAPERS)
def test_every_formula_is_right_as_printed_and_as_recorded(name, ring):
    record = load_record(find(name))
    run = verify(load(name), [ring], certificates=load_certificates(find(name)), record=record)
    assert {outcome.claim for outcome in run.outcomes} == {*record}
    assert all(outcome.verdict.green for outcome in run.outcomes)
    assert all(outcome.correction is None for outcome in run.outcomes)


@pytest.mark.parametrize("name", PAPERS)
def test_every_printed_formula_is_claimed_or_makes_a_scene(name):
    derivation = load(name)
    claimed = {place.display.id for claim in derivation.claims for place in claim.places()}
    printed = {display.id for display in derivation.displays() if not display.source}
    assert printed - claimed <= ASIDE


@pytest.mark.parametrize(
    "claim", [c for c in load("kharlamov2005").claims if isinstance(c, Union)], ids=lambda c: c.id
)
@pytest.mark.slow
def test_no_set_of_critical_points_can_be_left_out(claim):
    on = Session(load("kharlamov2005"), ["flint"]).on(claim)
    for neighbour in claim.neighbours(on.texts):
        assert isinstance(Statement(neighbour.claim, on).search(), Denial), neighbour.words
