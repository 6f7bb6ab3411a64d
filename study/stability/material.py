"""What the experiments share: both sides of an equation, and exact values at points."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from math import log10 as log
from typing import Any

from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.paper.elaborate import Elaboration
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.search.place import Candidate
from study.paper import paper

Gaussian = tuple[Fraction, Fraction]


def sides(id: str, at: Evaluation) -> tuple[Any, Any]:
    """Both sides of the corrected equation of a claim of the first paper, read on any scene."""
    printed, on = paper().claims[id].printed, at.setting
    assert printed is not None and isinstance(on, Elaboration)
    left, right = (at.scalar(on.plain(m)) for m in on.texts.relation(printed).members[:2])
    return left, right


def exact_value(at: Evaluation, element: Element, point: Mapping[str, Gaussian]) -> Gaussian:
    """The exact value of an element at an exact point; raises ``ValueError`` outside Q(i)."""
    number = Candidate(at, point)(element)
    parts = number.terms()
    if number.denominator or parts.keys() - {0, 1}:
        raise ValueError("the number is not a Gaussian rational")
    real, imaginary = (sum(parts.get(mask, {}).values(), Fraction(0)) for mask in (0, 1))
    return real, imaginary


def as_complex(value: Gaussian) -> complex:
    """A Gaussian rational, rounded once."""
    return complex(float(value[0]), float(value[1]))


def log10(value: Any) -> float:
    """The decimal logarithm of a positive number; of a fraction of any size."""
    if isinstance(value, Fraction):
        return log(value.numerator) - log(value.denominator)
    return log(value)
