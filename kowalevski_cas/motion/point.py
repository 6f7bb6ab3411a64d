r"""The motion through a point of N⁴: its constants, its phases, its signs.

A given state is exact for us, but hardly ever on N⁴ exactly. The constants are those of the
printed formulas at the state, to many more digits than any float has; the phases come from
whichever of s, S, f is the sharpest. So the closed form returns to a state on N⁴ within a few
units of its last place; a state to which it does not return has no motion here.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from math import sqrt

import numpy as np
from flint import arb

from kowalevski_cas.motion import formulas
from kowalevski_cas.motion.arrays import Array
from kowalevski_cas.motion.critical import LEAST_THETA, TOLERANCE, bounds
from kowalevski_cas.motion.formulas import exactly
from kowalevski_cas.motion.frame import BITS, rotate, state_from_numbers, turn_of
from kowalevski_cas.motion.methods.ball import enclosures
from kowalevski_cas.motion.methods.closed import states
from kowalevski_cas.motion.motion import Motion
from kowalevski_cas.motion.parameters import (
    Inadmissible,
    Parameters,
    Real,
    ball,
    extreme_ell,
    precision,
    root,
)
from kowalevski_cas.motion.phases import as_fraction
from kowalevski_cas.motion.regimes import NOISE, regime_of, without_rounding
from kowalevski_cas.motion.start import Values, arc_of, at_infinity, start, variables
from kowalevski_cas.motion.units import numbers_in_unit

ROUNDING = 1e-15
"""How far from a state, of its size, a motion may begin that is not improved."""

KNOWN = Fraction(1, 10**13)
"""To so much of its size a state is known: the closed form gives no better ones."""

STEPS = 3

SMALL = Fraction(1, 2**80)
"""The change of a constant or a phase, of its size, by which derivatives are found."""

NEWTON_BITS = 192


def on_N4(state: Sequence[Real]) -> Motion:
    """The motion that is at the state (ω, α, β), nine numbers, at t = 0.

    The fields may have any angle and lengths that are not equal and orthogonal at once. Raises
    :class:`~kowalevski_cas.motion.parameters.Inadmissible` if the state is not on N⁴, or so
    close to x1x2 = 0, where s1 is infinite, that it does not tell the motion. What is left of
    the distance, from rounding or because the state is only almost on N⁴, is the ``off`` of the
    motion.
    """
    given = state_from_numbers(state)
    infinite = _check(given)
    with precision(BITS):
        straight, turn = _straight(given)
        parameters, theta = _parameters(straight, infinite)
        if all(turn):
            parameters = without_rounding(parameters)
        motion = Motion(parameters, turn=turn, point=tuple(map(float, given)))
        if infinite:
            found = [_motion_at(motion, at_infinity(straight, parameters, s)) for s in (1, -1)]
        else:
            found = [_motion_at(motion, variables(straight, parameters, theta))]
        best = min(
            (_with_distance(motion, given) for motion in found), key=lambda motion: motion.off
        )
        if best.off > ROUNDING:
            unit = parameters.unit
            inner = numbers_in_unit(given, unit)
            fields, size = _sizes(inner)
            weights = np.repeat([float(size) ** -0.5, float(1 / fields)], (3, 6))
            fitted = nearest(best.in_unit(unit), inner, weights).in_unit(-unit)
            fitted = _with_distance(fitted, given)
            best = min(best, fitted, key=lambda motion: motion.off)
    if not best.off <= TOLERANCE:
        raise Inadmissible(
            f"the closed form with the constants of the state is {best.off:.3g} of its size away "
            "from it: the state is not on N⁴"
            + infinite
            * ", or so close to x1x2 = 0 that it does not tell the motion"
        )
    return best


def constants_at(state: Sequence[Fraction]) -> Parameters:
    """The constants of the printed formulas at a state that is on N⁴, at least almost."""
    with precision(BITS):
        return _parameters(_straight(state)[0], _is_infinite(state))[0]


def uncertainty(state: Sequence[Fraction]) -> list[Fraction]:
    """By how much each of the nine numbers of a state may be off."""
    omega, fields = (max(map(abs, part)) for part in (state[:3], state[3:]))
    return [KNOWN * omega] * 3 + [KNOWN * fields] * 6


def _motion_at(motion: Motion, values: tuple[Values, Values]) -> Motion:
    """The motion with these values at t = 0."""
    first, second = (
        arc_of(oscillation, value)
        for oscillation, value in zip(motion.oscillations(), values, strict=True)
    )
    motion = replace(motion, arcs=(first, second))
    origins, signs = zip(*map(start, motion.oscillations(), values), strict=True)
    return replace(motion, origins=origins, signs=signs)


def _with_distance(motion: Motion, given: list[Fraction]) -> Motion:
    """The motion with its distance from the state at t = 0."""
    return replace(motion, off=distance(states(motion, np.zeros(1))[0], given))


def nearest(motion: Motion, state: Sequence[Fraction], weights: Array) -> Motion:
    """The motion through the point of N⁴ nearest to a state, near which another motion begins.

    The fields stay as they are; differences from the state are multiplied by the weights. On a
    separating curve, where the state does not tell the phases, the motion is left as it is. Where
    x1x2 is almost zero the printed formulas divide by it, and lose the digits that the state still
    has: by the method of Gauss and Newton they are found again.
    """
    oscillations = motion.oscillations()
    if any(oscillation.kind != "elliptic" for oscillation in oscillations):
        return motion
    known = motion.parameters
    values = [known.m, as_fraction(known.ell), *motion.origins]
    times = (1 / as_fraction(oscillation.rate) for oscillation in oscillations)
    sizes = [abs(known.m), Fraction(1), *times]

    def move(values: Sequence[Fraction]) -> Motion:
        m, ell, t1, t2 = values
        parameters = Parameters.of(known.a, known.b, m, ell)
        return replace(motion, parameters=parameters, origins=(t1, t2))

    def off(values: Sequence[Fraction]) -> list[Fraction]:
        (there,) = enclosures(move(values), [0.0], NEWTON_BITS)
        return [as_fraction(x) - y for x, y in zip(there, state, strict=True)]

    try:
        for _ in range(STEPS):
            here = off(values)
            columns = []
            for place, size in enumerate(sizes):
                beside = off([x + (k == place) * size * SMALL for k, x in enumerate(values)])
                columns.append([float((x - y) / SMALL) for x, y in zip(beside, here, strict=True)])
            jacobian = np.array(columns).T * weights[:, None]
            step, *_ = np.linalg.lstsq(jacobian, -weights * [float(x) for x in here])
            values = [
                x + Fraction(float(part)) * size
                for x, part, size in zip(values, step, sizes, strict=True)
            ]
        return move(values)
    except (Inadmissible, ArithmeticError):
        return motion


def distance(state: Array, given: list[Fraction]) -> float:
    """How far a state is from a given one, relative to its size: ω and fields each of their own."""
    there = [Fraction(x) for x in state.tolist()]
    fields, whole = _sizes(given)
    differences = _sizes([x - y for x, y in zip(there, given, strict=True)])
    # |Δω|² is the difference of the two sizes of weight 2.
    omega_square = float((differences[1] - differences[0]) / whole)
    return max(float(differences[0] / fields), sqrt(omega_square))


def _sizes(state: Sequence[Fraction]) -> tuple[Fraction, Fraction]:
    """The size of the fields and of the state, both of weight 2: ω has weight 1, fields 2."""
    fields = max(map(abs, state[3:]))
    return fields, max(map(abs, state[:3])) ** 2 + fields


def _check(state: list[Fraction]) -> bool:
    """Whether s1 is infinite, x1x2 = 0; refuse a state off N⁴, and fields that do not separate.

    The left sides of (16) are compared with the size of the state, exactly.
    """
    *_, first, second = exactly(formulas.values_of_offer("integrals"), state)
    theta, *_, r_fourth = exactly(formulas.values_of_offer("constants"), state)
    if r_fourth == 0:
        raise Inadmissible("the fields are orthogonal and of equal size: r = 0, nothing separates")
    if _is_infinite(state):
        return True  # where (16) says nothing
    squares = bounds(theta, r_fourth, *_sizes(state))
    for number, value, square in zip((1, 2), (first, second), squares, strict=True):
        if value**2 > TOLERANCE**2 * square:
            raise Inadmissible(
                f"the state is not on N⁴: the left side of (16), equation {number}, is "
                f"{float(value**2 / square) ** 0.5:.3g} of its size"
            )
    return False


def _is_infinite(state: Sequence[Fraction]) -> bool:
    """Whether x1x2 = 0 at a state, as good as exactly: there s1 is infinite."""
    theta, *_, p_square, r_fourth = exactly(formulas.values_of_offer("constants"), state)
    found: bool = theta * p_square <= Fraction(LEAST_THETA) * r_fourth
    return found


def _straight(state: Sequence[Fraction]) -> tuple[list[Fraction], tuple[Fraction, Fraction]]:
    """The state in fields at right angles, and the turn that leads there."""
    _, _, a_square, b_square, c, *_ = exactly(formulas.values_of_offer("integrals"), state)
    turn = turn_of(a_square, b_square, c)
    if not all(turn):
        return rotate(state, *turn), turn
    fields, size = _sizes(state)
    return [
        x if (x**2 > NOISE**2 * size if place < 3 else abs(x) > NOISE * fields) else Fraction(0)
        for place, x in enumerate(rotate(state, *turn))
    ], turn


def _parameters(state: list[Fraction], infinite: bool) -> tuple[Parameters, arb]:
    """The constants at a state in fields at right angles, and the root of x1x2."""
    _, _, a_square, b_square, *_ = exactly(formulas.values_of_offer("integrals"), state)
    theta, total, w_square, h, g, p_square, r_fourth = exactly(
        formulas.values_of_offer("constants"), state
    )
    # 2g − p²h = r⁴m and ℓ² = 2p²m² + 2hm + 1: no division by x1x2.
    m = (2 * g - p_square * h) / r_fourth
    ell_square = 2 * p_square * m**2 + 2 * h * m + 1
    a, b, least = (root(square) for square in (a_square, b_square, theta))
    direct = w_square + total * m  # ℓ√(x1x2)
    # Either loses digits, the root of ℓ² near ℓ = 0 and the quotient near x1x2 = 0. On N⁴
    # exactly they agree, and ℓ² is rational.
    lost, other = 1 + abs(2 * h * m) + 2 * p_square * m**2, w_square + abs(total * m)
    exactly_on = direct**2 == theta * ell_square
    if infinite or exactly_on or lost**2 * theta < other**2 * ell_square:
        square = max(ell_square, Fraction(0))
        found = Parameters(a, b, m, square, (-1 if direct < 0 else 1) if square else 0)
    else:
        found = Parameters.of(a, b, m, as_fraction(ball(direct) / ball(least)))
    try:
        regime_of(found)
    except Inadmissible:
        # A state at rest in one variable is on the boundary, but for rounding.
        bound = extreme_ell(a, b, m)
        if abs(abs(found.ell) - ball(bound)) > ball(TOLERANCE * (1 + abs(bound))):
            raise
        found = Parameters.of(a, b, m, bound if found.ell_sign > 0 else -bound)
    return found, ball(least)
