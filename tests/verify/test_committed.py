"""The certificates that are committed: accepted by the checker, and compared with the record."""

import json
import random
import shutil
import subprocess
import sys
from functools import cache
from pathlib import Path

import pytest

from kowalevski_cas.library import available, find, load
from kowalevski_cas.problem import checker
from kowalevski_cas.verify.committed import (
    Expected,
    certificate_files,
    certificates_of,
    check_committed,
    check_files,
    statements,
)
from kowalevski_cas.verify.record import load_record
from tests.problem.oracle import is_true
from tests.problem.tampering import (
    changed,
    doubled_key,
    names_in,
    others,
    places,
    scratched,
    seal,
    twisted,
)
from tests.sample import sampled

CHECKER = Path(checker.__file__).parent
PAPERS = ("kharlamov2002", "kharlamov_savushkin2004")
"""Those of which the oracle has points at which no root vanishes."""

FILES = [path for name in PAPERS for path in certificate_files(find(name))]
FIRST = find("kharlamov2002") / "certificates"
TEXTS = {
    path.relative_to(FIRST).with_suffix("").as_posix(): path.read_text(encoding="utf-8")
    for path in certificate_files(FIRST.parent)
}
"""The certificates of the first paper; the oracle cannot look at as many roots as the other has."""

SAMPLE = 10
"""How many certificates are judged by the oracle, out of all, and tampered with in a quick run."""


def certificate(claim):
    return json.loads(TEXTS[claim])


def rejected(data, message=None):
    with pytest.raises(checker.Rejected, match=message):
        checker.check(seal(data))


def committed(folder, *known):
    return check_committed(folder, load(str(folder)), *known)


@pytest.mark.parametrize("many", [25, pytest.param(None, marks=pytest.mark.slow)])
def test_all_are_accepted(many):
    files = random.Random(1).sample(FILES, many or len(FILES))
    command = [sys.executable, "-I", "-S", "-O", str(CHECKER), *map(str, files)]
    result = subprocess.run(command, capture_output=True, text=True)
    assert result.returncode == 0, result.stdout
    assert result.stdout.splitlines()[-1] == f"CERTIFIED {len(files)} of {len(files)}"
    assert len(FILES) > 200


@pytest.mark.parametrize("name", available())
def test_every_recorded_claim_has_one(name):
    record, files = load_record(find(name)), certificate_files(find(name))
    assert len(certificates_of(record)) == len(files) and {*record} <= {*certificates_of(record)}
    for path in files:
        if path.parent.name != "corrected":
            digest = json.loads(path.read_text(encoding="utf-8"))["digest"]
            assert digest == record[path.stem]["statement"]


def test_words():
    said = checker.check(TEXTS["theta-prime"]).theorems
    assert said[0].words == r"D(\theta) = Q_2"
    assert (
        checker.check(TEXTS["eq14"]).summary().startswith("eq14: it is false that D(U_1 - U_2) = ")
    )


@pytest.fixture
def paper(tmp_path):
    """The derivation of the first paper, with its record and without a certificate."""
    others = shutil.ignore_patterns("certificates")
    return shutil.copytree(FIRST.parent, tmp_path / "paper", ignore=others)


class TestRecord:
    DATA = certificate("eq6")

    def checked(self, folder, claim="eq6", where="certificates", **entry):
        (folder / where).mkdir(parents=True)
        (folder / where / "eq6.json").write_text(TEXTS[claim], encoding="utf-8")
        entry = {"statement": self.DATA["digest"], "verdict": "proved", **entry}
        return committed(folder, {"eq6": entry, "eq7": {"verdict": "undecided"}})

    def test_as_recorded(self, paper):
        found = self.checked(paper)
        assert found.digests == {"eq6": self.DATA["digest"]} and not found.rejected
        assert found.without == ("eq7",) and found.total == 1

    def test_another_statement(self, paper):
        (why,) = self.checked(paper, statement="0123456789abcdef").rejected.values()
        assert "another statement" in why and "make certificates" in why

    def test_another_verdict(self, paper):
        (why,) = self.checked(paper, verdict="refuted").rejected.values()
        assert "another verdict" in why and "make certificates" in why

    def test_of_another_claim(self, paper):
        (why,) = self.checked(paper, claim="eq4.1").rejected.values()
        assert "it is about the claim eq4.1" in why

    def test_a_correction_that_is_not_recorded(self, paper):
        found = self.checked(paper, where="certificates/corrected")
        assert any("no correction" in why for why in found.rejected.values())
        assert found.rejected["eq6.json"] == "it is in the record, and missing"

    def test_a_correction_that_is_denied(self, paper):
        (paper / "certificates" / "corrected").mkdir(parents=True)
        for folder in ("certificates", "certificates/corrected"):
            (paper / folder / "eq14.json").write_text(TEXTS["eq14"], encoding="utf-8")
        entry = {
            "statement": certificate("eq14")["digest"],
            "verdict": "refuted",
            "correction": "x",
        }
        (why,) = committed(paper, {"eq14": entry}).rejected.values()
        assert "a correction has to hold" in why

    def test_one_that_says_something_else_under_the_same_digest(self, paper):
        """The digest is that of what the file states: it cannot be kept for something else."""
        data = {**self.DATA, "goals": [{**self.DATA["goals"][0], "conclusions": [[[1, 1]]]}]}
        (paper / "certificates").mkdir()
        path = paper / "certificates" / "eq6.json"
        path.write_text(json.dumps(data))
        assert not check_files(certificate_files(paper)).digests
        path.write_text(seal(data))
        entry = {"statement": self.DATA["digest"], "verdict": "proved"}
        assert not committed(paper, {"eq6": entry}).digests

    def test_one_that_is_missing(self, paper):
        entry = {"statement": self.DATA["digest"], "verdict": "proved", "correction": "x"}
        found = committed(paper, {"eq6": entry})
        missing = "it is in the record, and missing"
        assert found.rejected == {"eq6.json": missing, "corrected/eq6.json": missing}

    def test_one_of_a_claim_that_is_not_made(self, paper):
        self.checked(paper)
        (why,) = committed(paper, {}).rejected.values()
        assert "no such claim" in why


class TestPrint:
    """A certificate is compared with what is printed, whatever it and the record say."""

    PAPER = Expected(load(str(FIRST.parent)), load_record(FIRST.parent))

    def checked(self, folder, data, where="certificates", **entry):
        (folder / where).mkdir(parents=True, exist_ok=True)
        text, claim = seal(data), data["claim"]
        (folder / where / f"{claim}.json").write_text(text, encoding="utf-8")
        recorded = load_record(FIRST.parent)[claim]
        self.PAPER.record[claim] = {**recorded, "statement": json.loads(text)["digest"], **entry}
        return check_files(certificate_files(folder), self.PAPER)

    @pytest.mark.parametrize(
        "claim", sampled(["eq14", "eq6", "M4-dimension", "limit", "critical-set"], 1)
    )
    def test_a_triviality_under_the_name_of_a_claim(self, tmp_path, claim):
        goal = {"goal": "follows", "space": 0, "given": [], "conclusions": [[["x", "x"]]]}
        trivial = {"spaces": [{"variables": ["x"]}], "goals": [goal], "sign": "holds"}
        evidence = [{"point": {"roots": [], "values": [["x", 0]]}}]
        data = {**certificate(claim), **trivial, "evidence": evidence}
        assert checker.check(seal(data)).summary() == f"{claim}: x = x"
        found = self.checked(tmp_path, data, verdict="proved")
        assert not found.accepted
        (why,) = found.rejected.values()
        assert "prints another statement" in why

    @pytest.mark.slow
    @pytest.mark.parametrize("name", sampled(available(), 1, seed=1))
    def test_each_certificate_is_about_what_is_printed(self, name):
        folder = find(name)
        about = Expected(load(name), load_record(folder))
        for path in certificate_files(folder):
            data = json.loads(path.read_text(encoding="utf-8"))
            printed = about.printed(data["claim"], path.parent.name == "corrected")
            assert printed.digest == data["digest"], path

    def test_what_a_run_has_decided_is_not_written_anew(self, derivation, run, folder, record):
        decided = statements(run)
        about = Expected(derivation, record, decided)
        found = check_files(sorted((folder / "certificates").rglob("eq1[04]*.json")), about)
        assert found.digests.items() <= decided.items() and not found.rejected
        assert len(found.digests) > 2 and "interpretation" not in vars(about)

    def test_another_statement_than_a_run_has_decided(self, paper):
        wrong = certificate("eq7")["digest"]
        (paper / "certificates").mkdir()
        shutil.copy(FIRST / "eq6.json", paper / "certificates")
        record = {"eq6": load_record(paper)["eq6"]}
        assert committed(paper, record, {"eq6": wrong}).accepted
        record["eq6"] = {**record["eq6"], "statement": wrong}
        assert not committed(paper, record, {"eq6": wrong}).accepted

    def test_another_goal_that_fails_where_a_condition_is_violated(self, tmp_path):
        data, other = certificate("limit"), certificate("eq16.invariance")["failures"]
        found = self.checked(tmp_path, {**data, "failures": other})
        assert not found.accepted
        assert "what fails for a condition is something else" in "".join(found.rejected.values())
        assert "limit" in self.checked(tmp_path, data).accepted

    def test_the_statement_of_another_claim(self, tmp_path):
        data = {**certificate("eq7"), "claim": "eq6"}
        found = self.checked(tmp_path, data)
        assert not found.accepted and "prints another" in "".join(found.rejected.values())

    def test_the_correction_of_another_claim(self, tmp_path):
        data = {**certificate("corrected/eq10.1"), "claim": "eq10.2"}
        found = self.checked(tmp_path, data, "certificates/corrected")
        assert not found.accepted and "prints another" in "".join(found.rejected.values())

    def test_a_correction_that_is_no_edit_of_the_print(self, tmp_path):
        data = {**certificate("eq6"), "claim": "eq14"}
        found = self.checked(tmp_path, data, "certificates/corrected", correction="x_1 = x_1")
        assert not found.accepted and "prints another" in "".join(found.rejected.values())

    def test_a_print_that_has_changed(self, paper):
        section = paper / "section1.py"
        (paper / "certificates").mkdir()
        shutil.copy(FIRST / "eq6.json", paper / "certificates")
        record = {"eq6": load_record(paper)["eq6"]}
        assert committed(paper, record).accepted
        text = section.read_text(encoding="utf-8")
        assert "J_1^2  + J_2^2" in text
        section.write_text(text.replace("J_1^2  + J_2^2", "J_1^2  - J_2^2"), encoding="utf-8")
        (why,) = committed(paper, record).rejected.values()
        assert "prints another" in why

    def test_a_print_that_cannot_be_read(self, paper):
        section = paper / "section1.py"
        (paper / "certificates").mkdir()
        shutil.copy(FIRST / "eq6.json", paper / "certificates")
        text = section.read_text(encoding="utf-8")
        section.write_text(text.replace("J_1^2  + J_2^2", "J_1^2  + ("), encoding="utf-8")
        (why,) = committed(paper, {"eq6": load_record(FIRST.parent)["eq6"]}).rejected.values()
        assert "prints another" in why


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

    @pytest.mark.parametrize(
        "claim", sampled(["eq16.invariance", "equilibria", "corrected/critical-set"], 2, seed=1)
    )
    def test_a_failure_where_no_condition_is_violated(self, claim):
        data = certificate(claim)
        assert [line for line in checker.check(seal(data)).lines() if "at a point where" in line]
        condition = data["failures"][0]["condition"]
        there = changed(data, ("failures", 0, "condition"), ["+", condition, 1])
        rejected(there, "not where it should be")
        sign = "holds" if data["failures"][0]["sign"] == "denied" else "denied"
        rejected(changed(data, ("failures", 0, "sign"), sign))
        theorem = {key: data[key] for key in ("spaces", "goals", "sign", "evidence")}
        rejected(
            {**data, "failures": [{"condition": condition, **theorem}]},
            "nothing fails|another length",
        )

    def test_a_case_left_out(self):
        data = json.loads(TEXTS["redundant-integral"])
        (entry,) = data["evidence"]
        assert len(entry["product"]) == len(entry["cases"]) == 2
        for k in range(2):
            keys = ("product", "cases")
            left = {**entry, **{key: entry[key][k : k + 1] for key in keys}}
            rejected({**data, "evidence": [left]}, "not equal|length|empty|odd|may be")


# -- tampering ---------------------------------------------------------------------


@cache
def all_places(claim):
    data = json.loads(TEXTS[claim])
    keys = ("spaces", "goals", "evidence", "sign", "failures")
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
    tampered(2 * SAMPLE)


@pytest.mark.slow
def test_tampering_at_thousands_of_places():
    tampered(6000)


UNKNOWN = "no point was found"
"""The oracle has no points where too many roots would have to be there."""


def verdict(text):
    """Whether the checker accepts a text: what it accepts is true, what it rejects it calls so."""
    try:
        checker.check(text)
    except checker.Rejected as error:
        assert str(error).isprintable()
        return False
    true, why = is_true(json.loads(text))
    assert true or UNKNOWN in why, f"{text[:2000]} got through: {why}"
    return True


def counted(many, change, seed):
    """How many certificates are accepted after a change; they are of both papers."""
    choose = random.Random(seed)
    return sum(
        verdict(change(choose.choice(FILES).read_text(encoding="utf-8"), choose))
        for _ in range(many)
    )


CHANGES = {
    "twisted": lambda text, choose: seal(twisted(json.loads(text), choose)),
    "scratched": scratched,
    "doubled": doubled_key,
    "exchanged": lambda text, choose: exchanged(text, choose),
}


def exchanged(text, choose):
    """The statement of one claim with the evidence of another one."""
    other = json.loads(choose.choice(FILES).read_text(encoding="utf-8"))
    part = choose.choice([("evidence", "sign"), ("spaces",), ("goals",), ("spaces", "goals")])
    return seal({**json.loads(text), **{key: other[key] for key in part}})


@pytest.mark.parametrize("change", CHANGES)
def test_what_is_changed_in_any_way_is_rejected_or_true(change):
    assert counted(30, CHANGES[change], change) < (1 if change == "doubled" else 15)


@pytest.mark.slow
def test_thousands_of_changes(capsys):
    through = {name: counted(1500, change, 2002) for name, change in CHANGES.items()}
    with capsys.disabled():
        print(
            f"\n{1500 * len(through)} certificates that were changed; true all the same: {through}"
        )
    assert max(through.values()) < 500


@pytest.mark.slow
def test_certificates_come_in_the_order_of_the_record():
    folder = find("kharlamov2002")
    record = load_record(folder)
    found = [
        name.rpartition("/")[2]
        for name in check_committed(folder, load("kharlamov2002"), record).accepted
    ]
    assert list(dict.fromkeys(found)) == [claim for claim in record if claim in found]
