r"""Jacobi's functions for arrays of times, by theta series of small nome.

A quadruple (T1, T2, T3, T4) has :math:`{\rm sn}:{\rm cn}:{\rm dn}:1=T_1:T_2:T_3:T_4`. The
phase is brought to within half a quarter period. For :math:`k^2\le\frac12` the series have the
nome :math:`q=e^{-\pi K'/K}\le e^{-\pi}`; for larger k, by Jacobi's imaginary transformation,
:math:`q'=e^{-\pi K/K'}` and hyperbolic functions. Either way each series is sin, cos or 1 times
a polynomial of degree three in the square of the sine, to the last bit, and every function
keeps its relative accuracy, also near its zeros and however close k is to 1.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from flint import arb, arb_poly

from kowalevski_cas.motion.arrays import Array
from kowalevski_cas.motion.oscillation import Oscillation
from kowalevski_cas.motion.phases import Phase, as_fraction, expansion, parts_needed

Quadruple = tuple[Array, Array, Array, Array]

TERMS = 4
"""Of each series: the next would be below 1e-21."""


def jacobi(oscillation: Oscillation, origin: arb, largest: float) -> Callable[[Array], Quadruple]:
    """The quadruple of n(t − origin) as a function of arrays of times t, |t| ≤ ``largest``."""
    if oscillation.kind == "rest":
        return _rest
    if oscillation.kind == "elliptic":
        return _Elliptic(oscillation, origin, largest)
    return _Elementary(oscillation, origin)


def _rest(t: Array) -> Quadruple:
    ones = np.ones_like(t)
    return np.zeros_like(t), ones, ones, ones


class _Elementary:
    """The limits k = 1."""

    def __init__(self, oscillation: Oscillation, origin: arb) -> None:
        self.exponential = oscillation.kind == "exponential"
        scale = oscillation.rate / (2 if self.exponential else 1)
        self.rate, self.origin = (expansion(as_fraction(x), 2) for x in (scale, origin))

    def __call__(self, t: Array) -> Quadruple:
        since = (t - self.origin[0]) - self.origin[1]
        u = since * self.rate[0]
        if self.exponential:
            u = np.clip(u, -150, 150)
            up, down = np.exp(u), np.exp(-u)
            return up, down, down, up
        sech = 1 / np.cosh(np.clip(u, -300, 300))
        return np.tanh(u), sech, sech, np.ones_like(t)


class _Elliptic:
    """The functions of modulus k, 0 < k < 1 (or k = 0), at the phases of times."""

    def __init__(self, oscillation: Oscillation, origin: arb, largest: float) -> None:
        quarter = oscillation.quarter
        rate = oscillation.rate / quarter
        self.phase = Phase(rate, -rate * origin, parts_needed(float(rate), largest))
        self.functions = JacobiFunctions(
            quarter, oscillation.complementary_quarter, oscillation.complement_square
        )

    def __call__(self, t: Array) -> Quadruple:
        return self.functions(*self.phase(t))


class JacobiFunctions:
    """The quadruple by the argument over K, which is a whole number from −2 to 2, and a rest."""

    def __init__(self, quarter: arb, other: arb, complement_square: arb) -> None:
        self.hyperbolic = bool(complement_square < 0.5)
        self.complement = float(complement_square.sqrt())
        if self.hyperbolic:
            quarter, other = other, quarter
        nome = (-arb.pi() * other / quarter).exp()
        self.scale = float(arb.pi() / 2 * (other / quarter if self.hyperbolic else 1))
        self.polynomials = [[float(c) for c in series] for series in _series(nome)]

    def __call__(self, quarter: Array, rest: Array) -> Quadruple:
        """T1, T2, T3, T4; the last two are positive."""
        y = rest * self.scale
        sine, cosine = (np.sinh(y), np.cosh(y)) if self.hyperbolic else (np.sin(y), np.cos(y))
        square = -sine * sine if self.hyperbolic else sine * sine
        p1, p2, p3, p4 = (_horner(polynomial, square) for polynomial in self.polynomials)
        sine *= p1
        cosine *= p2
        if self.hyperbolic:
            t1, t2, t3, t4 = sine, p4, p3, cosine
        else:
            t1, t2, t3, t4 = sine, cosine, p3, p4
        # sn, cn, dn (u + K) = cd, −k′ sd, k′ nd, and sn, cn (u + 2K) = −sn, −cn.
        odd = np.abs(quarter) == 1
        k = self.complement
        t1, t2 = np.where(odd, t2, t1), np.where(odd, -k * t1, t2)
        t3, t4 = np.where(odd, k * t4, t3), np.where(odd, t3, t4)
        sign = np.where((quarter == -1) | (np.abs(quarter) == 2), -1.0, 1.0)
        t1 *= sign
        t2 *= sign
        return t1, t2, t3, t4


def _horner(polynomial: list[float], x: Array) -> Array:
    *rest, last = polynomial
    value = np.full_like(x, last)
    for coefficient in reversed(rest):
        value *= x
        value += coefficient
    return value


def _series(q: arb) -> list[list[arb]]:
    r"""The four theta functions by :math:`X=\sin^2z`: over sin z, over cos z, and whole.

    They are scaled so that their quotients by the fourth are sn, cn and dn.
    """
    one, twice = arb_poly([1]), arb_poly([2, -4])  # 2 cos 2z = 2 − 4X
    sines, cosines, even = [-one, one], [one, one], [arb_poly([1, -2]), one]
    for chebyshev in (sines, cosines, even):
        while len(chebyshev) <= TERMS:
            chebyshev.append(twice * chebyshev[-1] - chebyshev[-2])
    theta1 = theta2 = theta3 = theta4 = arb_poly()
    for n in range(TERMS):
        odd, square = q ** (n * (n + 1)), q ** (n * n) * (2 if n else 1)
        theta1 += odd * (-1) ** n * sines[n + 1]
        theta2 += odd * cosines[n + 1]
        theta3 += square * even[n + 1]
        theta4 += square * (-1) ** n * even[n + 1]
    at_zero = [theta2[0], theta3[0], theta4[0]]
    scales = (at_zero[1] / at_zero[0], at_zero[2] / at_zero[0], at_zero[2] / at_zero[1], arb(1))
    thetas = theta1, theta2, theta3, theta4
    return [(scale * theta).coeffs() for scale, theta in zip(scales, thetas, strict=True)]
