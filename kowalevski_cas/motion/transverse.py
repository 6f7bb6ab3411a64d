r"""How motions near :math:`N^4` leave it: what the cofactor matrix of (15) predicts.

:math:`(F_1,F_2)' = M(F_1,F_2)` is the linear equation across :math:`N^4` along a
motion on it, here in the real time :math:`t`. The matrix has no diagonal, and on
:math:`N^4`, where :math:`U_1+U_2=2r^4m`, the quotient of its other entries is constant.
So in the time :math:`\int dt/\sqrt{x_1x_2}=r^{-2}\int(s_1-s_2)\,dt` the equation has constant
coefficients, with the exponents :math:`\pm r^2\sqrt{-m}` (both facts are claims of
the derivation), and per unit of :math:`t`

.. math:: \lambda=\sqrt{-m}\,\bigl(\langle s_1\rangle-\langle s_2\rangle\bigr)

with the means of :math:`s_1`, :math:`s_2` over their periods. Tori with m > 0 are elliptic;
those with m < 0 are hyperbolic, except on the curves where :math:`\lambda=0`: on
:math:`\ell=0`, and on one inside each of the regimes :math:`A<-a<-b<b<C<a` and
:math:`-a<A<-b<C<b<a`. For m < 0 the mean of :math:`s_1` is a principal value, for the motion
passes :math:`x_1x_2=0`, where the root changes its sign; so the sign of
:math:`\lambda` has no meaning.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction

import numpy as np
from flint import acb, arb

from kowalevski_cas.motion.frame import state_from_numbers
from kowalevski_cas.motion.oscillation import Oscillation
from kowalevski_cas.motion.parameters import Inadmissible, Parameters, Real, ball, precision
from kowalevski_cas.motion.point import constants_at, uncertainty
from kowalevski_cas.motion.regimes import Regime, all_regimes, coincidences, ells, regime_of
from kowalevski_cas.motion.rounding import last_digits, vanishes


def exponent(parameters: Parameters) -> complex:
    r"""The transverse exponent :math:`|\lambda|` or :math:`i|\lambda|`, per unit of time.

    Real for m < 0, where the motion is unstable unless it is zero, and imaginary for m > 0.
    """
    return complex(np.sqrt(complex(-parameters.m))) * abs(difference(parameters))


def difference(parameters: Parameters) -> float:
    r""":math:`\langle s_1\rangle-\langle s_2\rangle`; zero where it is less than 1e-30 a."""
    regime = regime_of(parameters)
    for bits in (192, 768, 3072, 12288):  # so many where roots are as close
        with precision(bits):
            first, second = (
                mean(Oscillation(parameters, arc, first))
                for arc, first in ((regime.s1, True), (regime.s2, False))
            )
            gap = first - second
            if gap.is_finite():
                break
    return 0.0 if abs(gap) < ball(parameters.a) * 1e-30 else float(gap)


def degenerate(a: Real, b: Real, m: Real) -> Iterator[tuple[Regime, float]]:
    r"""The ℓ > 0 for which :math:`\lambda=0` inside a regime.

    It is looked for where the means are in one order near the one end of the regime, and in
    the other order near the other.
    """
    from scipy.optimize import brentq

    def with_sign(ell: float) -> float:
        return difference(Parameters.of(a, b, m, ell))

    for regime in all_regimes():
        low, high = ells(Parameters.of(a, b, m, 0), regime)
        margin = 1e-6 * (high - low)
        first, last = low + margin, high - margin
        if low < first < last < high < np.inf and with_sign(first) * with_sign(last) < 0:
            yield regime, brentq(with_sign, first, last, xtol=margin)


def kind(parameters: Parameters) -> str:
    """Whether a torus is elliptic, hyperbolic, or degenerate: λ = 0.

    It vanishes to the last digit of a, b, m and of ℓ, or of the energy where ℓ is irrational.
    """
    known, ell = parameters, parameters.rational_ell
    make, last = (Parameters.at_energy, known.h) if ell is None else (Parameters.of, ell)
    given = [known.a, known.b, known.m, last]
    return _kind(lambda numbers: make(*numbers), given, last_digits(given))


def kind_at(state: Sequence[Real]) -> str:
    """The same for the torus through a state on N⁴, as far as that is known."""
    given = state_from_numbers(state)
    return _kind(constants_at, given, uncertainty(given))


def _kind(
    constants: Callable[[Sequence[Fraction]], Parameters],
    given: Sequence[Fraction],
    steps: Sequence[Fraction],
) -> str:
    """The type of a torus with the constants that follow from the given numbers."""
    known = constants(given)
    if known.m > 0:
        return "elliptic"
    regime = regime_of(known)

    def square(numbers: Sequence[Fraction]) -> float | None:
        """That of the difference with its sign, which is smooth also in ℓ² at ℓ = 0."""
        try:
            beside = constants(numbers)
            gap = difference(beside) if regime_of(beside) == regime else None
        except Inadmissible:
            return None
        return None if gap is None else gap * abs(gap)

    if difference(known) == 0:
        return "degenerate"
    # On a separating curve itself the difference is that of the asymptotic motion.
    lost = not coincidences(known) and vanishes(square, given, steps)
    return "degenerate" if lost else "hyperbolic"


def mean(oscillation: Oscillation) -> arb:
    r"""The mean of s over a period; a principal value where s passes infinity.

    With the substitution :math:`x=\mp(s-p)/(s-q)` both the time and its product with s
    are complete integrals in the form of Carlson; for the principal value of R_J see DLMF
    19.20.14.
    """
    p, q, u, v = oscillation.roots
    end = oscillation.root(q)
    if oscillation.kind == "exponential":  # from one double root to the other
        return (oscillation.root(p) + end) / 2
    if oscillation.kind != "elliptic":  # at a root, or almost all the time near a double one
        return end
    side = -1 if oscillation.arc.infinite else 1
    y, z = (side * oscillation.gap(p, root) / oscillation.gap(q, root) for root in (u, v))
    RF = acb.elliptic_rf(acb(0), acb(y), acb(z)).real
    last = z * (1 + y) / (1 + z) if side < 0 else arb(1)
    RJ = acb.elliptic_rj(acb(0), acb(y), acb(z), acb(last)).real
    if side < 0:
        RJ = ((last - z) * RJ - 3 * RF) / (1 + z)
    return end + oscillation.gap(p, q) * side * RJ / (3 * RF)
