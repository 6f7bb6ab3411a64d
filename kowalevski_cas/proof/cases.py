"""Trees of cases: what a case split leaves behind, to be checked by anybody.

The records are tuples all the way down, so that they can be kept as evidence.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import Any, NamedTuple

Terms = dict[tuple[int, ...], Fraction]
Squares = tuple[tuple[Fraction, Terms], ...]
"""Positive factors, and what is squared."""

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

    @classmethod
    def read(cls, value: Any) -> Case:
        """The tree that was kept as plain tuples."""
        kind, known, reductions, children = value
        return cls(
            kind,
            known,
            tuple(Reduction(*reduction) for reduction in reductions),
            tuple((squares, cls.read(child)) for squares, child in children),
        )

    def nodes(self) -> Iterator[Case]:
        """All cases of the tree."""
        yield self
        for _, child in self.children:
            yield from child.nodes()

    def granted(self) -> Iterator[int]:
        """The indices of what the tree needs to be non-zero."""
        for case in self.nodes():
            for reduction in case.reductions:
                for powers in (reduction.unit, reduction.dropped):
                    yield from (index for index, exponent in enumerate(powers) if exponent)
                if case.kind == "empty":
                    yield reduction.target
