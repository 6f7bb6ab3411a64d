"""Certificates for other programs to confirm: one module a program, imported when asked for."""

from __future__ import annotations

from importlib import import_module

from kowalevski_cas.export.format import Export, Format, Inexpressible, Json

FORMATS = {
    "rocq": "theorems for Rocq, which differentiates by itself and assumes no axioms",
    "singular": "polynomial identities for Singular, which differentiates by its own `diff`",
    "maxima": "polynomial identities for Maxima, which differentiates by its own `diff`",
    "pari": "polynomial identities for PARI/GP, which differentiates by its own `deriv`",
}
"""The formats and what they are. Each has a module here with a class ``Program``."""


def load(name: str) -> Format:
    """The format with this name."""
    program: type[Format] = import_module(f"{__name__}.{name}").Program
    return program()
