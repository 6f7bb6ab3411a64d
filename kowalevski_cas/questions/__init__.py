"""Open questions about a scene, a module each; what is found is claimed like anything else.

A module has a docstring, and ``search(on, scene, pool, …)``, which yields one
:class:`~kowalevski_cas.verify.finding.Finding` after the other; what was found before the time is
over is kept.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from dataclasses import replace
from importlib import import_module
from types import ModuleType

from kowalevski_cas.limits import clock, tell, time_limit
from kowalevski_cas.paper.elaborate import Elaboration
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.paper.texts import Texts
from kowalevski_cas.verify.finding import Finding

QUESTIONS = {
    "integrals": "polynomial first integrals, up to a degree",
    "darboux": "polynomials F with F' = KF, up to a degree, and their K",
    "closure": "an invariant set, from a function and its derivatives",
    "parameters": "values of constants for which a polynomial divides its derivative",
    "exponents": "weights, balances, their Kowalevski exponents, and the Painlevé test",
}

MANY = 2000
"""How many monomials make a search long."""


def question(name: str) -> ModuleType:
    """The module of a question."""
    return import_module(f"{__name__}.{name}")


def nothing(name: str, **asked: object) -> str:
    """What was searched, and where one could look further, after a search that found nothing."""
    says = getattr(question(name), "nothing", None)
    return str(says(**asked)) if says else "nothing was found"


def with_constants(on: Elaborations, scene: Scene, *names: str) -> Elaboration:
    """What a scene means that has more constants."""
    words = on.texts.vocabulary
    words = replace(words, scalars=words.scalars.union(names))
    texts = Texts(words, on.texts.sources, on.texts.edits)
    return Elaborations(texts)(scene.having(constants=names))


def collect(search: Iterator[Finding], seconds: float) -> tuple[list[Finding], str]:
    """What is found in so many seconds, and why nobody looked further, if something is left."""
    from kowalevski_cas.algebra.polynomials import TooLarge

    findings: list[Finding] = []
    end = clock() + seconds
    try:
        while True:
            with time_limit(end - clock()):
                findings.append(next(search))
            tell(f"{len(findings)} found", 0, 1)
    except StopIteration:
        return findings, ""
    except TimeoutError:
        return findings, f"it took more than {seconds:g} s: give it more time"
    except TooLarge as error:
        return findings, f"it would be too large: {error}"


def forecast(scene: Scene, question: str, degree: int) -> None:
    """Say beforehand how large a question about polynomials is, if it is, and whether too large."""
    from kowalevski_cas.problem.polynomial_fields import number_of_monomials

    if not degree:
        return
    largest = import_module(f"kowalevski_cas.search.{question}").LARGEST
    width = len(scene.variables)
    if (size := number_of_monomials((1,) * width, degree)) > min(MANY, largest):
        large = f"{width} variables have {size} monomials up to degree {degree}"
        ends = "the search ends before, with what it has found"
        print(f"{large}: {ends if size > largest else 'it may take long'}", file=sys.stderr)
