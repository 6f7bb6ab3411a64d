"""How results and audits are printed: a file for each format, with a function for either."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from importlib import import_module
from pathlib import Path
from typing import Any

from kowalevski_cas.algebra import POINTS
from kowalevski_cas.cli.exits import AS_RECORDED, DIFFERENT, DISAGREEMENT, UNDECIDED, USAGE
from kowalevski_cas.paper.derivation import Derivation
from kowalevski_cas.paper.texts import Texts
from kowalevski_cas.report.places import PaperSection, sections
from kowalevski_cas.verify.outcome import Run, Verdict
from kowalevski_cas.verify.outcome_writer import disagreement
from kowalevski_cas.verify.record import Difference

FORMATS = ("pretty", "json", "junit", "sarif", "github")
OF_AUDITS = ("pretty", "json", "sarif", "github")
"""The formats that are chosen by name; ``-v`` chooses :mod:`.verbose`."""


@dataclass(frozen=True)
class ComparedRun:
    """A run, and how it differs from the record, or from what is expected where there is none.

    ``texts`` are those in which the derivation was read.
    """

    folder: Path
    derivation: Derivation
    texts: Texts
    run: Run
    differences: Sequence[Difference] = ()
    recorded: bool = True

    @cached_property
    def paper(self) -> tuple[PaperSection, ...]:
        """The outcomes in the order of the paper."""
        return sections(self.run, self.derivation, self.texts)

    def line(self, claim: str) -> tuple[str, int]:
        """Where a claim is stated; of a recorded one that is gone, where all the others are."""
        file, line = self.derivation.lines.get(claim, (str(self.folder), 1))
        here = Path.cwd()
        return str(Path(file).relative_to(here) if Path(file).is_relative_to(here) else file), line

    @property
    def standard(self) -> str:
        """What the verdicts before those that are found are."""
        return "recorded" if self.recorded else "expected"

    @property
    def exit_code(self) -> int:
        """The exit code that the result asks for."""
        outcomes = self.run.outcomes
        if any(disagreement(o.verdicts) for o in outcomes):
            return DISAGREEMENT
        verdicts = {o.verdict for o in outcomes}
        if Verdict.ERROR in verdicts:
            return USAGE
        open_ones = {o.claim for o in outcomes if o.verdict in (Verdict.UNDECIDED, Verdict.TIMEOUT)}
        if any(difference.claim not in open_ones for difference in self.differences):
            return DIFFERENT
        screened = self.run.arithmetics[0] in POINTS
        # Some claims say what no point can show; a screening that saw nothing at all is no success.
        if Verdict.UNDECIDED in verdicts and not (screened and len(verdicts) > 1):
            return UNDECIDED
        if Verdict.TIMEOUT in verdicts:
            return UNDECIDED
        return DIFFERENT if self.differences else AS_RECORDED


def load_format(name: str) -> Any:
    """The module of a format: ``render`` turns results into text, ``audited`` an audit."""
    return import_module(f"{__name__}.{name}")
