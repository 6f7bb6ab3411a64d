"""Section 4 of the first paper: the Lax pair, the critical set, O⁴; all of it proved as printed."""

import pytest

from kowalevski_cas.algebra import EXACT
from kowalevski_cas.library import find, load
from kowalevski_cas.notation import Negative, Number
from kowalevski_cas.problem import checker
from kowalevski_cas.problem.accept import Judge
from kowalevski_cas.problem.evidence import At, Denial, Point
from kowalevski_cas.problem.finder import finder_of
from kowalevski_cas.problem.space import all_names
from kowalevski_cas.verify.certificate import certificate, load_certificates
from kowalevski_cas.verify.record import load_record
from kowalevski_cas.verify.run import Session
from kowalevski_cas.verify.statement import Statement
from tests.sample import sampled

PAPERS = ("bobenko_reyman_semenov1989", "kharlamov2005", "kharlamov2007", "m4_tori")

RINGS = [pytest.param(ring, marks=[] if ring == "flint" else [pytest.mark.slow]) for ring in EXACT]

ASIDE = {
    # what scenes are made of, and what is claimed of its parts
    "surface", "K-alone", "epsilon", "kappa", "radicals-O4", "parts", "fields-by-u",
    "velocity-by-u", "rates-of-u", "one-variable", "hats", "hatted-parts", "hatted-fields",
    "hatted-velocity", "hatted-rates", "forces", "R", "abbreviations", "F-of-u", "R-of-u",
    "point-M4", "rates-M4", "roots-M4",
}  # fmt: skip


@pytest.mark.parametrize("ring", RINGS)
@pytest.mark.parametrize("name", sampled(PAPERS, 1))
def test_every_formula_is_right_as_printed_and_as_recorded(name, ring):
    record = load_record(find(name))
    run = Session(
        load(name), [ring], certificates=load_certificates(find(name)), record=record
    ).run()
    assert {outcome.claim for outcome in run.outcomes} == {*record}
    assert all(outcome.verdict.green for outcome in run.outcomes)
    assert all(outcome.correction is None for outcome in run.outcomes)


@pytest.mark.parametrize("name", PAPERS)
def test_every_printed_formula_is_claimed_or_makes_a_scene(name):
    derivation = load(name)
    claimed = {place.display.id for claim in derivation.claims for place in claim.places()}
    printed = {display.id for display in derivation.displays() if not display.source}
    assert printed - claimed <= ASIDE


ON_ONE_ALONE = {
    "critical-points": [
        {r"\lambda": 1, "Z": 1, r"\omega_3": 1, "N_1": 1, "E_1": 1, "E_2": 1, "E_4": 1, "E_5": 1,
         "w_1": 1, "w_2": 1, "y_1": 1, "y_2": 1},
        {"k": 1, r"\lambda": 1, "Z": 1, "E_1": 1, "E_2": 1, "w_1": 1, "w_2": 1},
        {"k": 1, r"\lambda": 1, "N_1": 1, r"\omega_3": 1, "w_1": 1},
        {"k": 1, r"\lambda": 1, "N_1": 1, r"\omega_3": 1, "E_3": 1},
    ],
    "critical-points-without-G": [
        {r"\mu": 1, "N_1": 1, "w_1": 1, "w_2": 1, "x_1": -1, "x_2": -1},
        {"k": 1, r"\lambda": 2, r"\mu": 1, "w_1": 1, "w_2": 1, "x_1": -2, "x_2": -2},
        {"k": 1, r"\mu": 1, "N_1": 1, "x_1": 1, "x_2": 1},
        {"k": 1, "N_1": 1, "w_1": 1, "w_2": 1},
    ],
}  # fmt: skip
"""Points that obey what is given, each on one of the sets and on none of the others."""


@pytest.mark.parametrize("place", sampled(range(4), 1))
@pytest.mark.parametrize("id", ON_ONE_ALONE)
def test_no_set_of_critical_points_can_be_left_out(id, place):
    claim = next(c for c in load("kharlamov2005").claims if c.id == id)
    on = Session(load("kharlamov2005"), ["flint"]).on(claim)
    neighbours = [*claim.neighbours(on.texts)]
    assert len(neighbours) == len(ON_ONE_ALONE[id])
    statement = Statement(neighbours[place].claim, on)
    (goal,) = statement.goals
    values = {name: ON_ONE_ALONE[id][place].get(name, 0) for name in all_names(goal.space)}
    point = Point({n: Negative(Number(-v)) if v < 0 else Number(v) for n, v in values.items()})
    judge = Judge(finder_of)
    judge.denies(goal, At(point))
    text = certificate(statement, Denial(0, At(point)), judge.accepted)
    assert checker.check(text).sign == "denied"
