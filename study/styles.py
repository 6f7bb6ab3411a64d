"""How many formulas of documents with styles of their own can be read, and print back the same.

The styles that stand beside a document are found as ``audit`` finds them. What cannot be read is
counted by what is said of it.
"""

from __future__ import annotations

import argparse
import re
import sys
from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path

from kowalevski_cas.cli import run as run_command
from kowalevski_cas.cli.exits import AS_RECORDED, DIFFERENT
from kowalevski_cas.notation import NotationError, to_latex
from kowalevski_cas.notation.open import OpenParser
from kowalevski_cas.notation.reader import read
from kowalevski_cas.reading.statements import SourcePaper, read_statements
from kowalevski_cas.source.files import read_source

_OWN = re.compile(r"“[^”]*”|\\[A-Za-z]+|\$[^$]*\$|\b\w\b")
"""What a message says of one formula only."""


@dataclass
class Legibility:
    """The formulas of some documents: how many there are, can be read, and print back the same."""

    formulas: int = 0
    readable: int = 0
    statements: int = 0
    same: int = 0
    reasons: Counter[str] = field(default_factory=Counter)

    def add(self, other: Legibility) -> None:
        """Count other documents in."""
        self.formulas += other.formulas
        self.readable += other.readable
        self.statements += other.statements
        self.same += other.same
        self.reasons += other.reasons

    @property
    def line(self) -> str:
        """The counts in a line."""
        back = f"{self.same} of {self.statements} statements print back to the same"
        return f"{self.readable} of {self.formulas} formulas are read; {back}"


def legibility(path: Path) -> Legibility:
    """What can be read of a document."""
    paper = read_statements(read_source(path))
    found = Legibility()
    troubles: dict[int, str] = {}
    for item in paper.items:
        place = id(item.typed)
        troubles.setdefault(place, "")
        if item.formula is None:
            troubles[place] = troubles[place] or item.trouble
        else:
            found.statements += 1
            found.same += _prints_back(item.formula, paper)
    found.formulas = len(troubles)
    found.readable = sum(not trouble for trouble in troubles.values())
    found.reasons.update(_OWN.sub("…", trouble) for trouble in troubles.values() if trouble)
    return found


def _prints_back(formula: object, paper: SourcePaper) -> bool:
    """Whether what a formula prints reads back as the same."""
    try:
        return read(to_latex(formula), paper.words, OpenParser) == formula  # type: ignore[arg-type]
    except NotationError:
        return False


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The arguments of the command."""
    parser.add_argument("documents", nargs="+", type=Path, metavar="DOCUMENT.tex")
    parser.add_argument("-v", "--verbose", action="store_true", help="say why others are not")


def run(arguments: argparse.Namespace) -> int:
    """Run the command and return its exit code."""
    total = Legibility()
    for path in arguments.documents:
        found = legibility(path)
        print(f"{path.stem}: {found.line}", flush=True)
        total.add(found)
    print(f"all: {total.line}")
    if arguments.verbose:
        print("".join(f"  {count:5} {why}\n" for why, count in total.reasons.most_common()), end="")
    return AS_RECORDED if total.readable else DIFFERENT


if __name__ == "__main__":
    sys.exit(run_command("python -m study.styles", "study.styles", sys.argv[1:]))
