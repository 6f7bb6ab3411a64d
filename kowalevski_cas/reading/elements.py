r"""Matrices that papers give by a letter for their elements, as a skew :math:`M=(m_{ij})`.

Words, or the ranges of the indices, say of which order they are.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple

from kowalevski_cas.reading.brackets_of_elements import brackets_of_elements
from kowalevski_cas.source.displays import TypedFormula

_LETTER = r"(?:\\[A-Za-z]+|[A-Za-z])"
_OPEN, _CLOSE = r"(?:\(|\\\||\[|\\lVert)", r"(?:\)|\\\||\]|\\rVert)"
_BY_ELEMENTS = re.compile(
    rf"\s*(?P<name>{_LETTER})\s*=\s*{_OPEN}\s*(?P<of>{_LETTER})_\s*\{{\s*(?P<i>[a-z])\s*(?P<j>[a-z])\s*\}}"
    rf"\s*{_CLOSE}(?P<rest>\s*[.,;]?\s*)"
)
_NUMBERS = {
    "two": 2,
    "three": 3,
    "four": 4,
    "five": 5,
    "второго": 2,
    "третьего": 3,
    "четвертого": 4,
}
_ORDER = re.compile(
    rf"(?:\border\s+|\bпорядка\s+)(?P<word>{'|'.join(_NUMBERS)}|[2-5])\b"
    rf"|\b(?P<russian>{'|'.join(list(_NUMBERS)[4:])})\s+порядка\b"
    r"|(?P<rows>[2-5])\s*\\times\s*[2-5]|\bso\s*\(?(?P<so>[3-5])\)"
)
_SKEW = re.compile(
    r"\bskew|\banti-?symmetric|\bso\s*\(?\d\)|кососимметри|антисимметри", re.IGNORECASE
)
_SYMMETRIC = re.compile(r"(?<![\w-])symmetric|(?<!\w)симметри\w+", re.IGNORECASE)
_RANGE = r"[a-z]\s*=\s*1\s*,\s*(?:2\s*,\s*)?(?:\d\s*,\s*)*(?:\\[lc]?dots[bcio]?\s*,\s*)?(\d)"
_AROUND = 160
"""So many signs before and behind a matrix may say what it is."""


class _Elements(NamedTuple):
    name: str
    order: int
    is_skew: bool = False
    is_symmetric: bool = False
    is_hollow: bool = False
    """Whether there are zeros on the diagonal, and nothing else is known."""

    def by_rows(self, name: str, letter: str) -> str:
        """What gives a matrix by its rows, and the elements by a letter."""
        every = range(1, self.order + 1)
        rows = r"\\".join("&".join(self.entry(letter, i, j) for j in every) for i in every)
        return rf"{name}=\begin{{pmatrix}}{rows}\end{{pmatrix}}"

    def below(self, letter: str) -> str:
        """What gives the elements of a skew matrix below the diagonal."""
        pairs = [(i, j) for i in range(2, self.order + 1) for j in range(1, i)]
        return "".join(rf",\quad {letter}_{{{i}{j}}}={self.entry(letter, i, j)}" for i, j in pairs)

    def entry(self, letter: str, i: int, j: int) -> str:
        """An element by those above the diagonal, if the matrix has a symmetry."""
        if i == j and (self.is_skew or self.is_hollow):
            return "0"
        if self.is_skew and i > j:
            return f"-{letter}_{{{j}{i}}}"
        first, second = sorted((i, j)) if self.is_symmetric else (i, j)
        return f"{letter}_{{{first}{second}}}"


def with_elements(formulas: Sequence[TypedFormula], text: str) -> Iterator[TypedFormula]:
    """The formulas, with matrices that are given by a letter for their elements by their rows."""
    known: dict[str, _Elements] = {}
    for formula in formulas:
        if found := _BY_ELEMENTS.fullmatch(formula.tex):
            if elements := _elements(found, formula, formulas, text):
                known.setdefault(found["of"], elements)
    multiples = {
        one.start: tex for one in formulas if (tex := _with_multiples(one, known, formulas))
    }
    moving = {
        letter: own
        for letter, own in known.items()
        if own.is_skew and any(re.search(_rate_of(own.name), one.tex) for one in formulas)
    }
    rates = {one.start: tex for one in formulas if (tex := _rates(one.tex, moving))}
    for formula in formulas:
        found = _BY_ELEMENTS.fullmatch(formula.tex)
        if found and found["of"] in known:
            own = known[found["of"]]
            tex = own.by_rows(found["name"], found["of"])
            below = own.below(found["of"]) if multiples or rates else ""
            yield replace(formula, tex=tex + below + found["rest"])
        elif formula.start in multiples:
            yield replace(formula, tex=multiples[formula.start])
        elif tex := _brackets(formula.tex, known) or rates.get(formula.start, ""):
            yield replace(formula, tex=tex)
        else:
            yield _above_the_diagonal(formula, known, formulas)


def _brackets(tex: str, known: Mapping[str, _Elements]) -> str:
    """The brackets of elements that a formula gives with four indices; empty if it gives none."""
    own = (
        brackets_of_elements(tex, letter, one.order, one.is_skew) for letter, one in known.items()
    )
    return next(filter(None, own), "")


def _rates(tex: str, known: Mapping[str, _Elements]) -> str:
    """The rates of the elements of a skew matrix that moves, but for those on the diagonal."""
    for letter, own in known.items():
        index = rf"{re.escape(letter)}_\s*\{{\s*([a-z])\s*([a-z])\s*\}}"
        dotted = rf"\\dot\s*(?:\{{\s*{re.escape(letter)}\s*\}}|{re.escape(letter)})"
        dotted += r"_\s*\{\s*([a-z])\s*([a-z])\s*\}"
        found = re.match(
            rf"\s*(?:\\d?frac\s*\{{\s*d\s*{index}\s*\}}\s*\{{\s*dt\s*\}}|{dotted})\s*&?=", tex
        )
        if found:
            i, j = filter(None, found.groups())
            values = ",".join(map(str, range(1, own.order + 1)))
            sign = "<" if r"\{" in tex else r"\ne "  # a bracket is skew as the element is
            return (
                rf"{tex.rstrip(' .,;')},\quad {i}={values},\quad {j}={values},\quad ({i}{sign}{j})"
            )
    return ""


_MULTIPLE = re.compile(
    rf"(?:^|\\q?quad|[,;]|\\\\)\s*(?P<name>{_LETTER})_\s*\{{\s*(?P<i>[a-z])\s*(?P<j>[a-z])\s*\}}"
    rf"\s*&?=\s*(?:{_LETTER}_\s*\{{\s*(?P=i)\s*(?P=j)\s*\}}\s*)?"
    rf"(?P<of>{_LETTER})_\s*\{{\s*(?P=i)\s*(?P=j)\s*\}}\s*(?=$|[.,;]|\\q?quad|\\\\)"
)
r"""Elements by those of another matrix, each with a factor: :math:`\Omega_{ij}=c_{ij}M_{ij}`."""


def _with_multiples(
    formula: TypedFormula, known: dict[str, _Elements], formulas: Sequence[TypedFormula]
) -> str:
    """A formula that gives elements by those of a skew matrix, with the matrix of them.

    Their letter is one where it stands in a commutator with the other. Nothing, if there is none.
    """
    for found in _MULTIPLE.finditer(formula.tex):
        own, name = known.get(found["of"]), found["name"]
        if own is None or not own.is_skew or name in known:
            continue
        pair = rf"{re.escape(own.name)}\s*,\s*{re.escape(name)}"
        other = rf"{re.escape(name)}\s*,\s*{re.escape(own.name)}"
        bracket = re.compile(rf"\[\s*(?:{pair}|{other})\s*\]")
        if any(bracket.search(one.tex) for one in formulas):
            every = range(1, own.order + 1)
            values = ",".join(map(str, every))
            ranges = rf"\quad {found['i']}={values},\quad {found['j']}={values}"
            matrix = _Elements(name, own.order, is_hollow=True).by_rows(name, name)
            tex = formula.tex.rstrip(" .,;\n")
            return rf"{tex},\quad {matrix},{ranges},\quad ({found['i']}\ne {found['j']})"
    return ""


def _above_the_diagonal(
    formula: TypedFormula, known: dict[str, _Elements], formulas: Sequence[TypedFormula]
) -> TypedFormula:
    """An equation for the elements of skew matrices, for those above the diagonal.

    Where it gives what moves by multiples of other elements, it gives these.
    """
    for letter, own in known.items():
        found = re.match(
            rf"\s*{re.escape(letter)}_\s*\{{\s*([a-z])\s*([a-z])\s*\}}\s*&?=", formula.tex
        )
        if found and own.is_skew and found[1] != found[2]:
            tex = re.sub(rf",?\s*(?:\\q?quad)?\s*{found[1]}\s*,\s*{_RANGE}", "", formula.tex)
            if any(re.search(_rate_of(own.name), one.tex) for one in formulas):
                tex = _solved(tex.strip(" .,;\n"), found, known)
            values = ",".join(map(str, range(1, own.order + 1)))
            ranges = rf",\quad {found[1]}={values},\quad {found[2]}={values}"
            return replace(
                formula, tex=rf"{tex.rstrip(' .,;')}{ranges},\quad ({found[1]}<{found[2]})"
            )
    return formula


def _rate_of(name: str) -> str:
    """What the rate of a matrix looks like."""
    letter = re.escape(name)
    ratio = rf"d\s*{letter}\s*\}}\s*\{{\s*d"
    prime = rf"(?<![A-Za-z\\]){letter}'"
    return rf"\\dot\s*\{{?\s*{letter}(?![A-Za-z])|{ratio}|{prime}"


def _solved(tex: str, found: re.Match[str], known: dict[str, _Elements]) -> str:
    """What gives elements by multiples of others, solved for these; as it is, if it does not."""
    left, _, right = tex.partition("=")
    index = rf"_\s*\{{\s*{found[1]}\s*{found[2]}\s*\}}"
    others = "|".join(map(re.escape, known))
    by = re.fullmatch(rf"&?\s*(?P<factor>.*?)\s*(?P<of>(?:{others}){index})", right)
    if by is None or not by["factor"] or re.search(rf"(?:{others})_", by["factor"]):
        return tex
    return rf"{by['of']}=\frac{{{left.strip(' &')}}}{{{by['factor']}}}"


def _elements(
    found: re.Match[str], formula: TypedFormula, formulas: Sequence[TypedFormula], text: str
) -> _Elements | None:
    """What words around a matrix say of it; ``None`` if nothing says of which order it is."""
    before = re.split(r"[.;]\s", text[max(0, formula.start - _AROUND) : formula.start])[-1]
    behind = re.split(r"[.;]\s", text[formula.end : formula.end + _AROUND])[0]
    said = _ORDER.search(before) or _ORDER.search(behind)
    order = 0
    if said:
        word = next(one for one in said.groups() if one)
        order = int(word) if word.isdigit() else _NUMBERS[word]
    else:
        pair = rf"{found['i']}\s*,\s*{found['j']}\s*=\s*1"
        ranges = (re.search(_RANGE, one.tex) for one in formulas if re.search(pair, one.tex))
        order = next((int(one[1]) for one in ranges if one), 0)
    words = f"{before} {behind}"
    skew = _SKEW.search(words) is not None
    return (
        _Elements(found["name"], order, skew, not skew and bool(_SYMMETRIC.search(words)))
        if order > 1
        else None
    )
