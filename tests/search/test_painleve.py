"""The Painlevé test, against published answers and against series that are found one by one."""

from fractions import Fraction

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from kowalevski_cas.search.exponents import LeadingPart
from kowalevski_cas.search.painleve import laurent
from tests.sample import sampled
from tests.search.test_exponents import EULER, KOWALEVSKI, LORENZ, TODA, henon_heiles, space_of


def answers(field):
    """The results of the test at the principal balances."""
    part = LeadingPart(space_of(field).finder, r"\mu")
    return part, [laurent(part, one) for one in part.balances() if one.is_principal()]


def passed(series):
    """Whether no free constant is missing."""
    return not series.conditions and series.logarithm is None


def passes(field):
    _, results = answers(field)
    assert results
    return all(passed(one) for one in results)


@pytest.mark.parametrize(
    "field",
    sampled(
        [
            EULER,
            KOWALEVSKI,
            TODA,
            henon_heiles(1, 1),
            henon_heiles(1, 6),
            henon_heiles(7, 6),
            r"\ddot x=6x^2+ax+b",
            r"\ddot x=2x^3+ax+b",
            r"\dot x=\frac12(y-x),\quad \dot y=-y-xz,\quad \dot z=xy-z",
            r"\dot x=y-x,\quad \dot y=\frac19x-y-xz,\quad \dot z=xy-2z",
            r"\dot x=\frac13(y-x),\quad \dot y=\rho x-y-xz,\quad \dot z=xy",
            r"\dot x=yz,\quad \dot y=zx,\quad \dot z=xy",
            r"A\dot p=(B-C)qr,\quad B\dot q=(C-A)rp,\quad C\dot r=(A-B)pq",
            r"\ddot x=-Ax-4x^3-4xy^2,\quad \ddot y=-By-4y^3-4x^2y",
        ],
        4,
    ),
)
def test_systems_with_the_property(field):
    assert passes(field)


@pytest.mark.parametrize(
    "field",
    [
        henon_heiles(2, 1),
        r"\ddot x=6x^2+b\dot x",
        r"\ddot x=2x^3+b\dot x",
        r"\dot x=10(y-x),\quad \dot y=28x-y-xz,\quad \dot z=xy-\frac83z",
        r"\dot x=y-x,\quad \dot y=\frac18x-y-xz,\quad \dot z=xy-2z",
        r"\dot x=\frac12(y-x),\quad \dot y=x-y-xz,\quad \dot z=xy-z",
    ],
)
def test_systems_without_it(field):
    assert not passes(field)


def values(part, case):
    """The equations of a case, with the names of the constants."""
    names = {f"v{k}": name for k, name in enumerate(part.names)}
    shown = " ".join(str(one / one.leading_coefficient()) for one in case.equations)
    for letters, name in names.items():
        shown = shown.replace(letters, name.lstrip("\\"))
    return shown


def test_the_three_cases_of_the_lorenz_equations():
    """Tabor and Weiss, Phys. Rev. A 24 (1981); Segur, Fermi lectures (1980)."""
    part, (result,) = answers(LORENZ)
    assert [exponent for exponent, _ in result.conditions] == [2, 4]
    first = result.conditions[0][1].factor()[1]
    assert {"2*v3 - v5", "3*v3 + v5 - 1"} <= {str(factor) for factor, _ in first}
    assert {values(part, one) for one in result.cases} == {
        "sigma - 1/2 b - 1 rho",
        "sigma - 1 b - 2 rho - 1/9",
        "sigma - 1/3 b",
    }


@pytest.mark.parametrize(
    ("field", "number"),
    [
        (r"\ddot x=-Ax-2xy,\quad \ddot y=-By-x^2-y^2", 2),
        (r"\ddot x=-Ax-4x^3-12xy^2,\quad \ddot y=-By-4y^3-12x^2y", 1),
    ],
)
def test_potentials_that_are_integrable_for_equal_frequencies(field, number):
    part, results = answers(field)
    assert len(results) == number
    for one in results:
        assert [values(part, case) for case in one.cases] == ["A - B"]


def test_no_value_helps_where_the_condition_is_a_number():
    _, results = answers(henon_heiles(2, 1))
    assert all(one.conditions and not one.cases for one in results)


@pytest.mark.parametrize(("factor", "exponent"), [(2, 3), (0, 1), (-1, 0)])
def test_a_double_exponent_at_which_one_constant_multiplies_a_logarithm(factor, exponent):
    """Where x = 1/t, y is t^factor times a logarithm if z drives it."""
    field = rf"\dot x=-x^2,\quad \dot y=({factor})xy+({{}})xz,\quad \dot z=({factor})xz"
    _, results = answers(field.format(1))
    assert [one.logarithm for one in results] == [exponent]
    assert not any(passed(one) for one in results)
    assert passes(field.format(0))


def residue(a, b, c):
    """What hinders the series x = t^-2 + … of ẍ = 6x² + cẋ + ax + b at its exponent 6."""
    x = [Fraction(1)]
    for k in range(1, 7):
        known = (
            6 * sum((x[j] * x[k - j] for j in range(1, k)), Fraction(0)) + c * (k - 3) * x[k - 1]
        )
        known += a * x[k - 2] if k > 1 else 0
        known += b if k == 4 else 0
        if k == 6:
            return known
        x.append(known / ((k - 2) * (k - 3) - 12))
    raise AssertionError


small = st.integers(-6, 6)


@given(small, small, small)
@example(6, 0, 5)
@example(-6, 0, 5)
@example(0, 0, 1)
def test_the_condition_of_a_damped_cubic_potential(a, b, c):
    assert passes(rf"\ddot x=6x^2+({c})\dot x+({a})x+({b})") == (not residue(a, b, c))


@given(st.lists(st.sampled_from([-2, -1, 1, 2, 3]), min_size=3, max_size=3), st.booleans())
def test_units_do_not_matter(units, special):
    """The Lorenz equations, with and without the property, for multiples of the variables."""
    p, q, r = units
    rho = r"\frac19" if special else r"\frac15"
    field = (
        rf"({p})\dot x=({q})y-({p})x,\quad ({q})\dot y={rho}({p})x-({q})y-({p * r})xz,\quad"
        rf"({r})\dot z=({p * q})xy-2({r})z"
    )
    assert passes(field) == special
