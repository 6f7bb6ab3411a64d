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


@given(st.lists(st.booleans(), min_size=4, max_size=4))
def test_what_a_zero_was_divided_by_is_kept(inverted):
    """The second row takes the first one away, which is not zero everywhere."""
    x = RING.generator(RING.names[0])
    hidden = [RING.zero * x.inverse() if one else RING.zero for one in inverted]
    one = RING.one
    first, second = [one, hidden[0]], [one, one]
    found = solve([first, second], [[hidden[1], hidden[2]], [one, hidden[3]]])
    for column, needed in enumerate(((0, 1), (0, 2, 3))):
        divided = {key for row in found for key in row[column].denominator}
        assert bool(divided) == any(inverted[k] for k in needed)
