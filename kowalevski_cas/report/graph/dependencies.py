"""Which claim rests on which: the lines worth drawing, between the boxes worth drawing."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from graphlib import CycleError, TopologicalSorter

from kowalevski_cas.verify.outcome import Outcome


def dependencies(
    outcomes: Sequence[Outcome], labels: Mapping[str, str]
) -> tuple[dict[str, list[str]], dict[str, list[str]]]:
    """The claims of each box, and the boxes that it rests on: no circles, nothing twice.

    A box is called by its first claim. Claims with the same label share one, if no boxes then rest
    on each other; claims never do, since each rests on earlier ones.
    """
    together: dict[str, list[str]] = {}
    for outcome in outcomes:
        together.setdefault(labels[outcome.claim], []).append(outcome.claim)
    boxes = [*together.values()]
    while True:
        rests = _between(boxes, outcomes)
        try:
            order = [*TopologicalSorter(rests).static_order()]
        except CycleError as error:
            boxes = [*_apart(boxes, error.args[1])]
        else:
            return {box[0]: box for box in boxes}, _reduced(rests, order)


def _between(boxes: Sequence[list[str]], outcomes: Sequence[Outcome]) -> dict[str, list[str]]:
    """The boxes on which each box rests."""
    home = {claim: box[0] for box in boxes for claim in box}
    rests: dict[str, dict[str, None]] = {box[0]: {} for box in boxes}
    earlier: set[str] = set()
    for outcome in outcomes:
        below = (home[claim] for claim in outcome.rests_on if claim in earlier)
        rests[home[outcome.claim]] |= dict.fromkeys(below)
        earlier.add(outcome.claim)
    return {name: [one for one in belows if one != name] for name, belows in rests.items()}


def _apart(boxes: Sequence[list[str]], names: Sequence[str]) -> Iterator[list[str]]:
    """The boxes, of which those with these names are taken apart."""
    for box in boxes:
        yield from [[claim] for claim in box] if box[0] in names else [box]


def _reduced(rests: dict[str, list[str]], order: Sequence[str]) -> dict[str, list[str]]:
    """The same without the lines that follow from others."""
    below_all: dict[str, set[str]] = {}
    for name in order:
        below_all[name] = set(rests[name]).union(*(below_all[b] for b in rests[name]))
    return {
        name: [b for b in belows if not any(b in below_all[o] for o in belows if o != b)]
        for name, belows in rests.items()
    }
