r"""The phase point from the two solved variables: one set of formulas for floats and balls.

Everything that the printed formulas combine is a product of distances :math:`s_j-e` to roots
e, which come from the elliptic functions without cancellation; so
:math:`\psi=2m\left[(s_1-A)(s_2-C)+(s_1-C)(s_2-A)\right]` and
:math:`2(s_1s_2-a^2)=(s_1-a)(s_2+a)+(s_1+a)(s_2-a)` keep their accuracy as a → b.

What belongs to s1 is multiplied by a weight that vanishes with its denominator Δ. The phase point
is homogeneous in it, so that :math:`s_1=\infty`, where Δ = 0, is a point like any other.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from flint import arb

from kowalevski_cas.motion import formulas
from kowalevski_cas.motion.oscillation import Oscillation
from kowalevski_cas.motion.parameters import Parameters, ball

Number = Any
"""A float, an array of floats, or a ball."""


@dataclass(frozen=True)
class VariableValues:
    """One variable at some times, multiplied by ``weight``: s, S, f, and s less each root."""

    weight: Number
    s: Number
    S: Number
    f: Number
    distances: Mapping[str, Number]


class Variable:
    """One variable by its quadruple: the numbers of an oscillation, in one arithmetic."""

    def __init__(
        self, oscillation: Oscillation, sign: int, number: Callable[[arb], Number]
    ) -> None:
        self._kappa = number(oscillation.kappa)
        self._places = tuple(
            (name, place, number(oscillation.coefficients[name]))
            for place, name in enumerate(oscillation.roots)
        )
        self._start = number(oscillation.root(oscillation.roots[0]))
        self._field = (number(sign * oscillation.field_amplitude), oscillation.field_roots)
        turned = sign * oscillation.orientation
        self._phi = (number(turned * oscillation.phi_amplitude), oscillation.phi_roots)

    def __call__(self, quadruple: Sequence[Number]) -> VariableValues:
        """The variable, with the weight Δ/(cn² + |κ| sn²), where the quadruple is given."""
        squares = [t * t for t in quadruple]
        head, tail = squares[1], self._kappa * squares[0]
        over = 1 / (head + abs(tail))  # so that the weight is 1, or between −1 and 1
        weight = (head + tail) * over
        distances = {name: c * squares[place] * over for name, place, c in self._places}
        field, (i, j) = self._field
        phi, (k, n) = self._phi
        return VariableValues(
            weight,
            self._start * weight + distances[self._places[0][0]],
            field * quadruple[i] * quadruple[j] * over,
            phi * quadruple[k] * quadruple[n] * over,
            distances,
        )


class PhasePoint:
    """The nine variables from s1 and s2, in one arithmetic."""

    def __init__(self, parameters: Parameters, number: Callable[[arb], Number]) -> None:
        self._gap = number(ball(parameters.a - parameters.b))
        self._r = number(ball(parameters.r_square).sqrt())
        self._m = number(ball(parameters.m))
        self._formulas = formulas.values_of_offer("phase_point")

    def __call__(
        self,
        first: VariableValues,
        second: VariableValues,
        select: Callable[[Number, Number, Number], Number],
    ) -> tuple[Number, ...]:
        """The state; ``select(x, y, z)`` is y where x ≥ 0 and z elsewhere."""
        one, weight, m, gap = first.distances, first.weight, self._m, self._gap
        two, S2, f2 = second.distances, second.S, second.f  # s2 is finite: its weight is 1
        shift = gap * weight
        # The nearest way from s2 to s1 goes through b and a, or through −b and −a.
        up, down = one["a"] + shift - two["b"] * weight, one["-a"] - shift - two["-b"] * weight
        d = select(first.s * weight, up, down)
        psi = 2 * m * (one["A"] * two["C"] + one["C"] * two["A"])
        by_a = (one["a"] * (two["-b"] + gap) + one["-a"] * (two["b"] - gap)) / 2
        by_b = ((one["a"] + shift) * two["-b"] + (one["-a"] - shift) * two["b"]) / 2
        return self._formulas(
            first.S, S2, first.f, f2, d, psi, by_a, by_b,
            -m * (one["A"] + one["C"]), -m * (two["A"] + two["C"]), self._r * S2 * weight, self._r,
        )  # fmt: skip
