r"""The separated variables at a state."""

from __future__ import annotations

from fractions import Fraction

from flint import arb

from kowalevski_cas.motion import formulas
from kowalevski_cas.motion.formulas import exactly
from kowalevski_cas.motion.parameters import Inadmissible, Parameters, ball
from kowalevski_cas.motion.start import Values


def variables(state: list[Fraction], parameters: Parameters, root: arb) -> tuple[Values, Values]:
    """The values of both variables at a state, from the printed formulas solved for them."""
    omega1, omega2, omega3, _, alpha2, alpha3, beta1, _, beta3 = map(ball, state)
    r_square, m, ell = ball(parameters.r_square), ball(parameters.m), parameters.ell
    r = r_square.sqrt()
    _, total, *_ = map(ball, exactly(formulas.offered("constants"), state))
    s1, s2 = (total + r_square) / (2 * root), (total - r_square) / (2 * root)
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


def _fitted(*equations: tuple[arb, arb]) -> arb:
    """The best x for coefficient·x = value, in the least squares."""
    above = sum((c * v for c, v in equations), arb(0))
    below = sum((c * c for c, _ in equations), arb(0))
    return above / below if below > 0 else arb(0)
