r"""Proofs by cases: which real solutions a system has, one factored consequence at a time.

Under equations that are known, a consequence of the system (a target) is reduced
by pseudo-division and factored. One of its factors has to vanish; factors that
are granted not to vanish are dropped, and a factor that is a sum of squares
vanishes over the reals only if each square does. Each factor opens a case with
more known equations, until the equations of a given set follow, or nothing is
left to follow.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import NamedTuple

from flint import fmpq_mpoly

from kowalevski_cas.algebra.flint import terms_of, to_flint, to_fraction
from kowalevski_cas.algebra.present import written
from kowalevski_cas.algebra.tower import Element, Ring
from kowalevski_cas.problem.evidence import Proof
from kowalevski_cas.problem.examine import value_of
from kowalevski_cas.search.branches import coefficient
from kowalevski_cas.search.cofactors import pseudo_divide
from kowalevski_cas.search.squares import four_squares, sum_of_squares

Row = list[Element]
Powers = tuple[int, ...]
"""Exponents of the expressions that are granted not to vanish."""


class Known(NamedTuple):
    """A known equation with its main variable; ``factor`` times it stands at ``place`` in a row."""

    polynomial: fmpq_mpoly
    variable: int
    place: int
    factor: Fraction


class Reduction(NamedTuple):
    """``granted**unit * f = sum quotients * known + content * granted**dropped * factors``.

    The ``factors`` come with exponents, and are empty if the content is zero.
    """

    unit: Powers
    quotients: list[fmpq_mpoly]
    content: Fraction
    dropped: Powers
    factors: list[tuple[fmpq_mpoly, int]]


class Opened(NamedTuple):
    """The case in which a factor, taken so many ``times``, vanishes.

    One element of the ``group`` stands for itself, several for the sum of their squares; no times
    are told if the factor is none of these.
    """

    group: Row
    times: Fraction
    known: tuple[Known, ...]


DEPTH = 9
"""How many splits may follow one another."""

LARGEST = 400
"""How many terms a consequence may have to be split."""


class Splitter:
    """The search for a proof that the goals vanish where the elements of a list do.

    ``targets`` vanish there: the ``rows`` combine them from the list. ``granted`` do not; the last
    of them is the left side of a surface, the element at ``place`` in the list is the difference of
    its sides, and ``value`` the right one. ``open`` has what is known in the cases that are left.
    """

    def __init__(
        self,
        targets: Sequence[Element],
        goals: Sequence[Element],
        granted: Sequence[Element],
        rows: Sequence[Row],
        place: int,
        value: Element,
    ) -> None:
        self.ring: Ring = value.ring
        self.targets, self.goals, self.granted = targets, goals, granted
        self.rows, self.place, self.value = rows, place, value
        self.divisors = [*map(self._polynomial, granted)]
        self.open: list[list[Element]] = []

    def proof(self, size: int, known: tuple[Known, ...] = (), depth: int = DEPTH) -> Proof | None:
        """The proof of the case of known equations, in which the list has ``size`` elements."""
        one = self.ring.one
        for k, expression in enumerate(self.granted if known else ()):
            reduction = self._reduced(expression, known)
            if reduction is not None and not reduction.content:
                powers = tuple(e + (j == k) for j, e in enumerate(reduction.unit))
                row = self._combined(reduction, known, size)
                return self._contradiction(self._divided(row, one, powers))
        goals = [self._reduced(goal, known) for goal in self.goals]
        settled = [r for r in goals if r is not None and not r.content]
        if len(settled) == len(goals):
            pairs = zip(settled, self.goals, strict=True)
            return Proof(
                written(self._divided(self._combined(r, known, size), g, r.unit) for r, g in pairs)
            )
        found = ((k, self._reduced(target, known)) for k, target in enumerate(self.targets))
        usable = [(k, r) for k, r in found if r is not None and r.content]
        usable.sort(key=lambda one: sum(len(factor) for factor, _ in one[1].factors))
        for k, reduction in usable if depth else ():
            opened = [self._opened(*factor, known, size) for factor in reduction.factors]
            cases = [one for one in opened if one is not None]
            if len(cases) == len(opened):
                return self._split(k, reduction, cases, known, size, depth)
        self.open.append([self._element(one.polynomial) for one in known])
        return None

    def _split(
        self,
        target: int,
        reduction: Reduction,
        opened: Sequence[Opened],
        known: tuple[Known, ...],
        size: int,
        depth: int,
    ) -> Proof | None:
        """The proof from the cases in which the factors of a reduced target vanish."""
        cases = [
            self.proof(size + len(group), (*known, *more), depth - 1) for group, _, more in opened
        ]
        proved = tuple(case for case in cases if case is not None)
        if len(proved) < len(opened) or not all(times for _, times, _ in opened):
            return None
        unit = self._powers(reduction.unit)
        start = [unit * entry for entry in self.rows[target]]
        start += [self.ring.zero] * (size - len(start))
        known_row = self._combined(reduction, known, size)
        left, number = self.ring.one, 1 / reduction.content
        for group, times, _ in opened:
            left, number = left * value_of(group), number * times
        row = [self.ring.number(number) * (a - b) for a, b in zip(start, known_row, strict=True)]
        row = self._divided(row, left, reduction.dropped)
        if not opened:
            return self._contradiction(row)
        return Proof(written([row]), written(group for group, *_ in opened), proved)

    def _reduced(self, element: Element, known: Sequence[Known]) -> Reduction | None:
        """An element modulo the known equations, factored; ``None`` if a unit is not granted."""
        rest = self._polynomial(element)
        context = rest.context()
        unit, quotients = context.constant(1), [context.constant(0)] * len(known)
        for _ in range(2):
            for k, (divisor, variable, *_) in enumerate(known):
                if len(rest) > LARGEST:
                    return None
                if len(divisor) == 1:
                    quotient, rest = divmod(rest, divisor)
                    quotients[k] += quotient
                    continue
                factor, (quotient,), rest = pseudo_divide(rest, [divisor], (variable,))
                if quotient:
                    unit *= factor
                    quotients = [q * factor for q in quotients]
                    quotients[k] += quotient
        powers, left = self._without_granted(unit)
        if not left.is_constant():
            return None
        quotients, rest = [q / left for q in quotients], rest / left
        if len(rest) > LARGEST:
            return None
        if not rest:
            return Reduction(powers, quotients, Fraction(0), (0,) * len(self.granted), [])
        dropped, rest = self._without_granted(rest)
        content, factors = rest.factor()
        return Reduction(powers, quotients, to_fraction(content), dropped, factors)

    def _without_granted(self, polynomial: fmpq_mpoly) -> tuple[Powers, fmpq_mpoly]:
        powers = []
        for expression in self.divisors:
            powers.append(0)
            quotient, remainder = divmod(polynomial, expression)
            while not remainder:
                powers[-1] += 1
                polynomial = quotient
                quotient, remainder = divmod(polynomial, expression)
        return tuple(powers), polynomial

    def _opened(
        self, factor: fmpq_mpoly, exponent: int, known: tuple[Known, ...], size: int
    ) -> Opened | None:
        """The case in which a factor vanishes; ``None`` if its equations have no main variable."""
        context, group = factor.context(), Row()
        squares = sum_of_squares(terms_of(factor)) or ()
        bases = [(number, self.ring.polynomials.from_terms(base)) for number, base in squares] or [
            (Fraction(1), factor)
        ]
        more = []
        for number, base in bases:
            variable = self._main(base)
            if variable is None:
                return None
            parts = [part for part in four_squares(number) if part]
            more.append(Known(base, variable, size + len(group), parts[0]))
            group += [self._element(base * context.constant(to_flint(part))) for part in parts]
        if not squares and exponent <= 2:
            return Opened(group * exponent, Fraction(exponent), tuple(more))
        return Opened(group, Fraction(exponent == 1 and len(squares) > 1), tuple(more))

    def _main(self, polynomial: fmpq_mpoly) -> int | None:
        """The variable of least degree whose leading coefficient is granted not to vanish."""
        degrees = polynomial.degrees()
        for variable in sorted(range(len(degrees)), key=lambda k: (degrees[k], -k)):
            if degrees[variable]:
                leading = coefficient(polynomial, variable, degrees[variable])
                if self._without_granted(leading)[1].is_constant():
                    return variable
        return None

    # -- rows ----------------------------------------------------------------------------

    def _combined(self, reduction: Reduction, known: Sequence[Known], size: int) -> Row:
        """The quotients of a reduction, each at the place of its equation."""
        row = [self.ring.zero] * size
        for quotient, (*_, place, factor) in zip(reduction.quotients, known, strict=True):
            row[place] = row[place] + self._element(quotient) * self.ring.number(1 / factor)
        return row

    def _divided(self, row: Row, left: Element, powers: Powers) -> Row:
        """The row for ``left``, from that for ``left`` times powers of what is granted.

        On the surface the last one is a number; elsewhere the difference of powers
        is a multiple of the difference of the sides.
        """
        *powers_of_conditions, power = powers
        over = (self._powers((*powers_of_conditions, 0)) * self.value**power).inverse()
        result = [entry * over for entry in row]
        ratio = self.granted[-1] * self.value.inverse()
        for k in range(power):
            rest = left * ratio**k * self.value.inverse()
            result[self.place] = result[self.place] - rest
        return result

    def _contradiction(self, row: Row) -> Proof:
        """Every goal, from a row that gives 1."""
        return Proof(written([goal * entry for entry in row] for goal in self.goals))

    def _powers(self, exponents: Sequence[int]) -> Element:
        """A product of powers of what is granted."""
        result = self.ring.one
        for expression, exponent in zip(self.granted, exponents, strict=True):
            result = result * expression**exponent if exponent else result
        return result

    def _polynomial(self, element: Element) -> fmpq_mpoly:
        polynomial: fmpq_mpoly = element.parts.get(0) or self.ring.polynomials.zero
        return polynomial

    def _element(self, polynomial: fmpq_mpoly) -> Element:
        return self.ring.element({0: polynomial}, {})
