"""Find the values of constants for which a polynomial F divides its derivative: F' = KF.

Names in F that the scene does not have are coefficients to be determined. All cases are found, with
the polynomial K of each; that there are no others is claimed too.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace

from kowalevski_cas.algebra.present import formula_of
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.notation import (
    Derivative,
    Formula,
    Name,
    Negative,
    Product,
    Sum,
    equal,
    read,
    times,
    to_latex,
    total,
)
from kowalevski_cas.notation.open import OpenParser
from kowalevski_cas.paper.claims import Identity, Implication, Union
from kowalevski_cas.paper.elaborate import Elaboration
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.pool import HERE, Pool
from kowalevski_cas.problem.mentions import mentions
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.questions import with_constants
from kowalevski_cas.search.parameters import DarbouxAnsatz, cofactor_monomials
from kowalevski_cas.verify.finding import Finding

LETTERS = (r"\kappa", r"\lambda", r"\mu")


def search(
    on: Elaborations, scene: Scene, pool: Pool = HERE, *, polynomial: str
) -> Iterator[Finding]:
    """What F' = KF asks of the constants, that there are these cases only, and each of them."""
    letters = _letters(on(scene))
    unknown = _unknown(on(scene), polynomial)
    if not unknown and not scene.constants:
        raise Meaningless(
            "nothing is to be determined: no constant stands in the motion, and none in the "
            "polynomial; give that coefficients, as in `x+Ay`"
        )
    space = with_constants(on, scene, *unknown, *letters)
    scene, words = space.scene, space.texts.vocabulary
    ansatz = DarbouxAnsatz(space.finder, space.finder.scalar(space.formula(polynomial)), letters)

    def formula(element: Element) -> Formula:
        return formula_of(element, words)

    def tex(*sides: Formula | Element) -> str:
        members = (side if isinstance(side, Formula) else formula(side) for side in sides)
        return to_latex(equal(*members))

    value, zero = formula(ansatz.value), ansatz.at.ring.zero
    rate = Derivative(value, scene.time)
    terms = [times(formula(b), formula(a)) for a, b in ansatz.equations()]
    rest = Sum((rate, Negative(Product((formula(ansatz.cofactor), value)))))
    asked = tuple(tex(element, zero) for _, element in ansatz.equations())
    said = "F' − KF by its monomials; F' = KF where all their coefficients vanish"
    yield Finding(Identity, scene, said, tex(rest, total(terms)))
    cases = [*ansatz.cases(pool)]
    sets = dict.fromkeys(
        tuple(tex(*sides) for sides in case.equations if not _mention(space, sides, unknown))
        for case in cases
    )
    if all(sets):
        where = f"only where {_either(sets)}" if sets else "for no values of the constants"
        said = f"F' = KF {where}"
        if not any(map(_is_number, ansatz.trivial())):
            said += ", unless F is constant"
            sets[tuple(tex(element, zero) for element in ansatz.trivial())] = None
        yield Finding(
            Union, _at_rest(scene), said, attributes={"given": asked, "sets": tuple(sets)}
        )
    for case in cases:
        given = tuple(tex(*sides) for sides in case.equations)
        cofactor = formula(case.cofactor)
        said = f"F' = KF with $K={to_latex(cofactor)}$ where {_either([given])}"
        multiple = tex(rate, Product((cofactor, value)))
        yield Finding(Implication, scene, said, multiple, {"given": given})


def _at_rest(scene: Scene) -> Scene:
    """The scene without its motion, for statements about its constants."""
    names = (*scene.variables, *scene.constants)
    return replace(scene, name=f"{scene.name}, at rest", variables=names, constants=(), field=())


def _either(sets: Iterable[tuple[str, ...]]) -> str:
    """In words that one of several sets of equations holds."""
    shown = (" and ".join(f"${equation}$" for equation in given) or "always" for given in sets)
    return ", or ".join(shown)


def _mention(space: Elaboration, sides: Iterable[Element], names: Iterable[str]) -> bool:
    """Whether one of some names stands in an equation."""
    return any(not space.finder.partial(side, name).is_zero for side in sides for name in names)


def _letters(space: Elaboration) -> tuple[str, ...]:
    """Names for the coefficients of K that the scene does not have."""
    letter = next(
        letter
        for letter in LETTERS
        if not any(name.startswith(letter) for name in space.scene.names())
    )
    indices = range(len(cofactor_monomials(space.finder)))
    return tuple(f"{letter}_{k}" if k < 10 else f"{letter}_{{{k}}}" for k in indices)


def _unknown(space: Elaboration, tex: str) -> tuple[str, ...]:
    """The names in a formula that have no meaning on the scene."""
    names = mentions(read(tex, space.texts.vocabulary, OpenParser))
    return tuple(n.name for n in names if isinstance(n, Name) and not space.finder.knows(n))


def _is_number(element: Element) -> bool:
    """Whether an element is a number other than zero."""
    return all(not any(m) for m in element.terms().get(0, {}))
