r"""Brackets without equations of motion: coordinates of a phase space in which nothing moves.

So :math:`\{x_i,p_j\}=\delta_{ij}` is printed, and what the brackets of functions are is claimed.
"""

from __future__ import annotations

from collections.abc import Iterator

from kowalevski_cas.notation import Name, PoissonBracket
from kowalevski_cas.notation.symbol import symbol
from kowalevski_cas.reading.kinematics import vanishing
from kowalevski_cas.reading.law import Law
from kowalevski_cas.reading.names import Names
from kowalevski_cas.reading.statements import SourcePaper
from kowalevski_cas.reading.unprinted import unprinted

_INDICES = ("i", "j", "k")


def free_brackets(paper: SourcePaper, names: Names) -> list[Law]:
    """The law of what brackets are printed of, and no rates: it moves in any way.

    What a statement gives, itself or as a vector, is a function of that.
    """
    if any(item.derives for item in paper.items):
        return []
    letters = [*dict.fromkeys(_coordinates(paper, names))]
    rows = (
        unprinted(paper, f"any-point-{k}", vanishing(x, 1, names), source="any motion")
        for k, x in enumerate(letters, 1)
    )
    return [Law(tuple(rows), names)] if letters else []


def _coordinates(paper: SourcePaper, names: Names) -> Iterator[str]:
    """The names in brackets on a left side that nothing gives, for all values of their indices."""
    given = {one.bare[0] for one in paper.items if one.bare and one.members[0] == Name(one.bare[0])}
    for item in paper.items:
        for one in item.members[:-1]:
            match one:
                case PoissonBracket(Name(x), Name(y)):
                    found = [*_components(x, names), *_components(y, names)]
                    if given.isdisjoint({*found, *map(names.whole, found)}):
                        yield from found
                case _:
                    break


def _components(name: str, names: Names) -> tuple[str, ...]:
    """A name; all components of the vector of which it is one, if it has a letter as its index."""
    parts = symbol(name)
    if parts.index not in _INDICES:
        return (name,)
    own = (v for v in names.vectors.values() if all(symbol(n).head == parts.head for n in v))
    return next(own, (name,))
