"""What is wrong in a paper: misprints, false statements, and hypotheses that are missing."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property

from kowalevski_cas.notation import Formula
from kowalevski_cas.report.compare import mark_differences
from kowalevski_cas.report.document import (
    Block,
    Emphasis,
    Equations,
    Heading,
    Judgement,
    Paragraph,
    Text,
)
from kowalevski_cas.report.sentences import (
    Phrases,
    capital,
    capitalise,
    count_in_words,
    group_alike,
    in_words,
    nonzero,
)
from kowalevski_cas.verify.outcome import Condition, Correction, Outcome, Verdict

Slip = tuple[Outcome, ...]
"""The formulas that one slip of the pen has spoiled."""


class Findings:
    """What is wrong, each thing once; ``copied`` if the formulas are those of the print."""

    def __init__(self, phrases: Phrases, outcomes: Sequence[Outcome], copied: bool = True) -> None:
        self.phrases, self.outcomes, self.copied = phrases, outcomes, copied

    @cached_property
    def refuted(self) -> tuple[Outcome, ...]:
        """What is false as printed."""
        return tuple(o for o in self.outcomes if o.verdict is Verdict.REFUTED)

    @cached_property
    def slips(self) -> tuple[Slip, ...]:
        """The misprints: the same change in rows of one display is one slip."""
        spoiled = [(o.claim, o) for o in self.refuted if o.correction and o.correction.edit]
        return tuple(ones for _, ones in group_alike(spoiled, _slip))

    @cached_property
    def false(self) -> tuple[Outcome, ...]:
        """What is false and no misprint."""
        return tuple(o for o in self.refuted if not (o.correction and o.correction.edit))

    @cached_property
    def lacking(self) -> tuple[Outcome, ...]:
        """What the paper claims, and fails at a point where its formulas make sense."""
        return tuple(o for o in self.outcomes if _lacks(o) and not o.ours)

    @cached_property
    def missing(self) -> dict[Formula, list[tuple[str, Condition]]]:
        """The hypotheses that are missing, each with the claims that need it."""
        found: dict[Formula, list[tuple[str, Condition]]] = {}
        for outcome in self.lacking:
            for condition in outcome.conditions:
                if condition.witness:
                    found.setdefault(condition.expression, []).append((outcome.claim, condition))
        return found

    @cached_property
    def open(self) -> tuple[Outcome, ...]:
        """What is neither proved nor refuted, though it can be read."""
        undecided = (Verdict.UNDECIDED, Verdict.TIMEOUT)
        return tuple(o for o in self.outcomes if o.verdict in undecided)

    def lead(self) -> str:
        """What was found, in two sentences; of statements that are ours, in two more."""
        if not self.outcomes:
            return "Nothing was selected, so nothing is said."
        ours = [outcome for outcome in self.outcomes if outcome.ours]
        if len(ours) == len(self.outcomes):
            return self._tally(ours)
        said = [self._tally([outcome for outcome in self.outcomes if not outcome.ours])]
        if ours:
            said.append(self._tally(ours, " of our own"))
        return " ".join(said)

    def _tally(self, outcomes: Sequence[Outcome], whose: str = "") -> str:
        """How many of these hold, and how."""
        many = {v: sum(o.verdict is v for o in outcomes) for v in Verdict}
        lacking = sum(map(_lacks, outcomes))
        where = many[Verdict.CONDITIONAL] - lacking
        found = [
            (many[Verdict.PROVED], "as stated here" if whose or not self.copied else "as printed"),
            (where, f"where {'its' if where == 1 else 'their'} denominators do not vanish"),
            (lacking, "under a named condition" if whose else f"only under {self._hypotheses()}"),
        ]
        what = count_in_words(len(outcomes), "formula or statement", "formulas and statements")
        wrong = self._wrong(outcomes)
        if len(outcomes) == 1:
            said = [f"holds {how}" for n, how in found if n] + [f"is {how}" for _, how in wrong]
            return f"The only statement{whose} {said[0]}."
        for n, how in found:
            if n == len(outcomes):
                every = f"All {what}" if n > 2 else "Both statements"
                return f"{every}{whose} hold {how}."
        holds = [f"{in_words(n)} hold{'s' * (n == 1)} {how}" for n, how in found if n]
        fails = _joined([f"{in_words(n)} {'is' if n == 1 else 'are'} {how}" for n, how in wrong])
        more = f" {capital(fails)}." if fails else ""
        return f"Of {what}{whose}, {_joined(holds) or 'none is proved'}.{more}"

    def _hypotheses(self) -> str:
        """What is missing, and how many there are if there are several."""
        many = len(self.missing)
        if many == 1:
            return "a hypothesis that the paper does not state"
        return f"hypotheses that the paper does not state ({in_words(many)} in all)"

    def _wrong(self, outcomes: Sequence[Outcome]) -> list[tuple[int, str]]:
        """How many statements do not hold, or are open, and why."""
        slips = [slip for slip in self.slips if any(outcome in outcomes for outcome in slip)]
        spoiled = sum(len(slip) for slip in slips)
        false = sum(outcome in self.false for outcome in outcomes)
        open_ones = [
            (sum(outcome.verdict is verdict for outcome in outcomes), what)
            for verdict, what in _OPEN.items()
        ]
        by = f"spoiled by {count_in_words(len(slips), 'misprint')}"
        return [one for one in ((spoiled, by), (false, "false"), *open_ones) if one[0]]

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
        if self.open:
            many = count_in_words(len(self.open), "open statement")
            yield Heading((capital(many),), "open", 2)
            for outcome in self.open:
                where = self.phrases.links([outcome.claim])
                said = self.phrases.sentence(outcome.message)
                yield Judgement(outcome.verdict, "", (*where, ": ", *said))

    def hypotheses(self) -> Iterator[Block]:
        """What the paper does not say and a statement needs, each condition once."""
        if self.missing:
            many = count_in_words(len(self.missing), "missing hypothesis", "missing hypotheses")
            yield Heading((capital(many),), "hypotheses", 2)
            for expression, needing in self.missing.items():
                reasons = group_alike(needing, lambda condition: condition.words)
                said = tuple(self._reason(claims, one) for claims, (one, *_) in reasons)
                head: Text = ("We need ", nonzero(expression), ".")
                yield Judgement(Verdict.CONDITIONAL, "", head, blocks=said)

    def _misprint(self, slip: Slip) -> Judgement:
        first, correction = slip[0], slip[0].correction
        assert correction is not None
        where = capitalise(self.phrases.found([outcome.claim for outcome in slip]))
        fails = "fails" if len(slip) == 1 else "fail"
        why = f" {fails} because of another formula" if correction.blamed else ""
        head: Text = (*where, f"{why}: ", *self.phrases.words(correction.words), ".")
        printed, meant = mark_differences(correction.blamed or first.formulas, correction.formulas)
        source = "" if correction.blamed else first.source
        shown: list[Block] = [
            Equations(printed, source, first.verdict, wrong=True),
            Equations(meant, verdict=correction.verdict),
        ]
        for other in filter(lambda other: _says_else(first, other), first.alternatives):
            shown.append(Paragraph(("Or: ", *self.phrases.words(other.words), ".")))
            shown.append(Equations(other.formulas, verdict=other.verdict))
        if correction.others:
            shown.append(Paragraph((*self.phrases.links(correction.others), _KEPT)))
        if first.counterexample:
            shown.append(Paragraph(self.phrases.values(first.counterexample), "note"))
        return Judgement(None, "", head, blocks=tuple(shown))

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
        if correction is None:
            head = (*head, " No true statement was found near it.")
            return Judgement(outcome.verdict, "", head, blocks=tuple(shown))
        head = (*head, " ", Emphasis(("Correct:",)), " ", *self.phrases.words(correction.words))
        if correction.conditions:
            head = (*head, ", where ", *self.phrases.where(correction.conditions))
        return Judgement(outcome.verdict, "", (*head, "."), blocks=tuple(shown))

    def _reason(self, claims: Sequence[str], condition: Condition) -> Paragraph:
        """What some claims say, and what happens without the hypothesis."""
        said: Text = ()
        for outcome in self.lacking:
            if outcome.claim in claims:
                said = (*said, *self.phrases.link(outcome.claim, outcome.words), " ")
        return Paragraph((*said, *self.phrases.sentence(condition.words)))


_KEPT = " stand on it as well, and are true with either."

_OPEN = {
    Verdict.PROBABLE: "true but for a named chance of error",
    Verdict.ENCLOSED: "true within a named radius",
    Verdict.UNDECIDED: "undecided",
    Verdict.TIMEOUT: "not decided in the time allowed",
    Verdict.ERROR: "not decided, because something went wrong",
}


def _says_else(outcome: Outcome, other: Correction) -> bool:
    """Whether an alternative to the correction says something else, and is still open.

    True identities with one left side have one right side, however it is printed.
    """
    correction, denied = outcome.correction, outcome.counterexample
    assert correction is not None
    if correction.accepted:
        return False
    edits = [one.edit for one in (correction, other) if one.edit and not one.blamed]
    same_left = len(edits) == 2 and not any(edit.path[:1] == (0,) for edit in edits)
    return not (same_left and denied is not None and not denied.words)


def _lacks(outcome: Outcome) -> bool:
    """Whether a point denies the statement where one of its conditions is violated."""
    return any(condition.witness for condition in outcome.conditions)


def _joined(items: Sequence[str]) -> str:
    """Words as a list, which may have commas of their own."""
    return ", and ".join(filter(None, [", ".join(items[:-1]), *items[-1:]]))


def _slip(outcome: Outcome) -> object:
    """What makes one slip of several changes: the same words in the same display."""
    correction = outcome.correction
    assert correction is not None
    return correction.words, correction.printed and correction.printed.display.id
