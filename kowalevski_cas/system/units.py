"""Unit matrices in equations of motion, and in what is claimed of them."""

from __future__ import annotations

from contextlib import suppress
from dataclasses import replace

from kowalevski_cas.notation import Formula, NotationError, read
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.paper.texts import IN_WORDS, Display
from kowalevski_cas.paper.unit_matrices import unit_matrices
from kowalevski_cas.paper.vocabulary import vocabulary
from kowalevski_cas.system.rows import Names, moving_names, read_rows, vocabulary_of
from kowalevski_cas.system.vectors import Vectors


def with_unit_matrices(tex: str, vectors: Vectors, declared: Names = ()) -> str:
    """Equations of motion, with the unit matrices that stand in them and are not printed."""
    display = Display("field", tex, "")
    words = vocabulary_of(display, vectors, declared)
    formulas = [*read_rows(display, words).values()] if words.matrices else []
    known = {name for formula in formulas for name in moving_names(formula)} | {*declared}
    known |= {name for place in display for name in place.heads.names}
    names = dict.fromkeys(name for formula in formulas for name in sorted(formula.names() - known))
    return r",\quad ".join((tex, *unit_matrices(formulas, names, words)))


def with_units(scene: Scene, display: Display) -> Scene:
    """A scene with the unit matrices that stand in a display.

    Raises ``ValueError`` for a name that is a number in the equations of motion.
    """
    words = vocabulary((scene,))
    if not words.matrices:
        return scene
    formulas: list[Formula] = []
    with suppress(NotationError):  # what cannot be read is the outcome of the claim
        formulas = [*read_rows(display, words).values()]
    known = {*scene.variables, *scene.definitions, *scene.roots, *scene.vectors}
    names = dict.fromkeys(name for formula in formulas for name in sorted(formula.names() - known))
    printed = [read(p.tex, words) for p in scene.definitions.values() if p.heads.matrix]
    for tex in unit_matrices([*formulas, *printed], names, words):
        name = tex.partition("=")[0]
        if name in scene.constants:
            raise ValueError(
                f"{name} is a number in the equations of motion, and a matrix here: print 1 for it"
            )
        scene = scene.defining(replace(display, id=f"unit-matrix-{name}", tex=tex, source=IN_WORDS))
    return scene
