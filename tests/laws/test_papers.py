"""Laws that hold on whole papers: what no way of running and writing them may change."""

from random import Random

import pytest

from kowalevski_cas.library import find, load
from kowalevski_cas.notation import Negative, NotationError, Number, Product, Relation, edits
from kowalevski_cas.paper.claims import Identity
from kowalevski_cas.paper.scene import Change
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.verify.certificate import load_certificates
from kowalevski_cas.verify.record import load_record
from kowalevski_cas.verify.run import Session
from kowalevski_cas.verify.statement import Statement
from tests.sample import sampled

PAPERS = sampled(("kharlamov2002", "kharlamov_savushkin2004"), 1)
FEW = 4
MANY = 60


def kept(name):
    folder = find(name)
    return {"certificates": load_certificates(folder), "record": load_record(folder)}


def recorded(name):
    return {claim: entry["verdict"] for claim, entry in load_record(find(name)).items()}


def verdicts(derivation, kept, only=()):
    run = Session(derivation, ("flint",), **kept).run(only)
    return {outcome.claim: str(outcome.verdict) for outcome in run.outcomes}


@pytest.mark.parametrize("name", PAPERS)
def test_a_claim_alone_has_the_verdict_that_it_has_among_all(name):
    known, derivation = recorded(name), load(name)
    stored = kept(name)
    for claim in Random(1).sample(sorted(known), FEW):
        assert verdicts(derivation, stored, (claim,)) == {claim: known[claim]}


@pytest.mark.slow
@pytest.mark.parametrize("name", PAPERS)
def test_the_order_of_claims_does_not_matter_nor_that_some_are_missing(name):
    derivation, choose = load(name), Random(2)
    for section in derivation.sections:
        choose.shuffle(section.claims)
    gone = {section.claims.pop().id for section in derivation.sections if section.claims}
    needed = set(derivation.accepted)
    gone -= {c.id for s in derivation.sections for c in s.claims if c.printed in needed}
    found = verdicts(derivation, kept(name))
    known = recorded(name)
    assert found == {claim: known[claim] for claim in known if claim not in gone}


def swapped(relation):
    return Relation(relation.members[::-1], relation.signs)


def tripled(relation):
    three = (Product((Number(3), member)) for member in relation.members)
    return Relation(tuple(three), relation.signs)


def moved(relation):
    negative = (Negative(member) for member in relation.members)
    return Relation(tuple(negative), relation.signs)


@pytest.mark.parametrize("change", [swapped, tripled, moved])
@pytest.mark.parametrize("name", PAPERS)
def test_an_identity_written_otherwise_says_the_same(name, change):
    session = Session(load(name), ["flint"], **kept(name))
    known = recorded(name)
    claims = [c for c in session.derivation.claims if type(c) is Identity]
    count = 0
    for claim in Random(3).sample(claims, len(claims)):
        relation = session.texts.formula(claim.own)
        if not isinstance(relation, Relation) or len(relation.members) != 2:
            continue
        if claim.scene.definitions.values() and claim.own in claim.scene.places:
            continue  # it defines a name as well, which stands alone on its side
        texts = session.texts.reading({claim.own: change(relation)})
        statement = Statement(claim, session.on(claim, texts))
        green = known[claim.id] in ("proved", "conditional")
        assert statement.holds() == green, claim.id
        count += 1
        if count == FEW:
            return
    assert count


def changes_of_scenes(name, many):
    """Whether a claim rests on a place of its scene, and whether an edit there changes it."""
    session, choose = Session(load(name), ["flint"]), Random(4)
    tried = 0
    while tried < many:
        claim = choose.choice(session.derivation.claims)
        places = [*dict.fromkeys(claim.scene.places)]
        if not places:
            continue
        place = choose.choice(places)
        on = session.on(claim)
        statement = Statement(claim, on)
        printed = edits(on.texts.statement(place), on.texts.vocabulary)
        found = [edit for edit in printed if len(edit.path) > 1]  # no side of its own: a head
        if not found:
            continue
        texts = on.texts.with_edit(place, choose.choice(found))
        try:
            other = Statement(claim, on.under(texts))
        except (NotationError, Meaningless, ZeroDivisionError, ValueError):
            continue  # the statement means nothing then: it has no verdict
        tried += 1
        rests, changed = place in set(statement.stands_on), other.digest != statement.digest
        chain = on.texts.formula(place)
        assert isinstance(chain, Relation)
        if len(chain.members) > 2 and rests and not changed:
            continue  # the edit is in a member of the chain that this claim does not read
        change = claim.scene.field
        if isinstance(change, Change) and place in change.formulas and rests and not changed:
            continue  # an old variable is said to rest on all formulas by which it is solved for
        yield claim.id, place, rests, changed


@pytest.mark.slow
@pytest.mark.parametrize("name", PAPERS)
def test_an_edit_of_the_scene_makes_another_statement_of_what_rests_on_it(name):
    for claim, place, rests, changed in changes_of_scenes(name, FEW * 3):
        assert rests == changed, (claim, place.place)


@pytest.mark.slow
@pytest.mark.parametrize("name", PAPERS)
def test_many_edits_of_scenes(name):
    for claim, place, rests, changed in changes_of_scenes(name, MANY * 5):
        assert rests == changed, (claim, place.place)
