r"""Skew matrices in italics of which a rule gives the entries, as on the Lie algebra so(n).

:math:`\dot M=[M,\Omega]` with :math:`M_{ij}=(\lambda_i+\lambda_j)\Omega_{ij}`, or with
:math:`M=J\Omega+\Omega J` for a diagonal J, which says the same, is an equation of the matrices of
:math:`M_{12},M_{13},\ldots`, and these give the entries of the other one.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import combinations

from kowalevski_cas.notation import NotationError, split_display
from kowalevski_cas.notation.lexer import scan
from kowalevski_cas.notation.ranges import without_ranges

_X, _Y = r"(?P<X>\\?[A-Za-z]+)", r"(?P<Y>\\?[A-Za-z]+)"
_FIRST = r"\s*_\s*\{\s*(?P<i>[a-z])\s*(?P<j>[a-z])\s*\}\s*"
_AGAIN = r"\s*_\s*\{\s*(?P=i)\s*(?P=j)\s*\}\s*"
_TURNED = r"\s*_\s*\{\s*(?P=j)\s*(?P=i)\s*\}\s*"
_BY_ENTRIES = re.compile(rf"{_X}{_FIRST}&?\s*=\s*\((?P<factor>[^()]*)\)\s*{_Y}{_AGAIN}")
_BY_DIAGONAL = re.compile(rf"{_X}\s*&?\s*=\s*(?P<J>[A-Za-z])\s*{_Y}\s*\+\s*(?P=Y)\s*(?P=J)")
_SKEW = re.compile(rf"{_X}{_FIRST}&?\s*=\s*-\s*(?P=X){_TURNED}")
_IN_ALGEBRA = re.compile(
    rf"{_X}\s*(?:=\s*\(\s*(?P=X){_FIRST}\)\s*)?\\in\s*\\mathfrak\s*\{{\s*so\s*\}}\s*\((?P<n>\d)\)"
)
_DIAGONAL = re.compile(
    r"(?P<J>[A-Za-z])\s*&?\s*=\s*\\(?:operatorname\s*\{\s*diag\s*\}|mathrm\s*\{\s*diag\s*\}|diag)"
    r"\s*\((?P<entries>[^()]*)\)"
)


def with_skew_matrices(tex: str) -> str:
    r"""Equations of motion with the entries of matrices that a rule and their symmetry give.

    >>> rule = r"M_{ij}=(a_i+a_j)\Omega_{ij}, M_{ji}=-M_{ij}, i,j=1,2"
    >>> print(with_skew_matrices(rf"\dot M=[M,\Omega], {rule}").rstrip())
    \dot M=[M,\Omega], M=\begin{pmatrix}0&M_{12}\\-M_{12}&0\end{pmatrix},\quad
    \Omega=\begin{pmatrix}0&\Omega_{12}\\-\Omega_{12}&0\end{pmatrix},\quad
    \Omega_{12}=\frac{M_{12}}{a_1+a_2}, ,
    """
    if not re.search(r"\\dot\s*\{?\s*\\?[A-Z]", tex) or "[" not in tex:
        return tex
    try:
        places = sorted({*split_display(tex)}, reverse=True)
    except NotationError:
        return tex  # who reads it says so
    said = {tex[start:end].strip(" .;\n&"): (start, end) for start, end in places}
    rule = next((one for text in said if (one := _rule(text, said))), None)
    both = ((pattern.fullmatch(text), text) for text in said for pattern in (_SKEW, _IN_ALGEBRA))
    skew = {match["X"]: text for match, text in both if match}
    size = _size(tex, said)
    if rule is None or not skew.keys() & {rule[1], rule[2]} or size < 2:
        return tex
    text, X, Y, factor, i, j = rule
    rows = [_matrix(X, size), _matrix(Y, size)]
    for a, b in combinations(range(1, size + 1), 2):
        below = re.sub(rf"_\s*\{{?\s*{i}\s*\}}?", f"_{a}", factor)
        below = re.sub(rf"_\s*\{{?\s*{j}\s*\}}?", f"_{b}", below)
        rows.append(rf"{Y}_{{{a}{b}}}=\frac{{{X}_{{{a}{b}}}}}{{{below}}}")
    gone = {said[one]: "" for name, one in skew.items() if name in (X, Y)}
    for (start, end), row in sorted({**gone, said[text]: ",\\quad\n".join(rows)}.items())[::-1]:
        tex = tex[:start] + row + tex[end:]
    return re.sub(rf"{i}\s*,\s*{j}\s*=\s*1\s*,[^=]*?{size}", "", tex)  # nothing runs any more


def _rule(
    text: str, said: dict[str, tuple[int, int]]
) -> tuple[str, str, str, str, str, str] | None:
    """A statement that gives entries by others: both matrices, and the factor with its indices."""
    if one := _BY_ENTRIES.fullmatch(text):
        return text, one["X"], one["Y"], one["factor"], one["i"], one["j"]
    if one := _BY_DIAGONAL.fullmatch(text):
        for entries in _diagonals(said, one["J"]):
            letter = entries[0].partition("_")[0].strip()
            return text, one["X"], one["Y"], f"{letter}_i+{letter}_j", "i", "j"
    return None


def _diagonals(said: dict[str, tuple[int, int]], name: str) -> Iterator[list[str]]:
    """The entries of a diagonal matrix, if they are a letter with numbers."""
    for text in said:
        one = _DIAGONAL.fullmatch(text)
        if one and one["J"] == name:
            entries = [entry.strip() for entry in one["entries"].split(",")]
            letter = entries[0].partition("_")[0]
            if entries == [f"{letter}_{k}" for k in range(1, len(entries) + 1)]:
                yield entries


def _size(tex: str, said: dict[str, tuple[int, int]]) -> int:
    """How many rows there are: by the algebra, or by the range of the indices."""
    for text in said:
        if one := _IN_ALGEBRA.fullmatch(text):
            return int(one["n"])
    ranges = without_ranges(scan(tex), tex)[1]
    numbers = {(*values,) for values in ranges.values() if values}
    return max(min(numbers)) if len(numbers) == 1 else 0


def _matrix(name: str, size: int) -> str:
    """A skew matrix by its entries above the diagonal."""

    def entry(a: int, b: int) -> str:
        low, high = sorted((a, b))
        return "0" if a == b else f"{'-' if a > b else ''}{name}_{{{low}{high}}}"

    every = range(1, size + 1)
    rows = r"\\".join("&".join(entry(a, b) for b in every) for a in every)
    return rf"{name}=\begin{{pmatrix}}{rows}\end{{pmatrix}}"
