"""Combinations whose coefficients are solved for."""

from flint import Ordering, fmpq_mpoly_ctx
from hypothesis import assume, given
from hypothesis import strategies as st

from kowalevski_cas.search.ansatz import combination, multiple

CONTEXT = fmpq_mpoly_ctx.get(("x", "y", "z"), Ordering.lex)
X, Y, Z = CONTEXT.gens()

QUADRICS = [X * X, X * Y, X * Z, Y * Y, Y * Z, Z * Z]


def form(monomials, coefficients):
    total = CONTEXT.constant(0)
    for monomial, coefficient in zip(monomials, coefficients, strict=True):
        total += monomial * coefficient
    return total


def forms(monomials):
    return st.lists(st.integers(-3, 3), min_size=len(monomials), max_size=len(monomials)).map(
        lambda coefficients: form(monomials, coefficients)
    )


@given(st.lists(forms(QUADRICS), min_size=2, max_size=3), st.data())
def test_what_is_a_combination_of_forms_is_found_to_be_one(generators, data):
    assume(all(not g.is_zero() for g in generators))
    target = CONTEXT.constant(0)
    for generator in generators:
        target += generator * data.draw(forms([X, Y, Z]))
    found = combination(target, generators)
    assert found is not None
    assert (
        sum((c * g for c, g in zip(found, generators, strict=True)), CONTEXT.constant(0)) == target
    )


def test_what_is_none_is_not():
    assert combination(X * X, [X * Y, Y * Z]) is None
    assert combination(X * X + Y * Y, [X * X + Z * Z, Y * Z]) is None


def test_without_weights_it_ends_without_an_answer():
    assert combination(X, [X * X + 1, Y]) is None


WIDER = fmpq_mpoly_ctx.get(("a", "x", "b", "y", "z", "c"), Ordering.lex)


@given(forms(QUADRICS), st.lists(forms(QUADRICS), min_size=1, max_size=3), st.integers(0, 1))
def test_variables_that_do_not_occur_change_nothing(target, generators, degree):
    assume(all(not g.is_zero() for g in (target, *generators)))

    def wider(one):
        return one.compose(*(WIDER.gens()[k] for k in (1, 3, 4)), ctx=WIDER)

    found = multiple(target, generators, degree)
    again = multiple(wider(target), [*map(wider, generators)], degree)
    assert (found is None) == (again is None)
    if found is not None:
        assert again == (wider(found[0]), [*map(wider, found[1])])
