"""What is wrong in a paper: misprints, false statements, and hypotheses that are missing."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from types import MappingProxyType

from kowalevski_cas.notation import Derivative, Formula, Relation
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.report.compare import mark_differences, ratio_of_sides
from kowalevski_cas.report.document import (
    Block,
    Code,
    Equations,
    Heading,
    Judgement,
    Paragraph,
    Text,
)
from kowalevski_cas.report.sentences import Phrases
from kowalevski_cas.report.words import (
    capital,
    capitalise,
    count_in_words,
    group_alike,
    violates_no,
)
from kowalevski_cas.verify.outcome import FALSE_AS_READ, Condition, Correction, Outcome, Verdict

Slip = tuple[Outcome, ...]
"""The formulas that one slip of the pen has spoiled."""


class Findings:
    """What is wrong, each thing once.

    Args:
        phrases: the phrases in the paper's words.
        outcomes: what was decided.
        copied: whether the formulas are those of the print.
        expected: the verdicts that the derivation itself expects.
    """

    def __init__(
        self,
        phrases: Phrases,
        outcomes: Sequence[Outcome],
        copied: bool = True,
        expected: Mapping[str, str] = MappingProxyType({}),
    ) -> None:
        self.phrases, self.outcomes = phrases, outcomes
        self.copied, self.expected = copied, expected

    @cached_property
    def refuted(self) -> tuple[Outcome, ...]:
        """What is false as it is stated, though nobody expects it to be."""
        found = (o for o in self.outcomes if o.verdict is Verdict.REFUTED)
        return tuple(o for o in found if o not in self.denied)

    @cached_property
    def slips(self) -> tuple[Slip, ...]:
        """The misprints: the same change in rows of one display is one slip."""
        spoiled = [(o.claim, o) for o in self.refuted if o.correction and o.correction.edit]
        alike = (ones for _, ones in group_alike(spoiled, _slip))
        return tuple(tuple(sorted(ones, key=_has_others)) for ones in alike)

    @cached_property
    def false(self) -> tuple[Outcome, ...]:
        """What is false and no misprint."""
        return tuple(o for o in self.refuted if not (o.correction and o.correction.edit))

    @cached_property
    def denied(self) -> tuple[Outcome, ...]:
        """What is false as the derivation itself expects, or as its paper says."""
        found = (o for o in self.outcomes if o.verdict is Verdict.REFUTED)
        return tuple(o for o in found if self.expected.get(o.claim) == o.verdict)

    @property
    def denier(self) -> str:
        """Who knew that it is false, in words."""
        return "as the paper says" if self.copied else "as expected"

    @cached_property
    def lacking(self) -> tuple[Outcome, ...]:
        """What the paper claims, and fails at a point where its formulas make sense."""
        return tuple(o for o in self.outcomes if lacks(o) and not o.ours)

    @cached_property
    def missing(self) -> dict[Formula, list[tuple[str, Condition]]]:
        """The hypotheses that are missing, each with the claims that need it."""
        found: dict[Formula, list[tuple[str, Condition]]] = {}
        for outcome in self.lacking:
            for condition in outcome.conditions:
                if condition.witness:
                    found.setdefault(condition.expression, []).append((outcome.claim, condition))
        return found

    @property
    def singular(self) -> bool:
        """Whether a set is no manifold by its equations alone where a hypothesis is missing."""
        needed = (one for several in self.missing.values() for one in several)
        return any(condition.singular for _, condition in needed)

    @cached_property
    def open(self) -> tuple[Outcome, ...]:
        """What is neither proved nor refuted, though it can be read."""
        undecided = (Verdict.UNDECIDED, Verdict.TIMEOUT)
        return tuple(o for o in self.outcomes if o.verdict in undecided)

    def blocks(self) -> Iterator[Block]:
        """What is wrong, for a reader who has half a minute."""
        if self.slips:
            yield Heading((capital(count_in_words(len(self.slips), "misprint")),), "misprints", 2)
            yield from map(self._misprint, self.slips)
        if self.false:
            many = count_in_words(len(self.false), "false statement")
            yield Heading((capital(many),), "false", 2)
            yield from map(self._falsehood, self.false)
        yield from self.hypotheses()
        if self.denied:
            many = count_in_words(len(self.denied), "statement")
            verb = "is" if len(self.denied) == 1 else "are"
            yield Heading((f"{capital(many)} that {verb} false, {self.denier}",), "denied", 2)
            yield from map(self._falsehood, self.denied)
        if self.open:
            many = count_in_words(len(self.open), "open statement")
            yield Heading((capital(many),), "open", 2)
            if any(outcome.message.startswith(FALSE_AS_READ) for outcome in self.open):
                yield Paragraph((_AS_READ,), "note")
            yield from map(self._not_decided, self.open)

    def _not_decided(self, outcome: Outcome) -> Judgement:
        """What is neither proved nor refuted: how it was read, and why it is open."""
        where = self.phrases.links([outcome.claim])
        head: Text = (*where, ": ", *self.phrases.sentence(outcome.message))
        if outcome.words:
            head = (*where, ", read as: ", *self.phrases.words(outcome.words), ".")
        shown: list[Block] = []
        late = outcome.verdict is Verdict.TIMEOUT
        more: Text = (" A longer ", Code("--timeout"), " may decide it.") if late else ()
        if outcome.source:
            shown.append(Equations(outcome.formulas, outcome.source))
        if outcome.words and outcome.message:
            shown.append(Paragraph(self.phrases.sentence(outcome.message) + more))
        if outcome.counterexample:
            shown.append(Paragraph(self.why(outcome), "note"))
        return Judgement(outcome.verdict, "", head, blocks=tuple(shown))

    def hypotheses(self) -> Iterator[Block]:
        """What the paper does not say and a statement needs, each condition once."""
        if self.missing:
            many = count_in_words(len(self.missing), "missing hypothesis", "missing hypotheses")
            yield Heading((capital(many),), "hypotheses", 2)
            for needing in self.missing.values():
                reasons = group_alike(needing, lambda condition: condition.words)
                said = (b for claims, (one, *_) in reasons for b in self._reason(claims, one))
                head: Text = ("We need ", *violates_no(needing[0][1]), ".")
                yield Judgement(Verdict.CONDITIONAL, "", head, blocks=tuple(said))

    def _misprint(self, slip: Slip) -> Judgement:
        first, correction = slip[0], slip[0].correction
        assert correction is not None
        where = capitalise(self.phrases.slip(slip))
        valid = self.phrases.valid(correction.conditions)
        words = self.phrases.words(correction.words)
        head: Text = (*where, ": ", *words, *((", ", *valid) if valid else ()), ".")
        if correction.blamed:
            spoiled = [o.claim for o in self.outcomes if _is_spoiled(o, correction.printed)]
            failing = self.phrases.links(spoiled)
            head = (*head, " Because of it ", *failing, f" fail{'s' * (len(spoiled) == 1)}.")
        printed, meant = mark_differences(correction.blamed or first.formulas, correction.formulas)
        source = "" if correction.blamed else first.source
        shown: list[Block] = [
            Equations(printed, source, first.verdict, wrong=True),
            Equations(meant, verdict=correction.verdict),
        ]
        for other in filter(lambda other: _says_else(first, other), first.alternatives):
            shown.append(Paragraph(("Or: ", *self.phrases.words(other.words), ".")))
            valid = self.phrases.valid(other.conditions)
            shown.append(Equations(other.formulas, verdict=other.verdict, label=valid))
        if correction.others:
            kept = self.phrases.links(correction.others)
            shown.append(Paragraph((*kept, _KEPT if len(correction.others) == 1 else _ALL_KEPT)))
        if first.counterexample:
            failing = self._failing(first) if correction.blamed else ()
            shown.append(Paragraph((*failing, *self.why(first)), "note"))
        return Judgement(None, "", head, blocks=tuple(shown))

    def _failing(self, outcome: Outcome) -> Text:
        """That a statement fails by a misprint in another formula, and what it says."""
        named = self.phrases.links([outcome.claim])
        shown = (", ", *outcome.formulas, ",") if len(outcome.formulas) == 1 else ()
        return (*capitalise(named), *shown, " fails with the print. ")

    def why(self, refuted: Outcome) -> Text:
        """The two values at a point, and what the one side is of the other where this is short."""
        found, correction = refuted.counterexample, refuted.correction
        said = self.phrases.values(found, _is_rate(refuted)) if found else ()
        if found is None or found.words or correction is None or correction.blamed:
            return said
        ratio = ratio_of_sides(refuted.formulas, correction.formulas)
        if ratio is None:
            return said
        return (*said, " The left side is always ", ratio, " times the right side.")

    def _falsehood(self, outcome: Outcome) -> Judgement:
        where = capitalise(self.phrases.found([outcome.claim]))
        head: Text = (*where, ": ", *self.phrases.sentence(outcome.words))
        shown: list[Block] = []
        if outcome.source and not {*outcome.formulas} <= {*head}:
            shown.append(Equations(outcome.formulas, outcome.source))
        if outcome.counterexample:
            shown.append(Paragraph(self.phrases.values(outcome.counterexample)))
        elif outcome.message:
            shown.append(Paragraph(self.phrases.sentence(outcome.message)))
        correction = outcome.correction
        if outcome in self.denied:
            return Judgement(outcome.verdict, "", head, blocks=tuple(shown))
        if correction is None:
            head = (*head, " No true statement was found near it.")
            return Judgement(outcome.verdict, "", head, blocks=tuple(shown))
        head = (*head, *self.phrases.correct(correction))
        return Judgement(outcome.verdict, "", head, blocks=tuple(shown))

    def _reason(self, claims: Sequence[str], condition: Condition) -> Iterator[Paragraph]:
        """What some claims say, what happens without the hypothesis, and a point where it does."""
        said: Text = ()
        for outcome in self.lacking:
            if outcome.claim in claims:
                said = (*said, *self.phrases.link(outcome.claim, outcome.words), " ")
        yield Paragraph((*said, *self.phrases.sentence(condition.words)))
        if condition.witness is not None:
            yield Paragraph(self.phrases.values(condition.witness), "note")


_AS_READ = (
    "What is “false as it was read” fails at the point that is given, as this program has read it. "
    "It may be wrong, or be meant otherwise: it has no verdict. A comment in the source can say "
    "how it is meant, as the documentation shows."
)

_KEPT = " stands on it as well, and is true with either."
_ALL_KEPT = " stand on it as well, and are true with either."


def _says_else(outcome: Outcome, other: Correction) -> bool:
    """Whether an alternative to the correction says something else, and is still open.

    True identities with one left side have one right side, however it is printed.
    """
    correction, denied = outcome.correction, outcome.counterexample
    assert correction is not None
    if correction.accepted:
        return False
    edits = [
        candidate.edit
        for candidate in (correction, other)
        if candidate.edit and not candidate.blamed
    ]
    same_left = len(edits) == 2 and not any(edit.path[:1] == (0,) for edit in edits)
    return not (same_left and denied is not None and not denied.words)


def _slip(outcome: Outcome) -> object:
    """What makes one slip of several changes: the same words in the same display."""
    correction = outcome.correction
    assert correction is not None
    return correction.words, correction.printed and correction.printed.display.id


def _is_spoiled(outcome: Outcome, place: Printed | None) -> bool:
    """Whether a claim is among those that fail because of what is printed at another place."""
    correction = outcome.correction
    if correction is None or not correction.blamed:
        return False
    return place in (correction.printed, *correction.besides)


def _has_others(outcome: Outcome) -> bool:
    """Whether a claim that a slip has spoiled needs other corrections as well."""
    return bool(outcome.correction and outcome.correction.besides)


def _is_rate(outcome: Outcome) -> bool:
    """Whether a derivative along the motion stands on the left of a claim."""
    match outcome.formulas:
        case (Relation((left, *_)),):
            return any(isinstance(one, Derivative) for one in left.nodes())
    return False


def lacks(outcome: Outcome) -> bool:
    """Whether a point denies the statement where one of its conditions is violated."""
    return any(condition.witness for condition in outcome.conditions)
