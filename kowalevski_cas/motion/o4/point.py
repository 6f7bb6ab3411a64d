r"""The phase point on O⁴ by two angles, in one arithmetic: each is of an arc, run to and fro.

With the ends :math:`e_1, e_2` of the arc

.. math:: u = \frac{n}{v}, \quad n = e_1\cos^2\tfrac\varphi2+\lambda e_2\sin^2\tfrac\varphi2, \quad
    v = \cos^2\tfrac\varphi2+\lambda\sin^2\tfrac\varphi2,

so that each :math:`n-ev` is a sum of two terms, the radicals are analytic in φ/2, and an arc
through infinity, where λ < 0, is one like any other. |λ| puts the neighbouring roots at equal
distances from the arc: then series in φ converge fast. The product y of the four radicals has the
square :math:`\pm\prod(n-ev)/2s\tau`, and the two Abelian differentials are

.. math:: (v, n)\frac{v\,dn-n\,dv}{y} =
    \pm(v, n)\sqrt{\frac{2s\tau|\lambda|}{\prod'(n-ev)}}\,d\varphi

with the product of the factors that do not vanish at the ends.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Any

from flint import arb

from kowalevski_cas.motion import formulas
from kowalevski_cas.motion.o4.parameters import HIGH, KAPPA, LOW, MU, ParametersO4
from kowalevski_cas.motion.o4.regimes import RegimeO4
from kowalevski_cas.motion.parameters import ball
from kowalevski_cas.motion.regimes import Arc
from kowalevski_cas.paper.closed_form import HyperellipticForm

Number = Any
"""A float, an array of floats, or a ball."""

Pair = tuple[Number, Number]

Root = Callable[[Number], Number]
"""The square root in some arithmetic."""


class VariableO4:
    r"""The variable on one arc, in one arithmetic.

    ``scale`` is what the differentials have above their root, and ``factors`` are the pairs
    (g1, g2) of the factors :math:`g_1\cos^2\frac\varphi2+g_2\sin^2\frac\varphi2` below it.
    """

    def __init__(self, known: ParametersO4, arc: Arc, number: Callable[[arb], Number]) -> None:
        first, last, above, below = arc.roots
        gap = known.gap
        quotient = gap(below, first) * gap(above, first) / (gap(below, last) * gap(above, last))
        factor = abs(quotient).sqrt() * (-1 if arc.infinite else 1)
        self.ends = (
            (number(known.root(first)), number(factor * known.root(last))),
            (number(arb(1)), number(factor)),
        )
        self._factors: dict[str, Pair] = {}
        for name in known.roots:
            pair = gap(first, name), factor * gap(last, name)
            sign = 1 if sum(pair) > 0 else -1
            self._factors[name] = number(sign * pair[0]), number(sign * pair[1])
        self._arc = arc.ends
        self.scale = number((ball(abs(2 * known.s * known.tau)) * abs(factor)).sqrt())
        self.sigma = number(ball(-known.sigma)) if known.sigma < 0 else None
        squares = (
            (MU, 1 / known.tau),
            ((LOW,), Fraction(1)),
            ((HIGH,), Fraction(1)),
            (KAPPA, 1 / (2 * known.s)),
        )
        self._radicals = [(roots, number(ball(abs(x)).sqrt())) for roots, x in squares]

    @property
    def factors(self) -> list[Pair]:
        """The pairs of those factors that are linear in cos φ, and do not vanish at the ends."""
        return [pair for name, pair in self._factors.items() if name not in self._arc]

    def pair(self, squares: Pair) -> Pair:
        """The pair n, v by the squares of cos φ/2 and sin φ/2."""
        n, v = (first * squares[0] + last * squares[1] for first, last in self.ends)
        return n, v

    def angle(self, pair: tuple[arb, arb]) -> arb:
        """The angle from 0 to π at which the variable is n/v, or the nearest one of the arc."""
        (n1, n2), (_, factor) = self.ends
        sin, cos = pair[0] - n1 * pair[1], n2 * pair[1] - factor * pair[0]
        if sin + cos < 0:
            sin, cos = -sin, -cos
        return 2 * arb.atan2(*(max(x.mid(), arb(0)).sqrt() for x in (sin, cos)))

    def radicals(self, half: Pair, root: Root) -> list[Number]:
        """What μ, A, B, K are times powers of v, analytic in φ/2, by cos φ/2 and sin φ/2."""
        cos, sin = half
        squares = cos * cos, sin * sin
        found = []
        for roots, scale in self._radicals:
            if roots == MU and self.sigma is not None:
                found.append(scale * root(self._complex(squares)))
                continue
            inner, value = 1, scale
            for end in roots:
                inner = inner * self._factor(end, squares)
                if end in self._arc:
                    value = value * (sin if end == self._arc[0] else cos)
            found.append(value * root(inner))
        return found

    def differentials(self, squares: Pair, root: Root) -> Pair:
        """The Abelian differentials by dφ, without their sign."""
        product = 1 if self.sigma is None else self._complex(squares)
        for first, last in self.factors:
            product = product * (first * squares[0] + last * squares[1])
        n, v = self.pair(squares)
        common = self.scale / root(product)
        return v * common, n * common

    def _factor(self, name: str, squares: Pair) -> Number:
        """|n − ev|, without what vanishes at an end."""
        first, last = self._factors[name]
        if name in self._arc:
            return last if name == self._arc[0] else first
        return first * squares[0] + last * squares[1]

    def _complex(self, squares: Pair) -> Number:
        """The positive n² − σv², where σ is negative."""
        n, v = self.pair(squares)
        return n * n + self.sigma * v * v


def cosines(angle: Number, cos: Callable[[Number], Number]) -> Pair:
    """The squares of cos φ/2 and sin φ/2."""
    value = cos(angle)
    return (1 + value) / 2, (1 - value) / 2


class PhasePointO4:
    """The nine variables by (cos φ/2, sin φ/2) of either variable.

    ``signs`` are those of :class:`~kowalevski_cas.motion.o4.motion.MotionO4`.
    """

    def __init__(
        self,
        known: ParametersO4,
        regime: RegimeO4,
        signs: Sequence[Number],
        number: Callable[[arb], Number],
        root: Root,
    ) -> None:
        self._variables = [VariableO4(known, arc, number) for arc in (regime.u1, regime.u2)]
        squares = known.p_square, known.r_square, known.kappa_square
        p, r, kappa = (number(ball(square).sqrt()) for square in squares)
        s, tau, sigma = (number(ball(value)) for value in (known.s, known.tau, known.sigma))
        self._for_squares = s, tau, r, sigma, kappa
        self._for_parts = s, tau, p, r
        self._for_point = s, tau, r
        self._signs, self._root = signs, root
        self._squares, self._parts, self._point = (
            formulas.values_of_offer(name, HyperellipticForm)
            for name in ("squares", "parts", "phase_point")
        )

    def __call__(self, first: Pair, second: Pair) -> tuple[Number, ...]:
        """The state."""
        root = self._root
        (n1, v1), (n, v) = (
            variable.pair((cos * cos, sin * sin))
            for variable, (cos, sin) in zip(self._variables, (first, second), strict=True)
        )
        mu1, A1, B1, K1 = self._variables[0].radicals(first, root)
        others = self._variables[1].radicals(second, root)
        sign, *signs = self._signs
        u1 = n1 / v1
        one = (mu1 / v1, A1 / root(v1), B1 / root(v1), sign * K1 / v1)
        two = [sign * radical for sign, radical in zip(signs, others, strict=True)]
        d = v * one[0] - two[0]
        *_, square = self._squares(u1, n, v, one[0], two[0], *self._for_squares)
        parts = self._parts(u1, n, v, *one, *two, *self._for_parts, d)
        return self._point(*one, *two, root(square), *parts, *self._for_point, v * u1 - n)
