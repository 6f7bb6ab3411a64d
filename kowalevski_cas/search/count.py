"""All solutions of equations, by the roots of an eliminant."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import compress

from flint import Ordering, fmpq_mpoly, fmpq_mpoly_ctx

from kowalevski_cas.algebra.flint import polynomial_of, terms_of, to_fraction
from kowalevski_cas.algebra.hermite import hermite_minors
from kowalevski_cas.algebra.ideals import remainder
from kowalevski_cas.algebra.polynomials import Terms
from kowalevski_cas.algebra.present import (
    formula_in,
    fraction_formula,
    polynomial_formula,
    power_formula,
)
from kowalevski_cas.algebra.squares import sum_of_squares
from kowalevski_cas.algebra.tower import Element, Ring
from kowalevski_cas.notation import Formula, Name, Number, times, total
from kowalevski_cas.problem.count import eliminant_value, remainders
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.evidence import Evidence, Factor, Point, Roots
from kowalevski_cas.problem.goals import Count
from kowalevski_cas.problem.space import Space
from kowalevski_cas.search.cofactors import cofactors
from kowalevski_cas.search.combinations import cofactors_for
from kowalevski_cas.search.cramer import cramer
from kowalevski_cas.search.eliminants import Eliminant, eliminant
from kowalevski_cas.search.levels import (
    LevelEquations,
    more_solutions,
    new_name,
    point_evidence,
    solutions,
    system_of,
)
from kowalevski_cas.search.place import PointFinder

Split = tuple[tuple[Factor, ...], tuple[tuple[Formula, tuple[int, ...]], ...]]
"""Factors, and minors as products of them."""


class Builder:
    """The evidence for one system and its eliminant, in formulas."""

    def __init__(
        self, goal: Count, system: LevelEquations, found: Eliminant, values: Sequence[Element]
    ) -> None:
        self.goal, self.system, self.found = goal, system, found
        self.at = system.at
        self.root = new_name(self.at)
        self.parameters = [formula_in(value) for value in values]
        names = (*self.at.setting.constants, self.root)
        self.inner = Evaluation(Space((), names), self.at.polynomials)
        self.known = self.at.differences(goal.equations)

    def formula(self, terms: Terms) -> Formula:
        """A polynomial in the form and the parameters."""
        return polynomial_formula(terms, [Name(self.root), *self.parameters])

    def _coefficients(self) -> list[Terms]:
        """Those of the eliminant in the parameters, the constant one first, without the last."""
        size = max(key[0] for key in self.found.equation)
        rows: list[Terms] = [{} for _ in range(size + 1)]
        for (power, *others), coefficient in self.found.equation.items():
            rows[power][(0, *others)] = coefficient
        return rows[:-1]

    def roots(self) -> Roots | None:
        """The evidence; ``None`` if not all minors are sums of squares, or a step fails."""
        chosen = compress(self.system.unknowns, self.found.form)
        solved = self._solutions()
        if solved is None:
            return None
        draft = Roots(
            root=self.root,
            form=total(map(Name, chosen)),
            eliminant=tuple(map(self.formula, self._coefficients())),
            solved=tuple(solved),
            rows=(),
            quotients=(),
            factors=(),
            minors=(),
            point=Point({}),
        )
        rows = self._rows(draft)
        quotients = self._quotients(draft)
        split = self._split()
        if rows is None or quotients is None or split is None:
            return None
        factors, minors = split
        point = self._point([self.at.scalar(factor.factor) for factor in factors])
        if point is None:
            return None
        return draft._replace(
            rows=rows, quotients=quotients, factors=factors, minors=minors, point=point
        )

    def _solutions(self) -> list[tuple[str, Formula, Formula]] | None:
        """Each variable by numerator and denominator, if it is zero or plus or minus an unknown."""
        found = {
            name: (self.formula(above), self.formula(below))
            for name, above, below in zip(
                self.system.unknowns, self.found.numerators, self.found.denominators, strict=True
            )
        }
        if any(self.at.scalar(below).is_zero for _, below in found.values()):
            return None
        for place, expression in self.system.solved:
            found[self.at.names[place]] = self._express(expression, found)
        return [(name, *found[name]) for name in self.goal.names]

    def _express(
        self, expression: fmpq_mpoly, found: Mapping[str, tuple[Formula, Formula]]
    ) -> tuple[Formula, Formula]:
        """A polynomial in the unknowns and the constants, over one in the constants."""
        unknowns, constants = self.system.unknowns, self.system.constants
        terms = self.system.terms(expression, [*unknowns, *constants])
        size = len(unknowns)
        above, below = ([found[name][k] for name in unknowns] for k in (0, 1))
        degrees = [
            0 if divisor == Number(1) else max((e[k] for e in terms), default=0)
            for k, divisor in enumerate(below)
        ]
        whole = {
            (*e, *(max(d - k, 0) for d, k in zip(degrees, e[:size], strict=True))): v
            for e, v in terms.items()
        }
        names = [*above, *map(Name, constants), *below]
        powers = (power_formula(b, d) for b, d in zip(below, degrees, strict=True) if d)
        return polynomial_formula(whole, names), times(*powers)

    def _rows(self, draft: Roots) -> tuple[tuple[Formula, ...], ...] | None:
        """What shows from the equations that a solution is a root."""
        bound = self.at.binding({draft.root: self.at.scalar(draft.form)})
        goals = [eliminant_value(draft, bound)]
        for name, above, below in draft.solved:
            goals.append(bound.scalar(below) * bound.scalar(Name(name)) - bound.scalar(above))
        solved = tuple(self.at.names[place] for place, _ in self.system.solved)
        main = [(*self.at.setting.constants, *solved), solved]
        found = []
        for goal in goals:
            zero = [goal] * len(self.known)
            row = zero if goal.is_zero else cofactors_for(goal, self.known, main)
            if row is None:
                return None
            found.append(tuple(map(formula_in, row)))
        return tuple(found)

    def _quotients(self, draft: Roots) -> tuple[Formula, ...] | None:
        """What shows that a root gives a solution."""
        inner = self.inner
        _, rests = remainders(draft, inner, self.at, self.known)
        equation = eliminant_value(draft, inner).parts[0]
        found = []
        for rest in rests:
            part = rest.parts.get(0, inner.ring.polynomials.zero)
            quotient, left = divmod(part, equation)
            if not left.is_zero():
                return None
            found.append(formula_in(inner.ring.element({0: quotient}, rest.denominator)))
        return tuple(found)

    def _split(self) -> Split | None:
        """The minors of Hermite as products of factors, each a sum of squares."""
        ring = Ring(self.at.polynomials(("s", *(f"p{k}" for k in range(len(self.parameters))))))
        minors = hermite_minors([ring.from_terms({0: row}) for row in self._coefficients()])
        below = [ring.from_terms({0: terms}) for terms in self.found.denominators]
        factors: list[fmpq_mpoly] = []
        products = []
        for index, element in enumerate([*minors, *below]):
            if element.is_zero:
                return None
            content, parts = element.parts[0].factor()
            powers = {}
            for factor, exponent in parts:
                if factor not in factors:
                    factors.append(factor)
                powers[factors.index(factor)] = int(exponent)
            if index < len(minors):
                products.append((to_fraction(content), powers))
        terms = [ring.polynomials.terms(factor) for factor in factors]
        found = [self._factor(term) for term in terms]
        used = {k for _, powers in products for k in powers}
        if any(found[k] is None for k in used) or any(number <= 0 for number, _ in products):
            return None
        shown = tuple(
            (fraction_formula(number), tuple(powers.get(k, 0) for k in range(len(factors))))
            for number, powers in products
        )
        whole = [f or Factor(self.formula(t)) for f, t in zip(found, terms, strict=True)]
        return tuple(whole), shown

    def _factor(self, terms: Terms) -> Factor | None:
        """A factor as a sum of squares: in the parameters, or in the variables."""
        written = self.formula(terms)
        if squares := sum_of_squares(terms):
            return Factor(
                written, tuple((fraction_formula(r), self.formula(b)) for r, b in squares)
            )
        whole = self.at.scalar(written)
        candidates = (self._in_variables(written), whole)
        known = ((e, sum_of_squares(e.terms().get(0, {}))) for e in candidates if e is not None)
        element, squares = next((pair for pair in known if pair[1]), (whole, None))
        if not squares:
            return None
        own: list[Formula] = [Name(n) for n in self.at.names]
        pairs = tuple((fraction_formula(r), polynomial_formula(b, own)) for r, b in squares)
        row = cofactors(whole - element, self.known, [tuple(self.at.setting.constants)])
        if row is None:
            return None
        bases = [self.at.scalar(base) for _, base in pairs]
        return Factor(written, pairs, tuple(map(formula_in, row)), self._granted_zero(bases))

    def _in_variables(self, factor: Formula) -> Element | None:
        """A factor in which constants are replaced by what the equations set equal to them."""
        names, still = self.at.names, self.at.setting.constants
        order = sorted(range(len(names)), key=lambda k: names[k] not in still)
        context = fmpq_mpoly_ctx.get([f"x{k}" for k in order], Ordering.lex)

        def carry(element: Element) -> fmpq_mpoly:
            terms = element.terms().get(0, {})
            return polynomial_of(context, {tuple(e[k] for k in order): v for e, v in terms.items()})

        known = [
            element
            for element in map(carry, self.known)
            if element and any(element.monomial(0)[: len(still)])
        ]
        rest = remainder(carry(self.at.scalar(factor)), known)
        if any(rest.degrees()[: len(still)]):
            return None
        places = [order.index(k) for k in range(len(names))]
        back = {tuple(e[k] for k in places): value for e, value in terms_of(rest).items()}
        return self.at.ring.from_terms({0: back})

    def _granted_zero(self, bases: Sequence[Element]) -> tuple[int, tuple[Formula, ...]] | None:
        """Something granted that would vanish where all bases do."""
        for place, formula in enumerate(self.at.setting.nonzero):
            target = self.at.scalar(formula)
            main = [tuple(self.at.setting.constants)]
            row = cofactors(target, [*bases, *self.known], main)
            if row is not None and not any(entry.denominator for entry in row):
                return place, tuple(map(formula_in, row))
        return None

    def _point(self, factors: Sequence[Element]) -> Point | None:
        """A solution in small whole numbers, with its constants."""
        for found in solutions(self.system):
            if all(self.system.value(factor, found) for factor in factors):
                return point_evidence(found)
        return None


def roots(goal: Count, finder: PointFinder) -> Evidence | None:
    """The solutions by the roots of an eliminant, if they are as many as claimed."""
    found = _by_roots(goal, finder)
    return found if found is not None and len(found.eliminant) == goal.number else None


def others(goal: Count, finder: PointFinder) -> Evidence | None:
    """Another number of roots, or more solutions than there should be."""
    found = _by_roots(goal, finder)
    if found is not None and len(found.eliminant) != goal.number:
        return found
    return more_solutions(goal, finder)


def _by_roots(goal: Count, finder: PointFinder) -> Roots | None:
    system = system_of(goal, finder)
    if system is None:
        return None
    if (solutions := cramer(goal, system)) is not None:
        return solutions
    levels = system.levels()
    if levels is None or not levels[0]:
        return None
    found = eliminant(levels[0], len(system.unknowns))
    return None if found is None else Builder(goal, system, found, levels[1]).roots()
