r"""One separated equation, :math:`\dot s^2=-m(s-p)(s-q)(s-u)(s-v)`, solved on its arc.

All four roots are real, in the cyclic order p, q, u, v with s between p and q. The map

.. math:: {\rm sn}^2(nt,k)=\frac{(s-p)(q-v)}{(s-v)(q-p)},\qquad
          k^2=\frac{(u-v)(q-p)}{(u-p)(q-v)},\qquad n^2=\tfrac14m(p-u)(q-v)

has :math:`0\le k^2\le1` for every arc, and with
:math:`\Delta={\rm cn}^2+\kappa\,{\rm sn}^2`, :math:`\kappa=(p-v)/(q-v)`,

.. math:: s-p=\kappa(q-p)\frac{{\rm sn}^2}\Delta,\quad s-q=(p-q)\frac{{\rm cn}^2}\Delta,\quad
          s-u=(p-u)\frac{{\rm dn}^2}\Delta,\quad s-v=(p-v)\frac1\Delta.

So S and f, products of two such roots, are single-valued in t: no sign is ever chosen twice.
Where roots coincide the functions become elementary:

* p = q: s rests;
* q = u (k = 1): :math:`{\rm sn}=\tanh`, :math:`{\rm cn}={\rm dn}=1/\cosh`;
* q = u and p = v: :math:`(s-p):(s-q)` is an exponential, and κ may be replaced by its sign.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Literal

from flint import acb, arb

from kowalevski_cas.motion.parameters import Parameters
from kowalevski_cas.motion.regimes import FIELD_1, FIELD_2, PHI, Arc, compare, coordinates, gap

Kind = Literal["rest", "elliptic", "separatrix", "exponential"]


@dataclass(frozen=True)
class Oscillation:
    """The solution of one separated equation, up to the origin of time and signs.

    ``first`` tells s1 from s2. All numbers are balls at the precision of FLINT's context at
    the time when they are asked for, so make one oscillation for each precision.
    """

    parameters: Parameters
    arc: Arc
    first: bool

    @cached_property
    def roots(self) -> tuple[str, str, str, str]:
        """The names of p, q, u, v; turned round where only p and v coincide, so that q = u."""
        p, q, u, v = self.arc.roots
        if self._same(p, v) and not self._same(q, u):
            return q, p, v, u
        return p, q, u, v

    @cached_property
    def kind(self) -> Kind:
        """Which functions solve the equation."""
        p, q, u, v = self.roots
        if self._same(p, q):
            return "rest"
        if self._same(q, u):
            return "exponential" if self._same(p, v) else "separatrix"
        return "elliptic"

    def _same(self, left: str, right: str) -> bool:
        return compare(self.parameters, left, right) == 0

    def gap(self, left: str, right: str) -> arb:
        """One root minus another, to full relative precision; each is computed once."""
        if (left, right) not in self._gaps:
            found = self.parameters.value(*gap(self.parameters, left, right))
            self._gaps[left, right], self._gaps[right, left] = found, -found
        return self._gaps[left, right]

    @cached_property
    def _gaps(self) -> dict[tuple[str, str], arb]:
        return {}

    def root(self, name: str) -> arb:
        """The value of a root."""
        return self.parameters.value(*coordinates(self.parameters, name))

    # -- the elliptic functions ------------------------------------------------------

    @cached_property
    def modulus_square(self) -> arb:
        """k²."""
        p, q, u, v = self.roots
        if self.kind == "rest":
            return arb(0)
        return self.gap(u, v) * self.gap(q, p) / (self.gap(u, p) * self.gap(q, v))

    @cached_property
    def complement_square(self) -> arb:
        """1 − k², by a product: nothing cancels near k = 1."""
        p, q, u, v = self.roots
        if self.kind == "rest":
            return arb(1)
        return self.gap(u, q) * self.gap(p, v) / (self.gap(u, p) * self.gap(q, v))

    @cached_property
    def rate(self) -> arb:
        """How fast the argument nt grows: n; zero at rest."""
        if self.kind == "rest":
            return arb(0)
        p, q, u, v = self.roots
        m = self.parameters.value(type(self.parameters.m)(0), self.parameters.m)
        return (m * self.gap(p, u) * self.gap(q, v) / 4).sqrt()

    @cached_property
    def quarter(self) -> arb:
        """K, a quarter of the period of sn, by the arithmetic-geometric mean."""
        return complete_integral(self.complement_square)

    @cached_property
    def complementary_quarter(self) -> arb:
        """K′."""
        return complete_integral(self.modulus_square)

    # -- s, S and f from sn, cn, dn --------------------------------------------------

    @cached_property
    def kappa(self) -> arb:
        """κ, by which Δ = cn² + κ sn²."""
        p, q, _, v = self.roots
        if self.kind in ("rest", "exponential"):
            return arb(-1 if self.arc.infinite else 1)
        return self.gap(p, v) / self.gap(q, v)

    @cached_property
    def coefficients(self) -> dict[str, arb]:
        """By what the squares of sn, cn, dn, 1 over Δ are multiplied to give s − root."""
        p, q, u, v = self.roots
        values = [self.kappa * self.gap(q, p), self.gap(p, q), self.gap(p, u), self.gap(p, v)]
        if self.kind == "exponential":
            values[3] = values[0]
        return dict(zip(self.roots, values, strict=True))

    @cached_property
    def orientation(self) -> int:
        """The sign of the derivative of s by sn²: that of S·f over sn·cn·dn."""
        if self.kind == "rest":
            return 1
        p, q, _, _ = self.roots
        return 1 if self.kappa * self.gap(q, p) > 0 else -1

    @property
    def field_pair(self) -> tuple[str, str]:
        """The roots of S²."""
        return FIELD_1 if self.first else FIELD_2

    @cached_property
    def field_roots(self) -> tuple[int, int]:
        """The places of the roots of S² among p, q, u, v."""
        return self._places(self.field_pair)

    @cached_property
    def phi_roots(self) -> tuple[int, int]:
        """The places of the roots of f² among p, q, u, v."""
        return self._places(PHI)

    @cached_property
    def field_amplitude(self) -> arb:
        """S by the product of its two functions over Δ."""
        return self._amplitude(self.field_roots)

    @cached_property
    def phi_amplitude(self) -> arb:
        """The function f by the product of its two functions over Δ, without sign."""
        m = self.parameters.m
        scale = self.parameters.value(type(m)(0), abs(4 * m))
        return scale.sqrt() * self._amplitude(self.phi_roots)

    def _places(self, pair: tuple[str, str]) -> tuple[int, int]:
        low, high = sorted(self.roots.index(root) for root in pair)
        return low, high

    def _amplitude(self, places: tuple[int, int]) -> arb:
        left, right = (self.coefficients[self.roots[place]] for place in places)
        return abs(left * right).sqrt()


def complete_integral(complement: arb) -> arb:
    """The complete elliptic integral by the square of the complementary modulus."""
    mean = acb(1).agm(acb(complement.sqrt())).real
    return arb.pi() / (2 * mean)
