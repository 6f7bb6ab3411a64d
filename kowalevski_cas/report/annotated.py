"""The author's paper with every formula where it stands, and its verdict beside it."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from hashlib import sha256
from itertools import count
from typing import Final

from kowalevski_cas.audit.assumed import assumptions_of, claims_of_numbers
from kowalevski_cas.audit.audit import Audit
from kowalevski_cas.audit.audited import OPEN, Audited
from kowalevski_cas.notation import Formula, NotationError, Vocabulary, read_display, split_display
from kowalevski_cas.paper.texts import Display as Printed
from kowalevski_cas.reading.counted import shown_numbers
from kowalevski_cas.reading.numbers import numbers_of
from kowalevski_cas.report.contents import Contents
from kowalevski_cas.report.dependence import graph
from kowalevski_cas.report.document import (
    Block,
    Code,
    Document,
    Emphasis,
    Equations,
    Heading,
    Inline,
    Items,
    Judgement,
    Link,
    Paragraph,
    Sign,
    Text,
    anchor,
)
from kowalevski_cas.report.marks import shown_as
from kowalevski_cas.report.paragraphs import FIRST, FormulaBlocks
from kowalevski_cas.report.places import PaperSection, ReportItem, numbered, sections
from kowalevski_cas.report.prose import read_article
from kowalevski_cas.report.trust import trust
from kowalevski_cas.report.words import capitalise, list_in_words
from kowalevski_cas.source.displays import TypedFormula, find_formulas
from kowalevski_cas.source.listing import guess
from kowalevski_cas.verify.outcome import Outcome, Run, Verdict

_CLOSING: Final = {"$": "$", "$$": "$$", "\\[": "\\]", "\\(": "\\)"}
_TITLE: Final = re.compile(r"\\title\s*(?:\[[^\]]*\])?\s*\{([^{}\\]*)\}")
_NUMBER: Final = re.compile(r"^\s*(?:\\S(?![A-Za-z])\s*)?(?:\d+\.?(?![\w-]))?\s*")
_IN_WORDS: Final = (
    "Sentences that state something in words on which there is no verdict, though there may be one "
    "on a formula in them:"
)
_UNKNOWN: Final = " is defined nowhere"
_END: Final = re.compile(r"\\end\s*\{document\}")


def annotate(audit: Audit) -> Document:
    """The source of an audit as a page.

    Raises:
        ProseError: if the text around the formulas cannot be read.
    """
    return _Annotated(audit).document()


@dataclass
class _Annotated:
    audit: Audit

    def __post_init__(self) -> None:
        audit, session = self.audit, self.audit.session
        derivation, texts = session.interpretation.derivation, session.interpretation.texts
        self.run = run = _with_reasons(audit)
        paper = sections(run, derivation, texts, every=True)
        self.text = audit.expanded.text
        self.typed = list(find_formulas(self.text, audit.expanded.body))
        body = audit.expanded.body
        self.numbers: dict[tuple[int, int], str] = {}
        for typed, number in numbers_of(self.typed, self.text, body, self.text[:body]):
            self.numbers.setdefault((typed.start, typed.end), number)
        self.placed = {
            (p.typed.start, p.typed.end): p.display for p in audit.places if p.typed is not None
        }
        if audit.reading is not None:
            paper = tuple(numbered([*map(_titled, paper)], {
                display.id: f"({self.numbers[place]})"
                for place, display in self.placed.items() if place in self.numbers
            }))  # fmt: skip
        self.file = audit.source.path.rpartition("/")[2]
        command = f"kowalevski-cas audit {self.file} --report DIR"
        self.contents = Contents(run, paper, command=command)
        self.items: dict[str, list[ReportItem]] = {}
        self.begins: dict[str, str] = {}
        for section in paper:
            waiting: list[ReportItem] = []
            last: list[ReportItem] | None = None
            shown = (i.display for i in section.items if i.display and not i.source)
            first = next(shown, "")
            self.begins[first] = f"section.{anchor(section.number)}"
            for item in section.items:
                if item.display and not item.source:
                    self.items[item.display] = last = [*waiting, item]
                    waiting = []
                else:
                    (waiting if last is None else last).append(item)
        _, self.names = guess(self.typed)

    def document(self) -> Document:
        """The page: the verdict, the paper, what stands nowhere in it."""
        run = self.run
        blocks = read_article(
            self._without_formulas(), [*map(self._one, self.typed)], self._labels()
        )
        blocks = [*_with_headings(blocks)]
        found = {d.id for d in self.placed.values()}
        lost = [item for id, items in self.items.items() if id not in found for item in items]
        if lost:
            blocks.append(Heading(("Not found in this text",), "lost"))
            blocks += [block for item in lost for block in self.contents.passages.item(item)]
        of: Text = (
            f"The source {self.file} (SHA-256 {self._digest()} …), a verdict at each formula.",
        )
        head = [
            *self.contents.verdict(), *self._assumptions(), *self._not_judged(),
            Heading(("The paper",), "paper"), Paragraph(of, "note"),
        ]  # fmt: skip
        shown = (*head, *blocks, *trust(self.contents.phrases), *graph(self.contents.findings))
        printed = _TITLE.search(self.text)
        name = printed[1] if printed and not run.author else run.title.rpartition("/")[2]
        title = f"“{name}”, verified formula by formula"
        return Document(title, title, ((run.author, "."),) if run.author else (), shown)

    def _digest(self) -> str:
        """The beginning of what binds the source."""
        return sha256(self.audit.source.text.encode(self.audit.source.encoding)).hexdigest()[:16]

    def _assumptions(self) -> Iterator[Block]:
        """What a source that is its own derivation takes for granted, and what rests on each."""
        if self.audit.reading is None:
            return
        used: dict[tuple[bool, tuple[str, ...]], list[str]] = {}
        for kind, words, _, claims in assumptions_of(self.audit):
            if claims:
                alike = used.setdefault((kind == "constant", claims), [])
                alike += [words] if words not in alike else []
        if used:
            yield Heading(("What is assumed",), "assumed", 2)
        phrases = self.contents.phrases
        for (unknown, claims), said in used.items():
            several = len(said) > 1
            names = [phrases.words(words.removesuffix(_UNKNOWN)) for words in said]
            what = (" are defined nowhere" if several else _UNKNOWN) if unknown else ""
            rest = f"{what}; on {'them' if several else 'it'} rest{'s' * (len(claims) == 1)} "
            yield Paragraph((*list_in_words(names), rest, *phrases.links(claims), "."))

    def _not_judged(self) -> Iterator[Block]:
        """The formulas and the sentences of such a source of which nothing is said."""
        audit, words = self.audit, self.contents.phrases.words
        if audit.reading is None:
            return
        unjudged = [formula for formula in audit.formulas if formula.verdict == OPEN]
        if unjudged or audit.uncovered:
            yield Heading(("What is not judged",), "unjudged", 2)
        reasons: dict[str, dict[str, None]] = {}
        for formula in unjudged:
            why = (formula.message or formula.reason).partition("\n")[0]
            reasons.setdefault(why, {})[self._called(formula)] = None
        told = [
            capitalise((*list_in_words([(place,) for place in places]), ": ", *words(f"{why}.")))
            for why, places in reasons.items()
        ]
        yield from _list_of(told)
        if audit.uncovered:
            yield Paragraph((_IN_WORDS,), leads=True)
        labels = {label: str(link.text[0]) for label, link in self._labels().items()}
        yield from _list_of([
            (f"Line {one.line} (“{one.cue}”): ", *words(one.read(lambda key: labels.get(key, key))))
            for one in audit.uncovered
        ])  # fmt: skip

    def _called(self, formula: Audited) -> str:
        """A formula by its number, or by its line."""
        numbers = (
            self.numbers.get((t.start, t.end)) for t in self.typed if formula.label in t.labels
        )
        number = next(filter(None, numbers), None) if formula.label else None
        return f"({number})" if number else f"line {formula.line}"

    # -- formulas -------------------------------------------------------------------

    def _one(self, typed: TypedFormula) -> FormulaBlocks:
        display = self.placed.get((typed.start, typed.end))
        if display is not None and display.id in self.items:
            return self._known_formula(typed, display)
        formulas = _read(typed.tex, self.run.vocabulary) or _read(typed.tex, self.names)
        if typed.inline:
            text = list_in_words([(formula,) for formula in formulas], ", ") or (Code(typed.tex),)
            return FormulaBlocks(text, inline=True)
        return FormulaBlocks((), (Equations(formulas, typed.tex),))

    def _known_formula(self, typed: TypedFormula, display: Printed) -> FormulaBlocks:
        """A formula that the derivation knows: with what is claimed of it."""
        items = self.items[display.id]
        own = next(item for item in items if item.display == display.id)
        formulas = [formula for row in own.rows for formula in row.formulas]
        wrong = self._wrong(display, own)
        blocks: list[Block] = []
        if display.id in self.begins:
            blocks.append(Paragraph((), anchor=self.begins[display.id]))
        before = ""
        for item in items:
            if item is own and wrong is not None:
                blocks.append(wrong)
                if not own.stated:
                    continue
            if item.source and item.source != before:
                said = self.contents.phrases.sentence(item.source, ":")
                blocks.append(Paragraph(said, "note", leads=True))
            before = item.source
            if item.stated or item.source or not typed.inline:
                blocks += self.contents.passages.item(item)
        if not typed.inline:
            return FormulaBlocks((), tuple(blocks))
        shown_here: list[Inline] = [*list_in_words([(formula,) for formula in formulas], ", ")]
        for outcome in own.outcomes[:1]:
            sign = Link(f"claim.{anchor(outcome.claim)}", (Sign(shown_as(outcome)),))
            shown_here += ["\u00a0", sign]
        return FormulaBlocks(tuple(shown_here) or (Code(typed.tex),), tuple(blocks), inline=True)

    def _wrong(self, display: Printed, own: ReportItem) -> Judgement | None:
        """What is wrong with a display of which nothing is claimed, with its formulas."""
        found = [
            formula
            for formula in self.audit.formulas
            if display.id in (formula.id, formula.id.partition(".")[0])
            and formula.wrong
            and not formula.claims
        ]
        if not found:
            return None
        misprints = self.audit.session.causes.misprints
        phrases = self.contents.phrases
        said: Text = ()
        for formula in found:
            word = "Misprinted" if formula.place in misprints else formula.verdict.capitalize()
            said += (f"{self._place(formula)}{word}. ", *phrases.sentence(formula.message), " ")
            if formula.breaks:
                said += ("Because of it, these fail: ", *phrases.links(formula.breaks), ". ")
        known = any(formula.place in misprints for formula in found)
        sign = Verdict.REFUTED if known else Verdict.ERROR
        if own.stated:  # its formulas follow, with what is claimed of the others
            return Judgement(sign, "", said)
        shown = [
            b._replace(label=())
            for b in self.contents.passages.item(own)
            if isinstance(b, Equations)
        ]
        return Judgement(sign, "", said, (own.label,) if own.label else (), tuple(shown))

    def _place(self, formula: Audited) -> str:
        """Which of several formulas of a display one is."""
        if self.audit.reading is None:
            return f"{formula.id}: "
        place = formula.place
        several = place is not None and len(split_display(place.display.tex)) > 1
        return f"Formula {place.number}: " if place is not None and several else ""

    # -- the text -------------------------------------------------------------------

    def _without_formulas(self) -> str:
        """The body of the text with a letter for each formula."""
        pieces: list[str] = []
        at = self.audit.expanded.body
        for number, typed in enumerate(self.typed):
            start, end = self._around(typed)
            if start >= at:
                pieces += [self.text[at:start], chr(FIRST + number)]
            else:  # another row of the environment before
                pieces.append(chr(FIRST + number))
            at = max(at, end)
        rest = self.text[at:]
        end_of_document = _END.search(rest)
        return "".join([*pieces, rest[: end_of_document.start()] if end_of_document else rest])

    def _around(self, typed: TypedFormula) -> tuple[int, int]:
        """The interval of a formula with what opens and closes it."""
        closing = _CLOSING.get(typed.kind)
        if typed.trouble:
            return typed.start, typed.end
        if closing:
            return typed.start - len(typed.kind), typed.end + len(closing)
        opened = self.text.rfind(f"\\begin{{{typed.kind}}}", 0, typed.start)
        closed = self.text.find(f"\\end{{{typed.kind}}}", typed.end)
        last = closed + len(typed.kind) + len("\\end{}") if closed >= 0 else typed.end
        return opened if opened >= 0 else typed.start, last

    def _labels(self) -> Mapping[str, Link]:
        """What references show: the numbers of displays, as TeX counts them."""
        found: dict[str, Link] = {}
        for typed in self.typed:
            place = typed.start, typed.end
            display = self.placed.get(place)
            printed = display.label if display and self.audit.reading is None else ""
            for label in typed.labels:
                number = printed.strip("()") or self.numbers.get(place, label)
                found[label] = Link(self._target(display), (number,))
        return found

    def _target(self, display: Printed | None) -> str:
        """Where a reference to a display leads."""
        items = self.items.get(display.id, ()) if display else ()
        own: Sequence[ReportItem] = [
            item for item in items if display and item.display == display.id
        ]
        return own[0].anchor if own else "paper"


def _with_reasons(audit: Audit) -> Run:
    """The run, in which outcomes say what the audit has found out about them.

    What is refuted because of another formula has the correction of that one.
    """
    told = {claim: formula.message for formula in audit.formulas for claim in formula.claims}
    mended = audit.session.causes.corrections
    reading = audit.reading
    counted = claims_of_numbers(reading) if reading is not None else ()
    number = f"for ${shown_numbers(reading.paper.numbers)}$" if reading is not None else ""

    def explained(outcome: Outcome) -> Outcome:
        if outcome.verdict is Verdict.REFUTED:
            correction = outcome.correction or mended.get(outcome.claim)
            outcome = outcome._replace(correction=correction)
        if outcome.verdict.green or outcome.verdict is Verdict.REFUTED:
            return outcome._replace(message=number) if outcome.claim in counted else outcome
        return outcome._replace(message=told.get(outcome.claim) or outcome.message)

    return audit.run._replace(outcomes=tuple(map(explained, audit.run.outcomes)))


def _list_of(said: Sequence[Text]) -> Iterator[Block]:
    """A list of sentences, if there are any."""
    if said:
        yield Items(tuple((Paragraph(text),) for text in said))


def _titled(section: PaperSection) -> PaperSection:
    """A section with its title in letters, without the number that its author types."""
    title = section.title.replace("\\,", " ").replace("~", " ")
    title = _NUMBER.sub("", title).strip().removesuffix(".")
    return section._replace(title=title or ("The beginning" if section.number == "0" else ""))


def _with_headings(blocks: Sequence[Block]) -> Iterator[Block]:
    """The blocks, where bold words at the head of a paragraph are the title of a section.

    An article that has sections by name is left as it is.
    """
    if any(isinstance(block, Heading) and block.level == 1 for block in blocks):
        yield from blocks
        return
    many = count(1)
    for block in blocks:
        match block:
            case Paragraph(text=(Emphasis(text=title, strong=True), *rest)) if _ends(title):
                yield Heading(_without_stop(title), f"part.{next(many)}")
                yield block._replace(text=tuple(rest))
            case _:
                yield block


def _ends(title: Text) -> bool:
    """Whether words come to an end as a title does."""
    return isinstance(title[-1], str) and title[-1].rstrip().endswith(".")


def _without_stop(title: Text) -> Text:
    *words, last = title
    assert isinstance(last, str)
    return (*words, last.rstrip().removesuffix("."))


def _read(tex: str, vocabulary: Vocabulary) -> tuple[Formula, ...]:
    try:
        return tuple(statement.formula for statement in read_display(tex, vocabulary))
    except NotationError:
        return ()
