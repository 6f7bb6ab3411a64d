r"""The phase point on O⁴ by both variables, in one arithmetic, without cancellation.

The parts are sums of products in which nothing cancels that is larger than the state (the section
“The parts by factors” of the derivation): of a sum and a difference the larger one is added up, and
the other one is a radical squared over it; :math:`vu_1\mp n` are bilinear in the squares of c and
s, with coefficients of one sign, for the arcs of :math:`u_1` and of :math:`\pm u_2` are disjoint.
"""

from __future__ import annotations

from collections.abc import Sequence

from flint import arb

from kowalevski_cas.motion import formulas
from kowalevski_cas.motion.o4.arithmetic import Arithmetic, Number, Pair
from kowalevski_cas.motion.o4.parameters import ParametersO4
from kowalevski_cas.motion.o4.regimes import RegimeO4
from kowalevski_cas.motion.o4.variable import VariableO4, stretch
from kowalevski_cas.motion.parameters import ball
from kowalevski_cas.paper.closed_form import HyperellipticForm


class PhasePointO4:
    """The nine variables by the pair (c, s) of either variable.

    ``signs`` are those of :class:`~kowalevski_cas.motion.o4.motion.MotionO4`.
    """

    def __init__(
        self, known: ParametersO4, regime: RegimeO4, signs: Sequence[Number], arithmetic: Arithmetic
    ) -> None:
        self._arithmetic, number = arithmetic, arithmetic.number
        arcs = regime.u1, regime.u2
        self._variables = [VariableO4(known, arc, arithmetic) for arc in arcs]
        factors = [(arb(1), stretch(known, arc)) for arc in arcs]
        self._minus, self._plus = (
            [
                [
                    number(x * y * between(first, second))
                    for y, second in zip(factors[1], arcs[1].ends, strict=True)
                ]
                for x, first in zip(factors[0], arcs[0].ends, strict=True)
            ]
            for between in (known.gap, known.sum)
        )
        p, r = (number(ball(square).sqrt()) for square in (known.p_square, known.r_square))
        self._s, self._tau = (number(ball(value)) for value in (known.s, known.tau))
        self._rho, self._real = number(ball(abs(known.sigma)).sqrt()), known.sigma > 0
        self._for_parts = self._s, self._tau, p, r
        self._for_point = self._s, self._tau, r
        self._signs = signs
        self._products, self._resolvents, self._parts, self._quotients, self._point = (
            formulas.values_of_offer(name, HyperellipticForm)
            for name in (
                "products", "resolvents", "parts",
                "quotients" if self._real else "conjugate_quotients", "phase_point",
            )
        )  # fmt: skip

    def __call__(self, first: Pair, second: Pair) -> tuple[Number, ...]:
        """The state."""
        root = self._arithmetic.root
        squares = [(c * c, s * s) for c, s in (first, second)]
        (_, v1), (_, v) = (
            variable.pair(pair) for variable, pair in zip(self._variables, squares, strict=True)
        )
        minus, plus = (_bilinear(form, *squares) / v1 for form in (self._minus, self._plus))
        mu1, A1, B1, K1 = self._variables[0].radicals(first)
        sign, *signs = self._signs
        root_of_v1 = root(v1)
        one = (mu1 / v1, A1 / root_of_v1, B1 / root_of_v1, sign * K1 / v1)
        two = [s * x for s, x in zip(signs, self._variables[1].radicals(second), strict=True)]
        by_one = [x / root_of_v1 for x in self._variables[0].one_variable_roots(first)]
        E = self._E(by_one, self._variables[1].one_variable_roots(second), plus, signs[0])
        V, d = self._resolve(one[0], two[0], v, self._products(one[3], two[3], *self._for_point))
        Pi, *Y, T, Lambda, N = self._parts(v, *one, *two, *self._for_parts, d)
        parts = (Pi, self._sharper_form(Y, v, one, two, d), V, d, T, Lambda, N)
        return self._point(*one, *two, E, *parts, *self._for_point, minus)

    def _E(
        self, one: Sequence[Number], two: Sequence[Number], plus: Number, sign: Number
    ) -> Number:
        """The positive root E by roots of one variable, with the sign of μ2."""
        (x1, y1), (x2, y2) = one, two
        if self._real:
            y2 = y2 * sign if self._tau > 0 else -y2 * sign
        added, divided = self._quotients(x1, y1, x2, y2, self._rho, plus)
        same = x1 * x2 * y1 * y2 if self._real else y2
        return abs(self._arithmetic.choose(same, (added,), (divided,))[0])

    def _resolve(
        self, mu1: Number, mu2: Number, v: Number, products: Sequence[Number]
    ) -> Sequence[Number]:
        """V and d by the sums and differences of 2s and μ1, of 2sv and μ2, with these products."""
        known: list[Number] = []
        for larger, smaller, product in zip(
            (2 * self._s, 2 * self._s * v), (mu1, mu2), products, strict=True
        ):
            total, difference = larger + smaller, larger - smaller
            known += self._arithmetic.choose(
                larger * smaller, (total, product / total), (product / difference, difference)
            )
        return self._resolvents(*known, self._s)

    def _sharper_form(
        self,
        Y: Sequence[Number],
        v: Number,
        one: Sequence[Number],
        two: Sequence[Number],
        d: Number,
    ) -> Number:
        """That of two forms of Y whose terms are smaller."""
        (mu1, A1, B1, _), (mu2, A2, B2, _) = one, two
        _, tau, p, _ = self._for_parts
        by_d = abs(tau) * d * d + (v * A1 * B1) ** 2 + (A2 * B2) ** 2
        sums = abs(v) * (A1 * A1 + B1 * B1 + 4 * p * p) + A2 * A2 + B2 * B2 + 2 * abs(mu1 * mu2)
        return self._arithmetic.choose(abs(tau * v) * sums - by_d, Y[:1], Y[1:])[0]


def _bilinear(form: Sequence[Sequence[Number]], first: Pair, second: Pair) -> Number:
    return sum(
        value * x * y
        for x, row in zip(first, form, strict=True)
        for y, value in zip(second, row, strict=True)
    )
