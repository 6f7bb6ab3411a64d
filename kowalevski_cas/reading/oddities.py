"""Where a misprint may stand if a claim fails, or has no meaning, and no repair of it is known."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator
from typing import NamedTuple

from kowalevski_cas.notation import Name
from kowalevski_cas.reading.known import ASSUMPTION, DEFINITION, NAMING, Known
from kowalevski_cas.reading.nearby import last_place
from kowalevski_cas.reading.statements import SourceStatement
from kowalevski_cas.reading.unprinted import is_printed


class Oddity(NamedTuple):
    """A statement on which a claim stands, and what is strange there."""

    item: SourceStatement
    words: str


def oddities(
    item: SourceStatement, on: Iterable[SourceStatement], known: Known
) -> Iterator[Oddity]:
    """What is strange in the statements on which a claim stands.

    A name may be defined by itself, move by two equations, or stand nowhere else in its part of the
    paper; what is supposed may be another thing than was meant, or say nothing of the claim.
    """
    counts = Counter(name for one in known.items for name in one.names - {r"\pi"})
    for one in _stands_on(item, known):
        twice = sorted(n for n in one.rates if _moves_twice(n, one, known))
        circular = sorted(n for n in known.roles[one].names if _is_circular(n, one, known))
        single = sorted(n for n in one.names if counts[n] == 1 and not known.is_defined(n))
        if circular:
            yield Oddity(one, f"${circular[0]}$ is defined in terms of itself")
        elif twice:
            yield Oddity(one, f"${twice[0]}$ has another equation of motion too")
        elif single:
            yield Oddity(one, f"${single[0]}$ stands nowhere else")
            if one is item:
                yield from _idle_definitions(item, known)
    for name in item.rates:
        if known.moves(name) or known.is_defined(name):
            continue
        before = (one for one in known.items if one.order < item.order)
        beside = (one for one in before if one.section is item.section and name in one.names)
        yield from (Oddity(one, f"no equation says how ${name}$ moves") for one in beside)
        yield from _unused_definition(item, known)
    supposed = dict.fromkeys(
        (*on, *known.supposed(item), *known.sets(item), *last_place(item, known))
    )
    for one in supposed:
        where = " where the motion begins" if one.begins else ""
        yield Oddity(one, f"${one.printed.tex}$ is supposed{where}")


def _idle_definitions(item: SourceStatement, known: Known) -> Iterator[Oddity]:
    """The definitions before a statement, in its section, of names that nothing after them has.

    What the statement names may be defined there by another letter, or behind it in its sentence.
    """
    after = [one for one in known.items if one.section is item.section]
    counts = Counter(name for one in known.items for name in one.names)
    for one in (one for one in after if one.order > item.order and one.sentence == item.sentence):
        given = known.roles[one].name in (DEFINITION, ASSUMPTION) and len(one.bare) == 1
        if given and counts[one.bare[0]] == 1 and one.members[0] == Name(one.bare[0]):
            yield Oddity(one, f"${one.bare[0]}$ is given there, and stands nowhere else")
    for one in (one for one in after if one.order < item.order):
        names = known.roles[one].names if known.roles[one].name == DEFINITION else ()
        if names and not any({*names} & later.names for later in after if later.order > one.order):
            yield Oddity(one, f"${names[0]}$ is defined and stands nowhere after it")


def _unused_definition(item: SourceStatement, known: Known) -> Iterator[Oddity]:
    """The last that gave a name a meaning before a statement, in its section, unused since.

    What the statement names, and nothing defines, may be defined there by another letter.
    """
    section = (one for one in known.items if one.section is item.section)
    up_to = [one for one in section if one.order <= item.order or one.sentence == item.sentence]
    for one in sorted(up_to, key=lambda one: -one.order):
        role = known.roles.get(one)
        names = {*role.names} if role is not None and role.name in NAMING else set[str]()
        since = [other for other in up_to if other.order > one.order]
        if names and one.order < item.order and not any(names & later.names for later in since):
            yield Oddity(one, f"${min(names)}$ is defined there, and stood nowhere since")
            return


def stranger(item: SourceStatement, name: str, known: Known) -> Iterator[Oddity]:
    """The statement in which alone a name stands of all that a claim rests on, before the claim."""
    before = (one for one in _stands_on(item, known) if one.order < item.order and is_printed(one))
    having = [one for one in before if name in one.names]
    if name not in item.names and len(having) == 1:
        yield Oddity(having[0], f"${name}$ stands here alone of what it rests on")


def _stands_on(item: SourceStatement, known: Known) -> Iterator[SourceStatement]:
    """A claim, the equations of motion for its names, and all that defines names of these."""
    names = {name for own in item.names for name in known.below(own)}
    moved = {*known.names.scalars(names)}
    rows = [
        row for law in known.laws if moved & {*law.variables, *law.mentions} for row in law.rows
    ]
    names |= {name for row in rows for own in row.names for name in known.below(own)}
    defining = (one for name in sorted(names) for one in known.definitions.get(name, ()))
    yield from dict.fromkeys((item, *rows, *defining))


def _is_circular(name: str, one: SourceStatement, known: Known) -> bool:
    """Whether what a statement gives for a name rests on this name."""
    others = one.names - {*known.roles[one].names, name}
    return any(name in known.below(other) for other in others if not known.moves(other))


def _moves_twice(name: str, one: SourceStatement, known: Known) -> bool:
    """Whether a statement and another row of a law give the rate of a name, and no other rate."""
    laws = [law.rows for law in known.laws if one in law.rows]
    rows = (row for rows in laws for row in rows if is_printed(row))
    alone = [row for row in rows if [*row.rates] == [name]]
    return one in alone and len({*alone}) > 1
