r"""Derivatives along orbits, as :math:`dr/d\varphi` of what moves: quotients of rates."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace

from kowalevski_cas.paper.chains import names_in
from kowalevski_cas.source.displays import TypedFormula

_NAME = r"(?:\\[A-Za-z]+|[A-Za-z])(?:_(?:\w|\{(?:[^{}]|\{[^{}]*\})*\}))?"
_D = r"(?:d|\\(?:mathrm|text)\s*\{\s*d\s*\}|\\dd(?![A-Za-z]))(?:\\,)?\s*"
_TWO = r"\^\s*(?:2|\{\s*2\s*\})\s*"
_SLOPE = re.compile(
    rf"\\[dt]?frac\s*\{{\s*{_D}(?P<of>{_NAME})\s*\}}\s*\{{\s*{_D}(?P<by>{_NAME})\s*\}}"
    rf"|(?<![A-Za-z\\])d(?P<of_line>{_NAME})\s*/\s*d(?P<by_line>{_NAME})"
)
_SECOND = re.compile(
    rf"\\[dt]?frac\s*\{{\s*{_D}{_TWO}(?P<of>{_NAME})\s*\}}"
    rf"\s*\{{\s*{_D}(?P<by>{_NAME})\s*{_TWO}\}}"
)
_GIVEN = re.compile(
    rf"\s*\{{?\s*(?P<name>{_NAME})\s*\}}?\s*(?:\(\s*(?P<at>{_NAME})\s*\))?\s*=(?P<by>[^=,;]+)"
)
"""A name alone on the left of one equation, perhaps at an argument."""
_APART = re.compile(r"\\q?quad(?![A-Za-z])|\\\\|[,;&]")


def with_orbits(
    formulas: Sequence[TypedFormula], moving: Collection[str]
) -> Iterator[tuple[TypedFormula, bool]]:
    """The formulas with quotients of rates for derivatives along orbits, and whether some are.

    What is derived moves, or is given by one name that does; and so does that by which it is. By
    its own name it is a partial derivative. Of a function of more names it may be one as well.
    """
    parts = (_GIVEN.fullmatch(part) for one in formulas for part in _parts(one.tex))
    found = [one for one in parts if one]
    given = {one["name"].replace(" ", ""): one["by"] for one in found}
    at = {one["name"].replace(" ", ""): one["at"] for one in found}
    varying = {name for name, by in given.items() if {*names_in(by)} & {*moving}}
    curves = {name: "" for name in moving}
    for name, by in given.items():
        own = {*names_in(by)} & {*moving}
        if len(own) == 1:
            plain = at[name] in own or ("dot" not in by and not {*names_in(by)} & varying)
            curves.setdefault(name, own.pop() if plain else "")

    def rewritten(found: re.Match[str]) -> str:
        of, by = (name.replace(" ", "") for name in _names(found))
        if of not in curves or by not in moving or of == by:
            return found[0]
        if curves[of] == by:
            two = "^2" if found.re is _SECOND else ""
            return rf"\frac{{\partial{two} {of}}}{{\partial {by}{two}}}"
        slope = rf"\frac{{\dot{{{of}}}}}{{\dot{{{by}}}}}"
        if found.re is _SECOND:
            return rf"\frac1{{\dot{{{by}}}}}\frac d{{dt}}\left({slope}\right)"
        return slope

    for one in formulas:
        tex = _SLOPE.sub(rewritten, _SECOND.sub(rewritten, one.tex))
        along = tex.count(r"\dot") > one.tex.count(r"\dot")
        yield (one, False) if tex == one.tex else (replace(one, tex=tex), along)


def _parts(tex: str) -> list[str]:
    """The equations that a formula lists."""
    return [part.strip(" .\n") for part in _APART.split(tex)]


def _names(found: re.Match[str]) -> tuple[str, str]:
    """What is derived, and by what."""
    by = found.groupdict()
    return by["of"] or by["of_line"], by["by"] or by["by_line"]
