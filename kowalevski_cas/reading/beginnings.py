r"""How motions begin: :math:`x(0)=a`, “it is released from rest at :math:`\varphi=\alpha`”.

What is said of the beginning holds at one time. It is no law and no definition; what is said of
the motion has to agree with it.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple

from kowalevski_cas.notation import Derivative, Formula, Name, Power, substitute, to_latex
from kowalevski_cas.reading.cues import cue
from kowalevski_cas.reading.initially import start_of_time
from kowalevski_cas.reading.known import ASSUMPTION, BEGINNING, Known, StatementRole
from kowalevski_cas.reading.law import Law
from kowalevski_cas.reading.statements import SourceStatement
from kowalevski_cas.reading.unprinted import unprinted

UNREAD = r"words say how the motion begins: print the values, as $x(0)=a$, $\dot x(0)=v$"
"""Why what is said of a motion is not judged."""

_TOLD = re.compile(
    r"\b(?:velocity|speed|position|displacement|angle|height|rate|point|distance|deflection|momentum)"
    r"(?:\s+(?:is|was|equals?|of))?\s*$"
    r"|\b(?:скорост|отклонени|угл|высот|положени|точк|импульс)\w*(?:\s+(?:равн\w+|есть))?\s*$",
    re.IGNORECASE,
)
"""How words end behind which a letter is a value, where they say how a motion begins."""


_GENERAL = re.compile(r"\bgeneral\b|\bобще[ей]\b", re.IGNORECASE)


_OF_ALL = re.compile(
    r"\b(?:all|every|each|any|always|identically)\b|\b(?:все|всех|люб\w+|кажд\w+|всегда)\b",
    re.IGNORECASE,
)
"""Words for what is said of all motions."""


class Beginning(NamedTuple):
    """The values of which a text says that a motion begins with them."""

    values: tuple[SourceStatement, ...] = ()
    is_unread: bool = False
    """Whether words give more of them there than can be read."""


def beginning(item: SourceStatement, known: Known) -> StatementRole | None:
    """A value at the beginning of a motion."""
    names = tuple(filter(known.moves, names_of_values(item))) if item.begins else ()
    return (
        StatementRole(ASSUMPTION, "a value at the beginning", BEGINNING, names) if names else None
    )


def names_of_values(item: SourceStatement) -> Iterator[str]:
    """The names of which, or of whose rates, a statement gives a value."""
    for member in item.members[:-1]:
        inner = member.argument if isinstance(member, Derivative) else member
        if isinstance(inner, Name):
            yield inner.name


def beginning_of(item: SourceStatement, law: Law, known: Known) -> Beginning:
    """How the motion begins of which something is said, as told last in its section."""
    before = [
        one
        for one in known.paper.items
        if one.section is item.section and one is not item
        and (one.order < item.order or one.sentence == item.sentence)
    ]  # fmt: skip
    roles = known.roles
    values = [one for one in before if one in roles and roles[one].kind == BEGINNING]
    near = [one for one in before if one.paragraph == item.paragraph]
    sentence = known.of_sentence(item.sentence)
    unread = any(_tells(one, known) for one in near) or (
        any(start_of_time(one.typed.tex) for one in sentence)
        and not any(one.begins for one in sentence)
    )
    if not values:
        return Beginning(tuple(_at_rest([*near, item], item, law, known)), unread)
    last = [one for one in values if one.paragraph == values[-1].paragraph]
    found = [*dict.fromkeys({member: one for one in last for member in one.members[:-1]}.values())]
    if not any(isinstance(member, Derivative) for one in found for member in one.members):
        found += _at_rest(found, values[-1], law, known)
    return Beginning(tuple(found), unread)


def at_start(values: Sequence[SourceStatement], known: Known) -> Iterator[SourceStatement]:
    """That the time is zero where a motion begins with some values."""
    if values:
        yield unprinted(known.paper, f"start-{values[0].order}", "t=0", values[0])


def _tells(one: SourceStatement, known: Known) -> bool:
    """Whether a letter alone is a value with which a motion begins, and not what moves."""
    fixed = isinstance(one.formula, Name) and not known.moves(one.formula.name)
    said = fixed and _TOLD.search(one.lead)
    return bool(said and cue("initially", one.words))


def is_of_all(item: SourceStatement) -> bool:
    """Whether words say of a solution that it is the general one."""
    return bool(_GENERAL.search(item.words))


def _at_rest(
    said: Sequence[SourceStatement], item: SourceStatement, law: Law, known: Known
) -> Iterator[SourceStatement]:
    """That velocities are zero, where the sentence of a statement says “from rest”."""
    if not any(cue("at rest", one.words) and cue("initially", one.words) for one in said):
        return
    for number, name in enumerate(_velocities(law)):
        yield unprinted(known.paper, f"from-rest-{item.order}-{number}", f"{name}=0", item)


def _velocities(law: Law) -> Iterator[str]:
    """The rates that are variables themselves: those below the highest, or with names."""
    for row in law.rows:
        for name, order in row.rates.items():
            if order > 1:
                yield rf"\dot{{{name}}}"
        match row.members:
            case (Derivative(Name()), Name(velocity)) if velocity in law.variables:
                yield velocity


def where_it_begins(
    item: SourceStatement, values: Sequence[SourceStatement], known: Known
) -> Iterator[SourceStatement]:
    """What an equation says where a motion begins with some values: these in their places.

    Raises ``ValueError`` if something that moves stands in it then, of which no value is given.
    """
    if not values:
        return
    by = {to_latex(member): one.members[-1] for one in values for member in one.members[:-1]}
    formula = _put(_written_out(item, known), by)
    if moving := known.varying(formula.names()):
        raise ValueError(f"where the motion begins no value is given of {moving[0]}")
    name = f"{item.printed.display.id}-{item.printed.number}-begins"
    yield unprinted(known.paper, name, to_latex(formula), item)


def _written_out(item: SourceStatement, known: Known) -> Formula:
    """An equation with what its names stand for, where that moves."""
    formula, names = item.formula, set[str]()
    assert formula is not None
    while new := {n for n in known.varying(formula.names() - names) if not known.moves(n)}:
        names |= new
        by = {name: known.definition(name, item) for name in new}
        given = {
            name: one.members[-1] for name, one in by.items() if one and one.bare[:1] == (name,)
        }
        formula = substitute(formula, given)
    return formula


def _put(formula: Formula, by: Mapping[str, Formula]) -> Formula:
    """A formula with values in the place of coordinates and velocities."""
    if isinstance(formula, Name | Derivative) and to_latex(formula) in by:
        return by[to_latex(formula)]
    return formula.map_children(lambda child: _put(child, by))


def is_of_state(item: SourceStatement, law: Law, known: Known) -> bool:
    """Whether an equation is one between coordinates and velocities: no rate in it is of a law.

    Where these stand in it themselves, no name stands for the value of an integral, or for what
    has velocities in it, as an energy.
    """
    free = not (
        any(map(known.moves, item.names))
        and (known.levels & item.names or any(known.has_velocities(n) for n in item.names))
    )
    return free and _has_velocities_only(item, [law])


def _has_velocities_only(item: SourceStatement, laws: Iterable[Law]) -> bool:
    """Whether what is derived in an equation are names, of lower orders than in some laws."""
    orders = _orders(laws)
    nodes = item.formula.nodes() if item.formula is not None else ()
    derived = [node.argument for node in nodes if isinstance(node, Derivative)]
    plain = all(isinstance(one, Name | Derivative) for one in derived)
    return plain and all(order < orders.get(name, 0) for name, order in item.rates.items())


def _orders(laws: Iterable[Law]) -> dict[str, int]:
    """The names that move by some laws, with the highest order of their rates there."""
    orders: dict[str, int] = {}
    for row in (row for law in laws for row in law.rows):
        orders |= {name: max(n, orders.get(name, 0)) for name, n in row.rates.items()}
    return orders


def gives_velocity(item: SourceStatement, known: Known) -> bool:
    """Whether an equation gives a velocity, or its square, by the place and by constants.

    What has this velocity has an equation of the second order. The constants are of the law, or
    nothing is said of them but that they are constant. Words say it of no motion at all.
    """
    if _OF_ALL.search(item.words):
        return False
    solved = [m for m in item.members if isinstance(_base(m), Derivative)]
    others = [m for m in item.members if m not in solved]
    rated = any(isinstance(node, Derivative) for member in others for node in member.nodes())
    if len(solved) != 1 or len(others) != 1 or rated:
        return False
    if not _has_velocities_only(item, known.laws):
        return False
    free = {n for n in item.names if not known.varies(n) and known.untied([n])}
    spoken_of = (one for one in known.paper.items if isinstance(one.formula, Name))
    return not any(free & one.names for one in spoken_of if not is_no_more_than_constant(one))


def _base(formula: Formula) -> Formula:
    return formula.base if isinstance(formula, Power) else formula


_CONSTANT = re.compile(r"\b(?:constants?|постоянн\w+)\b", re.IGNORECASE)


_OF_SOMETHING = re.compile(
    r"\b(?:values?|energ(?:y|ies)|its|their|moment(?:um|a)|has|have|значени\w+|энерги\w+|его|её)\b",
    re.IGNORECASE,
)
"""Words by which a letter is the constant of something that is known."""


def is_no_more_than_constant(item: SourceStatement) -> bool:
    """Whether words beside a letter call it a constant, and of nothing that is known."""
    words = f"{item.lead[-40:]} {item.tail[:40]}"
    return bool(_CONSTANT.search(words)) and not _OF_SOMETHING.search(words)
