r"""One variable on O⁴ by an angle: an arc, run to and fro.

With the ends :math:`e_1, e_2` of the arc

.. math:: u = \frac{n}{v}, \quad n = e_1c^2+\lambda e_2s^2, \quad v = c^2+\lambda s^2, \qquad
    c:s = \cos\tfrac\varphi2:\sin\tfrac\varphi2,

so that each :math:`n-ev` is a sum of two terms, the radicals are analytic in φ/2, and an arc
through infinity, where λ < 0, is one like any other. |λ| puts the neighbouring roots at equal
distances from the arc. A factor common to c and s changes no state.
"""

from __future__ import annotations

from fractions import Fraction

from flint import arb

from kowalevski_cas.motion.o4.arithmetic import Arithmetic, Number, Pair
from kowalevski_cas.motion.o4.parameters import HIGH, KAPPA, LOW, MU, ParametersO4
from kowalevski_cas.motion.parameters import ball
from kowalevski_cas.motion.regimes import Arc


def stretch(known: ParametersO4, arc: Arc) -> arb:
    """The number λ of an arc."""
    first, last, above, below = arc.roots
    gap = known.gap
    square = gap(below, first) * gap(above, first) / (gap(below, last) * gap(above, last))
    return abs(square).sqrt() * (-1 if arc.infinite else 1)


class VariableO4:
    """The variable on one arc, in one arithmetic, by (c, s) or their squares."""

    def __init__(self, known: ParametersO4, arc: Arc, arithmetic: Arithmetic) -> None:
        first, last = arc.ends
        self._arithmetic, number = arithmetic, arithmetic.number
        factor = stretch(known, arc)
        self._ends = (
            (number(known.root(first)), number(factor * known.root(last))),
            (number(arb(1)), number(factor)),
        )
        self._factors: dict[str, Pair] = {}
        for name in known.roots:
            pair = known.gap(first, name), factor * known.gap(last, name)
            # no root lies inside the arc: both terms have one sign, or one of them is zero
            sign = 1 if sum(pair) > 0 else -1
            self._factors[name] = number(sign * pair[0]), number(sign * pair[1])
        self._arc = arc.ends
        self._rho = number(ball(abs(known.sigma)).sqrt())
        self._real = known.sigma > 0
        squares = (
            (MU, 1 / known.tau),
            ((LOW,), Fraction(1)),
            ((HIGH,), Fraction(1)),
            (KAPPA, 1 / (2 * known.s)),
        )
        self._radicals = [(roots, number(ball(abs(x)).sqrt())) for roots, x in squares]

    def pair(self, squares: Pair) -> Pair:
        """The pair n, v by the squares of c and s."""
        n, v = (first * squares[0] + last * squares[1] for first, last in self._ends)
        return n, v

    def angle(self, pair: tuple[arb, arb]) -> arb:
        """The angle from 0 to π at which the variable is n/v, or the nearest one of the arc."""
        (n1, n2), (_, factor) = self._ends
        sin, cos = pair[0] - n1 * pair[1], n2 * pair[1] - factor * pair[0]
        if sin + cos < 0:
            sin, cos = -sin, -cos
        # n − e₁v and λ(e₂v − n) are to each other as s² to c²
        return 2 * arb.atan2(*(max(x.mid(), arb(0)).sqrt() for x in (sin, cos)))

    def factor(self, name: str, squares: Pair) -> Number:
        """|n − ev| for a real root e."""
        first, last = self._factors[name]
        return first * squares[0] + last * squares[1]

    def conjugate_factors(self, squares: Pair) -> Number:
        """The positive n² − σv², where σ is negative."""
        n, v = self.pair(squares)
        return n * n + self._rho * self._rho * v * v

    def radicals(self, half: Pair) -> list[Number]:
        """What μ, A, B, K are times powers of v, analytic in c and s."""
        squares = half[0] * half[0], half[1] * half[1]
        found = []
        for roots, scale in self._radicals:
            if roots == MU and not self._real:
                found.append(scale * self._arithmetic.root(self.conjugate_factors(squares)))
                continue
            value = scale
            for end in roots:
                value = value * self._root_of_factor(end, half, squares)
            found.append(value)
        return found

    def one_variable_roots(self, half: Pair) -> Pair:
        """The roots of |n ± √σ v|, P and Q; for σ < 0 the real parts a, b of that of n + ρiv."""
        squares = half[0] * half[0], half[1] * half[1]
        if self._real:
            low, high = MU
            return (
                self._root_of_factor(low, half, squares),
                self._root_of_factor(high, half, squares),
            )
        n, v = self.pair(squares)
        root, width = self._arithmetic.root, self._rho * v
        size = root(self.conjugate_factors(squares))
        larger = root((size + abs(n)) / 2)
        # (a + ib)² = n + iρv, so that 2ab = ρv: the smaller part by the larger one, without
        # cancellation
        smaller = width / (2 * larger)
        # For n < 0 the larger part is b, with the sign of v; n > 0 where v changes its sign.
        a, b = self._arithmetic.choose(n, (larger, smaller), (smaller, larger))
        return a, b

    def _root_of_factor(self, name: str, half: Pair, squares: Pair) -> Number:
        """The root of |n − ev|, analytic in c and s."""
        if name not in self._arc:
            return self._arithmetic.root(self.factor(name, squares))
        place = self._arc.index(name)
        return half[1 - place] * self._arithmetic.root(self._factors[name][1 - place])
