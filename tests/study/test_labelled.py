from __future__ import annotations

from collections import Counter

import pytest

from study.labelled import MISPRINT, TRUE, ArithmeticDisagreement, labelled_set, spread


@pytest.fixture(scope="module")
def statements():
    return labelled_set(1, ["kharlamov2002"])


@pytest.mark.slow
@pytest.mark.parametrize("many", [1, pytest.param(None, marks=pytest.mark.slow)])
def test_every_identity_is_true_and_every_misprint_is_false(statements, many):
    assert {s.truth for s in [s for s in statements if s.kind == TRUE][:many]} == {True}
    assert {s.truth for s in [s for s in statements if s.kind == MISPRINT][:many]} == {False}
    assert Counter(s.kind for s in statements)[TRUE] > 25


@pytest.mark.slow
@pytest.mark.parametrize("many", [2, pytest.param(8, marks=pytest.mark.slow)])
def test_there_are_near_misses_of_each_kind_and_hardly_one_is_true(statements, many):
    kinds = {s.kind for s in statements} - {TRUE, MISPRINT, "mutant"}
    assert kinds == {
        "coefficient off by 10^-20", "coefficient off by 2^61-1", "vanishes at small integers",
        "vanishes at real points", "true only for a=b", "wrong branch of a root",
    }  # fmt: skip
    for kind in kinds:
        labels = [s.truth for s in spread([s for s in statements if s.kind == kind], many)]
        assert not all(labels)


@pytest.mark.slow
def test_a_spread_takes_as_many_true_as_false_and_every_kind(statements):
    few = spread(statements, 20)
    assert len(few) == 20 and sum(s.kind == TRUE for s in few) == 10
    assert {s.kind for s in few} == {s.kind for s in statements}


@pytest.mark.slow
def test_a_disagreement_of_exact_arithmetics_is_an_error(statements):
    statement = statements[0]
    statement.__dict__["verdicts"] = {"flint": True, "sympy": False}
    with pytest.raises(ArithmeticDisagreement, match="'sympy': False"):
        _ = statement.truth
    del statement.__dict__["verdicts"]
