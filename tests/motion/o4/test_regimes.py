"""Where real motions on O⁴ exist: the table, its arcs, and how many tori there are."""

import re

import numpy as np
import pytest
from hypothesis import assume, example, given
from hypothesis import strategies as st

from kowalevski_cas.motion import Inadmissible, MotionO4, ParametersO4, load
from kowalevski_cas.motion.o4.arithmetic import FLOATS
from kowalevski_cas.motion.o4.regimes import regime_of
from kowalevski_cas.motion.o4.start import on_O4
from kowalevski_cas.motion.o4.variable import VariableO4
from kowalevski_cas.motion.parameters import precision
from tests.motion.o4.levels import EVERY_REGIME, KNOWN, admissible, motion, point, points
from tests.sample import sampled

closed = load("closed")
shares = st.fractions("1/40", "39/40", max_denominator=40)
constants = st.fractions(-5, 5, max_denominator=40)


@given(shares, constants, constants)
@example(*[KNOWN[0][k] / KNOWN[0][0] for k in (1, 2, 3)])
def test_motions_exist_exactly_where_the_table_says(b, s, tau):
    try:
        regime = regime_of(ParametersO4.of(1, b, s, tau))
    except Inadmissible as error:
        assume("degenerate" not in str(error))
        assert not admissible(1, b, s, tau)
    else:
        assert admissible(1, b, s, tau)
        assert regime_told(regime) in EVERY_REGIME.values()


@pytest.mark.parametrize("known", KNOWN, ids=str)
def test_every_regime_has_its_arcs_and_its_number_of_tori(known):
    assert regime_told(regime_of(ParametersO4.of(*known))) == EVERY_REGIME[known_as(known)]


def regime_told(regime):
    signs = str(regime).partition(", u1")[0]
    return signs, str(regime.u1), str(regime.u2), regime.tori


def known_as(known):
    return list(EVERY_REGIME)[KNOWN.index(known)]


@pytest.mark.parametrize("known", KNOWN, ids=str)
def test_inside_the_arcs_the_squares_are_positive_and_at_the_ends_one_vanishes(known):
    parameters = ParametersO4.of(*known)
    regime = regime_of(parameters)
    with precision(64):
        one, two = (VariableO4(parameters, arc, FLOATS) for arc in (regime.u1, regime.u2))
        s, tau, sigma = map(float, (parameters.s, parameters.tau, parameters.sigma))
    r_square, kappa_square = float(parameters.r_square), float(parameters.kappa_square)

    def squares(first, second):
        """Those of μ, A, B, K for u1 and, times powers of v, for u2 = n/v; and of E."""
        (n1, v1), (n, v) = (
            variable.pair((np.cos(x / 2) ** 2, np.sin(x / 2) ** 2))
            for variable, x in ((one, first), (two, second))
        )
        u = n1 / v1
        mu1, mu2 = (u**2 - sigma) / tau, (n**2 - sigma * v**2) / tau
        product = -np.sqrt(abs(mu1 * mu2))
        return np.array([
            mu1, u + tau + r_square, r_square - tau - u, (kappa_square - u**2) / (2 * s),
            mu2, n + (tau + r_square) * v, n + (tau - r_square) * v,
            (n**2 - kappa_square * v**2) / (2 * s),
            2 * sigma / (sigma * v + n * u + tau * product),
        ])  # fmt: skip

    inner = np.linspace(0.01, 3.13, 40)
    assert np.all(squares(*np.meshgrid(inner, inner)) > 0)
    for number, of in ((0, slice(0, 4)), (1, slice(4, 8))):
        for end in (0.0, np.pi):
            angles = [1.0, 1.0]
            angles[number] = end
            assert np.min(abs(squares(*angles)[of])) < 1e-12 * np.max(abs(squares(1.0, 1.0)))


whole = st.integers(-3, 3).filter(bool)


@pytest.mark.slow
@given(points | st.tuples(*[whole] * 7).map(point))
@example(point((1, 1, 2, 2, 2, 0, 1.5)))  # σ = 0, but for rounding
@example(point((-1, -1, -1, -2, 0, 2, -2)))
def test_every_real_point_of_O4_arises(state):
    try:
        found = on_O4(state.tolist())
    except Inadmissible as error:
        assume(not re.search("degenerate|a > b > 0 is needed", str(error)))
        raise
    assert found.off < 1e-10


@pytest.mark.slow
@pytest.mark.parametrize("known", KNOWN, ids=str)
def test_a_motion_passes_as_many_points_above_u1_u2_as_its_torus_has(known):
    moving = motion(known)
    states = closed(moving, np.random.default_rng(2007).uniform(0, 1e4, 150))
    seen = {on_O4(state.tolist()).signs for state in states}
    assert len(seen) * moving.regime.tori == (32 if moving.regime.signs[2] else 16)


@pytest.mark.slow
@pytest.mark.parametrize("known", sampled([(known,) for known in KNOWN], 1))
def test_the_tori_are_told_apart_by_signs_that_a_motion_keeps(known):
    count = regime_of(ParametersO4.of(*known)).tori
    found = set()
    for torus in range(1, count + 1):
        first = MotionO4.of(*known, angles=("1/3", "2"), torus=torus)
        for state in closed(first, np.array([0.0, 3.3, -17.0])):
            again = on_O4(state.tolist())
            assert first.regime.invariant(again.signs) == first.regime.invariant(first.signs)
        found.add(first.regime.invariant(first.signs))
    assert len(found) == count
    with pytest.raises(Inadmissible, match=f"no torus {count + 1}: .*(1 to {count}|one torus)"):
        MotionO4.of(*known, torus=count + 1)
