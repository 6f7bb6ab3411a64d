"""Where two formulas differ: what should not stand in the one, what should in the other."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import replace

from kowalevski_cas.notation import (
    Formula,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Relation,
    Root,
    Sum,
    power,
    times,
)
from kowalevski_cas.notation.brackets import COMPOUND
from kowalevski_cas.notation.formula import Changed

_TAKEN_APART = (Relation, Sum, Negative, Product, Quotient, Root, Power)
"""What is marked in part; a derivative, say, is marked as a whole."""

_FEW = 3
"""How many factors a ratio has at most."""

_MINUS = Negative(Number(1))


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


def ratio_of_sides(printed: Sequence[Formula], meant: Sequence[Formula]) -> Formula | None:
    r"""What the left side of a misprinted equation is of its right one, if the other one is true.

    Nothing, where that takes more than a few factors.

    >>> from kowalevski_cas.notation import Vocabulary, read, to_latex
    >>> words = Vocabulary(frozenset({"u", "v", "x", "y"}))
    >>> wrong = read(r"u=\frac{1}{\sqrt{xy}}(v+1)", words)
    >>> right = read(r"u=\sqrt{xy}(v+1)", words)
    >>> to_latex(ratio_of_sides([wrong], [right]))
    'xy'
    """
    match (*printed, *meant):
        case (Relation((left, wrong), ("=",)), Relation((other, right), ("=",))):
            powers = Counter[Formula]()
            for formula, exponent in ((left, 1), (wrong, -1), (other, -1), (right, 1)):
                _add_powers(powers, formula, exponent)
            return _product_of_powers(powers)
    return None


def _add_powers(powers: Counter[Formula], formula: Formula, exponent: int) -> None:
    """Count the factors of a formula; a root is one, since it is either of two."""
    match formula:
        case Product(factors):
            for factor in factors:
                _add_powers(powers, factor, exponent)
        case Quotient(above, below):
            _add_powers(powers, above, exponent)
            _add_powers(powers, below, -exponent)
        case Negative(argument):
            powers[_MINUS] += exponent
            _add_powers(powers, argument, exponent)
        case Power(base, Number(value)):
            _add_powers(powers, base, exponent * value)
        case Number(1):
            pass
        case _:
            powers[formula] += exponent


def _product_of_powers(powers: Counter[Formula]) -> Formula | None:
    """The product, unless it is long, or one."""
    for root in [factor for factor in powers if isinstance(factor, Root)]:
        half, powers[root] = divmod(powers[root], 2)
        _add_powers(powers, root.argument, half)
    negative = powers.pop(_MINUS, 0) % 2
    above, below = (
        [power(factor, sign * many) for factor, many in powers.items() if sign * many > 0]
        for sign in (1, -1)
    )
    factors = [*above, *below]
    long = len(factors) > _FEW or any(isinstance(node, Sum) for f in factors for node in f.nodes())
    if long or not (factors or negative):
        return None
    found = Quotient(times(*above), times(*below)) if below else times(*above)
    return Negative(found) if negative else found


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
        pairs = [
            (k and isinstance(old, Sum) and _sign(*pair)) or _mark_differences(*pair, old)
            for k, pair in enumerate(zip(before, after, strict=True))
        ]
        return _with(old, [a for a, _ in pairs]), _with(new, [b for _, b in pairs])
    bare = not isinstance(within, Sum | Product)  # a sign needs no brackets there
    return _mark(old, True, bare), _mark(new, False, bare)


def _sign(old: Formula, new: Formula) -> tuple[Formula, Formula] | None:
    """Terms of sums that differ by their sign, with a mark on it."""
    if Negative(old) == new or Negative(new) == old:
        return Changed(old, True, sign=True), Changed(new, False, sign=True)
    return None


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
