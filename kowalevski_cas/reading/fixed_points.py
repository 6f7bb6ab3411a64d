r"""What is said of maps by steps: fixed points, as :math:`x=0` of :math:`x_{n+1}=ax_n(1-x_n)`.

A letter without the index of the steps is what does not change with them.
"""

from __future__ import annotations

import re
from dataclasses import replace

from kowalevski_cas.notation import Name, to_latex
from kowalevski_cas.notation.edits import substitute
from kowalevski_cas.notation.symbol import symbol
from kowalevski_cas.reading.known import CLAIM, OTHER, Known, StatementRole
from kowalevski_cas.reading.law import Law
from kowalevski_cas.reading.phrases import plain
from kowalevski_cas.reading.rest_points import mark_of, says_rest
from kowalevski_cas.reading.statements import SourceStatement
from kowalevski_cas.reading.unprinted import unprinted

FIXED = "fixed point"
"""The kind of these claims."""
_INDEX = re.compile(r"(?P<step>[a-z])(?:[+-]\d+)?")
_OF_ANOTHER = re.compile(
    r"\b(?:iterat\w+|squared?|twice|double|period\w*|cycles?|inverse|composition|powers?)\b"
    r"|\b(?:итерац\w+|квадрат\w*|период\w*|цикл\w*|обратн\w+)",
    re.IGNORECASE,
)
"""Words for maps that are made of the one that is printed."""


def fixed_point(item: SourceStatement, known: Known) -> StatementRole | None:
    """What words call a fixed point of a map, by letters without the index of its steps."""
    law = _map_before(item, known)
    if law is None or _OF_ANOTHER.search(item.words) or not says_rest(item):
        return None
    if len(item.members) != 2 or not at_all_steps(item, law):
        return None
    if known.varying(item.names) or {*item.members[1].names()} & {*item.bare[:1]}:
        return None
    why = "the words beside it call it a fixed point"
    return StatementRole(CLAIM, why, FIXED, item.bare[:1])


def by_steps(item: SourceStatement, known: Known) -> StatementRole | None:
    r"""What a map moves, by the number of steps, as :math:`x_n=a^nx_0`, or by what another moves.

    It is not judged.
    """
    if len(item.members) != 2:
        return None
    every = [{*pair} for law in known.laws for pair in law.images]
    given = [name for name in item.bare[:1] if any(name in pair for pair in every)]
    if given and _step(given[0]) in item.names:
        return StatementRole(OTHER, f"gives {plain(given[0])} by the number of steps", "asked")
    names = {*item.names} - {*given}
    others = [{x for pair in law.images for x in pair} for law in known.laws if law.images]
    moving = names & {x for own in others for x in own}
    apart = [own for own in others if given and given[0] not in own]
    if any(moving & own for own in apart) and not any(
        moving <= o for o in others if o not in apart
    ):
        why = f"gives {plain(given[0])} by what another map moves"
        return StatementRole(OTHER, why, "asked")
    return None


def _map_before(item: SourceStatement, known: Known) -> Law | None:
    """The last map by steps before a statement."""
    maps = [law for law in known.laws if law.images and law.order < item.order]
    return maps[-1] if maps and all(_step(x) for x, _ in maps[-1].images) else None


def _step(name: str) -> str:
    """The index of the steps of what is mapped; empty if it has none."""
    found = _INDEX.fullmatch(symbol(name).index)
    return found["step"] if found else ""


def at_all_steps(item: SourceStatement, law: Law) -> dict[str, str]:
    """What is mapped at each step, with what stands for it in the equation of a fixed point.

    There is nothing where the map has other letters.
    """
    first = item.members[0]
    if not isinstance(first, Name):
        return {}
    letters = {x: replace(symbol(x), index="").name for x, _ in law.images}
    own = {
        x for x, letter in letters.items() if first.name == letter or mark_of(first.name, letter)
    }
    return dict.fromkeys(letters, first.name) if own == {*letters} else {}


def equations_of_fixed_point(
    item: SourceStatement, known: Known
) -> tuple[Law, tuple[SourceStatement, ...]]:
    """The map of which a fixed point is printed, and the equations of it in what is mapped."""
    law = _map_before(item, known)
    assert law is not None and item.formula is not None
    found = []
    for number, (x, letter) in enumerate(at_all_steps(item, law).items(), 1):
        tex, id = (
            to_latex(substitute(item.formula, {letter: Name(x)})),
            f"fixed-{item.order}-{number}",
        )
        found.append(unprinted(known.paper, id, tex, item, "does not change with the steps"))
    return law, tuple(found)
