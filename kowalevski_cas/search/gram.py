"""Gram matrices: sums of squares times weights, with exact entries.

Floats are made rational: exact equations are solved for some entries, all others are rounded, and a
matrix is kept if it is exactly positive. Where all solutions are singular, as they are for a
polynomial with a real zero, the vectors on which a matrix vanishes are read off, and no solution is
sought but those that vanish there (facial reduction).

J. M. Peyrl, P. A. Parrilo, "Computing sum of squares decompositions with rational coefficients",
Theoretical Computer Science 409 (2008); D. Monniaux, P. Corbineau, "On the generation of
Positivstellensatz witnesses in degenerate cases" (2011).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import chain, combinations, combinations_with_replacement
from math import prod
from typing import NamedTuple

from flint import fmpq_mat, fmpq_mpoly

from kowalevski_cas.algebra.flint import polynomial_of, terms_of, to_flint, to_fraction
from kowalevski_cas.algebra.polynomials import Terms, TooLarge
from kowalevski_cas.algebra.squares import Squares, reduce_gram
from kowalevski_cas.problem.polynomial_fields import number_of_monomials
from kowalevski_cas.search.semidefinite import Row, SemidefiniteProgram, Vectors

ROUNDS = 4
"""How often the solutions are looked for on a smaller face."""

DENOMINATORS = (1, 2, 6, 24, 1000)
"""The largest denominators to which entries are rounded, in turn."""

LARGEST = 2_500
"""How many unknowns a program may have."""

MOST = 100_000
"""How many monomials are looked at, and how many pairs of them, to see which are needed."""

LONGEST = 2**96
"""The largest factor of a square: nobody reads, or checks, what is longer."""

POSITIVE = 1e-5
"""What is surely positive."""

Monomial = tuple[int, ...]


class Summand(NamedTuple):
    """A sum of squares times a product of weights, which their places give."""

    weights: tuple[int, ...]
    squares: Squares


class Representation(NamedTuple):
    """The target, and what is known times these factors, are the sum of the summands."""

    factors: list[fmpq_mpoly]
    summands: list[Summand]

    def composed(self, images: Sequence[fmpq_mpoly]) -> Representation:
        """The same with these polynomials for the variables."""
        context = images[0].context()
        summands = [
            Summand(
                places,
                tuple(
                    (number, terms_of(polynomial_of(context, base).compose(*images)))
                    for number, base in squares
                ),
            )
            for places, squares in self.summands
        ]
        return Representation([one.compose(*images) for one in self.factors], summands)


class _Block(NamedTuple):
    """A Gram matrix on monomials, and the product of weights by which it is multiplied."""

    places: tuple[int, ...]
    weight: Terms
    monomials: list[Monomial]
    start: int

    def unknown(self, i: int, j: int) -> int:
        """The number of an entry, by columns of the upper triangle."""
        i, j = min(i, j), max(i, j)
        return self.start + j * (j + 1) // 2 + i

    @property
    def size(self) -> int:
        """The number of rows."""
        return len(self.monomials)


class GramEquations:
    """The equations between Gram matrices, factors of what is known, and a target.

    Raises:
        TooLarge: there are too many unknowns.
    """

    def __init__(
        self,
        target: fmpq_mpoly,
        weights: Sequence[fmpq_mpoly],
        known: Sequence[fmpq_mpoly],
        size: int,
    ) -> None:
        self.target, self.known = target, known
        degree = max(1, *(int(p.total_degree()) for p in (target, *known)))
        self.degree = degree + degree % 2
        self.names = sorted(
            {k for p in (target, *weights, *known) for k, d in enumerate(p.degrees()) if d}
        )
        self.context, self.count = target.context(), target.context().nvars()
        subsets = chain.from_iterable(combinations(range(len(weights)), k) for k in range(size + 1))
        blocks = [*self._blocks(subsets, weights)]
        _bound(sum(_number_of_pairs(monomials) for _, _, monomials in blocks), MOST)
        while self._prune(blocks):
            pass
        self.blocks: list[_Block] = []
        self.unknowns = 0
        for places, weight, monomials in (one for one in blocks if one[2]):
            self.blocks.append(_Block(places, weight, monomials, self.unknowns))
            self.unknowns += _number_of_pairs(monomials)
        self.first_factor = self.unknowns
        left = [self.degree - int(own.total_degree()) for own in known]
        _bound(self.unknowns + sum(map(self._number, left)), LARGEST)
        self.factors = [(k, one) for k, most in enumerate(left) for one in self._monomials(most)]
        self.unknowns += len(self.factors)
        self.rows, self.right = self._equations()

    def _blocks(
        self, subsets: Iterator[tuple[int, ...]], weights: Sequence[fmpq_mpoly]
    ) -> Iterator[tuple[tuple[int, ...], Terms, list[Monomial]]]:
        degrees = (p.degrees() for p in (self.target, *weights, *self.known))
        most = [*map(max, zip(*degrees, strict=True))]
        least = 0 if weights or self.known else min(map(sum, self.target.monoms()))
        looked_at = 0
        for places in subsets:
            weight = prod((weights[k] for k in places), start=self.context.constant(1))
            left = self.degree - int(weight.total_degree())
            if left >= 0:
                looked_at += self._number(left // 2)
                _bound(looked_at, MOST)
                monomials = [*self._halves(left // 2, weight, most, least)]
                yield places, terms_of(weight), monomials

    def _prune(self, blocks: list[tuple[tuple[int, ...], Terms, list[Monomial]]]) -> bool:
        """Leave out the monomials whose squares nothing can cancel; whether there are some."""
        if self.known:
            return False
        target, alone = terms_of(self.target), dict[Monomial, list[tuple[int, Monomial, bool]]]()
        mixed: set[Monomial] = set()
        for k, (_, weight, monomials) in enumerate(blocks):
            for j, second in enumerate(monomials):
                for own, value in weight.items():
                    square = _times(own, second, second)
                    alone.setdefault(square, []).append((k, second, value > 0))
                    mixed.update(_times(own, first, second) for first in monomials[:j])
        found = False
        for monomial, squares in alone.items():
            one_sign = len({sign for _, _, sign in squares}) == 1
            if monomial in target or monomial in mixed or not one_sign:
                continue
            for k, own, _ in squares:
                if own in blocks[k][2]:
                    blocks[k][2].remove(own)
                    found = True
        return found

    def _number(self, degree: int) -> int:
        """How many monomials there are up to a degree."""
        return number_of_monomials((1,) * len(self.names), degree)

    def _monomials(self, degree: int) -> Iterator[Monomial]:
        """All monomials up to a degree."""
        for size in range(degree + 1):
            for chosen in combinations_with_replacement(self.names, size):
                yield tuple(chosen.count(k) for k in range(self.count))

    def _halves(
        self, degree: int, weight: fmpq_mpoly, most: Sequence[int], least: int
    ) -> Iterator[Monomial]:
        """The monomials up to a degree whose squares, times a weight, are in some box."""
        room = [top - own for top, own in zip(most, weight.degrees(), strict=True)]
        for one in self._monomials(degree):
            if 2 * sum(one) >= least and all(2 * e <= r for e, r in zip(one, room, strict=True)):
                yield one

    def _equations(self) -> tuple[list[Row], list[Fraction]]:
        """For each monomial the coefficients of the unknowns, and that of the target."""
        rows: dict[Monomial, Row] = {}

        def enter(monomial: Monomial, unknown: int, value: Fraction) -> None:
            row = rows.setdefault(monomial, {})
            row[unknown] = row.get(unknown, Fraction(0)) + value

        for block in self.blocks:
            for j, second in enumerate(block.monomials):
                for i, first in enumerate(block.monomials[: j + 1]):
                    for own, value in block.weight.items():
                        twice = value if i == j else 2 * value
                        enter(_times(own, first, second), block.unknown(i, j), twice)
        for number, (k, monomial) in enumerate(self.factors):
            for own, value in terms_of(self.known[k]).items():
                enter(_times(own, monomial), self.first_factor + number, -value)
        terms = terms_of(self.target)
        keys = [*rows, *(one for one in terms if one not in rows)]
        return [rows.get(k, {}) for k in keys], [terms.get(k, Fraction(0)) for k in keys]

    def solve(self) -> Representation | None:
        """A representation, on smaller and smaller faces."""
        if any(value and not row for row, value in zip(self.rows, self.right, strict=True)):
            return None
        zeros: list[Vectors] = [[] for _ in self.blocks]
        for _ in range(ROUNDS):
            rows, right = [*self.rows], [*self.right]
            for block, vectors in zip(self.blocks, zeros, strict=True):
                for vector in vectors:
                    rows += _vanishing(block, vector)
            right += [Fraction(0)] * (len(rows) - len(right))
            entries = [
                [one.unknown(i, j) for j in range(one.size) for i in range(j + 1)]
                for one in self.blocks
            ]
            program = SemidefiniteProgram(self.unknowns, rows, right, entries)
            if (found := program.solve(zeros)) is None:
                return None
            values, margin = found
            if margin > POSITIVE and (exact := self._exact(rows, right, values)) is not None:
                return exact
            before = sum(map(len, zeros))
            zeros = program.zeros(values, zeros)
            if margin < -POSITIVE or sum(map(len, zeros)) == before:
                return None
        return None

    def _exact(
        self, rows: list[Row], right: list[Fraction], values: Sequence[float]
    ) -> Representation | None:
        """The first of the roundings that solves the equations by matrices that are positive."""
        width = self.unknowns
        table = fmpq_mat(len(rows), width + 1)
        for k, (row, value) in enumerate(zip(rows, right, strict=True)):
            for unknown, coefficient in row.items():
                table[k, unknown] = to_flint(coefficient)
            table[k, width] = to_flint(value)
        reduced, rank = table.rref()
        solved: dict[int, Row] = {}
        for k in range(rank):
            entries = [j for j in range(width + 1) if reduced[k, j]]
            solved[entries[0]] = {j: to_fraction(reduced[k, j]) for j in entries[1:]}
        if width in solved:
            return None
        for bound in DENOMINATORS:
            near = [Fraction(float(value)).limit_denominator(bound) for value in values]
            near.append(Fraction(-1))  # the right side
            for unknown, row in solved.items():
                near[unknown] = -sum((near[j] * value for j, value in row.items()), Fraction(0))
            if (found := self._represented(near)) is not None:
                return found
        return None

    def _represented(self, values: Sequence[Fraction]) -> Representation | None:
        summands: list[Summand] = []
        for block in self.blocks:
            gram = {
                first: {
                    second: values[block.unknown(i, j)]
                    for j, second in enumerate(block.monomials)
                    if values[block.unknown(i, j)]
                }
                for i, first in enumerate(block.monomials)
            }
            if (squares := reduce_gram(gram)) is None or any(map(_is_long, squares)):
                return None
            if squares:
                summands.append(Summand(block.places, squares))
        parts: list[dict[Monomial, Fraction]] = [{} for _ in self.known]
        for number, (k, monomial) in enumerate(self.factors):
            parts[k][monomial] = values[self.first_factor + number]
        factors = [
            self.context.from_dict({one: to_flint(value) for one, value in part.items() if value})
            for part in parts
        ]
        return Representation(factors, summands)


def _bound(number: int, most: int) -> None:
    if number > most:
        raise TooLarge(f"{number} unknowns are in the equations for Gram matrices")


def _number_of_pairs(monomials: Sequence[Monomial]) -> int:
    return len(monomials) * (len(monomials) + 1) // 2


def _is_long(square: tuple[Fraction, Terms]) -> bool:
    return square[0].numerator * square[0].denominator > LONGEST


def _times(*monomials: Monomial) -> Monomial:
    return tuple(map(sum, zip(*monomials, strict=True)))


def _vanishing(block: _Block, vector: Sequence[Fraction]) -> Iterator[Row]:
    """The equations that a matrix vanishes on a vector."""
    for i in range(block.size):
        yield {block.unknown(i, j): value for j, value in enumerate(vector) if value}
