"""Of what degrees in what moves a formula is, as it is printed."""

from __future__ import annotations

from kowalevski_cas.notation import (
    Derivative,
    Formula,
    Name,
    Negative,
    Number,
    Product,
    Quotient,
    Sum,
)
from kowalevski_cas.reading.known import Known
from kowalevski_cas.reading.law import Law


def is_linear(law: Law, known: Known) -> bool:
    """Whether a law is linear in what moves, without anything else."""
    found = (degrees(member, known) for row in law.rows for member in row.members)
    return all(own <= {1} for own in found)


def degrees(formula: Formula, known: Known) -> set[int]:
    """The degrees of the terms of a formula in what moves; 2 for what may be no polynomial."""
    if formula == Number(0):
        return set()
    if not known.varying(formula.names()):
        return {0}
    match formula:
        case Name(name) if known.moves(name):
            return {1}
        case Name(name) if (given := _given(name, known)) is not None:
            return degrees(given, known)
        case Sum(terms):
            return {degree for one in terms for degree in degrees(one, known)}
        case Negative(argument) | Derivative(argument):
            return degrees(argument, known)
        case Quotient(numerator, denominator) if not known.varying(denominator.names()):
            return degrees(numerator, known)
        case Product(factors):
            return {sum(max(degrees(one, known), default=0) for one in factors)}
    return {2}


def _given(name: str, known: Known) -> Formula | None:
    """What gives a name alone, and not by itself: ``None`` if more than one equation does."""
    match known.definitions.get(name, []):
        case [by] if by.members[:1] == (Name(name),) and len(by.members) == 2:
            below = {inner for one in by.members[1].names() for inner in known.below(one)}
            return by.members[1] if name not in below else None
    return None
