r"""The differentials of O⁴ by an elliptic argument x, in which they are smooth.

Four branch points near the arc become those of an elliptic function; the other two stay away, and
the differentials are

.. math:: (v, n)\frac{v\,dn-n\,dv}{y} = \pm C\,\frac{(v, n)\,dx}{\sqrt{gh}}

with the factors g, h of those two. Which four depends on what is near:

* :class:`ByNeighbours`: the ends and the real roots beside them;
* :class:`ByConjugates`, for σ < 0: the ends and :math:`\pm i\rho`, :math:`\rho^2=-\sigma`.

By the angle ψ, to which x is proportional and which has the period 2π, the differentials are
analytic in a strip. Its width does not fall below 1/log of the distance of two roots.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from functools import cached_property

from flint import acb, arb

from kowalevski_cas.motion.o4.arithmetic import BALLS, Arithmetic, Number, Pair
from kowalevski_cas.motion.o4.parameters import ParametersO4
from kowalevski_cas.motion.o4.variable import VariableO4, stretch
from kowalevski_cas.motion.oscillation import complete_integral
from kowalevski_cas.motion.parameters import ball
from kowalevski_cas.motion.regimes import Arc


def uniformize(known: ParametersO4, arc: Arc) -> Uniformization:
    """That uniformization of an arc which leaves the wider strip."""
    found: list[Uniformization] = [ByNeighbours(known, arc)]
    if known.sigma < 0:
        found.append(ByConjugates(known, arc))
    return max(found, key=lambda interval: float(interval.width))


class Uniformization(ABC):
    """An arc by an elliptic argument, in balls at the precision of FLINT's context.

    ``scale`` is a factor of s, ``constant`` is C, ``others`` are the real roots of g and h;
    ``quarters`` says how many K there are to an angle π.
    """

    quarters: int
    scale: arb
    constant: arb
    complement_square: arb
    modulus_square: arb
    others: Sequence[str]

    def __init__(self, known: ParametersO4, arc: Arc) -> None:
        self.known, self.arc = known, arc
        self.variable = VariableO4(known, arc, BALLS)

    @abstractmethod
    def pair(self, functions: Sequence[Number], side: Number, arithmetic: Arithmetic) -> Pair:
        """The pair (c, s) by four numbers proportional to sn, cn, dn, 1, for ψ from −π to π.

        ``side`` is the sign of ψ.
        """

    @abstractmethod
    def argument(self, pair: Pair) -> arb:
        """The argument x of a pair with c ≥ 0."""

    @property
    @abstractmethod
    def height(self) -> arb:
        """The imaginary part of x at the nearest singularity."""

    @cached_property
    def quarter(self) -> arb:
        """K."""
        return complete_integral(self.complement_square)

    @cached_property
    def other_quarter(self) -> arb:
        """K′."""
        return complete_integral(self.modulus_square)

    @cached_property
    def width(self) -> arb:
        """The imaginary part of ψ at the nearest singularity."""
        width: arb = self.height * arb.pi() / (self.quarters * self.quarter)
        return width

    @cached_property
    def rate(self) -> arb:
        """The constant by dψ instead of dx."""
        return self.constant * self.quarters * self.quarter / arb.pi()

    def functions(self, psi: acb) -> list[acb]:
        """Numbers proportional to sn, cn, dn, 1 at an angle, by theta functions."""
        thetas = acb.modular_theta(psi * self.quarters / (2 * arb.pi()), self._tau)
        return [scale * theta for scale, theta in zip(self._scales, thetas, strict=True)]

    def at(self, psi: arb) -> Pair:
        """The pair (c, s) at an angle."""
        turns = (psi / (2 * arb.pi())).mid()
        count = int((turns + arb(0.5)).floor().unique_fmpz() or 0)
        rest = psi - 2 * arb.pi() * count
        side = -1 if rest.mid() < 0 else 1
        c, s = self.pair([x.real for x in self.functions(acb(rest))], side, BALLS)
        return (-c, -s) if count % 2 else (c, s)

    def angle(self, given: arb) -> arb:
        r"""The angle ψ where :math:`c:s` is that of an angle φ."""
        count = int((given / (2 * arb.pi()) + arb(0.5)).mid().floor().unique_fmpz() or 0)
        half = given / 2 - arb.pi() * count
        rest = self.argument((half.cos(), half.sin())) * arb.pi() / (self.quarters * self.quarter)
        return rest + 2 * arb.pi() * count

    def differentials(self, pair: Pair, variable: VariableO4, rate: Number, root: Number) -> Pair:
        """Both differentials by dψ, without their sign, where c and s are given."""
        squares = pair[0] * pair[0], pair[1] * pair[1]
        n, v = variable.pair(squares)
        common = rate / root(self.below(variable, squares))
        return v * common, n * common

    def below(self, variable: VariableO4, squares: Pair) -> Number:
        """The product g·h."""
        if not self.others:
            return variable.conjugate_factors(squares)
        first, second = (variable.factor(name, squares) for name in self.others)
        return first * second

    @cached_property
    def _tau(self) -> acb:
        return acb(0, self.other_quarter / self.quarter)

    @cached_property
    def _scales(self) -> tuple[arb, ...]:
        _, t2, t3, t4 = (value.real for value in acb.modular_theta(acb(0), self._tau))
        # DLMF 22.2.4 to 22.2.6, without the common factor 1/θ₄ of the argument
        return t3 / t2, t4 / t2, t4 / t3, arb(1)


class ByNeighbours(Uniformization):
    r""":math:`c:s={\rm cn}\,x:\sqrt{k'}\,{\rm sn}\,x`, of period 2K."""

    quarters = 1

    def __init__(self, known: ParametersO4, arc: Arc) -> None:
        super().__init__(known, arc)
        first, last, above, below = arc.roots
        gap = known.gap
        whole = gap(above, first) * gap(below, last)
        self.complement_square = gap(last, above) * gap(first, below) / whole
        self.modulus_square = gap(last, first) * gap(above, below) / -whole
        self.scale = self.complement_square.sqrt().sqrt()
        square = abs(2 * ball(known.s * known.tau) * stretch(known, arc))
        at_first = gap(first, above) * gap(first, below)
        self.constant = 2 * self.scale * (square / abs(at_first)).sqrt()
        self.others = [name for name in known.roots if name not in arc.roots]

    def pair(self, functions: Sequence[Number], side: Number, arithmetic: Arithmetic) -> Pair:
        sn, cn, _, _ = functions
        return cn, arithmetic.number(self.scale) * sn

    def argument(self, pair: Pair) -> arb:
        c, s = pair[0] * self.scale, pair[1]
        size = (c * c + s * s).sqrt()
        x: arb = _incomplete(s / size, c / size, self.modulus_square).real
        return x

    @cached_property
    def height(self) -> arb:
        if self.others:
            return self.other_quarter
        first, last = (self.known.root(name) for name in self.arc.ends)
        i_rho = acb(0, ball(-self.known.sigma).sqrt())
        square = (i_rho - first) / (stretch(self.known, self.arc) * (last - i_rho))
        square /= acb(self.scale**2)
        whole = 1 + square
        x = _incomplete((square / whole).sqrt(), (1 / whole).sqrt(), self.modulus_square)
        height: arb = abs(x.imag)
        return height


class ByConjugates(Uniformization):
    r""":math:`c:s=1+{\rm cn}\,x:\nu\,{\rm sn}\,x`, of period 4K."""

    quarters = 2

    def __init__(self, known: ParametersO4, arc: Arc) -> None:
        super().__init__(known, arc)
        first, last = (known.root(name) for name in arc.ends)
        square = ball(-known.sigma)
        A, B = ((root * root + square).sqrt() for root in (first, last))
        # The angle between the lines from iρ to the ends is twice that of the modulus.
        cross = (first * last + square) * (-1 if arc.infinite else 1)
        sine = square * known.gap(arc.ends[1], arc.ends[0]) ** 2
        # (1 ± cos α)/2 with the product sin²α/4, by which the smaller one loses no digits
        larger = (A * B + abs(cross)) / (2 * A * B)
        smaller = sine / (4 * A * A * B * B * larger)
        self.complement_square, self.modulus_square = (
            (larger, smaller) if cross > 0 else (smaller, larger)
        )
        factor = abs(stretch(known, arc))
        self.scale = (A / (B * factor)).sqrt()
        twice = abs(2 * ball(known.s * known.tau))
        self.constant = self.scale * (twice * factor).sqrt() / A
        self.others = [name for name in known.roots if name not in arc.ends]

    def pair(self, functions: Sequence[Number], side: Number, arithmetic: Arithmetic) -> Pair:
        sn, cn, _, one = functions
        c, s = arithmetic.choose(cn, (one + cn, sn), (side * sn, side * (one - cn)))
        return c, arithmetic.number(self.scale) * s

    def argument(self, pair: Pair) -> arb:
        c, s = pair[0] * self.scale, pair[1]
        size = c * c + s * s
        sn, cn = 2 * c * s / size, (c * c - s * s) / size
        x: arb = _incomplete(sn, abs(cn), self.modulus_square).real
        if cn.mid() >= 0:
            return x
        return (-2 if sn.mid() < 0 else 2) * self.quarter - x

    @cached_property
    def height(self) -> arb:
        heights = []
        for name in self.others:
            first, last = (self.known.gap(end, name) for end in self.arc.ends)
            # cn = (1 − q)/(1 + q) there, or its opposite at a distance of 2K.
            quotient = abs(self.scale**2 * stretch(self.known, self.arc) * last / first)
            sine, cosine = 2 * quotient.sqrt() / (1 + quotient), abs(1 - quotient) / (1 + quotient)
            heights.append(_incomplete(sine, cosine, self.complement_square).real)
        return min(heights, key=float)


def _incomplete(sine: Number, cosine: Number, modulus_square: arb) -> acb:
    """The argument with this sn and cn, in the first quarter or the fourth one."""
    square = 1 - modulus_square * sine * sine
    # F(φ) = sin φ R_F(cos²φ, 1 − k² sin²φ, 1), by Carlson; DLMF 19.25.5
    value: acb = acb(sine) * acb.elliptic_rf(acb(cosine * cosine), acb(square), acb(1))
    return value
