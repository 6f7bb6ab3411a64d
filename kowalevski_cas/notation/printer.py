"""Formula to LaTeX, so that reading what was printed gives the same tree."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable

from kowalevski_cas.notation.errors import letter_and_index
from kowalevski_cas.notation.formula import (
    Application,
    Conjugate,
    Constant,
    CrossProduct,
    Derivative,
    Diagonal,
    Formula,
    ImaginaryPart,
    Name,
    Negative,
    Number,
    PoissonBracket,
    Power,
    Product,
    Quotient,
    RealPart,
    Relation,
    Root,
    ScalarProduct,
    Sum,
    Unwritten,
    Vector,
)

_COMMAND = re.compile(r"\\[A-Za-z]+$")
_DOTS = {1: r"\dot", 2: r"\ddot", 3: r"\dddot"}
# What carries a power without brackets.
_BASES = (Name, Number, Application, Vector, ScalarProduct, PoissonBracket, Conjugate)


def to_latex(formula: Formula) -> str:
    r"""The formula in LaTeX.

    >>> to_latex(Quotient(Power(Name("x_1"), Number(2)), Name(r"\ell")))
    '\\frac{x_1^2}{\\ell}'
    """
    return _PRINTERS[type(formula)](formula)


def bracketed(tex: str) -> str:
    r"""The source in brackets, square around round ones, tall around fractions and matrices.

    >>> bracketed("a + b(c + d)")
    '[a + b(c + d)]'
    """
    return _between("[", tex, "]") if "(" in tex and "[" not in tex else _between("(", tex, ")")


def _between(opening: str, tex: str, closing: str) -> str:
    if r"\frac" in tex or r"\begin" in tex:
        return rf"\left{opening}{tex}\right{closing}"
    return opening + tex + closing


def _join(parts: Iterable[str]) -> str:
    """The parts side by side; a command and a letter behind it need a space."""
    joined = ""
    for part in parts:
        space = " " if part[:1].isalpha() and _COMMAND.search(joined) else ""
        joined += space + part
    return joined


def _listed(formulas: Iterable[Formula]) -> str:
    # Square brackets around a list would be a commutator.
    return _between("(", ", ".join(map(to_latex, formulas)), ")")


def _term(formula: Formula) -> str:
    """The formula behind a sign."""
    tex = to_latex(formula)
    return bracketed(tex) if isinstance(formula, Sum | Negative | Relation) else tex


def _factor(formula: Formula) -> str:
    """The formula beside other factors."""
    inner = isinstance(formula, Sum | Negative | Product | CrossProduct | Relation)
    return bracketed(to_latex(formula)) if inner else to_latex(formula)


def _sum(formula: Sum) -> str:
    first, *rest = formula.terms
    tex = _negative(first) if isinstance(first, Negative) else _term(first)
    for term in rest:
        if isinstance(term, Negative):
            tex += " - " + _term(term.argument)
        else:
            tex += " + " + _term(term)
    return tex


def _negative(formula: Negative) -> str:
    return "-" + _term(formula.argument)


def _product(formula: Product) -> str:
    parts: list[str] = []
    for factor in formula.factors:
        part = _factor(factor)
        # A number behind a factor would look like a part of it.
        if parts and part[0].isdigit():
            part = r"\cdot " + part
        parts.append(part)
    return _join(parts)


def _quotient(formula: Quotient) -> str:
    above, below = to_latex(formula.numerator), to_latex(formula.denominator)
    # A product that begins with the scalar d must not pass for the d of a derivative.
    if isinstance(formula.denominator, Product) and formula.denominator.factors[0] == Name("d"):
        below = r"d\cdot " + below[1:].lstrip().removeprefix(r"\cdot ")
    return rf"\frac{{{above}}}{{{below}}}"


def _power(formula: Power) -> str:
    base, exponent = formula.base, to_latex(formula.exponent)
    plain = isinstance(base, _BASES) or (isinstance(base, Derivative) and base.mark == "dot")
    raised = exponent if len(exponent) == 1 else f"{{{exponent}}}"
    return f"{to_latex(base) if plain else bracketed(to_latex(base))}^{raised}"


def _derivative(formula: Derivative) -> str:
    argument, mark, order = formula.argument, formula.mark, 1
    if mark not in ("dot", "prime"):
        by = _join(["d", mark])
        if isinstance(argument, Name):
            return rf"\frac{{{_join(['d', argument.name])}}}{{{by}}}"
        return rf"\frac{{d}}{{{by}}}{bracketed(to_latex(argument))}"
    while isinstance(argument, Derivative) and argument.mark == mark:
        argument, order = argument.argument, order + 1
    if mark == "prime":
        inner = to_latex(argument)
        return (inner if isinstance(argument, Name) else bracketed(inner)) + "'" * order
    if isinstance(argument, Name):
        inner = letter_and_index(argument.name)[0]
        behind = argument.name[len(inner) :]
    else:
        inner, behind = bracketed(to_latex(argument)), ""
    while order > 3:
        inner, behind, order = f"{_DOTS[3]}{{{inner}}}{behind}", "", order - 3
    return f"{_DOTS[order]}{{{inner}}}{behind}"


def _vector(formula: Vector) -> str:
    rows = formula.components
    lengths = {len(row.components) if isinstance(row, Vector) else 0 for row in rows}
    if len(lengths) != 1 or 0 in lengths:
        return _listed(rows)
    lines = (" & ".join(map(to_latex, row.components)) for row in rows if isinstance(row, Vector))
    return r"\begin{pmatrix} " + r" \\ ".join(lines) + r" \end{pmatrix}"


def _cross_product(formula: CrossProduct) -> str:
    sides = []
    for side in (formula.left, formula.right):
        tex = to_latex(side)
        inner = isinstance(side, Sum | Negative | CrossProduct)
        # A dot between the factors of the right side would end that side.
        inner = inner or (side is formula.right and isinstance(side, Product) and r"\cdot " in tex)
        sides.append(bracketed(tex) if inner else tex)
    return r" \times ".join(sides)


def _relation(formula: Relation) -> str:
    first, *rest = map(to_latex, formula.members)
    return first + "".join(
        f" {sign} {member}" for sign, member in zip(formula.signs, rest, strict=True)
    )


_PRINTERS: dict[type[Formula], Callable[..., str]] = {
    Number: lambda f: str(f.value),
    Name: lambda f: f.name,
    Sum: _sum,
    Negative: _negative,
    Product: _product,
    Quotient: _quotient,
    Power: _power,
    Root: lambda f: rf"\sqrt{{{to_latex(f.argument)}}}",
    Derivative: _derivative,
    Conjugate: lambda f: rf"\overline{{{to_latex(f.argument)}}}",
    RealPart: lambda f: r"\operatorname{Re}" + bracketed(to_latex(f.argument)),
    ImaginaryPart: lambda f: r"\operatorname{Im}" + bracketed(to_latex(f.argument)),
    Application: lambda f: f.function + _listed(f.arguments),
    Vector: _vector,
    Diagonal: lambda f: r"\operatorname{diag}" + _listed(f.entries),
    ScalarProduct: lambda f: _listed((f.left, f.right)),
    CrossProduct: _cross_product,
    PoissonBracket: lambda f: rf"\{{{to_latex(f.left)}, {to_latex(f.right)}\}}",
    Unwritten: lambda f: r"\ldots",
    Constant: lambda f: r"\mathrm{const}",
    Relation: _relation,
}
