"""What the experiments share: the paper as corrected, its claims, exact values at points."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from functools import cache
from typing import Any

from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.claims import Claim
from kowalevski_cas.claims.bench import Bench
from kowalevski_cas.claims.points import AtPoint
from kowalevski_cas.library import find, load
from kowalevski_cas.notation import Relation
from kowalevski_cas.paper.derivation import Derivation
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.paper.texts import Texts
from kowalevski_cas.proof.evidence import load_evidence
from kowalevski_cas.proof.verify import Session
from kowalevski_cas.stage import Stage, scalar

PAPER = "kharlamov2002"

Gaussian = tuple[Fraction, Fraction]


@cache
def paper() -> tuple[Derivation, Texts]:
    """The derivation, and its texts with the misprints corrected, as FLINT proves them."""
    derivation = load(PAPER)
    session = Session(derivation, ("flint",), False, load_evidence(find(PAPER)))
    session.run()
    return derivation, session.texts


def claim(id: str) -> Claim:
    """The claim with this id."""
    return next(claim for claim in paper()[0].claims if claim.id == id)


def bench(arithmetic: str) -> Bench:
    """A bench for the corrected texts."""
    return Bench(arithmetic, paper()[1])


def sides(one: Claim, stage: Stage) -> tuple[Any, Any]:
    """Both sides of the equation that a claim is about, as corrected."""
    assert one.printed is not None
    formula = paper()[1].formula(one.printed)
    assert isinstance(formula, Relation)
    left, right = (scalar(member, stage) for member in formula.members[:2])
    return left, right


def stages(scene: Scene) -> tuple[Stage, Stage]:
    """A scene in exact polynomials, and in programs."""
    points = bench("modular")
    return points.finder.stage(scene), points.stage(scene)


def exact_value(stage: Stage, element: Element, point: Mapping[str, Gaussian]) -> Gaussian:
    """The exact value of an element at an exact point, by FLINT."""
    return gaussian(AtPoint(stage, dict(point))(element))


def gaussian(number: Element) -> Gaussian:
    """A number of Q(i) as its real and imaginary parts; raises ``ValueError`` for others."""
    inverse = number.ring.one
    for index, exponent in number.denominator.items():
        divisor = Element(number.ring, {0: number.ring.divisors[index]}, {})
        inverse = inverse * divisor.inverse() ** exponent
    parts = number.terms()
    if parts.keys() - {0, 1} or inverse is not number.ring.one:
        raise ValueError("the number is not a Gaussian rational")
    real, imaginary = (sum(parts.get(mask, {}).values(), Fraction(0)) for mask in (0, 1))
    return real, imaginary


def as_complex(value: Gaussian) -> complex:
    """A Gaussian rational, rounded once."""
    return complex(float(value[0]), float(value[1]))


def log10(value: Any) -> float:
    """The decimal logarithm of a positive number; of a fraction of any size."""
    from math import log10

    if isinstance(value, Fraction):
        return log10(value.numerator) - log10(value.denominator)
    return log10(value)
