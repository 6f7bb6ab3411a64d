import ast
import json
import random
import subprocess
import sys
from functools import cache
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from kowalevski_cas.library import available, find
from kowalevski_cas.proof import checker
from kowalevski_cas.proof.committed import certificate_files, check_committed, check_files

from .oracle import is_true
from .tampering import ODD, at, changed, names_in, others, places, seal

CHECKER = Path(checker.__file__)
FILES = certificate_files(find("kharlamov2002"))
TAMPERED = 60
TEXTS = {path.stem: path.read_text(encoding="utf-8") for path in FILES}


def run(*files, flags=("-I", "-S")):
    command = [sys.executable, *flags, str(CHECKER), *map(str, files)]
    return subprocess.run(command, capture_output=True, text=True)


def certificate(claim):
    return json.loads(TEXTS[claim])


def rejected(data, message=None, odd=()):
    with pytest.raises((checker.Rejected, *odd), match=message):
        checker.check(seal(data))


def accepted(data):
    try:
        checker.check(seal(data))
    except (checker.Rejected, *ODD):
        return False
    return True


class TestProgram:
    def test_it_is_short_and_needs_the_standard_library_only(self):
        source = CHECKER.read_text(encoding="utf-8")
        assert len(source.splitlines()) < 400
        tree = ast.parse(source)
        assert not [node for node in ast.walk(tree) if isinstance(node, ast.Assert)]
        modules = {node.module for node in ast.walk(tree) if isinstance(node, ast.ImportFrom)}
        modules |= {a.name for n in ast.walk(tree) if isinstance(n, ast.Import) for a in n.names}
        assert modules <= sys.stdlib_module_names

    @pytest.mark.parametrize("flags", [("-I", "-S"), ("-I", "-S", "-O")])
    def test_all_committed_certificates_are_accepted(self, flags):
        result = run(*FILES, flags=flags)
        assert result.returncode == 0, result.stdout
        assert result.stdout.splitlines()[-1] == f"CERTIFIED {len(FILES)} of {len(FILES)}"
        assert len(FILES) > 60

    def test_nothing_given(self):
        assert run().returncode == 6

    def test_one_rejected_of_two(self, tmp_path):
        broken = tmp_path / "eq6.json"
        broken.write_text(TEXTS["eq6"][:-30])
        result = run(FILES[0], broken)
        assert result.returncode == 5
        assert "REJECTED" in result.stdout
        assert result.stdout.endswith("CERTIFIED 1 of 2\n")

    def test_a_missing_file(self):
        assert run("nowhere.json").returncode == 5

    def test_the_same_certificate_twice(self):
        result = run(FILES[0], FILES[0])
        assert result.returncode == 5
        assert "certified before" in result.stdout

    def test_claims_of_the_same_name_in_two_derivations(self):
        result = run(*(find(name) / "certificates" / "eq10.1.json" for name in available()))
        assert result.returncode == 0
        assert result.stdout.endswith("CERTIFIED 2 of 2\n")

    def test_under_the_name_of_another_claim(self, tmp_path):
        other = tmp_path / "eq4.1.json"
        other.write_text(TEXTS["eq4.2"])
        result = run(other)
        assert result.returncode == 5
        assert "about the claim eq4.2" in result.stdout

    def test_words(self):
        _, said = checker.check(TEXTS["theta-prime"])
        assert said == [r"D(\theta) = Q_2", "(i ^ 2) = (-1)"]
        _, said = checker.check(TEXTS["eq15"])
        assert said[0].startswith("D(F_1) = 0, D(F_2) = 0 wherever F_1 = 0, F_2 = 0, for ")
        _, said = checker.check(TEXTS["eq14"])
        assert said[0].startswith("it is false that D((U_1 + (-U_2))) = ")


class TestText:
    def test_every_truncation(self):
        text = TEXTS["eq6"]
        for end in range(0, len(text) - 2, 7):
            with pytest.raises((checker.Rejected, *ODD)):
                checker.check(text[:end])

    def test_a_change_without_a_new_digest(self):
        for claim, text in TEXTS.items():
            data = json.loads(text)
            for place in random.Random(claim).sample(list(places(data)), 3):
                for value in others(data, place, ["x_1", "i"]):
                    with pytest.raises((checker.Rejected, *ODD)):
                        checker.check(json.dumps(changed(data, place, value)))

    def test_a_key_twice(self):
        text = TEXTS["eq6"].replace('"claim"', '"claim": "eq6", "claim"', 1)
        with pytest.raises((checker.Rejected, *ODD)):
            checker.check(text)

    @pytest.mark.parametrize(
        "key", ["format", "version", "claim", "statement", "spaces", "parts", "notes"]
    )
    def test_a_key_missing(self, key):
        data = certificate("eq6")
        del data[key]
        rejected(data)

    @pytest.mark.parametrize("path", [(), ("spaces", 0), ("parts", 0)])
    def test_a_key_too_many(self, path):
        data = certificate("eq6")
        at(data, path)["verdict"] = "proved"
        rejected(data)

    @pytest.mark.parametrize("text", ["", "null", "[]", "{}", "[" * 100_000, '{"a": NaN}', "\0"])
    def test_what_is_no_certificate(self, text):
        with pytest.raises((checker.Rejected, *ODD)):
            checker.check(text)

    def test_no_parts(self):
        rejected({**certificate("eq6"), "parts": []})

    def test_another_version(self):
        rejected({**certificate("eq6"), "version": 2}, "format")


class TestRecord:
    DATA = certificate("eq6")

    def checked(self, folder, **entry):
        (folder / "certificates").mkdir()
        (folder / "certificates" / "eq6.json").write_text(TEXTS["eq6"], encoding="utf-8")
        entry = {"statement": self.DATA["statement"], "certificate": self.DATA["digest"], **entry}
        return check_committed(folder, {"eq6": entry, "eq7": {"statement": "0"}})

    def test_as_recorded(self, tmp_path):
        found = self.checked(tmp_path)
        assert found.digests == {"eq6": self.DATA["digest"]} and not found.rejected
        assert found.without == ("eq7",)

    def test_another_statement(self, tmp_path):
        (why,) = self.checked(tmp_path, statement="0123456789abcdef").rejected.values()
        assert "another statement" in why and "make certificates" in why

    def test_another_certificate(self, tmp_path):
        (why,) = self.checked(tmp_path, certificate="0" * 64).rejected.values()
        assert "another certificate" in why

    def test_one_that_says_something_else_under_the_same_statement(self, tmp_path):
        (tmp_path / "certificates").mkdir()
        data = {**self.DATA, "parts": [{"space": 0, "shows": "follows", "equations": [[1, 1]]}]}
        (tmp_path / "certificates" / "eq6.json").write_text(seal(data))
        entry = {"statement": data["statement"], "certificate": data["digest"]}
        assert check_files(certificate_files(tmp_path)).digests
        assert not check_committed(tmp_path, {"eq6": entry}).digests

    def test_one_that_is_missing(self, tmp_path):
        entry = {"statement": self.DATA["statement"], "certificate": self.DATA["digest"]}
        found = check_committed(tmp_path, {"eq6": entry})
        assert found.rejected == {"eq6.json": "it is in the record, and missing"}

    def test_one_of_a_claim_that_is_not_made(self, tmp_path):
        self.checked(tmp_path)
        (why,) = check_committed(tmp_path, {}).rejected.values()
        assert "no such claim" in why


class TestStatements:
    def test_a_false_claim_with_honest_cofactors(self):
        data = certificate("eq15")
        data["parts"][0]["equations"][0] = [["D", "F_1"], 1]
        rejected(data, "not equal")

    def test_a_condition_removed(self):
        for claim in ("eq12", "eq15", "ratio", "eq22", "eq16.invariance"):
            data = certificate(claim)
            for k in range(len(data["spaces"])):
                for j in range(len(data["spaces"][k].get("nonzero", []))):
                    rejected(changed(data, ("spaces", k, "nonzero", j), None))

    def test_zero_as_a_denominator(self):
        data = certificate("eq15")
        for zero in (0, ["+", "x_1", ["-", "x_1"]], 1, ["/", 1, "x_1"]):
            other = json.loads(json.dumps(data))
            other["spaces"][1]["nonzero"].insert(0, zero)
            rejected(other)
        row = data["parts"][0]["cofactors"][0]
        row[0] = ["/", 1, ["+", "x_1", ["-", "x_1"]]]
        rejected(data, "may be zero")

    def test_given_equations_that_contradict_each_other(self):
        data = certificate("eq15")
        part = data["parts"][0]
        part["given"] = [[0, 1]]
        part["equations"] = [["x_1", 0]]
        part["cofactors"] = [[["*", -1, "x_1"]]]
        rejected(data, "not where it should be")

    def test_denominators_that_vanish_on_the_set(self):
        data = certificate("eq15")
        data["parts"][0]["given"] = [["x_1", 0], ["x_2", 0]]
        rejected(data)

    def test_given_without_a_point(self):
        data = certificate("eq15")
        del data["parts"][0]["point"]
        rejected(data, "point", ODD)

    def test_a_field_with_a_gap(self):
        data = certificate("eq4.1")
        data["spaces"][0]["field"].pop()
        rejected(data)

    def test_an_equation_of_motion_twice(self):
        data = certificate("eq4.1")
        data["spaces"][0]["field"] *= 2
        rejected(data, "twice")

    def test_a_root_that_leaves_its_relation(self):
        data = certificate("eq12")
        steps = data["spaces"][1]["steps"]
        root = next(step for step in steps if step[:2] == ["root", "z_1"])
        root[2] = ["+", root[2], "w_1"]
        data["parts"] = data["parts"][:1]
        rejected(data, "z_1 does not keep its square")

    def test_the_sign_of_a_root_on_which_others_rest(self):
        space = {"variables": ["x"], "steps": [["root", "r", "x"], ["root", "s", "r"]]}
        part = {"space": 0, "shows": "follows", "equations": [["s", "s"]], "given": [["x", 1]]}
        values = [["x", 1], ["r", 1], ["s", 1]]
        part |= {"cofactors": [[0]], "root": "r", "point": {"roots": [], "values": values}}
        data = {**certificate("eq6"), "spaces": [space], "parts": [part]}
        rejected(data, "the sign of 'r'")

    def test_a_rank_with_dependent_functions(self):
        data = certificate("M4-independence")
        part = data["parts"][0]
        part["functions"] = [part["functions"][0]] * 2
        rejected(data)

    def test_a_point_off_the_set(self):
        data = certificate("M4-dimension")
        data["parts"][0]["point"]["values"][0][1] = 7
        rejected(data, "not where it should be")

    def test_a_point_that_is_not_real(self):
        data = certificate("eq14")
        part = next(p for p in data["parts"] if p["shows"] == "differ")
        data["spaces"][part["space"]]["conjugates"] = [
            ["x_1", "x_2"], ["y_1", "y_2"], ["z_1", "z_2"], ["w_1", "w_2"], ["c_1", "c_2"],
        ]  # fmt: skip
        assert accepted(data)
        value = next(v for v in part["point"]["values"] if v[0] == "w_1")
        value[1] = ["+", value[1], 1]
        rejected(data, "not real")

    def test_two_sides_that_do_not_differ(self):
        data = certificate("eq14")
        part = next(p for p in data["parts"] if p["shows"] == "differ")
        part["equation"][1] = part["equation"][0]
        rejected(data, odd=ODD)

    def test_a_false_inverse(self):
        data = certificate("eq12")
        place = next(
            ("spaces", 1, "steps", k)
            for k, step in enumerate(data["spaces"][1]["steps"])
            if step[1] == "\\alpha_1"
        )
        step = at(data, place)
        rejected(changed(data, (*place, 2), ["+", step[2], 1]), "back")

    @pytest.mark.parametrize("exponent", [-1, 65, 10**9, True, "x", 1.5])
    def test_exponents(self, exponent):
        data = certificate("eq6")
        data["parts"][0]["equations"] = [[["^", "\\omega_1", exponent], 0]]
        rejected(data)

    def test_work_is_bounded(self):
        data = certificate("eq6")
        tree = ["+", *data["spaces"][0]["variables"]]
        for _ in range(4):
            tree = ["^", tree, 8]
        data["parts"][0]["equations"] = [[tree, tree]]
        rejected(data, "too")


# -- tampering ---------------------------------------------------------------------


@cache
def all_places(claim):
    data = certificate(claim)
    return [path for path in places(data) if path[0] in ("spaces", "parts") and len(path) > 1]


def judge(claim, choose):
    """Tamper at a place; what the checker accepts has to be true. Whether it was accepted."""
    data, path = certificate(claim), choose(all_places(claim))
    names = sorted(names_in([data["spaces"], data["parts"]]))
    value = choose(others(data, path, [choose(names), choose(names)]))
    other = changed(data, path, value)
    if not accepted(other):
        return False
    true, why = is_true(other)
    assert true, f"{claim}: {path} = {str(value)[:60]} got through: {why}"
    return True


def test_the_oracle_finds_all_certificates_true():
    for claim in TEXTS:
        assert is_true(certificate(claim)) == (True, ""), claim


def test_the_oracle_is_no_yes_sayer():
    data = certificate("eq15")
    data["parts"][0]["equations"][0][1] = 1
    assert not is_true(data)[0]
    data = certificate("eq6")
    data["spaces"][0]["field"][0][2] = ["-", data["spaces"][0]["field"][0][2]]
    assert not is_true(data)[0]


@settings(
    max_examples=500, deadline=None, derandomize=True, suppress_health_check=list(HealthCheck)
)
@given(st.data())
def test_tampering(data):
    claim = data.draw(st.sampled_from(sorted(TEXTS)))
    judge(claim, lambda items: data.draw(st.sampled_from(items)))


@pytest.mark.slow
def test_tampering_at_thousands_of_places(capsys):
    generator = random.Random(2002)
    claims = [claim for claim in sorted(TEXTS) for _ in range(TAMPERED)]
    through = sum(judge(claim, generator.choice) for claim in claims)
    with capsys.disabled():
        print(f"\n{len(claims)} tampered, {through} accepted and true, 0 accepted and false")
    assert through < len(claims) / 4
