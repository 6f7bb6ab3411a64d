r"""Sums that are printed without the values of their indices, as :math:`\sum_{i<j}m_im_j`.

An index has the values with which the names stand in the equations of motion. Where these are
printed with the sign of a permutation, an index that stands twice is summed over here too, as in
:math:`M_i\gamma_i`.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator
from itertools import groupby

from kowalevski_cas.notation import NotationError, Vocabulary
from kowalevski_cas.notation.cursor import Cursor
from kowalevski_cas.notation.lexer import scan
from kowalevski_cas.notation.ranges import without_ranges
from kowalevski_cas.notation.sums import SIGNS, SumSign
from kowalevski_cas.notation.symbol import symbol
from kowalevski_cas.notation.tensors import permuted, repeated
from kowalevski_cas.notation.tokens import Token


def has_permutation(tex: str) -> bool:
    r"""Whether the sign of a permutation of three indices stands in a display.

    >>> has_permutation(r"\dot M_i=\varepsilon_{ijk}M_j\gamma_k")
    True
    """
    return bool(permuted(scan(tex)))


def with_ranges(tex: str, names: Collection[str], convention: bool) -> str:
    r"""A formula with the values of the indices that its sums are printed without.

    With the ``convention``, sums over indices that stand twice in a term are printed too.

    >>> with_ranges(r"\sum_{i<j}x_ix_j", ["x_1", "x_2", "x_3"], False)
    '\\sum_{i<j}x_ix_j,\\quad i,j=1,2,3'
    >>> with_ranges("x_iy_i+z", ["x_1", "x_2", "y_1", "y_2", "z"], True)
    '\\sum_{i=1}^{2}x_iy_i+z'
    """
    try:
        tokens, ranges = without_ranges(scan(tex), tex)
        letters = [letter for letter in _letters(tokens) if letter not in ranges]
        values = {letter: _values(letter, tex, tokens, names) for letter in letters}
        known = {letter: found for letter, found in values.items() if len(found) > 1}
        pairs = repeated(tokens) if convention else ()
        found = [(term, _values(index, tex, term, names), index) for term, index in pairs]
    except NotationError:
        return tex  # who reads it says so
    for term, numbers, index in reversed(found):
        if numbers and numbers == [*range(1, len(numbers) + 1)]:
            sign, at = rf"\sum_{{{index}=1}}^{{{len(numbers)}}}", term[0].start
            tex = tex[:at] + sign + tex[at:]
    by = groupby(sorted(known, key=lambda one: (known[one], one)), key=lambda one: known[one])
    more = (f"{','.join(letters)}={','.join(map(str, numbers))}" for numbers, letters in by)
    return r",\quad ".join((tex, *more))


def _letters(tokens: list[Token]) -> Iterator[str]:
    """The indices of sums of which no values are printed."""
    for k, token in enumerate(tokens):
        if token.kind in SIGNS:
            yield from SumSign.at(tokens, k).without_values()


def _values(letter: str, tex: str, tokens: Iterable[Token], names: Collection[str]) -> list[int]:
    """The numbers that an index stands for: all names with it have the same ones."""
    used = {
        head
        for head, index in Cursor(tex, [*tokens], Vocabulary()).letters()
        if index == f"_{letter}"
    }
    found = {
        head: sorted(
            int(symbol(name).index)
            for name in names
            if symbol(name).head == head and symbol(name).index.isdecimal()
        )
        for head in used
    }
    first, *others = [*found.values()] or [[]]
    return first if all(other == first for other in others) else []
