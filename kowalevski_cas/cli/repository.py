"""The papers of a git repository, and those that were changed."""

from __future__ import annotations

import re
import subprocess
from collections.abc import Iterable
from pathlib import Path

from kowalevski_cas.cli.exits import CommandError
from kowalevski_cas.source.files import COMMENTS, read_source
from kowalevski_cas.source.text import SourceError

_CLASS = re.compile(rb"^[^%\n]*\\documentclass", re.MULTILINE)


def papers() -> list[Path]:
    """The files below this folder that git knows, or would add, and that begin a document."""
    listed = _git("ls-files", "-z", "--cached", "--others", "--exclude-standard", "--", "*.tex")
    paths = sorted({Path(name) for name in listed.split("\0") if name})
    return [path for path in paths if path.is_file() and _CLASS.search(path.read_bytes())]


def changed_since(commit: str, chosen: Iterable[Path]) -> list[Path]:
    """The papers that differ from a commit, in a file that they read or in their comments."""
    if commit.startswith("-"):
        raise CommandError(f"“{commit}” names no commit")
    if not commit.strip("0") or (commit == "HEAD" and not _git("rev-list", "--all", "-n1")):
        return [*chosen]  # git's name for what was before the first commit, of a branch or of all
    _git("rev-parse", "--verify", "--quiet", f"{commit}^{{commit}}")
    top = Path(_git("rev-parse", "--show-toplevel").removesuffix("\n"))
    listed = _git("diff", "-z", "--name-only", commit, "--")
    listed += _git(
        "ls-files", "-z", "--others", "--exclude-standard", "--full-name", "--", str(top)
    )
    changed = {(top / name).resolve() for name in listed.split("\0") if name}
    return [path for path in chosen if changed & {*map(Path.resolve, _files(path))}]


def _files(paper: Path) -> list[Path]:
    """The files of which a paper is made; of one that cannot be read, itself."""
    try:
        read = [Path(name) for name in read_source(paper).files]
    except SourceError:
        read = [paper]
    return [*read, paper.with_suffix(COMMENTS)]


def _git(*words: str) -> str:
    """What git prints."""
    try:
        done = subprocess.run(
            ["git", *words], capture_output=True, text=True, check=True, encoding="utf-8"
        )
    except FileNotFoundError:
        raise CommandError("git is needed here, or the papers by their names") from None
    except subprocess.CalledProcessError as error:
        said = error.stderr.strip() or f"there is no {words[-1]}"
        raise CommandError(f"git {words[0]}: {said}") from None
    return done.stdout
