"""Derivatives that close: the sets that they leave invariant, and the equations that they obey."""

from dataclasses import replace
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kowalevski_cas.algebra.present import formula_in
from kowalevski_cas.notation import to_latex
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.problem.place import PointEvaluation
from kowalevski_cas.search.closure import closures
from kowalevski_cas.search.follows import rows_of
from tests.laws.systems import (
    EULER,
    HENON_HEILES,
    LAGRANGE,
    LORENZ,
    NAHM,
    OSCILLATOR,
    PENDULUM,
    SPECIAL_LORENZ,
    System,
    identity,
)


def closed(space, tex, order=4):
    """The closures of a function, which are checked to be closures."""
    at = space.finder
    found = [*closures(at, at.scalar(space.formula(tex)), order)]
    for one in found:
        total = sum((c * f for c, f in zip(one.row, one.chain, strict=True)), at.ring.zero)
        assert (at.derivative(one.chain[-1]) - total).is_zero
        there = PointEvaluation(at, one.point)
        assert there.vanish(one.chain) and there.defines(one.row)
        assert all(at.derivative(integral).is_zero for integral in one.integrals())
    return found


def space_of(system):
    derivation = replace(system, statements=(identity("1=1"),)).derivation()
    return Elaborations(derivation.texts())(derivation.scenes()[0])


@pytest.mark.parametrize(
    ("system", "seed", "row"),
    [
        (SPECIAL_LORENZ, r"x^2-2\sigma z", [r"-2\sigma"]),
        (LORENZ, "x", [r"-z\sigma + \sigma\rho - \sigma", r"-\sigma - 1"]),
        (HENON_HEILES, "x", ["-2y - 1", "0"]),
        (PENDULUM, "c+w^2", ["0", "-4c - w^2", "0"]),
        (NAHM, "x-y", ["-z"]),
        (LAGRANGE, "g_3", ["0", "-p^2 - q^2 - r^2C^2 - 4g_3", "0"]),
        (OSCILLATOR, "x^3", ["-9", "0", "-10", "0"]),
    ],
)
def test_the_shortest_chain_that_needs_no_condition(system, seed, row):
    *_, last = closed(space_of(system), seed)
    assert [to_latex(formula_in(entry)) for entry in last.row] == row


def test_what_does_not_close_or_is_never_zero_gives_nothing():
    assert closed(space_of(HENON_HEILES), "y", 3) == []
    assert closed(space_of(OSCILLATOR), "x^2+1") == []


def test_a_shorter_chain_has_a_condition():
    first, last = closed(space_of(OSCILLATOR), "xy")
    assert [entry.denominator != {} for entry in first.row] == [True, True]
    assert first.is_regular() and not last.is_regular()
    assert len(last.row) == 3


def test_what_a_motion_is_divided_by_is_no_condition():
    (only,) = closed(space_of(EULER), "p")
    assert len(only.row) == 2


@pytest.mark.parametrize(
    ("system", "seed", "integral"),
    [(OSCILLATOR, "x", "-x^2 - u^2"), (OSCILLATOR, "xy", "2xy + 2uv")],
)
def test_the_integral_of_an_equation_with_constant_coefficients(system, seed, integral):
    *_, last = closed(space_of(system), seed)
    assert last.is_constant()
    assert [to_latex(formula_in(one)) for one in last.integrals()] == [integral]


PARAMETRIC = System(
    "a linear equation of the second order, and two solutions of it",
    (
        r"\dot x=u",
        r"\dot u=cx",
        r"\dot y=v",
        r"\dot v=cy",
        r"\dot c=-sw",
        r"\dot s=cw",
        r"\dot w=0",
    ),
    ("x", "u", "y", "v", "c", "s", "w"),
    (),
)


DEAR = ("x", "x^2+y^2", "x^3", "xy^2", "x^3+y^3", "x^2y^2")
SLOW = (pytest.param(seed, marks=pytest.mark.slow) for seed in DEAR)


@pytest.mark.parametrize("seed", ["xy", "x^2", *SLOW])
def test_products_of_solutions_obey_the_symmetric_power(seed):
    *_, last = closed(space_of(PARAMETRIC), seed, 5)
    assert to_latex(formula_in(last.power())) == "c"
    integrals = [*last.integrals()]
    assert len(integrals) == (seed in ("xy", "x^2+y^2", "x^2y^2"))


def test_invariant_relations_of_the_paper_from_their_first_function_alone(derivation):
    on = Elaborations(derivation.texts(derivation.corrected()))
    scenes = {scene.name: scene for scene in derivation.scenes()}
    seed = r"\theta\omega_3-Q_1"
    first, last = closed(on(scenes["complex variables"]), seed)
    # Off θ = 0 the first set is (15).
    root = on(scenes["complex variables with the root"])
    at = root.finder
    f = at.scalar(root.formula(seed))
    pair = [f, at.derivative(f)]
    F = [at.scalar(root.formula(name)) for name in ("F_1", "F_2")]
    roots = {"x_1", "x_2"}
    for targets, generators in ((pair, F), (F, pair)):
        rows, _ = rows_of(targets, generators)
        divisors = at.ring.divisors_of(entry for row in rows for entry in row)
        assert {to_latex(formula_in(divisor)) for divisor in divisors} <= roots
    assert [to_latex(formula_in(d)) for d in first.chain[0].ring.divisors_of(first.row)] == ["x_1"]
    # With the second derivative the set is invariant without that condition.
    assert len(last.row) == 3 and not any(entry.denominator for entry in last.row)
    assert to_latex(formula_in(last.power())) == (r"\frac{2y_1 + 2y_2 + 4w_1w_2 + \omega_3^2}{16}")
    assert len([*last.integrals()]) == 1


SIZE = 3
entries = st.lists(st.integers(-2, 2), min_size=SIZE, max_size=SIZE)


@given(st.lists(entries, min_size=SIZE, max_size=SIZE))
def test_a_coordinate_of_a_linear_system_closes_with_constant_coefficients(matrix):
    names = ("x", "y", "z")
    sums = ("+".join(f"({a}){n}" for a, n in zip(row, names, strict=True)) for row in matrix)
    motion = tuple(rf"\dot {name}={total}" for name, total in zip(names, sums, strict=True))
    *_, last = closed(space_of(System("a linear system", motion, names, ())), "x", SIZE)
    assert last.is_constant()
    assert _annihilates([-_number(entry) for entry in last.row], matrix)


def _number(entry):
    return sum(entry.terms().get(0, {}).values())


def _annihilates(polynomial, matrix):
    """Whether a monic polynomial in a matrix vanishes on the first coordinate."""
    row = [Fraction(k == 0) for k in range(SIZE)]
    total = [Fraction(0)] * SIZE
    for coefficient in (*polynomial, 1):
        total = [a + coefficient * b for a, b in zip(total, row, strict=True)]
        row = [sum(row[i] * matrix[i][k] for i in range(SIZE)) for k in range(SIZE)]
    return not any(total)
