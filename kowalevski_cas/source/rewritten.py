"""Where in what was typed a part of a rewritten formula stands."""

from __future__ import annotations

import re
from difflib import SequenceMatcher
from functools import cached_property
from itertools import accumulate

_SIGN = re.compile(r"\\[A-Za-z]+|.", re.DOTALL)
"""A macro, or one sign."""


class Rewritten:
    r"""A text and what it was rewritten to, with the intervals that became one another.

    >>> Rewritten(r"x=-U'(x), y=1", r"x=-\frac{dU}{dx}, y=1").interval(0, 16)
    (0, 8)
    """

    def __init__(self, typed: str, written: str) -> None:
        self.typed, self.written = typed, written

    def interval(self, start: int, end: int) -> tuple[int, int]:
        """What was typed for an interval of what is written; all that was changed with its ends."""
        if self.typed == self.written:
            return start, end
        first, last = self._place(start, 0), self._place(end, 1)
        return (first, last) if first < last else (0, len(self.typed))

    @cached_property
    def _blocks(self) -> list[tuple[int, int, int, int, bool]]:
        """Intervals of both texts, and whether they are equal."""
        written, typed = _SIGN.findall(self.written), _SIGN.findall(self.typed)
        new, old = ([0, *accumulate(map(len, signs))] for signs in (written, typed))
        found = SequenceMatcher(None, written, typed, autojunk=False).get_opcodes()
        return [(new[a], new[b], old[c], old[d], kind == "equal") for kind, a, b, c, d in found]

    def _place(self, offset: int, edge: int) -> int:
        """Where a beginning (0) or an end (1) was typed."""
        for first, last, begin, end, same in self._blocks:
            if first <= offset - edge < last:
                return begin + offset - first if same else (begin, end)[edge]
        return len(self.typed) if edge else 0
