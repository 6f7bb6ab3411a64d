r"""Piecewise linear functions: on each piece every absolute value is a linear function.

A piece is where the signs of what stands between bars are given: there an absolute value r = |L| is
L or −L, and what is known not to be negative, the absolute values and what is supposed, are linear
functions. If one of the signs follows from these, by a combination with coefficients that are not
negative, there is no other piece; else there are two. So :math:`|x+y|\le|x|+|y|` is decided, and
all that maxima and minima obey.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from functools import cached_property
from typing import NamedTuple

from kowalevski_cas.algebra.cones import combination_in_cone
from kowalevski_cas.algebra.present import formula_rows
from kowalevski_cas.algebra.squares import few_squares
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.notation import Number, Power
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.evidence import Proof
from kowalevski_cas.problem.examine import is_real
from kowalevski_cas.problem.space import Adjoined
from kowalevski_cas.search.combinations import complete

LARGEST = 200
"""Into how many pieces a space is cut at most."""

POSITIVE = (Fraction(1), Fraction(1, 100))
"""What a positive function is tried to be larger than."""

Form = tuple[Fraction, ...]
"""The coefficients of a linear function of the generators, and its constant term."""


class TooManyPieces(Exception):
    """The space falls into more pieces than are looked at."""


class Bound(NamedTuple):
    """A linear function that is not negative: it is the square of a root."""

    form: Form
    root: Element
    square: Element


class LinearPiece(NamedTuple):
    """What is known on a piece: elements that vanish, and what the absolute values are there.

    To an absolute value belong the place of what vanishes, the sign, and the linear function.
    """

    known: tuple[Element, ...] = ()
    values: dict[int, tuple[int, int, Form]] = {}  # noqa: RUF012 # it is never changed


def proof_by_pieces(
    goals: Sequence[Element], known: Sequence[Element], at: Evaluation
) -> Proof | None:
    """A proof that linear functions of absolute values vanish; none if it is not seen so.

    Without goals it is one that the known element does not, since it is positive.
    """
    whole = [*goals, *known]
    if (goals and known) or len(whole) > 1 or not is_real(at.setting):
        return None
    found = _Pieces(goals, whole, at)
    try:
        return found.proof(0, LinearPiece((*known,))) if found.order else None
    except TooManyPieces:
        return None


class _Pieces:
    """The absolute values in goals, in the order of the tower, and how they fall into cases."""

    def __init__(self, goals: Sequence[Element], whole: Sequence[Element], at: Evaluation) -> None:
        self.goals, self.whole, self.at, self.ring = goals, whole, at, at.ring
        self.size = len(self.ring.polynomials.generators)
        self.left = LARGEST
        self.order = [bit for bit in sorted(self.moduli) if bit in self._needed]

    @cached_property
    def moduli(self) -> dict[int, Element]:
        """What stands between bars, by the absolute values: linear functions of those before."""
        found = dict[int, Element]()
        for bit, name in enumerate(self.ring.roots):
            step = self.at.setting.step(name)
            match step.square if isinstance(step, Adjoined) else None:
                case Power(base, Number(2)) if name.startswith(r"\sqrt"):
                    inner = self.at.scalar(base)
                    linear = self._coefficients(inner)
                    if linear is not None and linear[1].keys() <= found.keys():
                        found[bit] = inner
        return found

    @cached_property
    def _supposed(self) -> dict[int, Element]:
        """The roots of linear functions of absolute values, with these: they are not negative."""
        squares = enumerate(self.ring.radicands)
        linear = ((bit, square, self._coefficients(square)) for bit, square in squares)
        return {
            bit: square
            for bit, square, found in linear
            if found is not None and found[1].keys() <= self.moduli.keys()
        }

    @cached_property
    def _needed(self) -> set[int]:
        """The absolute values in the goals, in what is supposed, and in one another."""
        alone = [self.ring.generator(self.ring.roots[bit]) for bit in self.moduli]
        supposed = [
            one for one in self._supposed.values() if not any((one - r).is_zero for r in alone)
        ]
        found, waiting = set[int](), [*self.whole, *supposed]
        while waiting:
            masks = waiting.pop().parts
            new = {bit for mask in masks for bit in self.moduli if mask >> bit & 1} - found
            found |= new
            waiting += (self.moduli[bit] for bit in new)
        return found

    def _coefficients(self, element: Element) -> tuple[Form, dict[int, Fraction]] | None:
        """A linear function as one of the generators and of the roots; none of anything else."""
        if element.denominator:
            return None
        form, roots = [Fraction(0)] * (self.size + 1), dict[int, Fraction]()
        for mask, part in element.terms().items():
            for exponents, value in part.items():
                if mask.bit_count() + sum(exponents) > 1:
                    return None
                if mask:
                    roots[mask.bit_length() - 1] = value
                else:
                    form[exponents.index(1) if any(exponents) else self.size] = value
        return (*form,), roots

    def _form(self, element: Element, piece: LinearPiece) -> Form | None:
        """A linear function of the generators on a piece; none if it is not known there."""
        linear = self._coefficients(element)
        if linear is None or not linear[1].keys() <= piece.values.keys():
            return None
        form, roots = linear
        for bit, value in roots.items():
            own = piece.values[bit][2]
            form = tuple(one + value * other for one, other in zip(form, own, strict=True))
        return form

    def _row(self, element: Element, piece: LinearPiece) -> list[Element]:
        """What the known elements are multiplied by, so that without them no root is left."""
        row = [self.ring.zero for _ in piece.known]
        linear = self._coefficients(element)
        roots = dict(linear[1]) if linear else {}
        for bit in sorted(piece.values, reverse=True):
            if value := roots.get(bit):
                place, sign, _ = piece.values[bit]
                row[place] = self.ring.number(value)
                _, inner = self._coefficients(self.moduli[bit]) or ((), {})
                for other, own in inner.items():
                    roots[other] = roots.get(other, Fraction(0)) + sign * value * own
        return row

    def _bounds(self, piece: LinearPiece) -> list[Bound]:
        """What is not negative on a piece, the number 1 among it."""
        one = Bound((*[Fraction(0)] * self.size, Fraction(1)), self.ring.one, self.ring.one)
        forms = ((bit, self._form(square, piece)) for bit, square in self._supposed.items())
        return [one] + [
            Bound(form, self.ring.generator(self.ring.roots[bit]), self._supposed[bit])
            for bit, form in forms
            if form is not None
        ]

    def proof(self, k: int, piece: LinearPiece) -> Proof | None:
        """A proof on a piece, where the absolute values before the place k are linear."""
        if k == len(self.order):
            return self._vanishing(piece) if self.goals else self._positive(piece)
        bit, bounds = self.order[k], self._bounds(piece)
        root = self._root_of(self.ring.generator(self.ring.roots[bit]))
        for sign in (1, -1) if root is not None else ():
            form = self._form(self._signed(bit, sign), piece)
            weights = form and combination_in_cone([bound.form for bound in bounds], form)
            if root is not None and weights is not None:
                return self._forced(k, piece, sign, root, _as_squares(bounds, weights))
        self.left -= 1
        if not self.left:
            raise TooManyPieces
        parts = [self._part(bit, sign, piece, ()) for sign in (1, -1)]
        cases = complete(self.proof(k + 1, part) for part in parts)
        row = [self.ring.zero for _ in piece.known]
        groups = formula_rows([[part.known[-1]] for part in parts])
        return Proof(formula_rows([row]), groups, tuple(cases)) if cases else None

    def _vanishing(self, piece: LinearPiece) -> Proof | None:
        """A proof that the goals vanish where they are linear functions."""
        forms = [self._form(goal, piece) for goal in self.goals]
        if any(form is None or any(form) for form in forms):
            return None
        return Proof(formula_rows([self._row(goal, piece) for goal in self.goals]))

    def _positive(self, piece: LinearPiece) -> Proof | None:
        """A proof that the known element is no zero: it is a sum of squares, one of a number."""
        form, bounds = self._form(piece.known[0], piece), self._bounds(piece)
        if form is None:
            return None
        for least in POSITIVE:
            rest = [*form[:-1], form[-1] - least]
            weights = combination_in_cone([bound.form for bound in bounds], rest)
            if weights is not None:
                break
        else:
            return None
        used = _as_squares(bounds, [weights[0] + least, *weights[1:]])
        group = [bound.root * self.ring.number(part) for bound, part in used]
        total = sum((one * one for one in group), self.ring.zero)
        row = [-entry for entry in self._row(piece.known[0] - total, piece)]
        row[0] = self.ring.one
        last = [self.ring.zero for _ in (*row, *group)]
        last[len(row)] = self.ring.number(1 / used[0][1])
        case = Proof(formula_rows([last]))
        return Proof(formula_rows([row]), formula_rows([group]), (case,), _power(group))

    def _signed(self, bit: int, sign: int) -> Element:
        """What stands between the bars, or its opposite."""
        return self.moduli[bit] * self.ring.number(sign)

    def _part(
        self, bit: int, sign: int, piece: LinearPiece, more: Sequence[Element]
    ) -> LinearPiece:
        """The part of a piece where an absolute value is what stands in it, times the sign."""
        signed = self._signed(bit, sign)
        form = self._form(signed, piece)
        assert form is not None
        zero = self.ring.generator(self.ring.roots[bit]) - signed
        known = (*piece.known, *more, zero)
        return LinearPiece(known, {**piece.values, bit: (len(known) - 1, sign, form)})

    def _root_of(self, modulus: Element) -> Element | None:
        """The root of an absolute value, which says that it is not negative."""
        bits = (bit for bit, square in self._supposed.items() if (square - modulus).is_zero)
        return next((self.ring.generator(self.ring.roots[bit]) for bit in bits), None)

    def _forced(
        self,
        k: int,
        piece: LinearPiece,
        sign: int,
        root: Element,
        used: Sequence[tuple[Bound, Fraction]],
    ) -> Proof | None:
        """A proof where what stands between bars, with the sign, is a sum S of squares.

        Of an absolute value r of S the element u = r − S is zero: u²(r + S) = u(r² − S²) vanishes,
        and is a sum of squares; so ur and uS vanish, and u², which is their difference.
        """
        signed = self._signed(self.order[k], sign)
        u = self.ring.generator(self.ring.roots[self.order[k]]) - signed
        roots = [bound.root * self.ring.number(part) for bound, part in used]
        total = sum((one * one for one in roots), self.ring.zero)
        less = [-u * entry for entry in self._row(signed - total, piece)]
        group = [u * one for one in (root, *roots)]
        inner = self.proof(k + 1, self._part(self.order[k], sign, piece, group))
        if inner is None:
            return None
        last = [*less, root, *(-one for one in roots)]
        step = Proof(formula_rows([last]), formula_rows([[u]]), (inner,), 2)
        row = [u * entry for entry in less]
        return Proof(formula_rows([row]), formula_rows([group]), (step,), _power(group))


def _as_squares(
    bounds: Sequence[Bound], weights: Sequence[Fraction]
) -> list[tuple[Bound, Fraction]]:
    """Bounds with numbers, the squares of which times the bounds add up to a combination."""
    return [
        (bound, part)
        for bound, weight in zip(bounds, weights, strict=True)
        for part in (few_squares(weight) if weight else ())
        if part
    ]


def _power(group: Sequence[Element]) -> int:
    """To which power a group is taken as the sum of its squares: one alone stands for itself."""
    return 2 if len(group) == 1 else 1
