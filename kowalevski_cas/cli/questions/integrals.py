"""Find the polynomial first integrals of a scene of a derivation, up to a degree.

What is a polynomial in those found before is left out.
"""

from __future__ import annotations

import argparse
from collections.abc import Iterator

from kowalevski_cas.algebra.present import formula_of
from kowalevski_cas.cli.session import natural
from kowalevski_cas.notation import to_latex
from kowalevski_cas.paper.claims import FirstIntegral
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.verify.found import Finding


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The arguments of the question."""
    parser.add_argument(
        "--degree", type=natural, default=2, metavar="N", help="the highest degree (2)"
    )
    parser.add_argument(
        "--constants",
        type=natural,
        default=0,
        metavar="N",
        help="the highest degree of coefficients in the constants of the scene (0)",
    )


def search(
    on: Elaborations, scene: Scene, arguments: argparse.Namespace
) -> Iterator[Finding | None]:
    """The integrals, the lowest degrees first."""
    from kowalevski_cas.search.integrals import first_integrals

    words = on.texts.vocabulary
    for element in first_integrals(
        on(scene).finder, arguments.degree, constants=arguments.constants
    ):
        tex = to_latex(formula_of(element, words))
        yield Finding(FirstIntegral, scene, "it is constant along every motion", tex)
