r"""Solutions that a paper gives by the time, as :math:`x=2\operatorname{sech}t`.

The equations are those of the law, or for what the law does not move those that the paper prints
for its rate. What stands in them and is not given may be a rate of what is: by
:math:`\dot x=y` that is so of :math:`y`, and then the equation for its rate has to hold as well.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Sequence
from functools import reduce
from itertools import takewhile
from typing import NamedTuple

from flint import acb_mat

from kowalevski_cas.algebra.keys import is_initial
from kowalevski_cas.algebra.samples import Sample, Valueless, is_zero, precisely
from kowalevski_cas.notation import (
    Derivative,
    Formula,
    Name,
    Number,
    Partial,
    Power,
    Relation,
    to_latex,
    to_plain,
)
from kowalevski_cas.reading.cues import cue
from kowalevski_cas.reading.known import CLAIM, DEFINITION, LEVEL, Known, StatementRole
from kowalevski_cas.reading.law import Law
from kowalevski_cas.reading.rows import is_row
from kowalevski_cas.reading.statements import SourceStatement
from kowalevski_cas.reading.unprinted import unprinted


class PrintedSolution(NamedTuple):
    """What gives names by the time, or constants in that, and the equations that then hold."""

    given: tuple[SourceStatement, ...]
    rows: tuple[SourceStatement, ...]


def rated_before(name: str, item: SourceStatement, known: Known) -> bool:
    """Whether an equation for the rate of a name is printed before a statement."""
    return any(name in one.rates and one.order < item.order for one in known.items)


def solution_of(
    item: SourceStatement, beside: Sequence[SourceStatement], law: Law | None, known: Known
) -> PrintedSolution:
    """The solution that a statement gives with those beside it.

    Raises:
        ValueError: something stands in its equations that is not given by the time.
    """
    given = {name: one for each in (*beside, item) for name, one in _given(each, known)}
    own = [name for name in item.bare if name in given]
    linked = {*own}
    every = law.rows if law is not None else (*_printed_rows(item, given.keys(), known),)
    rows = [*_rows_of(own, every)]
    for row in rows:
        for name in sorted(row.names):
            if not (known.varies(name) or name in row.rates) or name in linked:
                continue
            linked.add(name)
            rows += [other for other in _rows_of([name], every) if other not in rows]
            if name in given:
                continue
            if (fixed := _fixed(name, item, known)) is not None:
                given[name] = fixed
                continue
            by = _rate_of(name, every, given.keys())
            if by is None:
                raise ValueError(
                    "by the time not all is given that stands in its equation of motion"
                )
            tex = to_latex(Relation((Name(name), by), ("=",)))
            given[name] = unprinted(known.paper, f"{_id(item)}-{len(given)}", tex, item)
    if not rows:
        raise ValueError("no equation is printed that it would solve")
    by_time = dict.fromkeys(given[name] for name in given if name in linked)
    return PrintedSolution((*by_time, *constants_of(item, known)), (*rows,))


ALL = re.compile(
    r"\b(?:general|complete|most\s+general)\s+(?:\w+\s+)?(?:solutions?|integral)\b"
    r"|\b(?:all|every|any|each|the\s+only|(?:a|the)\s+unique)\s+(?:\w+\s+)?solutions?\b|\bintegrat(?:ing|ion)\b"
    r"|\bобщ(?:ее|его|им|ему|ем)\s+решени|\b(?:вс[её]|все|всякое|любое)\s+решени|\bинтегриру\w+",
    re.IGNORECASE,
)
"""Words for all solutions."""


def levels_in(
    found: PrintedSolution, item: SourceStatement, known: Known
) -> dict[str, SourceStatement]:
    r"""The values of integrals by which a solution is given, as in :math:`x=\sqrt{2E}\cos t`.

    They are constants there, and what names them has to hold of the solution as well.
    """
    solved = {name for one in found.given for name in one.bare} - known.levels
    names = {name for one in found.given for name in one.names} - solved
    by = {name: known.definition(name, item) for name in names}
    return {
        name: one
        for name, one in by.items()
        if one is not None
        and (known.roles[one].kind == "integral" or known.roles[one].name == LEVEL)
        and solved & {*known.below(name)}
    }


def lacking(
    found: Sequence[PrintedSolution], law: Law | None, known: Known, levels: Collection[str] = ()
) -> int:
    r"""How many constants solutions have less together than all those of their equations have.

    Those count that change the state alone: of :math:`a\cos t+b\cos t` it is one.
    """
    orders: dict[str, int] = {}
    for row in (row for each in found for row in each.rows):
        orders |= {name: max(n, orders.get(name, 0)) for name, n in row.rates.items()}
    given = {one for each in found for one in each.given}
    mentioned = set[str]() if law is None else {one for n in law.mentions for one in known.below(n)}
    printed = {name for one in given for name in one.names} - mentioned - known.times
    moved = {n for n in printed if known.varies(n) and not is_initial(n)}
    given_by = {n for n in printed if known.is_defined(n) or n in orders}
    free = [n for n in printed if n in levels or n not in moved | given_by]
    by_time = {one.bare[0]: one.members[-1] for one in given if one.bare and len(one.members) == 2}
    state = [
        reduce(Partial, ["t"] * k, by_time[name])
        for name, order in sorted(orders.items())
        if name in by_time
        for k in range(order)
    ]
    return max(sum(orders.values()) - changes_of(state, free), 0)


def changes_of(state: Sequence[Formula], free: Sequence[str]) -> int:
    """In how many independent ways constants change what is given by them, at a sample."""
    sample = Sample(1, {}, (), {}, "t")
    with precisely():
        try:
            rows = [[sample.value(Partial(one, name)) for one in state] for name in free]
        except (Valueless, ArithmeticError):
            return len(free)
        slopes = acb_mat(rows)
        powers = (slopes * slopes.conjugate().transpose()).charpoly().coeffs()
        return len(free) - len([*takewhile(is_zero, powers)])


def _given(item: SourceStatement, known: Known) -> Iterator[tuple[str, SourceStatement]]:
    """The names that a statement gives, each with what gives it alone."""
    for name in item.bare:
        if not known.varies(name) and not any(name in one.rates for one in known.items):
            continue
        if item.members[0] == Name(name):
            yield name, item
        else:
            tex = to_latex(Relation((Name(name), item.members[-1]), ("=",)))
            yield name, unprinted(known.paper, f"{_id(item)}-{len(tex)}-{name}", tex, item)


def _id(item: SourceStatement) -> str:
    return f"{item.printed.display.id}-{item.printed.number}-by-time"


_CASE = re.compile(r"\s*(?:if|when|for|let|suppose|если|при|когда|пусть)\b[^§]*$", re.IGNORECASE)
"""How a sentence begins that speaks of a case, and not of the solution in general."""
_NEXT = 1
"""So many sentences behind a solution may say what its constants are."""


def constants_of(item: SourceStatement, known: Known) -> list[SourceStatement]:
    r"""What gives constants of a solution, or their squares, beside it or in the next sentence.

    So :math:`x=a\operatorname{cn}(pt,k)` is found to be one where :math:`p^2=b+ca^2`.
    """
    mentioned = {name for law in known.laws for name in law.mentions}
    own = {name for name in item.names - mentioned - {"t"} if not known.varies(name)}
    found: dict[str, SourceStatement] = {}
    for one in known.items:
        name = _constant_given(one, own)
        fixed = name and not (one.derives or known.varying(one.names))
        if fixed and one.order > item.order and _is_next(one, item, known):
            found.setdefault(name, one)
    return [*found.values()]


def constant_of_solution(item: SourceStatement, known: Known) -> StatementRole | None:
    """What gives a constant of the solution before it: it says for which one this is a solution."""
    for one, role in known.roles.items():
        if role.kind == "solution" and one.order < item.order and item in constants_of(one, known):
            name = _constant_given(item, one.names)
            if known.is_defined(name) and known.definitions[name][-1].section is item.section:
                return None
            why = f"gives the constant {to_plain(Name(name))} of the solution before it"
            squared = not isinstance(item.members[0], Name)
            return StatementRole(DEFINITION, why, "square" if squared else "", (name,))
    return None


def _constant_given(one: SourceStatement, own: Collection[str]) -> str:
    """The name among some of which an equation gives the value, or the square; or none."""
    match one.members:
        case (Name(name) | Power(Name(name), Number(2)), value) if name in own:
            return "" if name in value.names() else name
    return ""


def _is_next(one: SourceStatement, item: SourceStatement, known: Known) -> bool:
    """Whether a statement stands in the sentence of a solution, or in the next one."""
    apart = one.sentence != item.sentence
    if one.section is not item.section or (apart and _CASE.match(one.before)):
        return False
    between = {o.sentence for o in known.items if item.order < o.order <= one.order}
    return len(between - {item.sentence}) <= _NEXT


def _rows_of(names: Sequence[str], rows: Sequence[SourceStatement]) -> Iterator[SourceStatement]:
    """The equations with derivatives of highest order of some names."""
    yield from (row for row in rows if {*names} & {*_highest(row)})


def _highest(row: SourceStatement) -> list[str]:
    most = max(row.rates.values(), default=0)
    return [name for name, order in row.rates.items() if order == most]


def _fixed(name: str, item: SourceStatement, known: Known) -> SourceStatement | None:
    """The statement that gives a variable by constants: before another, or in its sentence."""
    for one in known.items:
        near = one.order < item.order or one.sentence == item.sentence
        if not near or one.paragraph != item.paragraph or one.derives or one.begins:
            continue
        given = dict(_given(one, known)) if len(one.members) > 1 else {}
        value = one.members[-1].names() - known.levels if given else set()
        if name in given and not (known.varying(value) or value & known.times):
            return given[name]
    return None


def _rate_of(name: str, rows: Sequence[SourceStatement], given: Collection[str]) -> Formula | None:
    """The rate that a name is by one of the equations, of what is given."""
    for row in rows:
        match row.members:
            case (Derivative(Name(of)) as rate, Name(other)) if other == name and of in given:
                return rate
    return None


def _printed_rows(
    item: SourceStatement, given: Collection[str], known: Known
) -> Iterator[SourceStatement]:
    """The equations that are claimed before of the rates of what is given, and of nothing else.

    What is said on a set, or for special constants that are others here, is not said of it.
    """
    here = known.supposed(item)
    for row in known.items:
        role = known.roles.get(row)
        if row.order < item.order and is_row(row) and role is not None and role.name == CLAIM:
            if cue("on it", row.before) or not {*known.supposed(row)} <= {*here}:
                continue
            if {*row.rates} <= {*given} and {*known.varying(row.names)} <= {*given}:
                yield row
