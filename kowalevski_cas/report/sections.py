"""The claims in the order of the paper: its sections, and in them the displays."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from kowalevski_cas.notation import Formula
from kowalevski_cas.report.evidence import Evidence, evidence
from kowalevski_cas.report.names import display_of
from kowalevski_cas.verify.outcome import Outcome, Run, Verdict


@dataclass(frozen=True)
class Group:
    """A claim, or the rows of one display, with what is to be said about them.

    ``corrected`` names the claims whose corrections all the rows rest on.
    """

    name: str
    rows: tuple[Outcome, ...]
    words: str
    corrected: tuple[str, ...]
    evidence: tuple[Evidence, ...]


@dataclass(frozen=True)
class Section:
    """A section of the paper: its groups in order, and how many claims have which verdict."""

    number: str
    title: str
    groups: tuple[Group, ...]
    counts: dict[Verdict, int]
    total: int
    granted: tuple[Formula, ...]
    """What the scenes of the section suppose not to vanish."""
    branches: tuple[Formula, ...]
    """The equations by which they choose one of the two values of a root."""


def sections(run: Run) -> tuple[Section, ...]:
    """The sections that have claims; one that was not announced comes last."""
    titles = dict(run.sections)
    by_number: dict[str, list[Outcome]] = {number: [] for number in titles}
    for outcome in run.outcomes:
        by_number.setdefault(outcome.section, []).append(outcome)
    return tuple(
        Section(
            number,
            titles.get(number, ""),
            tuple(_groups(outcomes)),
            count(outcomes),
            len(outcomes),
            tuple(dict.fromkeys(f for outcome in outcomes for f in outcome.granted)),
            tuple(dict.fromkeys(f for outcome in outcomes for f in outcome.branches)),
        )
        for number, outcomes in by_number.items()
        if outcomes
    )


def _groups(outcomes: Sequence[Outcome]) -> Iterable[Group]:
    """Rows of one display that follow one another are one group."""
    runs: list[list[Outcome]] = []
    for outcome in outcomes:
        name = display_of(outcome.claim)
        if runs and name != outcome.claim and display_of(runs[-1][-1].claim) == name:
            runs[-1].append(outcome)
        else:
            runs.append([outcome])
    for rows in runs:
        name = display_of(rows[0].claim) if len(rows) > 1 else rows[0].claim
        words, corrected = {row.words for row in rows}, {row.corrected for row in rows}
        yield Group(
            name,
            tuple(rows),
            words.pop() if len(words) == 1 else "",
            corrected.pop() if len(corrected) == 1 else (),
            tuple(evidence(rows)),
        )


def count(outcomes: Iterable[Outcome]) -> dict[Verdict, int]:
    """How many outcomes have which verdict."""
    counts = dict.fromkeys(Verdict, 0)
    for outcome in outcomes:
        counts[outcome.verdict] += 1
    return counts
