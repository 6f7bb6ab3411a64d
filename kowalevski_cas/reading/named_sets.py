r"""Sets with names: :math:`\Sigma=\{S=1\}`, :math:`\mathcal K:\ x^2+y^2=1,\ z=0`."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import replace

from kowalevski_cas.source.displays import TypedFormula

_LETTER = (
    r"(?:\\math(?:cal|scr|bf|rm|frak|bb|sf)\s*(?:\{\s*[A-Za-z]\s*\}|[A-Za-z])|\\[A-Za-z]+|[A-Za-z])"
    r"(?:_(?:\{[^{}]*\}|\w))?"
)
_START = r"(?P<start>\s*(?:\\label\{[^{}]*\}\s*)*)"
_GAP = r"(?:\\[ ,;:!]|\\q?quad(?![A-Za-z])|~|\s)"
_COLON = re.compile(
    rf"{_START}(?P<name>{_LETTER})"
    r"(?P<sign>\s*:(?:\s*(?:\\[ ,;:!]|\\q?quad(?![A-Za-z])|~))+)(?P<body>.*)",
    re.DOTALL,
)
r"""A letter with a colon and a space before equations: without a space it may be a ratio."""
_SIZE = r"(?:\\(?:left|right|[bB]igg?[lr]?)\s*)?"
_BRACES = re.compile(
    rf"{_START}(?P<name>{_LETTER})(?P<sign>\s*:?=\s*{_SIZE}\\\{{)"
    rf"(?P<body>[^:|]*)(?P<end>{_SIZE}\\\}}{_GAP}*[.,;]?{_GAP}*)",
    re.DOTALL,
)
_MAP = re.compile(
    rf"\s*(?:{_LETTER}\s*:)?\s*\([^()]*\)\s*\\mapsto\s*\([^()]*'\s*\){_GAP}*,(?=.*=)", re.DOTALL
)
"""What is mapped to its image, with the name of the map, before the equations for it."""
_EQUATION = re.compile(r"(?<![<>:!])=(?!:)")


def without_set_names(formulas: Iterable[TypedFormula]) -> Iterator[tuple[TypedFormula, str]]:
    r"""The formulas with the equations alone of sets that have names, and these names.

    What stands in the place of a name, and of braces, is as long and prints nothing.
    """
    for formula in formulas:
        found = _COLON.fullmatch(formula.tex) or _BRACES.fullmatch(formula.tex)
        if found is None or ":" in found["body"] or not _EQUATION.search(found["body"]):
            mapped = _MAP.match(formula.tex)
            until = mapped.end() if mapped else 0
            blank = " " * until + formula.tex[until:]
            yield replace(formula, tex=blank) if until else formula, ""
            continue
        named = found["name"] + found["sign"]
        end = found.groupdict().get("end") or ""
        tex = found["start"] + " " * len(named) + found["body"] + " " * len(end)
        yield replace(formula, tex=tex), found["name"]
