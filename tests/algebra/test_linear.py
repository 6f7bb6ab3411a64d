"""Linear systems over a tower of roots."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kowalevski_cas.algebra.linear import Singular, determinant, inverse, solve
from tests.algebra.strategies import build, simple, tower

RING = tower("flint")
entries = st.one_of(st.just(({}, [])), simple).map(lambda neutral: build(RING, neutral))


def square(size, values=entries):
    return st.lists(st.lists(values, min_size=size, max_size=size), min_size=size, max_size=size)


def product(left, right):
    columns = [*zip(*right, strict=True)]
    return [
        [sum((a * b for a, b in zip(row, column, strict=True)), RING.zero) for column in columns]
        for row in left
    ]


@given(st.integers(1, 2).flatmap(lambda size: st.tuples(square(size), square(size))))
def test_what_solves_a_system_solves_it_or_the_determinant_is_zero(matrices):
    matrix, right = matrices
    if determinant(matrix).is_zero:
        with pytest.raises(Singular):
            solve(matrix, right)
        return
    found = product(matrix, solve(matrix, right))
    for row, wanted in zip(found, right, strict=True):
        assert all((a - b).is_zero for a, b in zip(row, wanted, strict=True))


@given(square(4, st.integers(-2, 2).map(RING.number)))
def test_a_matrix_times_its_inverse_is_one(matrix):
    if determinant(matrix).is_zero:
        with pytest.raises(Singular):
            inverse(matrix)
        return
    for k, row in enumerate(product(inverse(matrix), matrix)):
        assert all((value - RING.number(int(j == k))).is_zero for j, value in enumerate(row))
