"""The square roots of a scene: those that are printed, at images, and what says of signs."""

from __future__ import annotations

from collections.abc import Iterable

from kowalevski_cas.notation import (
    Application,
    Conjugate,
    Constant,
    Formula,
    Modulus,
    Name,
    Negative,
    Number,
    Power,
    Root,
    Sum,
    rank,
    read,
    read_display,
    substitute,
    times,
    to_latex,
)
from kowalevski_cas.notation.functions import SIGN
from kowalevski_cas.notation.open import OpenParser
from kowalevski_cas.notation.vocabulary import VECTOR
from kowalevski_cas.paper.exponents import half_power
from kowalevski_cas.paper.functions import without_extremes
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.paper.summation import without_sums
from kowalevski_cas.paper.texts import Display
from kowalevski_cas.paper.vocabulary import vocabulary


def with_roots(scene: Scene, display: Display) -> Scene:
    """A scene with the square roots that are printed in a display of its names.

    Raises ``ValueError`` if a name is defined there by two expressions, of which one would be lost,
    and for a bar, which would say nothing.
    """
    printed = read_display(display.tex, vocabulary((scene,)))
    waiting = [without_extremes(without_sums(statement.formula)) for statement in printed]
    for place, formula in zip(display, waiting, strict=True):
        named = {*place.heads.names} & {*scene.definitions}
        sides = [side for side in formula.children() if not isinstance(side, Constant)]
        if named and len(sides) > len(named) + 1:
            raise ValueError(f"{place.tex} gives {min(named)} twice: leave one side out")
    inner_first = (node for formula in waiting for node in reversed([*formula.nodes()]))
    for formula in inner_first:
        if isinstance(formula, Conjugate) and scene.unit is None:
            raise ValueError(
                f"{to_latex(formula)} is a conjugate, and all is real: rename it, or print i^2=-1 "
                "beside the equations of motion if they are complex"
            )
        words = vocabulary((scene,))
        root = _root(formula)
        if isinstance(formula, Modulus) and scene.unit and rank(formula.argument, words) != VECTOR:
            root = Root(times(formula.argument, Conjugate(formula.argument)))
        if root is not None and {name := to_latex(root), _opposite(root)}.isdisjoint(scene.roots):
            scene = scene.adjoining(name)
    return scene


def with_roots_at_images(scene: Scene, images: Iterable[tuple[str, str]]) -> Scene:
    """A scene with the square roots that it has at the images of a map, too."""
    there = {x: Name(new) for x, new in images}
    for root in _roots(scene):
        at_image = substitute(root, there)
        assert isinstance(at_image, Root)
        if {to_latex(at_image), _opposite(at_image)}.isdisjoint(scene.roots):
            scene = scene.adjoining(to_latex(at_image))
    return scene


def with_signs_of_moduli(scene: Scene) -> Scene:
    """A scene that says of absolute values that none is negative, if this may be needed.

    For products of them it is known anyway; so it is for sums that stand between bars.
    """
    words = vocabulary((scene,))
    moduli = [
        root
        for root in _roots(scene)
        if isinstance(root.argument, Power)
        and root.argument.exponent == Number(2)
        and rank(root.argument.base, words) != VECTOR
    ]
    if len(moduli) > 1 and any(isinstance(n, Sum) for root in moduli for n in root.nodes()):
        new = (to_latex(Root(root)) for root in moduli)
        scene = scene.adjoining(*(name for name in new if name not in scene.roots))
    return scene


def _roots(scene: Scene) -> list[Root]:
    """The square roots of a scene of which no equation is printed."""
    words = vocabulary((scene,))
    names = (name for name, place in scene.roots.items() if place is None)
    found = (read(name, words, OpenParser) for name in names if name.startswith(r"\sqrt"))
    return [root for root in found if isinstance(root, Root)]


def _opposite(root: Root) -> str:
    r"""The same length as it may be printed otherwise: :math:`|a-b|` is :math:`|b-a|`."""
    match root:
        case Root(Power(Sum((left, Negative(right))), exponent)):
            return to_latex(Root(Power(Sum((right, Negative(left))), exponent)))
    return to_latex(root)


def _root(formula: Formula) -> Root | None:
    """The square root that a root, an absolute value, a length or a power 3/2 is made of."""
    match formula:
        case Root():
            return formula
        case Modulus(argument):
            return Root(Power(argument, Number(2)))
        case Application(function, (argument,)) if function == SIGN:
            return Root(Power(argument, Number(2)))
        case Power(base, exponent) if half_power(exponent) is not None:
            return Root(base)
    return None
