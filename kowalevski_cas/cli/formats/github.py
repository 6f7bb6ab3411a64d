"""Results, and audits at the lines of their sources, as annotations of a GitHub workflow."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from kowalevski_cas.cli.formats import ComparedRun
from kowalevski_cas.verify.outcome import Outcome, Verdict, in_latex

if TYPE_CHECKING:
    from kowalevski_cas.audit.audit import Audit


def render(results: Sequence[ComparedRun]) -> str:
    """An error for each difference, a notice for each misprint and each false statement."""
    lines = []
    for result in results:
        for change in result.differences:
            place = result.line(change.claim)
            message = f"{result.standard}: {change.recorded}; found: {change.found}"
            lines.append(annotation("error", place, change.claim, message))
        for outcome in result.run.outcomes:
            place = result.line(outcome.claim)
            if outcome.verdict in (Verdict.ERROR, Verdict.UNDECIDED, Verdict.TIMEOUT):
                lines.append(annotation("error", place, outcome.claim, outcome.message))
            if outcome.verdict is Verdict.REFUTED:
                lines.append(annotation("notice", place, outcome.claim, _refuted(outcome)))
    return "".join(f"{line}\n" for line in lines)


def _refuted(outcome: Outcome) -> str:
    """A misprint and what it should be; of what is false besides, what it says."""
    correction = outcome.correction
    if correction is not None and correction.edit is not None:
        wrong = in_latex(correction.blamed) or outcome.source
        return f"misprint: {wrong}\ncorrect: {in_latex(correction.formulas)}"
    said = ": ".join(filter(None, (outcome.words, outcome.source)))
    return f"false: {said}\ncorrect: {correction.words if correction else 'unknown'}"


def audited(audit: Audit) -> str:
    """An error for what is wrong, a warning for what is not decided or moved."""
    lines = []
    for formula in audit.formulas:
        message = audit.explained(formula) or formula.verdict
        if formula.wrong:
            level = "error"
        elif formula.moved or formula.verdict in ("undecided", "timeout"):
            level = "warning"
            message = f"{message}; it has moved" if formula.moved else message
        else:
            continue
        place = audit.source.path, max(1, formula.line)
        lines.append(annotation(level, place, formula.id, f"{formula.verdict}: {message}"))
    for outcome in audit.statements:
        if not outcome.verdict.green:
            words = f"{outcome.verdict}: {outcome.message or outcome.words}"
            level = "error" if outcome in audit.false else "warning"
            place = audit.source.path, audit.lines.get(outcome.claim, 1)
            lines.append(annotation(level, place, outcome.claim, words))
    return "".join(f"{line}\n" for line in lines)


def annotation(level: str, place: tuple[str, int], title: str, message: str) -> str:
    """One workflow command, escaped as GitHub asks."""
    file, line = place
    text = message.replace("%", "%25").replace("\r", "%0D").replace("\n", "%0A")
    title = title.replace("%", "%25").replace(",", "%2C").replace(":", "%3A")
    return f"::{level} file={file},line={line},title={title}::{text}"
