"""How expressions of SymPy are printed in LaTeX, each symbol as one name."""

from __future__ import annotations

from contextlib import suppress
from typing import Any

from kowalevski_cas.notation import Name, NotationError, Vocabulary, read, to_latex
from kowalevski_cas.notation.open import OpenParser
from kowalevski_cas.notation.sympy import from_sympy


def latex_of(expression: Any, known: dict[str, Any]) -> str:
    """An expression of SymPy in LaTeX; its symbols are entered by their names into what is known.

    Raises ``ValueError`` if a symbol cannot be printed as a name, if another one is printed so, and
    if SymPy assumes more of it than that it is real, which nobody here would know.
    """
    return to_latex(from_sympy(expression, lambda symbol: _name(symbol, known)))


def _name(symbol: Any, known: dict[str, Any]) -> str:
    from sympy import Symbol, latex

    if symbol.assumptions0.items() - Symbol("x", real=True).assumptions0.items():
        said = "SymPy is to assume more of it than that it is real, which cannot be said here"
        raise ValueError(f"the symbol {symbol.name}: {said}; leave it out")
    for tex in (latex(symbol), rf"\mathrm{{{symbol.name}}}"):
        with suppress(NotationError):
            formula = read(tex, Vocabulary(frozenset({tex})), OpenParser)
            if isinstance(formula, Name):
                if known.setdefault(formula.name, symbol) != symbol:
                    raise ValueError(f"two symbols are printed {formula.name}: rename one")
                return formula.name
    raise ValueError(f"the symbol {symbol.name!r} cannot be printed as a name: rename it")
