"""What the charts share: the name and the mark of each method, panels, legends, units."""

from __future__ import annotations

from decimal import ROUND_CEILING, Context
from typing import TYPE_CHECKING, Any

from kowalevski_cas.pictures import PlotMark, mark
from kowalevski_cas.tools import title
from study.step import Row

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_NAMES = {
    "sympy": "SymPy polynomials",
    "modular": "residues",
    "ball": "balls",
    "floating": "floating point",
    "checker": "certificate checker",
    "python-flint": "python-flint alone",
    "search": "the whole search",
    "blocks": "residues by blocks, lifted",
    "rank": "python-flint, rank only",
    "cases": "one factor after another",
    "basis": "basis with cofactors",
    "closed": "closed form",
    "dop853": "DOP853",
    "radau": "Radau",
    "lsoda": "LSODA",
    "taylor": "Taylor series",
    "splitting": "splitting",
    "giac": "Giac",
}

_MARKS = (
    ("flint", "search", "cases"),
    ("symengine", "dop853", "blocks", "basis"),
    ("sympy", "closed"),
    ("modular", "lsoda"),
    ("python-flint", "taylor"),
    ("singular", "ball"),
    ("pari", "floating", "rank"),
    ("radau", "maxima"),
    ("giac",),
)
"""The methods with the first mark, with the second, …; those with the same one are in no chart
together. What is not known has the last one."""


def display_name(method: str) -> str:
    """The name of a method in print; a name that is not known stays as it is."""
    return _NAMES.get(method, title(method))


def look(method: str) -> PlotMark:
    """The mark of a method, the same in every chart; one that is not known has the last."""
    found = (index for index, methods in enumerate(_MARKS) if method in methods)
    return mark(next(found, len(_MARKS) - 1))


def line_style(one: PlotMark) -> dict[str, Any]:
    """What Matplotlib has to be told to draw a line with its points."""
    return {**one.line, "marker": one.marker}


def points(one: PlotMark, full: bool = True) -> dict[str, Any]:
    """The same for points alone, full or hollow."""
    fill = one.colour if full else "white"
    return {**line_style(one), "linestyle": "none", "markerfacecolor": fill}


def curve(axes: Axes, row: Row, x: str, y: str, label: str = "", least: float = 0.0) -> None:
    """Draw what a row measured: two lists, where ``None`` is no point.

    What is smaller than ``least``, or zero, is drawn there.
    """
    known = [(a, max(b, least)) for a, b in zip(row[x], row[y], strict=True) if b is not None]
    name, style = label or display_name(row["method"]), line_style(look(row["method"]))
    axes.plot([a for a, _ in known], [b for _, b in known], label=name, **style)


def legend_below(figure: Figure, axes: Axes, columns: int, **more: Any) -> None:
    """The legend of one of the panels under all of them."""
    found = axes.get_legend_handles_labels()
    figure.legend(*found, loc="outside lower center", ncols=columns, **more)


def digit(value: float) -> str:
    r"""A number, rounded up to one digit, as mathematics: a bound stays a bound.

    >>> print(digit(1e-13), digit(5.1e-22), digit(1000000))
    $10^{-13}$ $6\cdot10^{-22}$ $10^{6}$
    """
    up = Context(prec=1, rounding=ROUND_CEILING).create_decimal(repr(value))
    first, _, exponent = f"{up:e}".partition("e")
    factor = "" if first == "1" else rf"{first}\cdot"
    return f"${factor}10^{{{int(exponent)}}}$"


def seconds(value: float, _: object = None) -> str:
    """A time in words.

    >>> [seconds(value) for value in (1e-5, 0.01, 1, 100)]
    ['10 µs', '10 ms', '1 s', '100 s']
    """
    for unit, size in (("s", 1.0), ("ms", 1e-3), ("µs", 1e-6)):
        if value >= 0.999 * size:
            return f"{value / size:.3g} {unit}"
    return f"{value * 1e9:.3g} ns"


def size(value: float, _: object = None) -> str:
    """Bytes in words.

    >>> [size(value) for value in (1e6, 1e8, 1e10)]
    ['1 MB', '100 MB', '10 GB']
    """
    return f"{value / 1e9:.3g} GB" if value >= 1e9 else f"{value / 1e6:.3g} MB"
