r"""SymPy's expressions as formulas, and formulas as SymPy's expressions."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from contextlib import suppress
from functools import reduce
from operator import add, mul, truediv
from typing import Any

from kowalevski_cas.notation.formula import (
    Formula,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Relation,
    Root,
    Sum,
    equal,
    power,
)
from kowalevski_cas.notation.latex import to_latex


def from_sympy(expression: Any, name: Callable[[Any], str]) -> Formula:
    """An expression, or an equation, of SymPy as a formula; ``name`` says how symbols are printed.

    Raises:
        TypeError: something stands in it that is no sum, product, power or square root.
    """
    import sympy

    def of(part: Any) -> Formula:
        return from_sympy(part, name)

    expression = _expression(expression)
    if expression.is_Symbol:
        return Name(name(expression))
    if isinstance(expression, sympy.Equality):
        return equal(of(expression.lhs), of(expression.rhs))
    if not isinstance(expression, sympy.Expr):
        raise TypeError(f"{expression} is no equation: write Eq(…, evaluate=False), or LaTeX")
    return _operation(expression, of)


def _operation(expression: Any, of: Callable[[Any], Formula]) -> Formula:
    """A sum, product, quotient, power or number, with what it divides by also where it cancels."""
    import sympy

    if expression.is_Add:
        return Sum(tuple(of(term) for term in expression.as_ordered_terms()))
    opposite = -expression  # SymPy may cancel here
    if expression.could_extract_minus_sign() and -opposite == expression:
        return Negative(of(opposite))
    above, below = sympy.fraction(expression)
    if below != 1:
        return Quotient(of(above), of(below))
    if expression.is_Integer:
        return Number(int(expression))
    if expression.is_Mul:
        return Product(tuple(of(factor) for factor in expression.as_ordered_factors()))
    if expression.is_Pow and expression.exp.is_Rational and expression.exp.q < 3:
        base, exponent = of(expression.base), Number(int(expression.exp.p))
        base = base if expression.exp.q == 1 else Root(base)
        return power(base, exponent)
    raise TypeError(f"{expression} is no sum, product, whole power or square root: write LaTeX")


def _expression(value: Any) -> Any:
    """A value as an expression of SymPy; raises ``TypeError`` if it is none."""
    import sympy

    with suppress(sympy.SympifyError):
        expression = sympy.sympify(value, strict=True)
        if isinstance(expression, sympy.Basic):
            return expression
    raise TypeError(f"{value!r} is no formula, in LaTeX or of SymPy")


def to_sympy(formula: Formula, symbols: Mapping[str, Any]) -> Any:
    """A formula as an expression of SymPy, a chain of two members as an equation.

    A name that is not among the ``symbols`` becomes one, without its backslash and braces.

    Raises:
        TypeError: something stands in it that SymPy has no word for.
    """
    import sympy

    def of(part: Formula) -> Any:
        return to_sympy(part, symbols)

    match formula:
        case Number(value):
            return sympy.Integer(value)
        case Name(name):
            plain = "".join(sign for sign in name if sign not in "\\{}")
            return symbols[name] if name in symbols else sympy.Symbol(plain)
        case Relation((left, right), _) if formula.is_equality:
            return sympy.Eq(of(left), of(right), evaluate=False)
    if type(formula) in _OPERATIONS:
        return reduce(_OPERATIONS[type(formula)], map(of, formula.children()))
    if isinstance(formula, Negative | Root):
        value = of(formula.argument)
        return sympy.sqrt(value) if isinstance(formula, Root) else -value
    raise TypeError(f"SymPy is not told what {to_latex(formula)} is")


_OPERATIONS: dict[type[Formula], Callable[[Any, Any], Any]] = {
    Sum: add,
    Product: mul,
    Quotient: truediv,
    Power: pow,
}
