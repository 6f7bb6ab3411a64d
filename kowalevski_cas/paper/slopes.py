"""Derivatives of functions in print, by a name in their arguments."""

from __future__ import annotations

from kowalevski_cas.notation import (
    Application,
    Formula,
    Name,
    Number,
    Product,
    Vocabulary,
    read,
    substitute,
    to_latex,
)
from kowalevski_cas.notation.functions import DERIVATIVE_OF, FUNCTIONS
from kowalevski_cas.paper.differentiate import derivative
from kowalevski_cas.problem.space import Meaningless

_SLOPES = {
    r"\sin": r"\cos x",
    r"\cos": r"-\sin x",
    r"\tan": r"\frac{1}{\cos^2x}",
    r"\cot": r"-\frac{1}{\sin^2x}",
    r"\exp": r"\exp x",
    r"\sinh": r"\cosh x",
    r"\cosh": r"\sinh x",
    r"\tanh": r"\frac{1}{\cosh^2x}",
    **DERIVATIVE_OF,
}
"""The derivatives of functions by their argument x, in print."""
_AT_X = Vocabulary(frozenset("x"), functions=FUNCTIONS)


def derived(formula: Formula, by: str, order: int = 1) -> Formula:
    r"""A derivative of a formula with functions by a name; all other names stay as they are.

    Raises :class:`Meaningless` for a function of which the derivative is not in the table.

    >>> from kowalevski_cas.notation import to_plain
    >>> words = Vocabulary(frozenset("ax"), functions=FUNCTIONS)
    >>> to_plain(derived(read(r"x\cos(ax)", words), "x"))
    'cos(ax) + x·([−sin(ax)]a)'
    """
    if not order:
        return formula
    values: dict[str, Formula] = {}
    rates: dict[str, Formula] = {by: Number(1)}

    def named(part: Formula) -> Formula:
        if not isinstance(part, Application):
            return part.map_children(named)
        if part.function not in _SLOPES or len(part.arguments) != 1:
            raise Meaningless(f"the derivative of {to_latex(part)} is not known", part.function)
        name = f"{part.function}({len(values)})"
        (inner,) = part.arguments
        values[name] = part
        slope = substitute(read(_SLOPES[part.function], _AT_X), {"x": inner})
        rates[name] = Product((slope, derived(inner, by))) if by in inner.names() else Number(0)
        return Name(name)

    found = derivative(named(formula), rates, lambda _: None)
    return derived(substitute(found, values), by, order - 1)
