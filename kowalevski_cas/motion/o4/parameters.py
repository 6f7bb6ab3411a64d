r"""The constants of a motion on O⁴: the fields a, b and the partial integrals s, τ = τ₃, all exact.

The radicands of the phase point vanish where a variable is one of
:math:`\pm\sqrt\sigma,\ \pm\kappa,\ -\tau\pm r^2`. Each of these roots is told by its square with
its own sign, a rational number; as these are in the order of the roots, all that decides is exact.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property

from flint import arb

from kowalevski_cas.motion import formulas
from kowalevski_cas.motion.parameters import (
    Inadmissible,
    Lengths,
    Real,
    ball,
    exact,
    refuse_extremes,
)
from kowalevski_cas.motion.units import power
from kowalevski_cas.paper.closed_form import HyperellipticForm

MU, KAPPA, LOW, HIGH = ("-√σ", "√σ"), ("-κ", "κ"), "-τ-r²", "-τ+r²"
"""The roots of μ², of K², of A² and of B²."""

OPPOSITE = {x: y for pair in (MU, KAPPA) for x, y in (pair, pair[::-1])}
"""The roots −x beside x."""


class Degenerate(Inadmissible):
    """Constants of O⁴ at which two roots coincide: there are motions, without a closed form."""


@dataclass(frozen=True)
class ParametersO4(Lengths):
    """The constants of a motion on O⁴ in fields of lengths a > b > 0 at right angles."""

    s: Fraction
    tau: Fraction

    def __post_init__(self) -> None:
        """Refuse lengths that do not separate, and constants that vanish."""
        if not 0 < self.b < self.a:
            raise Inadmissible(f"a = {float(self.a):g}, b = {float(self.b):g}; a > b > 0 is needed")
        refuse_extremes({"s/a": self.s / self.a, "τ/a²": self.tau / self.a**2})
        refused = ((Inadmissible, "s", self.s), (Inadmissible, "τ", self.tau))
        for error, name, value in (*refused, (Degenerate, "σ", self.sigma)):
            if value == 0:
                raise error(f"{name} = 0: the tori of O⁴ degenerate; {name} ≠ 0 is needed")

    @staticmethod
    def of(a: Real, b: Real, s: Real, tau: Real) -> ParametersO4:
        """The constants as given; raises ``ValueError`` for what is not a finite number."""
        return ParametersO4(exact(a), exact(b), exact(s), exact(tau))

    def in_unit(self, unit: int) -> ParametersO4:
        """The same in a unit of time in which a rate of this power of two is 1."""
        # fields and s have the dimension of ω², τ that of ω⁴
        a, b, s = (x * power(-2 * unit) for x in (self.a, self.b, self.s))
        return ParametersO4(a, b, s, self.tau * power(-4 * unit))

    @cached_property
    def sigma(self) -> Fraction:
        """σ = τ² − 2p²τ + r⁴."""
        return self.tau**2 - 2 * self.p_square * self.tau + self.r_square**2

    @cached_property
    def kappa_square(self) -> Fraction:
        """κ² = σ + 4s²τ."""
        return self.sigma + 4 * self.s**2 * self.tau

    @cached_property
    def integrals(self) -> tuple[float, float, float]:
        """The values of H, K and G."""
        p, r = (float(ball(square).sqrt()) for square in (self.p_square, self.r_square))
        integrals = formulas.values_of_offer("integrals", HyperellipticForm)
        h, k, g = integrals(float(self.s), float(self.tau), p, r)
        return h, k, g

    @cached_property
    def roots(self) -> tuple[str, ...]:
        """The names of the real roots in their order upwards."""
        return tuple(sorted(self.keys, key=self.keys.__getitem__))

    @cached_property
    def keys(self) -> dict[str, Fraction]:
        """The square of each real root with the sign of the root."""
        found: dict[str, Fraction] = {}
        for (low, high), square in ((MU, self.sigma), (KAPPA, self.kappa_square)):
            if square >= 0:
                found |= {low: -square, high: square}
        for name, root in ((LOW, -self.tau - self.r_square), (HIGH, self.r_square - self.tau)):
            found[name] = root * abs(root)
        return found

    def root(self, name: str) -> arb:
        """The value of a root at the precision of FLINT's context."""
        key = self.keys[name]
        return ball(abs(key)).sqrt() * (-1 if key < 0 else 1)

    def gap(self, left: str, right: str) -> arb:
        """One root minus another, to full relative precision."""
        if self.keys[left] * self.keys[right] <= 0:
            return self.root(left) - self.root(right)
        # x − y = (x² − y²)/(x + y): the squares are rational, so that nothing cancels
        difference = ball(abs(self.keys[left]) - abs(self.keys[right]))
        return difference / (self.root(left) + self.root(right))

    def sum(self, left: str, right: str) -> arb:
        """The sum of two roots, to full relative precision: a gap from the opposite of one."""
        for name, other in ((left, right), (right, left)):
            if name in OPPOSITE:
                return self.gap(other, OPPOSITE[name])
        of_r = {LOW: -self.r_square, HIGH: self.r_square}
        return ball(of_r[left] + of_r[right] - 2 * self.tau)
