"""An audit formula by formula, with counterexamples, at a terminal."""

from __future__ import annotations

from collections.abc import Iterator

from kowalevski_cas.audit.audit import Audit
from kowalevski_cas.audit.audited import GIVEN, MISSING, NEW, SUSPECT, UNREADABLE
from kowalevski_cas.cli import plain
from kowalevski_cas.cli.audit_formats.pretty import Told
from kowalevski_cas.verify.outcome import Verdict

_AS = {SUSPECT: Verdict.REFUTED, MISSING: Verdict.REFUTED, UNREADABLE: Verdict.ERROR}
"""The verdicts whose sign formulas have about which nothing is claimed."""


def render(audit: Audit) -> str:
    """All formulas by line, and the statements in words."""
    told = Told(audit, evidence=True)
    return told.told((*_formulas(audit), *_statements(told)))


def _formulas(audit: Audit) -> Iterator[str]:
    yield from ("", "Formulas")
    vocabulary = audit.session.texts.vocabulary
    for formula in audit.formulas:
        shown = plain.formulas(() if formula.formula is None else (formula.formula,), "")
        shown = shown or plain.display(formula.tex, vocabulary)
        line = f"{formula.line or '-':>5}  {formula.id:<20}"
        notes = f"{formula.role}{', moved' * formula.moved}: {shown}"
        yield from plain.wrapped(notes, f"{_sign(formula.verdict, line)} {formula.verdict:<11} ", 8)


def _statements(told: Told) -> Iterator[str]:
    audit = told.audit
    if audit.statements:
        yield from ("", "Statements in words")
    for one in audit.statements:
        line = f"{audit.lines.get(one.claim, '-'):>5}  {one.claim:<20}"
        words = f"{one.words}: {one.message}" if one.message else one.words
        head = f"{_sign(str(one.verdict), line)} {one.verdict:<11} "
        yield from plain.wrapped(plain.text(told.phrases.words(words)), head, 8)


def _sign(verdict: str, words: str) -> str:
    if verdict in (GIVEN, NEW):
        return f"·   {words}"
    return plain.sign(_AS[verdict] if verdict in _AS else Verdict(verdict), words)
