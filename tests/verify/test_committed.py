"""The certificates that are committed: accepted by the checker, and compared with the record."""

import json
import random
import subprocess
import sys
from functools import cache
from pathlib import Path

import pytest

from kowalevski_cas.library import available, find
from kowalevski_cas.problem import checker
from kowalevski_cas.verify.committed import certificate_files, check_committed, check_files, wanted
from kowalevski_cas.verify.record import load_record
from tests.problem.oracle import is_true
from tests.problem.tampering import at, changed, names_in, others, places, seal

CHECKER = Path(checker.__file__)
FILES = [path for name in available() for path in certificate_files(find(name))]
FIRST = find("kharlamov2002") / "certificates"
TEXTS = {
    path.relative_to(FIRST).with_suffix("").as_posix(): path.read_text(encoding="utf-8")
    for path in certificate_files(FIRST.parent)
}
"""The certificates of the first paper; the oracle cannot look at as many roots as the other has."""

SAMPLE = 25
"""How many certificates are judged by the oracle, out of all, and tampered with in a quick run."""


def certificate(claim):
    return json.loads(TEXTS[claim])


def rejected(data, message=None):
    with pytest.raises(checker.Rejected, match=message):
        checker.check(seal(data))


@pytest.mark.parametrize("flags", [("-I", "-S", "-O")])
def test_all_are_accepted(flags):
    command = [sys.executable, *flags, str(CHECKER), *map(str, FILES)]
    result = subprocess.run(command, capture_output=True, text=True)
    assert result.returncode == 0, result.stdout
    assert result.stdout.splitlines()[-1] == f"CERTIFIED {len(FILES)} of {len(FILES)}"
    assert len(FILES) > 200


@pytest.mark.parametrize("name", available())
def test_every_recorded_claim_has_one(name):
    record = load_record(find(name))
    assert len(wanted(record)) == len(certificate_files(find(name)))
    assert {*record} <= {*wanted(record)}


def test_words():
    said = checker.check(TEXTS["theta-prime"]).theorems
    assert said[0].words == r"D(\theta) = Q_2"
    assert (
        checker.check(TEXTS["eq14"])
        .summary()
        .startswith("eq14: it is false that D((U_1 + (-U_2))) = ")
    )


class TestRecord:
    DATA = certificate("eq6")

    def checked(self, folder, claim="eq6", where="certificates", **entry):
        (folder / where).mkdir(parents=True)
        (folder / where / "eq6.json").write_text(TEXTS[claim], encoding="utf-8")
        entry = {"statement": self.DATA["digest"], "verdict": "proved", **entry}
        return check_committed(folder, {"eq6": entry, "eq7": {"verdict": "undecided"}})

    def test_as_recorded(self, tmp_path):
        found = self.checked(tmp_path)
        assert found.digests == {"eq6": self.DATA["digest"]} and not found.rejected
        assert found.without == ("eq7",) and found.total == 1

    def test_another_statement(self, tmp_path):
        (why,) = self.checked(tmp_path, statement="0123456789abcdef").rejected.values()
        assert "another statement" in why and "make certificates" in why

    def test_another_verdict(self, tmp_path):
        (why,) = self.checked(tmp_path, verdict="refuted").rejected.values()
        assert "another verdict" in why and "make certificates" in why

    def test_of_another_claim(self, tmp_path):
        (why,) = self.checked(tmp_path, claim="eq4.1").rejected.values()
        assert "it is about the claim eq4.1" in why

    def test_a_correction_that_is_not_recorded(self, tmp_path):
        found = self.checked(tmp_path, where="certificates/corrected")
        assert any("no correction" in why for why in found.rejected.values())
        assert found.rejected["eq6.json"] == "it is in the record, and missing"

    def test_a_correction_that_is_denied(self, tmp_path):
        (tmp_path / "certificates" / "corrected").mkdir(parents=True)
        for folder in ("certificates", "certificates/corrected"):
            (tmp_path / folder / "eq14.json").write_text(TEXTS["eq14"], encoding="utf-8")
        entry = {
            "statement": certificate("eq14")["digest"],
            "verdict": "refuted",
            "correction": "x",
        }
        (why,) = check_committed(tmp_path, {"eq14": entry}).rejected.values()
        assert "a correction has to hold" in why

    def test_one_that_says_something_else_under_the_same_digest(self, tmp_path):
        """The digest is that of what the file states: it cannot be kept for something else."""
        data = {**self.DATA, "goals": [{**self.DATA["goals"][0], "conclusions": [[[1, 1]]]}]}
        (tmp_path / "certificates").mkdir()
        path = tmp_path / "certificates" / "eq6.json"
        path.write_text(json.dumps(data))
        assert not check_files(certificate_files(tmp_path)).digests
        path.write_text(seal(data))
        entry = {"statement": self.DATA["digest"], "verdict": "proved"}
        assert not check_committed(tmp_path, {"eq6": entry}).digests

    def test_one_that_is_missing(self, tmp_path):
        entry = {"statement": self.DATA["digest"], "verdict": "proved", "correction": "x"}
        found = check_committed(tmp_path, {"eq6": entry})
        missing = "it is in the record, and missing"
        assert found.rejected == {"eq6.json": missing, "corrected/eq6.json": missing}

    def test_one_of_a_claim_that_is_not_made(self, tmp_path):
        self.checked(tmp_path)
        (why,) = check_committed(tmp_path, {}).rejected.values()
        assert "no such claim" in why


class TestStatements:
    def test_a_false_claim_with_honest_evidence(self):
        for claim in ("eq6", "theta-prime", "eq20.2", "eq15"):
            data = certificate(claim)
            goal = data["goals"][0]
            inner = goal["goals"][0] if goal["goal"] == "exists" else goal
            inner["conclusions"][0][0] = [
                ["+", inner["conclusions"][0][0][0], 1],
                inner["conclusions"][0][0][1],
            ]
            rejected(data, "not equal|may be")

    def test_a_condition_removed(self):
        data = certificate("equilibria")
        rejected(changed(data, ("evidence", 0, "away"), None), "may be zero")
        for claim in ("eq12", "eq15", "ratio", "eq22"):
            data = certificate(claim)
            for k, space in enumerate(data["spaces"]):
                for j in range(len(space.get("nonzero", []))):
                    rejected(changed(data, ("spaces", k, "nonzero", j), None))

    def test_a_field_with_a_gap_or_twice(self):
        data = certificate("eq4.1")
        rows = data["spaces"][0]["field"]
        data["spaces"][0]["field"] = rows[:-1]
        rejected(data)
        data["spaces"][0]["field"] = rows * 2
        rejected(data, "twice")

    def test_a_rank_with_dependent_functions(self):
        data = certificate("M4-independence")
        goal = data["goals"][-1]
        goal["functions"] = [goal["functions"][0]] * len(goal["functions"])
        rejected(data)

    def test_a_point_off_the_set(self):
        data = certificate("M4-dimension")
        data["evidence"][0]["point"]["values"][0][1] = 7
        rejected(data, "not where it should be")

    def test_two_sides_that_do_not_differ(self):
        data = certificate("eq14")
        sides = data["goals"][0]["conclusions"][0][0]
        sides[1] = sides[0]
        rejected(data, "may be equal")

    def test_a_case_left_out(self):
        data = json.loads(TEXTS["corrected/critical-set"])
        paths = [p for p in places(data["evidence"]) if p[-1] in ("product", "cases")]
        assert paths
        for path in paths:
            if len(at(data["evidence"], path)) == 1:
                continue
            other = json.loads(TEXTS["corrected/critical-set"])
            proof = at(other["evidence"], path[:-1])
            proof["product"], proof["cases"] = proof["product"][:1], proof["cases"][:1]
            rejected(other, "not equal|length|empty|odd|may be")


# -- tampering ---------------------------------------------------------------------


@cache
def all_places(claim):
    data = json.loads(TEXTS[claim])
    keys = ("spaces", "goals", "evidence", "sign")
    return [path for path in places(data) if path[0] in keys]


def judge(claim, choose):
    """Tamper at a place; what the checker accepts has to be true. Whether it was accepted."""
    data, path = json.loads(TEXTS[claim]), choose(all_places(claim))
    names = sorted(names_in([data["spaces"], data["goals"]]))
    value = choose(others(data, path, [choose(names), choose(names)]))
    other = changed(data, path, value)
    try:
        checker.check(seal(other))
    except checker.Rejected:
        return False
    true, why = is_true(other)
    assert true, f"{claim}: {path} = {str(value)[:60]} got through: {why}"
    return True


def test_the_oracle_finds_them_true():
    for claim in random.Random(2002).sample(sorted(TEXTS), SAMPLE):
        assert is_true(json.loads(TEXTS[claim])) == (True, ""), claim


@pytest.mark.slow
def test_the_oracle_finds_all_of_them_true():
    for claim, text in TEXTS.items():
        assert is_true(json.loads(text)) == (True, ""), claim


def test_the_oracle_is_no_yes_sayer():
    data = certificate("eq20.2")
    data["goals"][0]["conclusions"][0][0][1] = 1
    assert not is_true(data)[0]
    data = certificate("eq6")
    data["spaces"][0]["field"][0][2] = ["-", data["spaces"][0]["field"][0][2]]
    assert not is_true(data)[0]


def tampered(many):
    choose = random.Random(2002).choice
    claims = [choose(sorted(TEXTS)) for _ in range(many)]
    through = sum(judge(claim, choose) for claim in claims)
    assert through < many / 4


def test_tampering():
    tampered(8 * SAMPLE)


@pytest.mark.slow
def test_tampering_at_thousands_of_places():
    tampered(6000)
