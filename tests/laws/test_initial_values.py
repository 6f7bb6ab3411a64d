"""Two solutions of one regular system with one initial value are equal; nothing less says so."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kowalevski_cas.problem import checker
from kowalevski_cas.problem.examine import Unproved
from tests.problem.judges import judged
from tests.problem.tampering import seal

small = st.integers(-3, 3)
polynomials = st.lists(small, min_size=2, max_size=5).filter(lambda c: any(c[1:]))


def polynomial(coefficients, variable="w"):
    """The tree of a polynomial."""
    return ["+", 0, *(["*", c, ["^", variable, n]] for n, c in enumerate(coefficients))]


def value(coefficients, at):
    return sum(c * at**n for n, c in enumerate(coefficients))


def derivative(coefficients):
    return [n * c for n, c in enumerate(coefficients)][1:]


def is_accepted(space, initial, equations):
    """Whether judge and checker believe that the sides are equal along the motion."""
    pairs = [[name, start] for name, start in initial.items()]
    goal = {"goal": "along", "space": 0, "initial": pairs, "equations": equations}
    data = {"format": checker.FORMAT, "version": 2, "claim": "c", "spaces": [space]}
    data |= {"goals": [goal], "sign": "holds"}
    data |= {"evidence": [{"point": {"roots": [], "values": pairs}}]}
    opinions = []
    for believes, one in ((checker.check, seal(data)), (judged, data)):
        try:
            believes(one)
            opinions.append(True)
        except (checker.Rejected, Unproved):
            opinions.append(False)
    assert len({*opinions}) == 1, "judge and checker differ"
    return opinions[0]


def field(**rates):
    return [[[name], *row] if isinstance(row, tuple) else [[name], 1, row] for name, row in rates.items()]  # fmt: skip


def curve(coefficients, start, begins, rate=None, **more):
    """The problem whether y, which begins somewhere, is a polynomial in w with w' = 1."""
    rate = polynomial(derivative(coefficients)) if rate is None else rate
    space = {"variables": ["y", "w"], "field": field(y=rate, w=1), **more}
    return space, {"y": begins, "w": start}, [["y", polynomial(coefficients)]]


@given(polynomials, small, small)
def test_a_polynomial_is_the_solution_from_its_value_and_from_no_other(p, start, off):
    problem = curve(p, start, value(p, start) + off)
    assert is_accepted(*problem) == (off == 0)


@given(polynomials, small, st.integers(1, 4), small.filter(bool))
def test_with_another_rate_it_is_none(p, start, power, factor):
    """Also if the rates agree where the motion begins."""
    other = ["*", factor, ["^", ["+", "w", -start], power]]
    rate = ["+", polynomial(derivative(p)), other]
    assert not is_accepted(*curve(p, start, value(p, start), rate))


@given(small, st.integers(1, 4), small)
def test_where_the_system_is_singular_there_are_many_solutions(start, power, factor):
    """Of (w - a) y' = n y all c (w - a)^n begin at zero."""
    shifted = ["+", "w", -start]
    space = {"variables": ["y", "w"], "field": field(y=(shifted, ["*", power, "y"]), w=1)}
    equations = [["y", ["*", factor, ["^", shifted, power]]]]
    assert not is_accepted(space, {"y": 0, "w": start}, equations)


@given(polynomials, small, small.filter(bool))
def test_a_rate_that_is_not_printed_where_the_motion_begins_is_none(p, start, factor):
    """What is divided by cancels, and is zero there all the same."""
    mass = ["*", factor, ["+", "w", -start]]
    rate = (mass, ["*", mass, polynomial(derivative(p))])
    assert not is_accepted(*curve(p, start, value(p, start), rate))


@given(small.filter(bool), st.booleans())
def test_a_rate_with_a_root_of_what_is_sought_is_not_regular(factor, printed):
    r"""Of y' = 2√y from zero w² is a solution, and zero is another one."""
    root = r"\sqrt{y}" if printed else "r"
    space = {"variables": ["y", "w"], "steps": [["root", root, "y"]]}
    space["field"] = field(y=["*", 2, factor, root], w=1)
    for start in (0, 1):
        equations = [["y", ["^", ["+", ["*", factor, "w"], start], 2]]]
        assert not is_accepted(space, {"y": start, "w": 0, root: start}, equations)


@given(st.sampled_from(["r", r"\sqrt{1-s^2}"]))
def test_a_printed_root_changes_its_sign_nowhere(root):
    """With c' = -s the cosine goes on below zero, and the root does not."""
    one = ["+", 1, ["-", ["^", "s", 2]]]
    space = {"variables": ["s", "c"], "steps": [["root", root, one]]}
    space["field"] = field(s=root, c=["-", "s"])
    assert is_accepted(space, {"s": 0, "c": 1, root: 1}, [["c", root]]) == (root == "r")


@pytest.mark.parametrize("sides", [["z", "w"], ["w", "z"]])
def test_what_rests_on_what_it_should_give_is_no_proof(sides):
    space = {"variables": ["z", "w"], "field": field(z="w", w="z")}
    assert not is_accepted(space, {"z": 1, "w": 1}, [sides])


@given(polynomials, small)
def test_a_side_that_is_not_defined_where_the_motion_begins_is_refused(p, start):
    space, initial, [[name, side]] = curve(p, start, value(p, start))
    shifted = ["+", "w", -start]
    assert not is_accepted(space, initial, [[name, ["/", ["*", shifted, side], shifted]]])
