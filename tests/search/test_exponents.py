"""Kowalevski exponents, against published ones and laws."""

from collections import Counter
from fractions import Fraction
from itertools import combinations_with_replacement

import pytest
from flint import fmpq, fmpq_mat
from hypothesis import given, settings
from hypothesis import strategies as st

from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.texts import Texts
from kowalevski_cas.paper.vocabulary import vocabulary
from kowalevski_cas.problem.polynomial_fields import PolynomialField
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.search.exponents import LeadingPart, pseudo_remainder, weights_of_leading_terms
from kowalevski_cas.system import System
from tests.sample import sampled

EULER = r"\dot x=yz,\quad \dot y=-2zx,\quad \dot z=xy"
KOWALEVSKI = (
    r"2\dot p=qr,\; 2\dot q=-pr-\gamma_3,\; \dot r=\gamma_2,\; \dot\gamma_1=r\gamma_2-q\gamma_3,\;"
    r"\dot\gamma_2=p\gamma_3-r\gamma_1,\; \dot\gamma_3=q\gamma_1-p\gamma_2"
)
TODA = r"\dot a=2a(v-u),\; \dot b=2b(w-v),\; \dot u=2a,\; \dot v=2b-2a,\; \dot w=-2b"
LORENZ = r"\dot x=\sigma(y-x),\quad \dot y=\rho x-y-xz,\quad \dot z=xy-bz"


def henon_heiles(ratio, cubic):
    return rf"\ddot x=-x-2xy,\quad \ddot y=-{ratio}y-x^2-{cubic}y^2"


def space_of(field, letter=r"\mu"):
    scene = System(field).scene.having(constants=(letter,))
    return Elaborations(Texts(vocabulary((scene,))))(scene)


def found(field):
    part = LeadingPart(space_of(field).finder, r"\mu")
    return part, [*part.balances()]


@pytest.mark.parametrize(
    ("field", "weights", "exponents"),
    sampled(
        [
            (EULER, "1 1 1", ["-1 2 2", "-1 2 2"]),
            (LORENZ, "1 2 2", ["-1 2 4"]),
            (r"\ddot x=6x^2", "2 3", ["-1 6"]),
            (r"\ddot x=2x^3+x", "1 2", ["-1 4", "-1 4"]),
            (r"\ddot x=x^5", "1/2 3/2", ["-1 3"]),
            (henon_heiles(1, 1), "2 2 3 3", ["-1 2 3 6", "-1 -1 6 6"]),
            (henon_heiles(1, 6), "2 2 3 3", ["-3 -1 6 8", "-1 1 4 6"]),
            (henon_heiles(16, 16), "2 2 3 3", ["-7 -1 6 12", "-1 3/2 7/2 6"]),
            (TODA, "2 2 1 1 1", ["-1 1 1 2 3", "-1 1 1 2 3", "-2 -1 1 2 3"]),
            (KOWALEVSKI, "1 1 1 2 2 2", ["-1 0 1 2 3 4", "-1 -1 2 2 3 4", "-1 0 1 2 3 4"]),
        ],
        5,
    ),
)
def test_published_exponents(field, weights, exponents):
    part, balances = found(field)
    assert " ".join(map(str, part.weights)) == weights
    assert all(not one.factors for one in balances)
    computed = [" ".join(map(str, one.exponents)) for one in balances]
    assert {*computed} == {" ".join(sorted(one.split(), key=Fraction)) for one in exponents}
    for one in balances:
        rest = [*one.exponents]
        rest.remove(-1)
        assert one.is_principal() == all(own >= 0 and own.denominator == 1 for own in rest)


def test_exponents_that_depend_on_constants_are_factors():
    part, balances = found(r"\ddot x=-x-2xy,\quad \ddot y=-y-x^2-cy^2")
    for one in balances:
        assert one.exponents == (-1, 6)
        assert not one.is_principal()
    rho, c = part.exponent, part.context.gens()[1 + part.names.index("c")]
    factors = {str(f / f.leading_coefficient()) for one in balances for f in one.factors}
    expected = (rho**2 - 5 * rho + 12 - 6 * c, c * rho**2 - 5 * c * rho + 6 * c - 12)
    assert factors == {str(f / f.leading_coefficient()) for f in expected}


@pytest.mark.parametrize(
    ("field", "integral", "weight"),
    sampled(
        [
            (EULER, "2x^2+y^2", 2),
            (EULER, "x^2-z^2", 2),
            (KOWALEVSKI, r"2p^2+2q^2+r^2-2\gamma_1", 2),
            (KOWALEVSKI, r"2p\gamma_1+2q\gamma_2+r\gamma_3", 3),
            (KOWALEVSKI, r"\gamma_1^2+\gamma_2^2+\gamma_3^2", 4),
            (KOWALEVSKI, r"(p^2-q^2+\gamma_1)^2+(2pq+\gamma_2)^2", 4),
            (TODA, "u^2+v^2+w^2+2a+2b", 2),
        ],
        3,
    ),
)
def test_the_weight_of_an_integral_is_an_exponent_where_its_differential_does_not_vanish(
    field, integral, weight
):
    space = space_of(field)
    value = space.finder.scalar(space.formula(integral))
    part = LeadingPart(space.finder, r"\mu")
    terms = PolynomialField(space.finder).polynomial(value)
    polynomial = part.context.from_dict(
        {(0, *e): fmpq(v.numerator, v.denominator) for e, v in terms.items()}
    )
    reached = False
    for balance in part.balances():
        slopes = [polynomial.derivative(place) for place in part.places]
        if any(pseudo_remainder(one, balance.equations)[2] for one in slopes):
            reached = True
            assert weight in balance.exponents
    assert space.finder.derivative(value).is_zero
    assert reached


coefficients = st.integers(-3, 3).map(Fraction)
scales = st.fractions(-3, 3, max_denominator=3).filter(bool)


def lotka_volterra(matrix):
    rows = []
    for name, row in zip("xyz", matrix, strict=True):
        terms = "+".join(
            rf"(\frac{{{a.numerator}}}{{{a.denominator}}}){one}"
            for a, one in zip(row, "xyz", strict=True)
        )
        rows.append(rf"\dot {name}={name}({terms}+1)")
    return ",\\; ".join(rows)


@settings(max_examples=settings.default.max_examples // 2)
@given(st.lists(st.tuples(*3 * [coefficients]), min_size=3, max_size=3), st.tuples(*3 * [scales]))
def test_scaling_variables_changes_no_exponent_and_minus_one_is_always_one(matrix, scaling):
    matrix = [[a or Fraction(j == k) for j, a in enumerate(row)] for k, row in enumerate(matrix)]
    scaled = [[a * s for a, s in zip(row, scaling, strict=True)] for row in matrix]
    kept, changed = (found(lotka_volterra(one)) for one in (matrix, scaled))
    assert kept[0].weights == changed[0].weights == (1, 1, 1)
    assert all(-1 in one.exponents for one in kept[1])
    assert kept[1]
    first, second = (
        Counter((one.exponents, len(one.factors)) for one in balances)
        for _, balances in (kept, changed)
    )
    assert first == second


PAIRS = [*combinations_with_replacement(range(3), 2)]
digits = st.integers(-9, 9).filter(bool)


@settings(max_examples=settings.default.max_examples // 2)
@given(st.lists(st.tuples(*6 * [digits]), min_size=3, max_size=3), st.tuples(*3 * [digits]))
def test_a_balance_of_a_field_with_all_quadratic_terms_is_found(rows, c):
    """The first coefficients are chosen so that c + f(c) = 0."""
    fields = []
    for row, value in zip(rows, c, strict=True):
        rest = sum(a * c[j] * c[k] for a, (j, k) in zip(row[1:], PAIRS[1:], strict=True))
        fields.append([Fraction(-value - rest, c[0] ** 2), *row[1:]])
    tex = []
    for name, row in zip("xyz", fields, strict=True):
        numbers = (Fraction(a) for a in row)
        terms = (
            rf"(\frac{{{a.numerator}}}{{{a.denominator}}}){'xyz'[j]}{'xyz'[k]}"
            for a, (j, k) in zip(numbers, PAIRS, strict=True)
        )
        tex.append(rf"\dot {name}={'+'.join(terms)}")
    part, balances = found(r",\quad ".join(tex))
    at = [part.context.constant(0), *map(part.context.constant, c), part.exponent]
    (own,) = [
        one
        for one in balances
        if not any(e.compose(*at, ctx=part.context) for e in one.equations.equations)
    ]
    slope = fmpq_mat([[slope_of(row, i, j, c) for j in range(3)] for i, row in enumerate(fields)])
    expected = slope.charpoly()
    computed = own.characteristic[2].compose(*at, ctx=part.context)
    powers = (a * part.exponent**k for k, a in enumerate(expected.coeffs()))
    assert computed / computed.leading_coefficient() == sum(powers, part.context.constant(0))
    roots = [Fraction(int(r.p), int(r.q)) for r, power in expected.roots() for _ in range(power)]
    assert [*own.exponents] == sorted(roots) and -1 in roots


def slope_of(row, i, j, c):
    """The derivative of x_i + f_i by x_j at c."""
    terms = (
        fmpq(a.numerator, a.denominator) * ((j == k) * c[m] + (j == m) * c[k])
        for a, (k, m) in zip(map(Fraction, row), PAIRS, strict=True)
    )
    return sum(terms, fmpq(i == j))


monomials = st.tuples(*3 * [st.integers(0, 3)])


@given(st.lists(st.lists(monomials, min_size=1, max_size=3), min_size=3, max_size=3))
def test_no_term_is_heavier_than_the_leading_ones(rates):
    try:
        weights = weights_of_leading_terms(rates)
    except Meaningless:
        return
    excess = [
        sum(w * e for w, e in zip(weights, one, strict=True)) - weights[k] - 1
        for k, rate in enumerate(rates)
        for one in rate
    ]
    assert max(excess) == 0
    assert all(weight > 0 for weight in weights)


@pytest.mark.parametrize(
    ("field", "message"),
    [
        (r"\dot x=\frac1y,\quad \dot y=x", "quotients by variables"),
        (r"\dot x=x", "no term of the motion leads"),
    ],
)
def test_what_has_no_leading_part_is_refused(field, message):
    with pytest.raises(Meaningless, match=message):
        found(field)


def test_real_points_are_not_needed():
    """All balances of a field whose solutions are real for all times are complex."""
    _, balances = found(r"\ddot x=-2x^3")
    assert [one.exponents for one in balances] == [(-1, 4)]
