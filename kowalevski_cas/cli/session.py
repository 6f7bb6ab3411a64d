"""What the commands share: derivations by name, a run with its evidence, a bar of progress."""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from hashlib import sha256
from pathlib import Path
from time import time
from typing import TYPE_CHECKING, TypeVar

from kowalevski_cas import __version__
from kowalevski_cas.cli.exits import NOTHING, CommandError
from kowalevski_cas.cli.terminal import Output, printable
from kowalevski_cas.library import available, find, load, source
from kowalevski_cas.limits import tell
from kowalevski_cas.notation import NotationError
from kowalevski_cas.paper.derivation import Derivation
from kowalevski_cas.paper.texts import Texts
from kowalevski_cas.processes import each
from kowalevski_cas.verify.certificate import FOLDER, Stored, load_certificates
from kowalevski_cas.verify.outcome import Run
from kowalevski_cas.verify.record import RecordError, load_record
from kowalevski_cas.verify.run import Session, run_together

if TYPE_CHECKING:
    from rich.progress import TaskID

    from kowalevski_cas.pool import Pool

Item = TypeVar("Item")
Result = TypeVar("Result")


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
    found = [(find(name), load_named(find(name), name, anew=not k)) for k, name in enumerate(names)]
    ids = {claim.id for _, derivation in found for claim in derivation.claims}
    for id in only:
        if id not in ids:
            from difflib import get_close_matches

            near = get_close_matches(id, sorted(ids), 3, 0.4)
            hint = f"; did you mean {' or '.join(near)}?" if near else ""
            where = ", ".join(derivation.name for _, derivation in found)
            raise CommandError(f"there is no claim “{id}” in {where}{hint}", NOTHING)
    return [f for f in found if not only or any(claim.id in only for claim in f[1].claims)]


def load_named(folder: Path, name: str, anew: bool = True) -> Derivation:
    """The derivation with this name; a paper is read as its own."""
    file = source(folder)
    if file.suffix != ".tex":
        return load(name, anew)
    from kowalevski_cas.reading import read
    from kowalevski_cas.source.files import read_source

    return read(read_source(file)).derivation


def runs(
    chosen: Sequence[tuple[Path, Derivation]],
    arithmetics: Sequence[str],
    only: Sequence[str] = (),
    explain: bool = False,
    timeout: float | None = None,
    stored: Sequence[Mapping[str, Stored]] = (),
    seed: int = 1,
) -> list[tuple[Run, Texts]]:
    """Runs of derivations, with the texts that were read, and with progress on a terminal.

    Evidence is what is ``stored`` for each of them, or the certificates in their folders.
    """
    sessions = []
    stored = stored or [load_certificates(folder) for folder, _ in chosen]
    for (folder, derivation), kept in zip(chosen, stored, strict=True):
        if not derivation.claims:
            raise CommandError(f"{derivation.name} makes no claims", NOTHING)
        texts, record = derivation.texts(), readable_record(folder)
        try:
            session = Session(derivation, arithmetics, explain, kept, timeout, texts, seed, record)
        except NotationError as error:
            said = f"{derivation.name}: what it accepts cannot be read: {error}"
            raise CommandError(said) from None
        sessions.append(session)
    with progress_bar() as progress:
        found = run_together(sessions, only, progress)
    for note in (outcome.note for run in found for outcome in run.outcomes if outcome.note):
        print(note, file=sys.stderr)
    return [(run, session.texts) for run, session in zip(found, sessions, strict=True)]


def readable_record(folder: Path) -> Mapping[str, Mapping[str, object]]:
    """The record in a folder as far as it can be read: it only says what is tried first."""
    try:
        return load_record(folder) or {}
    except RecordError:
        return {}


def rejections(run: Run) -> dict[str, str]:
    """Why the checker, on its own, rejects certificates of a run; by the claims.

    It computes with Python's integers here, as it does wherever it is alone.
    """
    from kowalevski_cas.problem import checker

    reasons: dict[str, str] = {}
    for done, (name, text) in enumerate(run.certificates.items()):
        tell(name, done, len(run.certificates))
        try:
            checker.check(text)
        except checker.Rejected as error:
            reasons[name.rpartition("/")[2]] = str(error)
    return reasons


def add_timeout(
    parser: argparse.ArgumentParser, seconds: float, what: str = "for each claim"
) -> None:
    """The argument by which a command is told its limit."""
    parser.add_argument(
        "--timeout", type=_seconds, default=seconds, metavar="SECONDS", help=f"{what} ({seconds:g})"
    )


def add_limit(parser: argparse.ArgumentParser) -> None:
    """The argument by which a command is told the limit of its run."""
    parser.add_argument(
        "--limit",
        type=_seconds,
        metavar="SECONDS",
        help="for the whole run: what is not decided by then is timeout",
    )


def add_format(parser: argparse.ArgumentParser, formats: Iterable[str], each: str) -> None:
    """The arguments by which a command is told how to print results."""
    parser.add_argument("--format", choices=formats, default="pretty", help="how to print results")
    parser.add_argument(
        "-v", "--verbose", action="store_const", dest="format", const="verbose",
        help=f"show the results {each} by {each}",
    )  # fmt: skip


def add_output(
    parser: argparse.ArgumentParser,
    says: str,
    default: str = "",
    of: str = "DIR",
    required: bool = False,
) -> None:
    """The argument by which a command is told where to write."""
    parser.add_argument(
        "-o",
        "--output",
        type=Path,
        metavar=of,
        default=Path(default) if default else None,
        help=f"{says} ({default})" if default else says,
        required=required,
    )


KEPT = 30 * 24 * 3600.0
"""Seconds after which nobody will go on with what was interrupted."""

HOW = {"jobs", "scheduler", "timeout", "format", "write"}
"""Arguments that do not say what is asked, but how."""


def add_pool(parser: argparse.ArgumentParser, jobs: int = os.cpu_count() or 1) -> None:
    """The arguments by which a command is told where independent tasks are done."""
    parser.add_argument(
        "--jobs", type=_positive, default=jobs, metavar="N", help=f"processes at once ({jobs})"
    )
    parser.add_argument(
        "--scheduler", default="", metavar="ADDRESS", help="a Dask cluster that works instead"
    )


def pool(arguments: argparse.Namespace, folders: Sequence[Path] = ()) -> Pool:
    """Where tasks are done; what the same question had found when it was interrupted is there.

    It is another question if the program was changed since, or a derivation in one of ``folders``.
    """
    from kowalevski_cas.pool import Pool  # a run of a derivation needs none

    package = Path(__file__).parents[1]
    read = {source(folder) for folder in folders}.union(*(folder.rglob("*") for folder in folders))
    files = read.union(package.rglob("*.py"))
    saved = sorted((str(file), file.stat().st_mtime_ns) for file in files)
    asked = {k: v for k, v in vars(arguments).items() if k not in HOW and not callable(v)}
    words = repr((saved, Path.cwd(), sorted(asked.items())))
    caches = os.environ.get("XDG_CACHE_HOME") or os.path.expanduser("~/.cache")
    folder = Path(caches) / "kowalevski-cas"
    with suppress(OSError):
        for old in folder.glob("*"):
            if time() - old.stat().st_mtime > KEPT:
                old.unlink()
    file = folder / sha256(words.encode()).hexdigest()[:32]
    return Pool(arguments.jobs, arguments.scheduler, file)


def _positive(text: str) -> int:
    if not 0 < (value := natural(text)) <= 1000:
        raise argparse.ArgumentTypeError("from 1 to 1000 processes are possible")
    return value


def _seconds(text: str) -> float:
    with suppress(ValueError):
        if 0 < (value := float(text)) < 1e8:
            return value
    raise argparse.ArgumentTypeError(f"a positive number of seconds is expected, not “{text}”")


def natural(text: str) -> int:
    """The whole number that an argument is to be."""
    if not text.isdecimal():
        raise argparse.ArgumentTypeError(f"a whole number is expected, not “{text}”")
    return int(text)


def map_in_processes(
    work: Callable[[Item], Result], items: Sequence[Item], size: Callable[[Item], int] = lambda _: 0
) -> list[Result]:
    """The results of ``work`` on every item, each in a process; with progress on a terminal.

    The items of the largest ``size`` are begun first, so that no long one is left at the end.
    """
    order = sorted(range(len(items)), key=lambda place: -size(items[place]))
    with progress_bar() as progress:
        found = each(lambda place: work(items[place]), order, heard=progress)
        by_place = dict(zip(order, found, strict=True))
    return [by_place[place] for place in range(len(items))]


def remove_others(folder: Path, names: Iterable[str]) -> None:
    """Remove the certificates in a folder that have none of these names."""
    from kowalevski_cas.verify.committed import certificate_files

    kept = {folder / FOLDER / f"{name}.json" for name in names}
    for path in certificate_files(folder):
        if path not in kept:
            path.unlink()


class Progress:
    """What is heard of a run on a terminal; nothing elsewhere."""

    def __call__(self, name: str, done: int, total: int, number: int = 0) -> None:
        """Move the bar with this number: how much is done of how much."""

    def say(self, line: str) -> None:
        """Print a line above the bars."""


@contextmanager
def progress_bar() -> Iterator[Progress]:
    """A progress bar on stderr, if that is a terminal; nothing otherwise."""
    if not sys.stderr.isatty():
        yield Progress()
        return
    from rich.console import Console
    from rich.markup import escape
    from rich.progress import Progress as Bar

    tasks: dict[int, TaskID] = {}

    class Moving(Progress):
        def __call__(self, name: str, done: int, total: int, number: int = 0) -> None:
            name = escape(printable(name))
            if number not in tasks:
                tasks[number] = bar.add_task(name)
            bar.update(tasks[number], description=name, completed=done, total=total, refresh=True)

        def say(self, line: str) -> None:
            bar.console.print(escape(printable(line)), highlight=False, soft_wrap=True)

    # Without a thread of its own: processes are forked meanwhile.
    stream = sys.stderr.stream if isinstance(sys.stderr, Output) else sys.stderr
    with Bar(console=Console(file=stream), transient=True, auto_refresh=False) as bar:
        yield Moving()


def versions() -> dict[str, str]:
    """The versions of the programs and libraries that take part."""
    import platform

    installed = {"kowalevski_cas": __version__, "Python": platform.python_version()}
    return installed | installed_versions("python-flint", "symengine", "sympy")


def installed_versions(*libraries: str) -> dict[str, str]:
    """The versions of those libraries that are installed."""
    from importlib.metadata import PackageNotFoundError, version

    found: dict[str, str] = {}
    for library in libraries:
        with suppress(PackageNotFoundError):
            found[library] = version(library)
    return found
