"""For which values of constants a polynomial divides its derivative: all cases."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from flint import fmpq_mpoly

from kowalevski_cas.algebra.flint import coefficients
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.pool import HERE, Pool
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.polynomial_fields import monomials
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.search.branches import Branch, solve_by_cases

Monomial = tuple[int, ...]


@dataclass(frozen=True)
class Case:
    """What constants obey, by both sides of equations, and the K for which then F′ = KF."""

    equations: tuple[tuple[Element, Element], ...]
    cofactor: Element


class DarbouxAnsatz:
    """Polynomials F and K in the variables, with constants in their coefficients, and F′ = KF.

    Args:
        at: the evaluation of a space, with FLINT.
        value: F.
        letters: the constants that are the coefficients of K, as many as there are
            :func:`cofactor_monomials`.

    Raises:
        Meaningless: F or the motion is no polynomial in the variables, or F has none of them.
    """

    def __init__(self, at: Evaluation, value: Element, letters: Sequence[str]) -> None:
        self.at, self.value, self.letters = at, value, letters
        names = at.names
        self._moving = [names.index(name) for name in at.setting.variables]
        still = [name for name in reversed(at.setting.constants) if name not in letters]
        self._places = [names.index(name) for name in (*letters, *still)]
        terms = zip(letters, cofactor_monomials(at), strict=True)
        self.cofactor = at.ring.zero
        for letter, monomial in terms:
            self.cofactor = self.cofactor + at.ring.generator(letter) * self.monomial(monomial)
        self._residual = at.derivative(value) - self.cofactor * value
        self._equations = _coefficients(at, self._residual)
        self._growing = {m: c for m, c in _coefficients(at, value).items() if any(m)}
        if not self._growing:
            raise Meaningless("no variable stands in the polynomial: it never moves")

    def monomial(self, exponents: Monomial) -> Element:
        """The product of powers of the variables."""
        product = self.at.ring.one
        for name, exponent in zip(self.at.setting.variables, exponents, strict=True):
            product = product * self.at.ring.generator(name) ** exponent
        return product

    def equations(self) -> list[tuple[Element, Element]]:
        """The monomials in the variables of F′ − KF, and their coefficients."""
        below = self._residual.denominator
        return [
            (self.monomial(m), self.at.ring.element({0: c}, below))
            for m, c in self._equations.items()
        ]

    def trivial(self) -> list[Element]:
        """What vanishes if F is constant."""
        return [self._element(polynomial) for polynomial in self._growing.values()]

    def cases(self, pool: Pool = HERE) -> Iterator[Case]:
        """All cases in which F is not constant."""
        granted = [e.parts[0] for e in self.at.granted if e.parts.keys() == {0}]
        growing = [*self._growing.values()]
        tasks = (
            ([*self._equations.values(), *growing[:k]], self._places, [*granted, coefficient])
            for k, coefficient in enumerate(growing)
        )
        for branches in pool.map(solve_by_cases, tasks):
            yield from map(self._case, branches)

    def _case(self, branch: Branch) -> Case:
        """What a branch says of the constants, and of K; the rest of K is zero."""
        ring, names = self.at.ring, self.at.names
        values = dict.fromkeys(self.letters, ring.zero)
        equations = [(self._element(polynomial), ring.zero) for polynomial in branch.rest]
        for place, equation in branch.solved:
            slope = equation.derivative(place)
            below = self._element(slope)
            above = self._element(slope * ring.polynomials.generator(place) - equation)
            if names[place] in values:
                values[names[place]] = above / below
            elif slope.is_constant():
                equations.append((ring.generator(names[place]), above / below))
            else:
                equations.append((self._element(equation), ring.zero))
        cofactor = self.at.image(
            self.cofactor, lambda name: values[name] if name in values else ring.generator(name)
        )
        return Case(tuple(equations), cofactor)

    def _element(self, polynomial: fmpq_mpoly) -> Element:
        return self.at.ring.element({0: polynomial}, {})


def cofactor_monomials(at: Evaluation) -> list[Monomial]:
    """The exponents of variables in a polynomial that is of lower degree than the motion.

    Raises:
        Meaningless: the motion is no polynomial in the variables.
    """
    rates = [at.rates.get(name, at.ring.zero) for name in at.setting.variables]
    degree = max((sum(m) for rate in rates for m in _coefficients(at, rate)), default=0)
    ones = (1,) * len(at.setting.variables)
    return [monomial for size in range(degree) for monomial in monomials(ones, size)]


def _coefficients(at: Evaluation, element: Element) -> dict[Monomial, fmpq_mpoly]:
    """The coefficients of a numerator as a polynomial in the variables.

    Raises:
        Meaningless: there are roots, or variables below.
    """
    moving = [at.names.index(name) for name in at.setting.variables]
    below = (at.ring.divisors[k].degrees() for k in element.denominator)
    if element.parts.keys() - {0} or any(degrees[k] for degrees in below for k in moving):
        raise Meaningless("roots or quotients stand in the motion or in the function")
    found = coefficients(element.parts.get(0) or at.ring.polynomials.zero, moving)
    return {monomial: found[monomial] for monomial in sorted(found, reverse=True)}
