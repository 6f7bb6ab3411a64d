r"""Functions that nothing gives: :math:`V(r)`, :math:`f(t)`, :math:`\omega^2(t)`.

Each of their derivatives is a name of its own, :math:`V'` for :math:`V'(r)`, that moves by the next
one and by the rate of the argument. At a point a function may have any derivatives; so what holds
of these names holds for all functions, and where it fails there is a function for which it does.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace
from typing import NamedTuple

from kowalevski_cas.notation.cursor import is_known
from kowalevski_cas.notation.functions import FUNCTIONS, LETTERS
from kowalevski_cas.paper.names import head
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.paper.texts import Display

TIMES = ("t", r"\tau")
BEYOND = 4
"""How many derivatives are known beyond those that are printed."""
_INDEX = r"(?:_(?:\w|\{[^{}]*\}))?"
_APPLIED = re.compile(
    rf"""(?<![A-Za-z\\])(?P<name>(?:\\[A-Za-z]+|[A-Za-z]){_INDEX})(?P<primes>'*)
    (?P<power>\^(?:\d|\{{[^{{}}]*\}}))?\s*(?:\\left\s*)?\(\s*(?P<by>(?:\\[A-Za-z]+|[A-Za-z]){_INDEX})
    \s*(?:\\right\s*)?\)""",
    re.VERBOSE,
)


class Unknown(NamedTuple):
    """A function with the name of its argument, and how often it is derived at most."""

    name: str
    by: str
    order: int

    @property
    def jets(self) -> Iterator[tuple[str, str, str]]:
        """Each derivative, with the next one and the argument."""
        for order in range(self.order):
            yield self.name + "'" * order, self.name + "'" * (order + 1), self.by


def unknown_functions(tex: str) -> list[Unknown]:
    r"""The functions of which a display says nothing but their argument.

    >>> unknown_functions(r"\ddot r=-V'(r)+\frac{c^2}{r^3}, \dot x(t)=y(t), \dot y(t)=-x(t)")
    [Unknown(name='V', by='r', order=5)]
    """
    known = {
        head(name)[0]
        for place in Display("field", tex, "")
        for name in place.heads.names
        if place.tex.strip().startswith(head(name)[0])
    }
    found: dict[str, list[re.Match[str]]] = {}
    for match in _APPLIED.finditer(tex):
        found.setdefault(match["name"].replace(" ", ""), []).append(match)
    functions = []
    for name, matches in found.items():
        letter = name.split("_")[0]
        everywhere = len(re.findall(rf"(?<![A-Za-z\\]){re.escape(name)}(?![A-Za-z_])", tex))
        arguments = {match["by"] for match in matches}
        if (
            name in known | FUNCTIONS | LETTERS.keys()
            or not is_known(letter)
            or everywhere != len(matches)
            or len(arguments) > 1
            or _is_derived(name, tex)
        ):
            continue
        (by,) = arguments
        if by in TIMES or _has_momentum(by, tex) or _stands_elsewhere(by, name, tex):
            most = max(len(match["primes"]) for match in matches)
            functions.append(Unknown(name, by, most + BEYOND))
    return functions


def with_jets(scene: Scene, jets: Sequence[tuple[str, str, str]]) -> Scene:
    """A scene on which the derivatives of functions move; the last of each is any constant."""
    names = dict.fromkeys(name for name, _, _ in jets)
    last = tuple(next for _, next, _ in jets if next not in names)
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

        def name_alone(match: re.Match[str], one: Unknown = one) -> str:
            if match["name"] != one.name:
                return match[0]
            if match["by"] != one.by:
                raise ValueError(f"{one.name} is a function of {one.by}; {match[0]} is not known")
            return f"{match['name']}{match['primes']}{match['power'] or ''} "

        tex = _APPLIED.sub(name_alone, tex)
        applied = rf"(?<![A-Za-z\\]){re.escape(one.name)}'*(?:\^(?:\w|\{{[^{{}}]*\}}))?"
        if other := re.search(rf"{applied}\s*(?:\\left\s*)?\(", tex):
            shown = tex[other.start() : other.end() + 5]
            raise ValueError(f"{one.name} is a function of {one.by}; {shown}… is not known")
    return tex


def _is_derived(name: str, tex: str) -> bool:
    """Whether a name stands under a dot or in a derivative by the time."""
    under = rf"\\d*dot\s*\{{?\s*{re.escape(name)}(?![A-Za-z])"
    return bool(re.search(rf"{under}|\bd\s*{re.escape(name)}(?![A-Za-z])", tex))


def _has_momentum(by: str, tex: str) -> bool:
    """Whether the momentum of a coordinate stands in a display: p beside q, or with its index."""
    index = by.partition("_")[2] or by
    momenta = [f"p_{index}", f"p_{{{index}}}", *(["p"] if "_" not in by else [])]
    return any(re.search(rf"(?<![A-Za-z\\]){re.escape(p)}(?![A-Za-z_])", tex) for p in momenta)


def _stands_elsewhere(by: str, function: str, tex: str) -> bool:
    """Whether an argument is a name of the display."""
    rest = _APPLIED.sub(lambda match: "" if match["name"] == function else match[0], tex)
    return bool(re.search(rf"(?<![A-Za-z\\]){re.escape(by)}(?![A-Za-z])", rest)) or bool(
        re.search(rf"_\{{?{re.escape(by)}(?![A-Za-z])", rest)
    )
