r"""Equations that words give by cyclic permutation, as :math:`\dot M_2` by :math:`\dot M_1`."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace

from kowalevski_cas.notation import Name, substitute, to_latex
from kowalevski_cas.notation.symbol import symbol
from kowalevski_cas.reading.law import Law
from kowalevski_cas.reading.statements import SourcePaper, SourceStatement
from kowalevski_cas.reading.unprinted import is_printed, unprinted

_PERMUTED = re.compile(
    r"\bcyclic(?:al(?:ly)?)?\s+(?:\w+\s+)?permut|\bpermut\w+\s+cyclically|\bcyclic(?:al)?\s+(?:ones|equations)\b"
    r"|\bциклическ\w+\s+(?:\w+\s+)?перестанов|\bперестанов\w+\s+циклическ",
    re.IGNORECASE,
)
"""Words for equations that are not printed."""
_CHANGED = re.compile(
    r"\b(?:except|but|opposite|signs?|up\s+to|not)\b|\b(?:кроме|знак\w*|не)\b", re.IGNORECASE
)
"""Words for what else is changed in them."""
_INDICES = (("1", "2", "3"), ("x", "y", "z"))
_LETTERS = (
    ("p", "q", "r"), ("A", "B", "C"), ("a", "b", "c"), ("x", "y", "z"), ("X", "Y", "Z"),
    ("u", "v", "w"), (r"\alpha", r"\beta", r"\gamma"), (r"\xi", r"\eta", r"\zeta"),
)  # fmt: skip
"""Letters that are permuted with indices, or without any."""


def permuted_rows(rows: Sequence[SourceStatement], paper: SourcePaper) -> Iterator[SourceStatement]:
    """The equations that follow from rows by cyclic permutation, where their sentence says so.

    Those that are printed are not among them.
    """
    printed = {name for row in rows for name in row.rates}
    for row in rows:
        said = _PERMUTED.search(row.words) and not _CHANGED.search(row.words)
        if not said or row.formula is None:
            continue
        formula, names = row.formula, {*row.rates}
        for step in (1, 2):
            following = {name: Name(_next(name)) for name in formula.names()}
            formula = substitute(formula, following)
            names = {_next(name) for name in names}
            if not names & printed:
                id = f"permuted-{row.order}-{step}"
                yield unprinted(paper, id, to_latex(formula), row, "by cyclic permutation")


_MORE = re.compile(
    r"\bpermut|\b(?:the|two|three)\s+(?:other|more|further)s?\b|\b(?:similar|analogous)\w*\s+for\b"
    r"|\bперестанов|\bостальн|\bаналогичн",
    re.IGNORECASE,
)
"""Words behind equations for others of the same law."""


def has_more_rows(law: Law) -> bool:
    """Whether words behind a law tell of more equations, and none are permuted: it is not whole."""
    told = any(_MORE.search(row.after[:80]) for row in law.rows)
    return told and all(map(is_printed, law.rows))


def _next(name: str) -> str:
    """The name that follows in its cycle: by its index, or by its letter; itself, if in none."""
    parts = symbol(name)
    for cycle in _INDICES:
        if parts.index in cycle:
            return replace(parts, index=cycle[(cycle.index(parts.index) + 1) % 3]).name
    for letters in _LETTERS if not parts.index else ():
        if parts.letter in letters:
            return replace(parts, letter=letters[(letters.index(parts.letter) + 1) % 3]).name
    return name
