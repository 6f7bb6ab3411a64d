"""Scenes with what is defined or supposed beside equations of motion: roots, special constants."""

from __future__ import annotations

from dataclasses import replace

from kowalevski_cas.notation import (
    Application,
    Formula,
    Name,
    Negative,
    Number,
    Power,
    Relation,
    Root,
    read,
    to_latex,
)
from kowalevski_cas.notation.open import OpenParser
from kowalevski_cas.notation.symbol import symbol
from kowalevski_cas.paper.applied import SPECTRAL
from kowalevski_cas.paper.claims.forms import minus
from kowalevski_cas.paper.names import BRACKET, head
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.paper.signs import is_inequality
from kowalevski_cas.paper.texts import IN_WORDS, Display, Printed
from kowalevski_cas.paper.vocabulary import vocabulary
from kowalevski_cas.system.refused import check_no_differentials
from kowalevski_cas.system.roots import with_roots
from kowalevski_cas.system.rows import read_rows
from kowalevski_cas.system.vectors import lengths, vectors_of


def with_row(scene: Scene, place: Printed, formula: Formula) -> Scene:
    """A scene with what is defined or supposed beside the equations of motion."""
    if {*place.heads.names} - {*scene.variables, *scene.constants}:
        return scene.defining(place)
    if (supposing := _suppose(scene, place, formula)) is not None:
        return supposing
    if len(place.heads.squares) == 1:
        return scene.adjoining(place)
    what = "is no equation of motion, and defines no name: print a name alone on one side"
    raise ValueError(
        f"{place.tex} {what}; what is supposed is printed with "
        r"\ne, and an equation that holds on a set is given to a claim"
    )


def _suppose(scene: Scene, place: Printed, formula: Formula) -> Scene | None:
    """A scene with what is supposed not to vanish, or to be positive, or the imaginary unit."""
    if is_inequality(formula):
        return with_roots(scene, place.display).assuming(place)
    match formula:
        case Relation((left, right), (r"\ne",)):
            return scene.having(nonzero=(to_latex(minus((left, right))),))
        case Relation((Power(Name("i"), Number(2)), Negative(Number(1))), ("=",)):
            kept = tuple(name for name in scene.constants if name != "i")
            return replace(scene, constants=kept).with_unit(place)
    return None


def with_parameters(scene: Scene, display: Display) -> Scene:
    r"""A scene with the new names of which a display defines functions, as :math:`L(\lambda)`.

    They are constants: a function stands for its value whatever they are. New vectors have
    components.
    """
    words = vocabulary((scene,))
    if (vectors := vectors_of(display, scene.vectors, words)) != scene.vectors:
        scene = replace(scene, vectors=vectors)
    heads_of = [head(name) for place in display for name in place.heads.names]
    arguments = dict.fromkeys(one for name, listed in heads_of if name != BRACKET for one in listed)
    known = {name for name, _ in heads_of} | {*scene.names(), *scene.vectors, scene.time, "t"}
    new = (
        argument
        for argument in arguments
        if argument not in known and not argument.startswith(r"\dot")
    )
    return scene.having(constants=tuple(new))


def with_levels(scene: Scene, place: Printed) -> Scene:
    r"""A scene with the new names in an integral: T for it, or its value, as h in :math:`2T=2h`.

    The parameter of a spectral curve, :math:`\det(L-\mu)`, is any number.
    """
    known = {*scene.names(), *scene.definitions, *scene.vectors, scene.time}
    scene = with_parameters(scene, place.display)
    heads = place.heads.names or place.heads.multiples
    for name in heads:
        if name not in known:
            scene = scene.naming(name, place)
    formula = read_rows(place.display, vocabulary((scene,)))[place]
    curves = (n for n in formula.nodes() if isinstance(n, Application) and n.function == r"\det")
    spectral = {name for curve in curves for name in curve.names() if name in SPECTRAL} - known
    scene = scene.having(constants=(*sorted(spectral),))
    known |= spectral
    members = formula.members if isinstance(formula, Relation) else ()
    names = [{node.name for node in member.nodes() if isinstance(node, Name)} for member in members]
    new = {one for own in names if own.isdisjoint({*known, *heads}) for one in own}
    if known.isdisjoint(one for own in names for one in own):
        return scene  # of nothing that moves it is no value
    return scene.having(constants=tuple(sorted(new - {*scene.names()})))


def with_lengths(scene: Scene, display: Display) -> Scene:
    r"""A scene with the lengths of vectors that a display names, as :math:`\gamma^2=1`.

    Raises ``ValueError`` for a capital, which may be something else than the length.
    """
    known = {*scene.names(), *scene.definitions, *scene.roots, scene.time}
    vectors = {
        name: parts
        for name, parts in scene.vectors.items()
        if symbol(name).without_type.name not in known
    }
    formulas = [*read_rows(display, vocabulary((scene,))).values()] if vectors else []
    for tex in lengths(formulas, vectors, scene.variables):
        place = replace(display, id=f"{display.id}-length", tex=tex, source=IN_WORDS)
        scene = with_roots(scene.defining(place), place)
    return scene


def _with_real_root(scene: Scene, name: str, place: Printed, formula: Formula) -> Scene:
    """A scene on which what a relation says to be a square is not negative.

    A claim that does not speak of the name is one about real points, too.
    """
    for side in formula.children():
        if name not in side.names() and not side.names().isdisjoint(scene.constants):
            tex = rf"{to_latex(side)}\ge0"
            display = replace(
                place.display, id=f"{place.display.id}-real", tex=tex, source=IN_WORDS
            )
            return with_roots(scene, display).assuming(display)
    return scene


def _with_real_roots(scene: Scene, place: Printed, formula: Formula) -> Scene:
    """A scene on which the roots of constants are real that a relation prints."""
    for k, root in enumerate(node for node in formula.nodes() if isinstance(node, Root)):
        names = root.argument.names()
        if names and names <= {*scene.constants}:
            id, tex = f"{place.display.id}-root-{k}", rf"{to_latex(root.argument)}\ge0"
            display = replace(place.display, id=id, tex=tex, source=IN_WORDS)
            scene = with_roots(scene, display).assuming(display)
    return scene


def restrict(scene: Scene, place: Printed) -> Scene:
    """A scene with what a relation says of its constants."""
    formula = read(place.tex, vocabulary((scene,)), OpenParser)
    check_no_differentials(formula)
    if (supposing := _suppose(scene, place, formula)) is not None:
        return supposing
    # A name that is a square is not negative: as the root of it, the other one would be left out.
    for name in (*place.heads.names, *place.heads.squares):
        if name in scene.constants:
            kept = tuple(constant for constant in scene.constants if constant != name)
            rest = replace(scene, constants=kept)
            if name not in place.heads.squares:
                return _with_real_roots(rest.naming(name, place), place, formula)
            return _with_real_root(rest.adjoining(place), name, place, formula)
    known = ", ".join(scene.constants)
    solve = f"solve it for one of {known}, or" if known else "there is none:"
    raise ValueError(f"{place.tex} gives no constant: {solve} declare a further one by `having`")
