r"""Words between the formulas of a display: they are read as those between two displays.

So is :math:`f''=\sin f,\ \text{with the integral}\ \tfrac12f'^2+\cos f=h`.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace

from kowalevski_cas.notation.macros import JOINING, WORDS
from kowalevski_cas.notation.words import CONSTANT, DESCRIPTION
from kowalevski_cas.source.displays import TypedFormula

_GAP = r"(?:\s|~|&|[,;.:]|\\(?:[,;:!\s]|q?quad(?![A-Za-z])))"
_SAID = re.compile(
    rf"(?P<before>{_GAP}+)\\(?:text|mbox|hbox|textrm)\s*\{{(?P<words>[^{{}}\\$]*)\}}(?P<behind>{_GAP}*)"
)
_WORDS = re.compile(r"[\s,.;:~]*[^\W\d_]+(?:[\s,.;:~'’-]+[^\W\d_]+)*[\s,.;:~]*")
_BRACES = re.compile(r"\\begin(?![A-Za-z])|\\end(?![A-Za-z])|\\.|[{}()]", re.DOTALL)


def between_words(formula: TypedFormula) -> Iterator[TypedFormula]:
    """The formulas between which a display has words that are of none; itself, if there are none.

    Each has the labels of the display; the words stand in the text between their intervals.
    """
    printed = tex = formula.tex
    begin = 0
    for found in () if formula.inline or formula.trouble else _SAID.finditer(printed):
        before = tex[begin : found.start()]
        if before.strip() and _is_prose(found["words"]) and _is_outside(printed[: found.start()]):
            yield _piece(formula, begin, found.start(), found.start("words"))
            gap = found.end() - found.end("words")
            begin = found.end("words")
            tex = f"{tex[:begin]}{' ' * gap}{tex[found.end() :]}"
            formula = replace(formula, tex=tex, comments=())
    if not begin:
        yield formula
    elif tex[begin:].strip():
        yield _piece(formula, begin, len(tex), len(tex))


def _piece(formula: TypedFormula, begin: int, last: int, end: int) -> TypedFormula:
    start = formula.start
    return replace(formula, tex=formula.tex[begin:last], start=start + begin, end=start + end)


def _is_prose(words: str) -> bool:
    """Whether words say something that no formula has."""
    alone = words.strip(" .,;~")
    known = alone in JOINING or alone in WORDS
    return not (known or CONSTANT.fullmatch(alone) or DESCRIPTION.fullmatch(alone)) and bool(
        _WORDS.fullmatch(words)
    )


def _is_outside(before: str) -> bool:
    """Whether nothing is open behind some LaTeX: no braces, brackets or environments."""
    depth = 0
    for mark in _BRACES.findall(before):
        depth += {"{": 1, "(": 1, r"\begin": 1, "}": -1, ")": -1, r"\end": -1}.get(mark, 0)
    return depth == 0
