"""Which claim rests on which, as boxes and lines, in millimetres, whatever draws them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from graphlib import CycleError, TopologicalSorter
from typing import Final

from kowalevski_cas.notation import to_plain
from kowalevski_cas.report.graph.layout import WIDTH, layout
from kowalevski_cas.verify.outcome import WORST, Outcome, Verdict

BOX: Final = 5.0
"""The height of a box."""

LETTER: Final = 1.32
"""The width of a letter in a box."""

_HEIGHT: Final = 205.0
_LAYER: Final = 10.5


@dataclass(frozen=True)
class Box:
    """A claim, or several of one display, at its place (the centre, in mm).

    ``says`` is what it states, in plain text.
    """

    name: str
    label: str
    says: str
    verdict: Verdict
    x: float
    y: float
    width: float


@dataclass(frozen=True)
class Arrow:
    """A piece of a line from what is rested on to what rests on it; the last one has a tip.

    ``names`` has the boxes that it joins, the one where it begins first. It is ``cited`` if only
    the paper says so.
    """

    start: tuple[float, float]
    end: tuple[float, float]
    tip: bool
    cited: bool
    names: tuple[str, ...]


@dataclass(frozen=True)
class Drawing:
    """Boxes and lines; ``alone`` names the claims that rest on nothing and carry nothing."""

    boxes: tuple[Box, ...]
    lines: tuple[Arrow, ...]
    width: float
    height: float
    alone: tuple[str, ...] = ()

    @property
    def scale(self) -> float:
        """The factor that brings the picture to the size of a page."""
        if not self.boxes:
            return 1.0
        return min(1.0, 0.999 * WIDTH / self.width, _HEIGHT / self.height)


def picture(outcomes: Sequence[Outcome], labels: Mapping[str, str]) -> Drawing:
    """Lay out the claims that rest on others, foundations at the top; one label is one box."""
    members, rests, cited = dependencies(outcomes, labels)
    carried = {below for belows in rests.values() for below in belows}
    drawn = {name: belows for name, belows in rests.items() if belows or name in carried}
    alone = tuple(claim for name in members if name not in drawn for claim in members[name])
    if not drawn:
        return Drawing((), (), 0.0, 0.0, alone)
    verdicts = {o.claim: o.verdict for o in outcomes}
    stated = {o.claim: ", ".join(map(to_plain, o.formulas)) for o in outcomes}
    says = {name: "; ".join(filter(None, map(stated.get, members[name]))) for name in drawn}
    layers = layout(drawn, {name: LETTER * len(labels[name]) + 8.0 for name in drawn}, cited)
    edges = [(c.x - c.width / 2, c.x + c.width / 2) for layer in layers for c in layer]
    left, right = min(e[0] for e in edges) - 0.5, max(e[1] for e in edges) + 0.5

    def y(layer: int) -> float:
        return 0.5 + BOX / 2 + layer * _LAYER

    boxes = tuple(
        Box(
            cell.name,
            labels[cell.name],
            says[cell.name],
            min((verdicts[c] for c in members[cell.name]), key=WORST.index),
            cell.x - left,
            y(k),
            cell.width,
        )
        for k, layer in enumerate(layers)
        for cell in layer
        if cell.box
    )
    lines = tuple(
        Arrow(
            (cell.x - left, y(k) + (BOX / 2 if cell.box else 0)),
            (above.x - left, y(k + 1) - (BOX / 2 if above.box else 0)),
            above.box,
            above.cited or (cell.name, above.name) in cited,
            (cell.name, *above.ends()),
        )
        for k, layer in enumerate(layers)
        for cell in layer
        for above in cell.after
    )
    return Drawing(boxes, lines, right - left, y(len(layers) - 1) + BOX / 2 + 0.5, alone)


def dependencies(
    outcomes: Sequence[Outcome], labels: Mapping[str, str]
) -> tuple[dict[str, list[str]], dict[str, list[str]], set[tuple[str, str]]]:
    """The claims of each box, the boxes that it rests on, and which of these are only cited.

    There are no circles, and nothing twice.

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
            proved = _between(boxes, [outcome._replace(cites=()) for outcome in outcomes])
            drawn = _reduce(rests, order)
            cited = {(b, a) for a, belows in drawn.items() for b in belows if b not in proved[a]}
            return {box[0]: box for box in boxes}, drawn, cited


def _between(boxes: Sequence[list[str]], outcomes: Sequence[Outcome]) -> dict[str, list[str]]:
    """The boxes on which each box rests."""
    home = {claim: box[0] for box in boxes for claim in box}
    rests: dict[str, dict[str, None]] = {box[0]: {} for box in boxes}
    earlier: set[str] = set()
    for outcome in outcomes:
        known = (*outcome.rests_on, *outcome.cites)
        below = (home[claim] for claim in known if claim in earlier)
        rests[home[outcome.claim]] |= dict.fromkeys(below)
        earlier.add(outcome.claim)
    return {name: [below for below in belows if below != name] for name, belows in rests.items()}


def _apart(boxes: Sequence[list[str]], names: Sequence[str]) -> Iterator[list[str]]:
    """The boxes, of which those with these names are taken apart."""
    for box in boxes:
        yield from [[claim] for claim in box] if box[0] in names else [box]


def _reduce(rests: dict[str, list[str]], order: Sequence[str]) -> dict[str, list[str]]:
    """The same without the lines that follow from others."""
    below_all: dict[str, set[str]] = {}
    for name in order:
        below_all[name] = set(rests[name]).union(*(below_all[b] for b in rests[name]))
    return {
        name: [b for b in belows if not any(b in below_all[o] for o in belows if o != b)]
        for name, belows in rests.items()
    }
