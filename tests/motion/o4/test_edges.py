"""What the closed form promises on O⁴, sampled towards each edge, to 10⁻¹² of it."""

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from kowalevski_cas.algebra.numbers import square_root
from kowalevski_cas.motion import General, Inadmissible, MethodError, MotionO4, load
from kowalevski_cas.motion.critical import residuals
from kowalevski_cas.motion.formulas import values_of_offer
from kowalevski_cas.motion.general import with_constants_of_O4
from kowalevski_cas.motion.methods import closed as closed_form
from kowalevski_cas.motion.methods.integrators import initial_state
from kowalevski_cas.motion.o4.closed import ClosedO4
from kowalevski_cas.motion.o4.quadrature import NODES
from kowalevski_cas.motion.units import numbers_in_unit, unit_of
from kowalevski_cas.paper.closed_form import HyperellipticForm
from tests.motion.exact import apart, integrated
from tests.motion.o4.levels import admissible

A, B = Fraction(6, 5), Fraction(7, 10)

states, balls = load("closed"), load("ball")

EDGES = (
    "σ", "κ", "τ", "s", "s = a", "s = b", "s = -a", "s = -b", "a = b", "b", "fast", "large s",
)  # fmt: skip


@st.composite
def edges(draw):
    """Constants a, b, s, τ at a distance of 10⁰ to 10⁻¹² of an edge, or so far outside."""
    near = draw(st.sampled_from([1, -1])) * Fraction(10.0 ** draw(st.floats(-12, -0.5)))
    far = 1 / near
    a, b = A, B
    s = Fraction(draw(st.integers(-60, 60)), 20)
    tau = Fraction(draw(st.integers(-60, 90)), 17)
    kind = draw(st.sampled_from(EDGES))
    if kind == "σ":
        tau = draw(st.sampled_from([(a - b) ** 2, (a + b) ** 2])) + near
    elif kind == "κ":
        square = (tau - (a - b) ** 2) * (tau - (a + b) ** 2) / (-4 * tau) if tau else Fraction(-1)
        assume(square > 0)
        s = Fraction(float(square) ** 0.5) * (1 if s > 0 else -1) + near
    elif kind == "τ":
        tau = near
    elif kind == "s":
        s = near
    elif kind.startswith("s = "):
        s = (a if kind[-1] == "a" else b) * (-1 if "-" in kind else 1) + near
    elif kind == "a = b":
        b = a - abs(near)
        tau = draw(st.sampled_from([tau, near, (a - b) ** 2 / 3]))
    elif kind == "b":
        b = abs(near)
    elif kind == "fast":
        tau = far
    else:
        s = far
    assume(s and tau and 0 < b < a and admissible(a, b, s, tau))
    return a, b, s, tau


@st.composite
def motions(draw):
    """A motion on any of the tori, from any place of it, and times, early and late."""
    known = draw(edges())
    given_angles = draw(st.tuples(*[st.fractions(-6, 6, max_denominator=50)] * 2))
    try:
        first = MotionO4.of(*known)
    except Inadmissible:  # on the edge
        assume(False)
        raise
    torus = draw(st.integers(1, first.regime.tori))
    motion = MotionO4.of(*known, angles=given_angles, torus=torus)
    rate = 2.0 ** float(unit_of(initial_state(motion)))
    late = draw(st.floats(0, 9))
    return motion, np.array([0.0, 1.3 / rate, -(10.0**late) / rate])


def check_promise(moving):
    motion, times = moving
    assert apart(states(motion, times), balls(motion, times)) < closed_form.PROMISE


@pytest.mark.slow
@settings(max_examples=5, deadline=None)
@given(motions())
def test_the_closed_form_is_exact_to_twelve_digits(moving):
    check_promise(moving)


@pytest.mark.slow
@settings(max_examples=400, deadline=None)
@given(motions())
def test_the_closed_form_is_exact_to_twelve_digits_everywhere(moving):
    check_promise(moving)


@st.composite
def corners(draw):
    """Constants near two edges at once, where two pairs of roots almost coincide."""
    near, further = (
        draw(st.sampled_from([1, -1])) * Fraction(10.0 ** draw(st.floats(-12, -2))) for _ in "12"
    )
    b = draw(st.sampled_from([B, A - abs(near), abs(near)]))
    s = draw(st.sampled_from([A, B, -A, -B, b, -b])) + further
    tau = draw(st.sampled_from([(A - b) ** 2, (A + b) ** 2, Fraction(2), Fraction(0)])) + near
    assume(s and tau and admissible(A, b, s, tau))
    return A, b, s, tau


@pytest.mark.slow
@given(corners())
def test_near_two_edges_it_is_as_exact_or_is_not_given(known):
    try:
        motion = MotionO4.of(*known, angles=(Fraction(1, 3), Fraction(2)))
        rate = 2.0 ** float(unit_of(initial_state(motion)))
        times = np.array([0.0, 1.3 / rate, -1e6 / rate])
        found = states(motion, times)
    except (Inadmissible, MethodError) as error:
        assert any(word in str(error) for word in ("close", "almost", "≠ 0", "digits"))
    else:
        assert apart(found, balls(motion, times)) < closed_form.PROMISE


@pytest.mark.slow
@settings(max_examples=3, deadline=None)
@given(motions())
def test_of_many_times_it_is_as_exact_as_of_a_few(moving):
    """Angles are then found from a table."""
    motion, (_, step, late) = moving
    times = late + step * np.arange(NODES * NODES + 2)
    some = [0, 777, len(times) - 1]
    assert apart(states(motion, times)[some], balls(motion, times[some])) < closed_form.PROMISE


@pytest.mark.slow
@settings(max_examples=5)
@given(motions(), st.floats(9, 200))
def test_it_is_exact_however_late(moving, power):
    motion, times = moving
    late = np.array([-(10.0**power), 10.0 ** (power + 0.3)]) * abs(times[1])
    assert apart(states(motion, late), balls(motion, late)) < closed_form.PROMISE


def check_equations(moving):
    """From the state at t = 0 the nine equations lead to the others, but for its rounding."""
    motion, _ = moving
    begin = balls(motion, np.zeros(1))[0]
    unit = int(unit_of(begin))
    scales = np.ldexp(1.0, -unit * np.array([1] * 3 + [2] * 6))
    expected = integrated(begin * scales, Fraction(1, 2)) / scales
    found = states(motion, np.array([0.5 * 2.0**-unit]))[0]
    size = np.max(np.abs(begin[3:]) * scales[3:])
    assert apart(found, expected) < 1e-14 / min(size, 1.0)


@pytest.mark.slow
@settings(max_examples=3, deadline=None)
@given(motions())
def test_it_moves_by_the_printed_equations(moving):
    check_equations(moving)


@pytest.mark.slow
@settings(max_examples=150, deadline=None)
@given(motions())
def test_it_moves_by_the_printed_equations_everywhere(moving):
    check_equations(moving)


@pytest.mark.slow
@settings(max_examples=15, deadline=None)
@given(edges())
def test_any_integrator_starts_from_constants(known):
    """At t = 0 the state has the fields that are asked for, however close two roots are."""
    try:
        state = initial_state(MotionO4.of(*known))
    except Inadmissible:
        assume(False)
        raise
    alpha, beta = state[3:6], state[6:]
    a, b = map(float, known[:2])
    assert abs(np.linalg.norm(alpha) - a) < 1e-15 * a
    assert abs(np.linalg.norm(beta) - b) < 1e-15 * a
    assert abs(alpha @ beta) < 1e-15 * a * a


@pytest.mark.slow
@settings(deadline=None)
@given(edges())
def test_near_an_edge_the_series_have_some_hundreds_of_terms_at_most(known):
    try:
        closed = ClosedO4(MotionO4.of(*known), 1.0)
    except Inadmissible:
        assume(False)
        raise
    assert all(sines.shape[1] < 1000 for sines in closed._quadratures._amplitudes)


@settings(deadline=None)
@given(
    st.sampled_from(["s = a", "s = -a", "s = b", "s = -b", "σ = 0", "κ = 0"]),
    st.integers(-60, 60).filter(bool),
    st.integers(-60, 90).filter(bool),
    st.tuples(*[st.fractions(-6, 6, max_denominator=50)] * 2),
    st.integers(-100, 100),
)
def test_where_two_roots_coincide_integrators_start_from_constants_too(edge, s, tau, angles, power):
    """In any unit of time: the state has these constants, and is on O⁴."""
    s, tau, unit = Fraction(s, 20), Fraction(tau, 17), Fraction(2) ** power
    if edge.startswith("s"):
        s = (A if edge[-1] == "a" else B) * (-1 if "-" in edge else 1)
    elif edge == "σ = 0":
        tau = (A - B) ** 2 if tau > 0 else (A + B) ** 2
    else:  # on a rational point of 4s²τ = −σ
        square = -(tau - (A - B) ** 2) * (tau - (A + B) ** 2) / (4 * tau)
        assume(square > 0)
        s = square_root(square)
        assume(s is not None)
    given = {"a": A * unit**2, "b": B * unit**2, "angles": angles}
    try:
        motion = with_constants_of_O4(s * unit**2, tau * unit**4, **given)
    except Inadmissible:
        assume(False)
        raise
    assert isinstance(motion, General) and "degenerate" in motion.why
    state = numbers_in_unit(list(map(Fraction, motion.point)), power)
    row = np.array([state], dtype=float)
    assert residuals(row)["O4"][0] < 1e-13
    p, r = (float(square) ** 0.5 for square in (A**2 + B**2, A**2 - B**2))
    h, k, g = values_of_offer("integrals", HyperellipticForm)(float(s), float(tau), p, r)
    size = float(np.max(np.abs(row))) + 1
    H, K, *_, G = np.array(values_of_offer("integrals")(*row[0]))[:6]
    for value, expected, weight in ((H, h, 2), (K, k, 4), (G, g, 6)):
        assert abs(value - expected) < 1e-13 * size**weight


def test_a_state_that_does_not_keep_the_integrals_is_not_given(monkeypatch):
    monkeypatch.setattr(closed_form, "PROMISE", 1e-18)
    with pytest.raises(MethodError, match="twelve digits"):
        states(MotionO4.of("1.2", "0.7", "-0.9", "0.6"), np.linspace(0, 10, 9))
