"""Where derivations are found, and how one is loaded from its folder."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from contextlib import suppress
from importlib import invalidate_caches
from importlib.machinery import ModuleSpec, PathFinder, SourceFileLoader
from importlib.util import find_spec, module_from_spec, spec_from_file_location
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING

from kowalevski_cas import UserError
from kowalevski_cas.exit_guard import no_exit
from kowalevski_cas.notation.errors import Undeclared
from kowalevski_cas.paper.derivation import Derivation, Section
from kowalevski_cas.paper.scene import Scene

if TYPE_CHECKING:
    from _typeshed import ReadableBuffer


class LibraryError(UserError, ValueError):
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


EVIDENCE = ".evidence"
"""How the folder ends that holds the record and the certificates of a file beside it."""


SOURCES = (".py", ".tex")
"""How the files end of which something is kept beside them: derivations, and papers."""


def find(name: str) -> Path:
    """The folder with what is kept of a derivation, by its name, its path, or its module.

    A derivation that is a folder keeps its record and its certificates with it; that in a file
    ``lorenz.py`` has a folder ``lorenz.evidence`` beside it, once there is something to keep.
    """
    for folder in (library() / name, Path(name), Path(f"{name}{EVIDENCE}")):
        if source(folder).is_file():
            return folder
    path = Path(name)
    if not path.exists() and name.replace(".", "").isidentifier():
        path = _module(name) or path
    if path.name == "__init__.py":
        return path.parent
    if path.is_file() and path.suffix in SOURCES:
        return _beside(path)
    if name and path.exists():
        raise LibraryError(
            f"{name} is no derivation: a Python file is expected, or a folder with an __init__.py"
        )
    if path.suffix:
        raise LibraryError(f"there is no file {name}")
    known = ", ".join(available()) or "none"
    raise LibraryError(f"there is no derivation “{name}”; the library has: {known}")


READ: dict[Path, int] = {}
"""The files that derivations have read besides their modules, and when these had been saved."""


MADE: list[Section] = []
"""The sections of systems that were made since a derivation was loaded last, named or not."""


def _beside(path: Path) -> Path:
    """The folder of what is kept of a file; raises :class:`LibraryError` if two would share it."""
    others = [path.with_suffix(suffix) for suffix in SOURCES if suffix != path.suffix]
    if shared := next((other for other in others if other.is_file()), None):
        raise LibraryError(f"{path} and {shared.name} would share one folder: rename one of them")
    return path.with_suffix(EVIDENCE)


def source(folder: Path) -> Path:
    """The file that is executed for the derivation of which this folder keeps what there is."""
    if folder.suffix != EVIDENCE:
        return folder / "__init__.py"
    paper = folder.with_suffix(".tex")
    return paper if paper.is_file() else folder.with_suffix(".py")


def _module(name: str) -> Path | None:
    """The file of an importable module."""
    with suppress(ImportError, ValueError):
        spec = find_spec(name)
        return Path(spec.origin) if spec is not None and spec.origin else None
    return None


MEND = "Mend the formula, or declare its names; `having` declares constants."
"""What to do about a name that is not declared."""

SHELF = "kowalevski_cas_derivations"
"""The package below which derivations are loaded, beside those that they rest on."""


def load(name: str, anew: bool = True) -> Derivation:
    """The derivation with this name, in this folder, this file or this module.

    If not ``anew``, it is loaded together with the one before: if they stand side by side, a module
    that both need is executed once.

    It can rest on another one in the folder beside it or in the library, and imports it from
    there: ``from ..kharlamov2002.section1 import eq3``. A file that does not say what its
    ``derivation`` is, has the sections of its systems, in their order. Raises
    :class:`LibraryError` if nothing is stated there. Its modules are Python and are executed:
    load only derivations that you would run.
    """
    folder = find(name).resolve()
    file = source(folder)
    inside = file.parent == folder
    module_name = f"{SHELF}.{folder.stem if not inside else folder.name.replace('.', '_')}"
    path = [str(folder.parent), str(library())]
    if not anew and getattr(sys.modules.get(SHELF), "__path__", None) == path:
        known = sys.modules.get(module_name)
        found = getattr(known, "derivation", None)
        if isinstance(found, Derivation) and getattr(known, "__file__", None) == str(file):
            return found
        anew = known is not None
    else:
        anew = True
    if anew:
        _clear(path)
    below = [str(folder)] if inside else None
    loader = _loader(module_name, str(file))
    spec = spec_from_file_location(
        module_name, file, loader=loader, submodule_search_locations=below
    )
    assert spec is not None and spec.loader is not None
    module = module_from_spec(spec)
    sys.modules[module_name] = module
    MADE.clear()
    try:
        with no_exit():
            spec.loader.exec_module(module)
        return _derivation(module, file, folder.stem)
    except (LibraryError, KeyboardInterrupt):
        raise
    except BaseException as error:
        place = _place(error, folder if inside else file, file)
        kind = "" if isinstance(error, ValueError) else f"{type(error).__name__}: "
        said = error.msg if isinstance(error, SyntaxError) else str(error)
        said += f"\n  {MEND}" if isinstance(error, Undeclared) else ""
        raise LibraryError(f"{place}: {kind}{said}") from error


def _clear(path: list[str]) -> None:
    """Forget what was loaded; what is imported now is looked for in these folders."""
    for known in [m for m in sys.modules if m == SHELF or m.startswith(f"{SHELF}.")]:
        del sys.modules[known]
    shelf = ModuleType(SHELF)
    shelf.__path__ = path
    sys.modules[SHELF] = shelf
    invalidate_caches()


class _Anew(SourceFileLoader):
    """Keeps no compiled code: Python takes it for current if a file is saved twice in a second."""

    def set_data(self, path: str, data: ReadableBuffer, *, _mode: int = 0) -> None:
        """Write nothing."""


class _OnShelf(PathFinder):
    """Finds the modules of derivations, each with its loader."""

    @classmethod
    def find_spec(
        cls, fullname: str, path: Sequence[str] | None = None, target: ModuleType | None = None
    ) -> ModuleSpec | None:
        """Where a module of a derivation is, and how it is loaded."""
        if not fullname.startswith(f"{SHELF}."):
            return None
        spec = super().find_spec(fullname, path, target)
        if spec is not None and spec.origin and isinstance(spec.loader, SourceFileLoader):
            spec.loader = _loader(fullname, spec.origin)
        return spec


def _loader(name: str, file: str) -> SourceFileLoader:
    """How a module is loaded: those of a user may have been saved a moment ago."""
    own = Path(file).is_relative_to(library())
    return (SourceFileLoader if own else _Anew)(name, file)


sys.meta_path.insert(0, _OnShelf)


def owner(scene: Scene) -> tuple[Path, str] | None:
    """The file that was loaded last, and its name for the system that has this scene."""
    for module in [m for name, m in sys.modules.items() if name.startswith(f"{SHELF}.")]:
        for name, value in vars(module).items():
            if getattr(value, "scene", None) is scene and module.__file__ is not None:
                return Path(module.__file__), name
    return None


def _derivation(module: ModuleType, file: Path, name: str) -> Derivation:
    """What a module calls its derivation, or the sections that it states, or its values have."""
    found = getattr(module, "derivation", None)
    if isinstance(found, Derivation):
        return found
    sections = (getattr(value, "section", None) for value in vars(module).values())
    stated = [
        section
        for section in MADE
        if any(place == str(file) for place, _ in section.lines.values())
    ]
    own = tuple(
        dict.fromkeys([*stated, *(section for section in sections if isinstance(section, Section))])
    )
    if not own:
        raise LibraryError(
            f"{file} states nothing: make a System(...), or define `derivation = Derivation(...)`"
        )
    title = (module.__doc__ or name).strip().splitlines()[0].rstrip(".")
    source = "; ".join(filter(None, (file.name, *(section.title for section in own))))
    return Derivation(name, title, "", source, own)


def _place(error: BaseException, within: Path, file: Path) -> str:
    """The file and line of a derivation at which an error arose."""
    if isinstance(error, SyntaxError):
        return f"{error.filename or file}:{error.lineno or 1}"
    place = str(within)
    trace = error.__traceback__
    while trace is not None:
        name = trace.tb_frame.f_code.co_filename
        if Path(name).is_relative_to(within):
            place = f"{name}:{trace.tb_lineno}"
        trace = trace.tb_next
    return place
