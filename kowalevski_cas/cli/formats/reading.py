"""What stands at the head of an audit of a source that is its own derivation."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from typing import TYPE_CHECKING

from kowalevski_cas.audit.assumed import unchecked
from kowalevski_cas.audit.audited import OPEN
from kowalevski_cas.cli import plain
from kowalevski_cas.reading.counted import shown_numbers
from kowalevski_cas.report.document import Equations, Paragraph
from kowalevski_cas.report.sentences import Phrases
from kowalevski_cas.verify.outcome import Verdict

if TYPE_CHECKING:
    from kowalevski_cas.audit.audit import Audit
    from kowalevski_cas.audit.audited import Audited
    from kowalevski_cas.reading.statements import SourceStatement


_NO_LAW = ": no equations of motion are found"


def answer(audit: Audit) -> Iterator[str]:
    """By which equations of motion a source was read, and how many of its claims hold."""
    assert audit.reading is not None
    laws = audit.reading.parts.laws
    named = (f"{law.kind} {law.labels or f'of {_place(audit, law.first)}'}" for law in laws)
    equations = f", with {'; '.join(named)}" if laws else _NO_LAW
    numbers = audit.reading.paper.numbers
    counted = f" for {shown_numbers(numbers)}" if numbers else ""
    yield from plain.wrap(f"{audit.source.path}, read by itself{counted}{equations}.")
    yield ""
    verdicts = [outcome.verdict for outcome in audit.outcomes.values()]
    green = sum(verdict.green for verdict in verdicts)
    refuted = sum(verdict is Verdict.REFUTED for verdict in verdicts)
    unjudged = sum(formula.verdict == OPEN for formula in audit.formulas)
    parts = [
        (verdicts.count(Verdict.PROVED), "true"),
        (verdicts.count(Verdict.CONDITIONAL), "true where no denominator vanishes"),
        (refuted, "false"),
        (len(verdicts) - green - refuted, "not decided"),
    ]
    told = ", ".join(f"{count} {words}" for count, words in parts if count)
    claims = plain.many(len(verdicts), "claim")
    besides = f" Not judged: {plain.many(unjudged, 'formula')}." if unjudged else ""
    yield from plain.wrap(f"{claims}{': ' if told else ''}{told}.{besides}")
    yield from _comments(audit)


def rest(audit: Audit, phrases: Phrases) -> Iterator[str]:
    """What is assumed, what is not decided, and what is not judged."""
    yield from _assumptions(audit, phrases)
    yield from _doubts(audit, phrases)
    yield from _open(audit, phrases)
    if found := unchecked(audit):
        shown = ", ".join(dict.fromkeys(map(audit.called, found)))
        said = f"Definitions on which no verdict rests: {shown}."
        yield from ("", *plain.lines([Paragraph((said,))]))


def _comments(audit: Audit) -> Iterator[str]:
    """How many comments there are of each kind, and those that contradict what is inferred."""
    assert audit.reading is not None
    said = audit.reading.parts.said
    if not said.directives:
        return
    counts = Counter(directive.verb for directive in said.directives)
    counted = ", ".join(f"{number} {verb}" for verb, number in sorted(counts.items()))
    yield f"Comments are obeyed: {counted}."
    for formula in audit.reading.formulas:
        if formula.item in said.of and "; without it: " in formula.role.reason:
            yield from plain.wrap(f"{_place(audit, formula.item)}: {formula.role.reason}")


def _assumptions(audit: Audit, phrases: Phrases) -> Iterator[str]:
    from kowalevski_cas.audit.assumed import assumptions_of

    by_claim = {id: formula for formula in audit.formulas for id in formula.claims}
    listed = list[str]()
    for assumption in assumptions_of(audit):
        places = (audit.called(by_claim[id]) for id in assumption.claims if id in by_claim)
        resting = ", ".join(dict.fromkeys(places))
        if assumption.claims:
            listed.append(f"{assumption.words}; on it rest {resting}.")
    if listed:
        yield from ("", plain.bold("What is assumed"))
    for words in dict.fromkeys(listed):
        yield from plain.wrap(plain.text(phrases.words(words)), "  ", 4)


def _doubts(audit: Audit, phrases: Phrases) -> Iterator[str]:
    open_verdicts = (Verdict.UNDECIDED, Verdict.TIMEOUT)
    unclear = [f for f in audit.formulas if f.verdict in open_verdicts]
    in_words = [statement for statement in audit.statements if statement.verdict in open_verdicts]
    if unclear or in_words:
        yield from ("", plain.bold("What is not decided"))
    for formula in unclear:
        more = ". A longer --timeout may decide it" if formula.verdict == Verdict.TIMEOUT else ""
        words = phrases.words(f"{_where(audit, formula)}: {formula.message}{more}")
        yield from plain.wrap(plain.text(words))
        if formula.formula is not None:
            yield from plain.lines([Equations((formula.formula,), formula.tex)], 2)
        if formula.counterexample is not None:
            yield from plain.lines([Paragraph(phrases.values(formula.counterexample))], 2)
    for outcome in in_words:
        region = audit.sentences.get(outcome.claim)
        place = f"{region.path}:{region.line}" if region is not None else outcome.claim
        said = outcome.message or str(outcome.verdict)
        yield from plain.wrap(plain.text(phrases.words(f"{place}: {outcome.words}: {said}")))


def _open(audit: Audit, phrases: Phrases) -> Iterator[str]:
    unjudged = [formula for formula in audit.formulas if formula.verdict == OPEN]
    if unjudged:
        yield from ("", plain.bold("What is not judged"))
    told = (
        f"{_where(audit, one)}: {one.message.partition(chr(10))[0] or one.reason}"
        for one in unjudged
    )
    for words, many in Counter(told).items():
        several = f" ({many} formulas)" if many > 1 else ""
        yield from plain.wrap(plain.text(phrases.words(words + several)), "  ", 4)


def _place(audit: Audit, item: SourceStatement) -> str:
    """A statement by its label or its line."""
    assert audit.reading is not None
    paper, start = audit.reading.paper, item.typed.start
    begins, _ = paper.expanded.origin(start, start + 1)
    return item.printed.display.label or f"line {audit.source.line(begins)}"


def _where(audit: Audit, formula: Audited) -> str:
    place = f"{formula.region.path}:{formula.line}"
    return f"{place}: ({formula.label})" if formula.label else place
