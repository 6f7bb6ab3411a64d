r"""The law of variations: that of what varies, varied; what a paper prints of it is claimed."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from kowalevski_cas.notation import Derivative, Formula, Name, Partial, times, to_latex, total
from kowalevski_cas.notation.symbol import rate_name, symbol
from kowalevski_cas.reading.known import Known
from kowalevski_cas.reading.law import Law
from kowalevski_cas.reading.statements import SourcePaper, SourceStatement
from kowalevski_cas.reading.unprinted import unprinted

MARKS = (r"\delta", r"\Delta")
"""The letters that make variations."""


def with_varied(laws: Sequence[Law], paper: SourcePaper) -> Iterator[Law]:
    """Laws in which those of variations are what the laws before them give."""
    for place, law in enumerate(laws):
        found = (one for base in laws[:place] if (one := _varied(law, base, paper)) is not None)
        yield next(found, law)


def is_varied(item: SourceStatement, known: Known) -> bool:
    """Whether a statement derives a variation: near which motion, words may say elsewhere."""
    parts = map(symbol, item.rates)
    return any(one.letter in MARKS and known.moves(one.index) for one in parts)


def _varied(law: Law, base: Law, paper: SourcePaper) -> Law | None:
    """The law of the variations that a law moves, as another one gives it; if it gives all."""
    for mark in MARKS:
        names = {x: f"{mark}_{{{x}}}" if len(x) > 1 else f"{mark}_{x}" for x in base.variables}
        if {*law.variables} - {*base.variables} != {*names.values()}:
            continue
        rows = [_varied_row(row, names) for row in base.rows]
        if all(rows):
            why = f"the variation of {base.title}"
            items = (
                unprinted(paper, f"varied-{mark[1:]}-{k}", tex, law.first, why)
                for k, tex in enumerate(rows, 1)
            )
            return Law((*items,), law.names, base=base)
    return None


def _varied_row(row: SourceStatement, names: dict[str, str]) -> str:
    """The equation of a variation; empty if a row does not give the rate of one name."""
    if len(row.members) != 2:
        return ""
    left, force = row.members
    inner, order = left, 0
    while isinstance(inner, Derivative):
        inner, order = inner.argument, order + 1
    if not isinstance(inner, Name) or inner.name not in names or not order:
        return ""
    terms: list[Formula] = []
    for name, variation in names.items():
        for _ in range(order):
            slope = Partial(force, name)
            terms.append(times(slope, Name(variation)))
            name, variation = rate_name(name), rate_name(variation)
    rate = rate_name(names[inner.name])
    for _ in range(order - 1):
        rate = rate_name(rate)
    return f"{rate}={to_latex(total(terms))}"
