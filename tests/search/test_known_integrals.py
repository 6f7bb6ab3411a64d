"""An integral that was found is called by its name, or shortened, and says the same."""

from fractions import Fraction

from hypothesis import assume, given
from hypothesis import strategies as st

from kowalevski_cas.search.known_integrals import degree, name_of, products, shorten

SIZE = 2
monomials = st.tuples(st.integers(0, 2), st.integers(0, 2), st.integers(0, 1))
numbers = st.integers(-3, 3).filter(bool).map(Fraction)
polynomials = st.dictionaries(monomials, numbers, min_size=1, max_size=4).filter(
    lambda terms: degree(terms, SIZE) > 0
)
X, Y = ({(1, 0, 0): Fraction(1)}, {(0, 1, 0): Fraction(1)})


def plus(one, other, ratio):
    """A polynomial and a multiple of another one."""
    exponents = {*one, *other}
    values = {e: one.get(e, Fraction(0)) + ratio * other.get(e, Fraction(0)) for e in exponents}
    return {e: value for e, value in values.items() if value}


@given(polynomials, polynomials, numbers, numbers)
def test_a_combination_with_products_of_known_ones_has_the_name(found, known, ratio, more):
    """A multiple of what is found, and of every product: if it is no such combination itself."""
    beside = [*products([known], degree(found, SIZE), SIZE)]
    assume(name_of(found, [known], {"itself": found}, SIZE))
    named = plus({}, found, ratio)
    for product in beside:
        named = plus(named, product, more)
    assume(degree(named, SIZE) == degree(found, SIZE))
    assert name_of(found, [known], {"N": named}, SIZE) == "N"


def test_what_is_of_products_alone_is_no_name():
    square = {(2, 0, 0): Fraction(1)}
    assert name_of({(0, 2, 0): Fraction(1)}, [X], {"N": square}, SIZE) == ""
    assert (
        name_of(
            plus(square, {(0, 2, 0): Fraction(1)}, 3), [X], {"N": {(0, 2, 0): Fraction(2)}}, SIZE
        )
        == "N"
    )


@given(polynomials, st.lists(polynomials, max_size=2))
def test_what_is_shortened_says_the_same_in_no_more_terms(found, known):
    shorter = shorten(found, known, SIZE)
    assert len(shorter) <= len(found)
    assert all(value.denominator == 1 for value in shorter.values())
    if shorter:
        same = name_of(found, known, {"same": shorter}, SIZE)
        inside = not name_of(found, known, {"itself": found}, SIZE)
        assert same == "same" or inside or degree(shorter, SIZE) < degree(found, SIZE)
