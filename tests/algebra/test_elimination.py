"""Ranks and relations modulo a prime, by both programs, against FLINT's dense matrices."""

import random

import pytest
from flint import nmod_mat
from hypothesis import given
from hypothesis import strategies as st

from kowalevski_cas.algebra.elimination import LARGEST, PRIME, Echelon, rank, relations
from kowalevski_cas.algebra.polynomials import TooLarge
from kowalevski_cas.problem import checker
from kowalevski_cas.problem.checker import elimination
from tests.sample import sampled

full = st.lists(st.lists(st.integers(-2, 2), min_size=6, max_size=6), min_size=1, max_size=9).map(
    lambda rows: [{k: v % PRIME for k, v in enumerate(row) if v} for row in rows]
)
sparse = st.lists(
    st.dictionaries(st.integers(0, 40), st.integers(1, PRIME - 1), max_size=3), max_size=40
)
vectors = full | sparse | st.tuples(full, full).map(lambda two: two[0] + two[1] + two[0])


def by_flint(rows):
    places = sorted({place for row in rows for place in row})
    entries = [row.get(place, 0) for row in rows for place in places]
    return int(nmod_mat(len(rows), len(places), entries, PRIME).rank()) if places else 0


class Budget(checker.Budget):
    def spend(self, steps):
        assert steps >= 0


BUDGET = Budget()


@given(vectors)
def test_the_rank_is_that_of_the_dense_matrix_in_both_programs(rows):
    assert rank(rows) == elimination.rank(rows, BUDGET) == by_flint(rows)


@given(vectors)
def test_long_numbers_give_the_rank_that_single_entries_give(rows):
    assert elimination._dense_rank([row for row in rows if row], BUDGET.spend) == by_flint(rows)


@given(vectors)
def test_relations_vanish_and_each_is_of_a_vector_that_depends_on_those_before(rows):
    found = relations(rows)
    assert len(found) == len(rows) - by_flint(rows)
    echelon = Echelon()
    dependent = [k for k, row in enumerate(rows) if not echelon.extend(row)]
    assert [max(relation) for relation in found] == dependent
    for relation in found:
        assert relation[max(relation)] == 1 and not dependent_ones(relation, dependent)
        for place in {place for k in relation for place in rows[k]}:
            total = sum(value * rows[k].get(place, 0) for k, value in relation.items())
            assert total % PRIME == 0


def dependent_ones(relation, dependent):
    """The vectors of a relation, but the last, that depend on those before them."""
    return sorted({*relation} & {*dependent})[:-1]


def test_what_fills_up_is_eliminated_in_a_dense_matrix():
    rows = [{k: pow(j + 2, k, PRIME) for k in range(60)} for j in range(70)]
    assert rank(rows) == elimination.rank(rows, BUDGET) == 60
    assert len(relations(rows)) == 10


def test_what_would_take_too_much_memory_is_refused(monkeypatch):
    monkeypatch.setattr("kowalevski_cas.algebra.elimination.LARGEST", 1000)
    assert LARGEST > 1000
    rows = [{k: pow(j + 2, k, PRIME) for k in range(60)} for j in range(70)]
    with pytest.raises(TooLarge, match="60 rows and 70 columns"):
        rank(rows)


@pytest.mark.parametrize("seed", sampled(range(200), 8))
def test_vectors_of_any_density_with_dependent_ones_among_them(seed):
    """From nearly empty ones, through those that fill up on the way, to full ones."""
    chosen = random.Random(seed)
    height, width = chosen.randint(0, 70), chosen.randint(1, 70)
    density = chosen.choice([0.02, 0.05, 0.1, 0.2, 0.3, 0.6, 1])
    values = [1, 2, PRIME - 1, chosen.randrange(1, PRIME)]
    rows = [
        {k: chosen.choice(values) for k in range(width) if chosen.random() < density}
        for _ in range(height)
    ]
    for _ in range(chosen.randint(0, 15) if rows else 0):
        one, other, factor = chosen.choice(rows), chosen.choice(rows), chosen.randrange(PRIME)
        total = {k: one.get(k, 0) + factor * other.get(k, 0) for k in one.keys() | other.keys()}
        rows.insert(
            chosen.randint(0, len(rows)), {k: v % PRIME for k, v in total.items() if v % PRIME}
        )
    assert rank(rows) == elimination.rank(rows, BUDGET) == by_flint(rows)
    found = relations(rows)
    assert len(found) == len(rows) - by_flint(rows)
    for relation in found:
        for place in range(width):
            assert sum(v * rows[k].get(place, 0) for k, v in relation.items()) % PRIME == 0
