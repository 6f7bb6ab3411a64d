"""What the commands share: derivations by name, a run with its evidence, a bar of progress."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path

from kowalevski_cas.cli import parallel
from kowalevski_cas.cli.exits import NOTHING, CommandError
from kowalevski_cas.library import LibraryError, available, find, load
from kowalevski_cas.notation import NotationError
from kowalevski_cas.paper.derivation import Derivation
from kowalevski_cas.problem.accept import Unproved
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.problem.trees import FormatError
from kowalevski_cas.verify.certificate import FOLDER, Stored, load_certificates
from kowalevski_cas.verify.outcome import Run
from kowalevski_cas.verify.record import RecordError, load_record
from kowalevski_cas.verify.run import Progress, Session, verify


def add_derivations(parser: argparse.ArgumentParser) -> None:
    """The argument by which a command is told its :func:`derivations`."""
    parser.add_argument(
        "derivations",
        nargs="*",
        metavar="DERIVATION",
        help="name in the library, or folder; all of the library if none is named",
    )


def derivations(names: Sequence[str], only: Sequence[str] = ()) -> list[tuple[Path, Derivation]]:
    """The named derivations with their folders; all of the library if none is named.

    With ``only``, those that have one of these claims; each has to be in one of them.
    """
    names = names or available()
    if not names:
        raise CommandError("the library has no derivations", NOTHING)
    try:
        found = [(find(name), load(name)) for name in names]
    except LibraryError as error:
        raise CommandError(str(error)) from None
    ids = {claim.id for _, derivation in found for claim in derivation.claims}
    for id in only:
        if id not in ids:
            from difflib import get_close_matches

            near = get_close_matches(id, sorted(ids), 3, 0.4)
            hint = f"; did you mean {' or '.join(near)}?" if near else ""
            where = ", ".join(derivation.name for _, derivation in found)
            raise CommandError(f"there is no claim “{id}” in {where}{hint}", NOTHING)
    return [f for f in found if not only or any(claim.id in only for claim in f[1].claims)]


def run(
    folder: Path,
    derivation: Derivation,
    arithmetics: Sequence[str],
    only: Sequence[str] = (),
    explain: bool = False,
    timeout: float | None = None,
    stored: Mapping[str, Stored] | None = None,
    seed: int = 1,
) -> Run:
    """A run of a derivation, with the certificates in its folder and progress on a terminal."""
    if not derivation.claims:
        raise CommandError(f"{derivation.name} makes no claims", NOTHING)
    if stored is None:
        stored = load_certificates(folder)
    with progress_bar() as progress:
        return verify(
            derivation, arithmetics, only, explain, progress, stored, timeout, seed=seed,
            record=recorded(folder),
        )  # fmt: skip


def recorded(folder: Path) -> Mapping[str, Mapping[str, object]]:
    """The record in a folder as far as it can be read: it only says what is tried first."""
    try:
        return load_record(folder) or {}
    except RecordError:
        return {}


def certificates(
    folder: Path, derivation: Derivation, anew: bool = False
) -> tuple[dict[str, str], dict[str, str]]:
    """The texts of certificates by name, and reasons why others are missing.

    Evidence that is stored is used again, unless all is to be found ``anew``.
    """
    from kowalevski_cas.problem.checker import Rejected

    stored = {} if anew else load_certificates(folder)
    session = Session(derivation, ["flint"], certificates=stored, record=recorded(folder))
    texts: dict[str, str] = {}
    reasons: dict[str, str] = {}
    with progress_bar() as progress:
        for done, claim in enumerate(derivation.claims):
            progress(claim.id, done, len(derivation.claims))
            try:
                texts.update(session.certificates(claim))
            except (FormatError, Rejected, Unproved, NotationError, Meaningless) as error:
                reasons[claim.id] = str(error)
    return texts, reasons


def remove_others(folder: Path, names: Iterable[str]) -> None:
    """Remove the certificates in a folder that have none of these names."""
    from kowalevski_cas.verify.committed import certificate_files

    kept = {folder / FOLDER / f"{name}.json" for name in names}
    for path in certificate_files(folder):
        if path not in kept:
            path.unlink()


class progress_bar:
    """A progress bar on stderr, if that is a terminal; nothing otherwise."""

    def __enter__(self) -> Progress:
        """Start the bar and return what moves it."""
        self._stop: Callable[[], None] = lambda: None
        if parallel.forked or not sys.stderr.isatty():
            return lambda claim, done, total: None
        from rich.console import Console
        from rich.progress import Progress as Bar

        bar = Bar(console=Console(stderr=True), transient=True)
        task = bar.add_task("deciding")
        bar.start()
        self._stop = bar.stop
        return lambda claim, done, total: bar.update(
            task, description=claim, completed=done, total=total
        )

    def __exit__(self, *_: object) -> None:
        """Take the bar away."""
        self._stop()


def versions() -> dict[str, str]:
    """The versions of the programs and libraries that take part."""
    import platform
    from importlib.metadata import PackageNotFoundError, version

    from kowalevski_cas import __version__

    found = {"kowalevski_cas": __version__, "Python": platform.python_version()}
    for library in ("python-flint", "symengine", "sympy"):
        try:
            found[library] = version(library)
        except PackageNotFoundError:
            continue
    return found
