"""Combinations: an expression vanishes wherever others do, for it is a combination of them."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from kowalevski_cas.arithmetic.tower import Element
from kowalevski_cas.claims.bench import Bench, Key
from kowalevski_cas.claims.claim import show
from kowalevski_cas.proof.outcome import Step
from kowalevski_cas.scene import Scene
from kowalevski_cas.stage import Stage


def combination(
    bench: Bench,
    scene: Scene,
    key: Key,
    target: Callable[[Stage], Element],
    generators: Callable[[Stage], Sequence[Element]],
    main: Sequence[tuple[str, ...]] = (),
) -> list[Element] | None:
    """Cofactors with which ``target`` is a combination of ``generators``, checked.

    They are found by division, with FLINT, and the identity is checked in the
    arithmetic of the bench. ``None`` if none were found or the check fails.
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
    return found if rest.is_zero else None


def combination_steps(
    left: str, cofactors: Sequence[Element], stage: Stage, names: Sequence[str] = ()
) -> list[Step]:
    """The combination that was found, for the report."""
    shown = [
        rf"\left({show(c, stage)}\right) {names[k] if names else f'g_{{{k + 1}}}'}"
        for k, c in enumerate(cofactors)
        if not c.is_zero
    ]
    return [Step(f"The combination that division found for {left}:", " + ".join(shown) or "0")]
