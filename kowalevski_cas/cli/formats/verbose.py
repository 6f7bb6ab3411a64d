"""Results claim by claim, and audits formula by formula, with the evidence, at a terminal."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from kowalevski_cas.audit.audit import Audit
from kowalevski_cas.audit.audited import GIVEN, MISSING, NEW, OPEN, SUSPECT, UNREADABLE
from kowalevski_cas.cli import plain
from kowalevski_cas.cli.formats import ComparedRun
from kowalevski_cas.cli.formats.pretty import AuditText, phrases_of, render_result
from kowalevski_cas.report.evidence import Evidence
from kowalevski_cas.report.sentences import Phrases
from kowalevski_cas.verify.outcome import Outcome, Verdict


def render(results: Sequence[ComparedRun]) -> str:
    """Each derivation with all its claims, section by section."""
    return "\n".join(render_result(result, _claims(result)) for result in results)


def _claims(result: ComparedRun) -> Iterator[str]:
    phrases = phrases_of(result)
    width = max((len(outcome.claim) for outcome in result.run.outcomes), default=0)
    for section in result.paper:
        yield from ("", *map(plain.bold, plain.wrap(plain.text(phrases.title(section)))))
        for outcome in section.outcomes:
            yield from _claim(outcome, phrases, width)


def _claim(outcome: Outcome, phrases: Phrases, width: int) -> Iterator[str]:
    """A line with the time that it took, and what a reader has to know of it."""
    time = f"{1000 * sum(outcome.seconds.values()):8.1f} ms"
    first = f"{plain.sign(outcome.verdict, f'{outcome.claim:<{width}}')} {time}  "
    yield from plain.wrap("; ".join(_notes(outcome, phrases)), first, 4)
    yield from (f"        {line}" for line in outcome.stack.splitlines())
    if outcome.verdict is not Verdict.ERROR:
        yield from plain.lines(Evidence(phrases, (outcome,)).first(), 8)


def _notes(outcome: Outcome, phrases: Phrases) -> Iterator[str]:
    """What a verdict depends on."""
    yield str(outcome.verdict)
    where = [c for c in outcome.conditions if c.witness is None]
    if where:
        yield plain.text(("valid for ", *phrases.where(where)))
    if outcome.branches:
        yield f"with {plain.formulas(outcome.branches)}"
    if outcome.corrected:
        yield f"with the correction of {', '.join(outcome.corrected)}"
    if outcome.chance is not None:
        yield f"wrong with probability below {outcome.chance:.0e}"
    if outcome.radius is not None:
        yield f"within {outcome.radius:.0e}"


_AS = {
    SUSPECT: Verdict.REFUTED,
    MISSING: Verdict.REFUTED,
    UNREADABLE: Verdict.ERROR,
    OPEN: Verdict.UNDECIDED,
}
"""The verdicts whose sign formulas have about which nothing is claimed."""


def audited(audit: Audit) -> str:
    """All formulas by line, and the statements in words."""
    told = AuditText(audit, evidence=True)
    return told.render((*_formulas(audit), *_statements(told)))


def _formulas(audit: Audit) -> Iterator[str]:
    yield from ("", plain.bold("Formulas"))
    vocabulary = audit.session.interpretation.texts.vocabulary
    width = max((len(formula.id) for formula in audit.formulas), default=0)
    for formula in audit.formulas:
        shown = plain.formulas(() if formula.formula is None else (formula.formula,), "")
        shown = shown or plain.display(formula.tex, vocabulary)
        line = f"{formula.line or '-':>5}  {formula.id:<{width}}"
        notes = f"{formula.role}{', moved' * formula.moved}: {shown}"
        yield from plain.wrap(notes, f"{_sign(formula.verdict, line)} {formula.verdict:<11} ", 8)


def _statements(told: AuditText) -> Iterator[str]:
    audit = told.audit
    if audit.statements:
        yield from ("", plain.bold("Statements in words"))
    width = max((len(statement.claim) for statement in audit.statements), default=0)
    for outcome in audit.statements:
        region = audit.sentences.get(outcome.claim)
        line = f"{region.line if region else '-':>5}  {outcome.claim:<{width}}"
        words = f"{outcome.words}: {outcome.message}" if outcome.message else outcome.words
        head = f"{_sign(str(outcome.verdict), line)} {outcome.verdict:<11} "
        yield from plain.wrap(plain.text(told.phrases.words(words)), head, 8)


def _sign(verdict: str, words: str) -> str:
    if verdict in (GIVEN, NEW):
        return f"·   {words}"
    return plain.sign(_AS[verdict] if verdict in _AS else Verdict(verdict), words)
