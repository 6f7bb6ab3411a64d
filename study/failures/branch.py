r"""The branch of a root: :math:`\sqrt{x_1}\sqrt{x_2}` against :math:`\sqrt{x_1x_2}`.

Exactly: with :math:`x_j=e^{i\varphi_j}` the product of the principal roots is the principal root of
the product where :math:`-\pi<\varphi_1+\varphi_2\le\pi`, and its negative elsewhere. Where the sum
is ±π the product lies on the cut, and floating point decides by its rounding.
"""

from __future__ import annotations

import cmath
from collections.abc import Iterator, Sequence
from fractions import Fraction
from functools import partial

from matplotlib.axes import Axes

from kowalevski_cas.pictures import INK
from study.step import Measured, Row, Task

TITLE = "the branch of a root"

ANGLES = 32

CAPTION = (
    f"floating point takes principal values; at {ANGLES}×{ANGLES} angles of $x_1$ and $x_2$, grey "
    r"is where $\sqrt{x_1}\sqrt{x_2}=-\sqrt{x_1x_2}$"
)


def measure(quick: bool) -> Iterator[Task]:
    """Signs on a grid of angles."""
    yield Task("floating", "branch", partial(products, ANGLES // 4 if quick else ANGLES))


def angles(number: int) -> list[Fraction]:
    """Angles in units of π, between -1 and 1, none of which is an end."""
    return [Fraction(2 * k + 1 - number, number) for k in range(number)]


def products(number: int) -> Measured:
    """Signs of √x₁·√x₂ against √(x₁x₂), by principal values: a line an angle of x₂."""
    points = [cmath.rect(1.0, float(a) * cmath.pi) for a in angles(number)]
    signs = []
    for y in points:
        ratios = [cmath.sqrt(x) * cmath.sqrt(y) / cmath.sqrt(x * y) for x in points]
        signs.append("".join("+" if ratio.real > 0 else "-" for ratio in ratios))
    return {"signs": signs}


def draw(axes: Axes, rows: Sequence[Row]) -> None:
    """The signs of the products, and the lines on which they change."""
    axes.set(xlim=(-1, 1), ylim=(-1, 1), xlabel=r"$\arg x_1/\pi$", ylabel=r"$\arg x_2/\pi$")
    axes.set(xticks=(-1, 0, 1), yticks=(-1, 0, 1))
    axes.grid(visible=False)
    for row in rows:
        cells = [[0.6 if sign == "-" else 1.0 for sign in line] for line in row["signs"]]
        box = (-1, 1, -1, 1)
        axes.imshow(cells, cmap="gray", vmin=0, vmax=1, origin="lower", extent=box, aspect="auto")
    for ends in ((0, 1), (-1, 0)):
        axes.plot(ends, ends[::-1], color=INK)
    axes.text(0, 0, r"$\sqrt{x_1}\sqrt{x_2}=\sqrt{x_1x_2}$", ha="center", va="center", size=7)
