"""The record: any difference is seen, in either direction; what cannot be read is said."""

import json

import pytest

from kowalevski_cas.verify.outcome import Verdict
from kowalevski_cas.verify.record import RecordError, differences, dump_record, load_record


@pytest.fixture
def recorded(run, tmp_path):
    (tmp_path / "record.json").write_text(dump_record(run, {}), encoding="utf-8")
    return load_record(tmp_path)


def with_outcome(run, id, **changes):
    return run._replace(
        outcomes=tuple(o._replace(**changes) if o.claim == id else o for o in run.outcomes)
    )


def test_a_record_is_the_run_that_wrote_it(run, recorded):
    assert differences(run, recorded) == []


@pytest.mark.parametrize(("id", "verdict"), [("eq10.5", Verdict.REFUTED), ("eq10.1", Verdict.PROVED), ("eq15", Verdict.PROVED)])  # fmt: skip
def test_a_verdict_that_changes_is_a_difference_whichever_way(run, recorded, id, verdict):
    before = recorded[id]["verdict"]
    (found,) = differences(with_outcome(run, id, verdict=verdict), recorded)
    assert (found.claim, found.recorded, found.found) == (id, before, str(verdict))


def test_conditions_corrections_and_statements_are_compared(run, recorded):
    (found,) = differences(with_outcome(run, "eq15", conditions=()), recorded)
    assert (found.recorded, found.found) == ("conditions x_1x_2", "conditions none")
    (found,) = differences(with_outcome(run, "eq14", correction=None), recorded)
    assert found.recorded.startswith("correction ") and found.found == "correction none"
    (found,) = differences(with_outcome(run, "eq6", digest="0"), recorded)
    assert found.found == "statement 0"


def test_claims_that_are_new_or_gone_are_differences(run, recorded):
    less = {id: entry for id, entry in recorded.items() if id != "eq6"}
    (found,) = differences(run, less)
    assert (found.claim, found.recorded, found.found) == ("eq6", "not in the record", "proved")
    (found,) = differences(run, {**recorded, "eq99": {"verdict": "proved"}})
    assert (found.claim, found.recorded, found.found) == ("eq99", "proved", "not a claim")
    assert differences(run, {**recorded, "eq99": {}}, whole=False) == []


def test_no_record_is_none(tmp_path):
    assert load_record(tmp_path) is None


@pytest.mark.parametrize(
    "text", ["", "{", "[]", "{}", '{"claims": 3}', '{"claims": {"eq1": 7}}', "\x00"]
)
def test_an_unreadable_record_says_what_to_do(tmp_path, text):
    (tmp_path / "record.json").write_text(text)
    with pytest.raises(RecordError) as raised:
        load_record(tmp_path)
    assert str(raised.value).startswith(f"{tmp_path / 'record.json'}: the record cannot be read")
    assert str(raised.value).endswith("`make record` writes it anew")


def test_bytes_that_are_no_text_are_an_unreadable_record(tmp_path):
    (tmp_path / "record.json").write_bytes(b"\xff\xfe\x80")
    with pytest.raises(RecordError, match="`make record` writes it anew"):
        load_record(tmp_path)


@pytest.mark.parametrize("verdict", [Verdict.TIMEOUT, Verdict.ERROR])
def test_of_a_claim_that_came_to_no_end_the_record_keeps_what_it_has(run, recorded, verdict):
    late = with_outcome(run, "eq15", verdict=verdict, conditions=())
    assert json.loads(dump_record(late, recorded))["claims"] == recorded
    anew = json.loads(dump_record(late, {}))["claims"]
    assert anew == {id: entry for id, entry in recorded.items() if id != "eq15"}
