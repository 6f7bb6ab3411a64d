"""Evidence is not trusted: whatever is written there, nothing false becomes green."""

import random
import re
from fractions import Fraction

import pytest

from kowalevski_cas.paper.claims import InvariantRelations
from kowalevski_cas.proof.evidence import Evidence, Mended, dump_evidence, load_evidence
from kowalevski_cas.verify.outcome import in_latex
from kowalevski_cas.verify.run import Session, verify
from tests.paper.small import Oscillator, decide


@pytest.fixture
def evidence(folder):
    return load_evidence(folder)


def only(derivation, id, evidence, arithmetics=("flint",)):
    (outcome,) = verify(derivation, arithmetics, only=[id], evidence=evidence).outcomes
    return outcome


def test_evidence_is_read_back_as_it_was_written(folder, evidence, tmp_path):
    (tmp_path / "evidence.json").write_text(dump_evidence(evidence), encoding="utf-8")
    assert load_evidence(tmp_path) == evidence
    assert dump_evidence(evidence) == (folder / "evidence.json").read_text(encoding="utf-8")


@pytest.mark.parametrize(
    "text", ["", "{", "[]", '{"version": 0}', '{"version": 1, "claims": {"a": {}}}', "\x00"]
)
def test_evidence_that_cannot_be_read_is_none(tmp_path, text):
    (tmp_path / "evidence.json").write_text(text)
    assert load_evidence(tmp_path) == {}
    assert load_evidence(tmp_path / "nowhere") == {}


def test_evidence_for_another_statement_is_not_looked_at(derivation, evidence):
    evidence["eq15"].digest = "another"
    evidence["eq15"].found = {label: None for label in evidence["eq15"].found}
    assert only(derivation, "eq15", evidence).verdict == "conditional"
    assert all(evidence["eq15"].found.values())


def doubled(value):
    """The same with every polynomial twice as large."""
    match value:
        case Fraction():
            return value * 2
        case dict():
            return {k: doubled(v) for k, v in value.items()}
        case list() | tuple():
            return type(value)(map(doubled, value))
    return value


COFACTORS = ["eq7", "J3", "eq15", "real-form.1", "eq16.1", "eq16.invariance", "eq18", "ratio", "eq22", "redundant-integral", "appelrot-area", "limit"]  # fmt: skip


@pytest.mark.parametrize("id", COFACTORS)
def test_wrong_cofactors_are_not_believed(derivation, evidence, outcomes, id):
    found = evidence[id].found
    evidence[id].found = {
        k: doubled(v) if k.startswith("cofactors") else v for k, v in found.items()
    }
    found = only(derivation, id, evidence)
    assert found.verdict in (outcomes[id].verdict, "undecided")
    conditions = {condition.expression for condition in found.conditions}
    assert not found.verdict.green or {c.expression for c in outcomes[id].conditions} <= conditions


@pytest.mark.parametrize("id", ["eq7", "J3", "eq15", "eq22", "redundant-integral", "limit"])
def test_cofactors_that_are_wrong_are_found_anew(derivation, evidence, outcomes, id):
    found = evidence[id].found
    evidence[id].found = {
        k: doubled(v) if k.startswith("cofactors") else v for k, v in found.items()
    }
    assert only(derivation, id, evidence).verdict == outcomes[id].verdict
    again = evidence[id].found
    assert all(again[label] == value for label, value in found.items() if label in again)


@pytest.mark.parametrize(
    "id", ["eq10.1", "eq14", "eq21", "M4-dimension", "N4-independence", "kowalevski-variable"]
)
def test_wrong_points_and_guesses_prove_nothing(derivation, evidence, outcomes, id):
    evidence[id].found = {label: doubled(value) for label, value in evidence[id].found.items()}
    verdict = only(derivation, id, evidence).verdict
    assert verdict in (outcomes[id].verdict, "undecided")


@pytest.mark.parametrize("id", COFACTORS)
def test_what_was_found_may_be_missing(derivation, evidence, outcomes, id):
    del evidence[id]
    assert only(derivation, id, evidence).verdict == outcomes[id].verdict


@pytest.mark.parametrize("id", COFACTORS)
def test_a_search_that_found_nothing_proves_nothing(derivation, evidence, outcomes, id):
    evidence[id].found = {label: None for label in evidence[id].found}
    # An equivalence is searched for in the other direction; everything else is undecided.
    assert only(derivation, id, evidence).verdict in (outcomes[id].verdict, "undecided")


@pytest.mark.parametrize("seed", range(6))
def test_random_changes_of_numbers_never_make_a_misprint_green(
    derivation, folder, outcomes, tmp_path, seed
):
    changes = random.Random(seed)
    lines = (folder / "evidence.json").read_text(encoding="utf-8").splitlines()
    for k, line in enumerate(lines):
        if 'correction":null' in line or "eq9.i" in line:
            lines[k] = re.sub(r'"q":"-?\d+', lambda m: f'"q":"{changes.randint(-9, 9)}', line)
    (tmp_path / "evidence.json").write_text("\n".join(lines), encoding="utf-8")
    ids = ["eq9.i", "eq10.1", "critical-set"]
    for outcome in verify(
        derivation, ["flint"], only=ids, evidence=load_evidence(tmp_path)
    ).outcomes:
        assert not outcome.verdict.green


def test_a_false_correction_is_not_green(derivation, evidence):
    tex = evidence["eq10.1"].correction.tex
    evidence["eq10.1"].correction = Mended("eq10.1", tex.replace("z_1 w_1", "z_2 w_1"), "wrong")
    outcome = only(derivation, "eq10.1", evidence)
    assert outcome.verdict == "refuted"
    assert not outcome.correction.verdict.green


def test_a_search_for_a_correction_that_was_given_up_stays_given_up(derivation, evidence):
    evidence["eq14"].correction, evidence["eq14"].hopeless = None, True
    outcome = only(derivation, "eq14", evidence)
    assert outcome.verdict == "refuted" and outcome.correction is None


def test_a_correction_changes_its_own_statement_only(derivation, evidence):
    tex = evidence["eq10.1"].correction.tex
    evidence["eq10.1"].correction = Mended("eq10.1", tex.replace("w_3", r"\omega_3"), "all rows")
    outcomes = verify(derivation, ["flint"], only=["eq10.1", "eq10.2"], evidence=evidence).outcomes
    assert [str(o.verdict) for o in outcomes] == ["refuted", "refuted"]


def test_a_correction_is_a_neighbour_of_what_is_printed(derivation, evidence):
    tex = evidence["eq10.1"].correction.tex
    start = tex.index("{x'_1")
    trivial = tex[:start] + "{x'_1 = x'_1" + tex[tex.index(",", start) :]
    evidence["eq10.1"].correction = Mended("eq10.1", trivial, "trivial")
    assert in_latex(only(derivation, "eq10.1", evidence).correction.formulas) != "x_1' = x_1'"


def test_a_split_into_no_cases_proves_nothing(derivation, evidence):
    claim = next(c for c in derivation.claims if c.id == "critical-set")
    session = Session(derivation, ["flint"], False, {})
    bench = session._bench("flint", session.texts)
    system = claim.problem(bench).system(bench.stage(claim.scene))
    none = (0,) * len(system.granted)
    target = system.targets[0].terms()[0]
    empty = ("split", (), ((0, none, (), target, none, ()),), ())
    found = evidence["critical-set"].found
    evidence["critical-set"].found = {
        k: empty if k.startswith("cases") else v for k, v in found.items()
    }
    assert not only(derivation, "critical-set", evidence).verdict.green


def test_cofactors_may_not_be_divided_by_what_vanishes_on_the_set():
    small = Oscillator()
    place = small("x=0")
    claim = InvariantRelations("t", small.scene, None, "", relations=(place,), names=("x",))
    (honest,) = decide(small.section, claim)
    assert honest.verdict == "refuted"
    session = Session(_again(small), ["flint"], False, {})
    stage = session._bench("flint", session.texts).stage(small.scene)
    forged = claim.rate(stage, 0) / claim.functions(stage)[0]
    kept = {"t": Evidence(honest.digest, {"cofactors/t/0": [forged.neutral()]})}
    (outcome,) = verify(_again(small), ["flint"], evidence=kept).outcomes
    assert not outcome.verdict.green


def _again(small):
    from tests.paper.small import derivation

    return derivation(small.section)


@pytest.mark.parametrize(
    ("id", "label", "value"),
    [("eq7", "cofactors/eq7/0", []), ("eq7", "cofactors/eq7/0", 5), ("J3", "counterexample/J3", {}),
     ("M4-dimension", "rank/M4-dimension/generic", 7), ("critical-set", "cases/critical-set/any level", None),
     ("kowalevski-variable", "constant/kowalevski-variable", [Fraction(1)])],
)  # fmt: skip
def test_evidence_of_another_shape_is_searched_for_again(
    derivation, evidence, outcomes, id, label, value
):
    evidence[id].found[label] = value
    assert only(derivation, id, evidence).verdict in (outcomes[id].verdict, "undecided")


@pytest.mark.parametrize(
    "correction", [Mended("eq10.9", "x_1=x_1", ""), Mended("eq10.1", "x_1=(", "")]
)
def test_a_correction_that_cannot_be_read_is_searched_for_again(derivation, evidence, correction):
    evidence["eq10.1"].correction = correction
    assert only(derivation, "eq10.1", evidence).verdict == "refuted"
