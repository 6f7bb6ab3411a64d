"""Near which point, or set, an equation is linear, and where that is said."""

from __future__ import annotations

import re
from collections.abc import Sequence

from kowalevski_cas.notation import Formula, Name, Negative, Sum, to_latex, total
from kowalevski_cas.notation.symbol import rate_name
from kowalevski_cas.reading.cues import cue
from kowalevski_cas.reading.degrees import degrees
from kowalevski_cas.reading.deviations import at_no_deviation
from kowalevski_cas.reading.hypotheses import is_set, is_value
from kowalevski_cas.reading.known import Known
from kowalevski_cas.reading.linear_parts import point_at
from kowalevski_cas.reading.phrases import joined_lead
from kowalevski_cas.reading.rest_points import law_of_points
from kowalevski_cas.reading.sets import SetOfEquations
from kowalevski_cas.reading.statements import SourceStatement
from kowalevski_cas.reading.unprinted import unprinted


def near(item: SourceStatement, known: Known) -> SetOfEquations:
    """The point, or the set, near which what is linear holds: where all is given by constants.

    What has an equation of the second order is at rest there. Where small angles are spoken of, and
    no point, they are zero; near the origin all is. Letters that are deviations of all that moves
    are zero.
    """
    if deviating := at_no_deviation(item, _last_place(item, known), known):
        return deviating
    if deviating := _deviations(item, known):
        return deviating
    last = last_place(item, known)
    if not all(is_value(one, known) for one in last):
        return ()
    if not last and (point := _last_point(item, known)):
        return point
    orders: dict[str, int] = {}
    for name, order in (own for law in known.laws for own in law.orders.items()):
        orders[name] = max(order, orders.get(name, 0))
    moving = [*orders]
    names = {*known.names.scalars(name for one in last for name in one.bare)} & {*moving}
    words = known.paper.prose.between(item.section.start, item.sentence[1])
    if not last and _ORIGIN.search(item.before):
        names = {*moving}
    elif not last and (_is_small(item, known) or cue("small", words)):
        names = {*moving} & {*known.names.scalars(item.names | {*item.rates})}
    zero = [] if last else sorted(names)
    zero += [rate_name(name) for name in sorted(names) if orders[name] > 1]
    if last and names < {*moving}:  # all else is at rest there, too
        zero += [rf"\dot{{{name}}}" for name in sorted(names) if orders[name] == 1]
    return (*last, *_unprinted([f"{name}=0" for name in zero], item, known))


def _unprinted(texts: Sequence[str], item: SourceStatement, known: Known) -> SetOfEquations:
    """Equations of a place that the paper does not print."""
    return tuple(unprinted(known.paper, f"at-rest-{k}", tex, item) for k, tex in enumerate(texts))


def _deviations(item: SourceStatement, known: Known) -> SetOfEquations:
    r"""That the deviations are zero of which a statement prints rates, as :math:`\xi=x-1`.

    They are those of all that moves; a variable that words call small deviates from zero.
    """
    law = law_of_points(item, known)
    if law is None or not any(known.is_defined(name) for name in item.rates):
        return ()
    found: dict[str, str] = {}
    for name in known.definitions:
        by = known.definition(name, item)
        if by is not None and by.section in item.sections and (of := _deviates(name, by, known)):
            found.setdefault(of, name)
    if not {*item.rates} & {*found.values()}:
        return ()
    small = {name for name in law.variables if Name(name) in _called_small(item, known)}
    if not {*law.variables} <= found.keys() | small:
        return ()
    where = [
        _place(name, known.definition(found[name], item)) if name in found else f"{name}=0"
        for name in law.variables
    ]
    where += [f"{rate_name(name)}=0" for name, order in law.orders.items() if order > 1]
    return _unprinted(where, item, known)


def _place(name: str, by: SourceStatement | None) -> str:
    """The equation of the place from which a variable deviates, by what gives the deviation."""
    assert by is not None
    match by.members[1]:
        case Sum(terms) if Name(name) in terms:
            rest = total(Negative(term) for term in terms if term != Name(name))
            return f"{name}={to_latex(rest)}"
    return f"{to_latex(by.members[1])}=0"


def _deviates(name: str, by: SourceStatement, known: Known) -> str:
    """The variable of which a name is the difference from a constant; empty if it is none."""
    if known.moves(name) or by.derives or by.members[:1] != (Name(name),) or len(by.members) != 2:
        return ""
    varying = known.varying(by.members[1].names())
    linear = degrees(by.members[1], known) <= {0, 1}
    return varying[0] if len(varying) == 1 and known.moves(varying[0]) and linear else ""


def _last_point(item: SourceStatement, known: Known) -> SetOfEquations:
    """The equations of the point of which the coordinates are listed last before a statement.

    They stand in its paragraph, and no other point beside them.
    """
    law, start = law_of_points(item, known), max(item.paragraph, item.section.start)
    if law is None or not cue("linear", known.paper.prose.between(start, item.sentence[1])):
        return ()
    before = [one for one in known.items if start <= one.typed.start and one.order < item.order]
    points = [(one, point) for one in before if (point := point_at([one], item, law, known))]
    last = [point for one, point in points if one.sentence == points[-1][0].sentence]
    return last[0] if len(last) == 1 else ()


def _is_small(item: SourceStatement, known: Known) -> bool:
    """Whether words call what moves in a statement small, and that is all that they call so."""
    small = _called_small(item, known)
    moving = {Name(name) for name in item.names if known.moves(name)}
    return bool(small) and {*small} == moving


def _called_small(item: SourceStatement, known: Known) -> list[Formula | None]:
    """What words of the section before a statement call small, with what they join to it."""
    before = [one for one in known.items if one.section is item.section and one.order < item.order]
    return [one.formula for one in before if _SMALL.search(joined_lead(one))]


_ORIGIN = re.compile(r"\b(?:near|about|around|at)\s+the\s+origin\b", re.IGNORECASE)
_SMALL = re.compile(r"\b(?:small|мал\w+)[\s~]*$", re.IGNORECASE)


def last_place(item: SourceStatement, known: Known) -> SetOfEquations:
    """What the last sentence says that gives what moves, near which what is linear holds.

    It is that of the statement, or one before it in the paragraph.
    """
    start = max(item.paragraph, item.section.start)
    words = known.paper.prose.between(start, item.sentence[1])
    linear = cue("linear", words) or cue("place", words)
    return _last_place(item, known) if linear else ()


def _last_place(item: SourceStatement, known: Known) -> SetOfEquations:
    """What gives what moves, or a set, in the sentence of a statement, or last before it."""
    start = max(item.paragraph, item.section.start)
    before = [
        one
        for one in known.items
        if start <= one.typed.start and one.order < item.order
        and (is_value(one, known) or is_set(one, known))
    ]  # fmt: skip
    return tuple(one for one in before if one.sentence == before[-1].sentence)
