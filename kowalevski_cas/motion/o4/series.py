r"""The Abelian differentials as series of cosines, in balls.

A differential f(φ)dφ is even, and analytic in a strip :math:`|{\rm Im}\,\varphi|\le S`: each factor
below its root, :math:`g_1\cos^2\frac\varphi2+g_2\sin^2\frac\varphi2`, is at least
:math:`\frac12(|g_1|+|g_2|-|g_1-g_2|\cosh S)` there. If M is a bound of f in the strip, the
coefficients of :math:`f=\sum a_k\cos k\varphi` are at most :math:`2Me^{-kS}`, and n values give
:math:`a_k` up to :math:`4Me^{-(2n-k)S}/(1-e^{-2nS})`.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import acosh, ceil, log

from flint import arb, arb_mat, ctx

from kowalevski_cas.motion.o4.point import Pair, VariableO4, cosines
from kowalevski_cas.motion.parameters import Inadmissible, MethodError

WIDEST, SHARE = 20.0, 0.98
"""The greatest cosh S, and its share of the way from 1 to the nearest root."""

MOST = 20000
"""Values of a differential, beyond which two roots are too close."""

LARGEST_TRANSFORM = 2500
"""Values that are transformed at most: the matrix for it is dense, and takes half a gigabyte."""


class DifferentialSeries:
    """Both differentials of a variable, v and n by dφ, at the precision of FLINT's context.

    Raises :class:`~kowalevski_cas.motion.parameters.Inadmissible` if the series hardly converge.
    """

    def __init__(self, variable: VariableO4) -> None:
        factors = _moduli(variable)
        nearest = min([WIDEST, *(float((x + y) / z) for x, y, z in factors if z > 0)])
        self._width = arb(acosh(max(1 + SHARE * (nearest - 1), 1.0)))
        cosh, square = self._width.cosh(), arb(1)
        least = [(x + y - z * cosh) / 2 for x, y, z in factors]
        for bound in least:
            square *= bound
        self._bounds = [
            variable.scale * (abs(x + y) + abs(x - y) * cosh) / 2 / square.sqrt()
            for x, y in reversed(variable.ends)
        ]
        if not (
            self._width > 0 and all(bound > 0 for bound in least) and self.terms(ctx.prec) <= MOST
        ):
            raise Inadmissible(
                "two roots are so close that the series of the quadratures hardly converge: s or τ "
                "farther from those where the tori of O⁴ degenerate would do"
            )
        count = self.terms(ctx.prec)
        self._values = [
            variable.differentials(cosines(arb(2 * j + 1) / (2 * count), arb.cos_pi), arb.sqrt)
            for j in range(count)
        ]

    def terms(self, bits: int) -> int:
        """How many coefficients there are that need not be smaller than 2^−bits."""
        largest = log(1 + max(map(float, self._bounds)))
        return ceil((bits * log(2) + largest) / float(self._width)) + 1

    def means(self) -> list[arb]:
        """The means of both differentials."""
        return [
            sum(values, arb(0)) / len(values) + self._error_ball(place, 0)
            for place, values in enumerate(zip(*self._values, strict=True))
        ]

    def sines(self) -> Callable[[arb], Pair]:
        """The integrals of both, less their means, as functions of φ.

        Raises :class:`~kowalevski_cas.motion.parameters.MethodError` for too many values.
        """
        count = len(self._values)
        if count > LARGEST_TRANSFORM:
            raise MethodError(
                f"two roots are so close that an enclosure needs series of {count} terms, and "
                f"{LARGEST_TRANSFORM} are the most that fit into memory; the other methods follow "
                "the motion"
            )
        transform = arb_mat.dct(count) * arb_mat([list(pair) for pair in self._values])
        scale = (arb(2) / count).sqrt()
        terms = [
            [(scale * transform[k, place] + self._error_ball(place, k)) / k for place in (0, 1)]
            for k in range(1, count)
        ]
        beyond = 2 * (-count * self._width).exp() / (1 - (-self._width).exp()) / count
        rest = [_around_zero(beyond * bound) for bound in self._bounds]

        def series(angle: arb) -> Pair:
            first, second = rest
            for k, (one, two) in enumerate(terms, 1):
                sine = (k * angle).sin()
                first, second = first + one * sine, second + two * sine
            return first, second

        return series

    def _error_ball(self, place: int, k: int) -> arb:
        """A ball for the error of a coefficient."""
        count = len(self._values)
        last = (-(2 * count - k) * self._width).exp() / (1 - (-2 * count * self._width).exp())
        return _around_zero(4 * self._bounds[place] * last)


def matrix(series: Sequence[DifferentialSeries], signs: Sequence[int]) -> arb_mat:
    """The matrix of the means with their signs: a row an equation, a column a variable."""
    columns = [[sign * x for x in one.means()] for sign, one in zip(signs, series, strict=True)]
    return arb_mat(columns).transpose()


def _moduli(variable: VariableO4) -> list[tuple[arb, arb, arb]]:
    """Of each factor below the root: the moduli of g1, g2 and g1 − g2."""
    found = [(abs(x), abs(y), abs(x - y)) for x, y in variable.factors]
    if variable.sigma is None:
        return found
    # n² − σv² is a product of two conjugate factors.
    (n1, n2), (v1, v2) = variable.ends
    pairs = ((n1, v1), (n2, v2), (n1 - n2, v1 - v2))
    x, y, z = ((n * n + variable.sigma * v * v).sqrt() for n, v in pairs)
    return [*found, (x, y, z), (x, y, z)]


def _around_zero(bound: arb) -> arb:
    return arb(0, bound.upper())
