"""What follows at real points only: products split, and sums of squares fall apart."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from functools import reduce
from itertools import chain, product
from operator import mul

from kowalevski_cas.algebra.factors import irreducible_factors
from kowalevski_cas.algebra.present import formula_rows
from kowalevski_cas.algebra.squares import four_squares, sum_of_squares
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.problem.evidence import Proof
from kowalevski_cas.problem.examine import value_of
from kowalevski_cas.search.combinations import Combinations, complete

DEPTH = 12
"""How many splits may follow one another."""

Group = tuple[Element, ...]
"""What vanishes with a factor: itself, or all that is squared in it."""


def proof_by_cases(
    conclusions: Sequence[Sequence[Element]], known: Sequence[Element], depth: int = DEPTH
) -> Proof | None:
    """A proof that at each real point where all known elements vanish those of a conclusion do.

    There an element of a Gröbner basis of the known ones vanishes, and so does one of its factors;
    if this is a sum of squares, each square does.
    """
    one = known[0].ring.one
    combinations = Combinations([*chain.from_iterable(conclusions), one], known)
    for k, conclusion in enumerate(conclusions or [[one]]):
        rows = complete(map(combinations.row, conclusion))
        if rows is not None:
            return Proof(formula_rows([*_alternatives(conclusions, k, rows)]))
    best = min(_products(combinations), key=lambda product: product[0], default=None)
    if best is None or not depth:
        return None
    _, groups, power = best
    rows = combinations.rows([reduce(mul, map(value_of, groups))], power)
    cases = complete(proof_by_cases(conclusions, [*known, *group], depth - 1) for group in groups)
    if rows is None or cases is None:
        return None
    return Proof(formula_rows(rows), formula_rows(groups), tuple(cases), power)


def _alternatives(
    conclusions: Sequence[Sequence[Element]], place: int, rows: Sequence[Sequence[Element]]
) -> Iterator[list[Element]]:
    """Rows for the products of an element of each conclusion, from those for one conclusion."""
    places = (range(len(conclusion)) for conclusion in conclusions)
    for choice in product(*places):
        factor = rows[0][0].ring.one
        for k, (conclusion, number) in enumerate(zip(conclusions, choice, strict=True)):
            factor = factor if k == place else factor * conclusion[number]
        row = rows[choice[place]] if conclusions else rows[0]
        yield [factor * entry for entry in row]


def _products(combinations: Combinations) -> Iterator[tuple[tuple[bool, int], list[Group], int]]:
    """The groups of factors of elements of the basis, and a power of their product in the ideal.

    The best ones have a sum of squares in them, and few terms.
    """
    ring = combinations.ring
    for element in combinations.reduced_basis():
        terms = element.terms()[0]
        factors = irreducible_factors(terms)
        groups = [
            tuple(
                ring.from_terms({0: base}) * ring.number(part)
                for number, base in sum_of_squares(factor) or ((Fraction(1), factor),)
                for part in four_squares(number)
                if part
            )
            for factor, _ in factors
        ]
        one = all(len(group) == 1 for group in groups)
        if not one or len(groups) > 1:
            yield (one, len(terms)), groups, max(exponent for _, exponent in factors)
