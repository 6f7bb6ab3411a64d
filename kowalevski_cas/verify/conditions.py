"""The conditions under which a statement holds: what its denominators assume not to vanish."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import cache

from kowalevski_cas.algebra.factors import divided, irreducible_factors
from kowalevski_cas.algebra.present import formula_of
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.notation import Formula, Negative, Product, Sum
from kowalevski_cas.paper.denominators import (
    Denominators,
    Shape,
    denominators,
    factors_of,
    shape_of,
)
from kowalevski_cas.paper.elaborate import Elaboration
from kowalevski_cas.problem.examine import Accepted
from kowalevski_cas.problem.goals import Follows, Simple
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.search.groebner import vanishes_on
from kowalevski_cas.search.squares import sum_of_squares
from kowalevski_cas.verify.shown import written

Divided = tuple[Elaboration, Formula]
"""What may not vanish, and the setting in which it stands."""


def conditions_of(accepted: Accepted) -> list[Divided]:
    """What all that was accepted assumes to be non-zero, each factor once."""
    settings: dict[Elaboration, list[Element]] = {}
    stated: dict[Elaboration, list[Formula]] = {}
    for goal, elements in accepted.divided:
        assert isinstance(goal.space, Elaboration)
        kept = settings.setdefault(goal.space, [])
        kept += _not_implied(goal, elements, goal.space)
        stated.setdefault(goal.space, []).extend(goal.formulas())
    found: dict[Formula, Elaboration] = {}
    for setting, elements in settings.items():
        for formula in _divisors(elements, setting, stated[setting]):
            found.setdefault(formula, setting)
    return [(setting, formula) for formula, setting in found.items()]


def _not_implied(goal: Simple, elements: Sequence[Element], setting: Elaboration) -> list[Element]:
    """One over each divisor that may vanish where what is given holds."""
    at = setting.finder
    found = [one.inverse() for one in at.ring.divided_by(elements)]
    if not setting.powers or not isinstance(goal, Follows) or not goal.given:
        return found
    known, one = at.differences(goal.given), at.ring.one
    return [inverse for inverse in found if not vanishes_on(one, [inverse.inverse(), *known])]


def _divisors(
    elements: Sequence[Element], setting: Elaboration, stated: Sequence[Formula]
) -> list[Formula]:
    """What elements of a setting, in FLINT, are divided by, beyond what it takes for granted.

    A divisor is named as a denominator that is printed, in the scene or in what is ``stated``.
    """
    ring = setting.finder.ring
    divisors = ring.divided_by(elements)
    if not divisors:
        return []
    granted = {shape_of(one) for one in _granted(setting)}
    landmarks = [setting.texts.expression(locus.condition) for locus in setting.scene.loci]
    names = {shape_of(setting.finder.scalar(setting.plain(f))): f for f in landmarks}
    found: dict[Formula, None] = {}
    known = {shape_of(divisor) for divisor in divisors if len(divisor.terms()[0]) == 1} | granted
    below = cache(lambda: {**setting.denominators, **denominators(setting, stated)})
    for divisor in divisors:
        shape = shape_of(divisor)
        if shape in granted:
            continue
        if shape not in names and shape not in known:
            divisor = _without(divisor, known)
        printed = () if shape in names else _printed(divisor, granted, setting, below)
        if printed:
            found |= dict.fromkeys(printed)
        elif divisor is not ring.one:
            found[names[shape] if shape in names else _positive(divisor, setting)] = None
    for pair in setting.conjugates:
        first, second = map(setting.texts.expression, pair)
        if first in found and second in found:
            del found[second]
            found = {(Product((first, second)) if f == first else f): None for f in found}
    return list(found)


def _printed(
    divisor: Element, granted: set[Shape], setting: Elaboration, below: Callable[[], Denominators]
) -> tuple[Formula, ...]:
    """The printed denominators, one or several, that vanish together where the divisor does."""
    if len(divisor.terms()[0]) < 2:
        return ()
    wanted, product = factors_of(divisor) - granted, divisor.ring.one
    shares = {f: element for f, (element, factors) in below().items() if wanted & factors}
    for formula, element in shares.items():
        product = product * element
        if set(element.terms()) == {0} and factors_of(element) - granted == wanted:
            return (written(formula, setting),)
    together = set(product.terms()) == {0} and factors_of(product) - granted == wanted
    return tuple(written(formula, setting) for formula in shares) if together else ()


def _positive(divisor: Element, setting: Elaboration) -> Formula:
    """A divisor as it is printed, without a minus before most terms."""
    words = setting.texts.vocabulary
    formula = formula_of(divisor, words)
    terms = formula.terms if isinstance(formula, Sum) else (formula,)
    negative = sum(isinstance(term, Negative) for term in terms)
    return formula_of(-divisor, words) if 2 * negative > len(terms) else formula


def _granted(setting: Elaboration) -> Iterator[Element]:
    """What a setting takes for granted not to vanish, and what one over it is divided by."""
    for formula in setting.nonzero:
        element = setting.finder.scalar(formula)
        yield element
        yield from setting.finder.ring.divided_by([element.inverse()])


def _without(divisor: Element, known: set[Shape]) -> Element:
    """A polynomial without its factors that are known, which all are after that."""
    ring, result = divisor.ring, divisor.ring.one
    factors = irreducible_factors(divisor.terms()[0])
    new = [
        (f, e) for terms, e in factors if shape_of(f := ring.from_terms({0: terms})) not in known
    ]
    known.update(shape_of(factor) for factor, _ in new)
    whole = all(value.denominator == 1 for value in divisor.terms()[0].values())
    if whole and len(new) == len(factors) and all(exponent == 1 for _, exponent in new):
        return divisor
    for factor, _ in new:
        result = result * factor
    return result


def same(formula: Formula, other: Formula, setting: Elaboration) -> bool:
    """Whether two conditions are the same on a setting, up to a number."""
    both = _values(formula, other, setting)
    return both is not None and shape_of(both[0]) == shape_of(both[1])


def implies(formula: Formula, other: Formula, setting: Elaboration) -> bool:
    """Whether one expression vanishes only where the other one does.

    It divides the other one, or is a sum of squares of real numbers of which each does.
    """
    both = _values(formula, other, setting)
    if both is None or any(element.parts.keys() != {0} for element in both):
        return False
    first, second = both
    if divided(second.terms()[0], first.terms()[0]) is not None:
        return True
    polynomials = first.ring.polynomials
    names = {polynomials.generators[k] for k in polynomials.occurring(first.parts[0])}
    if any(names.intersection(pair) for pair in setting.conjugates):
        return False
    bases = [base for _, base in sum_of_squares(first.terms()[0]) or ()]
    gone = {m.index(1) for base in bases if len(base) == 1 for m in base if sum(m) == 1}
    return bool(bases) and all(any(m[k] for k in gone) for m in second.terms()[0])


def _values(formula: Formula, other: Formula, setting: Elaboration) -> list[Element] | None:
    """What two formulas are on a setting; ``None`` if one of them means nothing there."""
    try:
        return [setting.finder.scalar(setting.plain(one)) for one in (formula, other)]
    except Meaningless:
        return None
