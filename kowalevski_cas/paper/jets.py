"""Functions that nothing gives, by names for their values and derivatives: jets.

Each derivative moves by the next ones and by the rates of the arguments. At a point a function may
have any derivatives; so what holds of these names holds for all functions, and where it fails there
is a function for which it does.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import combinations_with_replacement
from typing import NamedTuple

from kowalevski_cas.notation import Vocabulary
from kowalevski_cas.notation.cursor import Cursor
from kowalevski_cas.notation.lexer import scan
from kowalevski_cas.notation.symbol import symbol
from kowalevski_cas.paper.chains import NAME
from kowalevski_cas.paper.scene import Scene

BEYOND = {1: 4, 2: 2, 3: 2}
"""How many derivatives are known beyond those that are printed, by the number of arguments."""
_BOLD = r"\\(?:mathbf|boldsymbol|vec)\s*\{?\s*\\?[A-Za-z]+\s*\}?(?:_(?:\w|\{[^{}]*\}))?"
APPLIED = re.compile(
    rf"""(?:(?<![A-Za-z\\])|(?<=[A-Za-z])(?<![A-Za-z\\][A-Za-z])(?=\\))
    (?<!\\mathbf[ {{])(?<!\\boldsymbol[ {{])(?P<name>{NAME})(?P<primes>'*)
    (?P<power>\^(?:\d|\{{[^{{}}]*\}}))?\s*(?:\\left\s*)?\(
    \s*(?P<by>(?:{_BOLD}|{NAME})(?:\s*,\s*(?:{_BOLD}|{NAME}))*)\s*(?:\\right\s*)?\)""",
    re.VERBOSE,
)

_OPENS = re.compile(r"\s*(?:\\left\s*)?\(")
"""A bracket, which is a factor behind a function at its argument."""


class Unknown(NamedTuple):
    """A function with the names of its arguments, and how often it is derived at most."""

    name: str
    by: tuple[str, ...]
    order: int

    def jets(self, vectors: Mapping[str, tuple[str, ...]]) -> Iterator[tuple[str, str, str]]:
        """Each derivative, with the next one and the argument, if vectors have these components."""
        by = tuple(part for one in self.by for part in vectors.get(one, (one,)))
        beyond = self.order + BEYOND.get(len(by), 1)
        for order in range(beyond):
            for places in combinations_with_replacement(range(len(by)), order):
                for k, argument in enumerate(by):
                    next = tuple(sorted((*places, k)))
                    yield self._derivative(places, by), self._derivative(next, by), argument

    def _derivative(self, places: Sequence[int], by: Sequence[str]) -> str:
        """The name of a derivative, by the numbers of arguments; with primes if there is one."""
        if len(by) == 1:
            return self.name + "'" * len(places)
        own = symbol(self.name)
        return replace(own, index=own.index + "".join(str(k + 1) for k in places)).name


def with_jets(scene: Scene, jets: Sequence[tuple[str, str, str]]) -> Scene:
    """A scene on which the derivatives of functions move; the last of each is any constant.

    One that the scene defines is what that says, and none is the last beyond it.
    """
    names = dict.fromkeys(name for name, _, _ in jets)
    known = {*names, *scene.definitions}
    last = tuple(dict.fromkeys(next for _, next, _ in jets if next not in known))
    constants = tuple(name for name in scene.constants if name not in (*names, *last))
    return replace(
        scene,
        variables=(*scene.variables, *names),
        constants=constants,
        undefined=(*scene.undefined, *last),
        jets=(*jets,),
    )


def without_argument(tex: str, functions: Collection[Unknown]) -> str:
    """A formula with these functions by their names alone.

    Raises ``ValueError`` for one at another argument.
    """
    for one in functions:
        listed = ", ".join(one.by)

        def name_alone(match: re.Match[str], one: Unknown = one, listed: str = listed) -> str:
            if match["name"] != one.name:
                return match[0]
            if (*arguments(match["by"]),) != one.by:
                raise ValueError(f"{one.name} is a function of {listed}; {match[0]} is not known")
            factor = _OPENS.match(match.string, match.end())
            dot = r"\cdot" if factor else ""
            return f"{match['name']}{match['primes']}{match['power'] or ''}{dot} "

        tex = APPLIED.sub(name_alone, tex)
        applied = rf"(?<![A-Za-z\\]){re.escape(one.name)}'*(?:\^(?:\w|\{{[^{{}}]*\}}))?"
        if other := re.search(rf"{applied}\s*(?:\\left\s*)?\(", tex):
            shown = tex[other.start() : other.end() + 5]
            raise ValueError(f"{one.name} is a function of {listed}; {shown}… is not known")
    return tex


def arguments(listed: str) -> Iterator[str]:
    """The names in a list of arguments, as the reader makes them."""
    for one in listed.split(","):
        ((letter, index),) = Cursor(one, scan(one), Vocabulary()).letters()
        yield letter + index
