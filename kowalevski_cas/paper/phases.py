r"""Phases: arguments as :math:`n(t-t_1)`, in which one term moves, taken as a whole.

The functions at a sum are made of those at its terms. Where all arguments are sums of multiples of
fewer ones than there are terms in them, those at these arguments say the same, and are simpler.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from fractions import Fraction

from kowalevski_cas.notation import Formula
from kowalevski_cas.paper.arguments import Combination, Monomial


class Phases:
    """The phases among the ``arguments`` of a family, which are given with their terms.

    ``is_one`` says of the terms that hang together whether sums of them are phases, and
    ``is_value`` of a term that the functions there are known: it is added to a phase.
    """

    def __init__(
        self,
        arguments: Mapping[Formula, Combination],
        is_one: Callable[[frozenset[Monomial]], bool],
        is_value: Callable[[Monomial], bool],
    ) -> None:
        self.spans: list[_Span] = []
        inner = {
            formula: {term: factor for term, factor in argument.items() if not is_value(term)}
            for formula, argument in arguments.items()
        }
        for terms in filter(is_one, _components(inner.values())):
            span, shifted = _Span(terms), list[Combination]()
            for formula, argument in inner.items():
                if not terms.isdisjoint(argument):
                    if argument == arguments[formula]:
                        span.add(formula, argument)
                    else:
                        shifted.append(argument)
            known = not any(span.reduced(argument)[0] for argument in shifted)
            if known and len(span.rows) < len(terms):
                self.spans.append(span)

    def __call__(self, argument: Combination) -> Combination:
        """An argument by the phases of which it is made."""
        for span in self.spans:
            if not span.terms.isdisjoint(argument):
                rest, found = span.reduced(argument)
                return {**found, **rest} if span.terms.isdisjoint(rest) else argument
        return argument


def _components(arguments: Iterable[Combination]) -> list[frozenset[Monomial]]:
    """The terms that hang together, as they stand in one argument."""
    found: list[frozenset[Monomial]] = []
    for argument in arguments:
        joined = [group for group in found if not group.isdisjoint(argument)]
        found = [group for group in found if group not in joined]
        found.append(frozenset(argument).union(*joined))
    return found


class _Span:
    """The sums of multiples of arguments, each row with its first term and what it is made of."""

    def __init__(self, terms: frozenset[Monomial]) -> None:
        self.terms = terms
        self.rows: list[tuple[Monomial, Combination, Combination]] = []

    def reduced(self, argument: Combination) -> tuple[Combination, Combination]:
        """What is left of an argument, and the multiples of arguments that were subtracted."""
        rest, found = argument, dict[Monomial, Fraction]()
        for term, row, by in self.rows:
            if factor := rest.get(term, Fraction(0)) / row[term]:
                rest, found = _plus(rest, row, -factor), _plus(found, by, factor)
        return rest, found

    def add(self, formula: Formula, argument: Combination) -> None:
        """Let an argument be a phase, if it is none of the sums."""
        rest, found = self.reduced(argument)
        if rest:
            phase: Combination = {((formula, 1),): Fraction(1)}
            self.rows.append((next(iter(rest)), rest, _plus(phase, found, Fraction(-1))))


def _plus(left: Combination, right: Combination, factor: Fraction) -> dict[Monomial, Fraction]:
    found = {**left}
    for term, number in right.items():
        found[term] = found.get(term, Fraction(0)) + factor * number
    return {term: number for term, number in found.items() if number}
