"""The phase point on O⁴ by two angles: the printed formulas, in one arithmetic."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from flint import arb

from kowalevski_cas.motion import formulas
from kowalevski_cas.motion.o4.parameters import ParametersO4
from kowalevski_cas.motion.o4.regimes import Regime
from kowalevski_cas.motion.o4.variable import Number, Pair, Variable
from kowalevski_cas.motion.parameters import ball


class PhasePoint:
    """The nine variables by (cos φ1/2, sin φ1/2) and (cos φ2/2, sin φ2/2).

    ``signs`` are those of :math:`K_1, \\mu_2, A_2, B_2, K_2` where both angles are between 0 and π,
    and the other radicals positive: they choose the torus, and the point on it.
    """

    def __init__(
        self,
        constants: ParametersO4,
        regime: Regime,
        signs: Sequence[int],
        number: Callable[[arb], Number],
        root: Callable[[Number], Number],
    ) -> None:
        self.variables = tuple(Variable(constants, arc, number) for arc in (regime.u1, regime.u2))
        names = ("s", "tau", "p", "r", "sigma", "kappa")
        values = [ball(constants.s), ball(constants.tau)]
        values += [ball(square).sqrt() for square in (constants.p_square, constants.r_square)]
        values += [ball(constants.sigma), ball(constants.kappa_square).sqrt()]
        self._known = dict(zip(names, map(number, values), strict=True))
        self._signs = signs
        self._root = root
        self._squares, self._parts, self._point = map(
            formulas.hyperelliptic, ("squares", "parts", "phase_point")
        )

    def __call__(self, first: Pair, second: Pair) -> tuple[Number, ...]:
        """The state."""
        s, tau, p, r, sigma, kappa = self._known.values()
        one, two = self.variables
        n1, v1 = one.pair((first[0] * first[0], first[1] * first[1]))
        n, v = two.pair((second[0] * second[0], second[1] * second[1]))
        radicals_1 = one.radicals(first, self._root)
        radicals_2 = two.radicals(second, self._root)
        sign_K1, *others = self._signs
        u1, weight = n1 / v1, self._root(v1)
        mu1, A1, B1, K1 = (radicals_1[name] for name in ("mu", "A", "B", "K"))
        radicals = (mu1 / v1, A1 / weight, B1 / weight, sign_K1 * K1 / v1) + tuple(
            sign * radicals_2[name]
            for sign, name in zip(others, ("mu", "A", "B", "K"), strict=True)
        )
        *_, square = self._squares(u1, n, v, radicals[0], radicals[4], s, tau, r, sigma, kappa)
        E = self._root(square)
        d = v * radicals[0] - radicals[4]
        parts = self._parts(u1, n, v, *radicals, s, tau, p, r, d)
        return self._point(*radicals, E, *parts, s, tau, r, v * u1 - n)
