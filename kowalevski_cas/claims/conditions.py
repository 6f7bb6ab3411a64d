"""The conditions under which a formula holds: what its denominators assume not to vanish."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from functools import lru_cache

from kowalevski_cas.arithmetic.tower import Element
from kowalevski_cas.claims.formulas import show
from kowalevski_cas.notation import Formula, Product
from kowalevski_cas.proof.outcome import Condition
from kowalevski_cas.paper.scene import Locus
from kowalevski_cas.stage import Stage, scalar

Shape = frozenset[object]
"""A polynomial up to a constant factor, as a key."""


def conditions_of(elements: Sequence[Element], stage: Stage) -> tuple[Condition, ...]:
    """What the denominators of these elements assume to be non-zero, each factor once."""
    ring = stage.ring
    indices = sorted({index for element in elements for index in element.denominator})
    if not indices:
        return ()
    granted, names = _declared(stage)
    shown: dict[Formula, None] = {}
    divisors = [Element(ring, {0: ring.divisors[index]}, {}) for index in indices]
    known = {_shape(divisor) for divisor in divisors if len(divisor.terms()[0]) == 1}.union(granted)
    for divisor in divisors:
        shape = _shape(divisor)
        if shape in granted:
            continue
        if shape not in names and shape not in known:
            divisor = _without(divisor, known)
        if divisor is not ring.one:
            shown[names[shape] if shape in names else show(divisor, stage)] = None
    for pair in stage.scene.conjugates:
        first, second = map(stage.formula, pair)
        if first in shown and second in shown:
            del shown[second]
            shown = {(Product((first, second)) if f == first else f): None for f in shown}
    return tuple(Condition(formula, "the formulas divide by it") for formula in shown)


@lru_cache(maxsize=64)
def _declared(stage: Stage) -> tuple[frozenset[Shape], dict[Shape, Formula]]:
    """What a scene takes for granted not to vanish, and its names for conditions, by shapes."""
    granted = frozenset(_shape(scalar(formula, stage)) for formula in stage.granted())
    return granted, {_shape(scalar(formula, stage)): formula for formula in stage.landmarks()}


def _without(divisor: Element, known: set[Shape]) -> Element:
    """A polynomial without its factors that are known, which all are after that."""
    from kowalevski_cas.search.factors import irreducible_factors

    ring, result = divisor.ring, divisor.ring.one
    factors = irreducible_factors(divisor.terms()[0])
    new = [(f, e) for terms, e in factors if _shape(f := ring.from_terms({0: terms})) not in known]
    known.update(_shape(factor) for factor, _ in new)
    whole = all(value.denominator == 1 for value in divisor.terms()[0].values())
    if whole and len(new) == len(factors) and all(exponent == 1 for _, exponent in new):
        return divisor
    for factor, _ in new:
        result = result * factor
    return result


def _shape(element: Element) -> Shape:
    """A polynomial up to a constant factor, as a key."""
    parts = element.terms()
    lead = next((parts[m][max(parts[m])] for m in sorted(parts)), Fraction(1))
    return frozenset(
        (mask, exponents, (scaled := value / lead).numerator, scaled.denominator)
        for mask, terms in parts.items()
        for exponents, value in terms.items()
    )


def locus_of(condition: Condition, stage: Stage) -> Locus | None:
    """The declared locus where a condition is violated, if there is one."""
    for locus in stage.scene.loci:
        if stage.formula(locus.condition) == condition.expression:
            return locus
    return None
