"""How methods are called where people read of them."""

from __future__ import annotations

_NAMES = {
    "flint": "FLINT",
    "symengine": "SymEngine",
    "sympy": "SymPy polynomials",
    "modular": "residues",
    "ball": "balls",
    "floating": "floating point",
    "checker": "certificate checker",
    "rocq": "Rocq",
    "singular": "Singular",
    "pari": "PARI/GP",
    "maxima": "Maxima",
    "python-flint": "python-flint alone",
}


def shown(method: str) -> str:
    """The name of a method in print; a name that is not known stays as it is."""
    return _NAMES.get(method, method)
