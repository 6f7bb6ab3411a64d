"""What an author has to look at in a paper, each at its place."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator
from hashlib import sha256

from kowalevski_cas.audit.audit import Audit
from kowalevski_cas.audit.audited import OPEN, Audited
from kowalevski_cas.audit.patch import repairs
from kowalevski_cas.reading import CLAIM
from kowalevski_cas.source.text import Region
from kowalevski_cas.source.tokens import words
from kowalevski_cas.verify.diagnostic import ERROR, NOTE, RULES, WARNING, Diagnostic, Replacement
from kowalevski_cas.verify.outcome import Outcome, Verdict


def diagnostics(audit: Audit) -> list[Diagnostic]:
    """All that an author has to look at, formulas first, and what is not judged."""
    fixes = _fixes(audit)
    found = [_of_formula(audit, formula, fixes.get(id(formula), ())) for formula in audit.formulas]
    found += [
        _of_statement(audit, statement)
        for statement in audit.statements
        if not statement.verdict.green
    ]
    return [*_with_fingerprints(diagnostic for diagnostic in found if diagnostic is not None)]


def _of_formula(
    audit: Audit, formula: Audited, fixes: tuple[Replacement, ...]
) -> tuple[Diagnostic, str] | None:
    message, rule, level = audit.explanation(formula), formula.verdict, WARNING
    if formula.wrong:
        level = ERROR
    elif formula.moved:
        rule = "moved"
    elif rule == OPEN and formula.role == CLAIM:
        level = NOTE
    elif rule not in (Verdict.UNDECIDED, Verdict.TIMEOUT):
        return None
    message = f"{rule}; {message}" if message else f"{rule}. {RULES[rule]}"
    told = Diagnostic(rule, level, formula.id, message, formula.region, fixes)
    return told, " ".join(words(formula.tex))


def _of_statement(audit: Audit, outcome: Outcome) -> tuple[Diagnostic, str]:
    region = audit.sentences.get(outcome.claim, Region(audit.source.path))
    level = ERROR if outcome in audit.false else WARNING
    message = f"{outcome.verdict}; {outcome.message or outcome.words}"
    told = Diagnostic(str(outcome.verdict), level, outcome.claim, message, region)
    return told, outcome.claim


def _with_fingerprints(found: Iterable[tuple[Diagnostic, str]]) -> Iterator[Diagnostic]:
    """The diagnostics with fingerprints; of several that are alike each has its own."""
    seen = Counter[tuple[str, str]]()
    for diagnostic, about in found:
        seen[diagnostic.rule, about] += 1
        text = "\n".join((diagnostic.rule, about, str(seen[diagnostic.rule, about])))
        yield diagnostic._replace(fingerprint=sha256(text.encode()).hexdigest()[:32])


def _fixes(audit: Audit) -> dict[int, tuple[Replacement, ...]]:
    """What mends a display, by the first of its formulas that is wrong."""
    found: dict[int, tuple[Replacement, ...]] = {}
    for place in audit.places:
        wrong = (f for f in audit.formulas if f.wrong and f.place)
        first = next((f for f in wrong if f.place and f.place.display == place.display), None)
        if first is not None:
            edits = sorted(repairs(audit, place).items())
            found[id(first)] = tuple(
                Replacement(audit.source.region(*interval), text) for interval, text in edits
            )
    return found
