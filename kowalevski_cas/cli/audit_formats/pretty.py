"""An audit for a reader at a terminal."""

from __future__ import annotations

import sys
from collections import Counter
from collections.abc import Mapping

from kowalevski_cas.audit.audit import Audit
from kowalevski_cas.audit.audited import Audited
from kowalevski_cas.cli import plain
from kowalevski_cas.cli.audit_formats import located, said
from kowalevski_cas.notation import Vocabulary
from kowalevski_cas.verify.outcome import Correction, Counterexample, Outcome

MARKS = {
    "proved": ("✓", "32"),
    "conditional": ("◐", "36"),
    "given": ("·", "2"),
    "new": ("·", "2"),
    "refuted": ("✗", "31"),
    "suspect": ("✗", "31"),
    "missing": ("✗", "31"),
}
"""Mark and colour; everything else is a question."""

WIDEST = 90


def render(audit: Audit) -> str:
    """The formulas by line, what is wrong with its evidence, statements in words, a summary."""
    colour = sys.stdout.isatty()
    lines = [f"{audit.source.path}, by the derivation {audit.session.derivation.name}", ""]
    vocabulary = audit.session.texts.vocabulary
    lines += [_line(formula, vocabulary, colour) for formula in audit.formulas]
    lines += _wrong(audit)
    lines += _restrictions(audit)
    lines += _statements(audit, colour)
    lines += [f"line {line}: {words}" for line, words in audit.notes]
    lines += ["", _summary(audit)]
    return "\n".join(lines) + "\n"


def _head(verdict: str, colour: bool) -> str:
    mark, code = MARKS.get(verdict, ("?", "33"))
    head = f"{mark} {verdict:<11}"
    return f"\x1b[{code}m{head}\x1b[0m" if colour else head


def _line(formula: Audited, vocabulary: Vocabulary, colour: bool) -> str:
    line = f"{formula.line:>5}" if formula.line else "    -"
    notes = " (moved)" if formula.moved else ""
    head = _head(formula.verdict, colour)
    text = _short(_printed(formula, vocabulary))
    return f"{line}  {formula.id:<20} {head} {formula.role:<12} {text}{notes}"


def _printed(formula: Audited, vocabulary: Vocabulary) -> str:
    if formula.formula is None:
        return plain.display(formula.tex, vocabulary)
    return plain.formulas((formula.formula,))


def _short(text: str) -> str:
    return text if len(text) <= WIDEST else f"{text[: WIDEST - 1]}…"


def _wrong(audit: Audit) -> list[str]:
    """Formulas to look at, and statements in words that are refuted."""
    lines = []
    vocabulary = audit.session.texts.vocabulary
    for index, formula in enumerate(audit.formulas):
        if formula.wrong:
            place = f"{audit.source.path}:{formula.line}"
            lines.append(f"  {place}: {formula.id} is {formula.verdict}")
            lines.append(f"    printed   {_printed(formula, vocabulary)}")
            if why := "; ".join(said(audit, index)):
                lines.append(f"    why       {plain.words(why, vocabulary)}")
            lines += _evidence(formula.correction, formula.counterexample, vocabulary)
    for outcome in audit.false:
        line = audit.lines.get(outcome.claim)
        place = f"{audit.source.path}:{line}: " if line else ""
        words = plain.words(outcome.words, vocabulary)
        lines.append(f"  {place}{outcome.claim} is refuted: {words}")
        if printed := plain.formulas(outcome.formulas, outcome.source):
            lines.append(f"    printed   {printed}")
        causes = audit.session.causes.get(outcome.claim, ())
        if causes:
            named = ", ".join(located(audit, cause.place) for cause in causes)
            lines.append(f"    why       because of {named}")
        lines += _evidence(outcome.correction, outcome.counterexample, vocabulary)
    return ["", "What is wrong", *lines] if lines else []


def _evidence(
    correction: Correction | None, against: Counterexample | None, vocabulary: Vocabulary
) -> list[str]:
    lines = []
    if correction is not None:
        where = "".join(f", where {plain.nonzero(c)}" for c in correction.conditions)
        shown = plain.formulas(correction.formulas)
        lines.append(f"    correct   {shown}   ({correction.verdict}{where})")
        lines.append(f"    that is   {plain.words(correction.words, vocabulary)}")
    return lines + ([] if against is None else plain.evidence(against, vocabulary))


def _restrictions(audit: Audit) -> list[str]:
    """Conditions under which a formula fails, with a point where it does."""
    lines: list[str] = []
    vocabulary = audit.session.texts.vocabulary
    for outcome in audit.outcomes.values():
        for condition in outcome.conditions:
            if condition.witness is not None:
                lines.append(f"  {outcome.claim}  {plain.needs(condition, vocabulary)}")
                lines += plain.evidence(condition.witness, vocabulary)
    return ["", "Conditions that are not stated", *lines] if lines else []


def _statements(audit: Audit, colour: bool) -> list[str]:
    lines = [_statement(outcome, audit, colour) for outcome in audit.statements]
    return ["", "Statements in words", *lines] if lines else []


def _statement(outcome: Outcome, audit: Audit, colour: bool) -> str:
    line, head = audit.lines.get(outcome.claim, ""), _head(str(outcome.verdict), colour)
    said = f"{outcome.words}: {outcome.message}" if outcome.message else outcome.words
    text = plain.words(said, audit.session.texts.vocabulary)
    return f"{line:>5}  {outcome.claim:<20} {head} {text}"


def _summary(audit: Audit) -> str:
    claims = Counter(str(outcome.verdict) for outcome in audit.outcomes.values())
    return (
        f"{len(audit.formulas)} formulas: {_counted(audit.counts)}\n"
        f"{len(audit.outcomes)} claims: {_counted(claims)}; {audit.seconds:.2f} s"
    )


def _counted(counts: Mapping[str, int]) -> str:
    return ", ".join(f"{count} {verdict}" for verdict, count in sorted(counts.items()))
