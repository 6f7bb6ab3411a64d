"""An erratum: half a page for author and journal, of nothing but what is to be changed."""

from __future__ import annotations

from collections.abc import Iterator

from kowalevski_cas.report.compare import mark_differences
from kowalevski_cas.report.document import Block, Equations, Link, Paragraph, Text
from kowalevski_cas.report.findings import Findings
from kowalevski_cas.report.sentences import Phrases
from kowalevski_cas.report.words import capitalise
from kowalevski_cas.verify.outcome import Outcome, Verdict, in_latex


def erratum(findings: Findings) -> Iterator[Block]:
    """For each slip, and each false statement: what is printed, what to read, and why."""
    for block in _corrections(findings):
        yield (
            block._replace(text=_without_links(block.text))
            if isinstance(block, Paragraph)
            else block
        )


def erratum_tex(phrases: Phrases, outcome: Outcome) -> str:
    """What to print instead of a refuted statement, in a sentence of LaTeX; nothing if unknown."""
    correction = outcome.correction
    if outcome.verdict is not Verdict.REFUTED or correction is None:
        return ""
    where = "".join(map(str, _without_links(capitalise(phrases.slip((outcome,))))))
    if correction.edit is None:
        return f"{where}: it is false that {outcome.words}. Read: {correction.words}."
    printed, meant = in_latex(correction.blamed or outcome.formulas), in_latex(correction.formulas)
    return f"{where}: for ${printed}$ read ${meant}$."


def _without_links(text: Text) -> Text:
    """The text without links, which would lead to the report."""
    return tuple(
        part
        for inline in text
        for part in (_without_links(inline.text) if isinstance(inline, Link) else (inline,))
    )


def _corrections(findings: Findings) -> Iterator[Block]:
    for slip in findings.slips:
        first, correction = slip[0], slip[0].correction
        assert correction is not None
        where = capitalise(findings.phrases.slip(slip))
        printed, meant = mark_differences(correction.blamed or first.formulas, correction.formulas)
        yield Paragraph((*where, ", for"), leads=True)
        yield Equations(printed, "" if correction.blamed else first.source)
        yield Paragraph(("read",), leads=True)
        yield Equations(meant)
        yield from _because(findings, first)
    for outcome in findings.false:
        words = findings.phrases.sentence(outcome.words)
        said: Text = (*_place(findings.phrases, outcome), ": ", *words, " This is false.")
        if outcome.correction is not None:
            said = (*said, " Read: ", *findings.phrases.words(outcome.correction.words))
            if outcome.correction.conditions:
                said = (*said, ", where ", *findings.phrases.where(outcome.correction.conditions))
            said = (*said, ".")
        yield Paragraph(said)
        if outcome.source and not {*outcome.formulas} <= {*said}:
            yield Equations(outcome.formulas, outcome.source)
        yield from _because(findings, outcome)


def _place(phrases: Phrases, outcome: Outcome) -> Text:
    """Where the paper says something: by its own numbers, and not by those of the report."""
    name = phrases.names.get(outcome.claim)
    if name is None or name.near or name.number.startswith("("):
        return capitalise(phrases.found([outcome.claim]))
    return (f"Section {outcome.section}",)


def _because(findings: Findings, outcome: Outcome) -> Iterator[Block]:
    if outcome.counterexample:
        first, *others = findings.why(outcome)
        begins = f"Because {first[:1].lower()}{first[1:]}" if isinstance(first, str) else first
        yield Paragraph((begins, *others), "note")
