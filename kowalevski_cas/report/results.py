"""Whether the main results of a paper stand: for a reader who reads one paragraph."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from typing import Final

from kowalevski_cas.notation import Formula, to_plain
from kowalevski_cas.report.document import Block, Judgement, Paragraph, Sign, Text
from kowalevski_cas.report.findings import Findings
from kowalevski_cas.report.marks import MARKS, shown_as
from kowalevski_cas.report.sentences import Phrases
from kowalevski_cas.report.words import capital, capitalise, count_in_words, in_words, list_in_words
from kowalevski_cas.verify.outcome import Condition, Outcome, Verdict

LONG: Final = 60
"""The signs that conditions have at most where a reader has half a minute."""


def main_results(findings: Findings, main: Collection[str]) -> Iterator[Block]:
    """What the verdicts say of the main results, which misprints they rest on, and what is false.

    Nothing, if no claim that was decided is named as a main result.
    """
    results = [outcome for outcome in findings.outcomes if outcome.claim in main]
    if results:
        said = _fate([outcome.verdict for outcome in results])
        parts = said, *_reach(findings, results), *_falsehood(findings, results), *_sign(results)
        yield Paragraph(parts, "lead")
        yield from (_statement(findings.phrases, outcome) for outcome in results)


def _fate(verdicts: Sequence[Verdict]) -> str:
    """Whether the results stand, as a sentence."""
    green, refuted = sum(v.green for v in verdicts), verdicts.count(Verdict.REFUTED)
    many = len(verdicts)
    said = [
        (green, "stands", "stand"),
        (refuted, "fails", "fail"),
        (many - green - refuted, "is not decided", "are not decided"),
    ]
    for number, alone, several in said:
        if number == many:
            return f"The main result{f's {several}' if many > 1 else f' {alone}'}."
    parts = [f"{in_words(n)} {alone if n == 1 else several}" for n, alone, several in said if n]
    return f"Of {in_words(many)} main results {' and '.join(parts)}."


def _statement(phrases: Phrases, outcome: Outcome) -> Judgement:
    """A statement with its sign, where it holds, and a link to its place."""
    sufficient = _where(phrases, [one for one in outcome.conditions if not one.witness])
    lacking = [one for one in outcome.conditions if one.witness]
    needed = phrases.where(lacking)
    without = "the differentials of its equations are dependent somewhere"
    if not all(one.singular for one in lacking):
        without = "it is false"
    valid: Text = (
        (", where ", *sufficient, " (elsewhere nothing is proved here)") if sufficient else ()
    )
    if needed:
        valid += (", and " if sufficient else ", where ", *needed, f" (without which {without})")
    name, words = phrases.names.get(outcome.claim), outcome.words.rstrip(".")
    said: Text = (*phrases.links([outcome.claim]), ": ", *phrases.words(words))
    if name is not None and not name.number.startswith("("):  # its words say where it stands
        said = capitalise(phrases.words(words))
    return Judgement(shown_as(outcome), "", (*said, *valid, "."))


def _where(phrases: Phrases, conditions: Sequence[Condition]) -> Text:
    """What conditions say, if that is short."""
    where = phrases.where(conditions)
    if sum(len(to_plain(part)) for part in where if isinstance(part, Formula)) > LONG:
        return ("the denominators that are named there do not vanish",)
    return where


def _falsehood(findings: Findings, results: Sequence[Outcome]) -> Text:
    """How many other statements are false, though no misprint has spoiled them."""
    others = [outcome for outcome in findings.false if outcome not in results]
    if not others:
        return ()
    verb = "is" if len(others) == 1 else "are"
    return (f" {capital(count_in_words(len(others), 'other statement'))} {verb} false.",)


def _sign(results: Sequence[Outcome]) -> Text:
    """What the sign of a condition means, where it stands first."""
    if not any(outcome.verdict is Verdict.CONDITIONAL for outcome in results):
        return ()
    meaning = MARKS[Verdict.CONDITIONAL].meaning
    return (" The sign ", Sign(Verdict.CONDITIONAL), f" marks what {meaning}.")


def _reach(findings: Findings, results: Sequence[Outcome]) -> Text:
    """Which of the misprints the results rest on."""
    phrases, slips = findings.phrases, findings.slips
    touched = {*_correctors(findings.outcomes, results), *(outcome.claim for outcome in results)}
    reaching = [slip for slip in slips if any(outcome.claim in touched for outcome in slip)]
    it, they = ("it", "It rests") if len(results) == 1 else ("them", "They rest")
    several = "s" * (len(reaching) > 1)
    many = len(slips) - len(reaching)
    free = f"{'does' if many == 1 else 'do'} not touch {it}."
    if not reaching:
        which = "misprint" if many == 1 else f"{in_words(many)} misprints"
        return (f" The {which} {free}",) if slips else ()
    where = [phrases.found([outcome.claim for outcome in slip]) for slip in reaching]
    rest = f"; the other {count_in_words(many, 'misprint')} {free}" if many else "."
    of = f" {they} on the correction{several} of the misprint{several} "
    return (of, *list_in_words(where), rest)


def _correctors(outcomes: Sequence[Outcome], results: Sequence[Outcome]) -> set[str]:
    """The claims on whose corrections results rest, also by what they rest on."""
    by_id = {outcome.claim: outcome for outcome in outcomes}
    waiting, seen = [*results], set()
    while waiting:
        outcome = waiting.pop()
        if outcome.claim not in seen:
            seen.add(outcome.claim)
            waiting += [by_id[id] for id in outcome.rests_on if id in by_id]
    return {id for claim in seen for id in by_id[claim].corrected}
