r"""Coordinates of which no equation says how they move: their rates are those of any motion.

So :math:`\dot x=\dot r\cos\varphi-r\dot\varphi\sin\varphi` follows from :math:`x=r\cos\varphi`,
whatever the forces are. An equation that holds for some motions only is not judged.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from kowalevski_cas.notation import Derivative, Formula, Name, Number, PoissonBracket, Relation
from kowalevski_cas.reading.known import CLAIM, Known
from kowalevski_cas.reading.law import Law
from kowalevski_cas.reading.names import Names
from kowalevski_cas.reading.statements import SourcePaper, SourceStatement, is_numerical
from kowalevski_cas.reading.unprinted import unprinted

SOURCE = "any motion"
MOST = 3
"""Up to which order derivatives are told apart."""


def free_motion(paper: SourcePaper, names: Names) -> list[Law]:
    """The law of coordinates that move in any way; none if no formula gives what they move.

    Derivatives of one more order than can be printed vanish: no identity of lower ones rests on it.
    """
    given = {one.bare[0] for one in paper.items if one.bare and _gives(one)}
    derived = [one for one in paper.items if one.rates]
    moved = dict.fromkeys(name for one in derived for name in one.rates)
    depths = dict.fromkeys(given, 0)
    for one in [*paper.items, *paper.items]:  # what is given may be explained behind its use
        if one.bare[:1] and one.bare[0] in given:
            own = max(_depth(member, depths) for member in one.members[1:])
            depths[one.bare[0]] = max(own, depths[one.bare[0]])
    order = 1 + max((_depth(one.formula, depths) for one in derived if one.formula), default=0)
    letters = [name for name in moved if name not in given]
    parts = {part for name in letters for part in names.vectors.get(name, ())}
    if not letters or parts & {*letters} or order > MOST:
        return []
    rows = [
        unprinted(paper, f"any-motion-{k}", vanishing(name, order, names), source=SOURCE)
        for k, name in enumerate(letters, 1)
    ]
    return [Law(tuple(rows), names)]


def vanishing(name: str, order: int, names: Names) -> str:
    """That a derivative vanishes, of a coordinate, or of a vector."""
    zero = r"\mathbf{0}" if name in names.vectors else "0"
    if order == 1:
        return rf"\frac{{d{name}}}{{dt}}={zero}"
    return rf"\frac{{d^{order}{name}}}{{dt^{order}}}={zero}"


def is_free(law: Law) -> bool:
    """Whether a law is that of coordinates which move in any way."""
    return any(row.printed.display.source == SOURCE for row in law.rows)


def refuse_dynamics(law: Law, item: SourceStatement, known: Known) -> None:
    """Judge only what can hold for any motion: an equation whose members all move, as rates do.

    What has constants on one side only may be a law of motion, and so may what gives a coordinate's
    own rate.

    Raises:
        ValueError: it may hold for some motions only.
    """
    role = known.roles.get(item)
    kinematic = role is not None and role.name == CLAIM and role.kind == "identity"
    formula = item.formula
    if kinematic and not item.derives and has_bracket(formula):
        return
    if kinematic and isinstance(formula, Relation):
        sides = [{n for own in m.names() for n in known.below(own)} for m in formula.members]
        fixed = [{n for n in side if not known.varies(n)} - {*item.bare} for side in sides]
        own = [m for m in formula.members if _is_own_rate(m, law)]
        bare = [m for m in formula.members if isinstance(m, Name)]
        rest = [f for f, m in zip(fixed, formula.members, strict=True) if m not in bare]
        alike = all(one <= rest[0] for one in rest)
        if alike and not own and Number(0) not in formula.members:
            return
    name = next((n for n in law.variables if n in item.names), law.variables[0])
    raise ValueError(f"no equation says how ${name}$ moves")


def has_bracket(formula: Formula | None) -> bool:
    """Whether something is said of brackets: that is so whatever moves."""
    nodes = formula.nodes() if formula is not None else ()
    return any(isinstance(node, PoissonBracket) for node in nodes)


def _gives(one: SourceStatement) -> bool:
    """Whether a statement has a name alone on its left, and no number beside it."""
    return one.members[0] == Name(one.bare[0]) and not any(map(is_numerical, one.members))


def _depth(formula: Formula, depths: Mapping[str, int]) -> int:
    """How often something is derived in a formula, at most, with what its names stand for."""
    if isinstance(formula, Name):
        return depths.get(formula.name, 0)
    below = max((_depth(child, depths) for child in formula.children()), default=0)
    return isinstance(formula, Derivative) + below


def _is_own_rate(formula: Formula, law: Law) -> bool:
    """Whether a formula is made of one coordinate and its derivatives."""
    (name, *others) = (*formula.names(), "")
    return name in law.variables and not others[:-1] and name in {*_derived(formula)}


def _derived(formula: Formula) -> Iterator[str]:
    """The names of which derivatives stand in a formula."""
    for node in formula.nodes():
        if isinstance(node, Derivative):
            yield from node.argument.names()
