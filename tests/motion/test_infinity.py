"""States with x1x2 = 0, where s1 is infinite and the motion as regular as elsewhere."""

from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
from flint import acb, arb
from hypothesis import assume, given
from hypothesis import strategies as st

from kowalevski_cas.motion import Inadmissible, load
from kowalevski_cas.motion.formulas import values_of_offer
from kowalevski_cas.motion.parameters import precision
from kowalevski_cas.motion.phases import as_fraction
from kowalevski_cas.motion.point import on_N4
from tests.motion.test_closed import motions, relative

closed = load("closed")
START, LATER = np.zeros(1), np.array([-1.0, 0.5, 2.0])


def moment(oscillation):
    """The time after which s1 is infinite: cn² + κ sn² = 0."""
    quotient = (-1 / oscillation.kappa).sqrt()
    if oscillation.kind == "elliptic":
        argument = acb.elliptic_f(acb(quotient.atan()), acb(oscillation.modulus_square)).real
    else:
        argument = quotient.asinh() if oscillation.kind == "separatrix" else arb(0)
    return as_fraction(argument / oscillation.rate)


@pytest.mark.slow
@given(motions(), st.sampled_from([1, -1]), st.fractions(-3, 3, max_denominator=9), st.booleans())
def test_the_state_tells_the_motion_also_there(motion, way, other, exactly):
    known = motion.parameters
    assume(known.b > Fraction(1, 10) and known.r_square > Fraction(1, 10))
    assume(-20 < known.m < 0 and known.ell_square > Fraction(1, 100))
    with precision(320):
        first = motion.oscillations()[0]
        assume(first.kind != "rest")
        motion = replace(motion, origins=(way * moment(first), other))
    state = closed(motion, START)[0]
    if exactly:
        state[3], state[4] = state[7], -state[6]
    found = on_N4(state.tolist())
    assert found.off < 1e-13
    assert relative(closed(found, START), state[None]) < 1e-13
    assert relative(closed(found, LATER), closed(motion, LATER)) < 1e-9


@given(st.lists(st.floats(-1, 1), min_size=3, max_size=3), st.floats(-3, 3), st.floats(0.1, 1))
def test_relations_16_are_empty_there_but_a_state_off_the_manifold_is_refused(omega, angle, height):
    # (16) holds wherever ξ1 = ξ2 = 0. Here b = 1 and r = height, and the limits of the printed
    # formulas give S2 and (ℓ − 2m s2)² < 1: on N⁴ s2² + S2² = 1 for the ℓ of the energy.
    cos, sin = np.cos(angle), np.sin(angle)
    state = [*omega, cos, sin, height, -sin, cos, 0.0]
    m = -(omega[0] ** 2 + omega[1] ** 2) / height**2
    assume(m < -1e-2)
    *_, h, _, p_square, _ = values_of_offer("constants")(*state)
    ell_square = 2 * p_square * m**2 + 2 * h * m + 1
    S2_square = (omega[2] - omega[0] / (m * height)) ** 2 / (-4 * m)
    x = omega[1] / (height * np.sqrt(-m))
    off = min(
        abs(S2_square + ((np.sqrt(max(ell_square, 0)) + sign * x) / (2 * m)) ** 2 - 1)
        for sign in (1, -1)
    )
    assume(off > 1e-3)
    with pytest.raises(Inadmissible):
        on_N4(state)
