r"""Chains of constants with signs of several kinds, :math:`0<b=2a<1`, as what each link says.

So each is supposed, or claimed, by itself: :math:`0<b,\ b=2a,\ 2a<1`. A list of letters with one
value, :math:`a,b=1`, says of each that it has this value.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator
from contextlib import suppress
from dataclasses import replace

from kowalevski_cas.notation import NotationError
from kowalevski_cas.notation.formula import EQUALITIES
from kowalevski_cas.notation.layout import StatementTokens, statements
from kowalevski_cas.notation.tokens import Token
from kowalevski_cas.paper.chains import NAME, names_in
from kowalevski_cas.source.displays import TypedFormula

_ORDERS = frozenset({"<", ">", r"\le", r"\ge", r"\ne"})
_RATE = re.compile(r"\\d{1,4}ot(?![A-Za-z])|'|\\prime|\\frac\s*\{\s*d")
_BROKEN = re.compile(r"&|\\\\|\\int(?![A-Za-z])")
"""Breaks in a display, and integrals: what stands there is no chain of constants in one row."""
_MULTIPLE = re.compile(rf"(?:\s|\d|/|\\,|\\cdot(?![A-Za-z])|{NAME})+")
"""A product of names and numbers."""
_OPENING, _CLOSING = frozenset({"open", "{"}), frozenset({"close", "}"})


def with_links(formulas: Iterable[TypedFormula], moving: Collection[str]) -> Iterator[TypedFormula]:
    """The formulas, with the links of their chains of constants side by side.

    ``moving`` are the names of which rates are printed: of these it is one chain.
    """
    for one in formulas:
        tex = one.tex
        with suppress(NotationError):  # who reads it says so
            tex = _side_by_side(one.tex, statements(one.tex), moving)
        yield one if tex == one.tex else replace(one, tex=tex)


def _side_by_side(tex: str, printed: Iterable[StatementTokens], moving: Collection[str]) -> str:
    for tokens, start, end in sorted(printed, key=lambda one: -one.start):
        signs = [] if _BROKEN.search(tex[start:end]) else [*_signs(tokens)]
        if links := _links(tex, start, end, signs, moving):
            tex = f"{tex[:start]}{', '.join(links)}{tex[end:]}"
    return tex


def _signs(tokens: Iterable[Token]) -> Iterator[Token]:
    """The relation signs that stand in no bracket."""
    depth = 0
    for token in tokens:
        depth += (token.kind in _OPENING) - (token.kind in _CLOSING)
        if token.kind == "relation" and depth == 0:
            yield token


def _links(
    tex: str, start: int, end: int, signs: list[Token], moving: Collection[str]
) -> list[str]:
    """What the links of a chain say, equalities together; none if it says one thing only.

    None if a rate stands in it, or a link with a sign of another kind is between what moves.
    """
    kinds = {sign.text for sign in signs}
    edges = [start, *(place for sign in signs for place in (sign.start, sign.end)), end]
    members = [tex[one:other] for one, other in zip(edges[::2], edges[1::2], strict=True)]
    if not EQUALITIES & kinds or not kinds <= _ORDERS | EQUALITIES or _RATE.search(tex[start:end]):
        return []
    found, run = list[str](), members[0]
    for sign, left, right in zip(signs, members, members[1:], strict=False):
        goes_on = sign.text in EQUALITIES and not _is_value(left, right, found or run != left)
        if goes_on:
            run = f"{run}={right}"
            continue
        if not (_is_constant(left, moving) and _is_constant(right, moving)):
            return []
        found += [run] if run != left else []
        found.append(f"{left}{tex[sign.start : sign.end]}{right}")
        run = right
    found += [run] if run != members[-1] else []
    return found if len(found) > 1 else []


def _is_constant(member: str, moving: Collection[str]) -> bool:
    """Whether nothing that moves, and no time, stands in a member."""
    return names_in(member).isdisjoint({*moving, "t"})


def _is_value(left: str, right: str, chained: object) -> bool:
    r"""Whether a chain ends in the value of a multiple of a name, as :math:`b=2\sigma=2`."""
    is_multiple = _MULTIPLE.fullmatch(left) and not re.fullmatch(NAME, left.strip())
    return bool(chained and names_in(left) and is_multiple) and not names_in(right)
