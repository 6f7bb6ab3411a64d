r"""The separated variables at a state; the phase and the sign of one from its values at t = 0.

The values s, S, f are multiplied by a weight, which is zero where s is infinite.
"""

from __future__ import annotations

from fractions import Fraction

from flint import acb, arb

from kowalevski_cas.motion import formulas
from kowalevski_cas.motion.formulas import exactly
from kowalevski_cas.motion.oscillation import Oscillation
from kowalevski_cas.motion.parameters import Inadmissible, Parameters, ball
from kowalevski_cas.motion.phases import as_fraction
from kowalevski_cas.motion.regimes import PHI, Arc, coordinates

Values = tuple[arb, arb, arb, arb]
"""s, S, f, each times the weight, and the weight."""


def variables(state: list[Fraction], parameters: Parameters, root: arb) -> tuple[Values, Values]:
    """The values of both variables at a state, from the printed formulas solved for them."""
    omega1, omega2, omega3, _, alpha2, alpha3, beta1, _, beta3 = map(ball, state)
    r_square, m, ell = ball(parameters.r_square), ball(parameters.m), parameters.ell
    r = r_square.sqrt()
    _, total, *_ = map(ball, exactly(formulas.values_of_offer("constants"), state))
    s1, s2 = (total + r_square) / (2 * root), (total - r_square) / (2 * root)
    d = r_square / root
    S1, S2 = alpha3 * d / r, beta3 * d / r
    by_f1, by_f2 = r * (ell - 2 * m * s2) / (2 * d), r * (ell - 2 * m * s1) / (2 * d)
    by_product, product = r_square / (2 * d**2), -alpha2 - beta1
    # ω1 and ω2 give f2 and f1; one of them surely, the other by ω3 and α2 + β1 as well.
    if parameters.m > 0:
        f1 = omega2 / by_f1
        f2 = _least_squares(
            (by_f2, omega1), (S1 / d, -omega3 - S2 * f1 / d), (by_product * f1, product)
        )
    else:
        f2 = omega1 / by_f2
        f1 = _least_squares(
            (by_f1, omega2), (S2 / d, -omega3 - S1 * f2 / d), (by_product * f2, product)
        )
    return (s1, S1, f1, arb(1)), (s2, S2, f2, arb(1))


def at_infinity(state: list[Fraction], parameters: Parameters, sign: int) -> tuple[Values, Values]:
    """The values of both variables where s1 = ∞, over s1; ``sign`` is that of f1/s1 = ±2√−m there.

    What the printed formulas say in the limit, f1² = −φ(s1) among them.
    """
    omega1, omega2, omega3, _, _, alpha3, *_ = map(ball, state)
    r, m = ball(parameters.r_square).sqrt(), ball(parameters.m)
    if parameters.m > 0:
        raise Inadmissible("x1x2 = 0 at the state and m > 0: it is not on N⁴, where s1 is finite")
    S1, f1 = alpha3 / r, 2 * sign * (-m).sqrt()
    f2 = -omega1 / (m * r)
    S2 = -(omega3 + S1 * f2) / f1
    s2 = (parameters.ell - 2 * omega2 / (r * f1)) / (2 * m)
    return (arb(1), S1, f1, arb(0)), (s2, S2, f2, arb(1))


def _least_squares(*equations: tuple[arb, arb]) -> arb:
    """The best x for coefficient·x = value, in the least squares."""
    above = sum((c * v for c, v in equations), arb(0))
    below = sum((c * c for c, _ in equations), arb(0))
    return above / below if below > 0 else arb(0)


def arc_of(oscillation: Oscillation, values: Values) -> Arc | None:
    """The arc of a motion that the regime does not tell: at rest on a double root, or downwards."""
    s, S, f, _ = values
    p, q, u, v = oscillation.roots
    if oscillation.kind not in ("separatrix", "exponential"):
        return None
    if S == 0 and f == 0:
        if abs(s - oscillation.root(p)) < abs(s - oscillation.root(q)):
            if oscillation.kind == "separatrix":
                return None  # at a simple root S or f is not zero: no motion has these values
            p, q, u, v = q, p, v, u
        return Arc((q, u, v, p), infinite=False)
    if oscillation.kind == "exponential" and S * f * oscillation.orientation < 0:
        return Arc((q, p, v, u), oscillation.arc.infinite)
    return None


def start(oscillation: Oscillation, values: Values) -> tuple[Fraction, int]:
    """The time t_j and the sign with which a variable has these values at t = 0."""
    _, S, f, _ = values
    if oscillation.kind == "rest":
        value = S if oscillation.field_roots == (2, 3) else f * oscillation.orientation
        return Fraction(0), _sign(value)
    p, q, _, _ = oscillation.roots
    distances = {root: _distance(oscillation, root, values) for root in oscillation.roots}
    weighted = [distances[root] / oscillation.coefficients[root] for root in (p, q)]
    weight = _sign(sum(weighted, arb(0)))  # Δ is negative beyond infinity
    first, second = (_positive(weight * value).sqrt() for value in weighted)
    S_sign, f_sign = _sign(weight * S), _sign(weight * oscillation.orientation * f)
    # sn carries the product of both signs, the other functions are positive from −K to K.
    sign = f_sign if 0 in oscillation.field_roots else S_sign
    argument = _argument(oscillation, first, second)
    if not argument.is_finite():  # no motion is ever at the double root to which it tends
        argument = arb(0)
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


def _distance(oscillation: Oscillation, root: str, values: Values) -> arb:
    """The distance s − root times the weight, by S² or f² where s itself would lose digits."""
    s, S, f, weight = values
    parameters = oscillation.parameters
    pair = next(p for p in (oscillation.field_pair, PHI) if root in p)
    other = pair[0] if root == pair[1] else pair[1]
    direct = s - weight * parameters.value(*coordinates(parameters, root))
    further = s - weight * parameters.value(*coordinates(parameters, other))
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
