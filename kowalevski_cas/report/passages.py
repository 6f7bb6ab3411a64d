"""The paper in its order: each display, what is claimed of it, and what was found."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Final

from kowalevski_cas.notation import Formula
from kowalevski_cas.report.alike import alike
from kowalevski_cas.report.compare import compared
from kowalevski_cas.report.document import (
    Block,
    Claim,
    Code,
    Display,
    Emphasis,
    Heading,
    Paragraph,
    Text,
)
from kowalevski_cas.report.evidence import Evidence
from kowalevski_cas.report.marks import MARKS
from kowalevski_cas.report.names import anchor
from kowalevski_cas.report.places import Item, Section
from kowalevski_cas.report.sentences import Phrases, capital, listed, nonzero
from kowalevski_cas.report.witnesses import Witness
from kowalevski_cas.tools import title
from kowalevski_cas.verify.outcome import Outcome, Verdict

_ROLES: Final = {
    "vector field": "Equations of motion",
    "definition": "Notation",
    "unit": "Notation",
    "condition": "We consider",
}


class Passages:
    """What is said about the parts of a paper, for those who read it from the beginning.

    Args:
        phrases: the phrases in the paper's words.
        certified: the digests of the certificates that the checker accepts, by claim.
        programs: which programs confirm which certificates.
    """

    def __init__(
        self, phrases: Phrases, certified: Mapping[str, str], programs: Sequence[Witness]
    ) -> None:
        self.phrases, self.certified, self.programs = phrases, certified, programs

    def section(self, section: Section) -> Iterator[Block]:
        """A section of the paper: what it assumes, and its displays and claims in their order."""
        name = self.phrases.words(f"{section.number}. {section.title}")
        yield Heading(name, f"section.{anchor(section.number)}")
        granted = dict.fromkeys(f for outcome in section.outcomes for f in outcome.granted)
        if granted:
            assumed = listed([(nonzero(formula),) for formula in granted])
            yield Paragraph(("We assume ", *assumed, " throughout this section."))
        chosen = dict.fromkeys(f for outcome in section.outcomes for f in outcome.branches)
        if chosen:
            meant = listed([(formula,) for formula in chosen])
            yield Paragraph(("Of the two values of a root we mean the one with ", *meant, "."))
        before = ""
        for item in section.items:
            what = "" if item.all else capital(item.source) or _ROLES.get(item.role, "")
            if what and what != before:
                yield Paragraph((*self.phrases.words(what), ":"), "note", leads=True)
            before = what
            yield from self.item(item)

    def item(self, item: Item) -> Iterator[Block]:
        """A display, what is claimed of it, and what was found; or a claim about no display."""
        if not item.all:
            formulas = tuple(formula for row in item.rows for formula in row.formulas)
            label = (item.label,) if item.label else ()
            place = f"display.{anchor(item.display)}" if item.display else ""
            yield Display(formulas, item.rows[0].source, label=label, anchor=place)
            return
        together = [o for row in item.rows for o in row.outcomes[:1]]
        others = [o for row in item.rows for o in row.outcomes[1:]] + [*item.outcomes]
        if len(together) > 1 or (together and len(item.rows) > 1):
            yield self._rows(item, together)
        elif item.rows:
            lone = together or [others.pop(0)]
            yield self._alone(lone[0], item)
        for outcome in others:
            yield self._alone(outcome)

    def _rows(self, item: Item, outcomes: Sequence[Outcome]) -> Claim:
        """A display of several statements, some of which are claimed."""
        words = dict.fromkeys(outcome.words for outcome in outcomes if outcome.words)
        names = dict(item.names())
        shown = []
        for number, row in enumerate(item.rows, 1):
            own = row.outcomes[0] if row.outcomes else None
            label = names.get(own.claim, "") if own else f"{item.label[:-1]}.{number})"
            shown.append(
                Display(
                    _slips(row.formulas, own),
                    row.source,
                    own.verdict if own else None,
                    self._beside(own, label if item.label else ""),
                    f"claim.{anchor(own.claim)}" if own else "",
                    bool(own and own.verdict is Verdict.REFUTED),
                )
            )
        head = self.phrases.sentence("; ".join(words))
        return self._claim(None, "", head, (), shown, outcomes)

    def _beside(self, outcome: Outcome | None, label: str) -> Text:
        """What stands behind a row: where it holds, and its number."""
        if outcome is None:
            return (label,) if label else ()
        name: Text = (label,) if label else (Code(outcome.claim),)
        where = [c for c in outcome.conditions if not c.witness]
        return ("valid for ", *self.phrases.where(where), ": ", *name) if where else name

    def _alone(self, outcome: Outcome, item: Item | None = None) -> Claim:
        """A single claim, with its formula."""
        label: Text = (item.label,) if item and item.label else (Code(outcome.claim),)
        formulas = tuple(f for row in item.rows for f in row.formulas) if item else outcome.formulas
        source = item.rows[0].source if item else outcome.source
        misprint = outcome.correction is not None and outcome.correction.edit is not None
        shown = []
        if formulas or source:
            shown = [Display(_slips(formulas, outcome), source, wrong=misprint)]
        head = (*self.phrases.sentence(outcome.words), *self._verdict_of(outcome))
        place = f"claim.{anchor(outcome.claim)}"
        return self._claim(outcome.verdict, place, head, label, shown, (outcome,))

    def _verdict_of(self, outcome: Outcome) -> Text:
        """The verdict in words, where it is not that the claim holds as printed."""
        where = [c for c in outcome.conditions if not c.witness]
        if where:
            return (" Valid for ", *self.phrases.where(where), ".")
        if outcome.verdict in (Verdict.PROVED, Verdict.CONDITIONAL):
            return ()
        return (" ", Emphasis((f"{MARKS[outcome.verdict].word.capitalize()}.",), strong=True))

    def _claim(
        self,
        verdict: Verdict | None,
        place: str,
        head: Text,
        label: Text,
        shown: Sequence[Display],
        outcomes: Sequence[Outcome],
    ) -> Claim:
        told = Evidence(self.phrases, outcomes)
        folded = (*told.steps(), *self._records(outcomes))
        return Claim(verdict, place, head, label, (*shown, *told.first()), folded)

    def _records(self, outcomes: Sequence[Outcome]) -> Iterator[Paragraph]:
        """Who confirms claims, and what they rest on; what holds of several is said once."""
        facts = [(outcome.claim, self._record(outcome)) for outcome in outcomes]
        for claims, (said, *_) in alike(facts):
            names: Text = listed([(Code(claim),) for claim in claims])
            yield Paragraph((*names, ": ", *said, "."), "record")

    def _record(self, outcome: Outcome) -> Text:
        agreeing = [title(name) for name, v in outcome.verdicts.items() if v is outcome.verdict]
        text: Text = ("decided by ", *_names(agreeing))
        if outcome.claim in self.certified:
            also = [w.name for w in self.programs if outcome.claim in w.claims]
            text = (*text, "; the certificate is accepted by ", *_names(["the checker", *also]))
        if outcome.rests_on:
            text = (*text, "; rests on ", *self.phrases.links(outcome.rests_on))
        if outcome.corrected:
            corrected = self.phrases.links(outcome.corrected)
            text = (*text, "; read with the correction of ", *corrected)
        return text


def _slips(formulas: tuple[Formula, ...], outcome: Outcome | None) -> tuple[Formula, ...]:
    """Formulas as printed, with marks on what the correction changes."""
    if outcome is None or outcome.correction is None or outcome.correction.edit is None:
        return formulas
    return compared(formulas, outcome.correction.formulas)[0]


def _names(names: Sequence[str]) -> Text:
    return listed([(name,) for name in names])
