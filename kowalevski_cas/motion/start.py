r"""The phase and the sign of one variable from its values at t = 0.

The values s, S, f are multiplied by a weight, which is zero where s is infinite.
"""

from __future__ import annotations

from fractions import Fraction

from flint import acb, arb

from kowalevski_cas.motion.oscillation import Oscillation
from kowalevski_cas.motion.parameters import ball
from kowalevski_cas.motion.phases import as_fraction
from kowalevski_cas.motion.regimes import PHI, Arc, coordinates

Values = tuple[arb, arb, arb, arb]
"""s, S, f, each times the weight, and the weight."""


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
