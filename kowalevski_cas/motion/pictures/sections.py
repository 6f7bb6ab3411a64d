"""The bifurcation diagram of the whole top, cut at energies: the planes of (g, √k)."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from fractions import Fraction

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patheffects import withStroke

from kowalevski_cas.motion.chambers import Chamber, chambers
from kowalevski_cas.motion.cut import Curve, rotations, section, values
from kowalevski_cas.motion.diagram import Fields
from kowalevski_cas.motion.energies import representatives
from kowalevski_cas.motion.levels import count_tori
from kowalevski_cas.motion.motion import Motion
from kowalevski_cas.motion.o4.motion import MotionO4
from kowalevski_cas.motion.pictures.regions import GREYS, fill_regions, mesh
from kowalevski_cas.paper.closed_form import CriticalSets
from kowalevski_cas.pictures import INK, mark, new_figure

ABOUT = CriticalSets

CAPTION = (
    "The bifurcation diagram of the whole top, in the planes of $(g,\\sqrt{k})$ at an energy "
    "between each two at which it changes: the values at which the three integrals are dependent, "
    "on $M^4$, $N^4$, $O^4$, and at rotations about the third axis (dots, hollow where they are on "
    "none of the three). Numbers count the tori of $M^4$, $N^4$ and $O^4$ with these values. "
    "Motions fill the shaded chambers; the bold numbers count their tori of dimension three, and "
    "those in a corner the tori of chambers that are too narrow to be seen. They follow from the "
    "tori on the walls or, in a wide chamber where these do not tell, from motions that are "
    "followed."
)

SEEN = 0.02
"""The least size of a chamber, as a share of the diagram, in which there is room for a number."""

COLUMNS = 3

SETS = ("$M^4$", "$N^4$", "$O^4$")


def draw(motion: Motion | MotionO4) -> Figure:
    """The sections for the fields of a motion."""
    fields = Fields(motion.parameters.a, motion.parameters.b)
    energies = representatives(fields)
    rows = -(-len(energies) // COLUMNS)
    figure = new_figure(height=2.0 * rows + 0.4)
    tiles = list(figure.subplots(rows, COLUMNS).flat)
    for axes, h in zip(tiles, energies, strict=False):
        _draw_section(axes, fields, h)
    for axes in tiles[len(energies) :]:
        axes.set_axis_off()
    for axes in tiles[len(energies) - COLUMNS : len(energies)]:
        axes.set_xlabel("$g$")
    for axes in tiles[: len(energies) : COLUMNS]:
        axes.set_ylabel(r"$\sqrt{k}$", rotation=0, labelpad=10)
    figure.legend(*tiles[0].get_legend_handles_labels(), loc="outside lower center", ncols=3)
    return figure


def _draw_section(axes: Axes, fields: Fields, h: float) -> None:
    """Draw the section at an energy, with the numbers of tori on its curves and in its chambers."""
    g, root = values(fields, h)
    low = root.min() if root.min() > root.max() / 2 else 0.0
    width, height = np.ptp(g), root.max() - low
    axes.set(xlim=(g.min() - 0.06 * width, g.max() + 0.06 * width))
    axes.set(ylim=(low - 0.04 * height, low + 1.08 * height), title=f"$h={round(h, 9) + 0.0:.4g}$")
    axes.grid(False)
    curves, dots = section(fields, h), rotations(fields, h)
    walls = [curve[:2] for some in curves for curve in some]
    here = fill_regions(axes, walls, (g, root))
    axes.contourf(*mesh(axes), here, levels=(0.5, 1.5), colors=[GREYS[1]], zorder=0)
    for index, (name, some) in enumerate(zip(SETS, curves, strict=True)):
        for number, curve in enumerate(some):
            numbers(axes, curve, [(x, y) for x, y, _ in dots])
            label = name if number == 0 else None
            axes.plot(*curve[:2], **mark((2, 0, 1)[index]).line, lw=1.2, label=label)
    for x, y, alone in dots:
        axes.plot(x, y, "o", ms=4, color=INK, mfc="white" if alone else INK, zorder=5)
    _draw_tori(axes, fields, chambers(fields, Fraction(h)))


def _draw_tori(axes: Axes, fields: Fields, found: Sequence[Chamber]) -> None:
    """Write the number of tori into each chamber, or into a corner where there is no room."""
    narrow = [chamber for chamber in found if chamber.depth < SEEN]
    wide = [chamber for chamber in found if chamber.depth >= SEEN]
    unknown = [chamber for chamber in wide if chamber.tori is None]
    followed = count_tori(fields, [chamber.level for chamber in unknown]) if unknown else []
    # Motions are followed for a while only: what the walls exclude is no count.
    left = {
        chamber: chamber.numbers & {count} or chamber.numbers
        for chamber, count in zip(unknown, followed, strict=True)
    }
    for chamber in wide:
        axes.text(
            *chamber.place, _words(left.get(chamber, chamber.numbers)),
            size=8, weight="bold", ha="center", va="center", zorder=6,
            path_effects=[withStroke(linewidth=1.5, foreground=GREYS[1])],
        )  # fmt: skip
    if narrow:
        words = "narrow: " + ", ".join(_words(chamber.numbers) for chamber in narrow)
        axes.text(0.02, 0.97, words, size=6, va="top", transform=axes.transAxes)


def _words(numbers: Collection[int]) -> str:
    """The number of tori, or between which it is."""
    least, most = min(numbers), max(numbers)
    return str(least) if least == most else f"{least} to {most}"


def numbers(axes: Axes, curve: Curve, taken: Sequence[tuple[float, float]]) -> None:
    """Write the number of tori onto each part of a curve that is long enough, off what is taken."""
    across, up = np.ptp(axes.get_xlim()), np.ptp(axes.get_ylim())
    for part in np.split(np.arange(len(curve.g)), np.flatnonzero(np.diff(curve.tori)) + 1):
        x, y = curve.g[part], curve.root[part]
        along = np.append(0.0, np.nancumsum(np.hypot(np.diff(x) / across, np.diff(y) / up)))
        if not curve.tori[part[0]] or along[-1] < 0.12:
            continue
        for share in (0.5, 0.35, 0.65):
            place = np.searchsorted(along, share * along[-1])
            at = x[place], y[place]
            if all(np.hypot((at[0] - u) / across, (at[1] - v) / up) > 0.06 for u, v in taken):
                axes.text(
                    *at, str(curve.tori[part[0]]), size=6, ha="center", va="center",
                    zorder=4, path_effects=[withStroke(linewidth=2.5, foreground="white")],
                )  # fmt: skip
                break
