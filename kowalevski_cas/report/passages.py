"""The paper in its order: each display, what is claimed of it, and what was found."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Final

from kowalevski_cas.notation import Formula, Relation
from kowalevski_cas.report.compare import mark_differences
from kowalevski_cas.report.document import (
    Block,
    Code,
    Emphasis,
    Equations,
    Heading,
    Judgement,
    Paragraph,
    Text,
    anchor,
)
from kowalevski_cas.report.erratum import erratum_tex
from kowalevski_cas.report.evidence import Evidence
from kowalevski_cas.report.findings import Findings
from kowalevski_cas.report.marks import MARKS, Shown, shown_as
from kowalevski_cas.report.places import ClaimGroup, PaperSection, ReportItem
from kowalevski_cas.report.witnesses import Witness
from kowalevski_cas.report.words import capital, capitalise, group_alike, list_in_words, supposed
from kowalevski_cas.tools import title
from kowalevski_cas.verify.outcome import Outcome, Verdict

_ROLES: Final = {
    "vector field": "Equations of motion",
    "definition": "Let",
    "unit": "Let",
    "condition": "Consider",
    "claim": "To be shown",
}


class Passages:
    """What is said about the parts of a paper, for those who read it from the beginning.

    Args:
        findings: what is wrong, in the paper's words.
        certified: the digests of the certificates that the checker accepts, by claim.
        programs: which programs confirm which certificates.
    """

    def __init__(
        self, findings: Findings, certified: Mapping[str, str], programs: Sequence[Witness]
    ) -> None:
        self.phrases, self.findings = findings.phrases, findings
        self.certified, self.programs = certified, programs
        self.resting: dict[str, list[str]] = {}
        for outcome in findings.outcomes:
            for claim in outcome.rests_on:
                self.resting.setdefault(claim, []).append(outcome.claim)

    def section(self, section: PaperSection) -> Iterator[Block]:
        """A section of the paper: what it assumes, and its displays and claims in their order."""
        name = self.phrases.title(section)
        yield Heading(name, f"section.{anchor(section.number)}")
        granted = dict.fromkeys(f for outcome in section.outcomes for f in outcome.granted)
        if granted:
            yield Paragraph(("We assume ", *supposed(granted), " throughout this section."))
        chosen = dict.fromkeys(f for outcome in section.outcomes for f in outcome.branches)
        if chosen:
            meant = list_in_words([(formula,) for formula in chosen])
            yield Paragraph(("Of the two values of a root we mean the one with ", *meant, "."))
        before = ""
        for item in section.items:
            what = "" if item.stated else capital(item.source) or _role(item)
            if what and what != before:
                yield Paragraph((*self.phrases.words(what), ":"), "note", leads=True)
            before = what
            yield from self.item(item)

    def item(self, item: ReportItem) -> Iterator[Block]:
        """A display, what is claimed of it, and what was found; or claims about no display."""
        if not item.stated:
            known = all(row.formulas for row in item.rows)
            formulas = tuple(formula for row in item.rows for formula in row.formulas if known)
            source = r",\quad ".join(row.source.strip(" ,") for row in item.rows)
            label = (item.label,) if item.label else ()
            yield Equations(formulas, source, label=label, anchor=item.anchor)
        for group in item.stated:
            yield self._several(group) if len(group.rows) > 1 else self._alone(group)

    def _several(self, stated: ClaimGroup) -> Judgement:
        """The formulas of a display, all or some of which are claimed."""
        outcomes = stated.outcomes
        words = dict.fromkeys(outcome.words for outcome in outcomes if outcome.words)
        where = {self._where(outcome) for outcome in outcomes}
        shown = []
        for row in stated.rows:
            own = row.outcome
            beside = [self.phrases.words(own.words)] if own and len(words) > 1 else []
            if own and own.spoiled:
                beside.append(("fails because of ", *self.phrases.spoilers(own)))
            if own and len(where) > 1 and self._where(own):
                beside.append(("valid for ", *self._where(own)))
            shown.append(
                Equations(
                    _slips(row.formulas, own),
                    row.source,
                    shown_as(own) if own else None,
                    list_in_words(beside, "; "),
                    f"claim.{anchor(own.claim)}" if own else "",
                    bool(own and shown_as(own) is Verdict.REFUTED),
                    erratum=erratum_tex(self.phrases, own) if own else "",
                )
            )
        head = self.phrases.sentence(*words) if len(words) == 1 else ()
        if len(where) == 1:
            head = (*head, *_valid(*where))
        return self._claim(None, "", head, stated.number, shown, outcomes)

    def _alone(self, stated: ClaimGroup) -> Judgement:
        """A single claim, with its formulas."""
        (row,), (outcome,) = stated.rows, stated.outcomes
        misprint = outcome.misprinted
        shown = []
        if row.formulas or row.source:
            sent = erratum_tex(self.phrases, outcome)
            formulas = _slips(row.formulas, outcome)
            shown = [Equations(formulas, row.source, wrong=misprint, erratum=sent)]
        head = (*self.phrases.sentence(outcome.words), *_valid(self._where(outcome)))
        if not self._where(outcome) and outcome.verdict not in (
            Verdict.PROVED,
            Verdict.CONDITIONAL,
        ):
            head = (*head, " ", Emphasis(self._word(outcome), strong=True))
        place = f"claim.{anchor(outcome.claim)}"
        return self._claim(shown_as(outcome), place, head, stated.number, shown, (outcome,))

    def _word(self, outcome: Outcome) -> Text:
        """The verdict as a sentence; of what another formula makes false, which one does."""
        if outcome.spoiled:
            return ("Fails because of ", *self.phrases.spoilers(outcome), ".")
        known = f", {self.findings.denier}" if outcome in self.findings.denied else ""
        return (f"{MARKS[outcome.verdict].word.capitalize()}{known}.",)

    def _where(self, outcome: Outcome) -> Text:
        """Where a statement holds, if its denominators say so."""
        return self.phrases.where(c for c in outcome.conditions if not c.witness)

    def _claim(
        self,
        verdict: Shown | None,
        place: str,
        head: Text,
        number: str,
        shown: Sequence[Equations],
        outcomes: Sequence[Outcome],
    ) -> Judgement:
        told = Evidence(self.phrases, outcomes)
        folded = (*told.steps(), *self._records(outcomes))
        return Judgement(verdict, place, head, (number,), (*shown, *told.first()), folded)

    def _records(self, outcomes: Sequence[Outcome]) -> Iterator[Paragraph]:
        """Who confirms claims, what they rest on, and what rests on them, each once."""
        here = {outcome.claim for outcome in outcomes}
        carried = dict.fromkeys(
            reason for o in outcomes for reason in self.resting.get(o.claim, ())
        )
        if others := [claim for claim in carried if claim not in here]:
            yield Paragraph(("What rests on it: ", *self.phrases.links(others), "."), "record")
        facts = [(outcome.claim, self._record(outcome)) for outcome in outcomes]
        for claims, (said, *_) in group_alike(facts):
            names: Text = list_in_words([(Code(claim),) for claim in claims])
            if not self.certified:  # no file has these names
                names = capitalise(self.phrases.links(claims))
            yield Paragraph((*names, ": ", *said, "."), "record")

    def _record(self, outcome: Outcome) -> Text:
        agreeing = [title(name) for name, v in outcome.verdicts.items() if v is outcome.verdict]
        text: Text = ("decided by ", *_names(agreeing)) if agreeing else ("not decided",)
        if outcome.claim in self.certified:
            also = [w.name for w in self.programs if outcome.claim in w.claims]
            text = (*text, "; the certificate is accepted by ", *_names(["the checker", *also]))
        if outcome.rests_on:
            text = (*text, "; rests on ", *self.phrases.links(outcome.rests_on))
        if outcome.corrected:
            corrected = self.phrases.links(outcome.corrected)
            text = (*text, "; read with the correction of ", *corrected)
        return text


def _role(item: ReportItem) -> str:
    """What a display is for that nobody claims where it stands."""
    equations = any(isinstance(f, Relation) for row in item.rows for f in row.formulas)
    return _ROLES.get(item.role if equations else "condition", "")


def _slips(formulas: tuple[Formula, ...], outcome: Outcome | None) -> tuple[Formula, ...]:
    """Formulas as printed, with marks on what the correction changes."""
    if outcome is None or outcome.correction is None or not outcome.misprinted:
        return formulas
    return mark_differences(formulas, outcome.correction.formulas)[0]


def _valid(where: Text) -> Text:
    return (" Valid for ", *where, ".") if where else ()


def _names(names: Sequence[str]) -> Text:
    return list_in_words([(name,) for name in names])
