"""The inverse of a linear change of variables, solved for with FLINT."""

from __future__ import annotations

from collections.abc import Sequence

from kowalevski_cas.algebra.linear import Singular
from kowalevski_cas.algebra.linear import inverse as inverse_matrix
from kowalevski_cas.algebra.present import polynomial_formula
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.notation import Formula, Name, total
from kowalevski_cas.paper.meaning import Meaning
from kowalevski_cas.problem.space import Meaningless


class SingularChange(Meaningless):
    """A linear change of variables of which the determinant is zero."""


def inverse(old: Meaning, formulas: Sequence[tuple[str, Formula]]) -> dict[str, Formula]:
    """The variables of ``old`` through new ones, which these formulas give.

    Raises :class:`SingularChange` if the formulas cannot be inverted, :class:`Meaningless` if they
    are not linear.
    """
    at = old.finder
    rows = []
    for name, formula in formulas:
        value = at.scalar(formula)
        row = [at.partial(value, variable) for variable in old.variables]
        if not all(_is_number(entry) for entry in row):
            raise Meaningless(f"the change of variables is not linear for {name}", name)
        rest = value
        for entry, variable in zip(row, old.variables, strict=True):
            rest = rest - entry * at.ring.generator(variable)
        if not rest.is_zero:
            raise Meaningless(f"the change of variables is not linear for {name}", name)
        rows.append(row)
    if len(rows) != len(old.variables):
        raise Meaningless("the change of variables is not one to one")
    try:
        solved = inverse_matrix(rows)
    except Singular:
        raise SingularChange("the change of variables is not invertible") from None
    return {
        variable: _combination(row, [name for name, _ in formulas])
        for variable, row in zip(old.variables, solved, strict=True)
    }


def _is_number(element: Element) -> bool:
    return not element.denominator and not any(
        any(exponents) for part in element.terms().values() for exponents in part
    )


def _combination(factors: Sequence[Element], names: Sequence[str]) -> Formula:
    """A sum of numbers, which may contain roots, times names."""
    terms: list[Formula] = []
    for factor, name in zip(factors, names, strict=True):
        roots = [Name(root) for root in factor.ring.roots]
        for mask, part in factor.terms().items():
            (value,) = part.values()
            bits = tuple(mask >> bit & 1 for bit in range(len(roots)))
            terms.append(polynomial_formula({(1, *bits): value}, [Name(name), *roots]))
    return total(terms)
