"""Combinations: an expression vanishes wherever others do, for it is a combination of them."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from itertools import islice

from kowalevski_cas.arithmetic.points import ExactPoint
from kowalevski_cas.arithmetic.tower import Element
from kowalevski_cas.claims.bench import Bench, Key
from kowalevski_cas.claims.formulas import combined
from kowalevski_cas.claims.points import AtPoint
from kowalevski_cas.notation import Formula, Name
from kowalevski_cas.proof.outcome import Step
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.stage import Stage
from kowalevski_cas.texts import Printed

TRIES = 20
"""How many points of a set are looked at for one where a condition holds."""


def combination(
    bench: Bench,
    scene: Scene,
    key: Key,
    target: Callable[[Stage], Element],
    generators: Callable[[Stage], Sequence[Element]],
    main: Sequence[tuple[str, ...]] = (),
    zero: Callable[[Stage], Sequence[Element]] | None = None,
) -> list[Element] | None:
    """Cofactors with which ``target`` is a combination of ``generators``, checked.

    They are found by division, with FLINT, and the identity is checked in the
    arithmetic of the bench. If they have denominators, an exact point where the
    generators vanish (or ``zero`` does, which makes them vanish) and these do not
    shows that the condition is not empty.
    ``None`` if nothing was found or a check fails.
    """

    def search(stage: Stage) -> list[Element] | None:
        from kowalevski_cas.search.cofactors import cofactors

        return cofactors(target(stage), generators(stage), main)

    found = bench.found_elements(("cofactors", key), scene, search)
    if found is None:
        return None
    stage = bench.stage(scene)
    rest = target(stage)
    for cofactor, generator in zip(found, generators(stage), strict=True):
        rest = rest - cofactor * generator
    if not rest.is_zero:
        return None
    own = {index for g in generators(stage) for index in g.denominator}
    divided = {index for cofactor in found for index in cofactor.denominator} - own
    if divided and not is_inhabited(bench, scene, key, zero or generators, sorted(divided)):
        return None
    return found


def is_inhabited(
    bench: Bench,
    scene: Scene,
    key: Key,
    generators: Callable[[Stage], Sequence[Element]],
    divisors: Sequence[int] = (),
) -> bool:
    """Whether the generators vanish together at an exact point where the divisors do not."""
    neutral = [
        bench.stage(scene).ring.polynomials.terms(bench.stage(scene).ring.divisors[index])
        for index in divisors
    ]

    def nonzero(stage: Stage) -> list[Element]:
        return [stage.ring.from_terms({0: terms}) for terms in neutral]

    def fits(stage: Stage, at: AtPoint) -> bool:
        try:
            return all(at(g).is_zero for g in generators(stage)) and not any(
                at(element).is_zero for element in nonzero(stage)
            )
        except ZeroDivisionError:
            return False

    def search(finder: Bench) -> ExactPoint | None:
        from kowalevski_cas.search.real import real_points

        stage = finder.stage(scene)
        points = islice(real_points(stage, generators(stage), nonzero(stage)), TRIES)
        return next((point for point in points if fits(stage, AtPoint(stage, point))), None)

    point = bench.found(("inhabited", key), search)
    if point is None:
        return False
    stage = bench.stage(scene)
    return fits(stage, AtPoint(stage, point))


def combination_steps(
    left: str, cofactors: Sequence[Element], stage: Stage, products: Iterable[tuple[Formula, ...]]
) -> list[Step]:
    """The combination of products that was found, for the report."""
    shown = combined(cofactors, products, stage)
    return [Step(f"The combination that division found for {left}:", (shown,))]


def label(printed: Printed) -> Name:
    """The left minus the right side of an equation, as steps call it."""
    return Name(rf"\mathrm{{({printed.place})}}")
