"""The numbers that references to sections and theorems show."""

from __future__ import annotations

import re
from typing import Final

THEOREM: Final = re.compile(
    r"(theorem|lemma|proposition|corollary|definition|remark|example|claim)\*?", re.IGNORECASE
)
_COUNTED: Final = re.compile(
    r"\\(?P<kind>section|subsection)\s*\{|\\begin\{(?P<theorem>\w+)\}|\\label\{(?P<label>[^{}]*)\}"
)


def numbers(tex: str) -> dict[str, str]:
    r"""The numbers of what has labels, with one counter for all theorems.

    >>> numbers(r"\section{A}\label{a}\begin{lemma}\label{l}\end{lemma}\subsection{B}\label{b}")
    {'a': '1', 'l': '1', 'b': '1.1'}
    """
    section = subsection = theorems = 0
    number, found = "", {}
    for match in _COUNTED.finditer(tex):
        if match["kind"] == "section":
            section, subsection = section + 1, 0
            number = str(section)
        elif match["kind"]:
            subsection += 1
            number = f"{section}.{subsection}"
        elif match["theorem"] and THEOREM.fullmatch(match["theorem"]):
            theorems += 1
            number = str(theorems)
        elif match["label"]:
            found[match["label"]] = number
    return found
