"""The style of every picture: readable in grey print and for the colour-blind, always the same.

Colours are those of M. Okabe and K. Ito, *Color universal design* (2008); each
comes with a marker and a line style of its own, so that nothing is told by colour
alone. Files carry no date and no version: the same figure gives the same bytes.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING, Any

from kowalevski_cas.files import write

if TYPE_CHECKING:
    from matplotlib.figure import Figure

INK = "#1a1a1a"
FAINT = "#9a9a9a"
"""Grids, guides, and what is shown for comparison only."""

COLOURS = 128
"""How many colours a picture has."""

LIGHT = 300_000
"""How many characters of SVG a page carries for a picture at most."""

WIDTH = 6.3
"""The width in inches of a picture that fills a line of the report."""


@dataclass(frozen=True)
class PlotMark:
    """A colour with the marker and the line style that go with it; ``dashes`` is Matplotlib's."""

    colour: str
    marker: str
    dashes: str | tuple[int, tuple[float, ...]]

    @property
    def line(self) -> dict[str, Any]:
        """What Matplotlib has to be told to draw a line."""
        return {"color": self.colour, "linestyle": self.dashes}


MARKS = (
    PlotMark("#0072b2", "o", "-"),  # blue
    PlotMark("#d55e00", "s", (0, (5, 1.5))),  # vermilion
    PlotMark("#009e73", "^", (0, (5, 1.5, 1, 1.5))),  # bluish green
    PlotMark("#cc79a7", "D", (0, (1, 1.2))),  # reddish purple
    PlotMark("#e69f00", "v", (0, (3, 1, 1, 1, 1, 1))),  # orange
    PlotMark("#56b4e9", "P", (0, (7, 2))),  # sky blue
    PlotMark("#000000", "X", (0, (2, 1))),  # black
    PlotMark(
        "#7a7a00", "*", (0, (8, 2, 2, 2))
    ),  # olive: the yellow of the palette, darkened for paper
    PlotMark("#8b4a2b", "h", (0, (4, 1, 1, 1))),  # brown, which is none of theirs
)
"""Marks in the order in which series take them."""

_STYLE: dict[Any, Any] = {
    "font.family": "DejaVu Sans",
    "mathtext.fontset": "dejavusans",
    "font.size": 8.5,
    "axes.titlesize": 9.5,
    "axes.titlelocation": "left",
    "axes.labelsize": 8.5,
    "axes.edgecolor": INK,
    "axes.linewidth": 0.7,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.axisbelow": True,
    "axes.grid": True,
    "grid.color": "#dcdcdc",
    "grid.linewidth": 0.5,
    "xtick.labelsize": 8,
    "ytick.labelsize": 8,
    "lines.linewidth": 1.3,
    "lines.markersize": 4.5,
    "legend.frameon": False,
    "legend.fontsize": 8,
    "figure.constrained_layout.use": True,
    "savefig.dpi": 250,
    "path.simplify": True,
}


@contextmanager
def style() -> Iterator[None]:
    """The style, for whatever is drawn inside; the user's own settings do not show through."""
    import matplotlib

    with matplotlib.rc_context():
        matplotlib.rcdefaults()
        for name, value in _STYLE.items():
            matplotlib.rcParams[name] = value
        yield


def new_figure(width: float = WIDTH, height: float = 4.0) -> Figure:
    """An empty figure, in inches; draw on it inside :func:`style`."""
    from matplotlib.figure import Figure

    return Figure(figsize=(width, height))


def mark(index: int) -> PlotMark:
    """The mark of the series with this index; they repeat after the last one."""
    return MARKS[index % len(MARKS)]


def save(figure: Figure, folder: Path, name: str) -> Path:
    """Write a figure as ``folder/name.png``, the one format that README, LaTeX and Typst all show.

    It has few colours, so that a page can carry it. The bytes depend on the figure and on the
    versions of Matplotlib and of Pillow, on nothing else.
    """
    from PIL import Image  # Matplotlib needs it

    path, drawn, small = folder / f"{name}.png", BytesIO(), BytesIO()
    with style():
        figure.savefig(drawn, format="png")
    with Image.open(drawn) as image:
        few = image.convert("RGB").quantize(COLOURS, dither=Image.Dither.NONE)
    few.save(small, "PNG", optimize=True)
    write(path, small.getvalue())
    return path


ALONE = "@media (prefers-color-scheme: dark) { svg:root { color: #e8e8e8; --page: #161616 } }\n"
"""The ink of a drawing that is no part of a page, in the dark."""


def save_drawing(figure: Figure, folder: Path, name: str) -> Path | None:
    """Write a figure as ``folder/name.svg``, an element of a page, if it is light and all lines.

    It has the ground of the page and its ink, so that it can be read in the dark, as greys could
    not; by itself it has the ink of the reader's scheme. What is named in it begins with the name
    of the figure. One that was there before, and is no more, is removed.
    """
    import matplotlib

    path, drawn = folder / f"{name}.svg", BytesIO()
    with style(), matplotlib.rc_context({"svg.hashsalt": name}):
        silent = dict.fromkeys(("Creator", "Date", "Format", "Type"))
        figure.savefig(drawn, format="svg", transparent=True, metadata=silent)
    text = drawn.getvalue().decode()
    text = re.sub(r'(?<=id="|f="#|rl\(#)', f"{name}-", text[text.index("<svg") :])
    text = re.sub(r' d="[^"]*"', lambda path: re.sub(r"(\.\d)\d+", r"\1", path[0]), text)
    text = text.replace("<svg ", '<svg fill="currentColor" ', 1)
    text = text.replace('<style type="text/css">', f'<style type="text/css">{ALONE}', 1)
    text = re.sub(rf"{INK}|#000000\b", "currentColor", text).replace("#ffffff", "var(--page, #fff)")
    greys = {*re.findall(r"fill: (#\w+)", text)} - {FAINT, *(mark.colour for mark in MARKS)}
    if greys or len(text) > LIGHT:
        path.unlink(missing_ok=True)
        return None
    write(path, text)
    return path
