"""Certificates are written from the print, byte for byte, and are not trusted when they are read."""

import json
import random
from copy import deepcopy
from pathlib import Path

import pytest

from kowalevski_cas.algebra import EXACT
from kowalevski_cas.algebra.present import formula_in
from kowalevski_cas.library import find, load
from kowalevski_cas.problem import checker
from kowalevski_cas.problem.evidence import Entailment, Proof
from kowalevski_cas.problem.examine import Unproved
from kowalevski_cas.problem.finder import finder_of
from kowalevski_cas.problem.trees import FormatError
from kowalevski_cas.verify.certificate import VERSION, Stored, load_certificates
from kowalevski_cas.verify.record import load_record
from kowalevski_cas.verify.run import Session
from kowalevski_cas.verify.statement import Statement
from tests.problem.tampering import at, changed, names_in, others, places, twisted
from tests.sample import sampled

PAPERS = ("kharlamov2002", "kharlamov_savushkin2004")


@pytest.mark.parametrize("many", [4, pytest.param(None, marks=pytest.mark.slow)])
@pytest.mark.parametrize("paper", PAPERS)
def test_the_committed_ones_are_written_from_the_print(paper, many):
    """Of each claim in any order, and of each correction, which holds; the record has the digests."""
    folder, derivation = find(paper), load(paper)
    stored, record = load_certificates(folder), load_record(folder)
    session = Session(derivation, ["flint"], certificates=stored, record=record)
    claims = derivation.claims
    for claim in random.Random(paper).sample(claims, many or len(claims)):
        texts = session.outcome(claim).certificates
        corrected = [f"corrected/{claim.id}"] if record[claim.id]["correction"] else []
        assert [*texts] == [claim.id, *corrected]
        assert all(stored[name].path.read_text(encoding="utf-8") == texts[name] for name in texts)
        assert record[claim.id]["statement"] == json.loads(texts[claim.id])["digest"]
        assert all(json.loads(texts[name])["sign"] == "holds" for name in corrected)


# -- forged evidence ---------------------------------------------------------------


@pytest.fixture(scope="module")
def decided(derivation):
    """What is said about a claim with these certificates; what it means is elaborated once."""
    session = Session(derivation, ["flint"])
    claims = {claim.id: claim for claim in derivation.claims}

    def decided(id, stored, record=()):
        session.decider.archive.certificates = dict(stored)
        session.decider.corrector.record = dict(record)
        return session.with_corrections(
            [session.decide(claims[id])], lambda work, of, _: map(work, of)
        )[0]

    return decided


def forged(certificates, id, evidence, **more):
    """The certificates, with other evidence for one claim."""
    stored = certificates[id]
    return {**certificates, id: Stored(stored.path, {**stored.data, "evidence": evidence, **more})}


def is_searched_anew(outcome, certificates, record, name):
    """It is told that what is stored is rejected, and the verdict is what it was."""
    id = name.rpartition("/")[2]
    assert outcome.note.startswith(f"{certificates[name].path} is rejected: ")
    assert outcome.verdict == record[id]["verdict"]
    assert (outcome.correction is None) == (record[id]["correction"] is None)
    assert f'"claim": "{id}"' in outcome.certificates[name]


CLAIMS = ["eq7", "J3", "eq20.2", "eq10.1", "eq14", "eq15", "eq16.invariance", "M4-dimension", "N4-independence",
    "equilibria", "critical-set", "limit", "kowalevski-variable", "ansatz-exponents", "last-multiplier", "eq21"]  # fmt: skip


OTHER_SHAPES = (
    None, [], {}, "x", 5, [None], [[]], [{}], [5], [{"goal": 9}], [{"goal": -1}], [{"goal": "x"}],
    [{"point": None}], [{"point": {"roots": [], "values": [["x_1", "?"]]}}], [{"cofactors": [[1]]}],
    [{"goal": 0, "point": {"roots": [], "values": []}}], [{"values": [], "evidence": []}],
)  # fmt: skip


@pytest.mark.parametrize("evidence", sampled(OTHER_SHAPES, 1))
@pytest.mark.parametrize("id", sampled(CLAIMS, 3))
def test_evidence_of_another_shape_is_told_and_searched_anew(
    decided, certificates, record, id, evidence
):
    outcome = decided(id, forged(certificates, id, evidence))
    is_searched_anew(outcome, certificates, record, id)


@pytest.mark.parametrize("id", sampled(CLAIMS, 1))
def test_the_other_sign_is_told(decided, certificates, record, id):
    data = certificates[id].data
    sign = {"holds": "denied", "denied": "holds"}[data["sign"]]
    outcome = decided(id, forged(certificates, id, data["evidence"], sign=sign))
    is_searched_anew(outcome, certificates, record, id)


@pytest.mark.parametrize("id", sampled(CLAIMS, 1))
def test_a_key_that_is_unknown_is_told_wherever_it_stands(decided, certificates, record, id):
    evidence = certificates[id].data["evidence"]
    found = [path for path in places(evidence) if isinstance(at(evidence, path), dict)]
    for path in random.Random(id).sample(found, min(len(found), 2)):
        more = changed(evidence, path, {**at(evidence, path), "trust": "me"})
        outcome = decided(id, forged(certificates, id, more))
        is_searched_anew(outcome, certificates, record, id)


@pytest.mark.parametrize("id", sampled(["eq16.invariance", "equilibria", "limit"], 1))
def test_what_does_not_fail_where_a_condition_is_violated_is_told(
    decided, certificates, record, id
):
    data = certificates[id].data
    (failure,) = data["failures"]
    other = {"holds": "denied", "denied": "holds"}[failure["sign"]]
    point = ("evidence", 0, "point" if "point" in failure["evidence"][0] else "points")
    for new in (changed(failure, point, []), {**failure, "sign": other}):
        more = forged(certificates, id, data["evidence"], failures=[new])
        is_searched_anew(decided(id, more), certificates, record, id)
    for value in ({}, [3]):
        more = forged(certificates, id, data["evidence"], failures=value)
        is_searched_anew(decided(id, more), certificates, record, id)
    unsaid = forged(certificates, id, data["evidence"], failures=None)  # it is found anew
    assert decided(id, unsaid).conditions == decided(id, certificates).conditions


def numbers(data, choose):
    """The same evidence with one of its numbers changed."""
    paths = [p for p in places(data) if type(at(data, p)) is int and p[-1] not in ("goal", "inner")]
    paths = [p for p in paths if "roots" not in p and "away" not in p]
    path = choose(paths)
    value = at(data, path)
    return changed(data, path, choose([value + 1, -value - 1, 2 * value + 3]))


MANY = (4, pytest.param(400, marks=pytest.mark.slow))
"""How often evidence is tampered with."""


@pytest.mark.parametrize("id", sampled(CLAIMS, 1))
@pytest.mark.parametrize(
    "seed", [0, *(pytest.param(k, marks=pytest.mark.slow) for k in range(1, 8))]
)
def test_a_number_that_is_changed_proves_nothing_else(decided, certificates, record, id, seed):
    choose = random.Random(f"{id} {seed}").choice
    evidence = numbers(certificates[id].data["evidence"], choose)
    outcome = decided(id, forged(certificates, id, evidence))
    if outcome.note:
        is_searched_anew(outcome, certificates, record, id)
    else:  # another point that is as good, or another combination
        assert outcome.verdict == record[id]["verdict"]
        accepted = {**certificates[id].data, "evidence": evidence}
        checker.check(json.dumps(accepted))


@pytest.mark.parametrize("many", MANY)
def test_no_tampered_evidence_makes_the_run_crash_or_the_verdict_another(
    decided, certificates, record, many
):
    """Whatever stands at whatever place: the recorded verdict."""
    choose = random.Random(2002)
    for _ in range(many):
        id = choose.choice(CLAIMS)
        data = certificates[id].data
        evidence = data["evidence"]
        path = choose.choice([*places(evidence)])
        names = sorted(names_in(data["spaces"]))
        value = choose.choice(others(evidence, path, [choose.choice(names), "i"]))
        outcome = decided(id, forged(certificates, id, changed(evidence, path, value)))
        assert outcome.verdict == record[id]["verdict"], (id, path, value)


@pytest.mark.slow
@pytest.mark.parametrize("many", MANY)
@pytest.mark.parametrize("paper", PAPERS)
def test_evidence_twisted_in_any_way_is_told_or_a_proof_for_the_checker_too(paper, many):
    folder = find(paper)
    derivation, stored, record = load(folder.name), load_certificates(folder), load_record(folder)
    session = Session(derivation, ["flint"], record=record)
    choose = random.Random(2004)
    for claim in choose.choices(derivation.claims, k=many):
        new = twisted({key: stored[claim.id].data[key] for key in ("evidence", "sign")}, choose)
        data = {**stored[claim.id].data, "evidence": None, "sign": None, **new}
        session.decider.archive.certificates = {
            **stored,
            claim.id: Stored(stored[claim.id].path, data),
        }
        outcome = session.decide(claim)
        assert outcome.verdict == record[claim.id]["verdict"], new
        assert outcome.certificates
        for text in outcome.certificates.values():
            checker.check(text)


@pytest.mark.parametrize("arithmetic", EXACT)
def test_in_every_arithmetic(derivation, certificates, record, arithmetic):
    evidence = deepcopy(certificates["eq20.2"].data["evidence"])
    evidence[0]["cofactors"] = [
        [["*", 2, entry] for entry in row] for row in evidence[0]["cofactors"]
    ]
    stored = forged(certificates, "eq20.2", evidence)
    (outcome,) = Session(derivation, [arithmetic], certificates=stored).run(["eq20.2"]).outcomes
    is_searched_anew(outcome, certificates, record, "eq20.2")
    assert f"({arithmetic}: the two sides are not equal)" in outcome.note


def test_evidence_for_another_statement_is_not_looked_at(decided, certificates, record):
    stored = forged(certificates, "eq15", [{"trust": "me"}], digest="0123456789abcdef")
    assert decided("eq15", stored).verdict == record["eq15"]["verdict"]


def test_forged_evidence_for_a_correction(decided, certificates, record):
    name = "corrected/eq10.1"
    for evidence in ([{"cofactors": [[1]]}], 5):
        outcome = decided("eq10.1", forged(certificates, name, evidence))
        is_searched_anew(outcome, certificates, record, name)


def test_the_correction_of_the_record_is_only_looked_at_first(decided, certificates):
    for tex in ("x_1 = (", "x_1' = x_1'", "x_1 = x_1", r"x_1' = -x_1\omega_3 + z_2w_1"):
        record = {"eq10.1": {"verdict": "refuted", "correction": tex}}
        outcome = decided("eq10.1", certificates, record)
        assert outcome.verdict == "refuted" and outcome.correction.verdict == "proved"


def test_cofactors_may_not_be_divided_by_what_vanishes_on_the_set(derivation):
    """A goal over a hypothesis, times this hypothesis, is the goal."""
    claim = next(c for c in derivation.claims if c.id == "eq20.2")
    session = Session(derivation, ["flint"])
    statement = Statement(claim, session.on(claim))
    (shown,) = statement.search()
    assert isinstance(shown, Entailment)
    space = statement.goals[0].space
    known = finder_of(space).differences(statement.goals[0].given)
    (target, *_) = finder_of(space).differences(statement.goals[0].conclusions[0])
    first = next(k for k, element in enumerate(known) if not element.is_zero)
    entries = [finder_of(space).ring.zero] * len(known)
    entries[first] = target / known[first]
    rows = list(shown.proof.rows)
    rows[0] = tuple(map(formula_in, entries))
    with pytest.raises(Unproved):
        session.decider.arithmetics.judge(
            statement, (shown._replace(proof=Proof(tuple(rows))),), "flint"
        )


@pytest.mark.parametrize(
    "text", ["", "{", "[]", '"x"', '{"version": 0}', '{"version": "2"}', "\x00", "[" * 9999]
)
def test_files_that_are_none_cannot_be_read(tmp_path, text):
    (tmp_path / "certificates" / "corrected").mkdir(parents=True)
    for name in ("eq1.json", "corrected/eq1.json"):
        (tmp_path / "certificates" / name).write_text(text)
    found = load_certificates(tmp_path)
    for name in ("eq1", "corrected/eq1"):
        with pytest.raises(FormatError):
            _ = found[name].data
    assert load_certificates(Path("nowhere")) == {}


@pytest.mark.slow
def test_what_is_passed_over_is_proved_anew(derivation, record):
    ids = ["eq9.i", "eq10.7", "eq12", "eq22"]
    found = Session(derivation, ["flint"]).run(ids).outcomes
    assert {o.claim: str(o.verdict) for o in found} == {id: record[id]["verdict"] for id in ids}
    for outcome in found:
        assert (outcome.correction is None) == (record[outcome.claim]["correction"] is None)


def test_the_version_is_that_of_the_checker(certificates):
    assert all(stored.data["version"] == VERSION for stored in certificates.values())
