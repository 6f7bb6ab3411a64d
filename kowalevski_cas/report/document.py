"""A document as data: what a report says, whatever sets it.

Texts are runs of words, formulas, signs and links; blocks follow one another. A writer of a format
has a method for each of these, and nothing else to decide.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, Final, NamedTuple

from kowalevski_cas.notation import Formula
from kowalevski_cas.report.marks import Shown

if TYPE_CHECKING:  # a terminal shows none
    from kowalevski_cas.report.figures import FigureFile
    from kowalevski_cas.report.graph import Drawing


class Code(NamedTuple):
    """Letters as they are typed: a name, a digest, a source."""

    text: str


class Sign(NamedTuple):
    """The sign of a verdict."""

    verdict: Shown


class Link(NamedTuple):
    """A text that leads to an anchor of the document, or, with ``outside``, to an address."""

    target: str
    text: Text
    outside: bool = False


class Emphasis(NamedTuple):
    """A text in italics, or in bold type."""

    text: Text
    strong: bool = False


APPENDIX: Final = "appendix"
"""The anchor of the appendix, which paper sets in small letters."""

Inline = str | Formula | Code | Sign | Link | Emphasis
Text = tuple[Inline, ...]


class Heading(NamedTuple):
    """A heading; the first level is that of sections."""

    text: Text
    anchor: str
    level: int = 1


class Paragraph(NamedTuple):
    """A paragraph; ``kind`` is empty, ``lead``, ``note``, or ``record`` for what few will read.

    One that ``leads`` on to a display stays with it.
    """

    text: Text
    kind: str = ""
    leads: bool = False
    anchor: str = ""


class Equations(NamedTuple):
    """Formulas on lines of their own, or their ``source`` where they cannot be read.

    ``verdict`` puts a sign beside them and ``label`` a text behind; ``wrong`` ones are false.
    On paper ``lead`` is what leads on to them, on the same line if there is room, and one that
    ``leads`` on to what is said of it stays with that.
    What is ``long`` stands in an appendix, where the format has no other way to fold it away.
    ``erratum`` is what to print instead, in LaTeX, for who tells the author.
    """

    formulas: tuple[Formula, ...]
    source: str = ""
    verdict: Shown | None = None
    label: Text = ()
    anchor: str = ""
    wrong: bool = False
    long: bool = False
    lead: Text = ()
    leads: bool = False
    erratum: str = ""


class Judgement(NamedTuple):
    """A statement with its verdict beside it, and what is said of it.

    ``folded`` is what the program did, which a reader may skip.
    """

    verdict: Shown | None
    anchor: str
    head: Text
    label: Text = ()
    blocks: tuple[Block, ...] = ()
    folded: tuple[Block, ...] = ()


class Items(NamedTuple):
    """A list, numbered or not, of items with blocks in them."""

    items: tuple[tuple[Block, ...], ...]
    numbered: bool = False


class Table(NamedTuple):
    """A table with a head; ``columns`` has the part of the line that each is wide."""

    columns: tuple[float, ...]
    head: tuple[Text, ...]
    rows: tuple[tuple[Text, ...], ...]


class Graph(NamedTuple):
    """The picture of what rests on what."""

    picture: Drawing


class Figure(NamedTuple):
    """A picture that another command drew."""

    figure: FigureFile
    caption: Text


class TrialVersion(NamedTuple):
    """A statement that fails or holds at points: its coordinates, and what has to hold there.

    ``steps`` is how both sides are computed, as JSON.
    """

    label: str
    names: tuple[tuple[str, Formula], ...]
    hypotheses: tuple[Text, ...]
    steps: str


class Trial(NamedTuple):
    """A counterexample that a page computes anew when its reader changes a number.

    There is nothing of it on paper. The first version is what is printed; ``of`` says which of
    several formulas it is about.
    """

    versions: tuple[TrialVersion, ...]
    of: Text = ()


Block = Heading | Paragraph | Equations | Judgement | Items | Table | Graph | Figure | Trial
"""A piece of the page."""


class Document(NamedTuple):
    """A titled document: ``short`` is its title in few words, ``subtitle`` has a line each."""

    title: str
    short: str
    subtitle: tuple[Text, ...]
    blocks: tuple[Block, ...]


def anchor(text: str) -> str:
    """A name that both LaTeX and Typst take for a label."""
    return re.sub(r"[^A-Za-z0-9.-]", "-", text)


def for_paper(document: Document) -> Document:
    """The document for paper: no records, nothing to try, long displays in an appendix with a link.

    What leads on to a display stands on its line, where there is room.
    """
    moved: list[Block] = []
    names: dict[tuple[Formula, ...], str] = {}

    def away(lead: Paragraph, display: Equations) -> Paragraph:
        name = names.get(display.formulas, f"A{len(names) + 1}")
        if display.formulas not in names:
            names[display.formulas] = name
            # one by one, so that a page can end between them
            first, *others = (Equations((formula,)) for formula in display.formulas)
            moved.append(first._replace(label=(name,), anchor=f"long.{name}"))
            moved.extend(others)
        return Paragraph(
            (*lead.text, " ", Link(f"long.{name}", (f"formula\N{NO-BREAK SPACE}{name}",)), ".")
        )

    def stays(blocks: Sequence[Block]) -> Iterator[Block]:
        before: Block | None = None
        for block in blocks:
            if isinstance(block, Equations) and block.long and isinstance(before, Paragraph):
                before = away(before, block)
                continue
            if before is not None:
                yield before
            before = block
            if isinstance(block, Judgement):
                inner = tuple(_lead(stays(block.blocks))), tuple(_lead(stays(block.folded)))
                before = _together(block._replace(blocks=inner[0], folded=inner[1]))
            elif isinstance(block, Trial) or (
                isinstance(block, Paragraph) and block.kind == "record"
            ):
                before = None
        if before is not None:
            yield before

    blocks = tuple(_lead(stays(document.blocks)))
    appendix = (Heading(("Appendix: long formulas",), APPENDIX), *moved) if moved else ()
    return document._replace(blocks=(*blocks, *appendix))


def _lead(blocks: Iterable[Block]) -> Iterator[Block]:
    """The blocks, where what leads on to a display, and to no other, is a part of it."""
    row = [*blocks]
    while row:
        match row:
            case [Paragraph(leads=True), Equations(verdict=None), Equations(), *_]:
                yield row.pop(0)
            case [Paragraph(leads=True) as lead, Equations(verdict=None) as display, *row]:
                yield display._replace(lead=lead.text)
            case [block, *row]:
                yield block


def _together(claim: Judgement) -> Judgement:
    """A claim of which the last formula stays with what is said of it."""
    row = *claim.blocks, *claim.folded
    for k, (before, behind) in enumerate(pairwise(row)):
        if isinstance(before, Equations) and isinstance(behind, Paragraph):
            row = *row[:k], before._replace(leads=True), *row[k + 1 :]
            break
    many = len(claim.blocks)
    return claim._replace(blocks=row[:many], folded=row[many:])
