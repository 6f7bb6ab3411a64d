"""The kinds of claims, one file each: the attributes of a statement, and its goals.

A kind is loaded when its name is first used; ``__init__.pyi`` says where it is, to type checkers as
well.
"""

import ast
from importlib import import_module
from pathlib import Path
from typing import Any

MODULES = {
    alias.name: statement.module
    for statement in ast.parse(Path(__file__).with_suffix(".pyi").read_text(encoding="utf-8")).body
    if isinstance(statement, ast.ImportFrom) and statement.module
    for alias in statement.names
}
"""The modules of the kinds, and of what all of them share, by name."""

__all__ = [*MODULES]


def __getattr__(name: str) -> Any:
    """A kind, loaded when it is first asked for."""
    if name not in MODULES:
        raise AttributeError(f"there is no kind of claims {name!r}")
    globals()[name] = kind = getattr(import_module(MODULES[name]), name)
    return kind
