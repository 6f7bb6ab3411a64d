"""The closed form on O⁴: at any time, in every regime, in floats and in balls."""

from functools import cache, partial

import numpy as np
import pytest
from flint import acb, arb
from hypothesis import given
from hypothesis import strategies as st

from kowalevski_cas.motion import Inadmissible, formulas, load
from kowalevski_cas.motion.formulas import values_of_offer
from kowalevski_cas.motion.methods.ball import enclosures
from kowalevski_cas.motion.o4.arithmetic import BALLS
from kowalevski_cas.motion.o4.point import PhasePointO4
from kowalevski_cas.motion.o4.series import DifferentialSeries
from kowalevski_cas.motion.o4.uniformization import ByConjugates, ByNeighbours, uniformize
from kowalevski_cas.motion.o4.variable import VariableO4
from kowalevski_cas.motion.parameters import ball, precision
from kowalevski_cas.paper.closed_form import HyperellipticForm, Values
from kowalevski_cas.paper.scene import Scene
from tests.motion.o4.levels import KNOWN, motion
from tests.sample import sampled

closed, balls, dop853 = load("closed"), load("ball"), load("dop853")
regime = pytest.mark.parametrize("known", sampled([(known,) for known in KNOWN], 6))
T = np.array([0.0, -3.3, 17.25, 1e6, -(2.0**19) - 0.1])
angles = st.fractions(-6, 6, max_denominator=100)
inside = st.fractions("1/10", 3, max_denominator=100)
signs = st.tuples(*[st.sampled_from((1, -1))] * 5)


def relative(found, exact):
    return np.max(np.linalg.norm(found - exact, axis=1) / np.linalg.norm(exact, axis=1))


def on_a_torus(known, first, second, chosen):
    """A motion with any phases; for σ < 0 the sign of μ2 is not free."""
    try:
        return motion(known, (first, second), chosen)
    except Inadmissible:
        return motion(known, (first, second), (chosen[0], -1, *chosen[2:]))


@given(st.sampled_from(KNOWN), angles, angles, signs)
def test_it_moves_by_the_nine_equations(known, first, second, chosen):
    moving, times = on_a_torus(known, first, second, chosen), np.linspace(-0.5, 0.5, 5)
    assert relative(closed(moving, times), dop853(moving, times)) < 1e-9


@regime
def test_floats_are_as_exact_as_balls_at_any_time(known):
    moving = motion(known)
    assert relative(closed(moving, T), balls(moving, T)) < 1e-12


@regime
def test_the_integrals_and_the_constants_of_O4_are_kept(known):
    moving = motion(known)
    values = values_of_offer("integrals")(*closed(moving, T).T)
    found = dict(zip(("h", "k", "a2", "b2", "c", "g"), values, strict=False))
    a, b, *_ = map(float, known)
    expected = {**moving.constants, "a2": a**2, "b2": b**2, "c": 0.0}
    size = max(abs(value) for value in expected.values())
    for name, values in found.items():
        assert np.all(abs(values - expected[name]) < 1e-11 * size)


def test_balls_get_smaller_and_contain_each_other():
    moving = motion(KNOWN[8])
    for wide, narrow in zip(
        enclosures(moving, [3.5], 64)[0], enclosures(moving, [3.5], 200)[0], strict=True
    ):
        assert wide.contains(narrow)
        assert narrow.rad() < arb(2) ** -150


@regime
def test_a_series_encloses_the_integral(known):
    with precision(128):
        for arc in motion(known).arcs:
            by = uniformize(motion(known).parameters, arc)
            series, angle = DifferentialSeries(by), arb(1) / 3

            def differential(z, analytic, place, by=by):
                pair = by.pair(by.functions(z), 1, BALLS)
                root = partial(acb.sqrt, analytic=analytic)
                return by.differentials(pair, by.variable, by.rate, root)[place]

            for place, sines in enumerate(series.enclose_sines()(angle)):
                found = series.enclose_means()[place] * angle + sines
                exact = acb.integral(
                    lambda z, analytic, place=place: differential(z, analytic, place),
                    acb(0),
                    acb(angle),
                )
                assert found.overlaps(exact.real)
                assert found.rad() < 1e-25


@regime
def test_both_uniformizations_give_the_same_pair_and_the_angle_of_a_pair_is_its_own(known):
    with precision(128):
        moving = motion(known)
        for arc in moving.arcs:
            kinds = (ByNeighbours, ByConjugates) if moving.parameters.sigma < 0 else (ByNeighbours,)
            for given in (arb(-9) / 4, arb(1) / 3, arb(5) / 2, arb(7)):
                for by in (kind(moving.parameters, arc) for kind in kinds):
                    c, s = by.at(by.angle(given))
                    assert (c * (given / 2).sin()).overlaps(s * (given / 2).cos())
                    assert c * (given / 2).cos() + s * (given / 2).sin() > 0


PARTS = (r"\Pi", "Y", "V", "T", r"\Lambda", "d", "N")
RADICALS = (r"\mu_1", r"\mu_2", "A_1", "B_1", "A_2", "B_2", "K_1", "K_2", "E")
names = ("u_1", "u_2", r"\varepsilon", "s", r"\tau_3", "p", "r", r"\sigma", r"\kappa")


@cache
def printed(ids, arguments):
    """The right-hand sides of displays of the section on the phase point, as a function."""
    derivation = formulas.source(HyperellipticForm)
    displays = {d.id: d for section in derivation.sections for d in section.displays}
    scene = Scene("printed", variables=(*names, *RADICALS, *PARTS))
    sides = tuple(member for id in ids for member in displays[id])
    return formulas.compile_values(Values(scene, sides, arguments), HyperellipticForm)


@given(st.sampled_from(KNOWN), inside, inside, signs)
def test_the_phase_point_is_that_of_the_printed_formulas(known, first, second, chosen):
    squares = printed(("radicals-O4",), (*names, r"\mu_1", r"\mu_2"))
    parts = printed(("parts",), (*names, *RADICALS, "d"))
    fields = printed(("velocity-by-u", "fields-by-u"), (*names, *RADICALS, *PARTS))
    moving = on_a_torus(known, first, second, chosen)
    values = moving.parameters
    with precision(128):
        halves = [arb(float(x) / 2).sin_cos()[::-1] for x in (first, second)]
        (n1, v1), (n, v) = (
            VariableO4(values, arc, BALLS).pair((cos**2, sin**2))
            for arc, (cos, sin) in zip(moving.arcs, halves, strict=True)
        )
        sign = 1 if v > 0 else -1
        rational = ball(values.s), ball(values.tau), ball(values.sigma)
        squared = values.p_square, values.r_square, values.kappa_square
        p, r, kappa = (ball(square).sqrt() for square in squared)
        at = (n1 / v1, n / v, arb(sign), *rational[:2], p, r, rational[2], kappa)
        K1, mu2, A2, B2, K2 = moving.signs
        signed = (1, sign * mu2, 1, 1, A2, B2, K1, sign * K2, 1)
        first_two = [s * x.sqrt() for s, x in zip(signed, squares(*at, 0, 0)[:2], strict=False)]
        radicals = [s * x.sqrt() for s, x in zip(signed, squares(*at, *first_two), strict=True)]
        d = radicals[0] - radicals[1]
        expected = fields(*at, *radicals, *parts(*at, *radicals, d))
        point = PhasePointO4(values, moving.regime, moving.signs, BALLS)
        for x, y in zip(point(*halves), expected, strict=True):
            assert x.overlaps(y)
            assert x.rad() < 1e-20
