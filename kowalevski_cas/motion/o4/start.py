r"""The motion through a point of O⁴: its constants, its angles, its signs.

A given state is exact for us, but hardly ever on O⁴ exactly. The constants are those of the printed
formulas at the state, to many more digits than any float has; the variables, and the signs that fit,
give two angles, which are then those that fit best. A state to which the closed form does not
return has no motion here.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import product

import numpy as np
from flint import acb, arb

from kowalevski_cas.motion import formulas
from kowalevski_cas.motion.critical import TOLERANCE
from kowalevski_cas.motion.formulas import exactly
from kowalevski_cas.motion.frame import BITS, turn_of, turned
from kowalevski_cas.motion.methods.closed import states
from kowalevski_cas.motion.o4.parameters import ParametersO4
from kowalevski_cas.motion.o4.motion import MotionO4
from kowalevski_cas.motion.o4.point import PhasePoint
from kowalevski_cas.motion.o4.variable import Variable
from kowalevski_cas.motion.parameters import Inadmissible, Real, ball, precision, root, usable
from kowalevski_cas.motion.phases import as_fraction
from kowalevski_cas.motion.point import distance

SIGNS = np.array(list(product((1, -1), repeat=5))).T
"""All signs that a phase point can have, a column each."""

STEP, STEPS = 1e-7, 4
"""The difference of angles that gives derivatives, and how many Newton steps are made."""


def on_O4(state: Sequence[Real]) -> MotionO4:
    """The motion that is at the state (ω, α, β), nine numbers, at t = 0.

    Raises :class:`~kowalevski_cas.motion.parameters.Inadmissible` if the state is not on O⁴, or the
    tori of its constants degenerate. What is left of the distance is the ``off`` of the motion.
    """
    given = [usable(value) for value in state]
    if len(given) != 9:
        raise ValueError(f"a state has nine numbers, ω, α, β; {len(given)} are given")
    with precision(BITS):
        _, _, a_square, b_square, c, *_ = exactly(formulas.integrals(), given)
        turn = turn_of(a_square, b_square, c)
        straight = turned(given, *turn)
        constants, pairs = _separated(straight)
        motion = MotionO4(constants, turn=turn, point=tuple(map(float, given)))
        angles = [
            float(Variable(constants, arc, lambda x: x).angle(pair))
            for arc, pair in zip(motion.arcs, pairs, strict=True)
        ]
        motion = _fitted(motion, angles, np.array(straight, dtype=float))
    off = distance(states(motion, np.zeros(1))[0], given)
    if not off <= TOLERANCE:
        raise Inadmissible(
            f"the closed form with the constants of the state is {off:.3g} of its size away "
            "from it: the state is not on O⁴"
        )
    return replace(motion, off=off)


def _separated(state: list[Fraction]) -> tuple[ParametersO4, list[tuple[arb, arb]]]:
    """The constants at a state in fields at right angles, and both variables as quotients."""
    if not any(state[:2]):
        raise Inadmissible("ω1 = ω2 = 0 at the state: it does not tell the constant s of O⁴")
    known = formulas.complex_variables()(*(acb(ball(x)) for x in state), acb(0, 1))
    found = [acb(value).real for value in formulas.hyperelliptic("constants")(*known)]
    s, tau, X, both = map(as_fraction, found)
    _, _, a_square, b_square, *_ = exactly(formulas.integrals(), state)
    constants = ParametersO4(root(a_square), root(b_square), s, tau)
    xi = both - tau
    square, *_ = _variables(X, xi, constants, 0)
    q = root(max(square, Fraction(0)))
    _, *numerators, v, product = _variables(X, xi, constants, q)
    n1, n2 = sorted(numerators, key=lambda n: abs(n + tau * v))  # |u1 + τ| ≤ r² ≤ |u2 + τ|
    first = (n1, v) if v else (product, n2)
    pairs = [(ball(n), ball(v)) for n, v in (first, (n2, v))]
    return constants, pairs


def _variables(
    X: Fraction, xi: Fraction, constants: ParametersO4, q: Fraction
) -> list[Fraction]:
    """The discriminant, the numerators of u1 and u2, their denominator and that of u1u2."""
    return exactly(
        formulas.hyperelliptic("variables"), [X, xi, constants.tau, constants.sigma, Fraction(q)]
    )


def _fitted(motion: MotionO4, angles: list[float], state: np.ndarray) -> MotionO4:
    """The motion with the signs, and angles near these, that fit the state best."""
    weights = np.repeat([max(abs(state[:3])) ** 2 + max(abs(state[3:]))], 9)
    weights[:3] **= 0.5

    def missing(signs: np.ndarray, angles: np.ndarray) -> np.ndarray:
        point = PhasePoint(motion.parameters, motion.regime, signs, float, np.sqrt)
        halves = [(np.cos(angle / 2), np.sin(angle / 2)) for angle in angles]
        with np.errstate(invalid="ignore"):
            found = np.array(np.broadcast_arrays(*point(*halves)))
        return (state[:, None] - found) / weights[:, None]

    found = np.array(angles)
    errors = np.linalg.norm(missing(SIGNS, found[:, None]), axis=0)
    signs = SIGNS[:, np.nanargmin(errors)]
    for _ in range(STEPS):
        columns = missing(signs, found[:, None] + STEP * np.array([[0, 1, 0], [0, 0, 1]]))
        slopes = (columns[:, :1] - columns[:, 1:]) / STEP
        found = found + np.linalg.lstsq(slopes, columns[:, 0], rcond=None)[0]
    first, second = map(Fraction, found.tolist())
    return replace(motion, angles=(first, second), signs=tuple(signs.tolist()))
