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

from collections.abc import Iterator

import numpy as np
from flint import acb, arb

from kowalevski_cas.motion.oscillation import Oscillation
from kowalevski_cas.motion.parameters import Inadmissible, Parameters, Real, ball, precision
from kowalevski_cas.motion.regimes import Regime, all_regimes, ells, regime_of


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
    """Whether a torus is elliptic, hyperbolic, or degenerate: λ = 0, to the last digit of ℓ."""
    if parameters.m > 0:
        return "elliptic"
    here = difference(parameters)
    return "degenerate" if here == 0 or _vanishes_beside(parameters) else "hyperbolic"


def _vanishes_beside(parameters: Parameters) -> bool:
    """Whether λ = 0 between the floats below and above ℓ, inside one regime."""
    ell = float(parameters.ell)
    signs, regimes = set(), set()
    for beside in (np.nextafter(ell, -np.inf), np.nextafter(ell, np.inf)):
        try:
            there = Parameters.of(parameters.a, parameters.b, parameters.m, float(beside))
            regimes.add(regime_of(there))
        except Inadmissible:
            return False
        signs.add(bool(difference(there) > 0))
    return len(signs) == 2 and len(regimes) == 1


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
