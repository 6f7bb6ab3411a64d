"""Equations of motion, or a map, as they are printed, and the scene that they make."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any

from kowalevski_cas.notation import defined_names, read_display
from kowalevski_cas.paper.constraints import equations_on
from kowalevski_cas.paper.jets import with_jets
from kowalevski_cas.paper.names import BRACKET
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.paper.texts import Display
from kowalevski_cas.paper.vocabulary import vocabulary
from kowalevski_cas.system.conventions import Conventions, plain_print, spelled_out
from kowalevski_cas.system.equations import (
    components,
    constraints_in,
    scene_by,
    with_motion,
    with_time,
)
from kowalevski_cas.system.indices import chain_ends
from kowalevski_cas.system.maps import Map, index_of_map, with_images
from kowalevski_cas.system.refused import check_raised
from kowalevski_cas.system.roots import with_roots
from kowalevski_cas.system.symbols import latex_of
from kowalevski_cas.system.units import with_unit_matrices
from kowalevski_cas.system.unknown import TIMES, check_said
from kowalevski_cas.system.vectors import Vectors


@dataclass(frozen=True)
class PrintedLaw:
    """What moves, or is mapped, and how: conventions, and a scene with all that is printed."""

    conventions: Conventions
    scene: Scene
    images: tuple[tuple[str, str], ...]
    """The variables of a map with their images; none if it is a motion."""
    constraints: tuple[str, ...]
    """On what the motion is: constraints with multipliers, and their derivatives."""
    implied: frozenset[str]
    """The canonical brackets, which equations of Hamilton imply and nobody has printed."""
    equalities: tuple[tuple[str, str], ...]
    """The members of chains, which have to be equal."""


def read_law(
    field: str | Mapping[Any, Any],
    name: str,
    vectors: Vectors,
    map: bool,
    symbols: dict[str, Any],
    place: Callable[[str], Display],
) -> PrintedLaw:
    """The law that is printed, or given by expressions in ``symbols``, which are entered there.

    ``place`` makes a display of it. Raises ``ValueError`` if it is none; the message says why.
    """
    if isinstance(field, str):
        check_raised(field)
    tex = spelled_out(field) if isinstance(field, str) else _rows(field, symbols)
    tex, conventions, equalities, said = plain_print(tex, vectors, map)
    functions = conventions.functions
    words = [*symbols, *(one.name for one in functions)]
    parts = components(tex, vectors, words)
    jets = [jet for one in functions for jet in one.jets(parts)]
    words += dict.fromkeys(name for *both, _ in jets for name in both)
    printed = {name for statement in defined_names(tex) for name in statement.names}
    images, constraints = tuple[tuple[str, str], ...](), tuple[str, ...]()
    index = index_of_map(tex)
    if map or index:
        display = place(with_images(tex, parts, words, index))
        found = Map(display, parts, words, index)
        images = (*found.images.items(),)
        scene = with_roots(found.scene(name, parts), display)
    else:
        arguments = [by for one in functions for by in one.by if by not in TIMES]
        tex = with_unit_matrices(tex, parts, words)
        display = place(with_time(with_motion(tex, parts, words, arguments), parts, words))
        scene = scene_by(display, name, parts, words)
        constraints = (*equations_on(scene, constraints_in(display, parts, words)),)
    scene = with_jets(scene, jets) if jets else scene
    check_said(said, scene.constants)
    conventions = replace(conventions, ends=_ends_of_chains(tex, display, scene))
    implied = frozenset(brackets(scene.definitions)) - printed
    return PrintedLaw(conventions, scene, images, constraints, implied, equalities)


def _rows(field: Mapping[Any, Any], symbols: dict[str, Any]) -> str:
    """Equations of motion by their right sides."""
    if not isinstance(field, Mapping):
        raise TypeError(f"LaTeX, or right sides by the variables of SymPy, and not {field!r}")
    sides = (
        [one if isinstance(one, str) else latex_of(one, symbols) for one in row]
        for row in field.items()
    )
    rows = [rf"\dot{{{x}}}={force}" for x, force in sides]
    tex = r",\quad ".join(rows)
    if len(defined_names(tex)) != len(rows):
        raise ValueError(f"{tex}: give each variable one right side")
    return tex


def _ends_of_chains(tex: str, display: Display, scene: Scene) -> set[str]:
    """The names of a scene that are no links of a chain of their own."""
    rows = read_display(display.tex, vocabulary((scene,)))
    given = {
        name: row.formula
        for place, row in zip(display, rows, strict=True)
        for name in place.heads.names
        if name in scene.definitions
    }
    return chain_ends(tex, given)


def brackets(names: Iterable[str]) -> Iterator[str]:
    """The names that are Poisson brackets of variables."""
    return (name for name in names if name.startswith(BRACKET))
