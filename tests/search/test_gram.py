"""Sums of squares times weights: exact ones, and no more unknowns than can be looked for."""

from math import prod

import pytest
from flint import Ordering, fmpq_mpoly_ctx

from kowalevski_cas.algebra.polynomials import TooLarge
from kowalevski_cas.limits import time_limit
from kowalevski_cas.processes import each
from kowalevski_cas.search.gram import GramEquations
from kowalevski_cas.search.weighted_squares import represent


def letters(size):
    return fmpq_mpoly_ctx.get(tuple(f"x{k}" for k in range(size)), Ordering.deglex).gens()


def test_a_square_is_found():
    pytest.importorskip("clarabel")
    x, y = letters(2)
    assert represent((x - 2 * y) ** 2, []) is not None
    assert represent(-((x - 2 * y) ** 2), []) is None


@pytest.mark.parametrize(
    ("size", "power", "weights", "known"),
    [(40, 2, 0, 1), (9, 7, 0, 0), (20, 3, 12, 0), (3, 60, 0, 1), (8, 3, 8, 3)],
)
def test_what_has_too_many_unknowns_is_not_begun(size, power, weights, known):
    gens = letters(size)
    target = (1 + sum(gens)) ** 2 * prod(gens[:1]) ** (2 * power - 2) + gens[-1] ** (2 * power)
    with pytest.raises(TooLarge):
        GramEquations(target, gens[:weights], [target + 1] * known or [], 2)


def test_a_process_that_has_searched_leaves_copies_of_it_free_to_search():
    """Threads do not survive a fork: a copy would wait for them until its time is over."""
    pytest.importorskip("clarabel")
    x, y = letters(2)
    squares = [(x - 2 * y) ** 2 + y**2 + 1, x**2 + y**2 + 1]

    def search(place):
        with time_limit(30):
            return represent(squares[place] ** 6, []) is None

    here = [search(place) for place in (0, 1)]
    assert [*each(search, (0, 1))] == here
