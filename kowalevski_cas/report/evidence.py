"""What is to be said about the claims of a display: each thing once, with those that have it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from kowalevski_cas.notation import Formula
from kowalevski_cas.report.alike import alike
from kowalevski_cas.systems import title
from kowalevski_cas.verify.outcome import (
    Condition,
    Correction,
    Counterexample,
    Outcome,
    Step,
    Value,
    Verdict,
)


@dataclass(frozen=True)
class Evidence:
    """One thing to be said about one or more claims of a group.

    ``ids`` names the claims, and is empty where it holds for the whole group.
    """

    ids: tuple[str, ...]
    step: Step | None = None
    displays: tuple[Formula, ...] = ()
    conditions: tuple[Condition, ...] = ()
    counterexample: Counterexample | None = None
    values: tuple[Values, ...] = ()
    correction: Correction | None = None
    corrected: tuple[str, ...] = ()
    message: str = ""
    disagreement: tuple[tuple[str, Verdict], ...] = ()

    @property
    def kind(self) -> str:
        """The name of the field that is filled."""
        kinds = (
            "step", "conditions", "counterexample", "correction", "corrected", "disagreement"
        )  # fmt: skip
        return next((kind for kind in kinds if getattr(self, kind)), "message")


@dataclass(frozen=True)
class Values:
    """The two values at one point, and the claims (none if there is one only) that have them."""

    ids: tuple[str, ...]
    left: Value
    right: Value


def evidence(rows: Sequence[Outcome]) -> Iterator[Evidence]:
    """What is to be said about one claim, or about the rows of one display."""
    yield from _steps(rows)
    yield from _corrected(rows)
    yield from _conditions(rows)
    yield from _counterexamples(rows)
    yield from _corrections(rows)
    for row in rows:
        ids = (row.claim,) if len(rows) > 1 else ()
        if row.message:
            yield Evidence(ids, message=row.message)
        if len(set(row.verdicts.values())) > 1:
            named = tuple((title(name), verdict) for name, verdict in row.verdicts.items())
            yield Evidence(ids, disagreement=named)


def _steps(rows: Sequence[Outcome]) -> Iterator[Evidence]:
    """Each sentence once, with the displays of all the rows that it is about."""
    if len(rows) == 1:
        yield from (Evidence((), step=step, displays=step.formulas) for step in rows[0].steps)
        return
    steps = [(row.claim, step) for row in rows for step in row.steps]
    for claims, ones in alike(steps, lambda step: (step.words, step.point)):
        displays = dict.fromkeys(formula for step in ones for formula in step.formulas)
        yield Evidence(_unless_all(claims, rows), step=ones[0], displays=tuple(displays))


def _corrected(rows: Sequence[Outcome]) -> Iterator[Evidence]:
    """The corrections on which some of the rows rest, and not all."""
    having = [(row.claim, row.corrected) for row in rows if row.corrected]
    for claims, ones in alike(having):
        if _unless_all(claims, rows):
            yield Evidence(claims, corrected=ones[0])


def _conditions(rows: Sequence[Outcome]) -> Iterator[Evidence]:
    """Conditions once for the rows that have the same ones; those for the same reason together."""
    having = [(row.claim, row.conditions) for row in rows if row.conditions]
    for claims, (conditions, *_) in alike(having):
        reasons = [("", one) for one in conditions]
        for _, same in alike(reasons, lambda one: (one.words, one.witness)):
            yield Evidence(_unless_all(claims, rows), conditions=same)


def _counterexamples(rows: Sequence[Outcome]) -> Iterator[Evidence]:
    """Each point once, with the values that the rows have there."""
    having = [(row.claim, row.counterexample) for row in rows if row.counterexample]
    for claims, ones in alike(having, lambda one: (one.point, one.words)):
        sides = [(claim, (one.left, one.right)) for claim, one in zip(claims, ones, strict=True)]
        values = tuple(
            Values(same if len(rows) > 1 else (), *pair) for same, (pair, *_) in alike(sides)
        )
        yield Evidence((), counterexample=ones[0], values=values)


def _corrections(rows: Sequence[Outcome]) -> Iterator[Evidence]:
    """Corrections of the same kind together."""
    having = [(row.claim, row.correction) for row in rows if row.correction]
    for claims, ones in alike(having, lambda one: (one.words, one.verdict, one.conditions)):
        yield Evidence(
            _unless_all(claims, rows),
            correction=ones[0],
            displays=tuple(formula for one in ones for formula in one.formulas),
        )


def _unless_all(claims: Sequence[str], rows: Sequence[Outcome]) -> tuple[str, ...]:
    """The claims, each once; no names if they are all the rows there are."""
    ids = tuple(dict.fromkeys(claims))
    return () if len(ids) == len(rows) else ids
