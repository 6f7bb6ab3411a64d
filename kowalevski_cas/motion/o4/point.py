"""The phase point on O⁴ by two angles: the printed formulas, in one arithmetic."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from flint import arb

from kowalevski_cas.motion import formulas
from kowalevski_cas.motion.o4.parameters import ParametersO4
from kowalevski_cas.motion.o4.regimes import Regime
from kowalevski_cas.motion.o4.variable import Number, Pair, Root, Variable
from kowalevski_cas.motion.parameters import ball
from kowalevski_cas.paper.closed_form import HyperellipticForm


class PhasePoint:
    """The nine variables by (cos φ/2, sin φ/2) of either variable.

    ``signs`` are those of :class:`~kowalevski_cas.motion.o4.motion.MotionO4`.
    """

    def __init__(
        self,
        known: ParametersO4,
        regime: Regime,
        signs: Sequence[Number],
        number: Callable[[arb], Number],
        root: Root,
    ) -> None:
        self._variables = [Variable(known, arc, number) for arc in (regime.u1, regime.u2)]
        squares = known.p_square, known.r_square, known.kappa_square
        p, r, kappa = (number(ball(square).sqrt()) for square in squares)
        s, tau, sigma = (number(ball(value)) for value in (known.s, known.tau, known.sigma))
        self._for_squares = s, tau, r, sigma, kappa
        self._for_parts = s, tau, p, r
        self._for_point = s, tau, r
        self._signs, self._root = signs, root
        self._squares, self._parts, self._point = (
            formulas.offered(name, HyperellipticForm)
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
