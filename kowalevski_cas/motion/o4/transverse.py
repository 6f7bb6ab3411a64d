r"""Whether the tori of O⁴ are stable in the whole top.

On O⁴ the number s is a double root of a polynomial Q, of which the coefficients are the integrals.
The quadratic form :math:`2QQ''-(Q')^2` of the variation is an integral of it, and its determinant
has the sign of :math:`s\tau_3Q''(s)` (the section “The type of the critical points on O⁴” of the
derivation): the tori are elliptic where that is negative, and hyperbolic where it is positive.
"""

from __future__ import annotations

from kowalevski_cas.motion import formulas
from kowalevski_cas.motion.o4.parameters import ParametersO4
from kowalevski_cas.motion.parameters import ball, precision
from kowalevski_cas.paper.closed_form import HyperellipticForm

BITS = 512
"""To how many the sign is computed; it vanishes if it is zero to so many."""


def kind(parameters: ParametersO4) -> str:
    """Whether a torus of O⁴ is elliptic, hyperbolic, or degenerate.

    >>> kind(ParametersO4.of("1.2", "0.7", "-0.9", "0.6"))
    'elliptic'
    """
    with precision(BITS):
        s, tau, p_square, r_square = map(
            ball, (parameters.s, parameters.tau, parameters.p_square, parameters.r_square)
        )
        curvature = formulas.values_of_offer("curvature", HyperellipticForm)
        (second,) = curvature(s, tau, p_square.sqrt(), r_square.sqrt())
        rate = s * tau * second
    if rate.contains(0):
        return "degenerate"
    return "hyperbolic" if rate > 0 else "elliptic"
