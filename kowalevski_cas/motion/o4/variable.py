r"""One of the two variables by an angle: an arc between two roots, run to and fro.

With the ends :math:`e_1, e_2` of the arc

.. math:: u = \frac{n}{v}, \quad n = e_1\cos^2\tfrac\varphi2+\lambda e_2\sin^2\tfrac\varphi2, \quad
    v = \cos^2\tfrac\varphi2+\lambda\sin^2\tfrac\varphi2,

so that each :math:`n-ev` is a sum of two terms, the radicals are analytic in φ/2, and an arc
through infinity, where λ < 0, is one like any other. |λ| puts the neighbouring roots at equal
distances from the arc: then series in φ converge fast. The product of the four radicals is
:math:`y=\pm\sqrt{\prod(n-ev)/2s\tau}`, and the two Abelian differentials are

.. math:: \frac{v^2du}{y}\,(v, n) = \pm(v, n)\sqrt{\frac{2s\tau|\lambda|}{\prod'(n-ev)}}\,d\varphi

with the product of the factors that do not vanish at the ends.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from flint import arb

from kowalevski_cas.motion.o4.parameters import HIGH, KAPPA, LOW, MU, ParametersO4
from kowalevski_cas.motion.o4.regimes import Arc
from kowalevski_cas.motion.parameters import ball

Number = Any
"""A float, an array of floats, or a ball."""

Pair = tuple[Number, Number]


class Variable:
    """The variable on one arc, in one arithmetic."""

    def __init__(self, constants: ParametersO4, arc: Arc, number: Callable[[arb], Number]) -> None:
        (first, last), (below, above), gap = arc.roots, arc.neighbours, constants.gap
        quotient = gap(below, first) * gap(above, first) / (gap(below, last) * gap(above, last))
        factor = abs(quotient).sqrt() * (-1 if arc.infinite else 1)
        self._n = number(constants.root(first)), number(factor * constants.root(last))
        self._v = number(factor)
        self._ends = first, last
        self._gaps: dict[str, Pair] = {}
        for name in constants.roots:
            pair = gap(first, name), factor * gap(last, name)
            sign = 1 if sum(pair) > 0 else -1
            self._gaps[name] = number(sign * pair[0]), number(sign * pair[1])
        both = abs(2 * constants.s * constants.tau)
        self.scale = number((ball(both) * abs(factor)).sqrt())
        self._sigma = number(ball(-constants.sigma)) if constants.sigma < 0 else None
        squares = ("mu", MU, 1 / constants.tau), ("A", (LOW,), 1), ("B", (HIGH,), 1), (
            "K", KAPPA, 1 / (2 * constants.s))  # fmt: skip
        self._radicals = [
            (name, roots, number(ball(abs(scale)).sqrt())) for name, roots, scale in squares
        ]

    @property
    def moduli(self) -> list[tuple[Number, Number, Number]]:
        """Of each factor :math:`g_1\\cos^2+g_2\\sin^2` below the root of the differentials:
        the moduli of g1, g2 and g1 − g2."""
        found = [
            (abs(x), abs(y), abs(x - y)) for name, (x, y) in self._gaps.items() if name not in self._ends
        ]
        if self._sigma is None:
            return found
        (n1, n2), v2, sigma = self._n, self._v, self._sigma
        squares = (n1 * n1 + sigma, n2 * n2 + sigma * v2 * v2,
                   (n1 - n2) * (n1 - n2) + sigma * (1 - v2) * (1 - v2))
        return [*found, *[tuple(square**0.5 for square in squares)] * 2]

    @property
    def pair_moduli(self):
        """The same of v and n."""
        (n1, n2), v2 = self._n, self._v
        return [(abs(x), abs(y), abs(x - y)) for x, y in ((v2 * 0 + 1, v2), (n1, n2))]

    def pair(self, squares: Pair) -> Pair:
        """The pair n, v by the squares of cos φ/2 and sin φ/2."""
        cos, sin = squares
        return self._n[0] * cos + self._n[1] * sin, cos + self._v * sin

    def angle(self, pair: tuple[arb, arb]) -> arb:
        """The angle from 0 to π at which the variable is n/v; the nearest one beyond the ends."""
        n, v = pair
        sin, cos = n - self._n[0] * v, self._n[1] * v - self._v * n
        if sin + cos < 0:
            sin, cos = -sin, -cos
        return 2 * arb.atan2(*(max(x.mid(), arb(0)).sqrt() for x in (sin, cos)))

    def radicals(self, half: Pair, root: Callable[[Number], Number]) -> dict[str, Number]:
        """The square roots of those of n² − σv², … that φ/2 makes analytic, by cos φ/2, sin φ/2."""
        cos, sin = half
        squares = cos * cos, sin * sin
        found = {}
        for name, roots, scale in self._radicals:
            if name == "mu" and self._sigma is not None:
                square = self._complex(squares)
            else:
                square = 1
                for end in roots:
                    square = square * self._factor(end, squares)
            value = scale * root(square)
            for end in roots:
                if end in self._ends:
                    value = value * (sin if end == self._ends[0] else cos)
            found[name] = value
        return found

    def differentials(self, squares: Pair, root: Callable[[Number], Number]) -> Pair:
        """The Abelian differentials by dφ."""
        product = 1 if self._sigma is None else self._complex(squares)
        for name in self._gaps:
            if name not in self._ends:
                product = product * self._factor(name, squares)
        n, v = self.pair(squares)
        common = self.scale / root(product)
        return v * common, n * common

    def _factor(self, name: str, squares: Pair) -> Number:
        """|n − ev|, without what vanishes at an end."""
        first, last = self._gaps[name]
        if name in self._ends:
            return last if name == self._ends[0] else first
        return first * squares[0] + last * squares[1]

    def _complex(self, squares: Pair) -> Number:
        """The positive n² − σv², where σ is negative."""
        n, v = self.pair(squares)
        return n * n + self._sigma * v * v
