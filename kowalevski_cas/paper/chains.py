r"""Chains of equalities, as :math:`\dot q=\partial H/\partial p=p/m` and :math:`L=T-V=…`.

A chain gives what stands first by what stands last; what stands between has to be equal to that,
and is passed over if it only gives names that stand nowhere else. Names that are all said to be
equal, :math:`m_1=m_2=m`, are given by the last one. Of :math:`\mathbf r=(x,y,z)=…` the list names
the components.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable
from contextlib import suppress
from typing import NamedTuple

from kowalevski_cas.notation import NotationError, split_display
from kowalevski_cas.notation.cursor import Cursor
from kowalevski_cas.notation.lexer import scan
from kowalevski_cas.notation.vocabulary import Vocabulary

NAME = r"(?:\\[A-Za-z]+|[A-Za-z])(?:_(?:\w|\{[^{}]*\}))?"
RATE = (
    rf"\\d{{0,3}}ot\s*(?:\{{\s*{NAME}\s*\}}(?:_(?:\w|\{{[^{{}}]*\}}))?"
    rf"|\s{NAME}|\\[A-Za-z]+(?:_\w)?)"
)
_IS_RATE = re.compile(rf"{RATE}|\\frac\s*\{{\s*d(?:\^\d)?\s*{NAME}\s*\}}\s*\{{[^{{}}]*\}}")
_RATIO = re.compile(
    rf"\\[dt]?frac\s*\{{(?:\s|\\,)*d\s*{NAME}\s*\}}\s*\{{(?!\s*d\s*{NAME}\s*\}}).*\}}"
    rf"|d\s*{NAME}\s*(?:/(?!\s*d\s*{NAME}\s*$).*)?",
    re.DOTALL,
)
_LISTED = re.compile(rf"\(\s*{NAME}(?:\s*,\s*{NAME})+\s*\)")
_CALLED = re.compile(rf"(?P<name>{NAME})\s*(?:\\left\s*)?\([^()]*\)")


class Chains(NamedTuple):
    """A display without chains, and the equalities of what stood in them."""

    tex: str
    equalities: tuple[tuple[str, str], ...]


def without_chains(tex: str, moving: Collection[str] = ()) -> Chains:
    r"""A display where each name and each rate is given once.

    >>> without_chains(r"\dot q=H_p=p, \dot p=-q, H=T-V=p^2+q^2", {"q", "p"})
    Chains(tex='\\dot q=p, \\dot p=-q, H=p^2+q^2', equalities=(('H_p', 'p'),))
    """
    places = sorted({*split_display(tex)}, reverse=True)
    equalities = list[tuple[str, str]]()
    changed = tex
    for start, end in places:
        members = _members(tex[start:end])
        if len(members) < 2 or any(map(_is_constant, members[:2])) or all(map(_is_ratio, members)):
            continue
        rest = names_in(without(tex, [(start, end)])) | {*moving}
        if len(members) == 3 and _LISTED.fullmatch(members[1]) and not _is_given(members[0]):
            rows = [f"{members[0]}={one}" for one in members[1:]]
            changed = changed[:start] + r",\quad ".join(rows) + changed[end:]
            continue
        given, others = _sides(members, rest)
        if not others and not any(map(_is_indexed, members)):
            if moving and all(_head(one) not in {*map(_head, moving)} for one in members):
                rows = [f"{one}=+{members[-1]}" for one in members[:-1]]
                changed = changed[:start] + r",\quad ".join(rows) + changed[end:]
            continue
        rates = [one for one in given if _IS_RATE.fullmatch(one)]
        if not given or len(others) < (1 if rates and len(given) > 1 else 2):
            continue
        *between, last = others
        known = rest | names_in(" , ".join((*given, last)))
        equalities += [(one, last) for one in between if names_in(one) & known]
        rows = [f"{one}={last}" for one in given]
        changed = changed[:start] + r",\quad ".join(rows) + changed[end:]
    return Chains(changed, tuple(reversed(equalities)))


def _is_ratio(member: str) -> bool:
    r"""Whether a member is a differential over something, as dx/P of dx/P = dy/Q = dt."""
    return _RATIO.fullmatch(member.strip()) is not None


def without_new_names(texts: Iterable[str]) -> list[str]:
    r"""Displays without members of chains that only give names which stand nowhere else.

    They are as long as before: errors point at places of the text as it was printed.

    >>> without_new_names([r"L=T-V=\dot x^2-x^2", r"f=\sin2u=2\sin u\cos u"])
    ['L=    \\dot x^2-x^2', 'f=\\sin2u=2\\sin u\\cos u']
    """
    texts = [*texts]
    found = []
    for k, tex in enumerate(texts):
        places = set[tuple[int, int]]()
        with suppress(NotationError):  # who reads it says so
            places |= {*split_display(tex)} if tex.count("=") > 1 else set()
        for start, end in places:
            members = _members(tex[start:end])
            if len(members) < 3 or not _is_given(members[0]) or _IS_RATE.fullmatch(members[0]):
                continue
            if not names_in(members[-1]):
                continue  # a number is the value, and says not what the first one is
            others = " , ".join((*texts[:k], *texts[k + 1 :], without(tex, [(start, end)])))
            for middle in members[1:-1]:
                whole = rf"(?<=[=&\s]){re.escape(middle)}\s*&?\s*="
                is_new = names_in(middle) - names_in(members[-1]) and not _is_given(middle)
                if is_new and not any(name in others for name in names_in(middle)):
                    tex = re.sub(whole, lambda one: " " * len(one[0]), tex, count=1)
        found.append(tex)
    return found


def _members(statement: str) -> list[str]:
    """What the signs of equality of a statement stand between, without marks of alignment."""
    found, depth, last = list[str](), 0, 0
    for token in scan(statement):
        depth += token.kind in ("{", "open") or token.kind == "begin"
        depth -= token.kind in ("}", "close") or token.kind == "end"
        if token.text == "=" and not depth:
            found.append(statement[last : token.start])
            last = token.end
    return [one.strip(" &\n\t.;") for one in (*found, statement[last:])]


def _sides(members: list[str], known: Collection[str]) -> tuple[list[str], list[str]]:
    """What a chain gives, and by what: rates, and names before all else; no new name behind."""
    given, others = list[str](), list[str]()
    for member in members:
        is_rate = bool(_IS_RATE.fullmatch(member))
        if _is_constant(member):
            continue
        if is_rate or (
            _is_given(member) and not others and not any(map(_IS_RATE.fullmatch, given))
        ):
            given.append(member)
        elif not re.fullmatch(NAME, member) or not {*known}.isdisjoint(names_in(member)):
            others.append(member)
    return (given, others) if members and members[0] in given else ([], others)


def _is_given(member: str) -> bool:
    """Whether it is a rate, a name, or a name at arguments."""
    return any(pattern.fullmatch(member) for pattern in (_IS_RATE, _CALLED, re.compile(NAME)))


def _is_indexed(member: str) -> bool:
    """Whether a letter runs in it, or it is a bracket or a name at arguments."""
    return bool(re.search(r"_\{?[^}]*[i-n]|\(", member)) or bool(_IS_RATE.fullmatch(member))


def _head(name: str) -> str:
    return name.partition("_")[0].strip()


def _is_constant(member: str) -> bool:
    return not member or r"\mathrm{const}" in member or r"\text{const}" in member


def names_in(tex: str) -> set[str]:
    """The names that stand in a formula."""
    try:
        return {letter + index for letter, index in Cursor(tex, scan(tex), Vocabulary()).letters()}
    except NotationError:
        return set()


def without(tex: str, places: list[tuple[int, int]]) -> str:
    """A display without what stands at some intervals."""
    for start, end in sorted(places, reverse=True):
        tex = tex[:start] + tex[end:]
    return tex
