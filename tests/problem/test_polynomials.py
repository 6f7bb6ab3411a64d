"""The polynomials of the checker, compared with their values at a point modulo a prime."""

from fractions import Fraction
from math import gcd, prod

from hypothesis import given
from hypothesis import strategies as st

from kowalevski_cas.problem.checker import Budget, Ring, quotient
from kowalevski_cas.problem.checker.division import primitive

PRIME = 2**61 - 1
R, S = 987_654_321, 123_123_123
Y = R * R * pow(3, -1, PRIME) % PRIME
X = 5 * S * S * Y * pow(R, -1, PRIME) % PRIME
INVERSES = {"u": pow(X - 2 * Y + X * Y + 3, -1, PRIME), "v": pow(Y, -1, PRIME)}
POINT = {"x": X, "y": Y, "r": R, "s": S, "t": -3, **INVERSES}
"""Where the roots r² = 3 y, s² = x r v / 5 and t² = 9 have values, v = 1/y and u = 1/(x - 2 y + x y + 3)."""

numbers = st.fractions(max_denominator=60) | st.integers(-(10**200), 10**200).map(Fraction)
polynomials = st.lists(st.tuples(numbers, st.lists(st.sampled_from("xy"), max_size=4)), max_size=4)
sums = st.lists(st.tuples(numbers, st.lists(st.sampled_from("xyrstuv"), max_size=5)), max_size=6)
without_s = st.lists(
    st.tuples(numbers, st.lists(st.sampled_from("xyrtuv"), max_size=5)), max_size=6
)


def ring():
    """Polynomials in x and y, these inverses and these roots."""
    found = Ring(Budget(10**9))
    x, _, y, r, *_ = (found.adjoin(name) for name in "xuyrvst")
    found.invert("u", x - y * found.number(2) + x * y + found.number(3))
    found.invert("v", y)
    found.relate("r", y * found.number(3))
    found.relate("s", x * r * found.generator("v") * found.number(Fraction(1, 5)))
    found.relate("t", found.number(9))
    return found


def element(here, terms):
    parts = (here.product([here.number(c), *map(here.generator, names)]) for c, names in terms)
    return here.total(parts)


def residue(number):
    return number.numerator * pow(number.denominator, -1, PRIME) % PRIME


def value(found):
    """The value at the point; on the way, what an element says of itself has to be true."""
    powers, under = {m: found.ring.exponents(m) for m in found.terms}, found.under
    assert all(found.terms.values())
    assert all(e == 1 for both in powers.values() for name, e in both if name in "rst")
    assert "v" not in {name for both in powers.values() for name, _ in both}  # y is a monomial
    assert found.below > 0
    assert all(n.bit_length() <= found.bits for n in (found.below, *found.terms.values()))
    assert {name for name, _ in found.ring.exponents(under)} <= INVERSES.keys()
    over = prod(POINT[n] ** e for n, e in found.ring.exponents(under))
    terms = (c * prod(POINT[n] ** e for n, e in powers[m]) for m, c in found.terms.items())
    return sum(terms) * over * pow(found.below, -1, PRIME) % PRIME


@given(sums)
def test_a_sum_of_products(terms):
    expected = sum(residue(c) * prod(POINT[name] for name in names) for c, names in terms)
    assert value(element(ring(), terms)) == expected % PRIME


@given(st.lists(sums, max_size=4), st.lists(st.integers(-9, 9), min_size=4, max_size=4))
def test_products_and_combinations(lists, counts):
    here = ring()
    found = [element(here, terms) for terms in lists]
    values = [*map(value, found)]
    assert value(here.product(found)) == prod(values) % PRIME
    combined = here.combination([*zip(counts, found, strict=False)], below=7)
    expected = sum(c * v for c, v in zip(counts, values, strict=False)) * pow(7, -1, PRIME)
    assert value(combined) == expected % PRIME


@given(sums, sums)
def test_differences_powers_and_norms(left, right):
    here = ring()
    a, b = element(here, left), element(here, right)
    assert value(a - b) == (value(a) - value(b)) % PRIME
    assert value(-a) == -value(a) % PRIME
    assert value(a**3) == value(a) ** 3 % PRIME
    above, norm = b.normed()
    assert value(above) * value(b) % PRIME == value(norm)
    assert not {*"rst"} & {*norm.generators()}


@given(polynomials, polynomials, polynomials)
def test_a_quotient_is_exact(left, right, rest):
    here = ring()
    a, b, c = (element(here, terms) for terms in (left, right, rest))
    if not b.terms:
        return
    content, b = primitive(b)
    assert (element(here, right) - here.number(content) * b).vanishes()
    assert gcd(*b.terms.values()) == 1 and b.below == 1
    assert (quotient(a * b, b) - a).vanishes()
    found = quotient(a * b + c, b)
    assert found is None or (found * b - a * b - c).vanishes()


@given(sums)
def test_what_is_cleared_has_all_divisors_below_it(terms):
    found = element(ring(), terms)
    cleared = found.cleared()
    assert value(cleared) == value(found)
    names = {name for m in cleared.terms for name, _ in cleared.ring.exponents(m)}
    assert names.isdisjoint(INVERSES) and {*cleared.generators()} == {*found.generators()}
    assert cleared.vanishes() == found.vanishes() == (not cleared.terms)


@given(without_s, without_s)
def test_the_derivative_of_a_product(left, right):
    here = ring()
    a, b = element(here, left), element(here, right)
    u = here.generator("u")

    def derivative(found):
        change = here.number(1) + here.generator("y")
        return found.partial("x") - found.partial("u") * u * u * change

    assert (derivative(a * b) - derivative(a) * b - a * derivative(b)).vanishes()
    assert (derivative(a + b) - derivative(a) - derivative(b)).vanishes()


@given(sums, sums)
def test_what_is_zero_has_no_terms(left, right):
    here = ring()
    a, b = element(here, left), element(here, right)
    assert ((a + b) * (a - b) - a * a + b * b).vanishes()
    for name, divisor in here.divisors.items():
        assert (a * divisor * here.generator(name) - a).vanishes()


@given(
    st.sampled_from([0, 1, Fraction(4, 9)]), st.lists(st.integers(-2, 2), min_size=2, max_size=5)
)
def test_products_with_divisors_of_zero(square, shifts):
    here = Ring(Budget(10**9))
    x, s = here.adjoin("x"), here.adjoin("s")
    here.relate("s", here.number(square))
    root = here.number(Fraction(2, 3) if square == Fraction(4, 9) else square)
    factors = [s - root, *(x + here.number(n) for n in shifts), s + root, x]
    assert not here.product(factors).terms
    assert not here.product(reversed(factors)).terms
