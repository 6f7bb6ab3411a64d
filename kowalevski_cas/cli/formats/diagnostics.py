"""What somebody has to look at in the result of a run."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from kowalevski_cas.cli.formats import ComparedRun
from kowalevski_cas.source.text import Region
from kowalevski_cas.verify.diagnostic import ERROR, NOTE, Diagnostic, Replacement
from kowalevski_cas.verify.outcome import Outcome, Verdict, in_latex


def diagnostics(result: ComparedRun) -> Iterator[Diagnostic]:
    """An error for each difference and all that is not decided, a note for what is refuted."""
    for change in result.differences:
        message = f"{result.standard}: {change.recorded}; found: {change.found}"
        yield _diagnostic(result, "different", ERROR, change.claim, message)
    for outcome in result.run.outcomes:
        rule = str(outcome.verdict)
        if outcome.verdict in (Verdict.ERROR, Verdict.UNDECIDED, Verdict.TIMEOUT):
            yield _diagnostic(result, rule, ERROR, outcome.claim, outcome.message)
        if outcome.verdict is Verdict.REFUTED:
            yield _diagnostic(result, rule, NOTE, outcome.claim, _of_refuted(outcome))


def from_json(value: Mapping[str, Any]) -> Diagnostic:
    """A diagnostic by what the JSON of an audit has of it."""
    fixes = tuple(Replacement(_region(fix), fix["text"]) for fix in value["fixes"])
    return Diagnostic(
        value["rule"], value["level"], value["id"], value["message"], _region(value), fixes,
        value["fingerprint"],
    )  # fmt: skip


def _region(value: Mapping[str, Any]) -> Region:
    numbers = (value[key] or 0 for key in ("line", "column", "end_line", "end_column"))
    return Region(value["file"], *numbers)


def _diagnostic(result: ComparedRun, rule: str, level: str, claim: str, message: str) -> Diagnostic:
    region = Region(*result.line(claim))
    fingerprint = f"{result.run.derivation}/{claim}/{rule}"
    return Diagnostic(rule, level, claim, message, region, fingerprint=fingerprint)


def _of_refuted(outcome: Outcome) -> str:
    """A misprint and what it should be; of what is false besides, what it says."""
    correction = outcome.correction
    if correction is not None and correction.edit is not None:
        wrong = in_latex(correction.blamed) or outcome.source
        return f"misprint: {wrong}\ncorrect: {in_latex(correction.formulas)}"
    said = ": ".join(filter(None, (outcome.words, outcome.source)))
    return f"false: {said}\ncorrect: {correction.words if correction else 'unknown'}"
