"""Integrals of which the value stands among other terms, as h in the energy T = U + h."""

from __future__ import annotations

import re
from collections.abc import Iterator

from kowalevski_cas.notation import Formula, Name, Negative, Number, Product, Sum, to_latex, total
from kowalevski_cas.reading.beginnings import is_no_more_than_constant
from kowalevski_cas.reading.cues import cue
from kowalevski_cas.reading.known import CLAIM, CONVENTION, NOTATION, Known, StatementRole
from kowalevski_cas.reading.phrases import integral_words, plain, supposing
from kowalevski_cas.reading.statements import SourceStatement
from kowalevski_cas.reading.unprinted import unprinted


def level(item: SourceStatement, known: Known) -> StatementRole | None:
    """An equation with one new name as a term by itself, which words call an integral.

    Or the first of several in a paragraph that have this name, as where variables are separated.
    """
    names = [name for name, _ in _apart(item, known)]
    if len(names) != 1 or not _is_of_state(item, known):
        return None
    (name,) = names
    if not known.varying(item.names - {name}):
        return None
    if _separates(item, name, known):
        why = f"gives the constant {plain(name)}, which others beside it have too"
        return StatementRole(CLAIM, why, "integral", value=name)
    if _is_integrated(item, name, known):
        return StatementRole(CLAIM, f"gives the constant {plain(name)}", "integral", value=name)
    if cue("deduced", item.lead) or name in known.later or not (said := integral_words(item)):
        return None
    why = f"“{said}” stands beside it; {plain(name)} is its value"
    return StatementRole(CLAIM, why, "integral", value=name)


def _separates(item: SourceStatement, name: str, known: Known) -> bool:
    """Whether others behind it in its paragraph are equations of motions with the same constant."""
    given = known.later.get(name, ())
    if given and not any(known.varying(one.names - {name}) for one in given):
        return False  # it stands for constants
    here = (one for one in known.paper.items if one.section is item.section)
    having = [one for one in here if one.paragraph == item.paragraph and name in one.names]
    beside = [one for one in having if one.formula != Name(name)]
    of_motion = (one.members and one.derives and known.varying(one.names) for one in beside)
    return len(beside) > 1 and all(of_motion) and not any(name in one.bare for one in beside)


def _is_integrated(item: SourceStatement, name: str, known: Known) -> bool:
    """Whether an equation has velocities, and a constant of which words say no more than that."""
    near = (
        one
        for one in known.paper.items
        if one.order < item.order or one.paragraph == item.paragraph
    )
    spoken_of = (one for one in near if one.formula == Name(name))
    alone = all(map(is_no_more_than_constant, spoken_of))
    given = not all(one.typed.inline and supposing(one) for one in known.later.get(name, ()))
    return alone and not given and bool(item.rates) and not cue("suppose", item.lead)


def levels_apart(known: Known, suffix: str) -> Iterator[tuple[SourceStatement, StatementRole]]:
    """These equations with the value alone on a side, by which it is defined."""
    for item, role in [*known.roles.items()]:
        if not role.value or item not in known.items:
            continue
        name, tex = role.value, dict(_apart(item, known)).get(role.value)
        if tex is None:
            continue
        id = re.sub(r"\W+", "-", f"value-{name}-{item.order}{suffix}")
        new = unprinted(known.paper, id, tex, item, f"{item.printed.place} says it")
        known.apart[item] = new
        yield new, StatementRole(CONVENTION, f"the value of {item.printed.place}", "", (name,))


def _is_of_state(item: SourceStatement, known: Known) -> bool:
    """Whether only rates stand in a statement that are velocities: the law gives higher ones."""
    orders: dict[str, int] = {}
    for law in known.laws:
        for name, order in (pair for row in law.rows for pair in row.rates.items()):
            for one in (name, *law.new):  # what is changed has the same order
                orders[one] = max(order, orders.get(one, 0))
    return all(n < orders.get(name, 0) for name, n in item.rates.items())


def _apart(item: SourceStatement, known: Known) -> list[tuple[str, str]]:
    """The new names of no functions that are terms by themselves, each with what gives it."""
    if len(item.members) != 2 or not any(isinstance(member, Sum) for member in item.members):
        return []
    found: list[tuple[str, str]] = []
    for one, other in (item.members, item.members[::-1]):
        terms = one.terms if isinstance(one, Sum) else ()
        for term in terms:
            name = _name_of(term)
            if (
                name
                and _is_new(name, item, known)
                and sum(node == Name(name) for m in item.members for node in m.nodes()) == 1
            ):
                rest = total(t for t in terms if t is not term)
                sides = (rest, other) if isinstance(term, Negative) else (other, rest)
                value = term.argument if isinstance(term, Negative) else term
                left = rf"{to_latex(sides[0])}-\left({to_latex(sides[1])}\right)"
                found.append((name, f"{left}={to_latex(value)}"))
    return found


def _is_new(name: str, item: SourceStatement, known: Known) -> bool:
    """Whether nothing is known of a name before a statement, but that it is one."""
    first = known.seen.get(name, item)
    named = first is not item and known.roles[first].name == NOTATION
    mentioned = any(name in law.mentions for law in known.laws)
    return (first is item or named) and not (
        mentioned or known.is_defined(name) or known.varies(name)
    )


def _name_of(term: Formula) -> str:
    """The name that a term is, perhaps with a sign and a number before it."""
    inner = term.argument if isinstance(term, Negative) else term
    match inner:
        case Name(name) | Product((Number(), Name(name))):
            return name
    return ""
