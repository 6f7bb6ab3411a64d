r"""Systems solved by the roots of one equation, all of them real and distinct."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

from kowalevski_cas.arithmetic.hermite import hermite_minors
from kowalevski_cas.arithmetic.numbers import Substitution
from kowalevski_cas.arithmetic.polynomials import Terms
from kowalevski_cas.arithmetic.tower import Element, Ring
from kowalevski_cas.claims.cases import is_sum
from kowalevski_cas.notation import Formula
from kowalevski_cas.proof.roots import Eliminant, Roots


@dataclass
class System:
    r"""The system :math:`P_j(x) = p_j` in one arithmetic.

    ``levels`` are the :math:`P_j` in the ``unknowns`` x; ``everywhere`` are the
    same integrals before anything was solved for, ``values`` the :math:`p_j` as printed.
    """

    levels: Sequence[Element]
    unknowns: Sequence[Element]
    everywhere: Sequence[Element]
    values: Sequence[Formula]

    @cached_property
    def ring(self) -> Ring:
        """Polynomials in the form s and the parameters."""
        kind = type(self.levels[0].ring.polynomials)
        return Ring(kind(("s", *(f"p_{k + 1}" for k in range(len(self.levels))))))

    def element(self, terms: Terms) -> Element:
        """A polynomial in the form and the parameters."""
        return self.ring.from_terms({0: terms})

    def into(self, values: Sequence[Element], form: Element | None = None) -> Substitution:
        """The homomorphism that gives values to the parameters, and to the form."""
        ring = values[0].ring
        names = self.ring.polynomials.generators
        images = dict(zip(names, (form or ring.zero, *values), strict=True))
        return Substitution(self.ring, images, ring)

    def holds(self, roots: Roots) -> bool:
        r"""Whether a certificate is right.

        * e(s) = 0 and d x = n(s) are identities when s is the form of the unknowns
          and the parameters are the levels: every solution comes from a root of e.
        * :math:`P_j(n/d)-p_j` and s(n/d) - s are multiples of e: every root gives a
          solution where no d vanishes, and different roots different ones.
        * The minors of Hermite, up to positive numbers, are products of factors
          that are sums of squares: all roots are real and distinct where no factor
          vanishes.
        """
        return (
            self._roots_of_solutions(roots.eliminant)
            and self._solutions_of_roots(roots)
            and self._factors(roots)
        )

    def _roots_of_solutions(self, found: Eliminant) -> bool:
        value = self.into(self.levels, form_of(found, self.unknowns))
        rests = [value(self.element(found.equation))]
        rows = zip(found.denominators, found.numerators, self.unknowns, strict=True)
        for below, above, unknown in rows:
            rests.append(value(self.element(below)) * unknown - value(self.element(above)))
        return all(rest.is_zero for rest in rests)

    def residuals(self, found: Eliminant) -> list[Element]:
        """The numerators of the equations and of the form at the solution that a root gives."""
        form, *parameters = (self.ring.generator(n) for n in self.ring.polynomials.generators)
        values = [
            self.element(above) * self.element(below).inverse()
            for below, above in zip(found.denominators, found.numerators, strict=True)
        ]
        ring = self.levels[0].ring
        numbers = {name: self.ring.zero for name in ring.polynomials.generators}
        for unknown, value in zip(self.unknowns, values, strict=True):
            ((exponents, _),) = unknown.terms()[0].items()
            numbers[ring.polynomials.generators[exponents.index(1)]] = value
        into = Substitution(ring, numbers, self.ring)
        rests = [into(level) - p for level, p in zip(self.levels, parameters, strict=True)]
        rests.append(form_of(found, values) - form)
        return [Element(self.ring, rest.parts, {}) for rest in rests]

    def _solutions_of_roots(self, roots: Roots) -> bool:
        equation = self.element(roots.eliminant.equation)
        pairs = zip(self.residuals(roots.eliminant), roots.quotients, strict=True)
        return all((rest - self.element(q) * equation).is_zero for rest, q in pairs)

    def minors(self, found: Eliminant) -> list[Element]:
        """The minors of Hermite, which show how many roots are real."""
        size = degree(found)
        rows: list[Terms] = [{} for _ in range(size + 1)]
        for (power, *others), value in found.equation.items():
            rows[power][(0, *others)] = value
        *coefficients, leading = (self.element(row) for row in rows)
        assert (leading - self.ring.one).is_zero
        return hermite_minors(coefficients)

    def products(self, found: Eliminant) -> list[Element]:
        """What must not vanish: the minors, then the denominators."""
        return [*self.minors(found), *(self.element(terms) for terms in found.denominators)]

    def _factors(self, roots: Roots) -> bool:
        factors = [self.element(sign.factor) for sign in roots.signs]
        products = self.products(roots.eliminant)
        for index, (value, (number, powers)) in enumerate(
            zip(products, roots.products, strict=True)
        ):
            product = self.ring.number(number)
            for factor, power in zip(factors, powers, strict=True):
                product = product * factor**power if power else product
            if not (value - product).is_zero or not number:
                return False
            if index < degree(roots.eliminant):
                used = [s for s, power in zip(roots.signs, powers, strict=True) if power]
                if number < 0 or any(not (s.in_parameters or s.in_variables) for s in used):
                    return False
        everywhere = self.into(self.everywhere)
        ring = self.everywhere[0].ring
        return all(
            is_sum(self.ring, factor, sign.in_parameters)
            if sign.in_parameters
            else not sign.in_variables or is_sum(ring, everywhere(factor), sign.in_variables)
            for factor, sign in zip(factors, roots.signs, strict=True)
        )


def form_of(found: Eliminant, unknowns: Sequence[Element]) -> Element:
    """The form of the unknowns."""
    total = unknowns[0].ring.zero
    for coefficient, unknown in zip(found.form, unknowns, strict=True):
        total = total + total.ring.number(coefficient) * unknown
    return total


def degree(found: Eliminant) -> int:
    """The number of roots."""
    return max(exponents[0] for exponents in found.equation)
