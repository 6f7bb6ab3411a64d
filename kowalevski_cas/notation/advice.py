r"""What to print for that which is typed as in Python, or in Unicode, and is no LaTeX.

>>> advice("x**2", 1), advice("sqrt(x)", 0), advice("2x", 0)
('print x^2 for x**2', 'print \\sqrt{…} for sqrt', '')
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable

from kowalevski_cas.notation.functions import FUNCTIONS
from kowalevski_cas.notation.macros import GREEK

_RAISED = "⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻"
_LEVEL = str.maketrans(_RAISED, "0123456789+-")
_HALVES = {"½": r"\frac12", "⅓": r"\frac13", "¼": r"\frac14", "¾": r"\frac34"}
_BEFORE = r"(?<![A-Za-z\\])(?:(?:np|numpy|math|sympy|sp)\.)?"


def _word(names: Iterable[str]) -> str:
    """Any of some names that are no part of a longer one."""
    return rf"{_BEFORE}({'|'.join(sorted(names))})(?![A-Za-z])"


def _typed_macros(macros: Iterable[str]) -> set[str]:
    """Macros without what begins them."""
    return {macro[1:] for macro in macros if macro[1:].isalpha()}


def _power(found: re.Match[str]) -> str:
    """A power, with braces where it needs them."""
    base, exponent = found[1], found[2].translate(_LEVEL).strip("() ")
    return f"{base}^{exponent}" if len(exponent) == 1 else f"{base}^{{{exponent}}}"


_INSTEAD: dict[str, str | Callable[[re.Match[str]], str]] = {
    r"([A-Za-z]?)\s*\*\*\s*(\([^()]*\)|-?\w+(?:\.\d+)?)": _power,
    rf"([A-Za-z]?)([{_RAISED}]+)": _power,
    r"([A-Za-z]?)\^(-\w+|\([^()]*\))": _power,
    r"(?<!\*)\*(?!\*)": r"nothing, or \\cdot,",
    "==": "=",
    "<=": r"\\le",
    ">=": r"\\ge",
    "!=": r"\\ne",
    _word(["sqrt"]) + r"\(?": r"\\sqrt{…}",
    "√": r"\\sqrt{…}",
    _word(["log"]) + r"\(?": r"\\ln",
    _word(_typed_macros(FUNCTIONS)) + r"\(?": r"\\\1",
    _word(_typed_macros(GREEK)) + r"\(?": r"\\\1",
    _word(["abs", "Abs"]) + r"\(?": "|…|",
    _word(["Rational"]) + r"\(?": r"\\frac{…}{…}",
    _word(["Eq"]) + r"\(?": "… = …",
    _word(["Derivative", "diff"]) + r"\(?": r"\\dot x, or \\frac{dx}{dt},",
    r"\.diff\(?": r"\\dot x, or \\frac{dx}{dt},",
    r"\bd/d([A-Za-z])": r"\\frac{d}{d\1}",
    f"[{''.join(_HALVES)}]": lambda found: _HALVES[found[0]],
}
"""Patterns of what is typed, and what to print for them."""


def advice(tex: str, position: int) -> str:
    """What to print for what stands at a place; nothing if it is not known what was meant."""
    for pattern, instead in _INSTEAD.items():
        for found in re.finditer(pattern, tex):
            if found.start() <= position < found.end():
                wanted = instead(found) if callable(instead) else found.expand(instead)
                return f"print {wanted} for {found[0].rstrip('(').strip()}"
    return ""
