r"""Indices that are taken modulo a number: :math:`q_4` is :math:`q_1`, where words say so."""

from __future__ import annotations

import re

from kowalevski_cas.reading.known import CONVENTION, StatementRole
from kowalevski_cas.reading.parts import Parts
from kowalevski_cas.reading.statements import is_closing
from kowalevski_cas.reading.unprinted import unprinted

_INDEXED = re.compile(r"(?P<letter>.+)_\{?(?P<index>\d+)\}?")


def enter_cyclic_names(parts: Parts) -> None:
    """Give names of which the index lies beside its period the meaning of those within it."""
    period = parts.paper.period
    for place, known in enumerate(parts.known) if period else ():
        names = frozenset().union(*(item.names for item in known.items))
        closed = {name for item in known.items if is_closing(item, period) for name in item.bare}
        for name in sorted(names - closed):
            found = _INDEXED.fullmatch(name)
            if (
                found is None
                or not {f"{found['letter']}_{k}" for k in range(1, period + 1)} & names
            ):
                continue  # it belongs to no family, as an initial value
            if not 1 <= (index := int(found["index"])) <= period:
                tex = f"{name}={found['letter']}_{(index - 1) % period + 1}"
                id = re.sub(r"\W+", "-", f"period-of-{name}-{place + 1}")
                item = unprinted(parts.paper, id, tex)
                parts.places[item] = place
                why = f"indices are taken modulo {period}"
                parts.enter(item, StatementRole(CONVENTION, why, "", (name,)))
