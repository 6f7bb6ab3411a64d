r"""Equations by cases, :math:`|x|=x` for :math:`x\ge0` and :math:`-x` for :math:`x<0`."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Any, NamedTuple

_CASES = re.compile(
    r"(?P<left>.*?)=\s*\\begin\{cases\}(?P<rows>.*?)\\end\{cases\}[\s.,;]*", re.DOTALL
)
_ROWS = re.compile(r"\\begin\{cases\}(?P<rows>.*?)\\end\{cases\}", re.DOTALL)
_WORDS = re.compile(
    r"\\(?:text|mbox|mathrm|hbox)\s*\{\s*(?:if|for|when|where|если|при)?\s*\}|\\q?quad"
)
_OTHERWISE = re.compile(r"\\(?:text|mbox|mathrm|hbox)\s*\{\s*(?:otherwise|else|иначе)\s*\}")
_SIGN = re.compile(r"\\(?:leqslant|geqslant|leq|geq|le|ge|lt|gt)(?![A-Za-z])|<|>")
_OPPOSITE = {
    "<": r"\ge ", r"\lt": r"\ge ", ">": r"\le ", r"\gt": r"\le ", r"\le": ">", r"\leq": ">",
    r"\leqslant": ">", r"\ge": "<", r"\geq": "<", r"\geqslant": "<",
}  # fmt: skip


class EquationOfCase(NamedTuple):
    """An equation, and the inequality for which it is printed; none is for all that is left."""

    equation: str
    condition: str


def cases_of(equation: Any) -> tuple[EquationOfCase, ...]:
    r"""The equations of an equation by cases; none of anything else.

    >>> [*map(tuple, cases_of(r"|x|=\begin{cases}x,&x\ge0,\\-x,&\text{otherwise}\end{cases}"))]
    [('|x|=x', 'x\\ge0'), ('|x|=-x', '')]

    Raises ``ValueError`` for a condition that is no inequality, or chain of two.
    """
    found = _CASES.fullmatch(equation) if isinstance(equation, str) else None
    if found is None:
        return ()
    cases = []
    for row in filter(str.strip, re.split(r"\\\\", found["rows"])):
        value, _, condition = row.partition("&")
        condition = _WORDS.sub("", _OTHERWISE.sub("", condition)).strip(" ,.;\n~")
        signs = len(_SIGN.findall(condition))
        if signs > 2 or bool(signs) == bool(_OTHERWISE.search(row)):
            raise ValueError(rf"{row.strip()}: print an inequality behind &, or \text{{otherwise}}")
        cases.append(EquationOfCase(f"{found['left']}={value.strip(' ,;')}", condition))
    return tuple(cases)


class LawOfCase(NamedTuple):
    """Equations of motion, and the inequalities for which they are printed."""

    equations: str
    conditions: tuple[str, ...]


def laws_by_cases(tex: str) -> tuple[LawOfCase, ...]:
    r"""Equations of motion by cases, each case by itself; none if there are no cases.

    >>> for law in laws_by_cases(r"\ddot x=-x\begin{cases}+F,&\dot x<0\\-F,&\dot x>0\end{cases}"):
    ...     print(*law)
    \ddot x=-x\left(F\right) ('\\dot x<0',)
    \ddot x=-x\left(-F\right) ('\\dot x>0',)
    """
    found = next((one for one in _ROWS.finditer(tex) if _values(one["rows"])), None)
    if found is None:
        return ()
    laws = list[LawOfCase]()
    before = list[str]()
    for value, condition in _values(found["rows"]):
        law = tex[: found.start()] + rf"\left({value}\right)" + tex[found.end() :]
        places = [(condition,)] if condition else _outside(before)
        before.append(condition)
        for place in places:
            more = laws_by_cases(law) or [LawOfCase(law, ())]
            laws += (LawOfCase(one, (*place, *conditions)) for one, conditions in more)
    return (*laws,)


def _values(rows: str) -> list[tuple[str, str]]:
    """The values by cases with their conditions, none for all that is left; else no list."""
    found = list[tuple[str, str]]()
    for row in filter(str.strip, re.split(r"\\\\", rows)):
        value, _, condition = row.partition("&")
        said = _WORDS.sub("", _OTHERWISE.sub("", condition)).strip(" ,.;\n~")
        is_case = _SIGN.search(said) if said else _OTHERWISE.search(condition)
        if not is_case or "=" in value or "&" in condition:
            return []
        found.append((value.strip(" ,;\n").removeprefix("+"), said))
    return found


def _outside(conditions: Sequence[str]) -> list[tuple[str, ...]]:
    """The ways in which none of some chains of inequalities holds, by the first that does not."""
    ways: list[tuple[str, ...]] = [()]
    for inequalities in map(parts, conditions):
        ways = [
            (*way, *inequalities[:k], opposite(one))
            for way in ways
            for k, one in enumerate(inequalities)
        ]
    return ways


def parts(condition: str) -> list[str]:
    r"""The inequalities of a chain.

    >>> parts(r"0<k\le1"), parts("x<y")
    (['0<k', 'k\\le1'], ['x<y'])
    """
    sides = _SIGN.split(condition)
    signs = _SIGN.findall(condition)
    return [f"{a}{sign}{b}" for a, sign, b in zip(sides, signs, sides[1:], strict=False)]


def opposite(condition: str) -> str:
    r"""The inequality that holds where another one does not.

    >>> opposite(r"x\ge0"), opposite("x<y")
    ('x<0', 'x\\ge y')
    """
    return _SIGN.sub(lambda sign: _OPPOSITE[sign[0]], condition)
