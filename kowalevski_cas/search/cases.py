r"""Case splits: which real solutions a system of equations has, one factored consequence at a time.

Under equations that are known, a consequence of the system (a target) is reduced
by pseudo-division and factored. One of its factors has to vanish; factors that
are granted not to vanish are dropped, and a factor that is a sum of squares
vanishes over the reals only if each square does. Each factor opens a case with
more known equations, until the equations of a given set follow, or nothing is
left to follow. The tree is only found here.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from flint import fmpq_mpoly

from kowalevski_cas.algebra.polynomials import Polynomial, Polynomials, Terms
from kowalevski_cas.search.cofactors import pseudo_divide
from kowalevski_cas.search.squares import Squares, sum_of_squares

Powers = tuple[int, ...]
"""Exponents of the expressions that are granted not to vanish."""


class Reduction(NamedTuple):
    """``granted**unit * target = sum quotients * known + content * granted**dropped * factors``.

    ``target`` is an index; ``factors`` come with exponents, and are empty if
    the content is zero.
    """

    target: int
    unit: Powers
    quotients: tuple[Terms, ...]
    content: Terms
    dropped: Powers
    factors: tuple[tuple[Terms, int], ...]


class Case(NamedTuple):
    """One case: the reductions that settle it, or the one that splits it.

    ``kind`` is ``split`` (a consequence factors; ``children`` belong to its
    factors, with the squares of which the factor is the sum), ``set`` (every
    equation of the set follows), ``empty`` (something granted would vanish), or
    ``open`` (nothing more follows).
    """

    kind: str
    known: tuple[Terms, ...]
    reductions: tuple[Reduction, ...] = ()
    children: tuple[tuple[Squares, Case], ...] = ()

    def nodes(self) -> Iterator[Case]:
        """All cases of the tree."""
        yield self
        for _, child in self.children:
            yield from child.nodes()


DEPTH = 9
"""How many splits may follow one another."""

LARGEST = 400
"""How many terms a consequence may have to be split."""


class Splitter:
    """The search for a tree of cases.

    ``targets`` vanish; ``granted`` do not; ``goals`` are the equations of the set.
    """

    def __init__(
        self,
        polynomials: Polynomials,
        targets: Sequence[Polynomial],
        goals: Sequence[Polynomial],
        granted: Sequence[Polynomial],
    ) -> None:
        self.polynomials = polynomials
        self.targets = targets
        self.goals = goals
        self.granted = granted

    def case(self, known: tuple[tuple[fmpq_mpoly, int], ...] = (), depth: int = DEPTH) -> Case:
        """The tree of cases under known equations, each with its main variable."""
        shown = tuple(self.polynomials.terms(g) for g, _ in known)
        for k, expression in enumerate(self.granted):
            reduction = self.reduce(k, expression, known) if known else None
            if reduction is not None and not reduction.content:
                return Case("empty", shown, (reduction,))
        goals = [self.reduce(k, goal, known) for k, goal in enumerate(self.goals)]
        settled = tuple(g for g in goals if g is not None and not g.content)
        if len(settled) == len(self.goals):
            return Case("set", shown, settled)
        splits = [self.reduce(k, target, known) for k, target in enumerate(self.targets)]
        usable = [s for s in splits if s is not None and s.content]
        for split in sorted(usable, key=_simplicity) if depth else ():
            opened = [self._opened(factor, known) for factor, _ in split.factors]
            cases = [entry for entry in opened if entry is not None]
            if len(cases) == len(opened):
                children = tuple((s, self.case(more, depth - 1)) for s, more in cases)
                return Case("split", shown, (split,), children)
        return Case("open", shown)

    def reduce(
        self, index: int, target: fmpq_mpoly, known: Sequence[tuple[fmpq_mpoly, int]]
    ) -> Reduction | None:
        """A target modulo the known equations, factored; ``None`` if a unit is not granted."""
        context = target.context()
        unit, rest = context.constant(1), target
        quotients = [context.constant(0)] * len(known)
        for _ in range(2):
            for k, (divisor, variable) in enumerate(known):
                if len(rest) > LARGEST:
                    return None
                if len(divisor) == 1:
                    quotient, rest = divmod(rest, divisor)
                    quotients[k] += quotient
                    continue
                factor, (quotient,), rest = pseudo_divide(rest, [divisor], (variable,))
                if quotient.is_zero():
                    continue
                unit *= factor
                quotients = [q * factor for q in quotients]
                quotients[k] += quotient
        powers, left = self._without_granted(unit)
        if not left.is_constant():
            return None
        quotients = [q / left for q in quotients]
        rest = rest / left
        if len(rest) > LARGEST:
            return None
        found = tuple(self.polynomials.terms(q) for q in quotients)
        if rest.is_zero():
            return Reduction(index, powers, found, {}, (0,) * len(self.granted), ())
        dropped, rest = self._without_granted(rest)
        content, factors = rest.factor()
        number = self.polynomials.terms(context.constant(content))
        split = tuple((self.polynomials.terms(f), int(exponent)) for f, exponent in factors)
        return Reduction(index, powers, found, number, dropped, split)

    def _without_granted(self, polynomial: fmpq_mpoly) -> tuple[Powers, fmpq_mpoly]:
        powers = []
        for expression in self.granted:
            powers.append(0)
            quotient, remainder = divmod(polynomial, expression)
            while remainder.is_zero():
                powers[-1] += 1
                polynomial = quotient
                quotient, remainder = divmod(polynomial, expression)
        return tuple(powers), polynomial

    def _opened(
        self, factor: Terms, known: tuple[tuple[fmpq_mpoly, int], ...]
    ) -> tuple[Squares, tuple[tuple[fmpq_mpoly, int], ...]] | None:
        """The known equations of the case in which a factor vanishes."""
        squares = sum_of_squares(factor) or ()
        for base in [base for _, base in squares] or [factor]:
            polynomial = self.polynomials.from_terms(base)
            variable = self._main(polynomial)
            if variable is None:
                return None
            known = (*known, (polynomial, variable))
        return squares, known

    def _main(self, polynomial: fmpq_mpoly) -> int | None:
        """The variable of least degree whose leading coefficient is granted not to vanish."""
        degrees = polynomial.degrees()
        for variable in sorted(range(len(degrees)), key=lambda k: (degrees[k], -k)):
            if not degrees[variable]:
                continue
            leading = {
                tuple(0 if k == variable else e for k, e in enumerate(exponents)): value
                for exponents, value in polynomial.to_dict().items()
                if exponents[variable] == degrees[variable]
            }
            left = self._without_granted(polynomial.context().from_dict(leading))[1]
            if left.is_constant():
                return variable
        return None


def _simplicity(split: Reduction) -> tuple[int, int]:
    """Factors with few terms first."""
    return sum(len(factor) for factor, _ in split.factors), split.target
