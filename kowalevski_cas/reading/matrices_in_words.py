r"""Letters that are matrices of which no elements are printed, as A in :math:`A^T=-A`.

They are read as numbers; nothing is judged by that.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from kowalevski_cas.notation import Name
from kowalevski_cas.reading.statements import SourcePaper
from kowalevski_cas.reading.text import MARK

_T = r"\s*T\s*|\s*\{\s*T\s*\}"
_SIGN = r"\\(?:top|intercal)|\\(?:math(?:rm|sf|tt|bf)|text(?:rm|sf)?)\s*(?:\{\s*T\s*\}|T)|\\rm\s*T"
_TRANSPOSED = re.compile(
    rf"(?<![A-Za-z\\])(?P<name>[A-Z])\s*\^(?:(?P<letter>{_T})|\s*\{{?\s*(?:{_SIGN}))(?![A-Za-z])"
)
"""A capital with the mark of a transposed matrix, which may be a letter."""
_LETTER_T = re.compile(r"(?<![A-Za-z\\^])(?<!\^\{)T(?![A-Za-z])")
_CALLED = re.compile(r"\b(?:matrix|matrices|матриц\w*)[\s~]*$", re.IGNORECASE)
_AND = re.compile(r"[\s~]*(?:,|\band\b|\bи\b)[\s~]*(?:\band\b)?[\s~]*", re.IGNORECASE)


def matrices_in_words(paper: SourcePaper) -> frozenset[str]:
    """The letters with the mark of a transposed matrix, or called matrices, and read as numbers."""
    texts = [item.typed.tex for item in paper.items]
    power = any(_LETTER_T.search(tex) for tex in texts)
    found = {
        one["name"]
        for tex in texts
        for one in _TRANSPOSED.finditer(tex)
        if not (power and one["letter"])
    }
    return frozenset(found | {*_called(paper)}) - paper.words.matrices - paper.words.vectors


def _called(paper: SourcePaper) -> Iterator[str]:
    """The letters that stand alone right behind the word, or in a list behind it."""
    before = False
    for item in paper.items:
        listed = before and item.before.endswith(f"{MARK}{item.lead}") and _AND.fullmatch(item.lead)
        before = isinstance(item.formula, Name) and bool(listed or _CALLED.search(item.lead))
        if before and isinstance(item.formula, Name):
            yield item.formula.name
