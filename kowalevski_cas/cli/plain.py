"""Documents, formulas and words in plain text, for a terminal: wrapped at its width."""

from __future__ import annotations

import shutil
from collections.abc import Iterable, Iterator
from textwrap import TextWrapper
from typing import Final

from kowalevski_cas.cli.terminal import width, with_style
from kowalevski_cas.notation import (
    Formula,
    NotationError,
    Vocabulary,
    print_prose,
    read_display,
    read_prose,
    to_plain,
)
from kowalevski_cas.report.compare import without_marks
from kowalevski_cas.report.document import (
    Block,
    Code,
    Emphasis,
    Equations,
    Heading,
    Inline,
    Judgement,
    Link,
    Paragraph,
    Sign,
    Text,
)
from kowalevski_cas.report.marks import MARKS, Shown
from kowalevski_cas.verify.outcome import Verdict

SHORT: Final = 24
"""How many letters a formula has at most that is not broken between two lines."""

_COLOURS: Final[dict[Shown, int]] = {
    Verdict.PROVED: 32, Verdict.CONDITIONAL: 36, Verdict.REFUTED: 31,
    Verdict.PROBABLE: 34, Verdict.ENCLOSED: 34,
}  # fmt: skip


def sign(verdict: Shown, words: str = "") -> str:
    """The sign of a verdict, and words, in its colour on a terminal; all signs are as wide."""
    return with_style(f"{MARKS[verdict].sign:<3} {words}".ljust(4), _COLOURS.get(verdict, 33))


def bold(line: str) -> str:
    """A line that stands out on a terminal."""
    return with_style(line, 1)


def formulas(found: Iterable[Formula], source: str = "") -> str:
    """The formulas of a display on one line; its source where they could not be read."""
    return ", ".join(to_plain(without_marks(formula)) for formula in found) or " ".join(
        source.split()
    )


def display(source: str, vocabulary: Vocabulary) -> str:
    """The formulas of a display by its source."""
    try:
        found = read_display(source, vocabulary)
    except NotationError:
        found = ()
    return formulas((statement.formula for statement in found), source)


def text(found: Text) -> str:
    """A text, in which spaces within short formulas are not broken."""
    return "".join(map(_inline, found))


def _inline(inline: Inline) -> str:
    match inline:
        case str():
            return inline
        case Code(source):
            return source
        case Formula():
            shown = to_plain(inline)
            return shown.replace(" ", "\xa0") if len(shown) <= SHORT else shown
        case Sign(verdict):
            return MARKS[verdict].sign
        case Link(text=inner) | Emphasis(text=inner):
            return text(inner)


def words(said: str, vocabulary: Vocabulary) -> str:
    """Words with mathematics between dollars."""
    return print_prose(read_prose(said, vocabulary), str, to_plain)


def many(number: int, what: str) -> str:
    """How many there are, in digits."""
    return f"{number} {what}{'s' * (number != 1)}"


def shorten(line: str) -> str:
    """As much of a line as the terminal is wide."""
    columns = shutil.get_terminal_size().columns
    return line if len(line) <= columns else f"{line[: columns - 1]}…"


def wrap(words: str, first: str = "", indent: int = 0) -> Iterator[str]:
    """The lines of words behind what stands ``first``; the others begin below these words."""
    columns = max(shutil.get_terminal_size().columns, 40 + indent)
    begins = width(first) * " "
    wrapper = TextWrapper(
        columns, begins, " " * indent, break_long_words=False, break_on_hyphens=False
    )
    start, *others = wrapper.wrap(words) or [begins]
    for line in (first + start[len(begins) :], *others):
        yield line.replace("\xa0", " ")


def lines(blocks: Iterable[Block], indent: int = 0) -> Iterator[str]:
    """Headings, paragraphs, displays and claims, wrapped, with hanging indents."""
    margin = " " * indent
    for block in blocks:
        match block:
            case Heading():
                yield ""
                yield from map(bold, wrap(text(block.text), margin, indent))
            case Paragraph():
                yield from wrap(text(block.text), margin, indent)
            case Equations():
                mark = sign(block.verdict) if block.verdict else " " * 4
                beside = f" ({text(block.label)})" if block.label else ""
                shown = formulas(block.formulas, block.source) + beside
                yield from wrap(shown, margin + mark, indent + 4)
            case Judgement():
                mark = sign(block.verdict) if block.verdict else ""
                inner = indent + (4 if block.verdict else 0)
                yield from wrap(text(block.head), margin + mark, inner)
                yield from lines(block.blocks, inner)
