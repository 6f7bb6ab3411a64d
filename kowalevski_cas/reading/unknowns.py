r"""Equations for letters that nothing else gives, as :math:`ma=mg-S,\ Ja=SR^2` for a and S.

They are supposed: what is said of these letters later follows from them.
"""

from __future__ import annotations

from kowalevski_cas.notation import Formula, Name, Number, Relation
from kowalevski_cas.paper.transcendental import PI
from kowalevski_cas.reading.known import ASSUMPTION, CLAIM, UNKNOWNS, Known, StatementRole
from kowalevski_cas.reading.phrases import plain
from kowalevski_cas.reading.statements import SourceStatement

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
    """One of the equations of a display for as many new letters, which are given by name later.

    None of them gives a letter alone on a side: that would be a definition.
    """
    if item.typed.inline or not _is_equation(item, known):
        return None
    display = [one for one in known.items if one.typed is item.typed]
    if len(display) < _FEWEST or not all(_is_equation(one, known) for one in display):
        return None
    before = {
        name
        for one in known.items
        if one.order < display[0].order and one.formula != Name(next(iter(one.names), ""))
        for name in one.names
    }
    letters = {name for one in display for name in one.names} - before
    later = {name for name in letters if _is_given_behind(name, display[-1], known)}
    own = sorted(later & item.names)
    unknown = len(later) if later else 0
    if not own or unknown > len(display) or not all(later & one.names for one in display):
        return None
    told = ", ".join(map(plain, own))
    return StatementRole(
        ASSUMPTION, f"an equation for {told}, which nothing gives before", UNKNOWNS, (*own,)
    )


def _is_equation(item: SourceStatement, known: Known) -> bool:
    """Whether a statement is an equation between constants, and gives none of them alone."""
    match item.formula:
        case Relation((left, right), ("=",)):
            fixed = not (item.derives or known.varying(item.names) or item.names & known.times)
            return fixed and not any(_is_bare(one) for one in (left, right))
    return False


def _is_bare(side: Formula) -> bool:
    return isinstance(side, Name) or (isinstance(side, Number) and side.value != 0)


def _is_given_behind(name: str, item: SourceStatement, known: Known) -> bool:
    """Whether a letter stands alone on the left of a later equation, of the same section."""
    if name == PI or known.is_defined(name) or known.moves(name):
        return False
    later = (one for one in known.later.get(name, ()) if one.order > item.order)
    return any(one.section is item.section and name not in one.members[-1].names() for one in later)
