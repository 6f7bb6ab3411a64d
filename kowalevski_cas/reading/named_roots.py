r"""Letters with an index that are roots of the equation before them: :math:`r_\pm` of one for r.

Such a letter has its name by what gives it, and that this is a root is claimed of it: the equation
has to hold with it in the place of the unknown. Of a function :math:`f(u)` it is a zero.
"""

from __future__ import annotations

import re
from dataclasses import replace

from kowalevski_cas.notation import Application, Name, Number, Relation, to_latex
from kowalevski_cas.notation.edits import substitute
from kowalevski_cas.notation.symbol import symbol
from kowalevski_cas.reading.known import CLAIM, OTHER, Known, StatementRole
from kowalevski_cas.reading.phrases import plain
from kowalevski_cas.reading.statements import SourceStatement
from kowalevski_cas.reading.unprinted import unprinted

IS_ROOT = "named root"
"""The kind of these claims."""
_ROOTS = re.compile(
    r"\b(?:roots?|zeros?|solutions?|whence|namely|solv(?:ing|e|es|ed)|these\s+are"
    r"|корн\w+|корень|нул[ья]\w*|решени\w+|откуда|решая|именно)\b",
    re.IGNORECASE,
)
"""Words by which something is found from an equation."""
_OTHER = re.compile(
    r"\b(?:approximat\w+|roughly|about|not|no|near|small|large|limit|sum|product|difference|mean"
    r"|приближ[её]нн\w+|прибл\w+|не|сумм\w+|произведени\w+|разност\w+)\b|\bif\s*$",
    re.IGNORECASE,
)
"""Words for what need be no root."""


def named_root(item: SourceStatement, known: Known) -> StatementRole | None:
    """A new letter with an index, which words find from an equation for the letter without it."""
    name = next(iter(item.bare), "")
    if not name or known.is_defined(name) or _OTHER.search(item.before):
        return None
    if equation_with_root(item, known) is None:
        return None
    why = f"words find {plain(name)} from an equation before it"
    return StatementRole(CLAIM, why, IS_ROOT, (name,))


def equation_for_roots(item: SourceStatement, known: Known) -> StatementRole | None:
    """An equation with zero of which roots are named behind it: it need not hold always."""
    if Number(0) not in item.members or item.derives:
        return None
    behind = (one for one in known.items if item.order < one.order < item.order + _NEAR)
    if not any(_equation_before(one, known) is item for one in behind):
        return None
    return StatementRole(OTHER, "roots of it are named: it is not said to hold always")


_NEAR = 8
"""So many formulas are between an equation and its roots at most."""


def equation_with_root(item: SourceStatement, known: Known) -> SourceStatement | None:
    """The equation before a statement with what it gives in the place of its unknown."""
    of = _equation_before(item, known)
    if of is None:
        return None
    name, value = item.bare[0], item.members[-1]
    letter = replace(symbol(name), index="").name
    left, right = of.members
    if isinstance(left, Application):
        left, right = right, Number(0)
    sides = (to_latex(substitute(side, {letter: value})) for side in (left, right))
    id = f"root-{item.order}-{item.printed.number}"
    return unprinted(known.paper, id, "=".join(sides), item, f"{of.printed.place}, for {name}")


def _equation_before(item: SourceStatement, known: Known) -> SourceStatement | None:
    """The equation for a letter of which it is a root, by words, with an index."""
    if len(item.members) != 2 or not item.bare or item.members[0] != Name(item.bare[0]):
        return None  # of a longer chain more is said than that its end is a root
    name, value = item.bare[0], item.members[-1]
    letter = replace(symbol(name), index="").name
    moved = any(map(known.moves, value.names() - {letter}))
    if letter == name or item.derives or moved or letter in value.names() or known.moves(name):
        return None
    before = [
        one
        for one in known.items
        if one.order < item.order
        and letter in one.names
        and isinstance(one.formula, Relation)
        and max(one.paragraph, one.section.start) == max(item.paragraph, item.section.start)
    ]
    of = next((one for one in reversed(before) if one.bare[:1] != (letter,)), None)
    if of is None or of.derives or len(of.members) != 2:  # inequalities have no members
        return None
    beside = of.sentence == item.sentence
    words = f"{of.before if beside else ''} § {of.tail} {item.before}"
    if not _ROOTS.search(words) or any(map(known.moves, of.names - {letter})):
        return None
    left = of.members[0]
    at = not isinstance(left, Application) or left.arguments == (Name(letter),)
    return of if at else None
