"""Results and audits for a reader at a terminal: the answer, what is wrong, and a summary."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

from kowalevski_cas.cli import plain
from kowalevski_cas.cli.formats import ComparedRun
from kowalevski_cas.library import MEND
from kowalevski_cas.notation import Formula, Vocabulary
from kowalevski_cas.report.document import Block, Equations, Paragraph
from kowalevski_cas.report.findings import Findings
from kowalevski_cas.report.marks import SPOILED, Shown
from kowalevski_cas.report.places import PaperSection, names, sections
from kowalevski_cas.report.results import main_results
from kowalevski_cas.report.sentences import Phrases
from kowalevski_cas.report.tally import tally, wrong_places
from kowalevski_cas.report.words import group_alike
from kowalevski_cas.verify.outcome import Correction, Counterexample, Outcome, Verdict

if TYPE_CHECKING:
    from kowalevski_cas.audit.audit import Audit
    from kowalevski_cas.audit.audited import Audited


SHORT = 120
"""Characters that are shown of a sentence."""


def render(results: Sequence[ComparedRun]) -> str:
    """Each derivation with what was found in it, each slip once; those with findings last."""
    shown = [render_result(result) for result in sorted(results, key=_worst)]
    if len(results) > 1:
        shown.append("".join(f"{line}\n" for line in _table(results)))
    return "\n".join(shown)


def _worst(result: ComparedRun) -> int:
    """How much a reader has to do about a derivation: nothing, to read, or to act."""
    if result.differences:
        return 2
    return int(not all(outcome.verdict.green for outcome in result.run.outcomes))


def _table(results: Sequence[ComparedRun]) -> Iterator[str]:
    """A line a derivation: how many claims have which verdict, and whether that is known."""
    width = max(len(result.run.derivation) for result in results)
    present = [v for v in Verdict if any(o.verdict is v for r in results for o in r.run.outcomes)]
    for result in sorted(results, key=_worst):
        counts = Counter(outcome.verdict for outcome in result.run.outcomes)
        cells = [f"{counts[v]:>5} {plain.sign(v)}" if counts[v] else " " * 10 for v in present]
        status = f"as {result.standard}" if not result.differences else "DIFFERENT"
        yield f"{result.run.derivation:<{width}}{''.join(cells)} {status}"


def render_result(result: ComparedRun, claims: Iterable[str] = ()) -> str:
    """A derivation; lines on its ``claims`` stand before the summary."""
    run, phrases = result.run, phrases_of(result)
    copied = any(section.copied for section in result.paper)
    findings = Findings(phrases, run.outcomes, copied, run.expected)
    read = f"Text read: {run.edition}" if run.edition else ""
    named = dict.fromkeys(filter(None, (run.author, run.title, run.source, read)))
    title = phrases.words("".join(f"{part.removesuffix('.')}. " for part in named))
    wrong = *plain.lines(findings.blocks()), *_errors(result), *claims
    return _page(plain.text(title), findings, run.main, wrong, _summary(result))


def _page(
    title: str,
    findings: Findings,
    main: Collection[str],
    wrong: Iterable[str],
    summary: Iterable[str],
) -> str:
    """The answer under a title, what is wrong, and a summary; the main results come first."""
    head = [*plain.wrap(title), ""]
    results = [*main_results(findings, main)]
    if results:
        head += [*plain.lines(results), *plain.lines(wrong_places(findings)), ""]
    return "\n".join((*head, *plain.wrap(tally(findings)), *wrong, "", *summary, ""))


def phrases_of(result: ComparedRun) -> Phrases:
    """How a report of the results would say it, where claims without a number have their ids."""
    return _phrases(result.run.vocabulary, result.paper)


def _phrases(vocabulary: Vocabulary, paper: Sequence[PaperSection]) -> Phrases:
    known = names(paper).items()
    printed = {claim: name for claim, name in known if name.number.startswith("(")}
    near = {
        claim: name._replace(number=claim)
        for claim, name in known
        if claim not in printed and name.near and name.several == 1
    }
    return Phrases(vocabulary, printed | near)


def _errors(result: ComparedRun) -> Iterator[str]:
    """Formulas that cannot be read, with the place where they stand."""
    wrong = [o for o in result.run.outcomes if o.verdict is Verdict.ERROR]
    if wrong:
        yield from ("", plain.bold("Errors"))
    for outcome in wrong:
        file, number = result.line(outcome.claim)
        first, *rest = outcome.message.splitlines()
        yield f"  {file}:{number}: {first}"
        yield from (f"    {line}" for line in rest)
    if wrong:
        yield f"  {MEND}"


def _summary(result: ComparedRun) -> Iterator[str]:
    run = result.run
    counts = Counter(o.verdict for o in run.outcomes)
    shown = ", ".join(f"{count} {verdict}" for verdict, count in counts.items())
    seconds = sum(sum(o.seconds.values()) for o in run.outcomes)
    claims, by = plain.many(len(run.outcomes), "claim"), ", ".join(run.arithmetics)
    checked = plain.many(len(run.certificates), "certificate")
    head = f"{claims}: {shown}; {by}; {checked} checked; {seconds:.2f} s"
    noun = result.standard
    if not result.differences:
        none = "; there is no record to compare with (`kowalevski-cas record`)"
        yield from plain.wrap(f"{head}; as\xa0{noun}{'' if result.recorded else none}")
    else:
        other = "THE\xa0RECORD" if result.recorded else "WHAT\xa0IS\xa0EXPECTED"
        yield from plain.wrap(f"{head}; DIFFERENT\xa0FROM\xa0{other}:")
        for difference in result.differences:
            yield f"  {difference.claim}: {noun} {difference.recorded}, found {difference.found}"


def audited(audit: Audit) -> str:
    """What is wrong, each slip once."""
    return AuditText(audit).render()


@dataclass
class AuditText:
    """An audit in words; ``evidence`` says whether counterexamples are shown beside corrections."""

    audit: Audit
    evidence: bool = False

    @cached_property
    def phrases(self) -> Phrases:
        """Phrases in the vocabulary of the source, with the numbers that a derivation knows."""
        interpretation, run = self.audit.session.interpretation, self.audit.run
        if self.audit.reading is not None:
            return Phrases(run.vocabulary, {})
        paper = sections(run, interpretation.derivation, interpretation.texts)
        return _phrases(run.vocabulary, paper)

    def render(self, details: Iterable[str] = ()) -> str:
        """The audit as text; details stand before the summary."""
        audit = self.audit
        run = audit.run
        findings = Findings(self.phrases, run.outcomes)
        if audit.reading is not None:
            from kowalevski_cas.cli.formats import reading  # a run has no audit

            head = *reading.answer(audit), *self.wrong(), *reading.rest(audit, self.phrases)
            return "\n".join((*head, *details, *self.uncovered(), "", *self.summary(), ""))
        source = f"{audit.source.path}, by the derivation {run.derivation}."
        notes = (f"line {line}: {words}" for line, words in audit.notes)
        wrong = *self.wrong(), *plain.lines(findings.hypotheses()), *details, *notes
        return _page(source, findings, run.main, wrong, self.summary())

    def wrong(self) -> Iterator[str]:
        """Formulas to look at, and statements in words that are refuted."""
        audit = self.audit
        if audit.wrong:
            yield from ("", plain.bold("What is wrong"))
        for ids, (first, *_) in group_alike(((f.id, f) for f in audit.formulas if f.wrong), _slip):
            why = "; ".join(audit.said(first))
            place = ":".join(map(str, filter(None, first.region[:2])))
            called = self.called(first, ids)
            named = "" if called == f"line {first.line}" else f"{called}: "  # the place says it
            place = f"{place}: {named}{first.verdict}"
            printed = () if first.formula is None else (first.formula,)
            yield from self._line_of(
                f"{place}, {why}" if why else place, printed, first.tex,
                (first.correction, *first.alternatives), first.counterexample,
                SPOILED if first.causes else Verdict.REFUTED,
            )  # fmt: skip
        for outcome in audit.false:
            yield from self._false(outcome)

    def called(self, formula: Audited, ids: Sequence[str]) -> str:
        """What formulas are called, of which the first is given."""
        if all(id in self.phrases.names for id in ids):
            return plain.text(self.phrases.found(ids))
        return ", ".join(ids) if len(ids) > 1 else self.audit.called(formula)

    def _false(self, outcome: Outcome) -> Iterator[str]:
        audit = self.audit
        region = audit.sentences.get(outcome.claim)
        place = f"{region.path}:{region.line}: " if region else ""
        why = ""
        if causes := audit.session.causes.places.get(outcome.claim, ()):
            named = ", ".join(audit.location(cause.place) for cause in causes)
            why = f"; because of {named}"
        yield from self._line_of(
            f"{place}{plain.text(self.phrases.found([outcome.claim]))}: refuted: "
            f"{outcome.words}{why}", outcome.formulas,
            outcome.source, (outcome.correction, *outcome.alternatives), outcome.counterexample,
            SPOILED if causes else Verdict.REFUTED,
        )  # fmt: skip

    def _line_of(
        self,
        head: str,
        printed: tuple[Formula, ...],
        source: str,
        corrections: Sequence[Correction | None],
        against: Counterexample | None,
        shown_as: Shown,
    ) -> Iterator[str]:
        said = self.phrases.words(head)
        correction, *others = corrections
        if correction is not None:
            said += self.phrases.words(
                f"{'; ' if correction.edit else '. Correct: '}{correction.words}"
            )
            if correction.conditions and not correction.edit:
                said += (", where ", *self.phrases.where(correction.conditions))
        yield from plain.wrap(plain.text((*said, ".")))
        shown: list[Block] = []
        if printed or source:
            shown.append(Equations(printed, source, shown_as))
        if correction is not None:
            valid = self.phrases.valid(correction.conditions) if correction.edit else ()
            shown.append(Equations(correction.formulas, verdict=correction.verdict, label=valid))
        for one in filter(None, others):
            shown.append(Paragraph(("Or: ", *self.phrases.words(one.words), ".")))
            valid = self.phrases.valid(one.conditions)
            shown.append(Equations(one.formulas, verdict=one.verdict, label=valid))
        if against is not None and (self.evidence or correction is None):
            shown.append(Paragraph(self.phrases.values(against)))
        yield from plain.lines(shown, 2)

    def uncovered(self) -> Iterator[str]:
        """What the text claims and no verdict covers; formulas once, with their lines."""
        listed = self.audit.uncovered
        if listed:
            yield from ("", plain.bold("What the text claims and no verdict covers"))
        lines: dict[str, list[str]] = {}
        for passage in listed:
            if passage.kind == "formula":
                lines.setdefault(passage.words, []).append(str(passage.line))
            else:
                said = plain.text(self.phrases.words(passage.read()))
                said = said if len(said) <= SHORT else f"{said[: SHORT - 1]}…"
                yield from plain.wrap(f"{passage.line} (“{passage.cue}”): {said}", "  ", 4)
        formulas = (f"{words} ({', '.join(places)})" for words, places in lines.items())
        yield from plain.wrap("; ".join(formulas)) if lines else ()

    def summary(self) -> Iterator[str]:
        """How many there are of each verdict."""
        audit = self.audit
        claims = Counter(str(outcome.verdict) for outcome in audit.outcomes.values())
        yield from plain.wrap(_count(len(audit.formulas), "formula", audit.counts))
        claimed = _count(len(audit.outcomes), "claim", claims)
        checked = plain.many(len(audit.certificates), "certificate")
        yield from plain.wrap(f"{claimed}; {checked} checked; {audit.seconds:.2f} s")


def _slip(formula: Audited) -> object:
    """What makes one slip of several changes: the same words in the same display."""
    if formula.correction is None or formula.place is None:
        return formula.id
    return formula.correction.words, formula.place.display.id


def _count(number: int, noun: str, counts: Mapping[str, int]) -> str:
    said = ", ".join(f"{count} {verdict}" for verdict, count in sorted(counts.items()))
    return f"{plain.many(number, noun)}: {said}" if said else plain.many(number, noun)
