r"""Functions with logarithms, of which only derivatives are known: :math:`(\ln f)'=f'/f`.

A logarithm of an absolute value is half that of its square; any other one is that of a positive
function, which is the square of its root. A logarithm is a term with a constant factor, so that it
stands in no derivative.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

from kowalevski_cas.notation import (
    Application,
    Formula,
    Modulus,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Root,
    Sum,
    to_latex,
)
from kowalevski_cas.paper.elaborate import Elaboration
from kowalevski_cas.problem.space import Meaningless

LOGARITHM = r"\ln"


def has_logarithm(formula: Formula) -> bool:
    """Whether a logarithm stands in a formula."""
    return any(
        isinstance(one, Application) and one.function == LOGARITHM for one in formula.nodes()
    )


def arguments(formula: Formula) -> Iterator[Formula]:
    """What logarithms are taken of that has to be positive: no absolute values."""
    for one in formula.nodes():
        if isinstance(one, Application) and one.function == LOGARITHM:
            plain = (inner for inner in one.arguments if not isinstance(inner, Modulus))
            yield from (inner for inner in plain if not has_logarithm(inner))


def derived(formula: Formula, by: Callable[[Formula], Formula], space: Elaboration) -> Formula:
    """A derivative of a function with logarithms, of which ``by`` is the one without them.

    Raises :class:`Meaningless` for a logarithm that is no term with a constant factor.
    """

    def of(part: Formula) -> Formula:
        return derived(part, by, space)

    if not has_logarithm(formula):
        return by(formula)
    match formula:
        case Application(_, (Modulus() as inner,)) if not has_logarithm(inner):
            square = Power(inner, Number(2))
            return Quotient(by(square), Product((Number(2), square)))
        case Application(_, (inner,)) if not has_logarithm(inner):
            return Quotient(by(inner), Power(Root(inner), Number(2)))
        case Sum() | Negative():
            return formula.mapped(of)
        case Quotient(above, below) if _is_constant(below, space):
            return Quotient(of(above), below)
        case Product(factors):
            own = [factor for factor in factors if not has_logarithm(factor)]
            if len(own) == len(factors) - 1 and all(_is_constant(one, space) for one in own):
                return Product(tuple(one if one in own else of(one) for one in factors))
    raise Meaningless(f"{to_latex(formula)}: a logarithm is read with a constant factor only")


def _is_constant(formula: Formula, space: Elaboration) -> bool:
    if has_logarithm(formula):
        return False
    value = space.finder.scalar(space.plain(formula))
    return all(space.finder.partial(value, name).is_zero for name in space.variables)
