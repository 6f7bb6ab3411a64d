"""Things that several claims have, said once."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import TypeVar

T = TypeVar("T")


def alike(
    things: Iterable[tuple[str, T]], aspect: Callable[[T], object] = lambda thing: thing
) -> Iterator[tuple[tuple[str, ...], tuple[T, ...]]]:
    """Claims and what they have, those together that are the same in the given aspect.

    >>> list(alike([("a", 1), ("b", 2), ("c", 1)]))
    [(('a', 'c'), (1, 1)), (('b',), (2,))]
    """
    found: dict[str, list[tuple[str, T]]] = {}
    for claim, thing in things:
        found.setdefault(repr(aspect(thing)), []).append((claim, thing))
    for having in found.values():
        yield tuple(claim for claim, _ in having), tuple(thing for _, thing in having)
