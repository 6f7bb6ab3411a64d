"""Find the Darboux polynomials of a scene of a derivation, up to a degree: F' = KF.

Neither F nor K is given. What is a combination of products of those found before is left out. With
--special, they are found for special values of the constants too; with --cofactor, those for one K,
and that there are no others is claimed: only that question is linear.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING

from kowalevski_cas.algebra.numbers import rational
from kowalevski_cas.algebra.present import formula_of
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.notation import (
    Application,
    Derivative,
    Formula,
    Name,
    Number,
    Partial,
    Product,
    Quotient,
    Sum,
    equal,
    power,
    times,
    to_latex,
)
from kowalevski_cas.paper.claims import (
    AllDarboux,
    DarbouxPolynomial,
    FirstIntegral,
    Identity,
    Implication,
)
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.pool import HERE, Pool
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.verify.finding import Attribute, Finding

if TYPE_CHECKING:
    from kowalevski_cas.search.cofactor_relations import CofactorRelation as CofactorRelation
    from kowalevski_cas.search.cofactor_relations import Exponential
    from kowalevski_cas.search.darboux import Darboux


def search(
    on: Elaborations,
    scene: Scene,
    pool: Pool = HERE,
    *,
    degree: int = 2,
    special: bool = False,
    cofactor: str = "",
) -> Iterator[Finding]:
    """The Darboux polynomials, the lowest degrees first, and what is built from them."""
    from kowalevski_cas.problem.polynomial_fields import PolynomialField
    from kowalevski_cas.search.cofactor_relations import exponential_factors, relations
    from kowalevski_cas.search.darboux import darboux_polynomials

    def formula(element: Element) -> Formula:
        return formula_of(element, on.texts.vocabulary)

    if cofactor and special:
        raise Meaningless("the constants are general for one K: take --cofactor or --special")
    if cofactor:
        yield from _with_cofactor(on, scene, pool, degree, cofactor)
        return
    at = on(scene).finder
    moving: list[Darboux] = []
    for polynomial in darboux_polynomials(at, degree, special, pool):
        value, K = formula(polynomial.polynomial), formula(polynomial.cofactor)
        if polynomial.equations:
            given = tuple(to_latex(equal(formula(a), formula(b))) for a, b in polynomial.equations)
            where = " and ".join(f"${equation}$" for equation in given)
            says = f"F' = KF with $K={to_latex(K)}$ where {where}"
            multiple = to_latex(equal(Derivative(value, scene.time), Product((K, value))))
            yield Finding(Implication, scene, says, multiple, {"given": given})
        elif polynomial.cofactor.is_zero:
            yield Finding(FirstIntegral, scene, INTEGRAL, to_latex(value))
        else:
            moving.append(polynomial)
            attributes = {"cofactor": to_latex(K)}
            yield Finding(DarbouxPolynomial, scene, PAIR, to_latex(value), attributes)
    field = PolynomialField(at)
    exponentials: list[Exponential] = []
    for factor in exponential_factors(field, moving, degree):
        exponentials.append(factor)
        if factor.is_polynomial:
            continue  # there are many of them: told where a product needs them
        exponent, rate = formula(factor.exponent), formula(factor.cofactor)
        whole = to_latex(Application(r"\exp", (exponent,)))
        says = f"so ${whole}$ is an exponential factor"
        yield Finding(
            Identity, scene, says, to_latex(equal(Derivative(exponent, scene.time), rate))
        )
    for relation in relations(field, moving, exponentials):
        yield _product(relation, moving, scene, formula)


def nothing(degree: int, special: bool, **_: object) -> str:
    """What was searched, and what not."""
    said = f"no polynomial up to degree {degree} with F' = KF was found"
    if special:
        return f"{said}, whatever the constants are"
    return f"{said} for constants in general position; --special tries special values too"


def _with_cofactor(
    on: Elaborations, scene: Scene, pool: Pool, degree: int, given: str
) -> Iterator[Finding]:
    """All F with F' = KF for a given K, and that there are no others."""
    from kowalevski_cas.search.integrals import first_integrals

    def tex(element: Element) -> str:
        return to_latex(formula_of(element, on.texts.vocabulary))

    at = on(scene).finder
    cofactor = at.scalar(on(scene).formula(given))
    if cofactor.is_zero:
        raise Meaningless("these are the first integrals: `find integrals` finds them")
    integrals = [*first_integrals(at, degree, (), pool)]
    found = list[str]()
    for element in first_integrals(at, degree, (), pool, cofactor, integrals):
        found.append(tex(element))
        yield Finding(DarbouxPolynomial, scene, PAIR, found[-1], {"cofactor": given})
    known = "a combination of these" if found else "zero"
    known += " by polynomials in first integrals" if found and integrals else ""
    words = f"each polynomial F up to degree {degree} with F' = KF is {known}"
    if scene.constants:
        words += ", for almost all values of the constants"
    attributes: dict[str, Attribute] = {
        "cofactor": given,
        "solutions": tuple(found),
        "integrals": tuple(map(tex, integrals)) if found else (),
        "degree": degree,
    }
    yield Finding(AllDarboux, scene, words, attributes=attributes)


ONE = Number(1)
INTEGRAL = "it is constant along every motion"
PAIR = "F' = KF for F and K"


def _product(
    relation: CofactorRelation,
    known: Sequence[Darboux],
    scene: Scene,
    formula: Callable[[Element], Formula],
) -> Finding:
    """That a product is an integral: as it stands if that can be written, else by its logarithm."""
    used = [
        (exponent, factor)
        for exponent, factor in zip(relation.exponents, known, strict=True)
        if not exponent.is_zero
    ]
    bases = [formula(factor.polynomial) for _, factor in used]
    whole = [rational(exponent) for exponent, _ in used]
    powers = [int(value) for value in whole if value is not None and value.denominator == 1]
    simple = len(powers) == len(used) and relation.exponential.is_zero
    if simple and not relation.multiplier:
        both = [(n, power(base, abs(n))) for n, base in zip(powers, bases, strict=True)]
        above, below = (
            times(*(formula for n, formula in both if n * sign > 0)) for sign in (1, -1)
        )
        quotient = above if below == ONE else Quotient(above, below)
        return Finding(FirstIntegral, scene, INTEGRAL, to_latex(quotient))
    exponents = [formula(exponent) for exponent, _ in used]
    factors = [power(base, n) for base, n in zip(bases, exponents, strict=True)]
    terms: list[Formula] = [
        Product((n, formula(factor.cofactor)))
        for n, (_, factor) in zip(exponents, used, strict=True)
    ]
    if not relation.exponential.is_zero:
        exponential = formula(relation.exponential)
        factors.append(Application(r"\exp", (exponential,)))
        terms.append(Derivative(exponential, scene.time))
    if relation.multiplier:
        terms += [Partial(Derivative(Name(n), scene.time), n) for n in scene.variables]
    kind = "is a last multiplier" if relation.multiplier else "is constant along every motion"
    says = f"so ${to_latex(times(*factors))}$ {kind}"
    return Finding(Identity, scene, says, to_latex(equal(Sum(tuple(terms)), Number(0))))
