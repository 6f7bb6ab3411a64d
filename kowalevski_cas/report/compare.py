"""Where two formulas differ: what should not stand in the one, what should in the other."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from kowalevski_cas.notation import Formula, Negative, Power, Product, Quotient, Relation, Root, Sum
from kowalevski_cas.notation.brackets import COMPOUND
from kowalevski_cas.notation.formula import Changed

_TAKEN_APART = (Relation, Sum, Negative, Product, Quotient, Root, Power)
"""What is marked in part; a derivative, say, is marked as a whole."""


def mark_differences(
    printed: Sequence[Formula], meant: Sequence[Formula]
) -> tuple[tuple[Formula, ...], tuple[Formula, ...]]:
    r"""Formulas as printed and as they were meant, with marks on what differs.

    >>> from kowalevski_cas.notation import Vocabulary, read
    >>> from kowalevski_cas.notation.mathml import to_mathml
    >>> words = Vocabulary(frozenset({"x", "y"}))
    >>> _, (meant,) = mark_differences([read("2x", words)], [read("2xy", words)])
    >>> to_mathml(meant)
    '<mn>2</mn><mi>x</mi><mrow class="meant"><mi>y</mi></mrow>'
    """
    if len(printed) != len(meant):
        return tuple(printed), tuple(meant)
    pairs = [_mark_differences(old, new, None) for old, new in zip(printed, meant, strict=True)]
    return tuple(old for old, _ in pairs), tuple(new for _, new in pairs)


def without_marks(formula: Formula) -> Formula:
    """The formula without marks."""
    return formula.argument if isinstance(formula, Changed) else formula.map_children(without_marks)


def _mark_differences(
    old: Formula, new: Formula, within: Formula | None
) -> tuple[Formula, Formula]:
    """Both, marked; ``within`` is what the old one stands in."""
    if old == new:
        return old, new
    if isinstance(old, Product) or isinstance(new, Product):
        factors = _factors(old), _factors(new)
        if len(factors[0]) != len(factors[1]) and set(factors[0]) & set(factors[1]):
            return _lone(old, factors[0], factors[1], True), _lone(new, *factors[::-1], False)
    before, after = old.children(), new.children()
    same = len(before) == len(after) and _with(old, after) == new
    if same and isinstance(old, _TAKEN_APART):
        pairs = [_mark_differences(*pair, old) for pair in zip(before, after, strict=True)]
        return _with(old, [a for a, _ in pairs]), _with(new, [b for _, b in pairs])
    bare = not isinstance(within, Sum | Product)  # a sign needs no brackets there
    return _mark(old, True, bare), _mark(new, False, bare)


def _lone(whole: Formula, own: Sequence[Formula], other: Sequence[Formula], wrong: bool) -> Formula:
    """A product with marks on the factors that the other one has not."""
    left = list(other)
    factors = []
    for factor in own:
        if factor in left:
            left.remove(factor)
            factors.append(factor)
        else:
            factors.append(_mark(factor, wrong, bare=False))
    return replace(whole, factors=tuple(factors)) if isinstance(whole, Product) else factors[0]


def _factors(formula: Formula) -> tuple[Formula, ...]:
    return formula.factors if isinstance(formula, Product) else (formula,)


def _mark(formula: Formula, wrong: bool, bare: bool) -> Formula:
    """The formula with a mark, inside of what has a sign or needs brackets where it stands."""
    if isinstance(formula, Negative) and not bare:
        return Negative(_mark(formula.argument, wrong, bare))
    if isinstance(formula, COMPOUND) and not bare:
        return formula.map_children(lambda part: _mark(part, wrong, bare))
    return Changed(formula, wrong, bracket=formula.bracket)


def _with(formula: Formula, children: Sequence[Formula]) -> Formula:
    """The formula with others in the places of its children."""
    following = iter(children)
    return formula.map_children(lambda _: next(following))
