"""Find the Darboux polynomials of a scene of a derivation, up to a degree: F' = KF.

Neither F nor K is given. What is a combination of products of those found before is left out. With
--special, they are found for special values of the constants too.
"""

from __future__ import annotations

import argparse
from collections.abc import Iterator

from kowalevski_cas.algebra.present import formula_of
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.cli.session import natural
from kowalevski_cas.notation import Derivative, Formula, Product, Relation, to_latex
from kowalevski_cas.paper.claims import DarbouxPolynomial, FirstIntegral, Implication
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.verify.found import Finding


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The arguments of the question."""
    parser.add_argument(
        "--degree", type=natural, default=2, metavar="N", help="the highest degree (2)"
    )
    parser.add_argument(
        "--special", action="store_true", help="constants may have special values as well"
    )


def search(on: Elaborations, scene: Scene, arguments: argparse.Namespace) -> Iterator[Finding]:
    """The Darboux polynomials, the lowest degrees first."""
    from kowalevski_cas.search.darboux import darboux_polynomials

    def formula(element: Element) -> Formula:
        return formula_of(element, on.texts.vocabulary)

    def equation(left: Formula, right: Formula) -> str:
        return to_latex(Relation((left, right), ("=",)))

    for one in darboux_polynomials(on(scene).finder, arguments.degree, arguments.special):
        value, cofactor = formula(one.polynomial), formula(one.cofactor)
        if one.equations:
            given = tuple(equation(formula(a), formula(b)) for a, b in one.equations)
            where = " and ".join(f"${one}$" for one in given)
            says = f"F' = KF with $K={to_latex(cofactor)}$ where {where}"
            multiple = equation(Derivative(value, scene.time), Product((cofactor, value)))
            yield Finding(Implication, scene, says, multiple, {"given": given})
        elif one.cofactor.is_zero:
            yield Finding(
                FirstIntegral, scene, "it is constant along every motion", to_latex(value)
            )
        else:
            says = f"F' = KF with $K={to_latex(cofactor)}$"
            attributes = {"cofactor": to_latex(cofactor)}
            yield Finding(DarbouxPolynomial, scene, says, to_latex(value), attributes)
