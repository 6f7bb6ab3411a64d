r"""Equations that words give by cyclic permutation, as :math:`\dot M_2` by :math:`\dot M_1`."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace

from kowalevski_cas.notation import Name, substitute, to_latex
from kowalevski_cas.notation.symbol import symbol
from kowalevski_cas.reading.statements import SourcePaper, SourceStatement
from kowalevski_cas.reading.unprinted import unprinted

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
