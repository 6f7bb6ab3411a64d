"""Certificates for other programs to confirm: one module a program, imported when asked for."""

from __future__ import annotations

from importlib import import_module

from kowalevski_cas.export.format import Export, Format, Inexpressible, Json


def load(name: str) -> Format:
    """The format with this name."""
    program: type[Format] = import_module(f"{__name__}.{name}").Program
    return program()
