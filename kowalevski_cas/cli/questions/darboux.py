"""Find the Darboux polynomials of a scene of a derivation, up to a degree: F' = KF.

Neither F nor K is given. What is a combination of products of those found before is left out. With
--special, they are found for special values of the constants too.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING

from kowalevski_cas.algebra.numbers import rational
from kowalevski_cas.algebra.present import formula_of
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.cli.session import natural
from kowalevski_cas.notation import (
    Derivative,
    Formula,
    Name,
    Number,
    Partial,
    Power,
    Product,
    Quotient,
    Relation,
    Sum,
    times,
    to_latex,
)
from kowalevski_cas.paper.claims import DarbouxPolynomial, FirstIntegral, Identity, Implication
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.pool import HERE, Pool
from kowalevski_cas.verify.found import Finding

if TYPE_CHECKING:
    from kowalevski_cas.search.cofactor_relations import Relation as CofactorRelation
    from kowalevski_cas.search.darboux import Darboux


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The arguments of the question."""
    parser.add_argument(
        "--degree", type=natural, default=2, metavar="N", help="the highest degree (2)"
    )
    parser.add_argument(
        "--special", action="store_true", help="constants may have special values as well"
    )


def search(
    on: Elaborations, scene: Scene, arguments: argparse.Namespace, pool: Pool = HERE
) -> Iterator[Finding]:
    """The Darboux polynomials, the lowest degrees first, and what is built from them."""
    from kowalevski_cas.problem.polynomial_fields import PolynomialField
    from kowalevski_cas.search.cofactor_relations import relations
    from kowalevski_cas.search.darboux import darboux_polynomials

    def formula(element: Element) -> Formula:
        return formula_of(element, on.texts.vocabulary)

    at = on(scene).finder
    moving: list[Darboux] = []
    for one in darboux_polynomials(at, arguments.degree, arguments.special, pool):
        value, cofactor = formula(one.polynomial), formula(one.cofactor)
        if one.equations:
            given = tuple(_equation(formula(a), formula(b)) for a, b in one.equations)
            where = " and ".join(f"${one}$" for one in given)
            says = f"F' = KF with $K={to_latex(cofactor)}$ where {where}"
            multiple = _equation(Derivative(value, scene.time), Product((cofactor, value)))
            yield Finding(Implication, scene, says, multiple, {"given": given})
        elif one.cofactor.is_zero:
            yield Finding(FirstIntegral, scene, INTEGRAL, to_latex(value))
        else:
            moving.append(one)
            says = f"F' = KF with $K={to_latex(cofactor)}$"
            attributes = {"cofactor": to_latex(cofactor)}
            yield Finding(DarbouxPolynomial, scene, says, to_latex(value), attributes)
    for relation in relations(PolynomialField(at), moving):
        yield _product(relation, moving, scene, formula)


ONE = Number(1)
INTEGRAL = "it is constant along every motion"


def _product(
    relation: CofactorRelation,
    known: Sequence[Darboux],
    scene: Scene,
    formula: Callable[[Element], Formula],
) -> Finding:
    """That a product is an integral: as it stands if that can be written, else by its logarithm."""
    used = [
        (exponent, one)
        for exponent, one in zip(relation.exponents, known, strict=True)
        if not exponent.is_zero
    ]
    bases = [formula(one.polynomial) for _, one in used]
    whole = [rational(exponent) for exponent, _ in used]
    powers = [int(value) for value in whole if value is not None and value.denominator == 1]
    simple = len(powers) == len(used) and relation.exponential.is_zero
    if simple and not relation.multiplier:
        both = [(n, _power(base, Number(abs(n)))) for n, base in zip(powers, bases, strict=True)]
        above, below = (times(*(one for n, one in both if n * sign > 0)) for sign in (1, -1))
        quotient = above if below == ONE else Quotient(above, below)
        return Finding(FirstIntegral, scene, INTEGRAL, to_latex(quotient))
    exponents = [formula(exponent) for exponent, _ in used]
    factors = [to_latex(_power(base, n)) for base, n in zip(bases, exponents, strict=True)]
    terms: list[Formula] = [
        Product((n, formula(one.cofactor))) for n, (_, one) in zip(exponents, used, strict=True)
    ]
    if not relation.exponential.is_zero:
        exponential = formula(relation.exponential)
        factors.append(rf"e^{{{to_latex(exponential)}}}")
        terms.append(Derivative(exponential, scene.time))
    if relation.multiplier:
        terms += [Partial(Derivative(Name(n), scene.time), n) for n in scene.variables]
    kind = "is a last multiplier" if relation.multiplier else "is constant along every motion"
    says = f"so ${' '.join(factors)}$ {kind}"
    return Finding(Identity, scene, says, _equation(Sum(tuple(terms)), Number(0)))


def _power(base: Formula, exponent: Formula) -> Formula:
    return base if exponent == ONE else Power(base, exponent)


def _equation(left: Formula, right: Formula) -> str:
    return to_latex(Relation((left, right), ("=",)))
