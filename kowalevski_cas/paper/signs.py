r"""Inequalities: differences, what is said of them, and the roots that say the same.

A real number is not negative if it is a square, and if it is its own absolute value. So what is
supposed of a difference f is that the root :math:`\sqrt f` is real, and what is claimed of it is
the equation :math:`f=\sqrt{f^2}`; for a root that is printed, which is not negative, the root of it
says so. Nothing but equations, at real points, is left to be proved.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import pairwise
from typing import NamedTuple

from kowalevski_cas.algebra.numbers import rational
from kowalevski_cas.notation import (
    EQUALITIES,
    Formula,
    Negative,
    Number,
    Relation,
    Root,
    Sum,
    to_latex,
)
from kowalevski_cas.paper.roots import rationals
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.space import Meaningless

SIGNS = {"<": "<", ">": "<", r"\le": r"\le", r"\ge": r"\le", r"\ne": r"\ne"}
"""The signs of inequalities, each with the one to which the other way round it comes."""


SAID = {"<": ">", r"\le": r"\ge", r"\ne": r"\ne", "=": "="}
"""How the sign of a comparison reads with the difference before it."""


class Comparison(NamedTuple):
    """Two neighbours of a chain: the larger less the smaller one, and the sign between them."""

    difference: Formula
    sign: str

    @property
    def said(self) -> Formula:
        """What it says, against zero."""
        return Relation((self.difference, Number(0)), (SAID[self.sign],))

    @property
    def number(self) -> bool | None:
        """Whether it is true, where the difference is a rational number; else ``None``."""
        try:
            value = rational(rationals().scalar(self.difference))
        except Meaningless:
            return None
        if value is None:
            return None
        if self.sign in (r"\ne", "="):
            return (value == 0) == (self.sign == "=")
        return value > 0 or (value == 0 and self.sign == r"\le")


def comparisons(relation: Relation) -> Iterator[Comparison]:
    """What a chain says of each two neighbours.

    Raises :class:`Meaningless` for a sign that is neither an equality nor an inequality.
    """
    for (left, right), sign in zip(pairwise(relation.members), relation.signs, strict=True):
        if sign in EQUALITIES:
            sign = "="
        elif sign not in SIGNS:
            raise Meaningless(f"{sign} is no inequality")
        smaller, larger = (right, left) if sign in (">", r"\ge") else (left, right)
        yield Comparison(_difference(larger, smaller), SIGNS.get(sign, sign))


def _difference(larger: Formula, smaller: Formula) -> Formula:
    if smaller == Number(0):
        return larger
    if larger == Number(0):
        return smaller.argument if isinstance(smaller, Negative) else Negative(smaller)
    return Sum((larger, Negative(smaller)))


def is_inequality(formula: Formula) -> bool:
    """Whether something is larger, or not smaller, by a chain."""
    return isinstance(formula, Relation) and any(
        SIGNS.get(sign, r"\ne") != r"\ne" for sign in formula.signs
    )


def root_of(formula: Formula) -> str:
    """The name of the root of a formula that is not negative."""
    return to_latex(Root(formula))


def contradiction(
    supposed: Sequence[Comparison], at: Evaluation
) -> tuple[Comparison, Comparison] | None:
    """Two comparisons of which positive multiples add up to a number that is too small, if any do.

    Longer combinations, as of a < b, b < c and c < a, are not looked for.
    """
    known: dict[frozenset[object], list[tuple[Fraction, Comparison]]] = {}
    for comparison in supposed:
        if comparison.sign == r"\ne" or (element := at.scalar(comparison.difference)).denominator:
            continue
        terms = {(mask, e): c for mask, part in element.terms().items() for e, c in part.items()}
        units = [(mask, e) for mask, e in terms if not mask and not any(e)]
        number = sum(map(terms.pop, units), Fraction())
        if not terms:
            continue
        scale = abs(terms[max(terms)])
        part = {(one, c / scale) for one, c in terms.items()}
        for other, before in known.get(frozenset((one, -c) for one, c in part), ()):
            rest = other + number / scale
            if rest < 0 or (rest == 0 and "<" in (comparison.sign, before.sign)):
                return before, comparison
        known.setdefault(frozenset(part), []).append((number / scale, comparison))
    return None
