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

import numpy as np
from flint import acb, arb, fmpq

from kowalevski_cas.motion import formulas
from kowalevski_cas.motion.compile import Function
from kowalevski_cas.motion.frame import turned
from kowalevski_cas.motion.methods.closed import states
from kowalevski_cas.motion.motion import Motion
from kowalevski_cas.motion.oscillation import Oscillation
from kowalevski_cas.motion.parameters import (
    Inadmissible,
    Parameters,
    Real,
    ball,
    precision,
    rational_root,
    usable,
)
from kowalevski_cas.motion.phases import as_fraction
from kowalevski_cas.motion.regimes import (
    FIELD_1,
    FIELD_2,
    PHI,
    Arc,
    coordinates,
    extreme_ell,
    gap,
    regime_of,
)

BITS = 320
"""To how many bits constants and phases are found."""

NOISE = Fraction(1, 2**256)
"""What is smaller beside the rest after a turn by a rounded angle, is zero."""

TOLERANCE = Fraction(1, 10**8)
"""How far from N⁴, and from the closed form at t = 0, a state may be, relative to its size."""

LEAST_THETA = 1e-12
"""The least x1x2 over r⁴/p², that is p²/(s1 − s2)²: its root is what s2 loses in accuracy."""


def through(state: Sequence[Real]) -> Motion:
    """The motion that is at the state (ω, α, β), nine numbers, at t = 0.

    The fields may have any angle and lengths that are not equal and orthogonal at once. Raises
    :class:`~kowalevski_cas.motion.parameters.Inadmissible` if the state is not on N⁴, or too
    close to x1x2 = 0, where s1 is infinite. What is left of the distance, from rounding or
    because the state is only almost on N⁴, is the ``off`` of the motion.
    """
    given = [usable(value) for value in state]
    if len(given) != 9:
        raise ValueError(f"a state has nine numbers, ω, α, β; {len(given)} are given")
    _check(given)
    with precision(BITS):
        turn = _turn(given)
        straight = _straight(given, turn)
        parameters, root = _parameters(straight)
        if all(turn):
            parameters = _coinciding(parameters)
        motion = Motion(parameters, turn=turn, point=tuple(map(float, given)))
        S1, f1, S2, f2, s1, s2 = _variables(straight, parameters, root)
        values = ((s1, S1, f1), (s2, S2, f2))
        arcs = [_arc(*pair) for pair in zip(motion.oscillations(), values, strict=True)]
        motion = replace(motion, arcs=(arcs[0], arcs[1]))
        starts = [_start(o, *v) for o, v in zip(motion.oscillations(), values, strict=True)]
    origins, signs = zip(*starts, strict=True)
    return _returning(replace(motion, origins=origins, signs=signs), given)


def _returning(motion: Motion, given: list[Fraction]) -> Motion:
    """The motion with its distance from the state at t = 0; refused if it is not there."""
    start = [Fraction(x) for x in states(motion, np.zeros(1))[0].tolist()]
    fields, whole = _sizes(given)
    differences = _sizes([x - y for x, y in zip(start, given, strict=True)])
    # |Δω|² is the difference of the two sizes of weight 2.
    omega_square = (differences[1] - differences[0]) / whole
    off = max(float(differences[0] / fields), float(omega_square) ** 0.5)
    if off > TOLERANCE:
        raise Inadmissible(
            f"the closed form with the constants of the state is {off:.3g} of its size away from "
            "it: the state is not on N⁴, or where its constants do not tell the motion"
        )
    return replace(motion, off=off)


def _sizes(state: list[Fraction]) -> tuple[Fraction, Fraction]:
    """The size of the fields and of the state, both of weight 2: ω has weight 1, fields 2."""
    fields = max(map(abs, state[3:]))
    return fields, max(map(abs, state[:3])) ** 2 + fields


def _exactly(compiled: Function, state: list[Fraction]) -> list[Fraction]:
    """The values of compiled formulas, by FLINT's rational numbers."""
    values = compiled(*(fmpq(x.numerator, x.denominator) for x in state))
    return [Fraction(int(value.p), int(value.q)) for value in values]


def _check(state: list[Fraction]) -> None:
    """Refuse a state off N⁴, and fields for which N⁴ is not separated.

    The left sides of (16) are compared with |ξ|·|fields|·size and r²|ξ|²·size², which
    bound them: so the answer is that for (νω, ν²α, ν²β), the same motion in another unit of time.
    """
    *_, first, second = _exactly(formulas.integrals(), state)
    theta, *_, p_square, r_fourth = _exactly(formulas.constants(), state)
    if r_fourth == 0:
        raise Inadmissible("the fields are orthogonal and of equal size: r = 0, nothing separates")
    if theta * p_square <= Fraction(LEAST_THETA) * r_fourth:
        raise Inadmissible(
            f"x1x2 = {float(theta):.3g} at the state: s1 is infinite or nearly so, and the state "
            "does not tell the motion; take one a moment later"
        )
    fields, size = _sizes(state)
    for number, value, square in (
        (1, first, theta * fields**2 * size),
        (2, second, r_fourth * theta**2 * size**2),
    ):
        if value**2 > TOLERANCE**2 * square:
            raise Inadmissible(
                f"the state is not on N⁴: the left side of (16), equation {number}, is "
                f"{float(value):.3g} there, {float(value**2 / square) ** 0.5:.3g} of what it can be"
            )


def _turn(state: list[Fraction]) -> tuple[Fraction, Fraction]:
    """The cosine and sine of the angle χ that makes the fields orthogonal, a > b."""
    _, _, a_square, b_square, c, *_ = _exactly(formulas.integrals(), state)
    if c == 0:
        return Fraction(a_square > b_square), Fraction(a_square < b_square)
    twice = arb.atan2(ball(2 * c), ball(a_square - b_square))
    sine, cosine = (twice / 2).sin_cos()
    return as_fraction(cosine), as_fraction(sine)


def _straight(state: list[Fraction], turn: tuple[Fraction, Fraction]) -> list[Fraction]:
    """The state in fields at right angles."""
    if not all(turn):
        return turned(state, *turn)
    fields, size = _sizes(state)
    return [
        x if (x**2 > NOISE**2 * size if place < 3 else abs(x) > NOISE * fields) else Fraction(0)
        for place, x in enumerate(turned(state, *turn))
    ]


def _coinciding(rounded: Parameters) -> Parameters:
    """The constants for which roots that differ by rounding are the same."""
    ends = {
        root: coordinates(rounded, end)[1]
        for root in PHI
        for end in (*FIELD_1, *FIELD_2)
        if abs(rounded.value(*gap(rounded, root, end))) < ball(NOISE * rounded.a)
    }
    if not ends:
        return rounded
    m = 1 / (ends["A"] - ends["C"]) if len(ends) == 2 else rounded.m
    ell = 2 * m * ends["A"] - 1 if "A" in ends else 2 * m * ends["C"] + 1
    return Parameters.of(rounded.a, rounded.b, m, ell)


def _parameters(state: list[Fraction]) -> tuple[Parameters, arb]:
    """The constants at a state in fields at right angles, and the root of x1x2."""
    _, _, a_square, b_square, *_ = _exactly(formulas.integrals(), state)
    theta, total, w_square, h, g, p_square, r_fourth = _exactly(formulas.constants(), state)
    # 2g − p²h = r⁴m and ℓ² = 2p²m² + 2hm + 1: no division by x1x2.
    m = (2 * g - p_square * h) / r_fourth
    ell_square = 2 * p_square * m**2 + 2 * h * m + 1
    a, b, root = (_root(square) for square in (a_square, b_square, theta))
    direct = w_square + total * m  # ℓ√(x1x2)
    # Either loses digits, the root of ℓ² near ℓ = 0 and the quotient near x1x2 = 0. On N⁴
    # exactly they agree, and ℓ² is rational.
    lost, other = 1 + abs(2 * h * m) + 2 * p_square * m**2, w_square + abs(total * m)
    if direct**2 == theta * ell_square or lost**2 * theta < other**2 * ell_square:
        found = Parameters(a, b, m, ell_square, _sign(direct) if ell_square else 0)
    else:
        found = Parameters.of(a, b, m, as_fraction(ball(direct) / ball(root)))
    try:
        regime_of(found)
    except Inadmissible:
        # A state at rest in one variable is on the boundary, but for rounding.
        bound = extreme_ell(a, b, m)
        if abs(abs(found.ell) - ball(bound)) > ball(TOLERANCE * (1 + abs(bound))):
            raise
        found = Parameters.of(a, b, m, bound if found.ell_sign > 0 else -bound)
    return found, ball(root)


def _root(square: Fraction) -> Fraction:
    exactly = rational_root(square)
    return as_fraction(ball(square).sqrt()) if exactly is None else exactly


def _variables(state: list[Fraction], parameters: Parameters, root: arb) -> tuple[arb, ...]:
    """S1, f1, S2, f2, s1, s2 at a state, from the printed formulas solved for them."""
    omega1, omega2, omega3, _, alpha2, alpha3, beta1, _, beta3 = map(ball, state)
    _, total, *_ = _exactly(formulas.constants(), state)
    r_square, m, ell = ball(parameters.r_square), ball(parameters.m), parameters.ell
    r = r_square.sqrt()
    s1, s2 = (ball(total) + r_square) / (2 * root), (ball(total) - r_square) / (2 * root)
    d = r_square / root
    S1, S2 = alpha3 * d / r, beta3 * d / r
    by_f1, by_f2 = r * (ell - 2 * m * s2) / (2 * d), r * (ell - 2 * m * s1) / (2 * d)
    by_product, product = r_square / (2 * d**2), -alpha2 - beta1
    # ω1 and ω2 give f2 and f1; one of them surely, the other by ω3 and α2 + β1 as well.
    if parameters.m > 0:
        f1 = omega2 / by_f1
        f2 = _fitted((by_f2, omega1), (S1 / d, -omega3 - S2 * f1 / d), (by_product * f1, product))
    else:
        f2 = omega1 / by_f2
        f1 = _fitted((by_f1, omega2), (S2 / d, -omega3 - S1 * f2 / d), (by_product * f2, product))
    return S1, f1, S2, f2, s1, s2


def _fitted(*equations: tuple[arb, arb]) -> arb:
    """The best x for coefficient·x = value, in the least squares."""
    above = sum((c * v for c, v in equations), arb(0))
    below = sum((c * c for c, _ in equations), arb(0))
    return above / below if below > 0 else arb(0)


def _arc(oscillation: Oscillation, values: tuple[arb, arb, arb]) -> Arc | None:
    """The arc of a motion that the regime does not tell: at rest on a double root, or downwards."""
    s, S, f = values
    p, q, u, v = oscillation.roots
    if oscillation.kind not in ("separatrix", "exponential"):
        return None
    if S == 0 and f == 0:
        if abs(s - oscillation.root(p)) < abs(s - oscillation.root(q)):
            p, q, u, v = q, p, v, u
        return Arc((q, u, v, p), infinite=False)
    if oscillation.kind == "exponential" and S * f * oscillation.orientation < 0:
        return Arc((q, p, v, u), oscillation.arc.infinite)
    return None


def _start(oscillation: Oscillation, s: arb, S: arb, f: arb) -> tuple[Fraction, int]:
    """The time t_j and the sign with which a variable has these values at t = 0."""
    if oscillation.kind == "rest":
        value = S if oscillation.field_roots == (2, 3) else f * oscillation.orientation
        return Fraction(0), _sign(value)
    p, q, _, _ = oscillation.roots
    distances = {root: _distance(oscillation, root, s, S, f) for root in oscillation.roots}
    weighted = [distances[root] / oscillation.coefficients[root] for root in (p, q)]
    weight = _sign(sum(weighted, arb(0)))  # Δ is negative beyond infinity
    first, second = (_positive(weight * value).sqrt() for value in weighted)
    S_sign, f_sign = _sign(weight * S), _sign(weight * oscillation.orientation * f)
    # sn carries the product of both signs, the other functions are positive from −K to K.
    sign = f_sign if 0 in oscillation.field_roots else S_sign
    argument = _argument(oscillation, first, second)
    if oscillation.kind != "exponential":
        argument *= S_sign * f_sign
    return as_fraction(-argument / oscillation.rate), sign


def _argument(oscillation: Oscillation, first: arb, second: arb) -> arb:
    """The argument at which the first two of the quadruple have this quotient, both positive."""
    if oscillation.kind == "exponential":
        return (first / second).log()
    if oscillation.kind == "separatrix":
        return (first / second).asinh()
    amplitude = arb.atan2(first, second)
    value = acb.elliptic_f(acb(amplitude), acb(oscillation.modulus_square))
    return arb(value.real.mid())


def _distance(oscillation: Oscillation, root: str, s: arb, S: arb, f: arb) -> arb:
    """The distance s − root, by S² or f² where s itself would lose digits."""
    parameters = oscillation.parameters
    pair = next(p for p in (oscillation.field_pair, PHI) if root in p)
    other = pair[0] if root == pair[1] else pair[1]
    direct = s - parameters.value(*coordinates(parameters, root))
    further = s - parameters.value(*coordinates(parameters, other))
    if abs(direct) > abs(further):
        return direct
    sign = 1 if oscillation.first else -1
    if pair == oscillation.field_pair:
        return sign * S * S / further
    return -sign * f * f / (4 * ball(parameters.m) * further)


def _sign(value: arb | Fraction) -> int:
    return -1 if value < 0 else 1


def _positive(value: arb) -> arb:
    middle = value.mid()
    return middle if middle > 0 else arb(0)
