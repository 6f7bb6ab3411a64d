r"""Whether the tori of O⁴ are stable in the whole top.

On O⁴ the number s is a double root of a polynomial Q, of which the coefficients are the integrals.
The quadratic form :math:`2QQ''-(Q')^2` of the variation is an integral of it, and its determinant
has the sign of :math:`s\tau_3Q''(s)` (the section “The type of the critical points on O⁴” of the
derivation): the tori are elliptic where that is negative, and hyperbolic where it is positive.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction

from flint import arb

from kowalevski_cas.motion import formulas
from kowalevski_cas.motion.frame import state_from_numbers
from kowalevski_cas.motion.o4.parameters import ParametersO4
from kowalevski_cas.motion.o4.start import constants_at
from kowalevski_cas.motion.parameters import Inadmissible, Real, ball, precision
from kowalevski_cas.motion.point import uncertainty
from kowalevski_cas.motion.rounding import last_digits, vanishes
from kowalevski_cas.paper.closed_form import HyperellipticForm

BITS = 512
"""To how many the sign is computed; it vanishes if it is zero to so many."""


def kind(parameters: ParametersO4) -> str:
    """Whether a torus of O⁴ is elliptic, hyperbolic, or, to the last digit, degenerate.

    >>> kind(ParametersO4.of("1.2", "0.7", "-0.9", "0.6"))
    'elliptic'
    """
    given = [parameters.a, parameters.b, parameters.s, parameters.tau]
    return _kind(lambda numbers: ParametersO4(*numbers), given, last_digits(given))


def kind_at(state: Sequence[Real]) -> str:
    """The same for the torus through a state on O⁴, as far as that is known."""
    given = state_from_numbers(state)
    return _kind(constants_at, given, uncertainty(given))


def _kind(
    constants: Callable[[Sequence[Fraction]], ParametersO4],
    given: Sequence[Fraction],
    steps: Sequence[Fraction],
) -> str:
    """The type of a torus with the constants that follow from the given numbers."""

    def number(numbers: Sequence[Fraction]) -> float | None:
        try:
            return float(_rate(constants(numbers)))
        except Inadmissible:
            return None

    rate = _rate(constants(given))
    if rate.contains(0) or vanishes(number, given, steps):
        return "degenerate"
    return "hyperbolic" if rate > 0 else "elliptic"


def _rate(known: ParametersO4) -> arb:
    """The number sτ₃Q″(s)."""
    with precision(BITS):
        s, tau, p_square, r_square = map(ball, (known.s, known.tau, known.p_square, known.r_square))
        curvature = formulas.values_of_offer("curvature", HyperellipticForm)
        (second,) = curvature(s, tau, p_square.sqrt(), r_square.sqrt())
        return arb(s * tau * second)
