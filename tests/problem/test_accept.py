"""Evidence that somebody made to deceive: the one function that believes it may believe none."""

from dataclasses import replace
from fractions import Fraction
from functools import reduce
from operator import add, mul, truediv

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kowalevski_cas.algebra import EXACT
from kowalevski_cas.notation import Name
from kowalevski_cas.problem import checker
from kowalevski_cas.problem.codec import evidence_data, problem_data
from kowalevski_cas.problem.evidence import (
    At,
    Entailment,
    Factor,
    Found,
    Further,
    Minors,
    Point,
    Proof,
    Regardless,
    Roots,
    Solutions,
)
from kowalevski_cas.problem.examine import Unproved
from kowalevski_cas.problem.goals import (
    Count,
    Exists,
    Fails,
    Follows,
    Kernel,
    Problem,
    Rank,
    identity,
)  # fmt: skip
from kowalevski_cas.problem.space import Adjoined, EquationOfMotion, Let, Raised, Space
from kowalevski_cas.problem.trees import decode

from .judges import judge
from .tampering import seal


def certificate(goal, evidence, sign=True):
    """The certificate of a goal by this evidence, which nobody has checked."""
    entry = evidence_data(evidence) if sign else {"goal": 0, **evidence_data(evidence)}
    data = {"format": checker.FORMAT, "version": 2, "claim": "c", "evidence": [entry]}
    return seal({**data, **problem_data(Problem((goal,))), "sign": "holds" if sign else "denied"})


def rejected(goal, evidence, message=".", sign=True):
    """The judge does not believe it, in no arithmetic, nor does the checker."""
    unproved(goal, evidence, message, sign)
    with pytest.raises(checker.Rejected):
        checker.check(certificate(goal, evidence, sign))


def unproved(goal, evidence, message=".", sign=True):
    for arithmetic in EXACT:
        one = judge(arithmetic)
        with pytest.raises(Unproved, match=message):
            (one.holds if sign else one.denies)(goal, evidence)


def denial_rejected(goal, evidence, message="."):
    rejected(goal, evidence, message, sign=False)


def accepted(goal, evidence, sign=True):
    """What is divided by, beyond the statement, in any arithmetic."""
    for arithmetic in EXACT[::-1]:
        one = judge(arithmetic)
        (one.holds if sign else one.denies)(goal, evidence)
    return [element for elements in one.accepted.away for element in elements]


def equations(*pairs):
    return tuple((decode(left), decode(right)) for left, right in pairs)


@given(st.lists(st.integers(-30, 30), min_size=4, max_size=4), st.sampled_from(("r", r"\sqrt{x}")))
def test_a_printed_root_is_not_negative_at_a_point(parts, name):
    """A name with a square may be either root; so the judge has it, and the checker."""
    numbers = [1, ["sqrt", 2], ["sqrt", 3], ["*", ["sqrt", 2], ["sqrt", 3]]]
    value = ["+", *(["*", part, one] for part, one in zip(parts, numbers, strict=True))]
    size = sum(part * one**0.5 for part, one in zip(parts, (1, 2, 3, 6), strict=True))
    space = Space(("x",), steps=(Adjoined(name, Name("x")),))
    found = Point({"x": decode(["^", value, 2]), name: decode(value)})
    goal, evidence = follows(["x", ["^", name, 2]], space=space), Entailment(Proof(), found)
    if name == "r" or size > -1e-9:
        accepted(goal, evidence)
        checker.check(certificate(goal, evidence))
    else:
        rejected(goal, evidence, "is negative there")


def follows(*conclusion, given=(), space=None):
    return Follows(space or XY, (equations(*conclusion),), equations(*given))


FORMULAS = st.recursive(
    st.sampled_from(["x", "y", 1, 2]),
    lambda one: (
        st.tuples(st.sampled_from("+*//"), one, one).map(list)
        | one.map(lambda tree: ["+", ["sqrt", ["*", tree, ["/", "x", tree]]], "y"])
    ),
    max_leaves=6,
)


def number(tree, place):
    """The value of a formula, where r is the one root."""
    if not isinstance(tree, list):
        return Fraction(place.get(tree, tree))
    op, *values = tree[0], *(number(part, place) for part in tree[1:])
    return place["r"] if op == "sqrt" else reduce({"+": add, "*": mul, "/": truediv}[op], values)


@given(FORMULAS, st.sampled_from([0, 1, 4]), st.integers(-2, 2), st.booleans())
def test_a_point_is_none_of_a_statement_if_anything_vanishes_by_which_it_is_divided(
    tree, x, y, named
):
    """However deep it stands, and for either root; the judge has it so, and the checker.

    So it is of what a name of the space stands for, also where nothing is said of that.
    """
    names = (Let("g", decode(tree)),) if named else ()
    space = Space(("x", "y"), steps=(Adjoined("r", Name("x")), *names))
    place = {"x": x, "y": y, "r": {0: 0, 1: 1, 4: -2}[x]}
    said = [] if named else [[tree, tree]]
    goal, evidence = (follows(["r", "r"], *said, space=space), Entailment(Proof(), at(**place)))
    try:
        number(tree, place), number(tree, {**place, "r": -place["r"]})
    except ZeroDivisionError:
        rejected(goal, evidence)
    else:
        accepted(goal, evidence)
        checker.check(certificate(goal, evidence))


def row(*trees):
    return tuple(map(decode, trees))


def at(**values):
    return Point({name: decode(tree) for name, tree in values.items()})


def plus(*trees):
    return ["+", *trees]


def minus(tree):
    return ["-", tree]


XY = Space(("x", "y"))
I = Adjoined("i", decode(minus(1)))  # noqa: E741
COMPLEX = Space(("x", "y"), steps=(I,))
SQUARE, SUM = ["^", "x", 2], plus(["^", "x", 2], ["^", "y", 2])
ORIGIN = at(x=0, y=0)
IDENTICALLY = Entailment(Proof(), at(x=1, y=2))
"""The two sides are equal, and there is a point."""


class TestHypotheses:
    def test_one_equals_zero(self):
        goal = follows(["x", 0], given=[[1, 0]])
        rejected(goal, Entailment(Proof((row("x"),)), ORIGIN), "not where it should be")

    def test_no_point(self):
        none = "no real point is known that satisfies the hypotheses"
        rejected(follows(["x", 0], given=[["x", 0]]), Entailment(Proof((row(1),))), none)
        rejected(follows(["x", "x"]), Entailment(), none)
        rejected(Follows(XY, (), equations([1, 0])), Entailment(Proof((row(1),))), none)

    def test_a_condition_that_vanishes_wherever_the_hypotheses_hold(self):
        goal, proof = follows(["y", 0], given=[["x", 0]]), Proof((row(["/", "y", "x"]),))
        for x in (0, 1):
            rejected(goal, Entailment(proof, at(x=x, y=0)), "not where|divided by")

    def test_hypotheses_that_hold_at_no_real_point(self):
        goal = follows(["y", 0], given=[[plus(SQUARE, 1), 0], ["y", 0]], space=COMPLEX)
        rejected(goal, Entailment(Proof((row(0, 1),)), at(x="i", y=0, i="i")), "not real")
        goal = replace(goal, space=XY)
        rejected(goal, Entailment(Proof((row(0, 1),)), at(x="i", y=0)), "not real")

    def test_emptiness_by_what_vanishes_on_the_set(self):
        empty = Follows(XY, (), equations(["x", 0]))
        proof = Proof((row(["/", 1, "x"]),))
        rejected(empty, Entailment(proof, at(x=1, y=0)), "may be zero")
        granted = replace(empty, space=Space(("x", "y"), nonzero=row("x")))
        accepted(granted, Entailment(proof, at(x=1, y=0)))

    def test_emptiness_in_a_setting_that_is_empty(self):
        """Where no r is the root of -1 - x², no r is 5; but that says nothing of 5."""
        square = minus(plus(SQUARE, 1))
        space = Space(("x",), steps=(Adjoined("r", decode(square)),))
        empty = Follows(space, (), equations([["^", "r", 2], plus(minus(SQUARE), 4)]))
        proof = Proof((row(["/", -1, 5]),))
        for r in (1, "i", ["*", -1, "i"]):
            rejected(empty, Entailment(proof, at(x=0, r=r)), "no root|not a root|not real")
        rejected(empty, Entailment(proof, at(x=0)), "leaves a value out|not real|not where")

    def test_emptiness_with_a_point_of_the_set(self):
        empty = Follows(XY, (), equations(["x", 0]))
        rejected(empty, Entailment(Proof((row(1),)), ORIGIN), "not equal")
        denied = At(at(x=0, y=5))
        accepted(empty, denied, sign=False)
        denial_rejected(empty, At(at(x=1, y=5)), "not where")

    def test_nothing_stated(self):
        for goal in (Follows(XY, ((),)), Follows(XY, ((), equations(["x", 0])))):
            rejected(goal, Entailment(), "nothing is stated")
        accepted(follows(["x", "x"]), IDENTICALLY)


class TestProofs:
    GOAL = follows(["x", 0], ["y", 0], given=[["x", "y"], ["y", 0]])
    ROWS = (row(1, 1), row(0, 1))

    def test_honest_rows(self):
        assert accepted(self.GOAL, Entailment(Proof(self.ROWS), ORIGIN)) == []

    @pytest.mark.parametrize("k", range(2))
    @pytest.mark.parametrize("j", range(2))
    @pytest.mark.parametrize("entry", [2, -1, "x", ["/", 1, 3]])
    def test_a_number_changed(self, k, j, entry):
        rows = [list(one) for one in self.ROWS]
        rows[k][j] = decode(entry)
        rejected(self.GOAL, Entailment(Proof(tuple(map(tuple, rows))), ORIGIN), "not equal")

    @pytest.mark.parametrize(
        "rows",
        [(row(1), row(0, 1)), (row(1, 1, 0), row(0, 1)), (row(1, 1),), (*ROWS, row(0, 0)),
         (row(1, 1), ()), (ROWS[1], ROWS[0])],
    )  # fmt: skip
    def test_rows_of_another_shape(self, rows):
        rejected(self.GOAL, Entailment(Proof(rows), ORIGIN), "row|not equal")

    @pytest.mark.parametrize("rows", [None, 5, "xy", (5,), ((5, 6), (7, 8)), ((None, None),) * 2])
    def test_rows_that_are_none(self, rows):
        unproved(self.GOAL, Entailment(Proof(rows), ORIGIN))

    @pytest.mark.parametrize("power", [0, -1, 17, 10**9, None, "x"])
    def test_a_power_of_the_goal_that_is_none(self, power):
        unproved(self.GOAL, Entailment(Proof(self.ROWS, power=power), ORIGIN))

    def test_a_power_of_the_goal_vanishes_with_it(self):
        goal = follows(["x", 0], given=[[SQUARE, 0]])
        accepted(goal, Entailment(Proof((row(1),), power=2), ORIGIN))
        rejected(goal, Entailment(Proof((row(1),), power=3), ORIGIN), "not equal")

    def test_a_name_that_is_not_there(self):
        for tree in ("z", ["D", "x"], ["conj", "z"], ["sqrt", "x"], ["/", 1, 0], ["^", "x", "y"]):
            entry = decode(tree) if tree != ["^", "x", "y"] else None
            unproved(self.GOAL, Entailment(Proof(((entry, entry), row(0, 1))), ORIGIN))

    @pytest.mark.parametrize(
        "evidence",
        [At(ORIGIN), Minors(()), Found({}, ()), Solutions(()), Regardless(0, ()), None, 5],
    )
    def test_evidence_for_something_else(self, evidence):
        unproved(self.GOAL, evidence, "no evidence")

    def test_what_shows_is_no_denial_and_the_reverse(self):
        denial_rejected(self.GOAL, Entailment(Proof(self.ROWS), ORIGIN), "no evidence")
        denial_rejected(self.GOAL, At(ORIGIN), "hold at the point")


class TestCases:
    GOAL = follows(["x", 0], ["y", 0], given=[[SUM, 0]])
    CASE = Proof((row(0, 1, 0), row(0, 0, 1)))
    PROOF = Proof((row(1),), (row("x", "y"),), (CASE,))

    def test_a_sum_of_squares_vanishes_with_each(self):
        accepted(self.GOAL, Entailment(self.PROOF, ORIGIN))

    @pytest.mark.parametrize("groups", [((),), (row("x", "y"), ()), ((), row("x", "y"))])
    def test_a_case_that_supposes_nothing(self, groups):
        proof = Proof((row(1),), groups, (self.CASE,) * len(groups))
        rejected(self.GOAL, Entailment(proof, ORIGIN), "each supposes something")

    def test_but_not_for_complex_names(self):
        goal = replace(self.GOAL, space=Space(("x", "y"), conjugates=(("x", "y"),)))
        rejected(goal, Entailment(self.PROOF, ORIGIN), "real names")
        goal = replace(self.GOAL, space=COMPLEX)
        rejected(goal, Entailment(self.PROOF, at(x=0, y=0, i="i")), "real names")
        space = Space(("x", "y"), steps=(Adjoined("j", decode(-4)),))
        point = at(x=0, y=0, j=["*", 2, "i"])
        rejected(
            replace(self.GOAL, space=space), Entailment(self.PROOF, point), "not real|real names"
        )

    STEPS = Proof((row(0, 1),), (row("y"),), (Proof((row(1, 0, minus(1)), row(0, 0, 1))),))
    """From x + y = 0 and y = 0 first y = 0 follows, then x = 0."""

    @pytest.mark.parametrize("space", [XY, Space(("x", "y"), conjugates=(("x", "y"),))])
    def test_a_product_of_one_formula_is_a_step(self, space):
        given = [[plus("x", "y"), 0], ["y", 0]]
        goal = follows(["x", 0], ["y", 0], given=given, space=space)
        accepted(goal, Entailment(self.STEPS, ORIGIN))
        for wrong in (
            self.STEPS._replace(rows=(row(1, 0),)),
            self.STEPS._replace(product=(row(1),)),
        ):
            rejected(goal, Entailment(wrong, ORIGIN), "not equal")
        goal = follows(["x", 0], ["y", 1], given=given, space=space)
        rejected(goal, Entailment(self.STEPS, ORIGIN), "not equal")

    def test_one_factor_vanishes_for_complex_names_too(self):
        goal = follows([["*", "x", "y"], 0], given=[[["*", SQUARE, "y"], 0]], space=COMPLEX)
        cases = Proof((row(0, "y"),)), Proof((row(0, "x"),))
        proof = Proof((row("y"),), (row("x"), row("y")), cases, 2)
        accepted(goal, Entailment(proof, at(x=0, y=0, i="i")))
        rejected(goal, Entailment(proof._replace(power=1), at(x=0, y=0, i="i")), "not equal")

    def test_a_difference_of_squares_is_none(self):
        goal = replace(self.GOAL, given=equations([SQUARE, ["^", "y", 2]]))
        rejected(goal, Entailment(self.PROOF, ORIGIN), "not equal")

    def test_a_case_left_out(self):
        goal = follows(["x", 0], given=[[["*", "x", "y"], 0]])
        one = Proof((row(0, 1),))
        for groups, cases in (
            ((row("x"), row("y")), (one,)),
            ((row("x"),), (one,)),
            ((row("x"), row("y")), (one, one)),
            ((row("x"), row("y")), ()),
            ((row("x"), ()), (one, one)),
        ):
            rejected(goal, Entailment(Proof((row(1),), groups, cases), ORIGIN))

    def test_a_case_that_is_not_proved(self):
        wrong = Proof((row(0, 1, 0), row(0, 1, 0)))
        rejected(self.GOAL, Entailment(self.PROOF._replace(cases=(wrong,)), ORIGIN), "not equal")

    def test_a_case_by_what_vanishes_in_it(self):
        goal = follows(["y", 0], given=[[["*", "x", "y"], 0]])
        by_x = Proof((row(0, ["/", "y", "x"]),))
        proof = Proof((row(1),), (row("x"), row("y")), (by_x, Proof((row(0, 1),))))
        assert accepted(goal, Entailment(proof, at(x=1, y=0)))  # for x other than zero
        rejected(goal, Entailment(proof, ORIGIN), "divided by")


class TestPoints:
    @pytest.mark.parametrize("point", [at(x=1), at(y=0), at()])
    def test_values_left_out(self, point):
        denial_rejected(follows(["y", "x"], given=[["x", 1]]), At(point), "leaves a value out")

    def test_the_value_of_a_root_left_out(self):
        space = Space(("x",), steps=(Adjoined("r", decode("x")),))
        goal = Follows(space, (equations(["r", 1]), equations(["r", -1])), equations(["x", 1]))
        denial_rejected(goal, At(at(x=1)), "value out")
        denial_rejected(goal, At(at(x=1, r=2)), "not a root there")
        denial_rejected(goal, At(at(x=1, r=-1)), "hold at the point")

    @pytest.mark.parametrize("tree", ["i", plus(1, "i"), ["sqrt", minus(2)], ["sqrt", 1], ["sqrt", 0],
        ["sqrt", ["sqrt", 2]], "x", "z", ["/", 1, 0], ["vector", 1, 2], ["^", 0, 0]])  # fmt: skip
    def test_values_that_are_none_or_not_real(self, tree):
        unproved(follows(["y", 2], given=[["x", 0]]), At(at(x=tree, y=1)), sign=False)

    @pytest.mark.parametrize("values", [None, 5, {"x": 1, "y": 2}, {"x": None, "y": None}])
    def test_points_that_are_none(self, values):
        for point in (None, Point(values)):
            unproved(follows(["y", "x"]), At(point), sign=False)

    def test_an_unknown_name(self):
        denial_rejected(follows(["y", "x"]), At(at(x=0, y=1, z=2)), "no meaning")

    def test_roots_take_no_side(self):
        goal = Follows(XY, (equations(["x", 2]), equations(["x", -2])), equations([SQUARE, 4]))
        denial_rejected(goal, At(at(x=["sqrt", 4], y=0)), "depend on each other")
        double = ["*", 2, "y"]
        goal = Follows(XY, (equations(["x", double]), equations(["x", minus(double)])),
                       equations([SQUARE, 8], [["^", "y", 2], 2]))  # fmt: skip
        denial_rejected(goal, At(at(x=["sqrt", 8], y=["sqrt", 2])), "depend on each other")
        point = at(x=["*", ["sqrt", 2], ["sqrt", 3]], y=["sqrt", 6])
        denial_rejected(follows([SQUARE, ["*", "x", "y"]]), At(point), "depend on each other")

    def test_the_unit_and_conjugates(self):
        goal = follows([["*", "x", "i"], "y"], space=COMPLEX)
        denial_rejected(goal, At(at(x=1, y=0, i=1)), "not a root")
        denial_rejected(goal, At(at(x=1, y=0)), "value out")
        pair = Space(("x", "y"), conjugates=(("x", "y"),))
        goal = follows(["x", "y"], space=pair)
        denial_rejected(goal, At(at(x=1, y=2)), "not real")
        denial_rejected(goal, At(at(x="i", y="i")), "not real")
        accepted(goal, At(at(x="i", y=minus("i"))), sign=False)

    def test_a_root_without_a_declared_conjugate_is_real(self):
        space = Space(("x", "y"), steps=(Adjoined("q", decode("x")),), conjugates=(("x", "y"),))
        goal = follows(["q", 3], space=space)
        complex_one = at(x=["*", 2, "i"], y=["*", -2, "i"], q=plus(1, "i"))
        denial_rejected(goal, At(complex_one), "q is not real there")
        accepted(goal, At(at(x=4, y=4, q=2)), sign=False)
        denial_rejected(goal, At(at(x=4, y=5, q=2)), "not real there")

    def test_off_the_set_and_on_it(self):
        goal = follows(["y", 1], given=[["x", 1]])
        denial_rejected(goal, At(at(x=2, y=2)), "not where it should be")
        denial_rejected(goal, At(at(x=1, y=1)), "hold at the point")
        accepted(goal, At(at(x=1, y=2)), sign=False)

    def test_at_a_pole(self):
        goal = follows([["/", "y", "x"], 1])
        denial_rejected(goal, At(at(x=0, y=1)), ".")
        goal = follows(["y", 1], given=[[["/", "y", "x"], 0]])
        denial_rejected(goal, At(ORIGIN), "not where")
        granted = Space(("x", "y"), nonzero=row("x"))
        denial_rejected(follows(["y", 1], space=granted), At(ORIGIN), "granted not to vanish")

    def test_a_power_that_is_not_known(self):
        space = Space(("x",), ("m",), steps=(Raised("P", decode("x"), "m"),))
        goal = follows(["P", "x"], space=space)
        for x, p in ((2, 4), (1, 2), (2, 1)):
            denial_rejected(goal, At(at(x=x, m=2, P=p)), "not known there")

    def test_each_conclusion_has_to_fail(self):
        goal = Follows(XY, (equations(["x", 0]), equations(["x", 1])))
        denial_rejected(goal, At(at(x=1, y=0)), "hold at the point")
        accepted(goal, At(at(x=2, y=0)), sign=False)


class TestFails:
    def test_what_follows_for_most_points_may_fail_at_others(self):
        goal = Fails(XY, (equations(["y", 0]),), equations([["*", "x", "y"], 0]))
        by_x = Entailment(Proof((row(["/", 1, "x"]),)), at(x=1, y=0))
        denial_rejected(goal, by_x, "may be zero")
        accepted(goal, At(at(x=0, y=1)))
        rejected(goal, At(at(x=1, y=0)), "hold at the point")
        rejected(goal, by_x, "no evidence")

    def test_printed_divisors_do_not_count(self):
        goal = Fails(XY, (equations([["/", "y", "x"], 0]),), equations(["y", 0]))
        accepted(goal, Entailment(Proof((row(["/", 1, "x"]),)), at(x=1, y=0)), sign=False)


class TestRank:
    GOAL = Rank(XY, row(SUM), equations(["x", 1]), 2)

    def test_independent_differentials(self):
        accepted(self.GOAL, At(at(x=1, y=1)))
        rejected(self.GOAL, At(at(x=1, y=0)), "dependent at the point")
        rejected(self.GOAL, At(at(x=2, y=1)), "not where")
        rejected(replace(self.GOAL, rank=1), At(at(x=1, y=1)), "2 independent")
        denial_rejected(self.GOAL, At(at(x=1, y=1)), "2 independent")
        denial_rejected(self.GOAL, At(at(x=1, y=0)), "dependent")

    def test_dependence_everywhere(self):
        goal = Rank(XY, row(SQUARE, "x"), (), 2)
        accepted(goal, Minors(((),)), sign=False)
        denial_rejected(goal, Minors(()), "a row for each minor")
        denial_rejected(replace(goal, functions=row(SUM, "x")), Minors(((),)), "not equal")

    def test_dependence_but_where_something_vanishes(self):
        """On x y = 0 the minor is x: it vanishes where y does not."""
        goal = Rank(XY, row(["/", SQUARE, 2]), equations([["*", "x", "y"], 0]), 2)
        rows = (row(["/", "x", "y"]),)
        denial_rejected(goal, Minors(rows), "may be zero|not equal")


class TestExists:
    SPACE = Space(("x", "y"), field=(EquationOfMotion(("x", "y"), decode(["vector", 1, 1]), decode(["vector", "y", minus("x")])),))  # fmt: skip

    def exists(self, *sides, expressions=("M",), numbers=(), space=None):
        return Exists((identity(space or self.SPACE, *equations(*sides)),), expressions, numbers)

    def test_names_without_values_and_values_without_names(self):
        goal = self.exists([["D", "x"], ["*", "M", "y"]])
        accepted(goal, Found({"M": decode(1)}, (IDENTICALLY,)))
        for values in ({}, {"N": decode(1)}, {"M": decode(1), "N": decode(1)}):
            rejected(goal, Found(values, (IDENTICALLY,)), "no value")
        for inner in ((), (IDENTICALLY, IDENTICALLY), (At(ORIGIN),), (None,), None):
            unproved(goal, Found({"M": decode(1)}, inner))
        rejected(goal, IDENTICALLY, "no expressions")

    def test_another_value(self):
        goal = self.exists([["D", "x"], ["*", "M", "y"]])
        for tree in (2, "x", "M", "N", ["/", 1, 0]):
            rejected(goal, Found({"M": decode(tree)}, (IDENTICALLY,)))

    def test_a_number_that_is_none(self):
        goal = self.exists(["x", "k"], expressions=(), numbers=("k",))
        for tree in ("x", plus("x", "y")):
            rejected(goal, Found({"k": decode(tree)}, (IDENTICALLY,)), "k is no number")

    def test_one_value_for_all_goals(self):
        first, second = (identity(self.SPACE, *equations(["M", tree])) for tree in ("x", "y"))
        goal = Exists((first, second), ("M",))
        for tree in ("x", "y"):
            rejected(goal, Found({"M": decode(tree)}, (IDENTICALLY, IDENTICALLY)), "not equal")

    def test_a_value_that_is_not_defined_on_the_set(self):
        goal = Exists(
            (
                identity(self.SPACE, *equations(["y", ["*", "M", "x"]])),
                replace(identity(self.SPACE, *equations(["y", ["*", "M", "x"]])), given=equations(["x", 0])),
            ),
            ("M",),
        )  # fmt: skip
        values = {"M": decode(["/", "y", "x"])}
        inner = (IDENTICALLY, Entailment(Proof(), at(x=0, y=1)))
        rejected(goal, Found(values, inner), "not where|divided by")

    def test_a_denial_at_a_pole(self):
        goal = self.exists([["*", "x", "M"], ["/", 1, "x"]])  # M = 1/x^2
        denial_rejected(goal, Regardless(0, ((decode(1), ORIGIN),)))

    def test_a_denial_where_the_name_counts(self):
        point = at(x=0, y=1)
        for sides in (["M", 1], [["*", "M", "y"], 1], [["*", "M", plus("M", "x")], 1], [["D", "M"], "y"],
                      [["conj", "M"], 1], [["/", "x", "M"], 1], [["d", "x", "M"], 1]):  # fmt: skip
            denial_rejected(self.exists(sides), Regardless(0, ((decode(1), point),)))
        goal = self.exists([["D", "x"], ["*", "M", "x"]])
        accepted(goal, Regardless(0, ((decode(1), point),)), sign=False)
        denial_rejected(goal, Regardless(0, ((decode(1), at(x=1, y=1)),)), "may hold")

    @pytest.mark.parametrize("goal", [1, 5, "x", None])
    def test_a_denial_of_no_goal(self, goal):
        evidence = Regardless(goal, ((decode(1), at(x=0, y=1)),))
        denial_rejected(self.exists([["D", "x"], ["*", "M", "x"]]), evidence)

    def test_weights(self):
        """k is x at each point, so that 2 points deny it; but no weights make x of a number."""
        goal = self.exists(["x", "k"], expressions=(), numbers=("k",))
        one, two = at(x=1, y=0), at(x=2, y=0)
        accepted(goal, Regardless(0, ((decode(1), one), (decode(-1), two))), sign=False)
        for weights in ((1, 1), (1, -2), (0, 0), ("x", -1), (["sqrt", 2], minus(["sqrt", 2]))):
            points = tuple(zip(map(decode, weights), (one, two), strict=True))
            denial_rejected(goal, Regardless(0, points))
        denial_rejected(goal, Regardless(0, ()))
        free = replace(goal, expressions=("k",), numbers=())
        denial_rejected(free, Regardless(0, ((decode(1), one), (decode(-1), two))), "may hold")

    def test_a_denial_of_an_implication(self):
        one = follows(["M", 1], given=[["x", 0]])
        denial_rejected(Exists((one,), ("M",)), Regardless(0, ((decode(1), ORIGIN),)), "identity")

    def test_what_denies_an_identity_denies_no_failure(self):
        """M x = 1 fails at the origin whatever M is, as is said."""
        one, never = follows([["*", "M", "x"], 1]), Regardless(0, ((decode(1), ORIGIN),))
        accepted(Exists((one,), ("M",)), never, sign=False)
        failure = Fails(one.space, one.conclusions)
        denial_rejected(Exists((failure,), ("M",)), never, "identity")


class TestCount:
    SPACE = Space(("x",), ("a",), nonzero=row("a"))
    GOAL = Count(SPACE, equations([SQUARE, ["^", "a", 2]]), ("x",), 2)
    ROOTS = Roots(
        root="s", form=decode("x"), eliminant=row(minus(["^", "a", 2]), 0),
        solved=((decode("x").name, decode("s"), decode(1)),), rows=(row(1), row(0)), quotients=row(1, 0),
        factors=(Factor(decode(["^", "a", 2]), ((decode(1), decode("a")),), (), (0, row(1, 0))),),
        minors=((decode(2), (0,)), (decode(4), (1,))), point=at(x=1, a=1),
    )  # fmt: skip

    def test_honest_evidence(self):
        accepted(self.GOAL, self.ROOTS)
        accepted(replace(self.GOAL, number=3), self.ROOTS, sign=False)
        rejected(replace(self.GOAL, number=3), self.ROOTS, "another number")
        denial_rejected(self.GOAL, self.ROOTS, "another number")

    @pytest.mark.parametrize(
        "change",
        [
            {"root": "x"}, {"root": "a"}, {"form": decode("a")}, {"form": decode("z")},
            {"eliminant": row(["^", "a", 2], 0)}, {"eliminant": row(minus(["^", "a", 2]))}, {"eliminant": ()},
            {"eliminant": row(minus(["^", "x", 2]), 0)}, {"solved": ()}, {"solved": (("x", decode("s"), decode(0)),)},
            {"solved": (("x", decode("a"), decode(1)),)}, {"solved": (("y", decode("s"), decode(1)),)},
            {"rows": (row(1),)}, {"rows": (row(2), row(0))}, {"rows": (row(1), row(0), row(0))}, {"rows": ((), ())},
            {"quotients": row(1)}, {"quotients": row(2, 0)}, {"quotients": ()}, {"factors": ()},
            {"minors": ((decode(2), (0,)),)}, {"minors": ((decode(-2), (0,)), (decode(4), (1,)))},
            {"minors": ((decode(2), (0,)), (decode(4), (2,)))}, {"minors": ((decode(2), ()), (decode(4), ()))},
            {"point": at(x=1, a=2)}, {"point": at(x=0, a=0)}, {"point": at(a=1)}, {"point": None}, {"minors": None},
        ],
    )  # fmt: skip
    def test_a_part_changed(self, change):
        rejected(self.GOAL, self.ROOTS._replace(**change))

    @pytest.mark.parametrize(
        "change",
        [
            {"squares": ()}, {"squares": ((decode(-1), decode("a")),)}, {"squares": ((decode(1), decode("x")),)},
            {"row": row(1)}, {"row": row(0, 0)}, {"factor": decode("a")}, {"granted": (1, row(1, 0))},
            {"granted": (0, row(2, 0))}, {"granted": (0, row(1))}, {"granted": ("x", row(1, 0))},
        ],
    )  # fmt: skip
    def test_a_factor_changed(self, change):
        (factor,) = self.ROOTS.factors
        rejected(self.GOAL, self.ROOTS._replace(factors=(factor._replace(**change),)))

    def test_a_double_root_is_not_two(self):
        goal = replace(self.GOAL, equations=equations([SQUARE, 0]))
        zero = Factor(decode(0))
        roots = self.ROOTS._replace(eliminant=row(0, 0), factors=(zero,), point=at(x=0, a=1))
        roots = roots._replace(minors=((decode(2), (0,)), (decode(1), (1,))))
        rejected(goal, roots)

    def test_rows_that_divide_by_what_may_vanish(self):
        """a x = 0 has the one solution 0, but for a = 0, where all numbers are."""
        goal = Count(Space(("x",), ("a",)), equations([["*", "a", "x"], 0]), ("x",), 1)
        roots = Roots(
            root="s", form=decode("x"), eliminant=row(0), solved=(("x", decode("s"), decode(1)),),
            rows=(row(["/", 1, "a"]), row(0)), quotients=row("a", 0), factors=(),
            minors=((decode(1), ()),), point=at(x=0, a=1),
        )  # fmt: skip
        assert accepted(goal, roots)  # for a other than zero
        one = judge()
        one.holds(goal, roots)
        assert [e for _, elements in one.accepted.divided for e in elements]
        rejected(goal, roots._replace(point=at(x=0, a=0)), "divided by")

    def test_rows_that_divide_by_what_is_counted(self):
        """x (x - 1) = 0 has two solutions; divided by x - 1 it has one."""
        goal = Count(Space(("x",), ("a",)), equations([["*", "x", plus("x", -1)], 0]), ("x",), 1)
        roots = Roots(
            root="s", form=decode("x"), eliminant=row(0), solved=(("x", decode("s"), decode(1)),),
            rows=(row(["/", 1, plus("x", -1)]), row(0)), quotients=row(plus("s", -1), 0), factors=(),
            minors=((decode(1), ()),), point=at(x=0, a=1),
        )  # fmt: skip
        rejected(goal, roots, "about what is counted")

    @given(st.integers(-3, 3), st.integers(-3, 3))
    def test_a_condition_about_what_is_counted(self, many, more):
        """Of the solutions a and -a of x^2 = a^2 one may be left out by it."""
        tree = plus("x", ["*", many, "a"], more)
        if 1 + many + more == 0:
            tree = plus(tree, 1)
        space = replace(self.SPACE, nonzero=row("a", tree))
        rejected(replace(self.GOAL, space=space), self.ROOTS, "about what is counted")
        goal = replace(
            self.GOAL, equations=equations([["/", SQUARE, tree], ["/", ["^", "a", 2], tree]])
        )
        put = decode(["/", 1, plus("s", ["*", many, "a"], more)])
        rejected(goal, self.ROOTS._replace(rows=(row(tree), row(0)), quotients=(put, decode(0))))

    def test_what_is_granted_does_not_follow_by_division(self):
        (factor,) = self.ROOTS.factors
        granted = factor._replace(granted=(0, row(["/", "a", "a"], 0)))
        accepted(self.GOAL, self.ROOTS._replace(factors=(granted,)))
        space = Space(("x",), ("a", "b"), nonzero=row("b"))
        goal = Count(space, self.GOAL.equations, ("x",), 2)
        forged = factor._replace(granted=(0, row(["/", "b", "a"], 0)))
        one = judge()
        one.holds(goal, self.ROOTS._replace(factors=(forged,), point=at(x=1, a=1, b=1)))
        assert [e for _, elements in one.accepted.divided for e in elements]  # a is a condition

    def test_complex_names(self):
        space = Space(("x",), ("a",), nonzero=row("a"), steps=(I,))
        rejected(
            replace(self.GOAL, space=space), self.ROOTS._replace(point=at(x=1, a=1, i="i")), "real"
        )

    def test_lists_of_solutions(self):
        goal = replace(self.GOAL, number=1)
        one, two = at(x=1, a=1), at(x=-1, a=1)
        accepted(goal, Solutions((one, two)), sign=False)
        for points in (
            (one,), (), (one, one), (one, at(x=2, a=1)), (one, at(x=-2, a=2)), (at(x=0, a=0), one),
            (at(x=["/", 2, 2], a=1), one), (at(a=1), one), (at(x=["sqrt", 4], a=2), at(x=-2, a=2)),
        ):  # fmt: skip
            denial_rejected(goal, Solutions(points))
        unproved(goal, Solutions((None, one)), sign=False)
        denial_rejected(self.GOAL, Solutions((one, two)), "more solutions")
        rejected(goal, Solutions((one, two)), "no evidence")


class TestMotion:
    def test_a_gap_in_the_field(self):
        space = Space(("x", "y"), field=(EquationOfMotion(("x",), decode(1), decode("y")),))
        rejected(follows([["D", "y"], 0], space=space), IDENTICALLY, "no equation of motion")
        rejected(follows([["D", "y"], 0]), IDENTICALLY, ".")

    def test_a_definition_that_moves_otherwise(self):
        rows = (EquationOfMotion(("x", "z"), decode(["vector", 1, 1]), decode(["vector", 1, 1])),)
        space = Space(("x",), steps=(Let("z", decode(0)),), field=rows)
        rejected(follows([["D", "x"], 1], space=space), IDENTICALLY, "does not move")

    def test_a_zero_divisor_among_the_roots(self):
        steps = (Adjoined("r", decode(2)), Adjoined("s", decode(8)))
        space = Space(("x",), steps=steps)
        goal = follows([["/", 1, plus("s", ["*", -2, "r"])], "x"], space=space)
        rejected(goal, IDENTICALLY, ".")


class TestKernel:
    MOTION = (
        EquationOfMotion(
            ("x", "y"), decode(["vector", 1, 1]), decode(["vector", ["*", "a", "y"], minus("x")])
        ),
    )
    SPACE = Space(("x", "y"), ("a",), field=MOTION)
    ENERGY = plus(["^", "x", 2], ["*", "a", ["^", "y", 2]])
    GOAL = Kernel(SPACE, decode(0), row(1), row(ENERGY), (1, 1), 5)
    POINT = At(at(x=1, y=2, a=3))  # fmt: skip

    def test_all_integrals_of_the_oscillator(self):
        accepted(self.GOAL, self.POINT)
        accepted(replace(self.GOAL, weights=(2, 3), degree=20), self.POINT)
        accepted(replace(self.GOAL, integrals=(), degree=1), self.POINT)
        accepted(replace(self.GOAL, factor=decode(1), solutions=(), integrals=()), self.POINT)

    @pytest.mark.parametrize(
        "change",
        [
            {"integrals": ()}, {"integrals": row(["^", ENERGY, 2])}, {"solutions": ()}, {"factor": decode("a")},
            {"integrals": row("x")}, {"integrals": row(["/", 1, ENERGY])}, {"solutions": row("y")},
            {"weights": (1, 0)}, {"weights": (1,)}, {"weights": (1, 1, 1)},
            {"degree": 10**30}, {"degree": -1}, {"weights": (2, 3), "degree": 10**9},
        ],
    )  # fmt: skip
    def test_another_statement(self, change):
        rejected(replace(self.GOAL, **change), self.POINT)

    def test_a_degree_with_too_many_monomials(self):
        unproved(replace(self.GOAL, degree=1000), self.POINT)

    def test_special_constants_show_nothing_of_others(self):
        rejected(self.GOAL, At(at(x=1, y=2, a=0)), "more")  # there y is an integral
        rejected(self.GOAL, At(at(x=1, y=2, a=["sqrt", 2])), "rational")

    @pytest.mark.parametrize("coefficient", ["a", 2**61 - 1])
    def test_degrees_are_those_for_almost_all_constants(self, coefficient):
        field = (
            EquationOfMotion(("x",), decode(1), decode(0)),
            EquationOfMotion(("y",), decode(1), decode(1)),
        )
        still = Space(("x", "y"), ("a",), field=field)
        higher = row(plus("x", ["*", coefficient, ["^", "x", 2]]))
        goal = Kernel(still, decode(0), row(1), higher, (1, 1), 1)
        fallen = at(x=1, y=2, a=0)  # where the integral is x, or so modulo the prime
        rejected(goal, At(fallen), "more")
        accepted(goal, Further(decode("x"), fallen), sign=False)
        none = replace(goal, integrals=())
        denial_rejected(none, Further(higher[0], fallen), "degree")

    def test_a_missing_integral_denies(self):
        goal = replace(self.GOAL, integrals=row(["^", self.ENERGY, 2]))
        accepted(goal, Further(decode(self.ENERGY), self.POINT.point), sign=False)
        denial_rejected(goal, Further(decode(["^", self.ENERGY, 2]), self.POINT.point), "depend")
        denial_rejected(goal, Further(decode(["^", self.ENERGY, 3]), self.POINT.point), "degree")
        denial_rejected(goal, Further(decode("x"), self.POINT.point), "no solution")
        denial_rejected(goal, self.POINT, "are solutions there")

    def test_what_is_no_integral_denies(self):
        goal = replace(self.GOAL, integrals=row(["*", "x", "y"]))
        accepted(goal, self.POINT, sign=False)
        denial_rejected(goal, At(at(x=0, y=0, a=1)), "are solutions there")
