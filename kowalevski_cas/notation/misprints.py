"""The slips of the pen that one change of a formula can undo."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import partial
from itertools import combinations
from typing import NamedTuple, TypeGuard

from kowalevski_cas.notation.errors import closeness
from kowalevski_cas.notation.formula import (
    Application,
    Conjugate,
    Constant,
    Derivative,
    Formula,
    ImaginaryPart,
    Modulus,
    Name,
    Negative,
    Number,
    Partial,
    Power,
    Product,
    Quotient,
    RealPart,
    Relation,
    Root,
    Sum,
    Unwritten,
    Vector,
    times,
)
from kowalevski_cas.notation.latex import to_latex
from kowalevski_cas.notation.symbol import symbol
from kowalevski_cas.notation.values import rank
from kowalevski_cas.notation.vocabulary import SCALAR, Vocabulary

Path = tuple[int, ...]
ONE, TWO = Number(1), Number(2)
HALF = Quotient(ONE, TWO)
# Where a factor may be missing: it would stand for the whole child of these nodes.
_WHOLE = (Relation, Sum, Negative, Quotient, Root, RealPart, ImaginaryPart, Conjugate)


_SQUARED = (Name, Derivative, Modulus, Application)
"""Of what the square may be meant."""

Misprint = tuple[str, Path, Formula, str]
"""Its kind, a place, the subtree that should stand there, and the words for it."""


class _NodePlace(NamedTuple):
    """A node, the way to it, what it stands in, and whether it is part of an exponent."""

    path: Path
    node: Formula
    parent: Formula | None
    raised: bool


def misprints(
    formula: Formula, vocabulary: Vocabulary, offered: Iterable[str], wanted: Formula | None = None
) -> Iterator[Misprint]:
    """Every slip in one place, the likelier kinds first; new names are among those offered.

    If a formula is ``wanted``, only places are looked at where a change can lead to it.
    """
    places = list(_places(formula, wanted))
    names = sorted(offered)
    present = {place.node.name for place in places if isinstance(place.node, Name)}
    names.sort(key=lambda name: name not in present)
    for slips in (
        _signs,
        partial(_names, "index", names, vocabulary),
        partial(_names, "letter", names, vocabulary),
        _functions,
        partial(_dots, {node.mark for node in formula.nodes() if isinstance(node, Derivative)}),
        partial(_exponents, vocabulary),
        _fractions,
        _coefficients,
        partial(_factors, vocabulary),
        partial(_moves, vocabulary),
        partial(_partials, names, vocabulary),
        partial(_terms, names, vocabulary),
        partial(_additions, names, vocabulary),
        partial(_rates, _rates_of(formula), vocabulary),
        partial(_exchanges, vocabulary),
    ):
        for place in places:
            yield from slips(place)


def only_change(before: Formula, after: Formula) -> int | None:
    """The place of the one child in which two nodes differ; ``None`` if they differ elsewhere."""
    old, new = before.children(), after.children()
    if type(before) is not type(after) or len(old) != len(new):
        return None
    different = [
        k for k, (formula, other) in enumerate(zip(old, new, strict=True)) if formula != other
    ]
    return different[0] if len(different) == 1 else None


def _places(formula: Formula, wanted: Formula | None) -> Iterator[_NodePlace]:
    """All nodes, or those on the way to the one that is changed, from left to right.

    A parent comes before its children.
    """
    waiting = [(_NodePlace((), formula, None, False), wanted)]
    while waiting:
        place, other = waiting.pop()
        yield place
        changed = None if other is None else only_change(place.node, other)
        for index, child in reversed([*enumerate(place.node.children())]):
            if other is None or index == changed:
                raised = place.raised or (isinstance(place.node, Power) and index == 1)
                below = None if other is None else other.children()[index]
                waiting.append((_NodePlace((*place.path, index), child, place.node, raised), below))


def _prints(formula: Formula) -> bool:
    """Whether the formula is more than a zero, a word or an ellipsis."""
    return formula != Number(0) and not isinstance(formula, Constant | Unwritten | Relation)


def _term(place: _NodePlace) -> bool:
    """Whether the node is a term with a sign of its own, a component, or a side of a relation."""
    node = place.node
    whole = place.parent is None or isinstance(place.parent, Relation | Sum | Negative | Vector)
    whole = whole and not (isinstance(place.parent, Vector) and isinstance(node, Vector))
    return whole and _prints(node) and not isinstance(node, Negative)


def factors_of(node: Formula) -> tuple[Formula, ...]:
    """The factors of a product; of anything else, itself."""
    return node.factors if isinstance(node, Product) else (node,)


def _signs(place: _NodePlace) -> Iterator[Misprint]:
    node = place.node
    if isinstance(node, Negative):
        yield "sign", place.path, node.argument, _sign_of(node.argument)
    elif isinstance(place.parent, Application) and place.parent.function == r"\exp":
        yield "sign", place.path, Negative(node), _sign_of(node)
    elif _term(place) and not isinstance(place.parent, Negative):
        if isinstance(place.parent, Sum) or not isinstance(node, Sum):
            yield "sign", place.path, Negative(node), _sign_of(node)


def _sign_of(node: Formula) -> str:
    """The words for a change of sign."""
    if isinstance(node, Number):
        return _read(node, Negative(node))
    return f"change the sign of ${to_latex(node)}$"


def _read(node: Formula, other: Formula) -> str:
    """The words for one formula in the place of another."""
    return f"for ${to_latex(node)}$ read ${to_latex(other)}$"


def _names(
    kind: str, names: list[str], vocabulary: Vocabulary, place: _NodePlace
) -> Iterator[Misprint]:
    node = place.node
    if not isinstance(node, Name) or node.name not in vocabulary.scalars | vocabulary.vectors:
        return
    names = names if node.name in vocabulary.scalars else sorted(vocabulary.vectors)
    head = symbol(node.name).head
    same = [n for n in names if n != node.name and symbol(n).head == head]
    others = same if kind == "index" else [n for n in names if n != node.name and n not in same]
    known = node.name in names or node.name in vocabulary.times
    wrong = (
        f"${node.name}$" if known else f"${node.name}$, which is not defined and may be anything,"
    )
    for other in sorted(others, key=lambda name: -closeness(node.name, name)):
        yield kind, place.path, Name(other), f"for {wrong} read ${other}$"


def _dots(marks: set[str], place: _NodePlace) -> Iterator[Misprint]:
    """A derivative more, or one less, where others stand."""
    node = place.node
    if isinstance(node, Derivative) and isinstance(node.argument, Name | Derivative):
        yield "letter", place.path, node.argument, _read(node, node.argument)
    if isinstance(node, Name | Derivative) and not isinstance(place.parent, Derivative):
        for mark in sorted(marks):
            other = Derivative(node, mark)
            yield "letter", place.path, other, _read(node, other)


_PAIRS = ((r"\sin", r"\cos"), (r"\sinh", r"\cosh"), (r"\sin", r"\tan"), (r"\cosh", r"\tanh"))


def _functions(place: _NodePlace) -> Iterator[Misprint]:
    """The sine for the cosine, and the like."""
    node = place.node
    if isinstance(node, Application):
        for pair in (both for both in _PAIRS if node.function in both):
            other = Application(pair[pair[0] == node.function], node.arguments)
            yield "letter", place.path, other, _read(node, other)


def _exponents(vocabulary: Vocabulary, place: _NodePlace) -> Iterator[Misprint]:
    node, others = place.node, list[Formula]()
    if isinstance(node, Number) and place.raised:
        # A power of one is not printed, and nothing is divided by zero.
        lowest = 2 if isinstance(place.parent, Power) else isinstance(place.parent, Quotient)
        if node.value > lowest:
            others += [Number(node.value - 1), Number(max(node.value // 2, int(lowest)))]
        others.append(Number(node.value + 1))
    elif isinstance(node, Power) and node.exponent == TWO:
        others.append(node.base)
    elif isinstance(node, _SQUARED) and not isinstance(place.parent, Power | Derivative):
        others += [Power(node, TWO)] if rank(node, vocabulary) == SCALAR else []
    for other in dict.fromkeys(others):
        yield "exponent", place.path, other, _read(node, other)


def _coefficients(place: _NodePlace) -> Iterator[Misprint]:
    node = place.node
    if _is_fraction(place.parent):
        return  # it is changed as a whole
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
                yield "coefficient", place.path, other, _read(node, other)
    elif _term(place) and not isinstance(node, Sum | Number):
        factors = factors_of(node)
        if not isinstance(factors[0], Number) and not _is_fraction(factors[0]):
            yield from _new_coefficients(place.path, node)


def _new_coefficients(path: Path, node: Formula) -> Iterator[Misprint]:
    """Twice a term that has no coefficient, and half of it, also with the number below."""
    for number in (TWO, HALF):
        words = f"insert ${to_latex(number)}$ before ${to_latex(node)}$"
        yield "coefficient", path, times(number, *factors_of(node)), words
    if isinstance(node, Quotient) and not isinstance(node.denominator, Number):
        below = Quotient(node.numerator, times(TWO, *factors_of(node.denominator)))
        yield "coefficient", path, below, _read(node, below)


def _is_fraction(node: Formula | None) -> TypeGuard[Quotient]:
    """Whether a node is a quotient of numbers."""
    return isinstance(node, Quotient) and all(isinstance(n, Number) for n in node.children())


def _fractions(place: _NodePlace) -> Iterator[Misprint]:
    """Another fraction where one stands: half or twice of it, and those with the next numbers."""
    if not _is_fraction(node := place.node):
        return
    above, below = (n.value for n in node.children() if isinstance(n, Number))
    twice = (above, below // 2) if below % 2 == 0 else (2 * above, below)
    pairs = [(above, 2 * below), twice, (1, below), (above, below + 1), (above, below - 1)]
    for numerator, denominator in (*pairs, (above + 1, below), (above - 1, below)):
        if numerator > 0 and denominator > 0 and numerator != denominator:
            whole = Number(numerator)
            other = whole if denominator == 1 else Quotient(whole, Number(denominator))
            if other != node:
                yield "coefficient", place.path, other, _read(node, other)


def _factors(vocabulary: Vocabulary, place: _NodePlace) -> Iterator[Misprint]:
    if isinstance(place.node, Product):
        whole = rank(place.node, vocabulary)
        factors = place.node.factors
        for index, factor in enumerate(factors):
            rest = times(*factors[:index], *factors[index + 1 :])
            words = f"omit ${to_latex(factor)}$ in ${to_latex(place.node)}$"
            if rank(rest, vocabulary) == whole:
                yield "factor", place.path, rest, words


def _additions(names: list[str], vocabulary: Vocabulary, place: _NodePlace) -> Iterator[Misprint]:
    node = place.node
    if isinstance(node, Power) and isinstance(node.base, Name) and not place.raised:
        for name in names:
            raised = times(node.base, Power(Name(name), node.exponent))
            yield "missing", place.path, raised, _read(node, raised)
    if place.raised or not (place.parent is None or isinstance(place.parent, _WHOLE)):
        return
    # What multiplies a quotient multiplies its numerator.
    if not _prints(node) or isinstance(node, Negative | Quotient):
        return
    factors = factors_of(node)
    if all(isinstance(factor, Name | Number | Power) for factor in factors):
        first = sum(rank(factor, vocabulary) == SCALAR for factor in factors)
    else:
        first = int(isinstance(factors[0], Number) or _is_fraction(factors[0]))
    tex = to_latex(node)
    for name in names:
        alike = [k for k, one in enumerate(factors, 1) if _has_letter(one, symbol(name).head)]
        at = max(alike, default=first)
        words = f"insert the factor ${name}$ in ${tex}$"
        yield "missing", place.path, times(*factors[:at], Name(name), *factors[at:]), words


def _rates_of(formula: Formula) -> list[Formula]:
    """The rates of numbers that stand in a formula, as a list without repetition."""
    nodes = (node for node in formula.nodes() if isinstance(node, Derivative))
    return [*dict.fromkeys(node for node in nodes if isinstance(node.argument, Name))]


def _rates(rates: list[Formula], vocabulary: Vocabulary, place: _NodePlace) -> Iterator[Misprint]:
    """A rate that stands elsewhere in the formula: it may be missing as a factor of a term."""
    node = place.node
    if isinstance(place.parent, Sum | Negative) and isinstance(node, Product | Name):
        factors = factors_of(node)
        first = sum(rank(factor, vocabulary) == SCALAR for factor in factors)
        for rate in rates:
            if rate not in factors and rank(rate, vocabulary) == SCALAR:
                words = f"insert the factor ${to_latex(rate)}$ in ${to_latex(node)}$"
                yield "missing", place.path, times(*factors[:first], rate, *factors[first:]), words


def _has_letter(factor: Formula, letter: str) -> bool:
    """Whether a factor is a name with a letter, perhaps with another index."""
    return isinstance(factor, Name) and symbol(factor.name).head == letter


def _partials(names: list[str], vocabulary: Vocabulary, place: _NodePlace) -> Iterator[Misprint]:
    """Another name by which something is derived, or a derivative by it more, or one less."""
    node = place.node
    if isinstance(node, Partial):
        if isinstance(node.argument, Partial) and node.argument.by == node.by:
            yield "letter", place.path, node.argument, _read(node, node.argument)
        if not isinstance(place.parent, Partial) or place.parent.by != node.by:
            more = Partial(node, node.by)
            yield "letter", place.path, more, _read(node, more)
        for name in names:
            if name != node.by and vocabulary.rank(name) == vocabulary.rank(node.by):
                words = f"for the derivative by ${node.by}$ read that by ${name}$"
                yield "letter", place.path, Partial(node.argument, name), words


def _terms(names: list[str], vocabulary: Vocabulary, place: _NodePlace) -> Iterator[Misprint]:
    """A name before a minus with which a bracket begins: it may be missing there."""
    node = place.node
    if isinstance(node, Negative) and isinstance(place.parent, Product | Power):
        if rank(node, vocabulary) == SCALAR:
            for name in names:
                words = f"insert ${name}$ before ${to_latex(node)}$"
                yield "missing", place.path, Sum((Name(name), node)), words


def _exchanges(vocabulary: Vocabulary, place: _NodePlace) -> Iterator[Misprint]:
    """Two names, or the sine and the cosine, each in the place of the other in a whole member.

    Where that puts terms, or factors, into another order only, nothing is exchanged.
    """
    node = place.node
    if isinstance(node, Relation) or not isinstance(place.parent, Relation | None):
        return
    nodes = dict.fromkeys(node.nodes())
    names = [node.name for node in nodes if isinstance(node, Name)]
    functions = {node.function for node in nodes if isinstance(node, Application)}
    for pair in (*combinations(names, 2), *(both for both in _PAIRS if functions.issuperset(both))):
        swapped = _swap(node, pair)
        if _in_order(swapped, vocabulary) != _in_order(node, vocabulary):
            yield "exchange", place.path, swapped, f"exchange ${pair[0]}$ and ${pair[1]}$"


def _in_order(formula: Formula, vocabulary: Vocabulary) -> Formula:
    """A formula with the terms of sums, and factors that are numbers, in one order."""
    ordered = formula.map_children(partial(_in_order, vocabulary=vocabulary))
    if isinstance(ordered, Sum):
        return Sum(tuple(sorted(ordered.terms, key=repr)))
    if isinstance(ordered, Product) and all(
        rank(one, vocabulary) == SCALAR for one in ordered.factors
    ):
        return Product(tuple(sorted(ordered.factors, key=repr)))
    return ordered


def _swap(formula: Formula, pair: tuple[str, str]) -> Formula:
    """A formula with two names, or two functions, in each other's place."""
    if isinstance(formula, Name) and formula.name in pair:
        return Name(pair[pair[0] == formula.name])
    changed = formula.map_children(lambda child: _swap(child, pair))
    if isinstance(changed, Application) and changed.function in pair:
        return Application(pair[pair[0] == changed.function], changed.arguments)
    return changed


def _moves(vocabulary: Vocabulary, place: _NodePlace) -> Iterator[Misprint]:
    """A factor of the denominator in the numerator, or the other way round."""
    node = place.node
    if isinstance(node, Quotient):
        above, below = factors_of(node.numerator), factors_of(node.denominator)
        for index, factor in enumerate(below):
            rest = times(*below[:index], *below[index + 1 :])
            up = times(*above, factor)
            moved = up if rest == ONE else Quotient(up, rest)
            words = f"move ${to_latex(factor)}$ from the denominator to the numerator"
            yield "power", place.path, moved, words
        for index, factor in enumerate(above):
            if factor != ONE and rank(factor, vocabulary) == SCALAR:
                rest = times(*above[:index], *above[index + 1 :])
                moved = Quotient(rest, times(*below, factor))
                words = f"move ${to_latex(factor)}$ from the numerator to the denominator"
                yield "power", place.path, moved, words
        if node.numerator != ONE and not _is_fraction(node):
            other = Quotient(node.denominator, node.numerator)
            yield "power", place.path, other, _read(node, other)
    elif isinstance(node, Product) and not isinstance(place.parent, Quotient):
        for index, factor in enumerate(node.factors):
            if not isinstance(factor, Number | Quotient) and rank(factor, vocabulary) == SCALAR:
                moved = Quotient(ONE, factor)
                words = f"move ${to_latex(factor)}$ from the numerator to the denominator"
                yield "power", (*place.path, index), moved, words
