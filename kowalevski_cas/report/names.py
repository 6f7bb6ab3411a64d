"""Names in a report: of claims, of the displays they are rows of, and of programs."""

from __future__ import annotations

import re
from typing import Final

_PROGRAMS: Final = {"flint": "FLINT", "symengine": "SymEngine", "sympy": "SymPy"}


def display_of(claim: str) -> str:
    """The display to which a claim belongs: ``eq10`` for ``eq10.3``; else the claim itself."""
    match = re.fullmatch(r"(.+)\.\d+", claim)
    return match[1] if match else claim


def anchor(text: str) -> str:
    """A name that both LaTeX and Typst take for a label."""
    return re.sub(r"[^A-Za-z0-9.-]", "-", text)


def program(arithmetic: str) -> str:
    """What the authors of an arithmetic call it."""
    return _PROGRAMS.get(arithmetic, arithmetic)
