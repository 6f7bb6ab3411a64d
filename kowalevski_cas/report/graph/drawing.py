"""Boxes and lines, in millimetres: what there is to draw, whatever draws it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Final

from kowalevski_cas.notation import to_plain
from kowalevski_cas.report.graph.dependencies import dependencies
from kowalevski_cas.report.graph.layout import WIDTH, layout
from kowalevski_cas.verify.outcome import WORST, Outcome, Verdict

BOX: Final = 5.0
"""The height of a box."""

LETTER: Final = 1.32
"""The width of a letter in a box."""

_HEIGHT: Final = 205.0
_LAYER: Final = 13.0


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
class Line:
    """A piece of a line from what is rested on to what rests on it; the last one has a tip."""

    start: tuple[float, float]
    end: tuple[float, float]
    tip: bool


@dataclass(frozen=True)
class Picture:
    """Boxes and lines; ``alone`` names the claims that rest on nothing and carry nothing."""

    boxes: tuple[Box, ...]
    lines: tuple[Line, ...]
    width: float
    height: float
    alone: tuple[str, ...] = ()

    @property
    def scale(self) -> float:
        """The factor that brings the picture to the size of a page."""
        if not self.boxes:
            return 1.0
        return min(1.0, 0.999 * WIDTH / self.width, _HEIGHT / self.height)


def picture(outcomes: Sequence[Outcome], labels: Mapping[str, str]) -> Picture:
    """Lay out the claims that rest on others, foundations at the top; one label is one box."""
    members, rests = dependencies(outcomes, labels)
    carried = {below for belows in rests.values() for below in belows}
    drawn = {name: belows for name, belows in rests.items() if belows or name in carried}
    alone = tuple(claim for name in members if name not in drawn for claim in members[name])
    if not drawn:
        return Picture((), (), 0.0, 0.0, alone)
    verdicts = {o.claim: o.verdict for o in outcomes}
    stated = {o.claim: ", ".join(map(to_plain, o.formulas)) for o in outcomes}
    says = {name: "; ".join(filter(None, map(stated.get, members[name]))) for name in drawn}
    layers = layout(drawn, {name: LETTER * len(labels[name]) + 8.0 for name in drawn})
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
        Line(
            (cell.x - left, y(k) + (BOX / 2 if cell.box else 0)),
            (above.x - left, y(k + 1) - (BOX / 2 if above.box else 0)),
            above.box,
        )
        for k, layer in enumerate(layers)
        for cell in layer
        for above in cell.after
    )
    return Picture(boxes, lines, right - left, y(len(layers) - 1) + BOX / 2 + 0.5, alone)
