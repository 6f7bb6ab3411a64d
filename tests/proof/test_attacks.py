"""Certificates that somebody made to deceive the checker: none may be accepted."""

import json
import subprocess
import sys
from pathlib import Path
from typing import ClassVar

import pytest

from kowalevski_cas.proof import checker

from .tampering import ODD, seal

CHECKER = Path(checker.__file__)


def certificate(spaces, parts, **more):
    data = {"format": checker.FORMAT, "version": 1, "claim": "c", "statement": "", "notes": []}
    return {**data, "spaces": spaces, "parts": parts, **more}


def follows(*equations, **more):
    return {"space": 0, "shows": "follows", "equations": [list(e) for e in equations], **more}


def at(**values):
    return {"roots": [], "values": [[name, value] for name, value in values.items()]}


def rejected(spaces, parts, message, odd=(), **more):
    with pytest.raises((checker.Rejected, *odd), match=message):
        checker.check(seal(certificate(spaces, parts, **more)))


def accepted(spaces, parts):
    return checker.check(seal(certificate(spaces, parts)))[1]


class TestHypotheses:
    XY: ClassVar = [{"variables": ["x", "y"]}]

    def test_one_equals_zero(self):
        part = follows(["x", 0], given=[[1, 0]], cofactors=[["x"]], point=at(x=0, y=0))
        rejected(self.XY, [part], "not where it should be")

    def test_a_condition_that_vanishes_wherever_the_hypotheses_hold(self):
        spaces = [{"variables": ["x", "y"], "nonzero": ["x"]}]
        for x in (0, 1):
            part = follows(["y", 0], given=[["x", 0]], point=at(x=x, y=0))
            part["cofactors"] = [[["/", "y", "x"]]]
            rejected(spaces, [part], "may be zero|not where")

    def test_hypotheses_that_hold_at_no_real_point(self):
        space = {"variables": ["x", "y"], "steps": [["root", "i", ["-", 1]]]}
        part = follows(["y", 0], given=[[["+", ["*", "x", "x"], 1], 0], ["y", 0]])
        part |= {"cofactors": [[0, 1]], "point": at(x="i", y=0, i="i")}
        rejected([space], [part], "not real")
        rejected(self.XY, [{**part, "point": at(x="i", y=0)}], "not real")

    def test_a_point_without_hypotheses_and_hypotheses_without_a_point(self):
        rejected(self.XY, [follows(["x", "x"], point=at(x=0, y=0))], "odd proof")
        rejected(self.XY, [follows(["x", 0], given=[["x", 0]], cofactors=[[1]])], "point", ODD)

    def test_nothing_stated(self):
        rejected(self.XY, [follows()], "odd proof")
        rejected(self.XY, [], "key")


class TestCases:
    SPACE: ClassVar = {"variables": ["x", "y"]}
    PROOF: ClassVar = {  # x^2 + y^2 = 0 leads to x = 0, y = 0
        "product": [["x", "y"]],
        "cofactors": [[1]],
        "cases": [{"cofactors": [[0, 1, 0], [0, 0, 1]]}],
        "given": [[["+", ["^", "x", 2], ["^", "y", 2]], 0]],
        "point": at(x=0, y=0),
    }

    def test_a_sum_of_squares_vanishes_with_each(self):
        (words,) = accepted([self.SPACE], [follows(["x", 0], ["y", 0], **self.PROOF)])
        assert words == "x = 0, y = 0 wherever ((x ^ 2) + (y ^ 2)) = 0"

    def test_but_not_for_complex_names(self):
        part = follows(["x", 0], ["y", 0], **self.PROOF)
        rejected([{**self.SPACE, "conjugates": [["x", "y"]]}], [part], "odd proof")
        space = {**self.SPACE, "steps": [["root", "i", ["-", 1]]]}
        part["point"] = at(x=0, y=0, i="i")
        rejected([space], [part], "odd proof")

    def test_a_difference_of_squares_is_none(self):
        part = follows(["x", 0], ["y", 0], **self.PROOF)
        part["given"] = [[["^", "x", 2], ["^", "y", 2]]]
        rejected([self.SPACE], [part], "not equal")

    def test_a_case_left_out(self):
        product = follows(["x", 0], given=[[["*", "x", "y"], 0]], point=at(x=0, y=0))
        product |= {"product": [["x"], ["y"]], "cofactors": [[1]]}
        rejected([self.SPACE], [{**product, "cases": [{"cofactors": [[0, 1]]}]}], "zip", ODD)
        product["product"] = [["x"]]
        rejected([self.SPACE], [{**product, "cases": [{"cofactors": [[0, 1]]}]}], "not equal")

    def test_cases_without_a_product(self):
        part = follows(["x", 0], given=[["x", 0]], point=at(x=0, y=0), cofactors=[[1]])
        rejected([self.SPACE], [{**part, "cases": [{"cofactors": [[1]]}]}], "zip", ODD)
        rejected([self.SPACE], [{**part, "trust": "me"}], "odd proof")


class TestMotion:
    def test_a_variable_whose_equation_is_missing_does_not_rest(self):
        """Its derivative is used before the row in which it would be given."""
        field = [[["y"], 1, ["D", "x"]]]
        part = follows([["D", "y"], 0])
        rejected(
            [{"variables": ["x", "y"], "field": field}], [part], "no variable|not all|there is no"
        )
        field = [[["z"], 1, 1], [["y"], 1, ["D", "x"]]]
        rejected([{"variables": ["x", "y", "z"], "field": field}], [part], "not all")

    def test_a_variable_that_is_set_to_a_number_where_it_moves(self):
        """The formula x and its square are two, but say nothing of y, which is held fixed."""
        old = {
            "variables": ["x", "y"],
            "field": [[["x", "y"], ["vector", 1, 1], ["vector", "y", "x"]]],
        }
        change = {"old": 0, "formulas": [["u", "x"], ["v", ["^", "x", 2]]], "time": 1}
        steps = [["let", "x", "u"], ["let", "v", ["^", "u", 2]], ["let", "y", 5]]
        new = {"variables": ["u"], "steps": steps, "change": change}
        part = {**follows([["D", "u"], 5]), "space": 1}
        rejected([old, new], [part], "moves otherwise")

    def test_a_constant_that_becomes_a_variable(self):
        old = {"variables": ["x"], "constants": ["a"], "field": [[["x"], 1, "a"]]}
        change = {"old": 0, "formulas": [["u", "x"]], "time": 1}
        new = {
            "variables": ["u"],
            "steps": [["let", "x", "u"], ["let", "a", "u"]],
            "change": change,
        }
        part = {**follows([["D", "u"], "u"]), "space": 1}
        rejected([old, new], [part], "moves otherwise")

    def test_conjugates_that_contradict_the_change(self):
        old = {
            "variables": ["x", "y"],
            "field": [[["x", "y"], ["vector", 1, 1], ["vector", "y", "x"]]],
        }
        i = ["root", "i", ["-", 1]]
        formulas = [["u", ["+", "x", ["*", "i", "y"]]], ["v", ["+", "x", ["-", ["*", "i", "y"]]]]]
        steps = [
            i,
            ["let", "x", ["/", ["+", "u", "v"], 2]],
            ["let", "y", ["/", ["+", "u", ["-", "v"]], ["*", 2, "i"]]],
        ]
        new = {
            "variables": ["u", "v"],
            "steps": steps,
            "change": {"old": 0, "formulas": formulas, "time": 1},
        }
        part = {**follows([["conj", "u"], "u"]), "space": 1}
        rejected([{**old, "steps": [i]}, new], [part], "not real")
        accepted(
            [{**old, "steps": [i]}, {**new, "conjugates": [["u", "v"]]}],
            [{**part, "equations": [[["conj", "u"], "v"]]}],
        )

    def test_a_definition_at_zero_with_a_rate(self):
        space = {
            "variables": ["x"],
            "steps": [["let", "z", 0]],
            "field": [[["x", "z"], ["vector", 1, 1], ["vector", 1, 1]]],
        }
        rejected([space], [follows([["D", "x"], 1])], "moves otherwise")


class TestNames:
    @pytest.mark.parametrize(
        "name",
        [
            "х",
            "x y",
            "x = 0",
            "(x + y)",
            "",
            "1",
            "1/0",
            "x\n",
            "+",
            "x,y",
            "é",
            "x\u202e",
            "{",
            "-x",
        ],
    )
    def test_odd_names(self, name):
        rejected([{"variables": [name]}], [follows([name, name])], "odd|list index|twice")

    def test_a_name_given_twice(self):
        for space in (
            {"variables": ["x", "x"]},
            {"variables": ["x"], "constants": ["x"]},
            {"variables": ["x"], "steps": [["let", "x", 0]]},
            {"variables": ["x"], "steps": [["root", "x", 0]]},
            {"variables": ["x"], "steps": [["let", "f", 0], ["let", "f", "x"]]},
        ):
            rejected([space], [follows(["x", "x"])], "twice")

    @pytest.mark.parametrize(
        "claim", ["a\nCERTIFIED 9 of 9", "../c", "c d", "", "ç", 5, None, ["c"]]
    )
    def test_odd_claims(self, claim):
        odd = () if isinstance(claim, str) else ODD
        rejected([{"variables": ["x"]}], [follows(["x", "x"])], "odd|expected", odd, claim=claim)

    def test_notes_cannot_pretend(self):
        data = certificate(
            [{"variables": ["x"]}], [follows(["x", "x"])], notes=["a\nCERTIFIED 9 of 9"]
        )
        (_, note) = checker.check(seal(data))[1]
        assert note == "argued in words, not checked: 'a\\nCERTIFIED 9 of 9'"


class TestNumbers:
    X: ClassVar = [{"variables": ["x"]}]

    @pytest.mark.parametrize("number", [1.0, True, None, "1", "NaN", {}, [], [1], float("inf")])
    def test_what_is_no_number(self, number):
        rejected(self.X, [follows([["+", "x", number], ["+", "x", number]])], ".")

    @pytest.mark.parametrize("version", [True, 1.0, "1", None, [1]])
    def test_what_is_no_version(self, version):
        rejected(self.X, [follows(["x", "x"])], "format", version=version)

    def test_towers_of_powers(self):
        for base in (10**40, ["/", 1, 3], ["+", "x", 10**40]):
            tree = base
            for _ in range(12):
                tree = ["^", tree, 64]
            rejected(self.X, [follows([tree, tree])], "too large|too much")

    def test_sums_that_never_end(self):
        names = [f"x_{k}" for k in range(90)]
        steps = [["let", "t_0", ["+", *names]]]
        for k in range(20):
            steps.append(["let", f"t_{k + 1}", ["*", f"t_{k}", f"t_{k}"]])
        rejected([{"variables": names, "steps": steps}], [follows([0, 0])], "too much|too large")
        steps = [["let", "t_0", ["^", ["+", *names], 2]]]
        steps += [["let", f"s_{k}", ["+", *["t_0"] * 5000]] for k in range(5)]
        rejected([{"variables": names, "steps": steps}], [follows([0, 0])], "too much|too large")

    def test_a_thousand_names(self):
        rejected([{"variables": [f"x_{k}" for k in range(1000)]}], [follows([0, 0])], "too many")

    @pytest.mark.parametrize(
        "divisor", [0, ["+", "x", ["-", "x"]], ["*", 0, "x"], 1, 5, ["^", "x", 0]]
    )
    def test_numbers_that_are_assumed_not_to_vanish(self, divisor):
        rejected([{"variables": ["x"], "nonzero": [divisor]}], [follows(["x", "x"])], "number")


class TestFiles:
    def run(self, *arguments, flags=("-I", "-S")):
        command = [sys.executable, *flags, str(CHECKER), *map(str, arguments)]
        result = subprocess.run(command, capture_output=True)
        assert b"Traceback" not in result.stderr
        return result.returncode, result.stdout.decode()

    @pytest.mark.parametrize(
        "flags", [("-I", "-S"), ("-I", "-S", "-O"), ("-I", "-X", "utf8=0"), ()]
    )
    def test_noise(self, flags, tmp_path):
        good = seal(certificate([{"variables": ["x"]}], [follows(["x", "x"])]))
        texts = {
            "empty": b"", "noise": bytes(range(256)) * 20, "truncated": good[:-4].encode(),
            "doubled": (good * 2).encode(), "bom": b"\xef\xbb\xbf" + good.encode(), "wide": good.encode("utf-16"),
            "deep": b"[" * 200_000, "deep_dicts": b'{"a":' * 100_000, "long": b" " * 2_000_000 + good.encode(),
            "number": b"9" * 500_000, "exponent": b"1e999999999", "null": b"null", "zeros": b"\0" * 5000,
            "surrogate": good.replace('"x"', '"\\ud800"').encode(),
            "twice": good.replace('"claim"', '"claim": "c", "claim"').encode(),
            "list": f"[{good}]".encode(),
        }  # fmt: skip
        paths = []
        for name, content in texts.items():
            paths.append(tmp_path / f"{name}.json")
            paths[-1].write_bytes(content)
        (tmp_path / "folder.json").mkdir()
        paths += [tmp_path / "folder.json", tmp_path / "missing.json", tmp_path / "od\udcffd.json"]
        code, out = self.run(*paths, flags=flags)
        assert code == 5
        *lines, last = out.splitlines()
        assert len(lines) == len(paths) and all(line.startswith("REJECTED ") for line in lines)
        assert last == f"CERTIFIED 0 of {len(paths)}"
        (tmp_path / "c.json").write_text(good)
        assert self.run(tmp_path / "c.json", flags=flags)[0] == 0

    def test_nothing(self):
        assert self.run() == (6, "CERTIFIED 0 of 0\n")

    def test_the_whole_program_says_the_same(self, tmp_path, capsys):
        from kowalevski_cas.cli import main

        path = tmp_path / "c.json"
        path.write_text('{"claim": "\\ud800"}')
        assert main(["check", str(path)]) == 5
        path.write_text(json.dumps(certificate([], [], claim="c")))
        assert main(["check", str(path)]) == 5
