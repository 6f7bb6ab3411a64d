r"""Derivatives along orbits, as :math:`dr/d\varphi` of what moves: quotients of rates."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace
from functools import partial

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
_RATED = re.compile(r"\\d{1,4}ot(?![A-Za-z])|d\s*t\s*\}")
"""A rate."""
_APART = re.compile(r"\\q?quad(?![A-Za-z])|\\\\|[,;&]")


def with_orbits(
    formulas: Sequence[TypedFormula], moving: Collection[str]
) -> Iterator[tuple[TypedFormula, bool]]:
    """The formulas with quotients of rates for derivatives along orbits, and whether some are.

    What is derived moves, or is given by one name that does; and so does that by which it is. By
    its own name it is a partial derivative, and beside rates so is a prime on what is given at its
    argument. Of a function of more names it may be one as well.
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

    texts = [one.tex for one in formulas]
    primed = [
        (_with_primes(name, by), by)
        for name, by in curves.items()
        if by and at[name] == by and not any(re.search(rf"{_letter(by)}'", tex) for tex in texts)
    ]
    for one in formulas:
        tex = _SLOPE.sub(rewritten, _SECOND.sub(rewritten, one.tex))
        for pattern, by in primed if _RATED.search(tex) else ():
            tex = pattern.sub(partial(_by_name, by), tex)
        along = tex.count(r"\dot") > one.tex.count(r"\dot")
        yield (one, False) if tex == one.tex else (replace(one, tex=tex), along)


def _letter(name: str) -> str:
    """What a name is where it stands alone."""
    return rf"(?<![A-Za-z\\]){re.escape(name)}"


def _with_primes(name: str, by: str) -> re.Pattern[str]:
    """A function with primes, and perhaps a power, at its argument or at none."""
    at = rf"\s*(?:\\left\s*)?\(\s*{re.escape(by)}\s*(?:\\right\s*)?\)"
    power = r"(?:\^(?:\d|\{\s*\d\s*\}))?"
    return re.compile(
        rf"(?P<of>{_letter(name)})(?P<primes>'+)(?P<power>{power})(?:{at}|(?!['\s]*(?:\\left)?\s*\())"
        rf"(?P<behind>{power})"
    )


def _by_name(by: str, found: re.Match[str]) -> str:
    """The derivative of a function by a name, for that with primes."""
    order = f"^{{{len(found['primes'])}}}" if len(found["primes"]) > 1 else ""
    derivative = rf"\frac{{\partial{order} {found['of']}}}{{\partial {by}{order}}}"
    power = found["power"] or found["behind"]
    return rf"\left({derivative}\right){power}" if power else derivative


def _parts(tex: str) -> list[str]:
    """The equations that a formula lists."""
    return [part.strip(" .\n") for part in _APART.split(tex)]


def _names(found: re.Match[str]) -> tuple[str, str]:
    """What is derived, and by what."""
    by = found.groupdict()
    return by["of"] or by["of_line"], by["by"] or by["by_line"]
