r"""The motion through a point of O⁴: its constants, its angles, its signs.

A given state is exact for us, but hardly ever on O⁴ exactly. The constants are those of the
printed formulas at the state, to many more digits than any float has; the angles are those of the
variables there, moved to where the phase point fits best. A state to which the closed form does
not return has no motion here.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import pairwise, product

import numpy as np
from flint import acb, arb

from kowalevski_cas.motion import formulas
from kowalevski_cas.motion.arrays import Array
from kowalevski_cas.motion.critical import TOLERANCE, residuals
from kowalevski_cas.motion.formulas import exactly
from kowalevski_cas.motion.frame import BITS, rotate, state_from_numbers, turn_of
from kowalevski_cas.motion.methods.closed import states
from kowalevski_cas.motion.o4.arithmetic import BALLS, FLOATS
from kowalevski_cas.motion.o4.motion import MotionO4
from kowalevski_cas.motion.o4.parameters import ParametersO4
from kowalevski_cas.motion.o4.point import PhasePointO4
from kowalevski_cas.motion.o4.variable import VariableO4
from kowalevski_cas.motion.parameters import Inadmissible, Real, ball, precision, root
from kowalevski_cas.motion.phases import as_fraction
from kowalevski_cas.motion.point import distance
from kowalevski_cas.motion.units import numbers_in_unit
from kowalevski_cas.paper.closed_form import HyperellipticForm

LEAST_GAP = Fraction(1, 2**40)
"""Between two roots, relative to the largest: with less the rounding of a state parts them."""

SIGNS = np.array(list(product((1.0, -1.0), repeat=5))).T
"""All signs that a phase point can have, a column each."""

STEP, STEPS = 1e-7, 4
"""The difference of angles that gives derivatives, and how many Newton steps are made."""


def on_O4(state: Sequence[Real]) -> MotionO4:
    """The motion that is at the state (ω, α, β), nine numbers, at t = 0.

    Raises :class:`~kowalevski_cas.motion.parameters.Inadmissible` if the state is not on O⁴, or the
    tori of its constants degenerate. What is left of the distance is the ``off`` of the motion.
    """
    given = state_from_numbers(state)
    residual = float(residuals(np.array([given], dtype=float))["O4"][0])
    if not residual <= TOLERANCE:
        raise Inadmissible(
            f"the state is not on O⁴: its equations leave {residual:.3g} of its size"
        )
    with precision(BITS):
        straight, turn = _straight(given)
        constants, pairs = _separate(straight)
        motion = MotionO4(constants, turn=turn, point=tuple(map(float, given)))
        # Either quotient may be u1.
        angles = [
            [float(VariableO4(constants, arc, BALLS).angle(pair)) for pair in order]
            for arc, order in zip(motion.arcs, (pairs, pairs[::-1]), strict=True)
        ]
        unit = constants.unit
        inner = np.array(numbers_in_unit(straight, unit), dtype=float)
        motion = _best_fit(motion.in_unit(unit), np.array(angles), inner).in_unit(-unit)
    off = distance(states(motion, np.zeros(1))[0], given)
    if not off <= TOLERANCE:
        raise Inadmissible(
            f"the closed form with the constants of the state is {off:.3g} of its size away "
            "from it: the state is not on O⁴, or two roots are too close for it to tell the motion"
        )
    return replace(motion, off=off)


def constants_at(state: Sequence[Fraction]) -> ParametersO4:
    """The constants of the printed formulas at a state that is on O⁴, at least almost."""
    with precision(BITS):
        return _constants(_straight(state)[0])[0]


def _straight(state: Sequence[Fraction]) -> tuple[list[Fraction], tuple[Fraction, Fraction]]:
    """The state in fields at right angles, and the turn that leads there."""
    _, _, a_square, b_square, c, *_ = exactly(formulas.values_of_offer("integrals"), state)
    turn = turn_of(a_square, b_square, c)
    return rotate(state, *turn), turn


def _constants(state: Sequence[Fraction]) -> tuple[ParametersO4, Fraction, Fraction]:
    """The constants at a state in fields at right angles, and x1x2, x1x2 + z1z2."""
    if not any(state[:2]):
        raise Inadmissible("ω1 = ω2 = 0 at the state: it does not tell the constant s of O⁴")
    known = formulas.values_of_offer("complex_variables")(*(acb(ball(x)) for x in state), acb(0, 1))
    found = [
        acb(value).real
        for value in formulas.values_of_offer("constants", HyperellipticForm)(*known)
    ]
    s, tau, X, total = map(as_fraction, found)
    _, _, a_square, b_square, *_ = exactly(formulas.values_of_offer("integrals"), state)
    return ParametersO4(root(a_square), root(b_square), s, tau), X, total


def _separate(state: Sequence[Fraction]) -> tuple[ParametersO4, list[tuple[arb, arb]]]:
    """The constants at a state in fields at right angles, and both variables as quotients."""
    constants, X, total = _constants(state)
    tau = constants.tau
    largest = abs(tau) + constants.r_square
    names = constants.roots
    close = [constants.gap(y, x) <= ball(LEAST_GAP * largest) for x, y in pairwise(names)]
    squares = constants.sigma, constants.kappa_square
    if any(close) or any(abs(square) <= LEAST_GAP * largest**2 for square in squares):
        raise Inadmissible("two roots coincide at the state, but for rounding: the tori degenerate")
    xi = total - tau
    given = [X, xi, tau, constants.sigma]
    variables = formulas.values_of_offer("variables", HyperellipticForm)
    square, *_ = exactly(variables, [*given, Fraction(0)])
    q = root(max(square, Fraction(0)))
    _, *ends, v, both = exactly(variables, [*given, q])
    larger = max(ends, key=abs)  # the other is both / larger, where nothing cancels
    return constants, [(ball(n), ball(d)) for n, d in ((larger, v), (both, larger))]


def _best_fit(motion: MotionO4, angles: Array, state: Array) -> MotionO4:
    """The motion with the signs, and angles near a column of these, that fit the state best."""
    weights = np.repeat([max(abs(state[:3])) ** 2 + max(abs(state[3:]))], 9)
    # fields have the dimension of ω²: each variable counts by the size of its kind
    weights[:3] **= 0.5

    def difference(signs: Array, angles: Array) -> Array:
        point = PhasePointO4(motion.parameters, motion.regime, list(signs), FLOATS)
        one, two = ((np.cos(angle / 2), np.sin(angle / 2)) for angle in angles)
        with np.errstate(invalid="ignore", divide="ignore"):  # signs for which E is not real
            found = np.array(np.broadcast_arrays(*point(one, two)))
        wanted: Array = (state[:, None] - found) / weights[:, None]
        return wanted

    signs, starts = np.tile(SIGNS, angles.shape[1]), np.repeat(angles, SIGNS.shape[1], axis=1)
    errors = np.linalg.norm(difference(signs, starts), axis=0)
    best = np.argmin(np.nan_to_num(errors, nan=np.inf))
    signs, found = signs[:, best], starts[:, best]
    for _ in range(STEPS):
        columns = difference(signs, found[:, None] + STEP * np.array([[0, 1, 0], [0, 0, 1]]))
        if not np.isfinite(columns).all():
            raise Inadmissible(
                "no phase point with the constants of the state is near: it is not on O⁴"
            )
        slopes = (columns[:, :1] - columns[:, 1:]) / STEP
        found = found + np.linalg.lstsq(slopes, columns[:, 0], rcond=None)[0]
    first, second = map(Fraction, found.tolist())
    return replace(motion, angles=(first, second), signs=tuple(map(int, signs)))
