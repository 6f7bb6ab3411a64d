r"""Logarithms as new variables: :math:`x=\ln(J/T)` gives :math:`J=Te^x`, where this is printed."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace

from kowalevski_cas.paper.chains import NAME
from kowalevski_cas.reading.initially import moving_names
from kowalevski_cas.source.displays import TypedFormula

_OPEN = r"(?:\\(?:left|[bB]igg?l?)\s*)?"
_CLOSE = r"(?:\\(?:right|[bB]igg?r?)\s*)?"
_OF = (
    rf"{_OPEN}\(\s*(?P<of>{NAME})\s*(?:/\s*(?P<by>{NAME}|\d+)\s*)?{_CLOSE}\)"
    rf"|{_OPEN}\(?\s*\\[dt]?frac\s*\{{?\s*(?P<above>{NAME})\s*\}}?\s*\{{?\s*(?P<below>{NAME}|\d)\s*\}}?\s*{_CLOSE}\)?"
    rf"|(?P<alone>{NAME})"
)
_GIVEN = re.compile(
    rf"(?P<name>{NAME})\s*=\s*\\(?:ln|log)(?![A-Za-z])\s*(?:{_OF})(?P<end>[\s.,;]*)"
)
_MACRO = re.compile(r"\\(?!exp(?![A-Za-z])|mathrm(?![A-Za-z])|rm(?![A-Za-z]))[A-Za-z]+")
_EULER = r"(?:e|\\(?:mathrm|rm)\s*\{{?\s*e\s*\}}?)"
_POWER = (
    rf"{_EULER}\s*\^\s*(?:\{{{{[^{{{{}}}}^]*)?{{name}}(?![A-Za-z_])"
    r"|\\exp[^=]*?{name}(?![A-Za-z_])"
)
"""The exponential of a name."""


def with_exponentials(formulas: Sequence[TypedFormula]) -> Iterator[TypedFormula]:
    """The formulas, with what moves by an exponential for the logarithm of it.

    So it is where the exponential of the new name is printed.
    """
    moving = moving_names(formulas)
    for formula in formulas:
        found = _GIVEN.fullmatch(formula.tex.strip())
        of = (found["of"] or found["above"] or found["alone"]) if found else ""
        if found and of in moving and _has_exponential(found["name"], formulas):
            factor = found["by"] or found["below"] or ""
            tex = rf"{of}={factor} e^{{{found['name']}}}{found['end']}"
            yield replace(formula, tex=tex)
        else:
            yield formula


def _has_exponential(name: str, formulas: Sequence[TypedFormula]) -> bool:
    """Whether the exponential of a name is printed."""
    plain = not name.startswith("\\")
    texts = (_MACRO.sub(" ", one.tex) if plain else one.tex for one in formulas)
    power = re.compile(_POWER.format(name=re.escape(name)))
    return any(map(power.search, texts))
