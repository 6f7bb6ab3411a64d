"""Find an invariant set: a function and its derivatives, as many as express the next one.

The shortest chain is told that closes by some division; then longer ones whose divisors have lower
degrees, and where no condition is left the last one. If the equation of a chain is a symmetric
power, or has constant coefficients, an integral is read off it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

from kowalevski_cas.algebra.present import formula_of
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.notation import (
    Derivative,
    Formula,
    Number,
    Product,
    equal,
    read,
    to_latex,
    total,
)
from kowalevski_cas.paper.claims import FirstIntegral, Identity, InvariantRelations, LocalDimension
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.pool import HERE, Pool
from kowalevski_cas.search.closure import Closure, closures
from kowalevski_cas.verify.finding import Finding
from kowalevski_cas.verify.outcome import in_latex


def search(
    on: Elaborations, scene: Scene, pool: Pool = HERE, *, seed: str, order: int = 4
) -> Iterator[Finding]:
    """The chains that close: their sets, their equations, and integrals by these."""
    space, vocabulary = on(scene), on.texts.vocabulary

    def tex(element: Element) -> str:
        return to_latex(formula_of(element, vocabulary))

    first = space.finder.scalar(space.formula(seed))
    for closure in closures(space.finder, first, order):
        relations = tuple(f"{tex(element)}=0" for element in closure.chain)
        said = "where these vanish they stay so"
        yield Finding(InvariantRelations, scene, said, attributes={"relations": relations})
        yield Finding(Identity, scene, _form(closure, tex), to_latex(_equation(closure, on, scene)))
        if closure.is_regular():
            size = len(space.variables) - len(closure.chain)
            values = closure.point.values
            point = [equal(read(name, vocabulary), values[name]) for name in space.variables]
            said = f"near a real point the set has dimension {size}: ${in_latex(point)}$"
            yield Finding(
                LocalDimension, scene, said, attributes={"equations": relations, "dimension": size}
            )
        for integral in closure.integrals():
            said = "it is constant along every motion, by the form of that equation"
            yield Finding(FirstIntegral, scene, said, tex(integral))


def nothing(seed: str, order: int) -> str:
    """What was searched."""
    return f"no chain of {order} derivatives of {seed} or fewer closes; --order allows longer ones"


def _equation(closure: Closure, on: Elaborations, scene: Scene) -> Formula:
    """The rate of the last derivative as a combination of the chain."""
    chain, row = (
        [formula_of(element, on.texts.vocabulary) for element in elements]
        for elements in (closure.chain, closure.row)
    )
    terms = [Product((c, f)) for c, f in zip(row, chain, strict=True) if c != Number(0)]
    return equal(Derivative(chain[-1], scene.time), total(terms))


def _form(closure: Closure, tex: Callable[[Element], str]) -> str:
    """What is known of an equation, in words."""
    if closure.is_constant():
        return "a linear equation with constant coefficients"
    q, degree = closure.power(), len(closure.row) - 1
    if q is None:
        return "the last derivative as a combination of those before"
    power = {1: "", 2: "the symmetric square of "}.get(degree, f"symmetric power {degree} of ")
    return f"{power}y'' = qy with $q={tex(q)}$"
