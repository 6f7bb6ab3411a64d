r"""The Abelian differentials as series of cosines, in balls.

A differential f(ψ)dψ is even and analytic in a strip :math:`|{\rm Im}\,\psi|\le S`, and largest on
its edge. If M is a bound of f there, the coefficients of :math:`f=\sum a_k\cos k\psi` are at most
:math:`2Me^{-kS}`, and 2n values give :math:`a_k` up to :math:`4Me^{-(2n-k)S}/(1-e^{-2nS})`.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cached_property
from math import ceil, log, sqrt

from flint import acb, arb, arb_mat, ctx

from kowalevski_cas.motion.o4.arithmetic import BALLS, Pair
from kowalevski_cas.motion.o4.uniformization import Uniformization
from kowalevski_cas.motion.parameters import Inadmissible, MethodError, precision

SHARE = 0.85
"""The share of the way to the nearest singularity."""

WIDEST = 3.0
"""The greatest S: wider strips save few terms."""

MOST = 1 << 14
"""Values of a differential, beyond which two roots are too close."""

GROWTH = 1e3
"""How much larger a differential is taken to be on the edge than on the real line."""

PIECES, MOST_PIECES = 40, 1 << 14
"""Of the edge of the strip, as many by its width, and at most so many, in search of a bound."""


class DifferentialSeries:
    """Both differentials of a variable, v and n by dψ, at the precision of FLINT's context.

    Raises :class:`~kowalevski_cas.motion.parameters.Inadmissible` if the series hardly converge.
    """

    def __init__(self, by: Uniformization) -> None:
        self.by = by
        self._width = min(float(by.width.lower()) * SHARE, WIDEST)
        # from here on e^(−kS) is below the last bit, also for a bound that is so much larger
        count = ceil((ctx.prec * log(2) + log(GROWTH)) / self._width) if self._width > 0 else MOST
        if count >= MOST:
            raise Inadmissible(
                "two pairs of roots are so close that the series of the quadratures hardly "
                "converge: s or τ farther from those where the tori of O⁴ degenerate would do"
            )
        self._count = count + 1
        angles = [arb(j) / self._count * arb.pi() for j in range(self._count + 1)]
        values = [self.differentials(angle) for angle in angles]
        self._coefficients = [_cosines([x[place] for x in values]) for place in (0, 1)]

    def differentials(self, angle: arb) -> Pair:
        """Both at an angle."""
        by = self.by
        return by.differentials(by.at(angle), by.variable, by.rate, BALLS.root)

    def means(self) -> list[arb]:
        """The means of both differentials, but for what the number of values leaves."""
        return [cosines[0] for cosines in self._coefficients]

    def sines(self) -> list[list[arb]]:
        """The coefficients of sin ψ, sin 2ψ, … in the integrals of both, but for the same."""
        return [[a / k for k, a in enumerate(cosines) if k] for cosines in self._coefficients]

    # -- enclosures -------------------------------------------------------------------------

    def enclose_means(self) -> list[arb]:
        """Balls for the means."""
        return [mean + self._error_ball(place, 0) for place, mean in enumerate(self.means())]

    def enclose_sines(self) -> Callable[[arb], Pair]:
        """The integrals of both, less their means, as functions of ψ that give balls."""
        # the sum of all e^(−kS)/k that are left out, with 1/n for each 1/k
        beyond = 2 * (-self._count * self._strip).exp() / (1 - (-self._strip).exp()) / self._count
        series = []
        for place, coefficients in enumerate(self.sines()):
            known = [a + self._error_ball(place, k) / k for k, a in enumerate(coefficients[:-1], 1)]
            series.append((_sum_of_sines(known), _around_zero(beyond * self._bounds[place])))

        def integrals(angle: arb) -> Pair:
            first, second = (sines(angle) + rest for sines, rest in series)
            return first, second

        return integrals

    @property
    def _strip(self) -> arb:
        return arb(self._width)

    @cached_property
    def _bounds(self) -> tuple[arb, arb]:
        """Bounds of both in the strip: on its edge, where ψ runs from 0 to π, piece by piece."""
        count = ceil(PIECES / self._width)
        pieces = [(arb(2 * place + 1) / (2 * count), arb(0.5) / count) for place in range(count)]
        first, second, tried = arb(0), arb(0), 0
        with precision(64):
            while pieces:
                middle, half = pieces.pop()
                one, two = self._sizes(middle, half)
                if one.is_finite() and two.is_finite():
                    first, second = max(first, one), max(second, two)
                else:
                    pieces += [(middle - half / 2, half / 2), (middle + half / 2, half / 2)]
                tried += 1
                if tried > MOST_PIECES:
                    raise MethodError("no bound of the differentials: roots are too close")
        return first, second

    def _sizes(self, middle: arb, half: arb) -> Pair:
        """Bounds of both on a piece of the edge, by its middle and half its length over π."""
        piece = (middle + arb(0, half.upper())) * arb.pi()
        by = self.by
        c, s = by.pair(by.functions(acb(piece, self._strip)), 1, BALLS)
        quotient = s / c
        squares = acb(1), quotient * quotient
        n, v = by.variable.pair(squares)
        common = by.rate / abs(by.below(by.variable, squares)).sqrt()
        return (abs(v) * common).upper(), (abs(n) * common).upper()

    def _error_ball(self, place: int, k: int) -> arb:
        """A ball for the error of a coefficient."""
        values, strip = 2 * self._count, self._strip
        last = (-(values - k) * strip).exp() / (1 - (-values * strip).exp())
        return _around_zero(4 * self._bounds[place] * last)


def matrix(means: Sequence[Sequence[arb]], signs: Sequence[int]) -> arb_mat:
    """The matrix of the means with their signs: a row an equation, a column a variable."""
    columns = [[sign * x for x in pair] for sign, pair in zip(signs, means, strict=True)]
    return arb_mat(columns).transpose()


def _cosines(values: Sequence[arb]) -> list[arb]:
    """The coefficients of 1, cos ψ, cos 2ψ, … of an even function, by values from 0 to π."""
    count = len(values) - 1
    # the function is even: from π to 2π its values are the same ones backwards
    found = acb.dft([*values, *values[-2:0:-1]])[: count + 1]
    first, *rest = (x.real / count for x in found)
    return [first / 2, *rest]


def _sum_of_sines(coefficients: Sequence[arb]) -> Callable[[arb], arb]:
    """The series of sin ψ, sin 2ψ, … by blocks: a recursion would widen the balls at each step."""
    width = ceil(sqrt(len(coefficients)))
    padded = [*coefficients, *[arb(0)] * (-len(coefficients) % width)]
    rows = arb_mat([padded[k : k + width] for k in range(0, len(padded), width)])

    def series(angle: arb) -> arb:
        inner = arb_mat([(k * angle).sin_cos() for k in range(1, width + 1)])
        outer = [(k * width * angle).sin_cos() for k in range(rows.nrows())]
        return sum(
            (
                sines * cosine + cosines * sine
                for (sines, cosines), (sine, cosine) in zip(
                    (rows * inner).tolist(), outer, strict=True
                )
            ),
            arb(0),
        )

    return series


def _around_zero(bound: arb) -> arb:
    return arb(0, bound.upper())
