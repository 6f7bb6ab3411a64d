"""Lists of *the* equilibria: where words give all of them, nothing else is at rest.

That each listed point is at rest is claimed of the point (``rest_points.py``).
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Set

from kowalevski_cas.notation import Derivative, Name, to_latex
from kowalevski_cas.paper.claims import Union
from kowalevski_cas.paper.derivation import Doubt
from kowalevski_cas.paper.transcendental import PI
from kowalevski_cas.reading.angles_at_rest import equations_of_point, up_to_turns
from kowalevski_cas.reading.in_words import InWords, is_unsure, sentences_of
from kowalevski_cas.reading.known import CLAIM, Known
from kowalevski_cas.reading.law import Law
from kowalevski_cas.reading.numerals import CARDINALS
from kowalevski_cas.reading.parts import Parts
from kowalevski_cas.reading.phrases import solved_by
from kowalevski_cas.reading.places_of_rest import velocities_at_rest
from kowalevski_cas.reading.rest_points import (
    FAMILY,
    FAMILY_BEHIND,
    POINT,
    is_membership,
    is_of_family,
    law_of_points,
)
from kowalevski_cas.reading.rung import places
from kowalevski_cas.reading.sets import SetOfEquations, sets_of
from kowalevski_cas.reading.statements import SourceStatement
from kowalevski_cas.reading.unprinted import unprinted

SAYS = "nothing else is at rest"
_NUMBER = re.compile(rf"\b(?:{'|'.join(CARDINALS)})\b", re.IGNORECASE)
_PLURAL = (
    r"(?:equilibria|equilibrium\s+(?:points|positions|states|solutions)"
    r"|(?:states|points|positions)\s+of\s+(?:rest|equilibrium)"
    r"|(?:rest|singular|stationary|fixed)\s+points|(?:steady|stationary)\s+states)"
)
_ONE = r"(?:equilibrium(?:\s+(?:point|position|state))?|(?:state|point)\s+of\s+rest)"
_RUSSIAN = (
    r"(?:положения\s+равновесия|состояния\s+(?:покоя|равновесия)|(?:особые|неподвижные)\s+точки)"
)
_OF = (
    r"(?:\s+of\s+(?:the|this|our|these)\s+\w+|\s+of\s+§|\s+(?:этой\s+)?системы)?"
    r"(?:(?:\s+of)?[\s~]*\(?\\(?:eq)?ref\s*\{[^{}]*\}\)?)?"
)
_GIVEN = (
    r"(?:[\s:,~]|\b(?:is|are|at|by|given|the|an?|points?|states?|namely|following|located|read|суть|есть|of"
    rf"|{'|'.join(CARDINALS[:4])}|{FAMILY}"
    r"|это|даются|определяются|точк\w+)\b|-{2,3}|—)*$"
)
_ALL = re.compile(
    rf"\b(?:the|its|all(?:\s+the)?)\s+(?:(?:only|{'|'.join(CARDINALS)})\s+)*{_PLURAL}{_OF}"
    rf"\s+(?:are|form|fill|make\s+up|consist\s+of|fall\s+into)\b{_GIVEN}"
    rf"|\b(?:the\s+(?:only|unique|single)|an?\s+(?:unique|single))\s+{_ONE}{_OF}{_GIVEN}"
    r"|\b(?:there\s+are|has|have|possess(?:es)?)\s+(?:(?:exactly|only|just|precisely)\s+)?"
    rf"(?:{'|'.join(CARDINALS)})\s+{_PLURAL}{_OF}{_GIVEN}"
    rf"|^[\s,]*{_PLURAL}\s*:[\s~]*$|^[\s,]*(?:все\s+)?{_RUSSIAN}{_OF}{_GIVEN}",
    re.IGNORECASE,
)
"""How words end behind which all states of rest are listed."""
_SOME = re.compile(
    r"\b(?:in|on|inside|outside|within|near|besides|apart|except|other|others|further|more|also|among"
    r"|with|where|for|beside|example|lie|belong|в|на|вне|кроме|при|для|где|также|среди)\b",
    re.IGNORECASE,
)
"""Words that may say of which states of rest a sentence speaks."""


def claims_of_all_rest(parts: Parts) -> Iterator[InWords]:
    """That nothing is at rest but where words that speak of all states of rest say it."""
    for start, words in sentences_of(parts):
        first = words.find("§")
        found = _ALL.search(words[:first]) if first >= 0 else None
        if found is None or is_unsure(words) or _SOME.search(FAMILY_BEHIND.sub("", words)):
            continue
        span = (start + found.start(), start + found.end())
        listed = [
            one for one in parts.paper.items if span[1] <= one.typed.start < start + len(words)
        ]
        number = _NUMBER.search(found[0])
        if listed and (claimed := _of_list(span, listed, number[0] if number else "", parts)):
            yield claimed


def _of_list(
    span: tuple[int, int], listed: list[SourceStatement], number: str, parts: Parts
) -> InWords | None:
    """That nothing else is at rest than what a list has, if its number is that of the words."""
    known = parts.of(listed[-1])
    law = law_of_points(listed[-1], known)
    if law is None or not {*law.variables} <= {name for row in law.rows for name in row.rates}:
        return None  # it is not known what is at rest if nothing moves
    letters = {n for one in listed if known.roles[one].kind == POINT for n in one.names}
    listed = [one for one in listed if not (is_membership(one) or _is_one_of(letters, one))]
    points = [*_points(listed, known)]
    if not points or (number and CARDINALS.index(number.lower()) + 1 != len(points)):
        return None
    still = velocities_at_rest(points[0], law, known)
    given = [*nothing_moves(law, listed[-1], known), *known.bound, *still]
    points = [_at(point, law, known) for point in points]
    if known.untied({name for point in points for one in point for name in one.names - {PI}}):
        return None  # a letter may tell the points of a family apart
    values: dict[str, object] = {"sets": (*map(places, points),), "given": places(given)}
    about = (*law.rows, *(one for point in points for one in point), *given)
    return InWords(span, Union, about, values, "rest", SAYS, listed[-1], law, Doubt.ALWAYS)


def _is_one_of(letters: Set[str], item: SourceStatement) -> bool:
    """Whether a statement is one of some letters alone, of which words say something."""
    return isinstance(item.formula, Name) and item.formula.name in letters


def nothing_moves(law: Law, item: SourceStatement, known: Known) -> list[SourceStatement]:
    """That all derivatives vanish of which equations are printed, and those below them."""
    found: dict[str, None] = {}
    for row in law.rows:
        for node in row.formula.nodes() if row.formula is not None else ():
            while isinstance(node, Derivative) and {*node.names()} <= {*law.variables}:
                found[to_latex(node)] = None
                node = node.argument
    return [
        unprinted(known.paper, f"rest-{number}-{item.order}", f"{rate}=0", item, "nothing moves")
        for number, rate in enumerate(found, 1)
    ]


def _at(point: SetOfEquations, law: Law, known: Known) -> SetOfEquations:
    """The equations of a point or a set, with those of sines and cosines for those of angles.

    Where a point is any of a family, a coordinate that is a letter of its own may have any value.
    """
    if known.roles[point[0]].kind != POINT:
        return up_to_turns(point, law, known)
    found = equations_of_point(point[0], law, known)
    if not is_of_family(point[0]):
        return found
    values = Counter(name for one in found for name in one.members[-1].names())
    letters = {Name(name) for name in known.untied(values) if values[name] == 1}
    return tuple(one for one in found if one.members[-1] not in letters)


def _points(listed: list[SourceStatement], known: Known) -> Iterator[SetOfEquations]:
    """The points of a list, and the sets that its equations define; none if it is not all read."""
    roles = [known.roles[one] for one in listed]
    if any(role.name != CLAIM or role.kind not in (POINT, "rest") for role in roles):
        return
    points = [one for one in listed if known.roles[one].kind == POINT]
    sets = [one for one in listed if one not in points]
    if any(solved_by(one, "equilibrium") for one in sets):
        return  # of solutions it is claimed already that they are all
    yield from ((one,) for one in points)
    yield from sets_of(sets, known.paper.source.text)
