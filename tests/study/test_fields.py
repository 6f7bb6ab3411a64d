"""Fields with one wrong token: the changed equation is what is blamed, and figures are measured."""

import json
from random import Random

import pytest

from kowalevski_cas import System
from study import fields
from study.fields import (
    FIGURES,
    HARMLESS,
    KNOWN,
    NONE,
    OTHER,
    RIGHT,
    TIE,
    WrongField,
    blamed,
    figures,
    wrong_fields,
)
from study.published import integrals
from tests.sample import sampled

ROTATION = integrals(
    "a rotation", r"\dot x=-y,\quad \dot y=x,\quad \dot z=1", 2, "x^2+y^2", "3x^2+3y^2"
)


def of_rotation(motion, row):
    return blamed(WrongField(ROTATION, motion, row, "made for this test"))


def test_a_change_by_which_all_stays_true_is_harmless():
    assert of_rotation(r"\dot x=-y,\quad \dot y=x,\quad \dot z=2", 3).end == HARMLESS


@pytest.mark.slow
def test_the_row_that_was_changed_has_to_be_blamed_by_every_claim_that_fails():
    wrong = r"\dot x=-z,\quad \dot y=x,\quad \dot z=1"
    assert of_rotation(wrong, 1).end == RIGHT
    assert of_rotation(wrong, 2).end == OTHER


@pytest.mark.slow
def test_a_row_that_could_as_well_be_wrong_is_a_tie():
    """Of two signs that are alike either may have been wrong."""
    found = of_rotation(r"\dot x=y,\quad \dot y=x,\quad \dot z=1", 1)
    assert found.end in (TIE, OTHER)
    assert of_rotation(r"\dot x=y,\quad \dot y=x,\quad \dot z=1", 2).end in (TIE, OTHER)


@pytest.mark.slow
def test_what_no_edit_mends_is_no_success():
    assert of_rotation(r"\dot x=-7y^3z,\quad \dot y=x,\quad \dot z=1", 1).end == NONE


@pytest.mark.parametrize("one", KNOWN, ids=lambda one: one.name)
def test_one_token_of_one_right_side_is_changed(one):
    found = next(wrong_fields(one, Random(1)))
    rows, before = found.motion.split(r"\dot"), one.motion.split(r"\dot")
    assert [k for k, pair in enumerate(zip(rows, before, strict=True)) if pair[0] != pair[1]] == [
        found.row
    ]
    assert System(found.motion).scene.variables == System(one.motion).scene.variables


@pytest.mark.parametrize("one", sampled(KNOWN, 2), ids=lambda one: one.name)
def test_what_is_published_of_a_field_is_proved(one):
    assert blamed(WrongField(one, one.motion, 1, "nothing")).end == HARMLESS


def test_the_figures_are_of_enough_fields_and_systems():
    found = json.loads(FIGURES.read_text(encoding="utf-8"))
    rows = [fields.BlamedField(**row) for row in found["rows"]]
    assert {**figures(rows), "rows": found["rows"]} == found
    assert found["fields"] == fields.FIELDS and found["systems"] == len(KNOWN) >= 25
    assert found[RIGHT] >= 45 and found["median seconds"] < 2
