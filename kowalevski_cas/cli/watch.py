"""A command that is done again whenever a file changes that it reads."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from time import sleep

from kowalevski_cas.cli.exits import INTERRUPTED

PAUSE = 0.5
"""Seconds between two looks at the files."""


def watch(once: Callable[[], tuple[int, Iterable[Path]]]) -> int:
    """The last exit code of a command that is done again with each change of its files.

    ``once`` does it, and says which files it has read. It ends with an interruption.
    """
    code = 0
    try:
        while True:
            code, files = once()
            if code == INTERRUPTED:
                return code
            read = _times(files)
            print(f"{len(read)} files are watched; Ctrl-C ends it", file=sys.stderr, flush=True)
            while _times(read) == read:
                sleep(PAUSE)
    except KeyboardInterrupt:
        return code


def _times(files: Iterable[Path]) -> Mapping[Path, int]:
    """When files were changed; 0 for what is not there."""
    return {path: path.stat().st_mtime_ns if path.exists() else 0 for path in files}
