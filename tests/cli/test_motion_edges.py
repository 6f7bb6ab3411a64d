"""What ``motion`` promises of O⁴ towards each edge, by whatever method follows the motion there."""

from __future__ import annotations

import json
from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from kowalevski_cas.cli import main
from kowalevski_cas.cli.motion import _states
from kowalevski_cas.motion import Inadmissible, MethodError, MotionO4
from kowalevski_cas.motion.methods.ball import loss
from kowalevski_cas.motion.methods.integrators import initial_state
from tests.motion.o4.levels import admissible

A, B = Fraction(6, 5), Fraction(7, 10)
ROOTS = [(A - B) ** 2, (A + B) ** 2, Fraction(0)]
"""Where σ vanishes, and τ."""


@st.composite
def edges(draw):
    """Constants a, b, s, τ: at a distance of 10⁰ to 10⁻¹² of an edge, or far outside."""
    near = Fraction(draw(st.sampled_from([1, -1]))) / 10 ** draw(st.integers(1, 12))
    a, b, s, tau = A, B, Fraction(draw(st.integers(-30, 30)), 10), Fraction(1, 7)
    kind = draw(st.sampled_from(["sigma", "fast", "a = b", "s = a", "kappa", "small s"]))
    if kind == "sigma":
        tau = draw(st.sampled_from(ROOTS)) + near
    elif kind == "fast":
        tau = -Fraction(10 ** draw(st.integers(1, 12)))
    elif kind == "a = b":
        b = a - abs(near)
    elif kind == "s = a":
        s, tau = A + near, -Fraction(draw(st.integers(1, 40)), 10)
    elif kind == "small s":
        s = near
    else:  # κ² = σ + 4s²τ almost zero
        tau = -Fraction(draw(st.integers(1, 20)), 10)
        sigma = (tau - ROOTS[0]) * (tau - ROOTS[1])
        s = Fraction(float(sigma / (-4 * tau)) ** 0.5) + near
    assume(s and tau and admissible(a, b, s, tau))
    return a, b, s, tau


def moving(known):
    try:
        return MotionO4.of(*known)
    except Inadmissible:
        assume(False)
        raise


def check_promise(known):
    motion = moving(known)
    rate = float(np.max(np.abs(initial_state(motion)[:3]))) + 1
    times = np.linspace(0.0, 3 / rate, 3)
    states, *radii = _states(motion, times, "closed", True)
    lost = loss(motion, times, states)
    assert lost <= 1e-12 or radii or np.isnan(lost)


@settings(max_examples=5, deadline=None)
@given(edges())
def test_the_promise_is_kept_or_another_method_follows(known):
    check_promise(known)


@pytest.mark.slow
@settings(max_examples=300, deadline=None)
@given(edges())
def test_the_promise_is_kept_or_another_method_follows_everywhere(known):
    check_promise(known)


@settings(max_examples=20, deadline=None)
@given(edges())
def test_any_integrator_starts_from_constants(known):
    """At t = 0 the state has the fields that are asked for, however close two roots are."""
    try:
        state = initial_state(moving(known))
    except MethodError:
        assume(False)
    alpha, beta = state[3:6], state[6:]
    a, b = map(float, known[:2])
    assert abs(np.linalg.norm(alpha) - a) < 1e-14 * a + 1e-15
    assert abs(np.linalg.norm(beta) - b) < 1e-14 * b + 1e-15
    assert abs(alpha @ beta) < 1e-14


def test_a_fast_top_is_followed_otherwise_and_this_is_said(capfd):
    fields = "--a 1.2 --b 0.7 --s 1 --tau=-1e8 --until 10 --samples 3"
    assert main(["motion", *fields.split()]) == 0
    out, err = capfd.readouterr()
    assert "ball follows the motion" in err and '"radius"' in out


def test_a_state_of_any_size_is_followed_and_no_constant_is_lost(capfd):
    """In another unit of time it is the same motion; what no float holds is told in digits."""
    for power in (-60, -200, 40):
        numbers = [f"{x}e{power}" for x in (1, 2, 3)] + [f"{x}e{2 * power}" for x in (1, 0, 2)]
        numbers = numbers if power > -200 else [f"{x}e-200" for x in (1, 2, 3, 1, 0, 2)]
        assert main(["motion", "--point", *numbers, "0", numbers[3], "0", "--until", "0"]) == 0
        invariants = json.loads(capfd.readouterr().out)["invariants"]
        assert all(Decimal(str(invariants[name])) != 0 for name in "abh")


def test_a_state_beside_a_set_is_followed_where_it_is(capfd):
    """Not its neighbour on the set, which may leave it, unless that is asked for."""
    on_N4 = json.loads(_printed(capfd, ["--a", "1", "--b", "0.4", "--m", "0.8", "--l", "0.9"]))
    state = on_N4["states"][0]
    point = [repr(x) for x in (*state["omega"], *state["alpha"], *state["beta"])]
    point[2] = repr(float(point[2]) + 3e-11)
    near = json.loads(_printed(capfd, ["--point", *point], "dop853 follows it"))["states"]
    assert near[0]["omega"][2] == float(point[2])


def _printed(capfd, arguments, said=""):
    assert main(["motion", *arguments, "--until", "1", "--samples", "2"]) == 0
    out, err = capfd.readouterr()
    assert said in err
    return out
