"""Exact points: the values that elements take there, and points that refute."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from kowalevski_cas.arithmetic.numbers import Substitution, gaussian, number_ring, show_number
from kowalevski_cas.arithmetic.points import ExactPoint
from kowalevski_cas.arithmetic.tower import Element, Ring
from kowalevski_cas.claims.bench import Bench, Key
from kowalevski_cas.notation import Formula
from kowalevski_cas.proof.outcome import Counterexample, Point
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.stage import Stage, scalar


class AtPoint:
    """The values of elements of a stage at an exact point, in the arithmetic of the stage."""

    def __init__(self, stage: Stage, point: ExactPoint) -> None:
        self.stage = stage
        self.numbers: Ring = number_ring(stage.arithmetic)
        self.values = {name: gaussian(self.numbers, *value) for name, value in point.items()}
        self.value = Substitution(stage.ring, self.values, self.numbers)

    def __call__(self, element: Element) -> Element:
        return self.value(element)

    def shown(self) -> Point:
        """The point, to be printed."""
        return Point({**self.values_shown()})

    def values_shown(self) -> dict[Formula, Formula]:
        """The values of the variables and constants, then those of the roots."""
        stage, scene = self.stage, self.stage.scene
        names = [*scene.variables, *scene.constants, *scene.undefined, *scene.roots]
        values: dict[Formula, Formula] = {}
        for name in names:
            formula = stage.formula(name)
            value = self.values.get(name) or self(scalar(formula, stage))
            values[formula] = show_number(value)
        return values


def counterexample(
    bench: Bench,
    scene: Scene,
    key: Key,
    pairs: Callable[[Stage], Sequence[tuple[Element, Element]]],
    zero: Callable[[Stage], Sequence[Element]] = lambda stage: (),
    words: str = "",
) -> Counterexample | None:
    """An exact point where ``zero`` vanishes and the members of a pair differ.

    The point is found with FLINT and both values are computed in the arithmetic
    of the bench; ``None`` if no such point was found.
    """
    if not bench.refute:
        return None

    def search(finder: Bench) -> ExactPoint | None:
        from kowalevski_cas.search.real import real_points

        stage = finder.stage(scene)
        left_right = pairs(stage)
        differing = [a - b for a, b in left_right if not (a - b).is_zero]
        if not differing:
            return None
        for point in real_points(stage, zero(stage), ()):
            at = AtPoint(stage, point)
            try:
                if not at(differing[0]).is_zero:
                    return point
            except ZeroDivisionError:
                continue
        return None

    point = bench.found(("counterexample", key), search)
    if point is None:
        return None
    stage = bench.stage(scene)
    at = AtPoint(stage, point)
    if any(not at(element).is_zero for element in zero(stage)):
        return None
    for left, right in pairs(stage):
        a, b = at(left), at(right)
        if not (a - b).is_zero:
            return Counterexample(at.shown(), show_number(a), show_number(b), words)
    return None
