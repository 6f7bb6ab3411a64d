"""Pruning: a problem holds what its goals lead to; any change of that changes its digest, nothing else does."""

import json
from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kowalevski_cas.library import find, load
from kowalevski_cas.notation import Name, NotationError, Power, edits
from kowalevski_cas.paper.claims import FirstIntegral
from kowalevski_cas.problem.codec import digest, problem_data, read_problem
from kowalevski_cas.problem.space import Meaningless, generators
from kowalevski_cas.problem.trees import FormatError
from kowalevski_cas.verify.certificate import load_certificates
from kowalevski_cas.verify.run import Session
from kowalevski_cas.verify.statement import Statement
from tests.problem.judges import judged
from tests.problem.tampering import changed, others, places
from tests.sample import sampled

ESTABLISHED = ["eq4.1", "eq6", "eq10.5", "eq12", "eq14", "eq16.1", "eq21"]


def stated(derivation, id, sources=None, claim=None):
    session = Session(derivation, ["flint"], texts=derivation.texts(sources))
    claim = claim or next(c for c in derivation.claims if c.id == id)
    return Statement(claim, session.on(claim))


@pytest.mark.parametrize("id", sampled(ESTABLISHED, 1))
def test_every_edit_of_a_formula_changes_the_digest(derivation, id):
    claim = next(c for c in derivation.claims if c.id == id)
    session = Session(derivation, ["flint"])
    on = session.on(claim)
    before, changed = Statement(claim, on).digest, 0
    for edit in edits(on.texts.statement(claim.printed), on.texts.vocabulary):
        try:
            after = Statement(claim, on.under(on.texts.with_edit(claim.printed, edit))).digest
        except (Meaningless, NotationError):
            continue
        member = edit.statement.formula.members[edit.path[0]] if edit.path else None
        level = isinstance(claim, FirstIntegral) and isinstance(member, Name | Power)
        assert after != before or level, edit.words  # a level is whatever the integral is
        changed += after != before
        if changed == 25:
            break
    assert changed


def test_spaces_between_signs_do_not_change_a_statement(derivation):
    before = stated(derivation, "theta-prime").digest
    assert (
        before == stated(derivation, "theta-prime", {"theta-prime": r"\theta'  =   Q_{2}"}).digest
    )


def test_what_a_scene_rests_on_is_part_of_the_statement(derivation):
    before = stated(derivation, "eq12").digest
    assert before != stated(derivation, "eq12", {"tau": r"\tau=2t"}).digest


def test_what_a_statement_does_not_reach_is_no_part_of_it(derivation):
    before = stated(derivation, "eq4.1").digest
    assert (
        before == stated(derivation, "eq4.1", {"eq18": r"(\alpha_1^2+\alpha_2^2)\omega_3=0"}).digest
    )


def test_parameters_are_part_of_the_statement(derivation):
    claim = next(c for c in derivation.claims if c.id == "N4-dimension")
    before = stated(derivation, claim.id).digest
    smaller = replace(claim.scene, nonzero=("x_1",))
    for other in (replace(claim, dimension=5), replace(claim, scene=smaller)):
        assert stated(derivation, claim.id, claim=other).digest != before


def test_different_claims_have_different_digests(run):
    found = [outcome.digest for outcome in run.outcomes]
    assert len(set(found)) == len(found)
    changed = [run._replace(outcomes=(*run.outcomes[:k], *run.outcomes[k + 1 :])) for k in (0, -2)]
    assert len({one.digest for one in (run, *changed)}) == 3


# -- both papers, statement by statement -------------------------------------------

PAPERS = {name: load(name) for name in ("kharlamov2002", "kharlamov_savushkin2004")}


@pytest.fixture(scope="module", params=sampled(PAPERS, 1, seed=1))
def statements(request):
    session = Session(PAPERS[request.param], ["flint"])
    return request.param, [Statement(c, session.on(c)) for c in PAPERS[request.param].claims]


def names_in(formula):
    own = {formula.name} if hasattr(formula, "name") and not formula.children() else set()
    return own.union(*map(names_in, formula.children()))


def test_a_problem_holds_what_it_uses_and_defines_it_before(statements):
    for statement in statements[1]:
        for small in statement.legend:
            known = {*generators(small)}
            for step in small.steps:
                first, *printed = step.formulas()
                assert names_in(first) <= known, (statement.claim.id, step.name)
                known.add(step.name)
                said = {name for formula in printed for name in names_in(formula)}
                assert said <= {*generators(small), *(one.name for one in small.steps)}
            for formula in small.nonzero:
                assert names_in(formula) <= known


def test_reading_what_was_written_gives_the_same_problem(statements):
    for one in statements[1]:
        data = json.loads(json.dumps(problem_data(one.problem)))
        again = read_problem(data)
        assert problem_data(again) == data
        assert digest(again) == one.digest


@pytest.mark.slow
def test_pruning_changes_no_verdict(statements):
    """The committed evidence is accepted on the problem as it is read from its file, and so for the goals."""
    name, ours = statements
    stored = load_certificates(find(name))
    for one in ours:
        judged(stored[one.claim.id].data)


@given(st.data())
def test_what_cannot_be_read_is_a_format_error(data):
    stored = data.draw(st.sampled_from(sorted(STORED)))
    whole = {key: STORED[stored].data[key] for key in ("spaces", "goals")}
    path = data.draw(st.sampled_from([*places(whole)]))
    value = data.draw(st.sampled_from([*others(whole, path, ["i"]), 5, "x", [], {}]))
    other = changed(whole, path, value)
    try:
        read_problem(other)
    except FormatError:
        pass


STORED = load_certificates(find("kharlamov2002"))
