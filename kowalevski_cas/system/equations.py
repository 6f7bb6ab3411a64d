"""What equations of motion say of their names, and scenes with roots and with special constants."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import replace

from kowalevski_cas.notation import (
    Application,
    Conjugate,
    Derivative,
    Formula,
    Name,
    Number,
    OpenParser,
    Partial,
    Relation,
    Root,
    Summation,
    Vocabulary,
    read,
    read_display,
    to_latex,
)
from kowalevski_cas.paper.plain import written_out
from kowalevski_cas.paper.scene import Scene, head, vocabulary
from kowalevski_cas.paper.texts import Display, Printed
from kowalevski_cas.problem.prune import mentions

_RATE = re.compile(r"\\dot\{([^{}]*)\}(.*)")


def roles(
    display: Display, vectors: Mapping[str, tuple[str, ...]]
) -> tuple[list[Printed], list[Printed], tuple[str, ...], tuple[str, ...]]:
    """The equations of motion, what is defined beside them, what moves, and the other names."""
    words = vocabulary(())
    heads = [head(name) for place in display for name in place.heads.names]
    named = frozenset(name for name, arguments in heads if arguments)  # as H in H(q,p)=…
    words = replace(
        words, vectors=frozenset(vectors), scalars=named, functions=words.functions | named
    )
    moving = dict.fromkeys(name for place in display for name in _moving(_open(place, words)))
    words = replace(words, moving=frozenset(moving))  # only these may be printed as x(t)
    laws = [place for place in display if _is_law(_open(place, words))]
    others = [place for place in display if place not in laws]
    for place in others:
        if not {*place.heads.names} - {*moving}:
            raise ValueError(f"{place.tex} is no equation of motion, and defines no name")
    if len(laws) > len(moving):
        raise ValueError(
            f"{len(laws)} equations for {len(moving)} unknowns ({', '.join(moving)}): "
            "leave one out, or claim it as an identity"
        )
    mentioned = dict.fromkeys(name for place in display for name in _mentioned(place, words))
    if "t" in mentioned:
        raise ValueError("the time t stands in the equations: give it a name, with \\dot s=1")
    heads = [head(name) for place in others for name in place.heads.names]
    defined = {one for name, arguments in heads for one in (name, *arguments)}
    for name in (name for place in display for name in _derived(_open(place, words))):
        if name not in defined:
            raise ValueError(f"{name} is differentiated, and nothing defines it: add {name}=…")
    defined |= {*moving}
    return laws, others, tuple(moving), tuple(name for name in mentioned if name not in defined)


def _open(place: Printed, words: Vocabulary) -> Formula:
    """What stands at a place, where any letter is a name; sums are written out."""

    def written(formula: Formula) -> Formula:
        formula = written_out(formula) if isinstance(formula, Summation) else formula
        return formula.mapped(written)

    return written(read(place.tex, words, OpenParser))


def _mentioned(place: Printed, words: Vocabulary) -> list[str]:
    return [one.name for one in mentions(_open(place, words)) if isinstance(one, Name)]


def _is_law(formula: Formula) -> bool:
    """Whether a rate stands in an equation, and no name for something else on its left."""
    first = formula.members[0] if isinstance(formula, Relation) else formula
    return not isinstance(first, Name | Application) and bool(_moving(formula))


def _moving(formula: Formula) -> list[str]:
    """The names that stand under a derivative, or by whose rates something is derived."""
    if isinstance(formula, Derivative) and isinstance(formula.argument, Name):
        return [formula.argument.name]
    found = [name for child in formula.children() for name in _moving(child)]
    rate = _RATE.fullmatch(formula.by) if isinstance(formula, Partial) else None
    return [rate[1] + rate[2], *found] if rate else found


def _derived(formula: Formula) -> list[str]:
    """The names of which partial derivatives are printed."""
    partial = (one.argument for one in formula.nodes() if isinstance(one, Partial))
    return [argument.name for argument in partial if isinstance(argument, Name)]


def rooted(scene: Scene, display: Display) -> Scene:
    """A scene with the square roots that are printed in a display of its names.

    Raises ``ValueError`` if a name is defined there by two expressions, of which one would be lost,
    and for a bar, which would say nothing.
    """
    waiting = [statement.formula for statement in read_display(display.tex, vocabulary((scene,)))]
    for place, formula in zip(display, waiting, strict=True):
        named = {*place.heads.names} & {*scene.definitions}
        if named and len([*formula.children()]) > len(named) + 1:
            raise ValueError(f"{place.tex} gives {min(named)} twice: leave one side out")
    for formula in (node for one in waiting for node in one.nodes()):
        if isinstance(formula, Conjugate):
            raise ValueError(f"{to_latex(formula)} is a conjugate, and all is real: rename it")
        if isinstance(formula, Root) and (name := to_latex(formula)) not in scene.roots:
            scene = scene.adjoining(name)
    return scene


def restricted(scene: Scene, place: Printed) -> Scene:
    """A scene with what a relation says of its constants."""
    formula = read(place.tex, vocabulary((scene,)), OpenParser)
    match formula:
        case Relation((left, Number(0)), (r"\ne",)):
            return scene.having(nonzero=(to_latex(left),))
    if any(name in scene.constants for name in place.heads.squares):
        return scene.adjoining(place)
    for name in place.heads.names:
        if name in scene.constants:
            kept = tuple(one for one in scene.constants if one != name)
            return replace(scene, constants=kept).naming(name, place)
    raise ValueError(
        f"{place.tex} gives no constant: solve it for one of {', '.join(scene.constants) or 'none'}"
    )
