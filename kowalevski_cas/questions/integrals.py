"""Find the polynomial first integrals of a scene of a derivation, up to a degree.

What is a polynomial in those found before is left out, what the scene has a name for is called by
it, and the others are shortened by products of those before. That there are no others is claimed
too; not so on the set of given relations (--on), where some polynomials vanish, nor where functions
or roots stand in the equations of motion: integrals are polynomials in these as well then.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress
from math import lcm

from kowalevski_cas.algebra.present import formula_of, name_formula
from kowalevski_cas.notation import Name, substitute, to_latex
from kowalevski_cas.paper.claims import AllIntegrals, FirstIntegral
from kowalevski_cas.paper.elaborate import Elaboration
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.pool import HERE, Pool
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.polynomial_fields import PolynomialField, Terms
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.questions.exponents import leading_part
from kowalevski_cas.verify.finding import Attribute, Finding

DEGREE = 2
"""The highest degree, if none is given."""

EVERYWHERE = "it is constant along every motion"


def search(
    elaborations: Elaborations,
    scene: Scene,
    pool: Pool = HERE,
    *,
    degree: int = 0,
    weighted: bool = False,
    on: Sequence[str] = (),
) -> Iterator[Finding]:
    """The integrals, the lowest degrees first, and that these are all."""
    from kowalevski_cas.search.integrals import first_integrals
    from kowalevski_cas.search.known_integrals import name_of, shorten

    if on and weighted:
        raise Meaningless("relations need not be homogeneous: take either --on or --weighted")
    if on:
        yield from _on_a_set(elaborations, scene, degree or DEGREE, tuple(on))
        return
    space = elaborations(scene)
    if (space.transcendental.groups or space.roots) and "i" not in space.roots:
        if weighted:
            raise Meaningless("functions and roots have no weights: leave --weighted out")
        yield from _in_functions(elaborations, scene, degree or DEGREE, pool)
        return
    at, found = space.finder, list[str]()
    weights = _weights(at) if weighted else ()
    if weights and not degree:
        weights, degree = _by_exponents(elaborations, scene, pool)
    degree = degree or DEGREE
    field = PolynomialField(at)
    before: list[Terms] = []
    named = _named(elaborations(scene), field)
    for element in first_integrals(at, degree, weights, pool):
        terms = field.polynomial(element)
        if name := name_of(terms, before, named, field.size):
            before.append(named[name])
        else:
            before.append(shorten(terms, before, field.size))
            name = to_latex(formula_of(field.element(before[-1]), elaborations.texts.vocabulary))
        found.append(name)
        yield Finding(FirstIntegral, scene, EVERYWHERE, name)
    known = "a polynomial in these" if found else "a constant"
    words = f"each polynomial first integral up to degree {degree} is {known}"
    if scene.constants:
        words += ", for almost all values of the constants"
    if weights:
        counted = zip(at.setting.variables, weights, strict=True)
        words += f", where {', '.join(f'${name}$ has weight {weight}' for name, weight in counted)}"
    attributes: dict[str, Attribute] = {"integrals": tuple(found), "degree": degree}
    attributes["weights"] = weights
    yield Finding(AllIntegrals, scene, words, attributes=attributes, steps=True)


def _named(space: Elaboration, field: PolynomialField) -> dict[str, Terms]:
    """The polynomial first integrals that a scene has names for."""
    from kowalevski_cas.search.known_integrals import degree

    found: dict[str, Terms] = {}
    for name in space.scene.definitions:
        with suppress(Meaningless):
            element = space.finder.scalar(Name(name))
            if space.finder.derivative(element).is_zero:
                found[name] = field.polynomial(element)
    return {name: terms for name, terms in found.items() if degree(terms, field.size)}


def _in_functions(
    elaborations: Elaborations, scene: Scene, degree: int, pool: Pool
) -> Iterator[Finding]:
    """The integrals that are polynomials in variables, functions and roots."""
    from kowalevski_cas.search.polynomial_extension import integrals_in_functions

    words = elaborations.texts.vocabulary
    for formula in integrals_in_functions(elaborations(scene).finder, degree, pool):
        printed = {name: name_formula(name, words) for name in formula.names()}
        yield Finding(FirstIntegral, scene, EVERYWHERE, to_latex(substitute(formula, printed)))


def _on_a_set(
    elaborations: Elaborations, scene: Scene, degree: int, relations: tuple[str, ...]
) -> Iterator[Finding]:
    """The integrals on an invariant set."""
    from kowalevski_cas.search.restricted import integrals_on

    space = elaborations(scene)
    given = space.finder.differences(space.equations(relations))
    for element in integrals_on(space.finder, given, degree):
        tex = to_latex(formula_of(element, elaborations.texts.vocabulary))
        if space.finder.derivative(element).is_zero:
            yield Finding(FirstIntegral, scene, EVERYWHERE, tex)
        else:
            where = ", ".join(f"${relation}$" for relation in relations)
            says = f"it is constant along every motion while {where}"
            yield Finding(FirstIntegral, scene, says, tex, {"given": relations})


def _weights(at: Evaluation) -> tuple[int, ...]:
    weights = PolynomialField(at).positive_weights
    if weights is None:
        raise Meaningless("the motion is homogeneous for no positive weights: leave --weighted out")
    return weights


def _by_exponents(on: Elaborations, scene: Scene, pool: Pool) -> tuple[tuple[int, ...], int]:
    """Whole weights, and the largest Kowalevski exponent in these units.

    The weight of an integral whose differential does not vanish at a balance is an exponent there.
    """
    part, *_ = leading_part(on, scene)
    unit = lcm(*(weight.denominator for weight in part.weights))
    weights = tuple(int(unit * weight) for weight in part.weights)
    exponents = (exponent for balance in part.balances(pool) for exponent in balance.exponents)
    return weights, max(DEGREE, int(unit * max(exponents, default=0)))
