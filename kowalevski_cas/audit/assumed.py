"""What the audit of a source by itself takes for granted, and what no verdict rests on."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from kowalevski_cas.audit.audit import Audit
from kowalevski_cas.audit.audited import Audited
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.paper.transcendental import PI
from kowalevski_cas.reading import ASSUMPTION, CONVENTION, DEFINITION, Reading
from kowalevski_cas.reading.counted import shown_numbers


class Assumed(NamedTuple):
    """Something that is taken for granted, and the claims that rest on it."""

    kind: str
    words: str
    place: Printed | None
    claims: tuple[str, ...]


def assumptions_of(audit: Audit) -> Iterator[Assumed]:
    """What an audit takes for granted: assumptions, conventions, numbers, names of constants."""
    reading = audit.reading
    assert reading is not None
    claiming = [formula for formula in reading.formulas if formula.claim is not None]
    if numbers := reading.paper.numbers:
        yield Assumed("number", f"${shown_numbers(numbers)}$", None, claims_of_numbers(reading))
    for formula in reading.formulas:
        if formula.role.name == ASSUMPTION:
            claims = (f.claim.id for f in claiming if f.claim and formula.item in f.on)
            words = f"${formula.item.printed.tex}$"
            words = f"{words} where the motion begins" if formula.item.begins else words
            yield Assumed("assumption", words, formula.item.printed, tuple(claims))
    for formula in reading.formulas:
        if formula.role.name == CONVENTION:
            place = formula.item.printed
            claims = (f.claim.id for f in claiming if f.claim and place in f.claim.reads())
            yield Assumed("convention", f"${place.tex}$", place, tuple(claims))
    names = dict.fromkeys(name for formula in claiming for name in formula.constants)
    for name in (one for one in names if one != PI):
        claims = (f.claim.id for f in claiming if f.claim and name in f.constants)
        yield Assumed("constant", f"${name}$ is defined nowhere", None, tuple(claims))


def claims_of_numbers(reading: Reading) -> tuple[str, ...]:
    """The claims that are decided for these numbers alone."""
    counted = reading.paper.counted
    several = {f.item.printed for f in reading.formulas if f.item.typed.start in counted}
    judged = (*reading.formulas, *reading.statements)
    claims = [one.claim for one in judged if one.claim is not None]
    return tuple(claim.id for claim in claims if not several.isdisjoint(claim.reads()))


def unchecked(audit: Audit) -> list[Audited]:
    """The definitions on which no verdict rests: nothing would show a misprint in them."""
    reading = audit.reading
    assert reading is not None
    claims = [formula.claim for formula in reading.formulas if formula.claim is not None]
    read = frozenset().union(*(claim.reads() for claim in claims))
    defining = {f.item.printed for f in reading.formulas if f.role.name == DEFINITION}
    return [
        formula
        for formula in audit.formulas
        if formula.place in defining and formula.place not in read
    ]
