"""What a report says, before anything is said about how it looks.

A template of any format (LaTeX, and whatever comes later) renders a :class:`Report`. Texts are
plain, with mathematics between dollars; formulas are TeX as they came from the run.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import Final, TypeVar

from kowalevski_cas import __version__
from kowalevski_cas.proof.outcome import (
    Condition,
    Correction,
    Counterexample,
    Outcome,
    Run,
    Verdict,
)
from kowalevski_cas.report.graph import Picture, picture

T = TypeVar("T")

_ROW: Final = re.compile(r"(.+)\.(\d+)")
_NAMES: Final = {
    "flint": "FLINT",
    "symengine": "SymEngine",
    "sympy": "SymPy",
    "python-flint": "python-flint",
    "python": "Python",
}
_ALWAYS: Final = (Verdict.PROVED, Verdict.CONDITIONAL, Verdict.REFUTED)


@dataclass(frozen=True, slots=True)
class Evidence:
    """One thing to be said about one or more claims of a group.

    ``ids`` names the claims, and is empty where it holds for the whole group.
    """

    ids: tuple[str, ...]
    step: str | None = None
    displays: tuple[str, ...] = ()
    condition: Condition | None = None
    counterexample: Counterexample | None = None
    values: tuple[Values, ...] = ()
    correction: Correction | None = None
    message: str = ""
    disagreement: tuple[tuple[str, Verdict], ...] = ()

    @property
    def kind(self) -> str:
        """The name of the field that is filled."""
        kinds = ("step", "condition", "counterexample", "correction", "disagreement")
        return next((kind for kind in kinds if getattr(self, kind)), "message")


@dataclass(frozen=True, slots=True)
class Values:
    """The two values at one point, and the claims (none if there is one only) that have them."""

    ids: tuple[str, ...]
    left: str
    right: str


@dataclass(frozen=True, slots=True)
class Group:
    """A claim, or the rows of one display, with what is to be said about them."""

    name: str
    rows: tuple[Outcome, ...]
    words: str
    evidence: tuple[Evidence, ...]


@dataclass(frozen=True, slots=True)
class Section:
    """A section of the paper: its groups in order, and how many claims have which verdict."""

    number: str
    title: str
    groups: tuple[Group, ...]
    counts: dict[Verdict, int]
    total: int


@dataclass(frozen=True, slots=True)
class Proviso:
    """A condition that the paper does not state, and the claims that need it."""

    condition: Condition
    ids: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Report:
    """Everything a template needs."""

    run: Run
    version: str
    verdict: tuple[str, str]
    verdicts: tuple[Verdict, ...]
    sections: tuple[Section, ...]
    counts: dict[Verdict, int]
    errata: tuple[Outcome, ...]
    provisos: tuple[Proviso, ...]
    picture: Picture
    arithmetics: tuple[str, ...]
    products: int
    by_verdict: dict[Verdict, tuple[str, ...]] = field(default_factory=dict)


def report(run: Run) -> Report:
    """Arrange a run for its readers."""
    present = {outcome.verdict for outcome in run.outcomes}
    return Report(
        run=run,
        version=__version__,
        verdict=(_first_sentence(run), _second_sentence(run)),
        verdicts=tuple(v for v in Verdict if v in _ALWAYS or v in present),
        sections=_sections(run),
        counts=_count(run.outcomes),
        errata=tuple(
            o for o in run.outcomes if o.verdict is Verdict.REFUTED or o.correction is not None
        ),
        provisos=_provisos(run.outcomes),
        picture=picture(run.outcomes),
        arithmetics=tuple(_NAMES.get(a, a) for a in run.arithmetics),
        products=sum(outcome.products for outcome in run.outcomes),
        by_verdict={
            verdict: tuple(o.claim for o in run.outcomes if o.verdict is verdict)
            for verdict in Verdict
        },
    )


# ------------------------------------------------------------------- sentences


def listed(items: Sequence[str], last: str = "and") -> str:
    """A list in words.

    >>> listed(["one", "two", "three"])
    'one, two and three'
    """
    return f" {last} ".join(filter(None, [", ".join(items[:-1]), *items[-1:]]))


def number(count: int) -> str:
    """A number in words, as far as they are shorter."""
    names = "no one two three four five six seven eight nine ten eleven twelve".split()
    return names[count] if count < len(names) else str(count)


def _are(count: int) -> str:
    return f"{count} is" if count == 1 else f"{count} are"


def _first_sentence(run: Run) -> str:
    counts = _count(run.outcomes)
    total = len(run.outcomes)
    proved, conditional = counts[Verdict.PROVED], counts[Verdict.CONDITIONAL]
    refuted = counts[Verdict.REFUTED]
    if not total:
        return "Nothing was selected, so nothing is said."
    if proved == total:
        many = "The one statement is" if total == 1 else f"All {total} formulas and statements are"
        return f"{many} proved as printed."
    parts = [f"{_are(proved)} proved as printed"]
    if conditional:
        hold = "holds" if conditional == 1 else "hold"
        parts.append(f"{conditional} {hold} under a condition that is named here")
    if refuted:
        parts.append(f"{_are(refuted)} refuted by an exact point")
    for verdict, what in (
        (Verdict.PROBABLE, "established but for a named chance of error"),
        (Verdict.ENCLOSED, "established within a named radius"),
    ):
        if counts[verdict]:
            parts.append(f"{_are(counts[verdict])} {what}")
    if open_ := sum(counts[v] for v in (Verdict.UNDECIDED, Verdict.TIMEOUT, Verdict.ERROR)):
        parts.append(f"{_are(open_)} left undecided")
    return f"Of {total} formulas and statements, {listed(parts)}."


def _second_sentence(run: Run) -> str:
    refuted = [o for o in run.outcomes if o.verdict is Verdict.REFUTED]
    mended = sum(o.correction is not None and o.correction.verdict.green for o in refuted)
    names = listed([_NAMES.get(a, a) for a in run.arithmetics])
    decided = [o for o in run.outcomes if o.verdicts]
    agreed = [o for o in decided if len(set(o.verdicts.values())) == 1]
    if len(decided) > len(agreed):
        disputed = listed([o.claim for o in decided if o not in agreed])
        how = f"the arithmetics disagree about {disputed}"
    elif len(run.arithmetics) > 1:
        every = [o for o in agreed if set(o.verdicts) >= set(run.arithmetics)]
        if len(run.outcomes) == 1:
            what = "the verdict was"
        elif len(every) == len(run.outcomes):
            what = "every verdict was"
        else:
            what = f"{len(every)} of the verdicts {'was' if len(every) == 1 else 'were'}"
        how = f"{what} reached by each of {names} on its own, without a disagreement"
    else:
        how = f"the arithmetic is {names or 'exact'}"
    if not refuted:
        return how[0].upper() + how[1:] + "."
    if mended == len(refuted):
        which = "the refuted one" if len(refuted) == 1 else "each of the refuted ones"
    else:
        which = f"{mended or 'none'} of the {len(refuted)} refuted"
    return f"For {which} the nearest true statement was found and proved; {how}."


# --------------------------------------------------------------------- grouping


def _count(outcomes: Iterable[Outcome]) -> dict[Verdict, int]:
    counts = dict.fromkeys(Verdict, 0)
    for outcome in outcomes:
        counts[outcome.verdict] += 1
    return counts


def group_name(claim: str) -> str:
    """The display to which a claim belongs: ``eq10`` for ``eq10.3``; else the claim itself."""
    match = _ROW.fullmatch(claim)
    return match[1] if match else claim


def _sections(run: Run) -> tuple[Section, ...]:
    known = dict(run.sections)
    numbers = [number for number, _ in run.sections]
    numbers += [s for s in dict.fromkeys(o.section for o in run.outcomes) if s not in known]
    sections = []
    for number in numbers:
        outcomes = [o for o in run.outcomes if o.section == number]
        if outcomes:
            sections.append(
                Section(
                    number,
                    known.get(number, ""),
                    tuple(_groups(outcomes)),
                    _count(outcomes),
                    len(outcomes),
                )
            )
    return tuple(sections)


def _groups(outcomes: Sequence[Outcome]) -> Iterable[Group]:
    """Rows of one display that follow one another are one group."""
    runs: list[list[Outcome]] = []
    for outcome in outcomes:
        name = group_name(outcome.claim)
        if runs and name != outcome.claim and group_name(runs[-1][-1].claim) == name:
            runs[-1].append(outcome)
        else:
            runs.append([outcome])
    for rows in runs:
        name = group_name(rows[0].claim) if len(rows) > 1 else rows[0].claim
        words = {row.words for row in rows}
        yield Group(
            name,
            tuple(rows),
            words.pop() if len(words) == 1 else "",
            tuple(_evidence(rows)),
        )


def _evidence(rows: Sequence[Outcome]) -> Iterator[Evidence]:
    single = len(rows) == 1
    if single:
        for step in rows[0].steps:
            yield Evidence((), step=step.words, displays=(step.tex,) if step.tex else ())
    else:
        yield from _shared_steps(rows)
    for claims, conditions in _alike(rows, lambda row: row.conditions):
        yield from (Evidence(claims, condition=condition) for condition in conditions)
    yield from _counterexamples(rows)
    yield from _corrections(rows)
    for row in rows:
        ids = () if single else (row.claim,)
        if row.message:
            yield Evidence(ids, message=row.message)
        if len(set(row.verdicts.values())) > 1:
            named = tuple((_NAMES.get(a, a), verdict) for a, verdict in row.verdicts.items())
            yield Evidence(ids, disagreement=named)


def _alike(
    rows: Sequence[Outcome], what: Callable[[Outcome], T]
) -> Iterator[tuple[tuple[str, ...], T]]:
    """What rows have, each thing once, with the rows that have it (no names if all do)."""
    found: dict[str, tuple[T, list[str]]] = {}
    for row in rows:
        if thing := what(row):
            found.setdefault(repr(thing), (thing, []))[1].append(row.claim)
    for thing, claims in found.values():
        yield () if len(claims) == len(rows) else tuple(claims), thing


def _shared_steps(rows: Sequence[Outcome]) -> Iterator[Evidence]:
    """Each sentence once, with the displays of all the rows that it is about."""
    for words in dict.fromkeys(step.words for row in rows for step in row.steps):
        having = [row for row in rows if any(step.words == words for step in row.steps)]
        displays = [s.tex for row in having for s in row.steps if s.words == words and s.tex]
        yield Evidence(
            () if len(having) == len(rows) else tuple(row.claim for row in having),
            step=words,
            displays=tuple(dict.fromkeys(displays)),
        )


def _counterexamples(rows: Sequence[Outcome]) -> Iterator[Evidence]:
    """Each point once, with the values that the rows have there."""
    found: dict[str, list[tuple[str, Counterexample]]] = {}
    for row in rows:
        if (one := row.counterexample) is not None:
            found.setdefault(repr((one.point, one.words)), []).append((row.claim, one))
    for having in found.values():
        pairs: dict[tuple[str, str], list[str]] = {}
        for claim, one in having:
            pairs.setdefault((one.left, one.right), []).append(claim)
        values = tuple(
            Values(tuple(claims) if len(rows) > 1 else (), left, right)
            for (left, right), claims in pairs.items()
        )
        yield Evidence((), counterexample=having[0][1], values=values)


def _corrections(rows: Sequence[Outcome]) -> Iterator[Evidence]:
    """Corrections of the same kind together."""
    found: dict[str, list[tuple[str, Correction]]] = {}
    for row in rows:
        if (one := row.correction) is not None:
            key = repr((one.words, one.verdict, one.conditions))
            found.setdefault(key, []).append((row.claim, one))
    for having in found.values():
        yield Evidence(
            () if len(having) == len(rows) else tuple(claim for claim, _ in having),
            correction=having[0][1],
            displays=tuple(c.printed for _, c in having if c.printed),
        )


def _provisos(outcomes: Sequence[Outcome]) -> tuple[Proviso, ...]:
    found: dict[str, tuple[Condition, list[str]]] = {}
    for outcome in outcomes:
        if outcome.verdict is Verdict.CONDITIONAL:
            for condition in outcome.conditions:
                key = f"{condition.tex}\n{condition.words}"
                kept, ids = found.setdefault(key, (condition, []))
                ids.append(outcome.claim)
                if kept.witness is None and condition.witness is not None:
                    found[key] = (condition, ids)
    return tuple(Proviso(condition, tuple(ids)) for condition, ids in found.values())
