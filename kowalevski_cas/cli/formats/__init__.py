"""How results are printed: one file for each format."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path

from kowalevski_cas.verify.outcome import Run
from kowalevski_cas.verify.record import Difference

FORMATS = ("pretty", "json", "junit", "github")
"""The formats that are chosen by name; ``-v`` chooses :mod:`.verbose`."""

EXPLAINED = ("pretty", "verbose", "json")
"""The formats that say where a statement fails, and how it was decided."""


@dataclass(frozen=True)
class Result:
    """A run, and how it differs from the record (``None`` where there is no record)."""

    folder: Path
    run: Run
    differences: list[Difference] | None


def load_format(name: str) -> Callable[[Sequence[Result]], str]:
    """The function that turns results into text in this format."""
    render: Callable[[Sequence[Result]], str] = import_module(f"{__name__}.{name}").render
    return render


def locate(result: Result, claim: str) -> tuple[str, int]:
    """The file and line of a derivation where a claim is stated."""
    stem = f'"{claim.rsplit(".", 1)[0]}'
    for needle in (f'"{claim}"', stem):
        for path in sorted(result.folder.glob("*.py")):
            for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
                if needle in line:
                    return str(path), number
    return str(result.folder), 1
