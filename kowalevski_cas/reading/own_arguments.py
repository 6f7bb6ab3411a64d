r"""Functions of what moves and of the time by their names: :math:`H(q,p,t)` is H."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace

from kowalevski_cas.paper.chains import NAME, RATE, names_in
from kowalevski_cas.reading.initially import moving_names
from kowalevski_cas.source.displays import TypedFormula

_TIME = "t"
_APPLIED = re.compile(
    rf"(?<![A-Za-z\\])(?P<name>{NAME})\s*(?P<open>(?:\\left|\\[bB]igg?l?)?\s*\()"
    r"(?P<by>[^()]*(?:\(\s*t\s*\)[^()]*)*)(?:\\right|\\[bB]igg?r?)?\s*\)"
)
_AT_TIME = re.compile(r"\s*(?:\\left\s*)?\(\s*t\s*(?:\\right\s*)?\)\s*$")
_VALUE = re.compile(r",|^\s*(?:\d+|t_\w|t_\{\w+\})\s*$")
"""What is no factor in brackets, but an argument."""
_PRIMED = re.compile(rf"(?<![A-Za-z\\])({NAME})\s*'+\s*&?\s*=")
_IS_RATE = re.compile(rf"\s*({NAME})\s*&?=\s*(?:[A-Za-z]\s*)?{RATE}[\s.,;]*")
"""What is a rate, or a multiple of one, as a momentum is."""
_GIVES = re.compile(r"^\s*(?:\\(?:begin|label)\s*\{[^{}]*\}\s*)*&?\s*")


def with_own_names(formulas: Sequence[TypedFormula]) -> Iterator[TypedFormula]:
    r"""The formulas without the arguments of what is given by what moves and by the time.

    So :math:`\sigma(t)=H(q(t),p(t),t)` is σ=H, where :math:`H(q,p,t)` is given. A letter that has
    other arguments anywhere keeps them.
    """
    texts = [one.tex for one in formulas]
    moving = moving_names(formulas) | {name for tex in texts for name in _PRIMED.findall(tex)}
    moving |= {found[1] for tex in texts if (found := _IS_RATE.fullmatch(tex))}
    given: dict[str, frozenset[str]] = {}
    for tex in texts:
        found = _APPLIED.match(tex, len(tex) - len(_GIVES.sub("", tex, count=1)))
        right = tex[found.end() :].lstrip(" &") if found else ""
        if found and right.startswith("=") and (by := _arguments(found["by"], moving)):
            if by != {_TIME} or {*names_in(right)} & {*moving, *given}:
                given.setdefault(found["name"].replace(" ", ""), by)
    for tex in texts:
        for found in _APPLIED.finditer(tex):
            name = found["name"].replace(" ", "")
            by = _arguments(found["by"], moving)
            if name in given and by != given[name] and (by or _VALUE.search(found["by"])):
                del given[name]
    for formula in formulas:
        tex = (
            _APPLIED.sub(lambda found: _alone(found, given), formula.tex) if given else formula.tex
        )
        yield formula if tex == formula.tex else replace(formula, tex=tex)


def _arguments(listed: str, moving: Collection[str]) -> frozenset[str] | None:
    """The names in a list of arguments, if they move, and the time is one of them."""
    found = [_AT_TIME.sub("", one).strip() for one in listed.split(",")]
    if _TIME not in found or not {*found} <= {*moving, _TIME}:
        return None
    return frozenset(found)


def _alone(found: re.Match[str], given: Collection[str]) -> str:
    name = found["name"].replace(" ", "")
    return f"{name} " if name in given else found[0]
