r"""Inequalities: differences, what is said of them, and the roots that say the same.

A real number is not negative if it is a square, and if it is its own absolute value. So what is
supposed of a difference f is that the root :math:`\sqrt f` is real, and what is claimed of it is
the equation :math:`f=\sqrt{f^2}`; for a root that is printed, which is not negative, the root of it
says so. Nothing but equations, at real points, is left to be proved.
"""

from __future__ import annotations

from collections.abc import Iterator
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
from kowalevski_cas.problem.space import Meaningless

SIGNS = {
    "<": "<", ">": "<", r"\ll": "<", r"\gg": "<", r"\le": r"\le", r"\ge": r"\le", r"\ne": r"\ne",
}  # fmt: skip
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
        smaller, larger = (right, left) if sign in (">", r"\gg", r"\ge") else (left, right)
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
