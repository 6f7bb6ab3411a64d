"""A scene has no generator that its claims do not use."""

import pytest

from study import scenes
from study.paper import paper


@pytest.mark.parametrize("id", ["eq5.1", "eq12", "eq18", "eq21", "eq22", "appelrot-area"])
def test_every_generator_is_used_or_justified(id):
    found = scenes.generators(paper().claims[id])
    assert found["verdict"] in ("equal", "justified"), found["reasons"]
    assert set(found["statement"]) | set(found["reasons"]) == set(found["scene"])


@pytest.mark.slow
def test_every_claim_of_the_paper_has_what_it_needs_and_no_more():
    found = {id: scenes.generators(one) for id, one in paper().claims.items()}
    assert [id for id, row in found.items() if row["verdict"] == "more"] == []


def test_a_generator_that_nothing_needs_is_found():
    one = paper().claims["eq21"]
    idle = scenes.replace(one.scene, constants=("a",))
    found = scenes.generators(scenes.replace(one, scene=idle))
    assert found["verdict"] == "more" and found["reasons"] == {"a": ""}


def test_the_statement_is_what_the_formula_depends_on():
    used = {id: scenes.statement(paper().claims[id]) for id in ("eq20.1", "eq5.1", "eq18")}
    assert used["eq20.1"] == {r"\omega_1", r"\omega_2", r"\alpha_1", r"\alpha_2", r"\sqrt{k}"}
    assert used["eq5.1"] >= {r"\omega_1", r"\omega_2"}
    assert r"\beta_1" not in used["eq18"]


def test_the_general_scene_has_all_generators_and_proves_the_same():
    own = scenes.prove({"claim": "eq18", "general": False, "repeats": 1})
    general = scenes.prove({"claim": "eq18", "general": True, "repeats": 1})
    assert own["verdict"] == general["verdict"] == "proved"
    assert general["generators"] > 20 > own["generators"]
