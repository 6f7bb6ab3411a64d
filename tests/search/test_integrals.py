"""What a search for polynomial first integrals finds, and that it finds nothing else."""

from dataclasses import replace
from fractions import Fraction

import pytest
from flint import fmpq, fmpq_mat
from hypothesis import given
from hypothesis import strategies as st

from kowalevski_cas.algebra import load
from kowalevski_cas.algebra.kernels import kernel
from kowalevski_cas.algebra.polynomials import TooLarge
from kowalevski_cas.algebra.present import formula_in
from kowalevski_cas.notation import Number, to_latex
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.problem import residues
from kowalevski_cas.problem.accept import Judge, Unproved
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.evidence import At, Point
from kowalevski_cas.problem.goals import Kernel
from kowalevski_cas.problem.polynomial_fields import PolynomialField, monomials
from kowalevski_cas.problem.residues import ResidueField
from kowalevski_cas.problem.space import EquationOfMotion, Meaningless, Space
from kowalevski_cas.problem.trees import decode
from kowalevski_cas.search import integrals
from kowalevski_cas.search.integrals import first_integrals
from tests.laws.systems import (
    EULER,
    HENON_HEILES,
    KEPLER,
    LAGRANGE,
    LORENZ,
    NAHM,
    PENDULUM,
    TODA,
    VOLTERRA,
)


def evaluation(system):
    derivation = system.derivation()
    return Elaborations(derivation.texts())(derivation.scenes()[0]).finder


def found(system, degree):
    at = evaluation(system)
    elements = list(first_integrals(at, degree))
    assert all(at.derivative(element).is_zero for element in elements)
    return [to_latex(formula_in(element)) for element in elements]


@pytest.mark.parametrize(
    ("system", "degree", "expected"),
    [
        (EULER, 3, ["p^2A + q^2B + r^2C", "p^2A^2 + q^2B^2 + r^2C^2"]),
        (HENON_HEILES, 4, ["6x^2y + 3x^2 - 2y^3 + 3y^2 + 3u^2 + 3v^2"]),
        (PENDULUM, 4, ["2c - w^2", "c^2 + s^2"]),
        (VOLTERRA, 4, ["x + y + z", "xyz"]),
        (NAHM, 4, ["x^2 - y^2", "x^2 - z^2"]),
        (LORENZ, 3, []),
    ],
    ids=lambda value: getattr(value, "name", None),
)
def test_all_integrals_that_do_not_follow_from_others(system, degree, expected):
    assert found(system, degree) == expected


@pytest.mark.parametrize(("system", "count"), [(TODA, 3), (LAGRANGE, 4)], ids=["Toda", "Lagrange"])
def test_as_many_as_there_are(system, count):
    assert len(found(system, 3)) == count


def test_the_integrals_of_the_two_field_top(derivation):
    scene = next(one for one in derivation.scenes() if one.name == "Kowalevski case")
    at = Elaborations(derivation.texts())(scene).finder
    elements = list(first_integrals(at, 4))
    assert all(at.derivative(element).is_zero for element in elements)
    assert len(elements) == 6  # those of the two fields, and H, K, G
    weights = PolynomialField(at).gradings[0]
    assert weights == (1, 1, 1, 2, 2, 2, 2, 2, 2, 1)
    assert len(list(first_integrals(at, 6, weights[:-1]))) == 6


@pytest.mark.parametrize("system", [EULER, HENON_HEILES, LORENZ, VOLTERRA])
def test_several_weights_are_solved_at_once_or_one_by_one_with_the_same_result(system, monkeypatch):
    at_once = found(system, 4)
    monkeypatch.setattr(integrals, "GROWTH", 1)
    assert found(system, 4) == at_once
    monkeypatch.setattr(integrals, "GROWTH", 10**6)
    weights = list[int]()

    def solve(search, first, last):
        if first < last:
            raise TooLarge("both")
        weights.append(last)
        return one_by_one(search, first, last)

    one_by_one = integrals._IntegralSearch._solve
    monkeypatch.setattr(integrals._IntegralSearch, "_solve", solve)
    assert found(system, 4) == at_once and weights == [0, 1, 2, 3, 4][-len(weights) :]


def test_the_dimension_that_a_search_has_found_is_that_of_the_kernel():
    at, ones = evaluation(TODA), (1,) * len(TODA.variables)
    list(first_integrals(at, 4))
    ((_, by_search),) = residues._dimensions.items()
    residues._dimensions.clear()
    assert residues.dimension(ResidueField(PolynomialField(at).rates, {}), ones, 4) == by_search


def test_a_field_with_roots_is_refused():
    with pytest.raises(Meaningless, match="a root stands in the equations of motion"):
        found(KEPLER, 2)


@given(st.lists(st.lists(st.integers(-3, 3), min_size=3, max_size=3), min_size=1, max_size=5))
def test_a_kernel_vanishes_and_has_the_right_dimension(rows):
    columns = [{k: Fraction(v) for k, v in enumerate(row) if v} for row in rows]
    vectors = kernel(columns)
    for vector in vectors:
        for k in range(3):
            assert sum(c * column.get(k, 0) for c, column in zip(vector, columns, strict=True)) == 0
    assert len(vectors) == len(rows) - _rank([*map(list, rows)])


def _rank(rows):
    rank = 0
    for column in range(3):
        pivot = next((row for row in rows[rank:] if row[column]), None)
        if pivot is None:
            continue
        rows.remove(pivot)
        rows.insert(rank, pivot)
        for row in rows[rank + 1 :]:
            factor = Fraction(row[column], pivot[column])
            row[:] = [a - factor * b for a, b in zip(row, pivot, strict=True)]
        rank += 1
    return rank


VARIABLES = ("x", "y", "z")
small = st.integers(-2, 2)
terms = st.lists(st.tuples(st.tuples(*[st.integers(0, 2)] * 3), small), min_size=1, max_size=3)


def tree(polynomial):
    products = [
        ["*", v, *(["^", n, e] for n, e in zip(VARIABLES, p, strict=True))] for p, v in polynomial
    ]
    return decode(["+", 0, *products])  # fmt: skip


@given(st.tuples(terms, terms, terms), st.integers(1, 3))
def test_as_many_as_the_rank_over_the_rational_numbers_leaves(components, degree):
    """All integrals are found, and with one less the certificate is refused."""
    field = tuple(
        EquationOfMotion((n,), Number(1), tree(c))
        for n, c in zip(VARIABLES, components, strict=True)
    )
    space = Space(VARIABLES, field=field)
    at = Evaluation(space, load("flint"))
    found = tuple(formula_in(element) for element in first_integrals(at, degree))
    own = PolynomialField(at)
    powers = [e for d in range(degree + 1) for e in monomials((1, 1, 1), d)]
    columns = [own.derivative(e) for e in powers]
    rows = sorted({key for column in columns for key in column})
    entries = [
        [fmpq(c[r].numerator, c[r].denominator) if r in c else 0 for c in columns] for r in rows
    ]
    nullity = len(powers) - (fmpq_mat(entries).rank() if rows else 0)
    goal = Kernel(space, Number(0), (Number(1),), found, (1, 1, 1), degree)
    names = {name: Number(3 + k) for k, name in enumerate(VARIABLES)}
    Judge(lambda _: at).holds(goal, At(Point(names)))
    assert (nullity == 1) == (not found)
    if found:
        with pytest.raises(Unproved, match="more polynomials"):
            Judge(lambda _: at).holds(replace(goal, integrals=found[:-1]), At(Point(names)))  # fmt: skip
