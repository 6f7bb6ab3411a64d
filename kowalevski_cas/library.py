"""Where derivations are found, and how one is loaded from its folder."""

from __future__ import annotations

import sys
from importlib import invalidate_caches
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path
from types import ModuleType

from kowalevski_cas.paper.derivation import Derivation


class LibraryError(ValueError):
    """A derivation that cannot be found or loaded; the message says what to do."""


def library() -> Path:
    """The folder of derivations: the checkout's own, or the one that is installed."""
    package = Path(__file__).parent
    checkout = package.parent / "derivations"
    return checkout if checkout.is_dir() else package / "derivations"


def available() -> list[str]:
    """The names of the derivations in the library."""
    folder = library()
    if not folder.is_dir():
        return []
    return sorted(path.parent.name for path in folder.glob("*/__init__.py"))


def find(name: str) -> Path:
    """The folder of a derivation, by its name in the library or by a path."""
    for folder in (library() / name, Path(name)):
        if (folder / "__init__.py").is_file():
            return folder
    known = ", ".join(available()) or "none"
    if Path(name).exists():
        raise LibraryError(f"{name} is no derivation: a folder with an __init__.py is expected")
    raise LibraryError(f"there is no derivation “{name}”; the library has: {known}")


SHELF = "kowalevski_cas_derivations"
"""The package below which derivations are loaded, beside those that they rest on."""


def load(name: str) -> Derivation:
    """The derivation with this name or in this folder.

    It can rest on another one in the folder beside it or in the library, and imports it from
    there: ``from ..kharlamov2002.section1 import eq3``. Raises :class:`LibraryError` if the
    folder does not hold a derivation. Its modules are Python and are executed: load only
    derivations that you would run.
    """
    folder = find(name).resolve()
    initial = folder / "__init__.py"
    for known in [m for m in sys.modules if m == SHELF or m.startswith(f"{SHELF}.")]:
        del sys.modules[known]
    shelf = ModuleType(SHELF)
    shelf.__path__ = [str(folder.parent), str(library())]
    sys.modules[SHELF] = shelf
    invalidate_caches()
    module_name = f"{SHELF}.{folder.name.replace('.', '_')}"
    spec = spec_from_file_location(module_name, initial, submodule_search_locations=[str(folder)])
    assert spec is not None and spec.loader is not None
    module = module_from_spec(spec)
    sys.modules[module_name] = module
    try:
        spec.loader.exec_module(module)
    except LibraryError:
        raise
    except Exception as error:
        raise LibraryError(f"{_place(error, folder)}: {type(error).__name__}: {error}") from error
    derivation = getattr(module, "derivation", None)
    if not isinstance(derivation, Derivation):
        raise LibraryError(f"{initial} does not define `derivation = Derivation(...)`")
    return derivation


def _place(error: Exception, folder: Path) -> str:
    """The file and line of a derivation at which an error arose."""
    place = str(folder)
    if isinstance(error, SyntaxError):
        return f"{error.filename or folder / '__init__.py'}:{error.lineno or 1}"
    trace = error.__traceback__
    while trace is not None:
        file = trace.tb_frame.f_code.co_filename
        if Path(file).is_relative_to(folder.resolve()):
            place = f"{file}:{trace.tb_lineno}"
        trace = trace.tb_next
    return place
