"""Laws that are printed anew: for special constants, or with other terms."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from kowalevski_cas.reading.law import Law
from kowalevski_cas.reading.laws import is_row, rates_given
from kowalevski_cas.reading.names import Names
from kowalevski_cas.reading.statements import SourceStatement


def find_restated(items: Sequence[SourceStatement], laws: Sequence[Law]) -> list[Law]:
    """The laws that displays print anew, row for row, with what rows of the law are left.

    They give all the rates of the rows in place of which they stand, of the same order and by the
    same time.
    """
    found: list[Law] = []
    for display in {id(i.typed): [o for o in items if o.typed is i.typed] for i in items}.values():
        rows = [item for item in display if is_row(item)]
        if not rows or rows[0].typed.inline or any(rows[0] in law.items for law in laws):
            continue
        for law in laws:
            rated = _orders(rows, law.names)
            own = [row for row in law.rows if rated.keys() & {*law.names.scalars(row.rates)}]
            whole = rates_given(rows, law.names) == len(rated)
            alike = _orders(own, law.names) == rated and _times(rows) <= _times(own)
            if law.order < rows[0].order and whole and alike:
                kept = tuple(row for row in law.rows if row not in own)
                found.append(Law((*kept, *rows), law.names, restates=law, momenta=law.momenta))
                break
    return found


def _orders(rows: Iterable[SourceStatement], names: Names) -> dict[str, int]:
    """The names that some rows derive, with the highest orders."""
    found: dict[str, int] = {}
    for row in rows:
        for rated, order in row.rates.items():
            found |= {name: max(order, found.get(name, 0)) for name in names.scalars((rated,))}
    return found


def _times(rows: Iterable[SourceStatement]) -> set[str]:
    """The times by which some rows are derived, as they are printed: dots are by t."""
    return {"t" if mark == "dot" else mark for row in rows for mark in row.marks}
