"""Sixty systems as others print them: none is misread, and as many are read as meant as were."""

import json
from collections import Counter
from pathlib import Path

import pytest

from study.prints import PrintReading, read, typed
from tests.sample import sampled

PRINTS = Path(__file__).parent.parent / "data" / "prints"
ENTRIES, PUBLIC = (
    {entry["id"]: entry for entry in json.loads((PRINTS / name).read_text(encoding="utf-8"))}
    for name in ("prints.json", "public.json")
)
MEANT = {"open": 28, "held": 29}
"""How many of each half are read as meant, with every claim decided rightly."""

pytestmark = pytest.mark.usefixtures("uncorrected")


def test_each_half_has_thirty():
    assert Counter(entry["half"] for entry in ENTRIES.values()) == {"open": 30, "held": 30}
    assert all(entry["true"] and entry["false"] for entry in ENTRIES.values())


@pytest.mark.parametrize("id", sampled(["gni-lotka-volterra-2", "pds-kuramoto", "wsu-norton"], 1))
def test_a_print_of_a_public_source_is_read_as_it_is_meant(id):
    assert read(PUBLIC[id], 30).reading == PrintReading.MEANT


@pytest.mark.slow
def test_no_print_of_a_public_source_is_misread():
    found = {id: read(entry, 30) for id, entry in PUBLIC.items()}
    assert not [id for id, one in found.items() if one.reading == PrintReading.MISREAD]
    count = Counter(one.reading for one in found.values())
    assert count[PrintReading.MEANT] >= 35, found


@pytest.mark.parametrize(
    "id", sampled(["duffing-strogatz", "uniform-field-landau", "toda-lax-matrix"], 1)
)
def test_a_print_is_read_as_it_is_meant(id):
    assert read(ENTRIES[id], 30).reading == PrintReading.MEANT


@pytest.mark.slow
def test_a_print_that_means_something_else_is_misread():
    entry = ENTRIES["duffing-strogatz"]
    other = {**entry, "equations": [tex.replace("x-x^3", "x+x^3") for tex in entry["equations"]]}
    assert read(other, 30).reading == PrintReading.MISREAD
    swapped = {**entry, "true": entry["false"], "false": entry["true"]}
    assert read(swapped, 30).reading == PrintReading.MISREAD


def test_what_stands_beside_the_equations_is_typed_as_what_it_can_be():
    system, given = typed(ENTRIES["lorenz-b2sigma"])
    assert not given and "b" in system.scene.definitions
    _, given = typed(ENTRIES["goryachev-chaplygin"])
    assert given == tuple(ENTRIES["goryachev-chaplygin"]["where"])


@pytest.mark.slow
@pytest.mark.parametrize("half", MEANT)
def test_no_print_is_misread(half):
    entries = [entry for entry in ENTRIES.values() if entry["half"] == half]
    found = {entry["id"]: read(entry, 30) for entry in entries}
    assert not [id for id, one in found.items() if one.reading == PrintReading.MISREAD]
    count = Counter(one.reading for one in found.values())
    assert count[PrintReading.MEANT] >= MEANT[half], found
