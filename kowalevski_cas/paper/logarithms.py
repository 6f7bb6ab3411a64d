r"""Functions of which only derivatives are known: :math:`(\ln f)'=f'/f`, and those of arcs.

They stand in first integrals, and under derivatives. A logarithm of an absolute value is half that
of its square. A logarithm, or an arc, is a term with a constant factor, so that it stands in no
derivative. It is real where the roots in its derivative are, and that of a sum of squares
everywhere.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator

from kowalevski_cas.notation import (
    Application,
    Derivative,
    Formula,
    Modulus,
    Negative,
    Number,
    Partial,
    Power,
    Product,
    Quotient,
    Root,
    Sum,
    Vocabulary,
    once,
    read,
    substitute,
    to_latex,
)
from kowalevski_cas.notation.functions import AT_AMPLITUDE, DERIVATIVE_OF, FUNCTIONS
from kowalevski_cas.paper.families import of_amplitude
from kowalevski_cas.paper.meaning import Meaning
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.problem.space import Meaningless

ARGUMENT = Vocabulary(frozenset("x"))
AT_ARGUMENT = Vocabulary(frozenset("xnk"), functions=FUNCTIONS)


@once
def has_logarithm(formula: Formula) -> bool:
    """Whether a function of which only the derivative is known stands in a formula, not derived."""
    match formula:
        case Derivative() | Partial():
            return False
        case Application(function) if function in DERIVATIVE_OF or of_amplitude(formula):
            return True
    return any(map(has_logarithm, formula.children()))


def with_real_logarithms(scene: Scene, formulas: Iterable[Formula]) -> Scene:
    """The scene on which the logarithms and arcs in some formulas are real."""
    found = (to_latex(root) for formula in formulas for root in roots(formula))
    new = [root for root in dict.fromkeys(found) if root not in scene.roots]
    return scene.adjoining(*sorted(new)) if new else scene


def roots(formula: Formula) -> Iterator[Root]:
    """The roots that are real where logarithms, but those of absolute values, and arcs are."""
    for one in formula.nodes():
        match one:
            case Application(function, (inner,)) if function in DERIVATIVE_OF:
                if not isinstance(inner, Modulus) and not has_logarithm(inner):
                    slope = _slope(function, inner)
                    yield from (node for node in slope.nodes() if isinstance(node, Root))


def _slope(function: str, inner: Formula) -> Formula:
    """The derivative of a function by its argument."""
    if function == r"\ln" and _is_sum_of_squares(inner):
        return Quotient(Number(1), inner)
    return substitute(read(DERIVATIVE_OF[function], ARGUMENT), {"x": inner})


def _is_sum_of_squares(formula: Formula) -> bool:
    """Whether a formula is printed as even powers of what is real, added up and divided."""
    match formula:
        case Sum(terms):
            return all(map(_is_sum_of_squares, terms))
        case Quotient(above, below):
            return _is_sum_of_squares(above) and _is_sum_of_squares(below)
        case Power(_, Number(exponent)):
            return exponent % 2 == 0
        case Number(value):
            return value > 0
    return False


def derivative_of(formula: Formula, by: Callable[[Formula], Formula], space: Meaning) -> Formula:
    """A derivative of a function with logarithms, of which ``by`` is the one without them.

    Raises :class:`Meaningless` for a logarithm that is no term with a constant factor.
    """

    def of(part: Formula) -> Formula:
        return derivative_of(part, by, space)

    if not has_logarithm(formula):
        return by(formula)
    match formula:
        case Application(r"\ln", (Modulus() as inner,)) if not has_logarithm(inner):
            square = Power(inner, Number(2))
            return Quotient(by(square), Product((Number(2), square)))
        case Application(function, (Application(_, (inner, *_)), *rest)) if of_amplitude(formula):
            below = dict(zip("nk", rest, strict=True)) if len(rest) > 1 else {"k": rest[0]}
            slope = substitute(read(AT_AMPLITUDE[function], AT_ARGUMENT), {"x": inner, **below})
            return Product((slope, by(inner)))
        case Application(function, (inner,)) if not has_logarithm(inner):
            return Product((_slope(function, inner), by(inner)))
        case Sum() | Negative():
            return formula.map_children(of)
        case Quotient(above, below) if _is_constant(below, space):
            return Quotient(of(above), below)
        case Product(factors):
            others = [factor for factor in factors if not has_logarithm(factor)]
            if len(others) == len(factors) - 1 and all(
                _is_constant(factor, space) for factor in others
            ):
                return Product(
                    tuple(factor if factor in others else of(factor) for factor in factors)
                )
    what = "a logarithm, or an arc, is read with a constant factor only"
    raise Meaningless(f"{to_latex(formula)}: {what}")


def _is_constant(formula: Formula, space: Meaning) -> bool:
    if has_logarithm(formula):
        return False
    value = space.finder.scalar(space.plain(formula))
    return all(space.finder.partial(value, name).is_zero for name in space.variables)
