"""An audit for a reader at a terminal."""

from __future__ import annotations

import sys

from kowalevski_cas.audit.audit import Audit
from kowalevski_cas.audit.audited import Audited
from kowalevski_cas.cli.audit_formats import explained
from kowalevski_cas.cli.plain import plain
from kowalevski_cas.proof.outcome import Condition, Counterexample, Outcome

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
    lines += [_line(formula, colour) for formula in audit.formulas]
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


def _line(formula: Audited, colour: bool) -> str:
    line = f"{formula.line:>5}" if formula.line else "    -"
    text = _short(plain(formula.tex))
    notes = " (moved)" if formula.moved else ""
    head = _head(formula.verdict, colour)
    return f"{line}  {formula.id:<20} {head} {formula.role:<12} {text}{notes}"


def _short(text: str) -> str:
    return text if len(text) <= WIDEST else f"{text[: WIDEST - 1]}…"


def _wrong(audit: Audit) -> list[str]:
    lines = []
    for index, formula in enumerate(audit.formulas):
        if not formula.wrong:
            continue
        lines.append(f"  {audit.source.path}:{formula.line}: {formula.id} is {formula.verdict}")
        lines.append(f"    printed   {plain(formula.tex)}")
        why = explained(audit, index)
        if why:
            lines.append(f"    why       {plain(why)}")
        if formula.counterexample is not None:
            lines += _evidence(formula.counterexample)
    return ["", "What is wrong", *lines] if lines else []


def _evidence(found: Counterexample) -> list[str]:
    point = ", ".join(f"{plain(name)} = {plain(v)}" for name, v in found.point.values.items())
    words = f"  ({plain(found.words)})" if found.words else ""
    values = f"{plain(found.left)} against {plain(found.right)}"
    return [f"    values    {values}{words}", f"    at        {point}"]


def _restrictions(audit: Audit) -> list[str]:
    """Conditions under which a formula fails, with a point where it does."""
    lines: list[str] = []
    for outcome in audit.outcomes.values():
        for condition in outcome.conditions:
            if condition.witness is not None:
                lines.append(f"  {outcome.claim}  {_needs(condition)}")
                lines += _evidence(condition.witness)
    return ["", "Conditions that are not stated", *lines] if lines else []


def _needs(condition: Condition) -> str:
    return f"needs {plain(condition.tex)} ≠ 0: {plain(condition.words)}"


def _statements(audit: Audit, colour: bool) -> list[str]:
    lines = [_statement(outcome, colour) for outcome in audit.statements]
    return ["", "Statements in words", *lines] if lines else []


def _statement(outcome: Outcome, colour: bool) -> str:
    head = _head(str(outcome.verdict), colour)
    message = f": {plain(outcome.message)}" if outcome.message else ""
    return f"       {outcome.claim:<20} {head} {plain(outcome.words)}{message}"


def _summary(audit: Audit) -> str:
    counts = ", ".join(f"{count} {verdict}" for verdict, count in audit.counts.items())
    return f"{len(audit.formulas)} formulas: {counts}; {audit.seconds:.2f} s"
