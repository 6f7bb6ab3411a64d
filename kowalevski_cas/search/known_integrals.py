"""Integrals that were found: by names that are known, or shorter by products of other ones."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from math import gcd, lcm

from kowalevski_cas.problem.polynomial_fields import Terms


def name_of(found: Terms, known: Sequence[Terms], named: Mapping[str, Terms], size: int) -> str:
    """The name of an integral that says as much as the found one; empty if none does.

    Each is a combination of the other and of products of the ``known`` ones.

    Args:
        found: a polynomial.
        known: the integrals before it.
        named: the integrals that have names.
        size: how many names move; the others are constants.
    """
    most = degree(found, size)
    named = {name: terms for name, terms in named.items() if degree(terms, size) == most}
    if not named:
        return ""
    space = _Combinations(products(known, most, size))
    rest = space.remainder(found)
    return next((n for n, terms in named.items() if _is_multiple(space.remainder(terms), rest)), "")


def shorten(found: Terms, known: Sequence[Terms], size: int) -> Terms:
    """The found one less multiples of products of the known ones, while that has fewer terms."""
    beside = list(products(known, degree(found, size), size))
    best = found
    while True:
        changes = (
            (len(p.keys() - best.keys()) - fewer, k, ratio)
            for k, p in enumerate(beside)
            for ratio, fewer in Counter(best[m] / p[m] for m in p.keys() & best.keys()).items()
        )
        more, product, ratio = min(changes, default=(0, 0, Fraction(0)))
        if more >= 0:
            return _whole(best)
        best = _less(best, beside[product], ratio)


def degree(terms: Terms, size: int) -> int:
    """The degree in what moves."""
    return max((sum(exponents[:size]) for exponents in terms), default=0)


def products(known: Sequence[Terms], most: int, size: int) -> Iterator[Terms]:
    """The products of known integrals, each several times, up to a degree; not the empty one."""
    for k, first in enumerate(known):
        rest = most - degree(first, size)
        if rest >= 0:
            yield first
            for other in products(known[k:], rest, size):
                yield _times(first, other)


class _Combinations:
    """The combinations of some polynomials, in echelon form."""

    def __init__(self, rows: Iterable[Terms]) -> None:
        self.rows: dict[tuple[int, ...], Terms] = {}
        for row in rows:
            if rest := self.remainder(row):
                self.rows[max(rest)] = rest

    def remainder(self, terms: Terms) -> Terms:
        """What no combination takes away."""
        rest, kept = dict(terms), Terms()
        while rest:
            leading = max(rest)
            if leading in self.rows:
                rest = _less(rest, self.rows[leading], rest[leading] / self.rows[leading][leading])
            else:
                kept[leading] = rest.pop(leading)
        return kept


def _is_multiple(one: Terms, other: Terms) -> bool:
    """Whether two polynomials are multiples of each other, and none is zero."""
    if not one or one.keys() != other.keys():
        return False
    return len({one[exponents] / other[exponents] for exponents in one}) == 1


def _less(terms: Terms, other: Terms, ratio: Fraction) -> Terms:
    """A polynomial less a multiple of another one."""
    result = dict(terms)
    for exponents, value in other.items():
        result[exponents] = result.get(exponents, Fraction(0)) - ratio * value
    return {exponents: value for exponents, value in result.items() if value}


def _times(one: Terms, other: Terms) -> Terms:
    result: Terms = {}
    for first, a in one.items():
        for second, b in other.items():
            exponents = tuple(map(sum, zip(first, second, strict=True)))
            result[exponents] = result.get(exponents, Fraction(0)) + a * b
    return {exponents: value for exponents, value in result.items() if value}


def _whole(terms: Terms) -> Terms:
    """The multiple with whole coefficients that have no common factor."""
    below = lcm(*(value.denominator for value in terms.values()))
    common = gcd(*(int(value * below) for value in terms.values()))
    return {exponents: value * Fraction(below, common) for exponents, value in terms.items()}
