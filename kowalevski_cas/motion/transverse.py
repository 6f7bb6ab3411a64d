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

import numpy as np
from numpy.typing import NDArray

from kowalevski_cas.motion import formulas
from kowalevski_cas.motion.oscillation import Oscillation
from kowalevski_cas.motion.parameters import Parameters
from kowalevski_cas.motion.regimes import regime_of

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]


def transverse(states: Array) -> tuple[Complex, Complex]:
    """F1, F2 (…, 2) and the matrices (…, 2, 2) of d(F1,F2)/dt at states (…, 9)."""
    functions, rates = formulas.across()
    known = formulas.complex_variables()(*np.moveaxis(states, -1, 0), 1j)
    root = np.sqrt(known[0] * known[1])  # of x1x2
    F1, F2, U1, U2 = functions(*known, root)
    columns = [rates(*unit, U1, U2, *known[:2], root) for unit in ((1.0, 0.0), (0.0, 1.0))]
    entries = np.broadcast_arrays(*(column[row] for row in (0, 1) for column in columns), F1)[:4]
    matrix = 1j * np.stack(entries, axis=-1).reshape(*np.shape(F1), 2, 2)  # τ = it
    return np.stack((F1, F2), axis=-1), matrix


def distance(states: Array) -> Array:
    r"""How far states (…, 9) are from N⁴: :math:`|F_1|` and :math:`|F_2|` in one number (…).

    They are added in the ratio of the two entries of the matrix, so that the sum of
    squares stays the same along an elliptic motion, to first order.
    """
    values, matrix = transverse(states)
    ratio = abs(matrix[..., 1, 0] / matrix[..., 0, 1])
    found: Array = np.sqrt(abs(values[..., 0]) ** 2 * ratio + abs(values[..., 1]) ** 2)
    return found


def exponent(parameters: Parameters) -> complex:
    r"""The transverse exponent :math:`|\lambda|` or :math:`i|\lambda|`, per unit of time.

    Real for m < 0, where the motion is unstable unless it is zero, and imaginary for m > 0.
    """
    regime = regime_of(parameters)
    means = [
        mean(Oscillation(parameters, arc, first))
        for arc, first in ((regime.s1, True), (regime.s2, False))
    ]
    return complex(np.sqrt(complex(-parameters.m))) * abs(means[0] - means[1])


def mean(oscillation: Oscillation) -> float:
    r"""The mean of s over a period; a principal value where s passes infinity.

    With the substitution :math:`x=\mp(s-p)/(s-q)` both the time and its product with s
    are complete integrals in the form of Carlson, whose principal value SciPy gives.
    """
    from scipy.special import elliprf, elliprj

    p, q, u, v = oscillation.roots
    end = float(oscillation.root(q))
    if oscillation.kind == "exponential":  # from one double root to the other
        return (float(oscillation.root(p)) + end) / 2
    if oscillation.kind != "elliptic":  # at a root, or almost all the time near a double one
        return end
    side = -1.0 if oscillation.arc.infinite else 1.0
    ratios = [
        side * float(oscillation.gap(p, root)) / float(oscillation.gap(q, root)) for root in (u, v)
    ]
    share = elliprj(0.0, *ratios, side) / (3 * elliprf(0.0, *ratios))
    return end + float(oscillation.gap(p, q)) * side * float(share)
