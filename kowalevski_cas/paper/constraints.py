r"""Constraints with multipliers: :math:`x^2+y^2+z^2=\ell^2`, or :math:`a\cdot\omega=0`.

A constraint is printed beside equations of motion in which a multiplier stands, a constant
:math:`\lambda` or :math:`\mu`. Derived along the motion until the multipliers stand in it, it gives
them; so the motion is one of all variables, and no motion leaves the set on which the constraints
and their derivatives hold. What is claimed is claimed there.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from itertools import pairwise

from kowalevski_cas.algebra.derivation import along
from kowalevski_cas.algebra.ideals import vanish_on
from kowalevski_cas.algebra.linear import Singular, solve
from kowalevski_cas.algebra.present import formula_of
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.notation import Derivative, Formula, Name, Power, Relation, to_latex
from kowalevski_cas.notation.symbol import symbol
from kowalevski_cas.paper.components import sides
from kowalevski_cas.paper.elaborate import Elaboration
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.paper.texts import Printed, Texts
from kowalevski_cas.paper.vocabulary import vocabulary

MULTIPLIERS = (r"\lambda", r"\mu")
# the multiplier comes in with the second derivative of positions, the first of velocities
MOST = 2
"""How often a constraint is derived."""


def constraints(
    formulas: Mapping[Printed, Formula],
    moving: Collection[str],
    vectors: Mapping[str, Sequence[str]],
) -> list[Printed]:
    """The equations among what moves that give no name, beside equations with a multiplier.

    Raises ``ValueError`` for one that may be either.
    """
    parts = {part for name in moving for part in vectors.get(name, ())} | {*moving}
    orders = orders_in(formulas.values())
    laws = [f for f in formulas.values() if orders_in([f])]
    letters = {symbol(n).letter for f in laws for n in f.names() - parts} & {*MULTIPLIERS}
    found = []
    for place, formula in formulas.items() if letters else ():
        low = all(order < orders[name] for name, order in orders_in([formula]).items())
        if not low or not isinstance(formula, Relation) or {*formula.signs} != {"="}:
            continue
        first, last = formula.members[0], formula.members[-1]
        names, squares = {*place.heads.names} - parts, {*place.heads.squares} - parts
        if names or (isinstance(first, Name) and first.name in vectors):
            continue
        if squares and (not isinstance(last, Power) or MULTIPLIERS[0] not in letters):
            continue
        others = (formula for other, formula in formulas.items() if other is not place)
        if squares and any(other.names() & squares for other in others):
            name = min(squares)
            raise ValueError(
                f"{place.tex}: a constraint, or a name? print {name}^2=… for a name; if it is a "
                f"constraint, leave {name} out of the other equations"
            )
        if not formula.names().isdisjoint(parts | {*vectors}):
            found.append(place)
    return found


def multipliers(
    scene: Scene, places: Sequence[Printed], called: Collection[str] = ()
) -> Iterator[str]:
    """Equations that give the multipliers of constraints: those that are ``called`` so, or by λ, μ.

    Raises ``ValueError`` if there are not as many as constraints, or if they do not follow.
    """
    space, words = _space(scene), vocabulary((scene,))
    used = {name for formula in space.printed_field for name in formula.names()}
    letters = {n: symbol(n).letter for n in scene.constants if n in used}
    names = [n for n in called if n in letters]
    names = names or [n for n, letter in letters.items() if letter == MULTIPLIERS[0]]
    if not called and len(names) < len(places):
        names += [n for n, letter in letters.items() if letter == MULTIPLIERS[1]]
    functions = [f for place in places for f in _functions(place, space)]
    if len(names) != len(functions):
        said = ", ".join(names) or "none"
        raise ValueError(
            f"{len(functions)} constraints and the multipliers {said}: print as many, "
            r"with the letter \lambda"
        )
    ring = space.finder.ring
    derived = [_until(function, names, space) for function in functions]
    matrix = [[_partial(constraint, name) for name in names] for constraint in derived]
    right = []
    for one, row in zip(derived, matrix, strict=True):
        rest = one
        for entry, name in zip(row, names, strict=True):
            rest = rest - entry * ring.generator(name)
        right.append([-rest])
    if any(not _partial(e, n).is_zero for row in matrix for e in row for n in names):
        raise ValueError("the multipliers do not stand linearly in the constraints derived")
    try:
        found = solve(matrix, right)
    except Singular:
        raise ValueError(f"the constraints do not determine {', '.join(names)}") from None
    for name, (value,) in zip(names, found, strict=True):
        yield f"{name}={to_latex(formula_of(value, words))}"


def equations_on(
    scene: Scene, places: Iterable[Printed], beside: Iterable[Printed] = ()
) -> Iterator[str]:
    """The constraints, and those of their derivatives that do not follow, with some ``beside``."""
    space, words = _space(scene), vocabulary((scene,))
    known = [function for place in beside for function in _functions(place, space)]
    for place in places:
        for function in _functions(place, space):
            while not all(vanish_on([function], known)):
                yield f"{to_latex(formula_of(function, words))}=0"
                known.append(function)
                function = space.finder.derivative(function)


def _space(scene: Scene) -> Elaboration:
    return Elaborations(Texts(vocabulary((scene,))))(scene)


def _functions(place: Printed, space: Elaboration) -> Iterator[Element]:
    """What a constraint says to vanish."""
    relation = space.texts.relation(place)
    for left, right in pairwise(sides(relation.members, space)):
        yield space.finder.scalar(left) - space.finder.scalar(right)


def _until(function: Element, names: Collection[str], space: Elaboration) -> Element:
    """The first derivative of a function in which one of the names stands."""
    for _ in range(MOST + 1):
        if not all(_partial(function, name).is_zero for name in names):
            return function
        function = space.finder.derivative(function)
    raise ValueError(f"a constraint gives no multiplier, derived {MOST} times")


def _partial(element: Element, name: str) -> Element:
    return along(element, {name: element.ring.one})


def orders_in(formulas: Iterable[Formula]) -> dict[str, int]:
    """The names that are derived by the time in formulas, and how often they are at most."""
    found: dict[str, int] = {}
    for formula in formulas:
        for node in formula.nodes():
            order = 0
            while isinstance(node, Derivative):
                node, order = node.argument, order + 1
            if order and isinstance(node, Name):
                found[node.name] = max(order, found.get(node.name, 0))
    return found
