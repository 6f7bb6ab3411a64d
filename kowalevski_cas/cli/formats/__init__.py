"""How results and audits are printed: a file for each format, with a function for either."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from typing import Any

from kowalevski_cas.report import Section
from kowalevski_cas.verify.outcome import Run
from kowalevski_cas.verify.record import Difference

FORMATS, OF_AUDITS = ("pretty", "json", "junit", "github"), ("pretty", "json", "sarif", "github")
"""The formats that are chosen by name; ``-v`` chooses :mod:`.verbose`."""


@dataclass(frozen=True)
class Result:
    """A run, and how it differs from the record, or from what is expected where there is none.

    ``paper`` has the outcomes in the order of the paper, ``lines`` the file and the line in which
    each claim is stated.
    """

    folder: Path
    run: Run
    paper: Sequence[Section]
    differences: list[Difference]
    recorded: bool
    lines: dict[str, tuple[str, int]]

    def line(self, claim: str) -> tuple[str, int]:
        """Where a claim is stated; of a recorded one that is gone, where all the others are."""
        file, line = self.lines.get(claim, (str(self.folder), 1))
        here = Path.cwd()
        return str(Path(file).relative_to(here) if Path(file).is_relative_to(here) else file), line


def load_format(name: str) -> Any:
    """The module of a format: ``render`` turns results into text, ``audited`` an audit."""
    return import_module(f"{__name__}.{name}")
