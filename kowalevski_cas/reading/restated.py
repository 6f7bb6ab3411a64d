"""Laws that are printed anew: for special constants, or with other terms."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence

from kowalevski_cas.reading.law import Law
from kowalevski_cas.reading.names import Names
from kowalevski_cas.reading.rows import is_row, rates_given
from kowalevski_cas.reading.statements import SourcePaper, SourceStatement
from kowalevski_cas.reading.text import references


def find_restated(items: Sequence[SourceStatement], laws: Sequence[Law]) -> list[Law]:
    """The laws that displays print anew, row for row, with what rows of the law are left."""
    found: list[Law] = []
    for display in {id(i.typed): [o for o in items if o.typed is i.typed] for i in items}.values():
        rows = [item for item in display if is_row(item)]
        if not rows or rows[0].typed.inline or any(rows[0] in law.items for law in laws):
            continue
        for law in laws:
            if (kept := _kept(law, rows)) is not None:
                found.append(Law((*kept, *rows), law.names, restates=law, momenta=law.momenta))
                break
    return found


_REPLACED = re.compile(
    r"\breplaced?\s+[^.;]*\b(?:by|with)(?:\s+the\s+(?:equations?|ones?))?[\s:,]*$"
    r"|\bin\s+place\s+of\s+[^.;]*\b(?:have|stand|appear|come|take)\w*[\s:,]*$"
    r"|\bзамен\w+\s+(?:на|уравнени\w+)[\s:,]*$"
    r"|\bвместо\s+[^.;]*\b(?:имеем|име[ею]т|получа\w+|стоят|будет)[\s:,]*$",
    re.IGNORECASE,
)
"""How words end behind which equations stand that take the place of those that they cite."""
_THESE = re.compile(r"\b(?:these|those|them|этих|этого|их)\b", re.IGNORECASE)
_NOT = re.compile(r"\b(?:not|never|cannot|if|were|не|нельзя|если)\b", re.IGNORECASE)


def replaced_law(item: SourceStatement, part: Sequence[Law], paper: SourcePaper) -> Law | None:
    """The law of another system: one before it, with the rows that a display replaces.

    Words right before the display say so, and cite what is replaced, or call it “these”.
    """
    words = item.lead
    if item.typed.inline or not _REPLACED.search(words) or _NOT.search(words):
        return None
    cited = {one for label in references(words) for one in paper.labels.get(label, ())}
    rows = [one for one in paper.items if one.typed is item.typed and is_row(one)]
    for law in part:
        these = not cited and law is part[-1] and _THESE.search(words)
        kept = _kept(law, rows) if these or cited & {*law.rows} else None
        if kept is not None and not law.change:
            apart = [one for one in item.sections if one not in law.first.sections]
            begins = apart[0].start if apart else item.sentence[0]
            return Law((*kept, *rows), law.names, momenta=law.momenta, begins=begins)
    return None


def _kept(law: Law, rows: Sequence[SourceStatement]) -> list[SourceStatement] | None:
    """What rows of a law are left where others are printed; ``None`` if these replace none.

    They give all the rates of those that they replace, of the same order and by the same time.
    """
    rated = orders_of(rows, law.names)
    own = [row for row in law.rows if rated.keys() & {*law.names.scalars(row.rates)}]
    whole = rates_given(rows, law.names) == len(rated)
    alike = orders_of(own, law.names) == rated and times_of(rows) <= times_of(own)
    if not rows or law.order >= rows[0].order or not (whole and alike):
        return None
    return [row for row in law.rows if row not in own]


def orders_of(rows: Iterable[SourceStatement], names: Names) -> dict[str, int]:
    """The names that some rows derive, with the highest orders."""
    found: dict[str, int] = {}
    for row in rows:
        for rated, order in row.rates.items():
            found |= {name: max(order, found.get(name, 0)) for name in names.scalars((rated,))}
    return found


def times_of(rows: Iterable[SourceStatement]) -> set[str]:
    """The times by which some rows are derived, as they are printed: dots are by t."""
    return {"t" if mark == "dot" else mark for row in rows for mark in row.marks}
