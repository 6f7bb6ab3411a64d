"""Searches by several methods: those that answer the same question agree."""

import shutil

import pytest

from study.searches import LEFT, LINEAR, POLYNOMIAL, QUICK, RIGHT, SYMBOLIC, measure

SYSTEMS = [one for one in (*LEFT, *RIGHT) if one.name in QUICK]


@pytest.mark.parametrize("one", SYSTEMS, ids=lambda one: f"{one.question}: {one.name}")
def test_methods_agree(one):
    installed = ["singular"] if shutil.which("Singular") else []
    if one.question == "integrals":
        names = [name for name in LINEAR if name != "singular"]
        sizes = {name: LINEAR[name](one)() for name in (*names, *installed)}
        for name in ("sympy", *installed):
            sizes[f"{name}, symbols"] = SYMBOLIC[name](one)()
    else:
        names = ["python-flint", "sympy", *installed]
        sizes = {name: POLYNOMIAL[name](one)() for name in names}
        assert POLYNOMIAL["basis"](one)() >= max(sizes.values())
        assert POLYNOMIAL["cases"](one)() > 0
    assert len({*sizes.values()}) == 1


@pytest.mark.slow
def test_every_method_finishes_on_small_systems(copies):
    for task in measure(quick=True):
        row = task.row()
        assert row["verdict"] in ("finished", "left out"), row
