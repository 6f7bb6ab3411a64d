r"""Definite integrals as functions of their ends, so that they can be read and compared.

:math:`\int_a^bf(x)\,dx` is read as a function of a, b, x and f(x), and printed as it was.
"""

from __future__ import annotations

import re

from kowalevski_cas.algebra.quadrature import INFINITE, INTEGRAL
from kowalevski_cas.notation import Application, Derivative, Formula, Name, Number, times, to_latex

DIFFERENTIAL = "d"
"""The sign of a differential, and the mark of the derivative that it is read as."""

_SIGN = re.compile(r"\\int\s*(?:\\limits\s*)?_")
_DIFFERENTIAL = re.compile(
    r"(?:\\[,;!:]\s*)*(?:\\mathrm\s*\{\s*d\s*\}|(?<![A-Za-z\\])d)\s*"
    r"(?P<by>\\[a-z]+|[a-z])(?![a-z])(?P<prime>'?)"
)
_PRIMED = "_{998}"
"""The index of a name that stands for that with a prime over which it is integrated."""


def without_integrals(tex: str) -> str:
    """A display with its definite integrals as functions, the innermost first; as far as it can."""
    signs = [*_SIGN.finditer(tex)]
    while signs:
        sign = signs.pop()
        first, at = _argument(tex, sign.end())
        if tex[at : at + 1] != "^":
            return tex
        last, at = _argument(tex, at + 1)
        end = _DIFFERENTIAL.search(tex, at)
        if end is None:
            return tex
        body, behind = tex[at : end.start()], tex[end.end() :]
        if body.count("{") > body.count("}"):  # it stands above a line
            closing = behind.find("}")
            _, stop = _argument(behind, closing + 1)
            body += f"1{behind[:stop]}"
            behind = behind[stop:]
        last = INFINITE if last.strip() == r"\infty" else last
        by = end["by"]
        if end["prime"]:
            body, by = _renamed(body, f"{by}'", by + _PRIMED), by + _PRIMED
        read = rf"{INTEGRAL}\left({first}, {last}, {by}, {body or '1'}\right)"
        tex = tex[: sign.start()] + read + behind
    return tex


def _renamed(tex: str, name: str, other: str) -> str:
    """A text in which a letter with a prime has another name."""
    pattern = rf"{re.escape(name)}|\\[A-Za-z]+|."
    return re.sub(pattern, lambda m: other if m[0] == name else m[0], tex, flags=re.DOTALL)


def _argument(tex: str, at: int) -> tuple[str, int]:
    """What stands behind a place as an argument, and where it ends."""
    while tex[at : at + 1].isspace():
        at += 1
    if tex[at : at + 1] != "{":
        found = re.compile(r"\\[A-Za-z]+|.", re.DOTALL).match(tex, at)
        return (found[0], found.end()) if found else ("", at)
    depth = 0
    for end in range(at, len(tex)):
        depth += (tex[end] == "{") - (tex[end] == "}")
        if not depth:
            return tex[at + 1 : end], end + 1
    return "", len(tex)


def with_integrals(formula: Formula) -> Formula:
    """A formula to be printed, with its integrals and differentials as they are printed."""
    formula = formula.map_children(with_integrals)
    match formula:
        case Derivative(derived, mark) if mark == DIFFERENTIAL:
            return times(Name(DIFFERENTIAL), derived)
        case Application(function, (first, last, by, body)) if function == INTEGRAL:
            end = r"\infty" if last == Name(INFINITE) else to_latex(last)
            ends = rf"\int_{{{to_latex(first)}}}^{{{end}}}"
            inner = "" if body == Number(1) else to_latex(body)
            return Name(rf"{ends}{inner}\,d{to_latex(by)}".replace(_PRIMED, "'"))
    return formula
