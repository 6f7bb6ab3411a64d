import json

import pytest

from kowalevski_cas.library import find, load
from kowalevski_cas.proof import checker
from kowalevski_cas.proof.certificate import certificates
from kowalevski_cas.proof.evidence import load_evidence
from kowalevski_cas.verify.record import load_record

PAPER = find("kharlamov2002")


@pytest.fixture(scope="module")
def written():
    return certificates(load("kharlamov2002"), load_evidence(PAPER))


def test_every_claim_has_one(written):
    assert [(one.claim, one.reason) for one in written if not one.text] == []
    assert [one.claim for one in written] == list(load_record(PAPER))


def test_the_committed_ones_say_what_is_printed(written):
    """They are written again, from the printed formulas: so statement and certificate belong together."""
    for one in written:
        committed = (PAPER / "certificates" / f"{one.claim}.json").read_text(encoding="utf-8")
        assert committed == one.text, one.claim


def test_the_record_has_their_digests(written):
    record = load_record(PAPER)
    assert {one.claim: one.digest for one in written} == {
        claim: entry["certificate"] for claim, entry in record.items()
    }


def test_what_rests_on_words_says_so(written):
    notes = {one.claim: json.loads(one.text)["notes"] for one in written}
    assert any("sign" in note for note in notes["equilibria"])
    assert any("gradient" in note for note in notes["critical-set"])
    assert not notes["eq6"]


def part(claim, written, shows):
    (text,) = (one.text for one in written if one.claim == claim)
    return [part for part in json.loads(text)["parts"] if part["shows"] == shows]


def test_the_critical_set_is_refuted_and_proved_in_both_directions(written):
    (point,) = part("critical-set", written, "differ")
    assert len(point["given"]) == 7
    forward, converse = part("critical-set", written, "follows")
    assert forward["equations"] == converse["given"][:-1]
    assert forward["given"] == [*converse["equations"], converse["given"][-1]]
    assert len(converse["cases"]) == 2


def test_states_of_rest_belong_to_the_roots_of_an_equation_whose_signs_alternate(written):
    to_roots, from_roots, *_, turning = part("equilibria", written, "follows")
    (equation,) = (sides for sides in from_roots["given"] if sides in to_roots["equations"][:1])
    assert equation[1] == 0
    signs = [str(sides[1]).startswith("['*', ['-', 4]") for sides in turning["equations"]]
    assert signs == [True, False, True]


def test_a_case_left_out_is_noticed(written):
    (text,) = (one.text for one in written if one.claim == "critical-set")
    data = json.loads(text)
    proof = data["parts"][2]
    for key in ("product", "cases"):
        proof[key] = proof[key][:1]
    with pytest.raises(checker.Rejected, match="not equal"):
        space = checker.Space([], **data["spaces"][0])
        space.follows(**{key: proof[key] for key in proof if key not in ("space", "shows")})
