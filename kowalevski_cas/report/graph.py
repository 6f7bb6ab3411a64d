"""The picture of which claim rests on which: a layered drawing, made from a run.

The layout is computed once, in millimetres, and drawn twice: as TikZ inside the LaTeX report,
and as SVG, which Typst and browsers read. Nothing in it depends on fonts that are measured or
on the order of a set, so that it is the same from run to run.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Final
from xml.sax.saxutils import escape

from kowalevski_cas.proof.outcome import Outcome, Verdict
from kowalevski_cas.report.marks import MARKS

WIDTH: Final = 155.0
HEIGHT: Final = 205.0
_BOX: Final = 5.0
_LAYER: Final = 13.0
_BESIDE: Final = 3.0
_PASS: Final = 1.8
_LETTER: Final = 1.32
_WORST: Final = (
    Verdict.PROVED,
    Verdict.CONDITIONAL,
    Verdict.ENCLOSED,
    Verdict.PROBABLE,
    Verdict.TIMEOUT,
    Verdict.UNDECIDED,
    Verdict.REFUTED,
    Verdict.ERROR,
)


@dataclass(frozen=True, slots=True)
class Box:
    """A claim, or several rows of one display, at its place (the centre, in mm)."""

    name: str
    label: str
    verdict: Verdict
    x: float
    y: float
    width: float


@dataclass(frozen=True, slots=True)
class Line:
    """A piece of a line from what is rested on to what rests on it; the last one has a tip."""

    start: tuple[float, float]
    end: tuple[float, float]
    tip: bool


@dataclass(frozen=True, slots=True)
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
        return min(1.0, 0.999 * WIDTH / self.width, HEIGHT / self.height)

    def tikz(self) -> str:
        """The picture as the body of a ``tikzpicture``."""
        out = [f"\\useasboundingbox (0,0) rectangle ({self.width:.1f},{-self.height:.1f});"]
        out += [_tikz_line(line) for line in self.lines]
        for box in self.boxes:
            out.append(
                f"\\node[claim,{box.verdict.value},minimum width={box.width:.1f}mm] "
                f"at ({box.x:.1f},{-box.y:.1f}) "
                f"{{{MARKS[box.verdict].tex}\\,\\hyperlink{{claim.{anchor(box.name)}}}"
                f"{{\\ttfamily {_latex(box.label)}}}}};"
            )
        return "\n".join(out)

    def svg(self) -> str:
        """The picture as a standalone SVG file."""
        width, height = self.width * self.scale, self.height * self.scale
        body = [_svg_line(line) for line in self.lines]
        body += [_svg_box(box) for box in self.boxes]
        return (
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{width:.1f}mm" '
            f'height="{height:.1f}mm" viewBox="0 0 {self.width:.1f} {self.height:.1f}">\n'
            + "\n".join(body)
            + "\n</svg>\n"
        )


# ---------------------------------------------------------------------- layout


@dataclass(slots=True)
class _Cell:
    """A place in a layer: a claim, or a long line passing through."""

    name: str
    order: float
    width: float
    x: float = 0.0
    before: list[_Cell] = field(default_factory=list)
    after: list[_Cell] = field(default_factory=list)

    @property
    def box(self) -> bool:
        return self.width > 0


def picture(outcomes: Sequence[Outcome]) -> Picture:
    """Lay out the claims that rest on others, foundations at the top."""
    members = _collapsed(outcomes)
    home = {claim: name for name, claims in members.items() for claim in claims}
    verdicts = {o.claim: o.verdict for o in outcomes}
    rests: dict[str, list[str]] = {name: [] for name in members}
    for outcome in outcomes:
        for below in outcome.rests_on:
            if below in home and home[below] != home[outcome.claim]:
                if home[below] not in rests[home[outcome.claim]]:
                    rests[home[outcome.claim]].append(home[below])
    rests = _reduced(_acyclic(rests))
    carried = {below for belows in rests.values() for below in belows}
    names = [name for name in members if rests[name] or name in carried]
    alone = tuple(claim for name in members if name not in names for claim in members[name])
    if not names:
        return Picture((), (), 0.0, 0.0, alone)
    labels = {name: _label(name, members[name]) for name in names}
    widths = {name: _LETTER * len(labels[name]) + 8.0 for name in names}
    layers = _layers(names, rests, widths)
    _order(layers)
    _place(layers)
    edges = [(c.x - c.width / 2, c.x + c.width / 2) for layer in layers for c in layer]
    left, right = min(e[0] for e in edges) - 0.5, max(e[1] for e in edges) + 0.5

    def y(layer: int) -> float:
        return 0.5 + _BOX / 2 + layer * _LAYER

    boxes = tuple(
        Box(
            members[cell.name][0],
            labels[cell.name],
            max((verdicts[c] for c in members[cell.name]), key=_WORST.index),
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
            (cell.x - left, y(k) + (_BOX / 2 if cell.box else 0)),
            (above.x - left, y(k + 1) - (_BOX / 2 if above.box else 0)),
            above.box,
        )
        for k, layer in enumerate(layers)
        for cell in layer
        for above in cell.after
    )
    return Picture(boxes, lines, right - left, y(len(layers) - 1) + _BOX / 2 + 0.5, alone)


def _collapsed(outcomes: Sequence[Outcome]) -> dict[str, list[str]]:
    """Rows of one display as one box, where that makes no circle."""
    members: dict[str, list[str]] = {}
    for outcome in outcomes:
        match = re.fullmatch(r"(.+)\.\d+", outcome.claim)
        members.setdefault(match[1] if match else outcome.claim, []).append(outcome.claim)
    rests = {outcome.claim: outcome.rests_on for outcome in outcomes}

    def reaches(start: str, group: set[str]) -> bool:
        """Whether a row rests on a row of its own display by way of others."""
        seen: set[str] = set()
        stack = [below for below in rests.get(start, ()) if below not in group]
        while stack:
            claim = stack.pop()
            if claim in group:
                return True
            if claim not in seen:
                seen.add(claim)
                stack.extend(rests.get(claim, ()))
        return False

    found: dict[str, list[str]] = {}
    for name, claims in members.items():
        if len(claims) > 1 and any(reaches(claim, set(claims)) for claim in claims):
            found.update({claim: [claim] for claim in claims})
        else:
            found[name if len(claims) > 1 else claims[0]] = claims
    return found


def _label(name: str, claims: Sequence[str]) -> str:
    if len(claims) == 1:
        return claims[0]
    numbers = [int(claim.rsplit(".", 1)[1]) for claim in claims]
    if numbers == list(range(numbers[0], numbers[-1] + 1)):
        return f"{name}.{numbers[0]}–{numbers[-1]}"
    return f"{name}.{','.join(map(str, numbers))}"


def _acyclic(rests: dict[str, list[str]]) -> dict[str, list[str]]:
    """The same without the lines that would close a circle."""
    state: dict[str, int] = {}
    kept: dict[str, list[str]] = {name: [] for name in rests}
    for root in rests:
        if root in state:
            continue
        state[root] = 1
        stack = [(root, iter(rests[root]))]
        while stack:
            name, belows = stack[-1]
            below = next(belows, None)
            if below is None:
                state[name] = 2
                stack.pop()
            elif state.get(below) != 1:
                kept[name].append(below)
                if below not in state:
                    state[below] = 1
                    stack.append((below, iter(rests[below])))
    return kept


def _reduced(rests: dict[str, list[str]]) -> dict[str, list[str]]:
    """The same without the lines that follow from others."""
    below_all: dict[str, set[str]] = {}
    for name in _upwards(rests):
        below_all[name] = set(rests[name]).union(*(below_all[b] for b in rests[name]))
    return {
        name: [b for b in belows if not any(b in below_all[o] for o in belows if o != b)]
        for name, belows in rests.items()
    }


def _upwards(rests: dict[str, list[str]]) -> list[str]:
    """The names, each after everything that it rests on."""
    done: dict[str, None] = {}
    for root in rests:
        stack = [root]
        while stack:
            name = stack[-1]
            waiting = [b for b in rests[name] if b not in done]
            if waiting:
                stack.extend(reversed(waiting))
            else:
                done.setdefault(name)
                stack.pop()
    return list(done)


def _levels(
    names: Sequence[str], rests: dict[str, list[str]], widths: dict[str, float]
) -> dict[str, int]:
    """The layer of each name: under what it rests on, and no layer wider than the page."""
    level: dict[str, int] = {}
    used: dict[int, float] = {}
    for name in (n for n in _upwards(rests) if n in widths):
        at = max((level[b] + 1 for b in rests[name]), default=0)
        wide = widths[name] + _BESIDE
        while used.get(at, 0.0) and used[at] + wide > WIDTH:
            at += 1
        level[name] = at
        used[at] = used.get(at, 0.0) + wide
    for name in names:  # a foundation stands near the first claim that needs it
        above = [level[n] for n in names if name in rests[n]]
        wide = widths[name] + _BESIDE
        if not rests[name] and above:
            for at in range(min(above) - 1, level[name], -1):
                if used.get(at, 0.0) + wide <= WIDTH:
                    used[level[name]] -= wide
                    level[name], used[at] = at, used.get(at, 0.0) + wide
                    break
    present = sorted(set(level.values()))
    return {name: present.index(at) for name, at in level.items()}


def _layers(
    names: Sequence[str], rests: dict[str, list[str]], widths: dict[str, float]
) -> list[list[_Cell]]:
    """Cells by layer; a line over several layers passes through a cell in each."""
    order = {name: k for k, name in enumerate(names)}
    level = _levels(names, rests, widths)
    layers: list[list[_Cell]] = [[] for _ in range(max(level.values()) + 1)]
    cells = {name: _Cell(name, order[name], widths[name]) for name in names}
    for name in names:
        layers[level[name]].append(cells[name])
    for name in names:
        for below in rests[name]:
            previous = cells[below]
            for between in range(level[below] + 1, level[name]):
                shared = next((c for c in previous.after if not c.box and c.name == below), None)
                if shared is None:
                    shared = _Cell(below, (order[below] + order[name]) / 2, 0.0)
                    layers[between].append(shared)
                    _join(previous, shared)
                previous = shared
            _join(previous, cells[name])
    return layers


def _join(below: _Cell, above: _Cell) -> None:
    below.after.append(above)
    above.before.append(below)


def _crossings(layers: Sequence[Sequence[_Cell]]) -> int:
    total = 0
    for left, right in pairwise(layers):
        at = {id(cell): k for k, cell in enumerate(right)}
        ends = [at[id(c)] for cell in left for c in sorted(cell.after, key=lambda c: at[id(c)])]
        total += sum(ends[a] > ends[b] for a in range(len(ends)) for b in range(a + 1, len(ends)))
    return total


def _order(layers: list[list[_Cell]]) -> None:
    """Sort each layer so that few lines cross: sweeps of barycentres, the best one kept."""
    for layer in layers:
        layer.sort(key=lambda cell: cell.order)
    best, fewest = [list(layer) for layer in layers], _crossings(layers)
    for sweep in range(12):
        forward = sweep % 2 == 0
        for k in range(1, len(layers)) if forward else range(len(layers) - 2, -1, -1):
            _sort(layers[k], layers[k - 1 if forward else k + 1], forward)
        if (now := _crossings(layers)) < fewest:
            best, fewest = [list(layer) for layer in layers], now
    layers[:] = best


def _sort(layer: list[_Cell], beside: Sequence[_Cell], forward: bool) -> None:
    at = {id(cell): k for k, cell in enumerate(beside)}
    own = {id(cell): float(k) for k, cell in enumerate(layer)}

    def middle(cell: _Cell) -> float:
        near = [at[id(c)] for c in (cell.before if forward else cell.after)]
        return sum(near) / len(near) if near else own[id(cell)]

    layer.sort(key=middle)


def _place(layers: Sequence[Sequence[_Cell]]) -> None:
    """Move each cell near its neighbours, and never on top of the next one."""
    for layer in layers:
        _spread(layer, [0.0] * len(layer))
    for sweep in range(24):
        for layer in layers if sweep % 2 == 0 else reversed(layers):
            wanted = []
            for cell in layer:
                near = [c.x for c in (*cell.before, *cell.after)]
                wanted.append(sum(near) / len(near) if near else cell.x)
            _spread(layer, wanted)


def _spread(layer: Sequence[_Cell], wanted: Sequence[float]) -> None:
    """The places nearest to those wanted, in order, with room between, and on the page."""
    offsets = [0.0]
    for cell, after in pairwise(layer):
        room = _BESIDE if cell.box or after.box else _PASS
        offsets.append(offsets[-1] + (cell.width + after.width) / 2 + room)
    blocks: list[tuple[float, int]] = []
    for want, offset in zip(wanted, offsets, strict=True):
        blocks.append((want - offset, 1))
        while len(blocks) > 1 and blocks[-2][0] > blocks[-1][0]:
            (a, m), (b, n) = blocks[-2:]
            blocks[-2:] = [((a * m + b * n) / (m + n), m + n)]
    flat = [value for value, count in blocks for _ in range(count)]
    for cell, value, offset in zip(layer, flat, offsets, strict=True):
        cell.x = value + offset
    left = layer[0].x - layer[0].width / 2 + WIDTH / 2
    right = layer[-1].x + layer[-1].width / 2 - WIDTH / 2
    shift = -(left + right) / 2 if right - left > 0 else -min(0.0, left) - max(0.0, right)
    for cell in layer:
        cell.x += shift


# --------------------------------------------------------------------- drawing


def anchor(text: str) -> str:
    """A name that both LaTeX and Typst take for a label."""
    return re.sub(r"[^A-Za-z0-9.-]", "-", text)


def _latex(text: str) -> str:
    return text.replace("–", "--").replace("_", r"\_")


def _tikz_line(line: Line) -> str:
    (x0, y0), (x1, y1) = line.start, line.end
    half = (y1 - y0) / 2
    return (
        f"\\draw[rests{',->' if line.tip else ''}] ({x0:.1f},{-y0:.1f}) .. controls "
        f"+(0,{-half:.1f}) and +(0,{half:.1f}) .. ({x1:.1f},{-y1:.1f});"
    )


def _svg_line(line: Line) -> str:
    (x0, y0), (x1, y1) = line.start, line.end
    half = (y1 - y0) / 2
    path = f"M{x0:.1f} {y0:.1f}C{x0:.1f} {y0 + half:.1f} {x1:.1f} {y1 - half:.1f} {x1:.1f} {y1:.1f}"
    if line.tip:
        path += f"M{x1 - 0.6:.1f} {y1 - 1.3:.1f}L{x1:.1f} {y1:.1f}L{x1 + 0.6:.1f} {y1 - 1.3:.1f}"
    return f'<path d="{path}" fill="none" stroke="#777" stroke-width="0.18"/>'


_SVG_STYLE: Final = {
    Verdict.PROVED: 'fill="#fff" stroke="#000" stroke-width="0.18"',
    Verdict.CONDITIONAL: 'fill="#fff" stroke="#000" stroke-width="0.25" stroke-dasharray="1 0.6"',
    Verdict.REFUTED: 'fill="#e4e4e4" stroke="#000" stroke-width="0.6"',
}
_SVG_OTHER: Final = 'fill="#fff" stroke="#000" stroke-width="0.25" stroke-dasharray="0.25 0.6"'
_SVG_SIGN: Final = {
    Verdict.PROVED: "M-1.1 0.1L-0.3 0.9L1.2 -1",
    Verdict.CONDITIONAL: "M-0.8 0.1L-0.2 0.7L0.9 -0.8"
    "M-1.1 -1.2C-1.9 -0.5 -1.9 0.5 -1.1 1.2M1.1 -1.2C1.9 -0.5 1.9 0.5 1.1 1.2",
    Verdict.REFUTED: "M-0.9 -0.9L0.9 0.9M-0.9 0.9L0.9 -0.9",
}


def _svg_box(box: Box) -> str:
    left, top = box.x - box.width / 2, box.y - _BOX / 2
    style = _SVG_STYLE.get(box.verdict, _SVG_OTHER)
    wide = _LETTER * len(box.label)
    start = box.x - (wide + 4.0) / 2
    sign = _SVG_SIGN.get(box.verdict)
    mark = (
        f'<path transform="translate({start + 1.3:.2f} {box.y:.2f})" d="{sign}" '
        'fill="none" stroke="#000" stroke-width="0.35"/>'
        if sign
        else f'<text x="{start + 1.3:.2f}" y="{box.y + 0.85:.2f}" font-size="2.6" '
        f'text-anchor="middle">{escape(MARKS[box.verdict].sign)}</text>'
    )
    label = (
        f'<text x="{start + 4.0:.2f}" y="{box.y + 0.8:.2f}" font-size="2.45" '
        f'textLength="{wide:.2f}" font-family="DejaVu Sans Mono, monospace">'
        f"{escape(box.label)}</text>"
    )
    return (
        f'<rect x="{left:.1f}" y="{top:.1f}" width="{box.width:.1f}" height="{_BOX}" rx="0.8" '
        f"{style}/>{mark}{label}"
    )
