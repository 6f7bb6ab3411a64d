"""Darboux polynomials of which neither the polynomial nor the cofactor is given."""

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kowalevski_cas.algebra.present import formula_in
from kowalevski_cas.notation import to_plain
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.texts import Texts
from kowalevski_cas.paper.vocabulary import vocabulary
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.search.darboux import darboux_polynomials
from kowalevski_cas.system import System
from tests.laws.systems import (
    EULER,
    HENON_HEILES,
    KEPLER,
    LORENZ,
    LOTKA_VOLTERRA,
    NAHM,
    PENDULUM,
    SPECIAL_LORENZ,
    VOLTERRA,
)


def shown(element):
    return to_plain(formula_in(element))


def found(system, degree, special=False):
    """Polynomials with cofactors and equations, each checked."""
    derivation = system.derivation()
    at = Elaborations(derivation.texts())(derivation.scenes()[0]).finder
    for one in darboux_polynomials(at, degree, special):
        rest = at.derivative(one.polynomial) - one.cofactor * one.polynomial
        for left, right in one.equations:
            name = shown(left)
            names = {n: at.ring.generator(n) for n in at.names} | {_name(at, name): right}
            rest = at.image(rest, names.__getitem__)
        assert rest.is_zero
        yield shown(one.polynomial), shown(one.cofactor), [f"{shown(a)} = {shown(b)}" for a, b in one.equations]  # fmt: skip


def _name(at, shown_name):
    return next(n for n in at.names if shown(at.ring.generator(n)) == shown_name)


@pytest.mark.parametrize(
    ("system", "degree", "expected"),
    [
        (SPECIAL_LORENZ, 2, {"x² − 2zσ": "−2σ"}),
        (LORENZ, 2, {}),
        (LOTKA_VOLTERRA, 3, {"x": "−yb + a", "y": "xm − n"}),
        (VOLTERRA, 2, {"x": "y − z", "y": "−x + z", "z": "x − y", "x + y + z": "0"}),
        (NAHM, 1, {"x + y": "z", "x − y": "−z", "x + z": "y", "x − z": "−y", "y + z": "x", "y − z": "−x"}),
        (PENDULUM, 2, {"c² + s²": "0", "2c − w²": "0"}),
        (HENON_HEILES, 2, {}),
    ],
    ids=lambda value: getattr(value, "name", None),
)  # fmt: skip
def test_all_that_are_known(system, degree, expected):
    assert {f: k for f, k, _ in found(system, degree)} == expected


@pytest.mark.parametrize("speed", ["ax+by+c", "ax-by", "ax^2+by+c", "(a+1)x+bcy"])
@pytest.mark.parametrize("rate", ["1", "x-3"])
def test_a_circle_is_found_however_the_motion_turns_along_it(speed, rate):
    """F = x² + y² − 1 has K = 2xk if ẋ = ye + kF, ẏ = −xe: no relation of constants is needed."""
    scene = System(rf"\dot x=y({speed})+({rate})(x^2+y^2-1),\ \dot y=-x({speed})").scene
    at = Elaborations(Texts(vocabulary((scene,))))(scene).finder
    found = [shown(one.polynomial) for one in darboux_polynomials(at, 2) if not one.equations]
    assert "x² + y² − 1" in found


QUARTICS = {
    "Yablonskii": (
        r"\dot x=-4abcx-(a+b)y+3(a+b)cx^2+4xy,\ \dot y=(a+b)abx-4abcy"
        r"+(4abc^2-\frac32(a+b)^2+4ab)x^2+8(a+b)cxy+8y^2",
        "12xac + 12xbc + 16y − 8abc",
    ),
    "Filipstov": (
        r"\dot x=6(1+a)x+2y-6(2+a)x^2+12xy,\ \dot y=15(1+a)y+3a(1+a)x^2-2(9+5a)xy+16y^2",
        "−24xa − 48x + 48y + 30a + 30",
    ),
    "Chavarriga": (
        r"\dot x=5x+6x^2+4(1+a)xy+ay^2,\ \dot y=x+2y+4xy+(2+3a)y^2", "18x + 12ya + 10y + 10"
    ),
    "Chavarriga, Llibre and Sorolla": (
        r"\dot x=2(1+2x-2ax^2+6xy),\ \dot y=8-3a-14ax-2axy-8y^2", "−12xa + 8y + 8"
    ),
}  # fmt: skip


@pytest.mark.slow
@pytest.mark.parametrize(
    "name",
    [pytest.param(k, marks=[pytest.mark.slow] if k == "Yablonskii" else []) for k in QUARTICS],
)
def test_the_quartic_limit_cycles_of_quadratic_systems_need_no_relation_of_constants(name):
    """J. Chavarriga, J. Llibre and J. Sorolla, J. Differential Equations 200 (2004) 206–244."""
    motion, cofactor = QUARTICS[name]
    scene = System(motion).scene
    at = Elaborations(Texts(vocabulary((scene,))))(scene).finder
    (one,) = darboux_polynomials(at, 4)
    assert (shown(one.cofactor), one.equations) == (cofactor, ())
    assert (at.derivative(one.polynomial) - one.cofactor * one.polynomial).is_zero


def test_what_splits_is_left_out():
    assert len([*found(VOLTERRA, 3)]) == 4  # neither xyz nor (x + y + z)² is listed
    assert all(k == "0" for _, k, _ in found(EULER, 2))


LOW = {
    ("b = 2σ",): ("x² − 2zσ", "−2σ"),
    ("b = 1", "ρ = 0"): ("y² + z²", "−2"),
    ("b = 1", "σ = 1"): ("x²ρ − y² − z²", "−2"),
}
HIGH = {("b = 4", "σ = 1"): "−4", ("b = 6σ − 2", "ρ = 2σ − 1"): "−4σ", ("b = 0", "σ = 1/3"): "−4/3"}


def test_the_values_of_constants_for_which_the_system_of_lorenz_has_one_of_degree_2():
    cases = {tuple(sorted(e)): (f, k) for f, k, e in found(LORENZ, 2, special=True)}
    assert cases.pop(("σ = 0",)) == ("x", "0")
    assert cases == LOW


@pytest.mark.slow
def test_the_six_classes_of_the_system_of_lorenz_up_to_degree_4():
    cases = {tuple(sorted(e)): (f, k) for f, k, e in found(LORENZ, 4, special=True)}
    moving = {e: value for e, value in cases.items() if "σ = 0" not in e}
    assert {e: k for e, (_, k) in moving.items()} == {e: k for e, (_, k) in LOW.items()} | HIGH


def test_a_field_with_roots_or_quotients_is_refused():
    with pytest.raises(Meaningless, match="a root stands"):
        [*found(KEPLER, 1)]


numbers = st.integers(-3, 3)


@pytest.mark.slow
@settings(max_examples=20)
@given(numbers, numbers, numbers, numbers, numbers)
def test_cofactors_are_as_heavy_as_a_motion_that_is_homogeneous_by_other_weights(a, b, c, d, e):
    """x has weight 1 and y weight 2; y + ex² obeys the linear equation with the cofactor cx² + dy."""
    field = (
        rf"\dot x=x(({a})x^2+({b})y), "
        rf"\quad \dot y=(y+({e})x^2)(({c})x^2+({d})y)-2({e})x^2(({a})x^2+({b})y)"
    )
    scene = System(field).scene
    at = Elaborations(Texts(vocabulary((scene,))))(scene).finder
    x, y = map(at.ring.generator, "xy")
    a, b, c, d, e = map(at.ring.number, (a, b, c, d, e))
    cofactors = [one.cofactor for one in darboux_polynomials(at, 2)]
    known = [(x, a * x * x + b * y), (y + e * x * x, c * x * x + d * y)]
    for polynomial, cofactor in known:
        assert (at.derivative(polynomial) - cofactor * polynomial).is_zero
        assert any((cofactor - own).is_zero for own in cofactors)


YABLONSKII = (
    r"\dot x=-4abcx-(a+b)y+3(a+b)cx^2+4xy,\quad "
    r"\dot y=(a+b)abx-4abcy+(4abc^2-\frac32(a+b)^2+4ab)x^2+8(a+b)cxy+8y^2"
)
"""It has a cycle of degree four, and special constants by which other cases may not be divided."""


@pytest.mark.slow
def test_special_constants_of_one_case_may_be_excluded_by_another():
    found = System(YABLONSKII).find_darboux(1, special=True)
    assert {one.verdict.green for one in found} == {True}
    assert len(found) == 9
