r"""Equations for letters that nothing else gives, as :math:`ma=mg-S,\ Ja=SR^2` for a and S.

They are supposed: what is said of these letters later follows from them.
"""

from __future__ import annotations

import re

from kowalevski_cas.notation import Name, Number, Power, Relation
from kowalevski_cas.paper.transcendental import PI
from kowalevski_cas.reading.known import ASSUMPTION, CLAIM, UNKNOWNS, Known, StatementRole
from kowalevski_cas.reading.phrases import plain
from kowalevski_cas.reading.statements import SourceStatement

_EQUATION = re.compile(r"\b(?:equation|уравнени\w+)\b[^.§]*$", re.IGNORECASE)
_FEWEST = 2
"""So many equations of one display are a system."""


def unknown(item: SourceStatement, known: Known) -> StatementRole | None:
    """An equation for unknowns, or what one of them is, which follows from those before."""
    if len(item.members) > 1 and isinstance(item.members[0], Name):
        if equations_before(item, known) and not (item.derives or known.varying(item.names)):
            name = item.members[0].name
            if any(name in known.roles[one].names for one in equations_before(item, known)):
                why = f"gives {plain(name)}, for which equations stand before it"
                return StatementRole(CLAIM, why, "identity")
    return _equation_for(item, known)


def equations_before(item: SourceStatement, known: Known) -> tuple[SourceStatement, ...]:
    """The equations for unknowns in the section before a statement, if it has one of these."""
    before = [
        one
        for one, role in known.roles.items()
        if role.kind == UNKNOWNS and one.order < item.order and one.section is item.section
    ]
    found, names = list[SourceStatement](), {*item.names}
    while new := [one for one in before if one not in found and {*known.roles[one].names} & names]:
        found += new
        names |= {name for one in new for name in known.roles[one].names}
    return tuple(sorted(found, key=lambda one: one.order))


def _equation_for(item: SourceStatement, known: Known) -> StatementRole | None:
    """One of the equations of a display for new letters, of which some are given by name later.

    None of them gives a letter alone on a side: that would be a definition. One equation alone is
    no linear one, and words call it an equation.
    """
    if not _is_equation(item, known):
        return None
    display = [one for one in known.items if one.typed is item.typed]
    if not all(_is_equation(one, known) for one in display):
        return None
    before = {
        name
        for one in known.items
        if one.order < display[0].order and one.formula != Name(next(iter(one.names), ""))
        for name in one.names
    }
    letters = {name for one in display for name in one.names} - before
    unknown = sorted(name for name in letters if _is_given_behind(name, display[-1], known))
    if not 0 < len(unknown) <= len(display) or not all(letters & one.names for one in display):
        return None
    told = _EQUATION.search(item.lead) and _is_raised(unknown[0], item)
    if item.typed.inline or len(display) < _FEWEST:
        if len(display) > 1 or not told:
            return None
    letter = ", ".join(map(plain, unknown))
    return StatementRole(
        ASSUMPTION, f"an equation for {letter}, which nothing gives before", UNKNOWNS, (*unknown,)
    )


def _is_equation(item: SourceStatement, known: Known) -> bool:
    """Whether a statement is an equation between constants, and none stands alone on its left."""
    match item.formula:
        case Relation((left, _), ("=",)) if not isinstance(left, Name | Number):
            return not (item.derives or known.varying(item.names) or item.names & known.times)
    return False


def _is_raised(name: str, item: SourceStatement) -> bool:
    """Whether a power of a letter stands in an equation."""
    nodes = item.formula.nodes() if item.formula is not None else ()
    return any(isinstance(node, Power) and name in node.base.names() for node in nodes)


def _is_given_behind(name: str, item: SourceStatement, known: Known) -> bool:
    """Whether a letter stands alone on the left of a later equation, of the same section."""
    if name == PI or known.is_defined(name) or known.moves(name):
        return False
    later = (one for one in known.later.get(name, ()) if one.order > item.order)
    return any(one.section is item.section and name not in one.members[-1].names() for one in later)
