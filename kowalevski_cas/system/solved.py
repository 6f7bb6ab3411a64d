"""Relations among constants, solved for one of them."""

from __future__ import annotations

from collections.abc import Collection

from kowalevski_cas.notation import (
    Formula,
    Name,
    Negative,
    Number,
    Product,
    Quotient,
    Relation,
    Sum,
    to_latex,
    total,
)


def solved(formula: Formula, constants: Collection[str]) -> str:
    r"""A constant by the others, as :math:`\alpha=2-\beta` for :math:`\alpha+\beta=2`.

    It stands in one term, with a number before it; if there is none, the string is empty.
    """
    match formula:
        case Relation((left, right), ("=",)):
            terms = [*_terms(left), *map(_minus, _terms(right))]
        case _:
            return ""
    for k, term in enumerate(terms):
        factor, name = _multiple(term)
        rest = [*terms[:k], *terms[k + 1 :]]
        if name in constants and all(Name(name) not in one.nodes() for one in rest):
            others = total(map(_minus, rest) if factor > 0 else rest)
            value = others if abs(factor) == 1 else Quotient(others, Number(abs(factor)))
            return f"{name}={to_latex(value)}"
    return ""


def _terms(formula: Formula) -> tuple[Formula, ...]:
    terms = formula.terms if isinstance(formula, Sum) else (formula,)
    return tuple(term for term in terms if term != Number(0))


def _minus(formula: Formula) -> Formula:
    return formula.argument if isinstance(formula, Negative) else Negative(formula)


def _multiple(formula: Formula) -> tuple[int, str]:
    """The number before a name, and the name; an empty one for all else."""
    match formula:
        case Name(name):
            return 1, name
        case Product((Number(factor), Name(name))):
            return factor, name
        case Negative(argument):
            factor, name = _multiple(argument)
            return -factor, name
    return 1, ""
