r"""Partial differential equations, as :math:`u_t+6uu_x+u_{xxx}=0`: no equations of motion.

They are printed before a reduction, and by themselves they are neither claimed nor judged.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from kowalevski_cas.notation import Name, Partial
from kowalevski_cas.notation.symbol import symbol
from kowalevski_cas.reading.known import OTHER, Known, StatementRole
from kowalevski_cas.reading.statements import SourceStatement

_INDEX = re.compile(r"t+|[xyzrs]+")
"""What a function is derived by, as often as it is printed."""


def partial_equation(item: SourceStatement, known: Known) -> StatementRole | None:
    """An equation with derivatives of one function by the time and by something that is at rest."""
    if not item.members or item.derives:
        return None
    found: dict[str, set[str]] = {}
    for function, by in (*_by_signs(item), *_by_indices(item, known)):
        found.setdefault(function, set()).add(by)
    several = any("t" in own and len(own) > 1 for own in found.values())
    moving = any(known.moves(by) for own in found.values() for by in own)
    if not several or moving:
        return None
    return StatementRole(OTHER, "a partial differential equation: it is not read")


def _by_signs(item: SourceStatement) -> Iterator[tuple[str, str]]:
    """The functions of which partial derivatives are printed, and by what."""
    for node in item.formula.nodes() if item.formula is not None else ():
        inner = node
        while isinstance(inner, Partial):
            inner = inner.argument
        if isinstance(node, Partial) and isinstance(inner, Name):
            yield inner.name, node.by


def _by_indices(item: SourceStatement, known: Known) -> Iterator[tuple[str, str]]:
    """The functions of which derivatives are printed by indices, if these are names of nothing."""
    for name in item.names:
        parts, given = symbol(name), (*known.later.get(name, ()), *known.definitions.get(name, ()))
        told = any(one.formula == Name(name) for one in known.items)
        told = told or known.moves(name) or any(one is not item for one in given)
        if _INDEX.fullmatch(parts.index) and not told:
            yield parts.letter, parts.index[0]
