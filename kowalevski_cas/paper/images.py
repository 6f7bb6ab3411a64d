r"""Images under maps, as :math:`x_{n+1}` of :math:`x_n`, and those that are solved for."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace

from kowalevski_cas.algebra.present import formula_in
from kowalevski_cas.notation import to_latex
from kowalevski_cas.notation.symbol import Symbol, symbol
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.matrix_equations import solve_linear
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.paper.texts import Printed, Texts
from kowalevski_cas.paper.vocabulary import vocabulary


def images_by_index(names: Iterable[str], index: str) -> dict[str, str]:
    """The variables of a map with their images; between its first and last step none is missing.

    >>> images_by_index(["x_n", "x_{n+3}"], "n")
    {'x_n': 'x_{n+1}', 'x_{n+1}': 'x_{n+2}', 'x_{n+2}': 'x_{n+3}'}
    """
    steps: dict[Symbol, list[int]] = {}
    for name in names:
        parts = symbol(name)
        if step := re.fullmatch(rf"{re.escape(index)}([+-]\d+)?", parts.index):
            steps.setdefault(replace(parts, index=""), []).append(int(step[1] or 0))

    def at(letter: Symbol, step: int) -> str:
        return replace(letter, index=f"{index}{step:+}" if step else index).name

    pairs = [
        (one, k) for one, found in steps.items() for k in range(min(0, *found), max(0, *found))
    ]
    return {at(*pair): at(pair[0], pair[1] + 1) for pair in sorted(pairs, key=lambda p: p[1] < 0)}


def solutions(scene: Scene, images: Sequence[str], places: Iterable[Printed]) -> Iterator[str]:
    """What gives images, by the equations in which they are linear.

    Raises ``ValueError`` if these do not determine them, or are not linear.
    """
    kept = tuple(name for name in scene.constants if name not in images)
    scene = replace(scene, constants=kept).having(variables=tuple(images))
    space = Elaborations(Texts(vocabulary((scene,))))(scene)
    pairs = [space.texts.sides(place) for place in places]
    sides = [(space.plain(left), space.plain(right)) for left, right in pairs]
    values = solve_linear(space.finder.differences(sides), images)
    for name, value in zip(images, values, strict=True):
        if value is None or any(one in formula_in(value).names() for one in images):
            raise ValueError(f"solve the equations for {name}: they are not linear in it")
        yield f"{name}={to_latex(formula_in(value))}"
