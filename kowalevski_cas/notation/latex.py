"""Formula to LaTeX, so that reading what was printed gives the same tree."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import replace

from kowalevski_cas.notation.formula import Formula, Name, Product, Quotient
from kowalevski_cas.notation.printer import Printer
from kowalevski_cas.notation.symbol import DOTS, symbol

_COMMAND = re.compile(r"\\[A-Za-z]+$")


class Latex(Printer):
    """Prints what the reader reads."""

    minus, times, cross, prime, partial_d = "-", r"\cdot ", r"\times", "'", r"\partial"
    dots, const, braces = r"\ldots", r"\mathrm{const}", (r"\{", r"\}")
    bars = (r"\lvert ", r"\rvert")
    word_form, fraction_form = r"\operatorname{{{}}}", r"\frac{{{}}}{{{}}}"
    root_form, bar_form, sum_form = r"\sqrt{{{}}}", r"\overline{{{}}}", r"\sum_{{{}={}}}^{{{}}}"
    radical_form = r"\sqrt[{}]{{{}}}"
    change_forms = (r"\Meant{{{}}}", r"\Slip{{{}}}")

    def name(self, formula: Name) -> str:
        return formula.name

    def sign(self, sign: str) -> str:
        return sign

    def side_by_side(self, parts: Iterable[str]) -> str:
        """The parts side by side; a command and a letter behind it need a space."""
        joined = ""
        for part in parts:
            space = " " if part[:1].isalpha() and _COMMAND.search(joined) else ""
            joined += space + part
        return joined

    def between(self, opening: str, text: str, closing: str) -> str:
        """Brackets, tall around fractions and matrices."""
        if r"\frac" in text or r"\begin" in text:
            return rf"\left{opening}{text}\right{closing}"
        return opening + text + closing

    def quotient(self, formula: Quotient) -> str:
        below = self(formula.denominator)
        # A product that begins with the scalar d must not pass for the d of a derivative.
        if isinstance(formula.denominator, Product) and formula.denominator.factors[0] == Name("d"):
            below = r"d\cdot " + below[1:].lstrip().removeprefix(r"\cdot ")
        return self.fraction(self(formula.numerator), below)

    def superscript(self, base: str, exponent: str) -> str:
        return f"{base}^{exponent}" if len(exponent) == 1 else f"{base}^{{{exponent}}}"

    def with_dots(self, argument: Formula, order: int) -> str:
        if isinstance(argument, Name):
            parts = symbol(argument.name)
            inner = replace(parts, raised="", index="", primes="").name
            behind = parts.name.removeprefix(inner)
        else:
            inner, behind = self.enclose(argument), ""
        while order > 3:
            inner, behind, order = f"{DOTS[2]}{{{inner}}}{behind}", "", order - 3
        return f"{DOTS[order - 1]}{{{inner}}}{behind}"

    def rows(self, rows: Sequence[Sequence[str]]) -> str:
        body = r" \\ ".join(map(" & ".join, rows))
        return rf"\begin{{pmatrix}} {body} \end{{pmatrix}}"


LATEX = Latex()
bracketed = LATEX.in_brackets


def to_latex(formula: Formula) -> str:
    r"""The formula in LaTeX.

    >>> to_latex(Quotient(Name("x_1"), Name(r"\ell")))
    '\\frac{x_1}{\\ell}'
    """
    return LATEX(formula)
