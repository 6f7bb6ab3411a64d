r"""Brackets of the components of a momentum, as :math:`\{M_1,M_2\}=-M_3` where ω moves.

With :math:`M_i=a_i\omega_i+\lambda_i` they say what the brackets of the variables are.
"""

from __future__ import annotations

from collections.abc import Iterator

from kowalevski_cas.notation import (
    Formula,
    Name,
    PoissonBracket,
    Product,
    Quotient,
    Sum,
    Vector,
    times,
    to_latex,
)
from kowalevski_cas.reading.cues import cue
from kowalevski_cas.reading.known import CLAIM, CONVENTION, DEFINITION, Known, StatementRole
from kowalevski_cas.reading.statements import SourceStatement
from kowalevski_cas.reading.unprinted import unprinted

OF_MOMENTA = "bracket of momenta"
"""The kind of a definition of the bracket of two components of a momentum."""


def bracket_of_momenta(item: SourceStatement, known: Known) -> StatementRole | None:
    """The bracket of two components of a momentum, of which each is given by one variable.

    What is printed of the same bracket behind it is claimed.
    """
    if not (item.members and isinstance(item.members[0], PoissonBracket)):
        return None
    own = _bracket(item, known)
    told = [_bracket(one, known) for one, role in known.roles.items() if role.kind == OF_MOMENTA]
    pairs = [{*one[0]} for one in told if one is not None]
    pair = {*own[0]} if own is not None else item.members[0].names()
    if pair in pairs:
        return StatementRole(CLAIM, "an equation between what is known", "identity")
    if own is None or cue("denied", f"{item.before} §"):
        return None
    return StatementRole(DEFINITION, "the bracket of two components of a momentum", OF_MOMENTA)


def brackets_by_momenta(
    known: Known, suffix: str
) -> Iterator[tuple[SourceStatement, StatementRole]]:
    """The brackets of variables that those of the components of a momentum give."""
    said = [one for one in known.items if known.roles[one].kind == OF_MOMENTA]
    for number, item in enumerate(said, 1):
        found = _bracket(item, known)
        assert found is not None
        (x, y), tex = found
        place = f"{item.printed.place} gives it"
        own = rf"\{{{x},{y}\}}={tex}"
        given = unprinted(known.paper, f"momentum-bracket-{number}{suffix}", own, item, place)
        yield given, StatementRole(CONVENTION, place, "", given.printed.heads.names)


def _bracket(item: SourceStatement, known: Known) -> tuple[tuple[str, str], str] | None:
    """The variables of which a statement gives the bracket, by that of momenta, and its value."""
    match item.members:
        case (PoissonBracket() as left, right):
            sides = left.children()
        case _:
            return None
    names = [one.name for one in sides if isinstance(one, Name)]
    by = [one for name in names if (one := _by_variable(name, known)) is not None]
    if len(by) != 2 or by[0][0] == by[1][0]:
        return None
    (x, a), (y, b) = by
    return (x, y), to_latex(Quotient(right, times(a, b)))


def _by_variable(name: str, known: Known) -> tuple[str, Formula] | None:
    """The variable by which a component of a momentum is given, and the factor before it."""
    for given in (one for law in known.laws for one in law.momenta):
        parts = [*known.names.vectors.get(given.bare[0], ())]
        vector = given.members[1]
        if name in parts and isinstance(vector, Vector):
            entry = vector.components[parts.index(name)]
            terms = entry.terms if isinstance(entry, Sum) else (entry,)
            moving = [one for one in terms if known.varying(one.names())]
            return _linear(moving[0], known) if len(moving) == 1 else None
    return None


def _linear(term: Formula, known: Known) -> tuple[str, Formula] | None:
    """The variable in a term, and the constant before it."""
    factors = term.factors if isinstance(term, Product) else (term,)
    moving = [one for one in factors if known.varying(one.names())]
    match moving:
        case [Name(variable)] if known.moves(variable):
            return variable, times(*(one for one in factors if one is not moving[0]))
    return None
