"""How methods are called where people read of them."""

from __future__ import annotations

from kowalevski_cas.systems import title

_NAMES = {
    "sympy": "SymPy polynomials",
    "modular": "residues",
    "ball": "balls",
    "floating": "floating point",
    "checker": "certificate checker",
    "python-flint": "python-flint alone",
}


def shown(method: str) -> str:
    """The name of a method in print; a name that is not known stays as it is."""
    return _NAMES.get(method, title(method))
