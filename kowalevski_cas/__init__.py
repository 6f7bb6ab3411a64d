"""Printed derivations of mathematical mechanics, read, proved or refuted."""

import os
from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from kowalevski_cas.system import System, display

__version__ = "0.1.0"

if os.name == "nt":
    raise ImportError("kowalevski_cas runs on Linux and macOS; on Windows, inside of its WSL")

__all__ = ["System", "UserError", "__version__", "display"]


class UserError(Exception):
    """An error that the user can do something about; a command ends with its ``code``."""

    code = 2


def __getattr__(name: str) -> Any:
    """``System`` and ``display``, loaded when they are first asked for."""
    if name not in __all__:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(f"{__name__}.system"), name)
