"""What rests on what, as a section with a picture."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from textwrap import shorten
from typing import Final
from unicodedata import normalize

from kowalevski_cas.notation import Relation, print_prose, read_prose, to_plain
from kowalevski_cas.report.document import Block, Graph, Heading, Paragraph, Text
from kowalevski_cas.report.findings import Findings
from kowalevski_cas.report.graph import picture
from kowalevski_cas.report.sentences import Phrases
from kowalevski_cas.report.words import count_in_words
from kowalevski_cas.verify.outcome import Outcome, Verdict

_EDGES: Final = 6
"""How many lines a picture of what rests on what has at least."""

_CITED: Final = (
    "A broken line leads from what the paper cites to where it does, if no proof here needs it. "
)

_SHORT: Final = 26
"""How many letters stand in a box behind the number at most."""

_TYPED: Final = re.compile("[ -ʯΆ-Ͽᵢ-ᵥḀ-₟→∀-⊋]+")
"""What a font of a typewriter has, which boxes are written in: another one has other widths."""

_STYLED: Final = re.compile("[\U0001d400-\U0001d7ff]")
"""Letters in bold, or of another style, which that font has as plain ones."""

_FRAMES: Final = {
    Verdict.PROVED: "thin where a statement holds",
    Verdict.CONDITIONAL: "broken where it holds under a condition",
    Verdict.REFUTED: "heavy where it is false",
}


def graph(findings: Findings) -> Iterator[Block]:
    """What rests on what, where that is more than a few lines can say."""
    outcomes = findings.outcomes
    drawn = picture(outcomes, _labels(findings.phrases, outcomes))
    if sum(line.tip for line in drawn.lines) < _EDGES:
        return
    yield Heading(("What rests on what",), "section.picture")
    yield Paragraph(
        ("A line leads from each statement to those that rest on it; lines implied by others "
         f"are omitted. {_CITED * any(line.cited for line in drawn.lines)}The frame tells the "
         f"verdict: {_frames(outcomes)}. The formulas of one display share a box, which shows the "
         "worst verdict among them.",),
        leads=True,
    )  # fmt: skip
    yield Graph(drawn)
    said: Text = ("The equations of motion underlie everything and are not drawn.",)
    if findings.slips:
        said = (*said, " What rests on a misprinted formula starts from its corrected form.")
    if drawn.alone:
        many = count_in_words(len(drawn.alone), "statement")
        said = (*said, f" Omitted: {many} that neither rest on another nor carry one.")
    yield Paragraph(said, "note")


def _labels(phrases: Phrases, outcomes: Sequence[Outcome]) -> dict[str, str]:
    """A number and a name for each claim, and one for those of one number."""
    found: dict[str, str] = {}
    for outcome in outcomes:
        number = phrases.names[outcome.claim].number
        found.setdefault(number, f"{number} {_name(phrases, outcome)}".rstrip())
    return {o.claim: found[phrases.names[o.claim].number] for o in outcomes}


def _name(phrases: Phrases, outcome: Outcome) -> str:
    """What is stated, if that is short, or the beginning of it."""
    several = phrases.names[outcome.claim].several > 1
    said = [to_plain(f) for f in outcome.formulas if isinstance(f, Relation)]
    words = print_prose(read_prose(outcome.words, phrases.vocabulary), str, to_plain)
    first = [f"{word}, …" for word in said[:1]]
    for text in (*([] if several else [", ".join(said)]), *first, words):
        if _TYPED.fullmatch(text) and len(text) <= _SHORT:
            return text
    light = (_STYLED.sub(lambda m: normalize("NFKC", m[0]), text) for text in (words, *said))
    plain = (text for text in light if _TYPED.fullmatch(text))
    return next((shorten(text, _SHORT, placeholder=" …") for text in plain), "")


def _frames(outcomes: Sequence[Outcome]) -> str:
    """What the frames of the boxes mean, of those that are drawn."""
    verdicts = {outcome.verdict for outcome in outcomes}
    said = [words for verdict, words in _FRAMES.items() if verdict in verdicts]
    return ", ".join(said + ["dotted for the rest"] * (not verdicts <= {*_FRAMES}))
