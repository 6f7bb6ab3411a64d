"""What was found, for a reader of the first lines: what is wrong where, and how many hold."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Final

from kowalevski_cas.notation import Formula, Relation, to_plain
from kowalevski_cas.report.document import Block, Emphasis, Inline, Judgement, Paragraph, Text
from kowalevski_cas.report.findings import Findings, Slip, lacks
from kowalevski_cas.report.sentences import Phrases
from kowalevski_cas.report.words import (
    capital,
    capitalise,
    count_in_words,
    in_words,
    list_in_words,
    violates_no,
)
from kowalevski_cas.verify.outcome import Outcome, Verdict

SHORT: Final = 30
"""The signs of a printed formula and its correction that are shown whole in the first lines."""

LONGEST: Final = 200
"""The signs of a point, and of what fails there, that are shown in the first lines."""

_OPEN: Final = {
    Verdict.PROBABLE: "true up to a stated probability of error",
    Verdict.ENCLOSED: "true within a named radius",
    Verdict.UNDECIDED: "undecided",
    Verdict.TIMEOUT: "not decided in the time allowed",
    Verdict.ERROR: "not decided, because something went wrong",
}


def wrong_places(findings: Findings) -> Iterator[Block]:
    """Where something is misprinted, what is false, and which hypotheses are missing."""
    phrases = findings.phrases
    if findings.slips:
        lead = Emphasis(("Misprinted.",), strong=True)
        yield Paragraph((lead, *_evidence(findings.slips)), leads=True)
        yield from (_misprint(phrases, slip) for slip in findings.slips)
    if findings.false:
        many = count_in_words(len(findings.false), "statement")
        verb = "is" if len(findings.false) == 1 else "are"
        lead = Emphasis((f"{capital(many)} {verb} false.",), strong=True)
        yield Paragraph((lead,), leads=True)
        yield from (_falsehood(phrases, outcome) for outcome in findings.false)
    if findings.missing:
        needed = [
            (*violates_no(needing[0][1]), " (for ", *phrases.links(id for id, _ in needing), ")")
            for needing in findings.missing.values()
        ]
        lead = Emphasis(("Not stated, though the proofs need it:",), strong=True)
        yield Paragraph((lead, " ", *list_in_words(needed), "."))


def _evidence(slips: Sequence[Slip]) -> Text:
    """What stands in brackets beside misprints, and that their corrections are proved."""
    corrections = [correction for (first, *_) in slips if (correction := first.correction)]
    said: Text = ()
    if any(first.counterexample for first, *_ in slips):
        said = (" In brackets: the two sides at a point, which is given with the formula below.",)
    if all(correction.verdict.green for correction in corrections):
        named = any(correction.conditions for correction in corrections)
        which = "The" if len(slips) == 1 else "Each"
        where = ", under the conditions that are named there" if named else ""
        said = (*said, f" {which} correction is proved{where}.")
    return said


def _misprint(phrases: Phrases, slip: Slip) -> Judgement:
    """Where a misprint stands, what to read, and the two values that show it."""
    first, correction = slip[0], slip[0].correction
    assert correction is not None
    where = phrases.slip(slip)
    read = phrases.words(correction.words)
    if not correction.blamed and _is_short([*first.formulas, *correction.formulas]):
        read = ("for ", *first.formulas, " read ", *correction.formulas)
    return Judgement(first.verdict, "", (*where, ": ", *read, *_values(phrases, first), "."))


def _values(phrases: Phrases, refuted: Outcome) -> Text:
    """The two sides at a point in brackets, or in short what else fails there."""
    found = refuted.counterexample
    if found is None:
        return ()
    if found.words:
        words = phrases.words(found.words)
        return (" (", *words, ")") if _length(words) <= LONGEST else ()
    if isinstance(found.left, Formula) and isinstance(found.right, Formula):
        return (" (", Relation((found.left, found.right), (r"\ne",)), ")")
    return (" (", found.left, " ≠ ", found.right, ")")


def _is_short(formulas: Sequence[Formula]) -> bool:
    """Whether a formula and what it should be are read faster than what was changed in it."""
    return len(formulas) == 2 and _length(formulas) <= SHORT


def _length(text: Sequence[Inline]) -> int:
    """How many signs a text without links has."""
    return sum(
        len(part if isinstance(part, str) else to_plain(part))
        for part in text
        if isinstance(part, str | Formula)
    )


def _falsehood(phrases: Phrases, outcome: Outcome) -> Judgement:
    """What is false, the point that shows it, and what is true in its place."""
    words, found = phrases.words(outcome.words.rstrip(".")), outcome.counterexample
    said = (*capitalise(phrases.found([outcome.claim])), *((": “", *words, "”") if words else ()))
    why = phrases.values(found._replace(defined=())) if found else ()
    if _length(why) > LONGEST:
        why = ()
    correct = phrases.correct(outcome.correction) if outcome.correction else ()
    return Judgement(outcome.verdict, "", (*said, ".", *((" ", *why) if why else ()), *correct))


def tally(findings: Findings) -> str:
    """How many statements hold, in two sentences; of those that are ours, in two more."""
    if not findings.outcomes:
        return "Nothing was selected, so nothing is said."
    ours = [outcome for outcome in findings.outcomes if outcome.ours]
    if len(ours) == len(findings.outcomes):
        return _tally(findings, ours)
    said = [_tally(findings, [outcome for outcome in findings.outcomes if not outcome.ours])]
    if ours:
        said.append(_tally(findings, ours, " of our own"))
    return " ".join(said)


def _tally(findings: Findings, outcomes: Sequence[Outcome], whose: str = "") -> str:
    """How many of these hold, and how."""
    many = {v: sum(o.verdict is v for o in outcomes) for v in Verdict}
    lacking = sum(map(lacks, outcomes))
    where = many[Verdict.CONDITIONAL] - lacking
    found = [
        (many[Verdict.PROVED], "as stated here" if whose or not findings.copied else "as printed"),
        (where, f"where {'its' if where == 1 else 'their'} denominators do not vanish"),
        (lacking, "under a named condition" if whose else f"only under {_hypotheses(findings)}"),
    ]
    what = count_in_words(len(outcomes), "formula or statement", "formulas and statements")
    wrong = _wrong(findings, outcomes)
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


def _hypotheses(findings: Findings) -> str:
    """What is missing, and how many there are if there are several."""
    many = len(findings.missing)
    if many == 1:
        return "a hypothesis that the paper does not state"
    return f"hypotheses that the paper does not state ({in_words(many)} in all)"


def _wrong(findings: Findings, outcomes: Sequence[Outcome]) -> list[tuple[int, str]]:
    """How many statements do not hold, or are open, and why."""
    slips = [slip for slip in findings.slips if any(outcome in outcomes for outcome in slip)]
    spoiled = sum(len(slip) for slip in slips)
    false = sum(outcome in findings.false for outcome in outcomes)
    denied = sum(outcome in findings.denied for outcome in outcomes)
    open_ones = [
        (sum(outcome.verdict is verdict for outcome in outcomes), what)
        for verdict, what in _OPEN.items()
    ]
    by = f"spoiled by {'a misprint' if len(slips) == 1 else count_in_words(len(slips), 'misprint')}"
    refuted = (spoiled, by), (false, "false"), (denied, f"false, {findings.denier}")
    return [one for one in (*refuted, *open_ones) if one[0]]


def _joined(items: Sequence[str]) -> str:
    """Words as a list, which may have commas of their own."""
    return ", and ".join(filter(None, [", ".join(items[:-1]), *items[-1:]]))
