"""A formula as pieces side by side, between which a display can be broken into lines."""

from __future__ import annotations

import unicodedata
from collections.abc import Iterable, Iterator
from functools import cache
from typing import NamedTuple

from kowalevski_cas.notation import (
    Derivative,
    Formula,
    Name,
    Negative,
    Power,
    Product,
    Quotient,
    Relation,
    Root,
    Sum,
    Vector,
    to_plain,
)
from kowalevski_cas.notation.brackets import COMPOUND, SIGNED, is_base
from kowalevski_cas.notation.formula import Changed
from kowalevski_cas.notation.printer import Printer

_BRACKET, _TALL_BRACKET = 0.39, 0.7
_SIGN, _AROUND = 0.78, 0.44
_RELATION = 1.36
_SCRIPT = 0.72
_RATE = 1.4
_ADDED = tuple(kind for kind in SIGNED if kind is not Negative)


class Piece(NamedTuple):
    """A piece of a formula: its source in some format, its width in em, its class.

    ``kind`` is one of ord, sign, relation, open, close. ``inner`` holds the pieces of a
    bracket, with both ends, or of the numerator of a fraction (whose denominator is
    ``below``), so that either can be taken apart where it does not fit on a line.
    """

    text: str
    width: float
    kind: str = "ord"
    inner: tuple[Piece, ...] = ()
    below: tuple[Piece, ...] = ()
    tall: bool = False


def pieces(formula: Formula, printer: Printer) -> tuple[Piece, ...]:
    """The pieces of a formula, printed by the printer of a format."""
    return tuple(_pieces(formula, printer))


def _pieces(formula: Formula, printer: Printer) -> Iterator[Piece]:
    match formula:
        case Relation():
            yield from _chain(formula, printer)
        case Sum(terms):
            for k, term in enumerate(terms):
                if not k:
                    yield from _within(term, _ADDED, printer)
                    continue
                sign, inner = printer.signed(term)
                yield Piece(sign, _SIGN + _AROUND, "sign")
                yield from _within(inner, _ADDED if inner is term else SIGNED, printer)
        case Negative(argument):
            yield Piece(printer.minus, _SIGN + _AROUND, "sign")
            yield from _within(argument, SIGNED, printer)
        case Product(factors):
            for k, factor in enumerate(factors):
                first, *others = _within(factor, COMPOUND, printer)
                if k and (between := printer.separator(factors[k - 1], factor, first.text)):
                    first = first._replace(text=between + first.text)
                yield first
                yield from others
        case Derivative():
            yield from _rate(formula, printer)
        case _:
            yield _piece(formula, printer)


def _chain(relation: Relation, printer: Printer) -> Iterator[Piece]:
    for sign, member in zip((None, *relation.signs), relation.members, strict=True):
        if sign is not None:
            yield Piece(printer.sign(sign), _RELATION, "relation")
        yield from _pieces(member, printer)


def _rate(formula: Derivative, printer: Printer) -> Iterator[Piece]:
    """A derivative; one of a sum as what differentiates and a bracket."""
    if formula.mark in ("dot", "prime") or not isinstance(formula.argument, COMPOUND):
        yield _piece(formula, printer)
        return
    below = printer.side_by_side([printer.d, printer(Name(formula.mark))])
    yield Piece(printer.fraction(printer.d, below), _RATE, tall=True)
    yield _bracket(formula.argument, printer)


def _piece(formula: Formula, printer: Printer) -> Piece:
    """A formula that is one piece, though perhaps one with inner ones."""
    match formula:
        case Power(base, exponent) if not is_base(base):
            bracket, high = _bracket(base, printer), pieces(exponent, printer)
            text, (*inner, closing) = source_of(high, printer), bracket.inner
            closing = closing._replace(text=printer.superscript(closing.text, text))
            whole = printer.superscript(bracket.text, text)
            return _pair((*inner, closing), whole, _SCRIPT * width_of(high))
        case Quotient(above, below):
            over, under = pieces(above, printer), pieces(below, printer)
            width = max(width_of(over), width_of(under)) + 0.24
            return Piece(printer(formula), width, inner=over, below=under, tall=True)
        case Vector(rows) if all(isinstance(row, Vector) for row in rows):
            columns = zip(*(row.components for row in rows if isinstance(row, Vector)), strict=True)
            wide = (max(width_of(pieces(cell, printer)) for cell in cells) for cells in columns)
            return Piece(printer(formula), sum(wide) + len(rows) + 0.8, tall=True)
        case Changed(argument):
            return _piece(argument, printer)._replace(text=printer(formula), inner=(), below=())
        case Root(argument):
            inside = pieces(argument, printer)
            tall = any(piece.tall for piece in inside)
            return Piece(printer(formula), width_of(inside) + 0.9, tall=tall)
    return Piece(printer(formula), sum(map(_letter, to_plain(formula))))


def _within(
    formula: Formula, compound: tuple[type[Formula], ...], printer: Printer
) -> Iterator[Piece]:
    """The pieces of a part, in brackets where it needs them."""
    if isinstance(formula, compound):
        yield _bracket(formula, printer)
    else:
        yield from _pieces(formula, printer)


def _bracket(formula: Formula, printer: Printer) -> Piece:
    inner = pieces(formula, printer)
    text = source_of(inner, printer)
    opening, closing = printer.brackets(text, formula.bracket)
    ends = Piece(opening, _BRACKET, "open"), Piece(closing, _BRACKET, "close")
    return _pair((ends[0], *inner, ends[1]), printer.between(opening, text, closing))


def _pair(inner: tuple[Piece, ...], text: str, more: float = 0.0) -> Piece:
    tall = any(piece.tall for piece in inner)
    width = width_of(inner) + (2 * (_TALL_BRACKET - _BRACKET) if tall else 0) + more
    return Piece(text, width, inner=inner, tall=tall)


def source_of(side_by_side: Iterable[Piece], printer: Printer) -> str:
    """The source of pieces side by side."""
    text, before = "", "open"
    for piece in side_by_side:
        if piece.kind == "relation" or (piece.kind == "sign" and before in ("ord", "close")):
            text += f" {piece.text} "
        elif before in ("ord", "close"):
            text = printer.side_by_side([text, piece.text])
        else:
            text += printer.prefix(piece.text) if piece.kind == "sign" else piece.text
        before = piece.kind
    return text.strip()


def width_of(side_by_side: Iterable[Piece]) -> float:
    """The width of pieces side by side, in em; a sign with nothing before it is narrower."""
    total, before = 0.0, "open"
    for piece in side_by_side:
        alone = piece.kind == "sign" and before not in ("ord", "close")
        total += piece.width - (_AROUND if alone else 0.0)
        before = piece.kind
    return total


@cache
def _letter(letter: str) -> float:
    """The width of a letter of plain text that is set as a formula, in em."""
    if unicodedata.combining(letter):
        return 0.0
    if unicodedata.decomposition(letter).startswith(("<sub>", "<super>")):
        return 0.42
    if letter in "mwMW":
        return 0.9
    if letter in "()[]{},′ /":
        return 0.35
    return 0.8 if letter.isupper() or letter in "=+−×≡≠" else 0.58
