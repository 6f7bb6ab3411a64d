"""The equations (3), (5) integrated in balls by Taylor series: what every method has to agree with."""

from fractions import Fraction

import numpy as np
from flint import arb, arb_series, ctx

from kowalevski_cas.motion.formulas import values_of_offer
from kowalevski_cas.motion.parameters import ball, precision
from kowalevski_cas.motion.units import in_unit, unit_of

BITS, ORDER, STEP = 160, 30, Fraction(1, 16)


def integrated(start, time):
    """The state at a time, from one whose size is about 1; each step errs by about 2⁻¹¹⁰."""
    rates, state = values_of_offer("equations"), [arb(float(x)) for x in start]
    count = max(1, -(-abs(time) // STEP))
    cap = ctx.cap
    try:
        ctx.cap = ORDER + 1
        with precision(BITS):
            step = ball(Fraction(time) / count)
            for _ in range(int(count)):
                series = [arb_series([x], prec=ORDER + 1) for x in state]
                for order in range(1, ORDER + 1):
                    found = rates(*(arb_series(one.coeffs()[:order], prec=order) for one in series))
                    series = [
                        arb_series([x, *one.integral().coeffs()[1:]], prec=order + 1)
                        for x, one in zip(state, found, strict=True)
                    ]
                state = [_value(one.coeffs(), step) for one in series]
    finally:
        ctx.cap = cap
    return np.array([float(x.mid()) for x in state])


def _value(coefficients, x):
    total = arb(0)
    for coefficient in reversed(coefficients):
        total = total * x + coefficient
    return total.mid()


def apart(states, exact):
    """How far states are from exact ones: ω relative to the state, the fields to these."""
    difference = np.abs(np.asarray(states) - exact)
    fields = np.max(difference[..., 3:], axis=-1) / np.max(np.abs(exact[..., 3:]), axis=-1)
    omega = np.max(in_unit(difference, unit_of(exact))[..., :3], axis=-1)
    return float(np.max(np.maximum(omega, fields)))
