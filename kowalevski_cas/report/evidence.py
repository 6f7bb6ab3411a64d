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
    Value,
    Verdict,
)


@dataclass(frozen=True)
class Evidence:
    """One thing to be said about one or more claims of a group.

    ``ids`` names the claims, and is empty where it holds for the whole group.
    """

    ids: tuple[str, ...]
    step: str | None = None
    displays: tuple[Formula, ...] = ()
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


@dataclass(frozen=True)
class Values:
    """The two values at one point, and the claims (none if there is one only) that have them."""

    ids: tuple[str, ...]
    left: Value
    right: Value


def evidence(rows: Sequence[Outcome]) -> Iterator[Evidence]:
    """What is to be said about one claim, or about the rows of one display."""
    yield from _steps(rows)
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
        for step in rows[0].steps:
            yield Evidence((), step=step.words, displays=step.formulas)
        return
    steps = [(row.claim, step) for row in rows for step in row.steps]
    for claims, shared in alike(steps, lambda step: step.words):
        yield Evidence(
            _unless_all(claims, rows),
            step=shared[0].words,
            displays=tuple(dict.fromkeys(f for step in shared for f in step.formulas)),
        )


def _conditions(rows: Sequence[Outcome]) -> Iterator[Evidence]:
    """Conditions once for the rows that have the same ones."""
    having = [(row.claim, row.conditions) for row in rows if row.conditions]
    for claims, (conditions, *_) in alike(having):
        ids = _unless_all(claims, rows)
        yield from (Evidence(ids, condition=condition) for condition in conditions)


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
