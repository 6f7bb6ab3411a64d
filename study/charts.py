"""What the charts share: a mark for each series, points that are left out, legends, axes."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING, Any, TypeVar

from kowalevski_cas.pictures import Mark, mark
from kowalevski_cas.systems import title
from study.step import Row

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

T = TypeVar("T")

_NAMES = {
    "sympy": "SymPy polynomials",
    "modular": "residues",
    "ball": "balls",
    "floating": "floating point",
    "checker": "certificate checker",
    "python-flint": "python-flint alone",
}


def shown(method: str) -> str:
    """The name of a method in print; a name that is not known stays as it is."""
    return _NAMES.get(method, title(method))


def names(rows: Iterable[Row], key: str) -> list[str]:
    """The methods, or the cases, of rows, each once, in their order."""
    return list(dict.fromkeys(row[key] for row in rows))


def by_place(rows: Iterable[Row]) -> dict[tuple[str, str], Row]:
    """The rows by method and case."""
    return {(row["method"], row["case"]): row for row in rows}


def marked(series: Iterable[T]) -> Iterator[tuple[Mark, T]]:
    """Each series with a mark of its own."""
    return ((mark(index), one) for index, one in enumerate(series))


def curve(axes: Axes, xs: Iterable[Any], ys: Iterable[Any], **look: Any) -> None:
    """Draw what is known: where y is ``None`` there is no point."""
    known = [(x, y) for x, y in zip(xs, ys, strict=True) if y is not None]
    axes.plot([x for x, _ in known], [y for _, y in known], **look)


def split(
    axes: Axes, mark: Mark, points: Iterable[tuple[float, float, bool]], label: str, **look: Any
) -> None:
    """Points (x, y, full): full ones, under one label, and hollow ones."""
    found = list(points)
    for full in (True, False):
        chosen = [(x, y) for x, y, kind in found if kind is full]
        axes.plot(
            [x for x, _ in chosen],
            [y for _, y in chosen],
            label=label if full else None,
            **{**mark.points(full), **look},
        )


def list_cases(axes: Axes, cases: Sequence[str], xlabel: str) -> None:
    """Time on a log axis, and a line for each case from above to below."""
    axes.set_xscale("log")
    axes.set_yticks(range(len(cases)), cases)
    axes.invert_yaxis()
    axes.set_xlabel(xlabel)


def label_outer(panels: Any, xlabel: str, ylabel: str) -> None:
    """Label a grid of panels on the left and below."""
    for axes in panels[-1]:
        axes.set_xlabel(xlabel)
    for axes in panels[:, 0]:
        axes.set_ylabel(ylabel)


def legend_below(figure: Figure, axes: Axes, columns: int, **look: Any) -> None:
    """The legend of one of the panels under all of them."""
    found = axes.get_legend_handles_labels()
    figure.legend(*found, loc="outside lower center", ncols=columns, **look)


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
