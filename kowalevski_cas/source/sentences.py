"""The sentences of a source as words, whatever their spaces, fonts and line breaks."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from dataclasses import dataclass

from kowalevski_cas.source.displays import TypedFormula

_WORD = re.compile(
    r"\\label\s*\{[^{}]*\}"
    r"|\\(?:it|em|bf|rm|sl|sc|emph|textit|textbf|textrm|noindent)(?![A-Za-z])"
    r"|\\[ ,;:!/>()-]|%[^\n]*|\$(?!\$)"
    r"|(?P<stop>\n[ \t\r]*\n|\\par(?![A-Za-z])|[.;:?!]"
    r"|\$\$|\\[\[\]]|\\(?:begin|end)\s*\{[A-Za-z]+\*?\})"
    r"|(?P<word>\\(?:eqref|ref|cite)\s*\{[^{}]*\}|\\[A-Za-z]+|\w+|\\.|[^\s{}~])",
    re.DOTALL,
)
STOP = "."


@dataclass(frozen=True)
class Word:
    """A word, a sign, or an inline formula; every stop is the same, and so is a display."""

    text: str
    start: int
    end: int


def sentence_words(
    text: str, start: int, formulas: Iterable[TypedFormula], called: Callable[[TypedFormula], str]
) -> list[Word]:
    """The words of a text from an offset on, with its formulas as ``called``."""
    found: list[Word] = []

    def prose(first: int, last: int) -> None:
        for match in _WORD.finditer(text, first, last):
            if match["stop"] or match["word"]:
                word = STOP if match["stop"] else match["word"]
                found.append(Word(word, *match.span()))

    at = start
    for formula in formulas:
        prose(at, formula.start)
        name = called(formula) if formula.inline else STOP
        found.append(Word(name, formula.start, formula.end))
        at = formula.end
    prose(at, len(text))
    return [w for k, w in enumerate(found) if w.text != STOP or not k or found[k - 1].text != STOP]
