"""Trees of cases as proofs: rows of cofactors, and products that split."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import product
from math import isqrt

from kowalevski_cas.algebra.polynomials import Terms
from kowalevski_cas.algebra.present import formula_in
from kowalevski_cas.algebra.tower import Element, Ring
from kowalevski_cas.notation import Formula
from kowalevski_cas.problem.evidence import Proof
from kowalevski_cas.problem.examine import value_of
from kowalevski_cas.search.cases import Case, Powers, Reduction
from kowalevski_cas.search.squares import Squares

Row = list[Element]
Places = list[tuple[int, Fraction]]
"""Where in the list of what is known each equation of a case stands, and its factor there."""


class Unsplit(ValueError):
    """A tree of cases that is no proof; the message says why."""


@dataclass(frozen=True)
class System:
    """``targets`` vanish by assumption, ``granted`` do not; all ``goals`` are to vanish."""

    ring: Ring
    targets: Sequence[Element]
    goals: Sequence[Element]
    granted: Sequence[Element]

    def powers(self, exponents: Sequence[int]) -> Element:
        """A product of powers of what is granted."""
        result = self.ring.one
        for expression, exponent in zip(self.granted, exponents, strict=True):
            result = result * expression**exponent if exponent else result
        return result

    def element(self, terms: Terms) -> Element:
        """A polynomial as an element."""
        return self.ring.from_terms({0: terms})


class Prover:
    """Proofs that the goals of a system vanish where the elements of a list do.

    ``targets`` are the rows that combine the targets of the system from the list.
    The last granted expression is the left side of a surface ``level``; the element
    at ``place`` is the difference of its sides, and ``value`` the right one.
    """

    def __init__(
        self,
        system: System,
        targets: Sequence[Row],
        place: int,
        value: Element,
    ) -> None:
        self.system, self.targets = system, targets
        self.place, self.value, self.ring = place, value, system.ring

    def proof(self, case: Case, size: int, places: Places) -> Proof:
        """The proof of a case, in which the list has ``size`` elements."""
        if case.kind == "open":
            raise Unsplit("a case is left open")
        if case.kind == "set":
            rows = [
                self._divided(self._known(r, size, places), goal, r.unit)
                for goal, r in zip(self.system.goals, sorted(case.reductions), strict=True)
            ]
            return Proof(written(rows))
        (first, *_) = case.reductions
        row = self._known(first, size, places)
        if case.kind == "empty":
            powers = tuple(e + (k == first.target) for k, e in enumerate(first.unit))
            return self._contradiction(self._divided(row, self.ring.one, powers))
        unit = self.system.powers(first.unit)
        start = [unit * entry for entry in self.targets[first.target]]
        row = [a - b for a, b in zip(_longer(start, size, self.ring.zero), row, strict=True)]
        ((content,),) = (first.content.values(),)
        groups = [
            self._group(factor, exponent, squares)
            for (factor, exponent), (squares, _) in zip(first.factors, case.children, strict=True)
        ]
        left, number = self.ring.one, 1 / content
        for group, times, _ in groups:
            left, number = left * value_of(group), number * times
        row = [self.ring.number(number) * entry for entry in row]
        row = self._divided(row, left, first.dropped)
        if not groups:
            return self._contradiction(row)
        cases = []
        for (group, _, added), (_, child) in zip(groups, case.children, strict=True):
            inside = places + [(size + k, factor) for k, factor in added]
            cases.append(self.proof(child, size + len(group), inside))
        split = [group for group, _, _ in groups]
        return Proof(written([row]), written(split), tuple(cases))

    def _known(self, reduction: Reduction, size: int, places: Places) -> Row:
        """The quotients of a reduction, each at the place of its equation."""
        row = [self.ring.zero] * size
        for quotient, (place, factor) in zip(reduction.quotients, places, strict=True):
            row[place] = row[place] + self.system.element(quotient) * self.ring.number(1 / factor)
        return row

    def _divided(self, row: Row, left: Element, powers: Powers) -> Row:
        """The row for ``left``, from that for ``left`` times powers of what is granted.

        On the surface the last one is a number; elsewhere the difference of powers
        is a multiple of the difference of the sides.
        """
        *powers_of_conditions, power = powers
        below = self.system.powers((*powers_of_conditions, 0)) * self.value**power
        over = below.inverse()
        result = [entry * over for entry in row]
        ratio = self.system.granted[-1] * self.value.inverse()
        for k in range(power):
            rest = left * ratio**k * self.value.inverse()
            result[self.place] = result[self.place] - rest
        return result

    def _contradiction(self, row: Row) -> Proof:
        """Every goal, from a row that gives 1."""
        rows = [[goal * entry for entry in row] for goal in self.system.goals]
        return Proof(written(rows))

    def _group(
        self, factor: Terms, exponent: int, squares: Squares
    ) -> tuple[Row, Fraction, Places]:
        """What vanishes with a factor, how often the factor is taken, and the places of its parts.

        One element stands for itself, several for the sum of their squares.
        """
        if not squares and exponent <= 2:
            return [self.system.element(factor)] * exponent, Fraction(exponent), [(0, Fraction(1))]
        if exponent > 1 or len(squares) < 2:
            raise Unsplit("a factor of a case is a higher power")
        group: Row = []
        added: Places = []
        for number, base in squares:
            parts = [part for part in four_squares(number) if part]
            added.append((len(group), parts[0]))
            group += [self.ring.number(part) * self.system.element(base) for part in parts]
        return group, Fraction(1), added


def written(rows: Sequence[Sequence[Element]]) -> tuple[tuple[Formula, ...], ...]:
    """Rows of elements as formulas."""
    return tuple(tuple(map(formula_in, row)) for row in rows)


def _longer(row: Row, size: int, zero: Element) -> Row:
    return [*row, *([zero] * (size - len(row)))]


def four_squares(number: Fraction) -> tuple[Fraction, ...]:
    """Four rational numbers, the squares of which add up to a positive number (Lagrange).

    >>> sum(part**2 for part in four_squares(Fraction(7, 3))) == Fraction(7, 3)
    True
    """
    whole = number.numerator * number.denominator
    top = isqrt(whole)
    for a, b, c in product(range(top, -1, -1), repeat=3):
        rest = whole - a * a - b * b - c * c
        if rest >= 0 and isqrt(rest) ** 2 == rest:
            return tuple(Fraction(n, number.denominator) for n in (a, b, c, isqrt(rest)))
    raise AssertionError("every natural number is a sum of four squares")
