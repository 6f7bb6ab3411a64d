"""Integrals of which the value stands among other terms, as h in the energy T = U + h."""

from __future__ import annotations

import re
from collections.abc import Iterator

from kowalevski_cas.notation import Formula, Name, Negative, Number, Product, Sum, to_latex, total
from kowalevski_cas.reading.cues import cue
from kowalevski_cas.reading.known import CLAIM, CONVENTION, Known, StatementRole
from kowalevski_cas.reading.phrases import integral_words, plain
from kowalevski_cas.reading.statements import SourceStatement
from kowalevski_cas.reading.unprinted import unprinted


def level(item: SourceStatement, known: Known) -> StatementRole | None:
    """An equation that words call an integral, with one new name as a term by itself."""
    found = _apart(item, known)
    if found is None or not _is_of_state(item, known) or cue("deduced", item.lead):
        return None
    if not (said := integral_words(item)):
        return None
    name = found[0]
    mentioned = any(name in law.mentions for law in known.laws)
    used = mentioned or known.is_known(name) or name in known.later or known.moves(name)
    if used or not known.varying(item.names - {name}):
        return None
    why = f"“{said}” stands beside it; {plain(name)} is its value"
    return StatementRole(CLAIM, why, "integral")


def levels_apart(known: Known, suffix: str) -> Iterator[tuple[SourceStatement, StatementRole]]:
    """These equations with the value alone on a side, by which it is defined."""
    for item, role in [*known.roles.items()]:
        own = role.kind == "integral" and not role.names and item in known.items
        found = _apart(item, known) if own and _is_of_state(item, known) else None
        if found is None or known.is_defined(found[0]) or known.seen.get(found[0]) is not item:
            continue
        name, tex = found
        id = re.sub(r"\W+", "-", f"value-{name}-{item.order}{suffix}")
        new = unprinted(known.paper, id, tex, item, f"{item.printed.place} says it")
        known.apart[item] = new
        yield new, StatementRole(CONVENTION, f"the value of {item.printed.place}", "", (name,))


def _is_of_state(item: SourceStatement, known: Known) -> bool:
    """Whether only rates stand in a statement that are velocities: the law gives higher ones."""
    rates = [row.rates for law in known.laws for row in law.rows]
    orders = {name: max((one.get(name, 0) for one in rates), default=0) for name in item.rates}
    return all(n < orders[name] for name, n in item.rates.items())


def _apart(item: SourceStatement, known: Known) -> tuple[str, str] | None:
    """The only name of no function that is a term by itself, with what gives it; or ``None``."""
    if len(item.members) != 2 or not any(isinstance(member, Sum) for member in item.members):
        return None
    found: list[tuple[str, str]] = []
    for one, other in (item.members, item.members[::-1]):
        terms = one.terms if isinstance(one, Sum) else ()
        for term in terms:
            name = _name_of(term)
            if (
                name
                and not known.varies(name)
                and sum(node == Name(name) for m in item.members for node in m.nodes()) == 1
            ):
                rest = total(t for t in terms if t is not term)
                sides = (rest, other) if isinstance(term, Negative) else (other, rest)
                value = term.argument if isinstance(term, Negative) else term
                left = rf"{to_latex(sides[0])}-\left({to_latex(sides[1])}\right)"
                found.append((name, f"{left}={to_latex(value)}"))
    return found[0] if len(found) == 1 else None


def _name_of(term: Formula) -> str:
    """The name that a term is, perhaps with a sign and a number before it."""
    inner = term.argument if isinstance(term, Negative) else term
    match inner:
        case Name(name) | Product((Number(), Name(name))):
            return name
    return ""
