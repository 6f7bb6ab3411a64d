"""The slips of the pen that one change of a formula can undo."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from kowalevski_cas.notation.errors import closeness, letter_and_index
from kowalevski_cas.notation.formula import (
    Conjugate,
    Constant,
    Formula,
    ImaginaryPart,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    RealPart,
    Relation,
    Root,
    Sum,
    Unwritten,
    times,
)
from kowalevski_cas.notation.latex import to_latex
from kowalevski_cas.notation.values import rank
from kowalevski_cas.notation.vocabulary import SCALAR, Vocabulary

Path = tuple[int, ...]
ONE, TWO = Number(1), Number(2)
HALF = Quotient(ONE, TWO)
# Where a factor may be missing: it would stand for the whole child of these nodes.
_WHOLE = (Relation, Sum, Negative, Quotient, Root, RealPart, ImaginaryPart, Conjugate)


@dataclass(frozen=True)
class Misprint:
    """A new subtree for one place, and what was changed."""

    kind: str
    path: Path
    replacement: Formula
    words: str


@dataclass(frozen=True)
class _Place:
    """A node, the way to it, what it stands in, and whether it is part of an exponent."""

    path: Path
    node: Formula
    parent: Formula | None
    raised: bool


def misprints(
    formula: Formula, vocabulary: Vocabulary, offered: Iterable[str]
) -> Iterator[Misprint]:
    """Every slip in one place, the likelier kinds first; new names are among those offered."""
    places = list(_places(formula))
    names = sorted(offered)
    present = {place.node.name for place in places if isinstance(place.node, Name)}
    names.sort(key=lambda name: name not in present)
    for place in places:
        yield from _signs(place)
    for kind in ("index", "letter"):
        for place in places:
            yield from _names(place, kind, names, vocabulary)
    for place in places:
        yield from _exponents(place, vocabulary)
    for place in places:
        yield from _coefficients(place)
    for place in places:
        yield from _factors(place, vocabulary)
    for place in places:
        yield from _moves(place, vocabulary)
    for place in places:
        yield from _missing(place, names, vocabulary)


def _places(formula: Formula) -> Iterator[_Place]:
    """All nodes, a parent before its children, from left to right."""
    waiting = [_Place((), formula, None, False)]
    while waiting:
        place = waiting.pop()
        yield place
        below = [
            _Place(
                (*place.path, index),
                child,
                place.node,
                place.raised or (isinstance(place.node, Power) and index == 1),
            )
            for index, child in enumerate(place.node.children())
        ]
        waiting.extend(reversed(below))


def _printed(formula: Formula) -> bool:
    """Whether the formula is more than a zero, a word or an ellipsis."""
    return formula != Number(0) and not isinstance(formula, Constant | Unwritten | Relation)


def _term(place: _Place) -> bool:
    """Whether the node is a term with a sign of its own, or a side of a relation."""
    node = place.node
    whole = place.parent is None or isinstance(place.parent, Relation | Sum | Negative)
    return whole and _printed(node) and not isinstance(node, Negative)


def _factors_of(node: Formula) -> tuple[Formula, ...]:
    return node.factors if isinstance(node, Product) else (node,)


def _signs(place: _Place) -> Iterator[Misprint]:
    node = place.node
    if isinstance(node, Negative):
        words = _sign_of(node.argument)
        yield Misprint("sign", place.path, node.argument, words)
    elif _term(place) and not isinstance(place.parent, Negative):
        if isinstance(place.parent, Sum) or not isinstance(node, Sum):
            words = _sign_of(node)
            yield Misprint("sign", place.path, Negative(node), words)


def _sign_of(node: Formula) -> str:
    """The words for a change of sign."""
    tex = to_latex(node)
    return (
        f"for ${tex}$ read $-{tex}$" if isinstance(node, Number) else f"change the sign of ${tex}$"
    )


def _names(
    place: _Place, kind: str, names: list[str], vocabulary: Vocabulary
) -> Iterator[Misprint]:
    node = place.node
    if not isinstance(node, Name) or node.name not in vocabulary.scalars:
        return
    letter = letter_and_index(node.name)[0]
    same = [n for n in names if n != node.name and (letter_and_index(n)[0] == letter)]
    others = same if kind == "index" else [n for n in names if n != node.name and n not in same]
    known = node.name in names or node.name in vocabulary.times
    wrong = f"${node.name}$" if known else f"${node.name}$, which is not defined,"
    for other in sorted(others, key=lambda name: -closeness(node.name, name)):
        yield Misprint(kind, place.path, Name(other), f"for {wrong} read ${other}$")


def _exponents(place: _Place, vocabulary: Vocabulary) -> Iterator[Misprint]:
    node, words = place.node, to_latex(place.node)
    if isinstance(node, Number) and place.raised:
        # A power of one is not printed, and nothing is divided by zero.
        lowest = 2 if isinstance(place.parent, Power) else isinstance(place.parent, Quotient)
        if node.value > lowest:
            for value in dict.fromkeys((node.value - 1, max(node.value // 2, int(lowest)))):
                yield Misprint(
                    "exponent", place.path, Number(value), f"for ${words}$ read ${value}$"
                )
        higher = Number(node.value + 1)
        yield Misprint("exponent", place.path, higher, f"for ${words}$ read ${higher.value}$")
    elif isinstance(node, Power) and node.exponent == TWO:
        said = f"for ${words}$ read ${to_latex(node.base)}$"
        yield Misprint("exponent", place.path, node.base, said)
    elif isinstance(node, Name) and not isinstance(place.parent, Power):
        if rank(node, vocabulary) == SCALAR:
            square = Power(node, TWO)
            said = f"for ${words}$ read ${to_latex(square)}$"
            yield Misprint("exponent", place.path, square, said)


def _coefficients(place: _Place) -> Iterator[Misprint]:
    node = place.node
    if isinstance(node, Number) and not place.raised and node.value:
        value = node.value
        others: list[Formula] = [Number(value + 1), Number(2 * value)]
        others += [Number(value - 1), ONE] if value > 1 else []
        others += [Number(0)] if isinstance(place.parent, Relation) else []
        if value % 2 == 0:
            others.append(Number(value // 2))
        elif not isinstance(place.parent, Quotient):
            others.append(Quotient(node, TWO))
        for other in dict.fromkeys(others):
            # A factor of one is a factor that is not written.
            if other != node and not (other == ONE and isinstance(place.parent, Product)):
                words = f"for ${value}$ read ${to_latex(other)}$"
                yield Misprint("coefficient", place.path, other, words)
    elif _term(place) and not isinstance(node, Sum | Number):
        factors = _factors_of(node)
        if not isinstance(factors[0], Number):
            for number in (TWO, HALF):
                words = f"insert ${to_latex(number)}$ before ${to_latex(node)}$"
                yield Misprint("coefficient", place.path, times(number, *factors), words)


def _factors(place: _Place, vocabulary: Vocabulary) -> Iterator[Misprint]:
    if isinstance(place.node, Product):
        whole = rank(place.node, vocabulary)
        factors = place.node.factors
        for index, factor in enumerate(factors):
            rest = times(*factors[:index], *factors[index + 1 :])
            words = f"omit ${to_latex(factor)}$ in ${to_latex(place.node)}$"
            if rank(rest, vocabulary) == whole:
                yield Misprint("factor", place.path, rest, words)


def _missing(place: _Place, names: list[str], vocabulary: Vocabulary) -> Iterator[Misprint]:
    node = place.node
    if place.raised or not (place.parent is None or isinstance(place.parent, _WHOLE)):
        return
    # What multiplies a quotient multiplies its numerator.
    if not _printed(node) or isinstance(node, Negative | Quotient):
        return
    if rank(node, vocabulary) != SCALAR:
        return
    for name in names:
        words = f"insert the factor ${name}$ in ${to_latex(node)}$"
        factors = _factors_of(node)
        behind = all(isinstance(factor, Name | Number | Power) for factor in factors)
        first = 0 if behind or not isinstance(factors[0], Number) else 1
        if behind:
            first = len(factors)
        with_name = (*factors[:first], Name(name), *factors[first:])
        yield Misprint("missing", place.path, times(*with_name), words)


def _moves(place: _Place, vocabulary: Vocabulary) -> Iterator[Misprint]:
    """A factor of the denominator in the numerator, or the other way round."""
    node = place.node
    if isinstance(node, Quotient):
        above, below = _factors_of(node.numerator), _factors_of(node.denominator)
        for index, factor in enumerate(below):
            rest = times(*below[:index], *below[index + 1 :])
            up = times(*above, factor)
            moved = up if rest == ONE else Quotient(up, rest)
            words = f"move ${to_latex(factor)}$ from the denominator to the numerator"
            yield Misprint("power", place.path, moved, words)
        for index, factor in enumerate(above):
            if factor != ONE and rank(factor, vocabulary) == SCALAR:
                rest = times(*above[:index], *above[index + 1 :])
                moved = Quotient(rest, times(*below, factor))
                words = f"move ${to_latex(factor)}$ from the numerator to the denominator"
                yield Misprint("power", place.path, moved, words)
    elif isinstance(node, Product) and not isinstance(place.parent, Quotient):
        for index, factor in enumerate(node.factors):
            if not isinstance(factor, Number | Quotient) and rank(factor, vocabulary) == SCALAR:
                moved = Quotient(ONE, factor)
                words = f"move ${to_latex(factor)}$ from the numerator to the denominator"
                yield Misprint("power", (*place.path, index), moved, words)
