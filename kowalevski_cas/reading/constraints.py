r"""Constraints of a paper, beside equations of motion in which multipliers stand.

The motion is on them wherever the paper speaks of it; what they give the multipliers is derived.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Sequence
from itertools import islice

from kowalevski_cas.notation import Application, Name, Number, Power, Product, Vector
from kowalevski_cas.notation.functions import FUNCTIONS
from kowalevski_cas.notation.symbol import symbol
from kowalevski_cas.paper.claims import InvariantRelations
from kowalevski_cas.paper.constraints import MULTIPLIERS, equations_on, multipliers, orders_in
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.reading.cues import cue
from kowalevski_cas.reading.in_words import InWords
from kowalevski_cas.reading.known import (
    ASSUMPTION,
    CLAIM,
    CONSTRAINT,
    DEFINITION,
    NOTATION,
    Known,
    StatementRole,
)
from kowalevski_cas.reading.law import Law
from kowalevski_cas.reading.parts import Parts
from kowalevski_cas.reading.phrases import plain
from kowalevski_cas.reading.reactions import reactions
from kowalevski_cas.reading.rows import BINDING
from kowalevski_cas.reading.stage import Stage
from kowalevski_cas.reading.statements import SourceStatement
from kowalevski_cas.reading.text import MARK
from kowalevski_cas.reading.unprinted import is_printed, unprinted

SAYS = "the constraints give it"
KEPT = "the motion stays on its constraints"
_AND = re.compile(r"[\s,;~]*(?:and|и)?[\s~]*")
_WITH = re.compile(r"[\s,;~]*(?:and|with|и|при)?[\s~]*")
UNBOUND = "${}$ may be a multiplier: print the constraint beside, or say that it is constant"


def constraint(item: SourceStatement, known: Known) -> StatementRole | None:
    """An equation among what moves, beside equations of motion with a multiplier."""
    for law in known.laws:
        if is_constraint(item, law, known):
            for one in known.paper.alike[item.formula]:
                if one in known.items and one in known.roles and one in known.bound:
                    return StatementRole(NOTATION, f"said before, at {one.printed.place}")
            return StatementRole(ASSUMPTION, "a constraint of the motion", CONSTRAINT)
    return None


def reaction(item: SourceStatement, known: Known) -> StatementRole | None:
    """What gives a reaction, or a multiplier: it follows from the constraint of the motion."""
    if len(item.members) != 2 or not item.bare or item.members[0] != Name(item.bare[0]):
        return None
    bound = [
        one for one in known.items if one in known.roles and known.roles[one].kind == CONSTRAINT
    ]
    for law in known.laws if bound else ():
        names = {*reactions([*law.rows, *_surplus(law, known)], known.items)}
        beside = any(row.sentence == item.sentence for row in law.rows)
        pulling = {*_multipliers(law, known)}
        own = [one for one in bound if one.order < item.order]
        if len(own) <= len(pulling) and not (beside or cue("where", item.lead)):
            names |= pulling  # else the law has it from there
        if item.bare[0] in names and any(is_constraint(one, law, known) for one in bound):
            why = f"gives {plain(item.bare[0])}, which a constraint determines"
            return StatementRole(CLAIM, why, "identity")
    return None


def is_constraint(item: SourceStatement, law: Law, known: Known) -> bool:
    """Whether a statement is one for a law: of lower order, where words or the display say so.

    Where no multiplier stands in the law, its own sentence says so, or says it behind “where”.
    """
    if item in law.rows or not item.members:
        return False
    first = item.members[0]
    first = first.base if isinstance(first, Power) and first.exponent == Number(2) else first
    names = {*known.names.scalars(item.names)}
    gives = isinstance(first, Name) and not known.moves(first.name)
    gives |= isinstance(first, Application) and first.function not in FUNCTIONS
    gives |= any(isinstance(member, Vector) for member in item.members)
    moving = _moving(item, law, known)
    if gives or not moving or any(map(known.moves, names - moving)):
        return False
    orders = orders_in(row.formula for row in law.rows if row.formula is not None)
    if item.formula is None:
        return False
    if item in (surplus := _surplus(law, known)):
        return bool(reactions([*law.rows, *surplus], known.items))
    if any(o >= orders.get(n, 0) for n, o in _derived(item)):
        return False
    rows = [row for row in law.rows if row.sentence == item.sentence]
    before = [row.typed.end for row in rows if row.order < item.order]
    if pulling := [*_multipliers(law, known)]:
        if _is_of_some_motions(item, law, len(pulling), known):
            return False
        beside = any(row.typed is item.typed for row in law.rows)
        words = known.paper.prose.between(max(before), item.typed.start) if before else ""
        return (
            beside
            or _says_constraint(item)
            or bool(cue("where", words) or _is_listed(item, law, known))
            or (bool(before) and _WITH.fullmatch(words.rpartition(MARK)[2]) is not None)
        )
    if before:
        said = bool(cue("where", item.lead) or cue("constraint", item.lead))
        said = said or _is_listed(item, law, known)
        return said and names <= {*law.variables, *law.mentions}
    return bool(rows) and _says_constraint(item)


_CONSTRAINT = re.compile(r"\bconstrain|\bсвяз[ьи]|\bстеснен", re.IGNORECASE)


def _is_of_some_motions(item: SourceStatement, law: Law, many: int, known: Known) -> bool:
    """Whether an equation behind a law is satisfied by some of its motions only.

    Words speak of special motions, or as many constraints as there are multipliers stand before.
    """
    rows = law.rows
    if item.order < max(row.order for row in rows) or any(
        r.sentence == item.sentence for r in rows
    ):
        return False
    if _CONSTRAINT.search(item.words):
        return False
    before = [
        one
        for one, role in known.roles.items()
        if role.kind == CONSTRAINT and one.order < item.order and one.sentence != item.sentence
    ]
    return len(before) >= many or bool(cue("special motion", item.words))


def _moving(item: SourceStatement, law: Law, known: Known) -> set[str]:
    """The variables of a law in a statement."""
    return {*known.names.scalars(item.names)} & {*law.variables}


def _says_constraint(item: SourceStatement) -> bool:
    """Whether words beside a statement call it a constraint."""
    return any(cue(name, words) for name in BINDING for words in (item.lead, item.tail[:40]))


def _is_listed(item: SourceStatement, law: Law, known: Known) -> bool:
    """Whether a statement follows a constraint, with no more than a comma or “and” between."""
    before = [one for one in known.items if one.order < item.order]
    listed = before and before[-1].sentence == item.sentence and _AND.fullmatch(item.lead)
    return bool(listed) and is_constraint(before[-1], law, known)


def _orders_below(item: SourceStatement, law: Law, known: Known) -> int:
    """Of how many orders a constraint and its derivatives are that are below those of its law.

    Where equations of the first order say what velocities are, there is one more.
    """
    pulling = {*_multipliers(law, known)}
    orders: dict[str, int] = {}
    for row in sorted(law.rows, key=lambda row: row.names.isdisjoint(pulling)):
        pulls = pulling and row.names.isdisjoint(pulling)
        behind = max((orders.get(name, 0) for name in row.names), default=0) if pulls else 0
        orders |= {name: order + behind for name, order in row.rates.items()}
    own = dict(_derived(item))
    names = orders.keys() & item.names
    return max((orders[n] - own.get(n, 0) for n in names), default=1)


def _derived(item: SourceStatement) -> Iterator[tuple[str, int]]:
    assert item.formula is not None
    yield from orders_in([item.formula]).items()


def _is_open(name: str, known: Known) -> bool:
    """Whether nothing gives a name, or it is given by velocities: a value is that at some place."""
    giving = (one for one in known.items if one.members[:1] == (Name(name),))
    return name not in known.later or any(one.derives for one in giving)


def _multipliers(law: Law, known: Known) -> Iterator[str]:
    """The names in a law that may be multipliers: nothing gives them, or by what moves.

    Words may call another letter one, if only this stands in several equations of motion, or if
    they stand right before it. A map has none.
    """
    if law.images:
        return
    called = {
        one.formula.name
        for one in known.items
        if isinstance(one.formula, Name) and cue("multiplier", one.lead[-24:])
    }
    if found := sorted(called & law.mentions - {*law.variables}):
        yield from found
        return
    free = [
        name
        for name in sorted(law.mentions)
        if name not in law.variables and (_is_open(name, known) or known.varies(name))
    ]
    found = [name for name in free if symbol(name).letter in MULTIPLIERS]
    if not found and any(cue("multiplier", row.words) for row in law.rows):
        shared = [name for name in free if sum(name in row.names for row in law.rows) > 1]
        found = shared if len(shared) == 1 else []
    yield from found or reactions([*law.rows, *_surplus(law, known)], known.items)


def _surplus(law: Law, known: Known) -> list[SourceStatement]:
    """The equations in the sentence of a law for accelerations that it gives already."""
    orders = orders_in(row.formula for row in law.rows if row.formula is not None)
    return [
        one
        for row in law.rows[:1]
        for one in known.of_sentence(row.sentence)
        if one not in law.rows and one.rates
        and all(orders.get(name, 0) == order for name, order in one.rates.items())
    ]  # fmt: skip


def unbound_multiplier(known: Known, constants: Collection[str]) -> str:
    r"""A constant :math:`\lambda` that may be a multiplier: nothing says that it is constant.

    It stands in several equations of motion, of the second order, or with factors that do not move.
    """
    for law in known.laws:
        for name in {*constants} & {*_multipliers(law, known)}:
            rows = (len(row.rates) for row in law.rows if _pulls(row, name, known))
            first = symbol(name).letter == MULTIPLIERS[0]
            if first and sum(rows) > 1 and not _is_said_constant(name, known):
                return name
    return ""


def _pulls(row: SourceStatement, name: str, known: Known) -> bool:
    """Whether a name stands in an equation of motion as a multiplier does."""
    nodes = [*row.formula.nodes()] if row.formula is not None else []
    if not any(Name(name) in one.children() for one in nodes if not isinstance(one, Application)):
        return False  # it is an angle
    terms = [node for node in nodes if isinstance(node, Product) and Name(name) in node.factors]
    factors = [one for term in terms for one in term.factors]
    if max(row.rates.values(), default=0) > 1:
        return name in row.names and not any(orders_in([one]) for one in factors)
    return bool(terms) and not known.varying(name for one in factors for name in one.names())


def _is_said_constant(name: str, known: Known) -> bool:
    """Whether words, or what is supposed, say that a name is a constant."""
    return any(
        name in one.names
        and (
            known.roles[one].name == ASSUMPTION
            or one.is_const
            or (not one.members and cue("a constant", f"{one.lead[-40:]} § {one.tail[:40]}"))
        )
        for one in known.items
    )


def enter_constraints(parts: Parts) -> None:
    """Give the multipliers their values, and keep the derivatives of the constraints."""
    for place, known in enumerate(parts.known):
        for one in _kept(known, parts.known[:place]):
            known.enter(one, parts.roles[one])
        suffix = f"-{place + 1}" if place else ""
        for law in (law for law in known.laws if not law.change):  # in new names it has the same
            bound = [
                one
                for one in (*known.items, *_kept(known, parts.known[:place]))
                if parts.roles[one].kind == CONSTRAINT and is_constraint(one, law, known)
            ]
            called = any(cue("multiplier", item.words) for item in known.items)
            if not bound and not called:
                continue
            try:
                found = [*_implied(law, bound, known, suffix)]
                if not [*_multipliers(law, known)] and not _keeps(
                    law, [*bound, *dict(found)], known
                ):
                    for one in bound:  # words that come before a law say what nothing makes true
                        known.assumptions.remove(one)
                        parts.enter(one, StatementRole(CLAIM, KEPT, "identity"))
                    continue
            except (ValueError, Meaningless) as error:
                known.lost |= dict.fromkeys(_multipliers(law, known), str(error))
                continue
            for item, role in found:
                parts.places[item] = place
                parts.enter(item, role)


def _kept(known: Known, before: Sequence[Known]) -> list[SourceStatement]:
    """The constraints of a part before of which equations of motion are kept, and others replaced.

    A constraint that is printed anew takes the place of all.
    """
    own = any(known.roles[one].kind == CONSTRAINT for one in known.items)
    rows = {row for law in known.laws for row in law.items}
    earlier = (one for one in reversed(before) if any(rows & {*law.items} for law in one.laws))
    last = None if own else next(earlier, None)
    return [one for one in last.bound if is_printed(one)] if last else []


def _keeps(law: Law, bound: list[SourceStatement], known: Known) -> bool:
    """Whether a law without multipliers keeps constraints, with their derivatives."""
    places = [one.printed for one in bound]
    found = equations_on(Stage(known).scene([*bound, *law.items], law=law).scene, places)
    return len([*islice(found, len(places) + 1)]) <= len(places)


def claims_of_constraints(parts: Parts) -> Iterator[InWords]:
    """That a law keeps its constraints, where its multipliers are printed and not derived."""
    for known in parts.known:
        for law in known.laws:
            bound = tuple(one for one in known.bound if _moving(one, law, known))
            given = [known.definitions.get(name, ()) for name in _multipliers(law, known)]
            if bound and all(one and all(map(is_printed, one)) for one in given):
                relations: dict[str, object] = {"relations": tuple(one.printed for one in bound)}
                span = (bound[0].typed.start, bound[0].typed.end)
                last = max((*law.rows, *bound), key=lambda one: one.order)
                yield InWords(
                    span, InvariantRelations, bound, relations, CONSTRAINT, KEPT, last, law
                )


def _implied(
    law: Law, bound: list[SourceStatement], known: Known, suffix: str
) -> Iterator[tuple[SourceStatement, StatementRole]]:
    """What gives the multipliers of a law, and the derivatives of its constraints."""
    names = [name for name in _multipliers(law, known) if not known.is_defined(name)]
    if not bound:
        raise ValueError(f"{', '.join(names)}: a multiplier, and no constraint is read")
    stage, places = Stage(known), [one.printed for one in bound]
    scene = stage.scene(bound, law=law).scene
    for number, tex in enumerate(multipliers(scene, places, names) if names else (), 1):
        item = unprinted(known.paper, f"multiplier-{number}{suffix}", tex, law.first, SAYS)
        role = StatementRole(DEFINITION, "follows from the constraints", "", item.bare[:1])
        known.enter(item, role)
        yield item, role
    scene = Stage(known).scene([*bound, *law.items], law=law).scene
    for one in bound:
        others = [other.printed for other in bound if other is not one]
        found = equations_on(scene, (one.printed,), others)
        derived = islice(found, _orders_below(one, law, known))
        for number, tex in enumerate([*derived][1:], 1):
            id = f"derivative-{number}-of-{one.printed.display.id}{one.printed.number}{suffix}"
            item = unprinted(known.paper, id, tex, one, "the derivative of a constraint")
            yield item, StatementRole(ASSUMPTION, "the derivative of a constraint", CONSTRAINT)
