"""Certificates that somebody made to deceive the checker: none may be accepted.

Those in ``test_accept.py`` are put to it as well; here are such as only a file can be.
"""

import json
import re
import subprocess
import sys
from copy import deepcopy
from pathlib import Path
from typing import ClassVar

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kowalevski_cas.problem import checker
from kowalevski_cas.problem.checker.command import main
from kowalevski_cas.problem.examine import Unproved

from .judges import judged
from .tampering import at as place
from .tampering import places, seal

CHECKER = Path(checker.__file__).parent


def certificate(spaces, goals, evidence, sign="holds", **more):
    data = {"format": checker.FORMAT, "version": 2, "claim": "c", "sign": sign}
    return {**data, "spaces": spaces, "goals": goals, "evidence": evidence, **more}


def follows(*equations, given=(), space=0):
    return {"goal": "follows", "space": space, "given": [list(e) for e in given], "conclusions": [[list(e) for e in equations]]}  # fmt: skip


def at(*roots, **values):
    return {"roots": [*roots], "values": [[name, value] for name, value in values.items()]}


def rejected(spaces, goals, evidence, message, sign="holds", **more):
    with pytest.raises(checker.Rejected, match=message):
        checker.check(seal(certificate(spaces, goals, evidence, sign, **more)))


def accepted(spaces, goals, evidence, sign="holds"):
    return checker.check(seal(certificate(spaces, goals, evidence, sign))).theorems


XY = {"variables": ["x", "y"]}
ORIGIN = at(x=0, y=0)
I = ["root", "i", ["-", 1]]  # noqa: E741


class TestHypotheses:
    @pytest.mark.parametrize("x", [0, 1])
    def test_a_condition_that_vanishes_wherever_the_hypotheses_hold(self, x):
        goal, entry = follows(["y", 0], given=[["x", 0]]), {"cofactors": [[["/", "y", "x"]]]}
        entry["point"] = at(x=x, y=0)
        rejected([{**XY, "nonzero": ["x"]}], [goal], [entry], "not where|condition fails")
        rejected([XY], [goal], [{**entry, "away": ["x"]}], "not where|condition fails")
        rejected([XY], [goal], [entry], "may be zero|not where")

    def test_a_setting_without_a_real_point(self):
        for square in (["-", ["+", ["^", "x", 2], 1]], ["+", ["-", ["^", "x", 2]], -1]):
            space = {**XY, "steps": [["root", "r", square]]}
            rejected([space], [follows(["x", "x"])], [{"point": at(x=0, y=0, r="i")}], "not real")

    def test_what_is_assumed_before_a_change(self):
        """With u = x + y, v = x - y and x not zero there is nothing where u = -v."""
        half = [["*", ["/", 1, 2], ["+", "u", "v"]], ["*", ["/", 1, 2], ["+", "u", ["-", "v"]]]]
        steps = [["let", name, tree] for name, tree in zip("xy", half, strict=True)]
        formulas = [["u", ["+", "x", "y"]], ["v", ["+", "x", ["-", "y"]]]]
        change = {"old": 0, "formulas": formulas, "time": 1}
        old = {**XY, "nonzero": ["x"], "field": [[["x"], 1, 0], [["y"], 1, 0]]}
        new = {"variables": ["u", "v"], "steps": steps, "change": change}
        goal = follows([["D", "u"], 0], given=[["u", ["-", "v"]]], space=1)
        entry = {"cofactors": [[0]], "point": at(u=1, v=-1)}
        rejected([old, new], [goal], [entry], "before the change")
        accepted([XY | {"field": old["field"]}, new], [goal], [entry])
        with pytest.raises(Unproved, match="granted"):
            judged(certificate([old, new], [goal], [entry]))

    def test_emptiness_with_a_condition(self):
        goal = {"goal": "follows", "space": 0, "given": [["x", 0]], "conclusions": []}
        entry = {"cofactors": [[["/", 1, "x"]]], "point": at(x=1, y=0)}
        rejected([XY], [goal], [{**entry, "away": ["x"]}], "unknown")
        rejected([XY], [goal], [entry], "may be zero")

    def test_emptiness_of_nothing(self):
        goal = {"goal": "follows", "space": 0, "given": [], "conclusions": []}
        rejected([XY], [goal], [{"point": ORIGIN}], "nothing")
        rejected([XY], [{**goal, "goal": "fails"}], [{"point": ORIGIN}], "nothing")

    def test_nothing_stated(self):
        rejected([XY], [{**follows(), "conclusions": [[]]}], [{"point": ORIGIN}], "nothing")
        rejected(
            [XY], [{**follows(), "conclusions": [[], [["x", 0]]]}], [{"point": ORIGIN}], "nothing"
        )
        rejected([XY], [], [], "no goal")
        rank = {"goal": "rank", "space": 0, "functions": [], "given": [], "rank": 0}
        rejected([XY], [rank], [{"point": ORIGIN}], "nothing")

    @pytest.mark.parametrize("y", ["x", ["sqrt", 2], ["/", 1, 0], "i", ["-", 1, 1], None, True])
    def test_forged_points(self, y):
        goal = follows(["y", 1], given=[["y", 1]])
        rejected([XY], [goal], [{"cofactors": [[1]], "point": at(x=0, y=y)}], ".")

    @pytest.mark.parametrize("roots", [[-2], [1], [0], [True], ["x"], [2, 2.0], 2, [[2]]])
    def test_roots_of_points(self, roots):
        point = {"roots": roots, "values": [["x", 0], ["y", 1]]}
        rejected([XY], [follows(["x", "x"])], [{"point": point}], ".")

    def test_values_missing_unknown_or_given_twice(self):
        for values in ([["x", 0]], [["x", 0], ["y", 0], ["z", 0]], [["x", 0], ["y", 0], ["y", 0]]):
            point = {"roots": [], "values": values}
            rejected([XY], [follows(["x", "x"])], [{"point": point}], "value of the point")


class TestDivisors:
    def test_a_printed_denominator_is_a_condition(self):
        (found,) = accepted([XY], [follows([["/", "x", "x"], 1])], [{"point": at(x=1, y=0)}])
        assert found.where == ["x"]
        rejected([XY], [follows([["/", "x", "x"], 1])], [{"point": ORIGIN}], "condition fails")

    def test_it_is_one_of_its_goal_only(self):
        goals = [follows([["/", "x", "x"], 1]), follows(["y", ["*", "y", 1]], given=[["y", 0]])]
        entries = [{"point": at(x=1, y=0)}, {"cofactors": [[0]], "point": ORIGIN}]
        assert not accepted([XY], goals, entries)[1].where
        entries[1]["cofactors"] = [[["/", "x", "x"]]]
        rejected([XY], goals, entries, "may be zero")

    @pytest.mark.parametrize("zero", [0, ["+", "x", ["-", "x"]], ["*", 0, "x"]])
    def test_what_vanishes_identically(self, zero):
        rejected([XY], [follows([["/", "x", zero], 1])], [{"point": at(x=1, y=0)}], "by zero")

    @pytest.mark.parametrize(
        "divisor", [0, ["+", "x", ["-", "x"]], ["*", 0, "x"], 1, 5, ["^", "x", 0], ["/", "x", "x"]]
    )
    def test_numbers_that_are_assumed_not_to_vanish(self, divisor):
        goal, entry = follows(["x", "x"]), {"point": at(x=1, y=1)}
        why = "number|by zero|may be zero"
        rejected([{**XY, "nonzero": [divisor]}], [goal], [entry], why)
        rejected([XY], [goal], [{**entry, "away": [divisor]}], why)

    def test_what_is_granted_may_be_divided_by_what_is_then_a_condition(self):
        goal, entry = follows(["x", "x"]), {"point": at(x=1, y=1)}
        space = {**XY, "nonzero": [["/", ["+", "x", "y"], "x"]]}
        assert accepted([space], [goal], [entry])[0].where == ["x", "(x + y) / x"]
        rejected([space], [goal], [{"point": ORIGIN}], "condition fails")
        rejected([space], [goal], [{"point": at(x=1, y=-1)}], "condition fails")

    @pytest.mark.parametrize("product", [["*", "x"], ["*"], ["^", "x", -1], ["^", "x", True],
        ["^", "x", 10**9], ["^", "x", "y"], ["^", "x"], ["*", "x", ["^", "y", 0]], ["*", "x", None]])  # fmt: skip
    def test_odd_products_of_conditions(self, product):
        goal, entry = follows(["x", "x"]), {"point": at(x=1, y=1)}
        rejected([{**XY, "nonzero": [product]}], [goal], [entry], ".")
        rejected([XY], [goal], [{**entry, "away": [product]}], ".")


class TestCases:
    GOAL = follows(["x", 0], ["y", 0], given=[[["+", ["^", "x", 2], ["^", "y", 2]], 0]])
    PROOF: ClassVar = {  # x^2 + y^2 = 0 leads to x = 0, y = 0
        "product": [["x", "y"]],
        "cofactors": [[1]],
        "cases": [{"cofactors": [[0, 1, 0], [0, 0, 1]]}],
        "point": ORIGIN,
    }

    def test_a_sum_of_squares_vanishes_with_each(self):
        (found,) = accepted([XY], [self.GOAL], [self.PROOF])
        assert found.words == "x = 0, y = 0 wherever x ^ 2 + y ^ 2 = 0"

    def test_other_roots_are_real(self):
        space = {**XY, "steps": [["root", "r", ["+", "x", 1]]]}
        assert accepted([space], [self.GOAL], [{**self.PROOF, "point": at(x=0, y=0, r=1)}])

    def test_cases_without_a_product(self):
        goal = follows(["x", 0], given=[["x", 0]])
        proof = {"point": ORIGIN, "cofactors": [[1]]}
        rejected([XY], [goal], [{**proof, "cases": [{"cofactors": [[1]]}]}], "cases belong")
        rejected([XY], [goal], [{**proof, "product": [], "cases": []}], "empty")
        rejected([XY], [goal], [{**proof, "product": [[]], "cases": [{}]}], "empty")
        rejected([XY], [goal], [{**proof, "trust": "me"}], "unknown")


class TestEqualRoots:
    SPACE: ClassVar = {**XY, "steps": [["root", r"\sqrt{x}", ["^", "x", 2]], ["root", "r", "y"]]}
    POINT: ClassVar = at(**{"x": 1, "y": 1, r"\sqrt{x}": 1, "r": 1})

    @pytest.mark.parametrize(
        ("left", "right", "message"),
        [
            (r"\sqrt{x}", "x", "sign"),
            (r"\sqrt{x}", ["-", "x"], "sign"),
            (["-", r"\sqrt{x}"], "x", "sign"),
            (r"\sqrt{x}", ["*", "x", -1, -1], "sign"),
            (["*", "r", r"\sqrt{x}"], ["*", "r", r"\sqrt{x}"], "sign"),
            (["^", "x", 3], ["*", r"\sqrt{x}", ["^", "x", 2]], "sign"),
            (["conj", r"\sqrt{x}"], r"\sqrt{x}", "sign"),
            (["^", r"\sqrt{x}", 2], ["^", "y", 2], "squares"),
            (["+", r"\sqrt{x}", 1], r"\sqrt{x}", "squares"),
        ],
    )
    def test_what_may_be_negative_or_has_another_square(self, left, right, message):
        goal, entry = follows([left, right]), {"equal": [[left, right]], "cofactors": [[1]]}
        entry["point"] = self.POINT
        rejected([self.SPACE], [goal], [entry], message)
        with pytest.raises(Unproved):
            judged(certificate([self.SPACE], [goal], [entry]))

    def test_an_imaginary_root(self):
        space = {**XY, "steps": [I, ["root", r"\sqrt{-4}", -4]]}
        sides = [["^", "i", 2], ["^", "i", 4]]
        entry = {"equal": [sides], "cofactors": [[1]], "point": {**ORIGIN, "values": [*ORIGIN["values"], ["i", "i"], [r"\sqrt{-4}", ["*", 2, "i"]]]}}  # fmt: skip
        rejected([space], [follows(sides)], [entry], "sign")


class TestMotion:
    POINT: ClassVar = {"point": ORIGIN}

    def test_a_variable_whose_equation_is_missing_does_not_rest(self):
        """Its derivative is used before the row in which it is given, or would be."""
        for rest in ([], [[["x"], 1, 1]]):
            field = [[["y"], 1, ["D", "x"]], *rest]
            goal = follows([["D", "y"], 0])
            rejected([{**XY, "field": field}], [goal], [self.POINT], "not known yet")
        rejected([{**XY, "field": [[["y"], 1, "x"]]}], [goal], [self.POINT], "does not move")

    def test_a_partial_derivative_in_the_field_holds_the_others_fixed(self):
        energy = ["+", ["^", "x", 2], ["*", "x", "y"]]
        rates = ["vector", ["d", "y", energy], ["-", ["d", "x", energy]]]
        space = {**XY, "field": [[["x", "y"], ["vector", 1, 1], rates]]}
        accepted([space], [follows([["D", energy], 0])], [self.POINT])

    def test_the_conjugate_of_what_is_defined_later(self):
        steps = [["root", "r", "x"], ["root", "s", ["conj", "r"]]]
        space = {**XY, "steps": steps, "conjugates": [["x", "y"], ["r", "s"]]}
        point = at(x=1, y=1, r=1, s=1)
        rejected([space], [follows(["s", 1])], [{"point": point}], "not defined yet|its square")

    def test_moving_twice_or_though_constant(self):
        rejected([{**XY, "field": [[["x", "y"], ["vector", 1, 1], ["vector", 1, 1]]] * 2}],
                 [follows([["D", "x"], 1])], [self.POINT], "twice")  # fmt: skip
        space = {"variables": ["x"], "constants": ["y"], "field": [[["x"], 1, 1], [["y"], 1, 1]]}
        rejected([space], [follows([["D", "y"], 1])], [self.POINT], "constant moves")

    def test_a_derivative_without_a_field(self):
        rejected([XY], [follows([["D", 1], 0])], [self.POINT], "no vector field")
        still = {"variables": [], "constants": ["a"]}
        rejected([still], [follows([["D", "a"], 1])], [{"point": at(a=1)}], "not equal")
        accepted([still], [follows([["D", "a"], 0])], [{"point": at(a=1)}])

    def test_a_variable_that_is_set_to_a_number_where_it_moves(self):
        """The formula x and its square are two, but say nothing of y, which is held fixed."""
        old = {**XY, "field": [[["x", "y"], ["vector", 1, 1], ["vector", "y", "x"]]]}
        change = {"old": 0, "formulas": [["u", "x"], ["v", ["^", "x", 2]]], "time": 1}
        steps = [["let", "x", "u"], ["let", "v", ["^", "u", 2]], ["let", "y", 5]]
        new = {"variables": ["u"], "steps": steps, "change": change}
        goal = follows([["D", "u"], 5], space=1)
        rejected([old, new], [goal], [{"point": at(u=0)}], "moves otherwise")

    def test_a_constant_that_becomes_a_variable(self):
        old = {"variables": ["x"], "constants": ["a"], "field": [[["x"], 1, "a"]]}
        change = {"old": 0, "formulas": [["u", "x"]], "time": 1}
        steps = [["let", "x", "u"], ["let", "a", "u"]]
        new = {"variables": ["u"], "steps": steps, "change": change}
        goal = follows([["D", "u"], "u"], space=1)
        rejected([old, new], [goal], [{"point": at(u=0)}], "moves otherwise")

    @given(st.permutations(["c", ["/", 1, "c"], ["+", "a", ["-", "b"]], "a"]))
    def test_a_divisor_that_a_change_makes_vanish(self, factors):
        """A product is not defined where a factor is not, whatever else is zero in it."""
        constants = ["a", "b", "c"]
        old = {"variables": ["x"], "constants": constants, "field": [[["x"], 1, ["*", *factors]]]}
        steps = [["let", "x", "u"], ["let", "c", 0], ["let", "b", "a"]]
        change = {"old": 0, "formulas": [["u", "x"]], "time": 1}
        new = {"variables": ["u"], "constants": ["a"], "steps": steps, "change": change}
        goal = follows([["D", "u"], 0], space=1)
        rejected([old, new], [goal], [{"point": at(u=0, a=1)}], "by zero")

    def change(self, time=1, **more):
        old = {**XY, "steps": [I], "field": [[["x", "y"], ["vector", 1, 1], ["vector", "y", "x"]]]}
        u, v = ["+", "x", ["*", "i", "y"]], ["+", "x", ["-", ["*", "i", "y"]]]
        steps = [
            I,
            ["let", "x", ["/", ["+", "u", "v"], 2]],
            ["let", "y", ["/", ["+", "u", ["-", "v"]], ["*", 2, "i"]]],
        ]
        change = {"old": 0, "formulas": [["u", u], ["v", v]], "time": time}
        return [old, {"variables": ["u", "v"], "steps": steps, "change": change, **more}]

    def test_conjugates_that_contradict_the_change(self):
        entry = {"point": at(u=2, v=2, i="i")}
        rejected(self.change(), [follows([["conj", "u"], "u"], space=1)], [entry], "not real")
        spaces = self.change(conjugates=[["u", "v"]])
        accepted(spaces, [follows([["conj", "u"], "v"], space=1)], [entry])

    def test_a_time_factor_that_vanishes(self):
        goal, entry = follows(["u", "u"], space=1), {"point": at(u=2, v=2, i="i")}
        for time_factor in (0, ["+", "x", ["-", "x"]]):
            spaces = self.change(time_factor, conjugates=[["u", "v"]])
            rejected(spaces, [goal], [entry], "by zero")
        rejected(self.change("y", conjugates=[["u", "v"]]), [goal], [entry], "condition fails")
        assert accepted(self.change("x", conjugates=[["u", "v"]]), [goal], [entry])[0].where

    @given(st.integers(-2, 2), st.integers(-2, 2), st.integers(-2, 2))
    def test_nothing_moves_where_the_time_stands_still(self, a, b, c):
        """By dt = (ax + by + c) ds there is no derivative where this factor vanishes."""
        factor = ["+", ["*", a, "x"], ["*", b, "y"], c]
        spaces = self.change(factor, conjugates=[["u", "v"]])
        goal, entry = follows([["D", "u"], ["D", "u"]], space=1), {"point": at(u=2, v=2, i="i")}
        if 2 * a + c:  # x = 2, y = 0 at the point
            accepted(spaces, [goal], [entry])
            judged(certificate(spaces, [goal], [entry]))
        else:
            rejected(spaces, [goal], [entry], "condition fails|by zero")
            with pytest.raises(Unproved, match=r"divided by|division"):
                judged(certificate(spaces, [goal], [entry]))

    def test_a_false_inverse(self):
        spaces = self.change(conjugates=[["u", "v"]])
        spaces[1]["steps"][1][2] = ["/", ["+", "u", "v"], 3]
        rejected(spaces, [follows(["u", "u"], space=1)], [{"point": at(u=2, v=2, i="i")}], "back")

    def test_a_root_that_leaves_its_relation(self):
        row = [["x", "r"], ["vector", 1, 1], ["vector", 1, 1]]
        space = {"variables": ["x"], "steps": [["root", "r", "x"]], "field": [row]}
        rejected([space], [follows([["D", "r"], 1])], [{"point": at(x=0, r=0)}], "moves otherwise")

    def test_a_printed_equation_of_a_root_that_does_not_hold(self):
        step = ["root", "r", ["+", "x", 1], [["^", "r", 2], ["+", "x", 1]]]
        goal, entry = follows(["x", "x"]), {"point": at(x=0, y=0, r=1)}
        accepted([{**XY, "steps": [step]}], [goal], [entry])
        step[3][1] = "x"
        rejected([{**XY, "steps": [step]}], [goal], [entry], "another square")

    def test_old_and_new_field(self):
        space = {**XY, "field": [], "change": {"old": 0, "formulas": [], "time": 1}}
        rejected([XY, space], [follows(["x", "x"])], [self.POINT], "a field, or a change")


class TestConjugation:
    """It is an involution that keeps all relations, or nothing is conjugated."""

    PAIR: ClassVar = {**XY, "conjugates": [["x", "y"]]}

    def test_a_real_root_of_what_is_not_real(self):
        space, point = {**self.PAIR, "steps": [["root", "r", "x"]]}, at(x=1, y=1, r=1)
        rejected([space], [follows([["conj", "r"], "r"])], [{"point": point}], "keep its square")
        assert accepted([space], [follows(["r", "r"])], [{"point": point}])
        for x, y, r in (("i", ["-", "i"], "i"), (["*", 2, "i"], ["*", -2, "i"], ["+", 1, "i"])):
            rejected([space], [follows(["r", "r"])], [{"point": at(x=x, y=y, r=r)}], "real|square")

    def test_conjugate_roots_of_conjugates(self):
        steps = [["root", "r", "x"], ["root", "s", "y"]]
        space = {**XY, "steps": steps, "conjugates": [["x", "y"], ["r", "s"]]}
        goal = follows([["conj", ["*", "r", "x"]], ["*", "s", "y"]])
        entry = {
            "point": at(x=["*", 2, "i"], y=["*", -2, "i"], r=["+", 1, "i"], s=["+", 1, ["-", "i"]])
        }
        assert accepted([space], [goal], [entry])
        steps[1][2] = ["*", 2, "y"]
        rejected([space], [goal], [entry], "keep its square")

    def test_a_real_root_of_a_negative_number(self):
        goal = follows([["*", "j", ["conj", "j"]], 4])
        assert accepted(
            [{**XY, "steps": [["root", "j", -4]]}],
            [goal],
            [{"point": at(x=0, y=0, j=["*", 2, "i"])}],
        )
        steps = [["root", "j", -4], ["root", "k", -4]]
        space = {**XY, "steps": steps, "conjugates": [["j", "k"]]}
        rejected([space], [goal], [{"point": at(x=0, y=0, j="i", k="i")}], "its own pair")

    @pytest.mark.parametrize("value", [1, -1, "i", ["*", 2, "i"]])
    def test_a_root_is_real_where_its_square_is_no_negative_number(self, value):
        space = {**XY, "steps": [["root", "r", "x"]]}
        square = {1: 1, -1: 1, "i": -1}.get(value if isinstance(value, int | str) else 0, -4)
        entry = {"point": at(x=square, y=0, r=value)}
        if square > 0:
            assert accepted([space], [follows(["r", "r"])], [entry])
        else:
            rejected([space], [follows(["r", "r"])], [entry], "not real")


class TestPowers:
    SPACE: ClassVar = {"variables": ["x"], "constants": ["m"], "steps": [["power", "P", "x", "m"]]}

    def test_only_where_the_base_is_one(self):
        goal = follows(["P", "P"])
        accepted([self.SPACE], [goal], [{"point": at(x=1, m=5, P=1)}])
        for point in (at(x=2, m=2, P=4), at(x=1, m=2, P=-1), at(x=-1, m=2, P=1), at(x=0, m=1, P=0)):
            rejected([self.SPACE], [goal], [{"point": point}], "no power")

    @pytest.mark.parametrize("exponent", ["x", 2, ["+", "m", 1], "z", None])
    def test_the_exponent_is_a_constant(self, exponent):
        space = {**self.SPACE, "steps": [["power", "P", "x", exponent]]}
        rejected([space], [follows(["x", "x"])], [{"point": at(x=1, m=5, P=1)}], "step")

    def test_the_base_is_real(self):
        steps = [I, ["power", "P", ["*", "i", "x"], "m"]]
        point = at(x=["-", "i"], m=1, P=1, i="i")
        rejected(
            [{**self.SPACE, "steps": steps}], [follows(["x", "x"])], [{"point": point}], "real"
        )

    def test_no_partial_derivative_by_the_exponent(self):
        goal = follows([["d", "m", "P"], 0])
        rejected([self.SPACE], [goal], [{"point": at(x=1, m=5, P=1)}], "no variable")

    def test_no_rate_of_its_own(self):
        row = [["x", "P"], ["vector", 1, 1], ["vector", 1, 0]]
        goal = follows([["D", "P"], 0])
        rejected(
            [{**self.SPACE, "field": [row]}], [goal], [{"point": at(x=1, m=5, P=1)}], "by itself"
        )
        old = {**self.SPACE, "field": [[["x"], 1, 1]]}
        change = {"old": 0, "formulas": [["P", "P"]], "time": 1}
        new = {"variables": [], "constants": ["m", "x"], "change": change}
        new["steps"] = self.SPACE["steps"]
        rejected([old, new], [{**goal, "space": 1}], [{"point": at(x=1, m=5, P=1)}], "by itself")


class TestExistence:
    def exists(self, *goals, numbers=(), expressions=()):
        return {
            "goal": "exists",
            "numbers": [*numbers],
            "expressions": [*expressions],
            "goals": [*goals],
        }

    def test_a_bound_name_that_is_taken_unused_or_without_a_value(self):
        point = {"point": ORIGIN}
        for names, used, values in ((["x"], "x", ["x"]), (["M", "N"], "M", ["M", "N"]),
                                    (["M"], "M", []), (["M"], "M", ["M", "N"]), (["M", "M"], "M", ["M", "M"])):  # fmt: skip
            goal = self.exists(follows([used, 0]), expressions=names)
            entry = {"values": [[name, 0] for name in values], "evidence": [point]}
            rejected([XY], [goal], [entry], "another meaning|not used|other names|twice")

    def test_no_bound_name(self):
        goal = self.exists(follows(["x", "x"]))
        rejected([XY], [goal], [{"values": [], "evidence": [{"point": ORIGIN}]}], "no name")

    def test_existence_of_existence_and_of_nothing(self):
        inner = self.exists(follows(["M", 0]), expressions=["M"])
        for goal in (self.exists(inner, expressions=["M"]), self.exists(expressions=["M"])):
            rejected([XY], [goal], [{"values": [["M", 0]], "evidence": []}], "unknown|nothing")


class TestDenials:
    """A denial may not suppose more than the goal: where it fails, the goal might hold."""

    GOAL = follows(["y", 0], given=[[["*", "x", "y"], 0]])

    def test_what_fails_somewhere_is_not_denied_elsewhere(self):
        fails = {**self.GOAL, "goal": "fails"}
        assert accepted([XY], [fails], [{"point": at(x=0, y=1)}])
        entry = {"goal": 0, "away": ["x"], "cofactors": [[["/", 1, "x"]]], "point": at(x=1, y=0)}
        rejected([XY], [fails], [entry], "may fail where", "denied")
        (found,) = accepted([XY], [self.GOAL], [{k: v for k, v in entry.items() if k != "goal"}])
        assert found.where == ["x"]

    def test_minors_are_not_divided(self):
        rank = {"goal": "rank", "space": 0, "functions": [["*", "x", "y"]], "given": [], "rank": 1}
        entry = {"goal": 0, "away": ["x"], "minors": [[], []]}
        rejected([XY], [rank], [entry], "unknown", "denied")


class TestCount:
    SPACE: ClassVar = {"variables": ["x"], "constants": ["a"], "nonzero": ["a"]}
    ENTRY: ClassVar = {
        "point": at(x=1, a=1), "root": "s", "form": "x", "eliminant": [["-", ["^", "a", 2]], 0],
        "solved": [["x", "s", 1]], "cofactors": [[1], [0]], "quotients": [1, 0],
        "factors": [{"factor": ["^", "a", 2], "squares": [[1, "a"]]}], "minors": [[2, [0]], [4, [1]]],
    }  # fmt: skip

    def goal(self, square=("^", "a", 2), number=2):
        equation = [["^", "x", 2], [*square]]
        return {
            "goal": "count",
            "space": 0,
            "equations": [equation],
            "names": ["x"],
            "number": number,
        }

    def test_two(self):
        assert accepted([self.SPACE], [self.goal()], [self.ENTRY])
        rejected([self.SPACE], [self.goal(number=3)], [self.ENTRY], "is 2")
        rejected([self.SPACE], [self.goal()], [{"goal": 0, **self.ENTRY}], "as stated", "denied")

    def test_a_factor_that_may_vanish_or_be_negative(self):
        rejected([{**self.SPACE, "nonzero": []}], [self.goal()], [self.ENTRY], "may be zero")
        entry = {**self.ENTRY, "eliminant": [["-", "a"], 0], "minors": [[2, [0]], [4, [1]]]}
        entry["factors"] = [{"factor": "a", "squares": []}]
        rejected([self.SPACE], [self.goal(("*", 1, "a"))], [entry], "no sum of squares")

    def test_a_condition_on_what_is_counted(self):
        rejected([{**self.SPACE, "nonzero": ["a", "x"]}], [self.goal()], [self.ENTRY], "is counted")
        rejected([self.SPACE], [self.goal()], [{**self.ENTRY, "away": ["x"]}], "is counted")

    def test_complex_solutions(self):
        goal = self.goal(("-", ["^", "a", 2]))
        entry = {**self.ENTRY, "eliminant": [["^", "a", 2], 0], "minors": [[2, [0]], [-4, [1]]]}
        rejected([self.SPACE], [goal], [{**entry, "point": at(x="i", a=1)}], "not real")

    def test_a_root_that_is_no_solution_and_one_that_is_left_out(self):
        cubic = {
            **self.ENTRY,
            "eliminant": [0, ["-", ["^", "a", 2]], 0],
            "minors": [[3, [0]], [6, [1]], [4, [3]]],
        }
        cubic |= {"cofactors": [["x"], [0]]}
        rejected([self.SPACE], [self.goal()], [cubic], "no solution")
        linear = {**self.ENTRY, "eliminant": [["-", "a"]], "minors": [[1, [0]]]}
        rejected([self.SPACE], [self.goal()], [linear], "not equal")

    def test_a_name_that_is_a_variable_elsewhere(self):
        space = {**self.SPACE, "variables": ["x", "y"]}
        goal = self.goal(("^", "y", 2))
        rejected([space], [goal], [{**self.ENTRY, "point": at(x=1, y=1, a=1)}], "another name")
        rejected([self.SPACE], [self.goal()], [{**self.ENTRY, "root": "x"}], "meaning")
        rejected(
            [self.SPACE], [self.goal()], [{**self.ENTRY, "eliminant": ["s", 0]}], "not defined"
        )


class TestNames:
    @pytest.mark.parametrize("name", ["х", "x y", "x = 0", "(x + y)", "", "1", "1/0", "x\n", "+", "x,y", "é",
        "x\u202e", "{", "-x", "x^2", "x*y", "x*", "\\", "x{=0}", "x{a=b}", "x{a} b", ":x", "x^", "x{", "x}", "x{}", "x{\n}"])  # fmt: skip
    def test_odd_names(self, name):
        entry = [{"point": {"roots": [], "values": [[name, 0]]}}]
        rejected([{"variables": [name]}], [follows([name, name])], entry, "odd")
        space = {"variables": [], "steps": [["let", name, 0]]}
        rejected([space], [follows([name, name])], [{"point": at()}], "odd")

    def test_a_name_given_twice(self):
        for space in (
            {"variables": ["x", "x"]},
            {"variables": ["x"], "constants": ["x"]},
            {"variables": ["x"], "steps": [["let", "x", 0]]},
            {"variables": ["x"], "steps": [["root", "x", 0]]},
            {"variables": ["x"], "steps": [["let", "f", 0], ["let", "f", "x"]]},
            {"variables": ["x"], "steps": [["let", "f", 0], ["root", "f", "x"]]},
            {"variables": ["x"], "constants": ["m"], "steps": [["power", "x", 1, "m"]]},
        ):
            rejected([space], [follows(["x", "x"])], [{"point": at(x=0)}], "twice")

    @pytest.mark.parametrize("pairs", [[["x", "x"]], [["x", "y"], ["y", "x"]], [["x", "a"]], [["x", "z"]], [["i", "j"]],
        [["x"]], ["xy"], [["x", "y", "y"]], [["f", "x"]]])  # fmt: skip
    def test_odd_conjugates(self, pairs):
        steps = [I, ["root", "j", -4], ["let", "f", 0]]
        space = {**XY, "constants": ["a"], "steps": steps, "conjugates": pairs}
        rejected([space], [follows(["x", "x"])], [{"point": at(x=0, y=0, a=0)}], ".")

    @pytest.mark.parametrize(
        "claim", ["a\nCERTIFIED 9 of 9", "../c", "c d", "", "ç", 5, None, ["c"]]
    )
    def test_odd_claims(self, claim):
        rejected([XY], [follows(["x", "x"])], [{"point": ORIGIN}], "odd", claim=claim)

    def test_nothing_of_a_file_reaches_another_line(self, tmp_path, capsys):
        for key in ("spaces", "goals", "evidence", "sign", "claim", "digest", "format", "version"):
            data = certificate([XY], [follows(["x", "x"])], [{"point": ORIGIN}])
            data[key] = "a\nCERTIFIED 9 of 9"
            (tmp_path / "c.json").write_text(json.dumps(data) if key == "digest" else seal(data))
            assert main([str(tmp_path / "c.json")]) == 5
        name = "x\nCERTIFIED 9 of 9\u202e"
        for tree in (name, [name, 1], ["+", name, 1], ["^", "x", name], ["d", name, 1]):
            (tmp_path / "c.json").write_text(
                seal(certificate([XY], [follows([tree, tree])], [{"point": ORIGIN}]))
            )
            assert main([str(tmp_path / "c.json")]) == 5
        lines = capsys.readouterr().out.splitlines()
        assert {line for line in lines if not line.startswith("REJECTED")} == {"CERTIFIED 0 of 1"}
        assert all(re.fullmatch("[ -~]*", line) for line in lines)


class TestNumbers:
    @pytest.mark.parametrize(
        "number", [1.0, True, None, "1", "NaN", {}, [], [1], [[]], float("inf")]
    )
    def test_what_is_no_number(self, number):
        tree = ["+", "x", number]
        rejected([XY], [follows([tree, tree])], [{"point": ORIGIN}], ".")

    @pytest.mark.parametrize("version", [True, 2.0, "2", None, [2], 3, 0])
    def test_what_is_no_version(self, version):
        rejected(
            [XY], [follows(["x", "x"])], [{"point": ORIGIN}], "format|integer", version=version
        )

    @pytest.mark.parametrize("size", [True, 1.0, "1", -1, None, 10**9])
    def test_what_is_no_size(self, size):
        rank = {"goal": "rank", "space": 0, "functions": ["x"], "given": [], "rank": size}
        rejected([XY], [rank], [{"point": ORIGIN}], "odd|integer")
        rejected([XY], [rank], [{"goal": 0, "point": ORIGIN}], "odd|integer", "denied")

    @pytest.mark.parametrize("index", [True, -1, 1, "0", None, 0.0, [0]])
    def test_what_is_no_space_and_no_goal(self, index):
        rejected([XY], [follows(["x", "x"], space=index)], [{"point": ORIGIN}], "odd|integer")
        entry = {"goal": index, "point": at(x=1, y=0)}
        rejected([XY], [follows(["x", 0])], [entry], "odd|integer", "denied")

    def test_work_belongs_to_one_check(self):
        goal = follows([["^", ["+", "x", "y"], 40], ["^", ["+", "y", "x"], 40]])
        for _ in range(40):
            assert accepted([XY], [goal], [{"point": ORIGIN}])


class TestFiles:
    GOOD = certificate([XY], [follows(["x", "x"])], [{"point": ORIGIN}])

    def run(self, *arguments, flags=("-I", "-S")):
        command = [sys.executable, *flags, str(CHECKER), *map(str, arguments)]
        result = subprocess.run(command, capture_output=True, timeout=60)
        assert not result.stderr
        return result.returncode, result.stdout.decode("ascii")

    @pytest.mark.parametrize(
        "flags", [("-I", "-S"), ("-I", "-S", "-O"), ("-I", "-X", "utf8=0"), ()]
    )
    def test_noise(self, flags, tmp_path):
        good = seal(self.GOOD)
        texts = {
            "empty": b"", "noise": bytes(range(256)) * 20, "truncated": good[:-4].encode(),
            "doubled": (good * 2).encode(), "bom": b"\xef\xbb\xbf" + good.encode(), "wide": good.encode("utf-16"),
            "deep": b"[" * 200_000, "deep_dicts": b'{"a":' * 100_000, "long": b" " * 2_000_000 + good.encode(),
            "number": b"9" * 500_000, "exponent": b"1e999999999", "null": b"null", "zeros": b"\0" * 5000,
            "surrogate": good.replace('"x"', '"\\ud800"').encode(),
            "twice": good.replace('"claim"', '"claim": "c", "claim"').encode(),
            "list": f"[{good}]".encode(), "nested": good.replace('[["x", "x"]]', "[" * 5000 + "]" * 5000).encode(),
        }  # fmt: skip
        paths = []
        for name, content in texts.items():
            paths.append(tmp_path / f"{name}.json")
            paths[-1].write_bytes(content)
        (tmp_path / "folder.json").mkdir()
        paths += [
            tmp_path / "folder.json",
            tmp_path / "missing.json",
            tmp_path / "od\udcffd.json",
            "new\nline",
        ]
        code, out = self.run(*paths, flags=flags)
        assert code == 5
        *lines, last = out.splitlines()
        assert len(lines) == len(paths) and all(line.startswith("REJECTED ") for line in lines)
        assert last == f"CERTIFIED 0 of {len(paths)}"
        (tmp_path / "c.json").write_text(good)
        assert self.run(tmp_path / "c.json", flags=flags)[0] == 0

    def test_nothing(self):
        assert self.run() == (6, "CERTIFIED 0 of 0\n")

    def test_a_certificate_of_format_1(self):
        data = {"format": checker.FORMAT, "version": 1, "claim": "c", "parts": []}
        with pytest.raises(checker.Rejected, match=r"format 1.*make certificates"):
            checker.check(json.dumps(data))

    @pytest.mark.parametrize(
        "junk", [None, True, 5, "x", [], {}, [[]], [{}], {"x": []}, [["x"]], [None], "\ud800"]
    )
    def test_other_types_everywhere(self, junk):
        """Whatever stands at whatever place, it is a rejection and no other error."""
        data = json.loads(seal(self.GOOD))
        data["spaces"][0] |= {
            "constants": [],
            "nonzero": [],
            "steps": [["let", "f", "x"]],
            "conjugates": [],
        }
        data["spaces"][0]["field"] = [[["x", "y"], ["vector", 1, 1], ["vector", "y", "x"]]]
        for path in places(data):
            if place(data, path) != junk and path != ("digest",):
                other = deepcopy(data)
                place(other, path[:-1])[path[-1]] = junk
                try:
                    checker.check(seal(other))
                except checker.Rejected:
                    continue
                empty = junk in ({}, [{}]) and path in (("evidence",), ("evidence", 0))
                assert empty or junk in ([], 5, "x"), path  # an identity needs no evidence
