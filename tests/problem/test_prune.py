"""Digests: whatever changes a statement changes its digest, and nothing else does."""

from dataclasses import replace

import pytest

from kowalevski_cas.notation import edits
from kowalevski_cas.proof.digest import Digester, combined

ESTABLISHED = ["eq4.1", "eq6", "eq10.5", "eq12", "eq14", "eq16.1", "eq21"]


def digest(claim, texts):
    return Digester().statement(claim, texts)


@pytest.mark.parametrize("id", ESTABLISHED)
def test_every_edit_of_a_formula_changes_the_digest(derivation, id):
    texts = derivation.texts()
    claim = next(c for c in derivation.claims if c.id == id)
    before = digest(claim, texts)
    found = {before}
    changed = 0
    for edit in edits(texts.statement(claim.printed), texts.vocabulary):
        after = digest(claim, texts.edited(claim.printed, edit))
        assert after != before, edit.words
        found.add(after)
        changed += 1
        if changed == 40:
            break
    assert len(found) > 1


def test_spaces_do_not_change_a_statement(derivation):
    claim = next(c for c in derivation.claims if c.id == "theta-prime")
    texts = derivation.texts()
    assert digest(claim, texts) == digest(
        claim, derivation.texts({"theta-prime": r"\theta'  =   Q_{2}"})
    )


def test_what_a_scene_rests_on_is_part_of_the_statement(derivation):
    claim = next(c for c in derivation.claims if c.id == "eq12")
    changed = derivation.texts({"tau": r"\tau=2t"})
    assert digest(claim, derivation.texts()) != digest(claim, changed)


def test_parameters_are_part_of_the_statement(derivation):
    texts = derivation.texts()
    claim = next(c for c in derivation.claims if c.id == "N4-dimension")
    assert digest(claim, texts) != digest(replace(claim, dimension=5), texts)
    assert digest(claim, texts) != digest(
        replace(claim, scene=replace(claim.scene, nonzero=("x_1",))), texts
    )
    assert digest(claim, texts) != digest(
        replace(claim, scene=replace(claim.scene, loci=())), texts
    )


def test_different_claims_have_different_digests(run):
    found = [outcome.digest for outcome in run.outcomes]
    assert len(set(found)) == len(found)
    assert run.digest == combined(f"{o.claim} {o.digest}" for o in run.outcomes)


def test_the_digest_is_the_same_from_run_to_run(derivation):
    claims = derivation.claims[:20]
    assert [digest(c, derivation.texts()) for c in claims] == [
        digest(c, derivation.texts()) for c in claims
    ]
