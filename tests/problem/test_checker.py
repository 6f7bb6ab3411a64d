import ast
import json
import random
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from kowalevski_cas.problem import checker

from .tampering import at, changed, others, places, seal

CHECKER = Path(checker.__file__).parent
FILES = sorted((Path(__file__).parent / "handwritten").glob("*.json"))
TEXTS = {path.stem: path.read_text(encoding="utf-8") for path in FILES}


def run(*files, flags=("-I", "-S")):
    command = [sys.executable, *flags, str(CHECKER), *map(str, files)]
    return subprocess.run(command, capture_output=True, text=True, timeout=60)


def certificate(claim):
    return json.loads(TEXTS[claim])


def rejected(data, message=None):
    with pytest.raises(checker.Rejected, match=message):
        checker.check(seal(data))


class TestProgram:
    def test_it_needs_the_standard_library_only(self):
        trees = [ast.parse(path.read_text(encoding="utf-8")) for path in CHECKER.glob("*.py")]
        nodes = [node for tree in trees for node in ast.walk(tree)]
        assert len(trees) > 5 and not [node for node in nodes if isinstance(node, ast.Assert)]
        found = [node for node in nodes if isinstance(node, ast.ImportFrom)]
        assert {node.level for node in found} == {0, 1}
        modules = {node.module for node in found if not node.level}
        modules |= {a.name for n in nodes if isinstance(n, ast.Import) for a in n.names}
        assert {module.split(".")[0] for module in modules} <= sys.stdlib_module_names

    def test_it_runs_wherever_it_is_taken(self, tmp_path):
        away = shutil.copytree(CHECKER, tmp_path / "elsewhere" / "another_name")
        for name in (
            "fractions.py",
            "re.py",
            "json.py",
        ):  # none of these may be taken for the library's
            for folder in (tmp_path, away.parent):
                (folder / name).write_text("raise SystemExit('shadowed')")
        command = [sys.executable, "-I", "-S", str(away), *map(str, FILES)]
        found = subprocess.run(command, capture_output=True, text=True, cwd=tmp_path, timeout=60)
        assert found.returncode == 0, found.stderr
        assert found.stdout == run(*FILES).stdout

    @pytest.mark.parametrize("flags", [("-I", "-S"), ("-I", "-S", "-O")])
    def test_all_are_accepted(self, flags):
        result = run(*FILES, flags=flags)
        assert result.returncode == 0, result.stdout
        assert result.stdout.splitlines()[-1] == f"CERTIFIED {len(FILES)} of {len(FILES)}"

    def test_a_line_a_file(self):
        assert len(run(*FILES).stdout.splitlines()) == len(FILES) + 1

    def test_all_of_a_theorem(self):
        result = run(
            "--full",
            *(f for f in FILES if f.stem in ("exponents", "change", "rank", "denied-exists")),
        )
        assert result.returncode == 0
        for line in ("variables: x", "constants: m", "power: P = x ^ m, where x > 0",
                     "root: r ^ 2 = x ^ 2 + y ^ 2", "for y ^ 2 + x ^ 2 != 0",
                     "point: x = 1, y = 2, z = 0, r = sqrt(5)", "conjugates: u, v",
                     "field: vector(1, 1) D(x, y) = vector(y, -x)", "factor of the time: 2",
                     "before the change, field: vector(1, 1) D(x, y) = vector(y, -x)"):  # fmt: skip
            assert f" {line}\n" in result.stdout, line

    def test_nothing_given(self):
        assert run().returncode == 6
        assert run("--full").returncode == 6

    def test_one_rejected_of_two(self, tmp_path):
        broken = tmp_path / "count.json"
        broken.write_text(TEXTS["count"][:-30])
        result = run(FILES[0], broken)
        assert result.returncode == 5
        assert "REJECTED" in result.stdout
        assert result.stdout.endswith("CERTIFIED 1 of 2\n")

    def test_a_missing_file(self):
        assert run("nowhere.json").returncode == 5

    def test_the_same_claim_twice(self):
        result = run(FILES[0], FILES[0])
        assert result.returncode == 5
        assert "certified before" in result.stdout

    def test_the_same_problem_in_two_claims(self, tmp_path):
        other = tmp_path / "again.json"
        other.write_text(json.dumps({**certificate("count"), "claim": "again"}))
        result = run(other, CHECKER.parents[2] / "tests/problem/handwritten/count.json")
        assert result.returncode == 0

    def test_claims_of_the_same_name_in_two_derivations(self, tmp_path):
        other = tmp_path / "count.json"
        other.write_text(json.dumps({**certificate("empty"), "claim": "count"}))
        result = run(other, CHECKER.parents[2] / "tests/problem/handwritten/count.json")
        assert result.stdout.endswith("CERTIFIED 2 of 2\n")

    def test_under_the_name_of_another_claim(self, tmp_path):
        other = tmp_path / "empty.json"
        other.write_text(TEXTS["count"])
        result = run(other)
        assert result.returncode == 5
        assert "about count" in result.stdout

    def test_words(self):
        said = {claim: checker.check(text).summary() for claim, text in TEXTS.items()}
        assert said["empty"] == "empty: there is no real point where x ^ 2 + y ^ 2 = 1, x = 2"
        assert said["alternatives"] == "alternatives: r = x or r = -x wherever y = 0"
        assert said["denied-fails"] == "denied-fails: x ^ 2 = y ^ 2 wherever x = y"
        assert said["denied-identity"] == "denied-identity: it is false that D(x * y) = 0, x = x"
        assert said["exponents"].endswith("m = 1 / 2 wherever D(P) = P / 2, for x, P != 0")


class TestText:
    def test_every_truncation(self):
        text = TEXTS["count"]
        for end in range(0, len(text) - 2, 7):
            with pytest.raises(checker.Rejected):
                checker.check(text[:end])

    def test_a_change_of_the_problem_without_a_new_digest(self):
        for claim, text in TEXTS.items():
            data = json.loads(text)
            inside = [p for p in places(data) if p[0] in ("spaces", "goals", "digest")]
            for place in random.Random(claim).sample(inside, 4):
                for value in others(data, place, ["x", "i"]):
                    with pytest.raises(checker.Rejected):
                        checker.check(json.dumps(changed(data, place, value)))

    def test_the_evidence_is_no_part_of_the_digest(self):
        data = certificate("rank")
        data["evidence"][0]["point"] = {
            "roots": [],
            "values": [["x", 3], ["y", 4], ["z", 0], ["r", 5]],
        }
        assert checker.check(json.dumps(data)).digest == checker.check(TEXTS["rank"]).digest

    def test_a_key_twice(self):
        for key in ("claim", "variables", "goal", "point", "values"):
            text = TEXTS["rank"].replace(f'"{key}"', f'"{key}": 0, "{key}"', 1)
            with pytest.raises(checker.Rejected, match="twice"):
                checker.check(text)

    @pytest.mark.parametrize(
        "key", ["format", "version", "claim", "spaces", "goals", "sign", "evidence"]
    )
    def test_a_key_missing(self, key):
        data = certificate("rank")
        del data[key]
        rejected(data)

    def test_a_digest_missing(self):
        data = certificate("rank")
        del data["digest"]
        with pytest.raises(checker.Rejected):
            checker.check(json.dumps(data))

    @pytest.mark.parametrize("claim", TEXTS)
    def test_a_key_too_many(self, claim):
        data = certificate(claim)
        for path in [(), *(p for p in places(data) if isinstance(at(data, p), dict))]:
            other = json.loads(TEXTS[claim])
            at(other, path)["verdict"] = "proved"
            rejected(other, "unknown|expected")

    @pytest.mark.parametrize("text", ["", "null", "[]", "{}", "[" * 100_000, '{"a": NaN}', "\0"])
    def test_what_is_no_certificate(self, text):
        with pytest.raises(checker.Rejected):
            checker.check(text)

    def test_another_version(self):
        rejected({**certificate("rank"), "version": 1}, "format 1")
        rejected({**certificate("rank"), "version": 3}, "another format")

    def test_another_sign(self):
        for claim, text in TEXTS.items():
            data = json.loads(text)
            rejected({**data, "sign": {"holds": "denied", "denied": "holds"}[data["sign"]]})
            rejected({**data, "sign": claim}, "neither")

    def test_too_much_and_too_little_evidence(self):
        for text in TEXTS.values():
            data = json.loads(text)
            rejected({**data, "evidence": data["evidence"][:-1]})
            rejected({**data, "evidence": data["evidence"] + data["evidence"][-1:]})


@pytest.mark.parametrize("exponent", [-1, 65, 10**9, True, "x", 1.5])
def test_exponents(exponent):
    data = certificate("positive")
    data["goals"][0]["given"][0][0] = ["^", "x", exponent]
    rejected(data, "odd|integer")


def test_work_is_bounded():
    data = certificate("positive")
    tree = ["+", "x", "y", 1]
    for _ in range(4):
        tree = ["^", tree, 8]
    data["goals"][0]["given"][0][0] = tree
    rejected(data, "too")


DIVISORS = [
    (["m", "r"], True),
    (["r"], True),  # m is a factor of what the statement divides by
    ([], False),
]


@pytest.mark.parametrize("away, accepted", DIVISORS)
def test_products_of_factors_of_a_known_divisor_divide(away, accepted):
    """The statement divides by r²m², and a cofactor by r³m: no multiple, nor a divisor of that."""
    cofactor = ["*", ["/", "r", ["*", ["^", "r", 3], "m"]], ["/", 1, "m"]]
    values = [["r", 1], ["m", 1], ["z", 0]]
    square = ["*", ["^", "r", 2], ["^", "m", 2]]
    data = seal(
        {
            "format": "kowalevski-cas certificate",
            "version": 2,
            "claim": "quotient",
            "spaces": [{"variables": ["r", "m", "z"]}],
            "goals": [
                {
                    "goal": "follows", "space": 0, "given": [["z", 0]],
                    "conclusions": [[[["/", "z", square], 0]]],
                }
            ],
            "sign": "holds",
            "evidence": [
                {"point": {"roots": [], "values": values}, "cofactors": [[cofactor]], "away": away}
            ],
        }
    )  # fmt: skip
    if accepted:
        assert checker.check(data).theorems
    else:
        with pytest.raises(checker.Rejected):
            checker.check(data)
