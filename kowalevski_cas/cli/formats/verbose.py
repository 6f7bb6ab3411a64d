"""Results claim by claim, and audits formula by formula, with the evidence, at a terminal."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from kowalevski_cas.audit.audit import Audit
from kowalevski_cas.audit.audited import GIVEN, MISSING, NEW, SUSPECT, UNREADABLE
from kowalevski_cas.cli import plain
from kowalevski_cas.cli.formats import Result
from kowalevski_cas.cli.formats.pretty import Told, phrases_of, told
from kowalevski_cas.report.evidence import Evidence
from kowalevski_cas.report.sentences import Phrases
from kowalevski_cas.verify.outcome import Outcome, Verdict


def render(results: Sequence[Result]) -> str:
    """Each derivation with all its claims, section by section."""
    return "\n".join(told(result, _claims(result)) for result in results)


def _claims(result: Result) -> Iterator[str]:
    phrases = phrases_of(result)
    width = max((len(outcome.claim) for outcome in result.run.outcomes), default=0)
    for section in result.paper:
        yield from ("", *plain.wrapped(plain.text(phrases.title(section))))
        for outcome in section.outcomes:
            yield from _claim(outcome, phrases, width)


def _claim(outcome: Outcome, phrases: Phrases, width: int) -> Iterator[str]:
    """A line with the time that it took, and what a reader has to know of it."""
    time = f"{1000 * sum(outcome.seconds.values()):8.1f} ms"
    first = f"{plain.sign(outcome.verdict, f'{outcome.claim:<{width}}')} {time}  "
    yield from plain.wrapped("; ".join(_notes(outcome, phrases)), first, 4)
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


_AS = {SUSPECT: Verdict.REFUTED, MISSING: Verdict.REFUTED, UNREADABLE: Verdict.ERROR}
"""The verdicts whose sign formulas have about which nothing is claimed."""


def audited(audit: Audit) -> str:
    """All formulas by line, and the statements in words."""
    told = Told(audit, evidence=True)
    return told.told((*_formulas(audit), *_statements(told)))


def _formulas(audit: Audit) -> Iterator[str]:
    yield from ("", "Formulas")
    vocabulary = audit.session.texts.vocabulary
    width = max((len(formula.id) for formula in audit.formulas), default=0)
    for formula in audit.formulas:
        shown = plain.formulas(() if formula.formula is None else (formula.formula,), "")
        shown = shown or plain.display(formula.tex, vocabulary)
        line = f"{formula.line or '-':>5}  {formula.id:<{width}}"
        notes = f"{formula.role}{', moved' * formula.moved}: {shown}"
        yield from plain.wrapped(notes, f"{_sign(formula.verdict, line)} {formula.verdict:<11} ", 8)


def _statements(told: Told) -> Iterator[str]:
    audit = told.audit
    if audit.statements:
        yield from ("", "Statements in words")
    width = max((len(one.claim) for one in audit.statements), default=0)
    for one in audit.statements:
        line = f"{audit.lines.get(one.claim, '-'):>5}  {one.claim:<{width}}"
        words = f"{one.words}: {one.message}" if one.message else one.words
        head = f"{_sign(str(one.verdict), line)} {one.verdict:<11} "
        yield from plain.wrapped(plain.text(told.phrases.words(words)), head, 8)


def _sign(verdict: str, words: str) -> str:
    if verdict in (GIVEN, NEW):
        return f"·   {words}"
    return plain.sign(_AS[verdict] if verdict in _AS else Verdict(verdict), words)
