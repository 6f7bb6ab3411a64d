"""Exact points with given properties, as evidence against a statement."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from itertools import islice

from kowalevski_cas.arithmetic.numbers import show_number
from kowalevski_cas.arithmetic.points import ExactPoint
from kowalevski_cas.arithmetic.tower import Element
from kowalevski_cas.claims.bench import Bench, Key
from kowalevski_cas.claims.points import AtPoint
from kowalevski_cas.notation import Number
from kowalevski_cas.proof.outcome import Counterexample
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.stage import Stage

Elements = Callable[[Stage], Sequence[Element]]

TRIES = 40
"""How many points are looked at."""


def witness(
    bench: Bench,
    scene: Scene,
    key: Key,
    zero: Elements,
    values: Elements,
    words: Callable[[int], str],
    nonzero: Elements = lambda stage: (),
    also: Elements = lambda stage: (),
    sections: Callable[[Stage], Iterable[Sequence[Element]]] = lambda stage: ((),),
) -> Counterexample | None:
    """A point where ``zero`` and ``also`` vanish, ``nonzero`` does not, and not all ``values`` do.

    ``zero`` is solved for by the search, with FLINT; everything is checked in the
    arithmetic of the bench. The ``sections`` are more equations, in turn, to make the
    search easier. ``words`` says what the value with an index is.
    """
    if not bench.refute:
        return None

    def failing(stage: Stage, point: ExactPoint) -> tuple[AtPoint, int, Element] | None:
        at = AtPoint(stage, point)
        if any(at(element).is_zero for element in nonzero(stage)):
            return None
        if any(not at(element).is_zero for element in (*zero(stage), *also(stage))):
            return None
        for index, element in enumerate(values(stage)):
            if not (value := at(element)).is_zero:
                return at, index, value
        return None

    def search(finder: Bench) -> ExactPoint | None:
        from kowalevski_cas.search.real import real_points

        stage = finder.stage(scene)
        for section in sections(stage):
            points = real_points(stage, [*zero(stage), *section], nonzero(stage))
            for point in islice(points, TRIES):
                if failing(stage, point):
                    return point
        return None

    point = bench.found(("witness", key), search)
    found = failing(bench.stage(scene), point) if point is not None else None
    if found is None:
        return None
    at, index, value = found
    return Counterexample(at.shown(), show_number(value), Number(0), words(index))
