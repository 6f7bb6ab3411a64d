"""The conditions under which a statement holds: what its denominators assume not to vanish."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import cache, reduce
from operator import mul

from kowalevski_cas.algebra.ideals import vanish_on
from kowalevski_cas.algebra.present import formula_of
from kowalevski_cas.algebra.squares import sum_of_squares
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.notation import Formula, Negative, Product, Sum
from kowalevski_cas.paper.denominators import Divisor, Shape
from kowalevski_cas.paper.elaborate import Elaboration
from kowalevski_cas.problem.examine import Accepted, law
from kowalevski_cas.problem.finder import finder_of
from kowalevski_cas.problem.goals import Exists, Follows, Goal, Simple, simple
from kowalevski_cas.problem.space import Setting
from kowalevski_cas.verify.as_printed import printed_formula
from kowalevski_cas.verify.printed_functions import PrintedFunctions

Divided = tuple[Elaboration, Formula]
"""What may not vanish, and the setting in which it stands."""


def conditions_of(
    accepted: Accepted, legend: Mapping[Setting, Elaboration], printed: Sequence[Formula]
) -> list[Divided]:
    """What all that was accepted assumes to be non-zero, each factor once.

    It is named in the words of the scenes that the ``legend`` tells, and by the functions that are
    ``printed``.
    """
    divisors: dict[Elaboration, set[int]] = {}
    stated: dict[Elaboration, list[Formula]] = {}
    for goal, elements in accepted.divided:
        setting = legend.get(goal.space)
        if setting is None:  # a theorem on functions: it has none
            continue
        there = setting.finder
        for divisor in may_vanish(goal, elements):
            factors = there.image(divisor).inverse().denominator
            divisors.setdefault(setting, set()).update(factors)
        stated.setdefault(setting, []).extend(goal.formulas())
    found: dict[Formula, Elaboration] = {}
    for setting, indices in divisors.items():
        functions = PrintedFunctions(setting, printed)
        for formula in _divisor_factors(sorted(indices), functions, stated[setting]):
            found.setdefault(formula, setting)
    return [(setting, formula) for formula, setting in found.items()]


def may_vanish(goal: Simple, elements: Sequence[Element]) -> list[Element]:
    """What elements are divided by, that may vanish where what is given holds."""
    at = finder_of(goal.space)
    found = at.ring.divisors_of(elements)
    if not goal.space.powers or not isinstance(goal, Follows) or not goal.given:
        return found
    known, one = at.differences(goal.given), at.ring.one
    # where 1 is in the ideal of both, the divisor vanishes nowhere on the set (Hilbert)
    return [divisor for divisor in found if vanish_on([one], [divisor, *known]) == [False]]


def _divisor_factors(
    indices: Sequence[int], functions: PrintedFunctions, stated: Sequence[Formula]
) -> list[Formula]:
    """What may vanish of divisors of a setting, beyond what it takes for granted.

    A divisor is named as a denominator that is printed, in the scene or in what is ``stated``.
    """
    setting = functions.setting
    divisors = setting.divisors
    left = [one for index in indices if (one := divisors.left(index)).factors]
    known = {shape for divisor in left if len(divisor.factors) == 1 for shape in divisor.factors}
    found: dict[Formula, None] = {}
    below = cache(lambda: {**divisors.printed, **divisors.below(stated)})
    for divisor in left:
        landmark = divisors.landmarks.get(Shape(divisor.element))
        if named := landmark or functions.vanishing_with(divisor.element):
            found[named] = None
            continue
        if len(divisor.factors) > 1:
            divisor = divisor.without(known)
            known |= divisor.factors.keys()
        if divisor.factors:
            several = _printed_divisors(divisor, functions, below)
            found |= dict.fromkeys(several or (_positive(divisor.element, setting),))
    for pair in setting.conjugates:
        first, second = map(setting.texts.expression, pair)
        if first in found and second in found:
            # conjugates vanish together: they are one condition, and their product is real
            del found[second]
            found = {(Product((first, second)) if f == first else f): None for f in found}
    return list(found)


def _printed_divisors(
    divisor: Divisor, functions: PrintedFunctions, below: Callable[[], dict[Formula, Divisor]]
) -> tuple[Formula, ...]:
    """The printed denominators, one or several, that vanish together where the divisor does."""
    setting = functions.setting
    wanted, granted = divisor.factors.keys(), setting.divisors.granted
    if len(divisor.element.parts[0]) < 2:
        return ()
    shares = {
        f: denominator for f, denominator in below().items() if wanted & denominator.factors.keys()
    }
    for formula, (element, factors) in shares.items():
        if element.parts.keys() == {0} and factors.keys() - granted == wanted:
            return (printed_formula(functions.put_in(formula), setting),)
    elements = (element for element, _ in shares.values())
    if set[Shape]().union(*(factors for _, factors in shares.values())) - granted != wanted:
        return ()
    if reduce(mul, elements).parts.keys() != {0}:
        return ()
    return tuple(printed_formula(functions.put_in(formula), setting) for formula in shares)


def _positive(divisor: Element, setting: Elaboration) -> Formula:
    """A divisor as it is printed, without a minus before most terms."""
    words = setting.texts.vocabulary
    formula = formula_of(divisor, words)
    terms = formula.terms if isinstance(formula, Sum) else (formula,)
    negative = sum(isinstance(term, Negative) for term in terms)
    return formula_of(-divisor, words) if 2 * negative > len(terms) else formula


def divisors_on_set(
    goals: Iterable[Goal], legend: Mapping[Setting, Elaboration]
) -> tuple[Formula, ...]:
    """What the motion is divided by that vanishes on a set of which a goal about it speaks."""
    found: dict[Formula, None] = {}
    for goal in goals:
        bound = goal.bound if isinstance(goal, Exists) else ()
        for part in simple(goal):
            if part.space not in legend:
                continue
            at = finder_of(part.space)
            known = at.differences(part.given) if isinstance(part, Follows) else []
            divisors = at.ring.divisors_of(law(part, at, bound)) if known else []
            gone = zip(divisors, vanish_on(divisors, known), strict=True)
            found |= {
                _positive(divisor, legend[part.space]): None for divisor, here in gone if here
            }
    return tuple(found)


def implies(first: Element, second: Element, setting: Elaboration) -> bool:
    """Whether one element of a setting, in FLINT, vanishes only where the other one does.

    It divides the other one, or is a sum of squares of real numbers of which each does.
    """
    if first.parts.keys() != {0} or second.parts.keys() != {0}:
        return False
    if not divmod(second.parts[0], first.parts[0])[1]:
        return True
    polynomials = first.ring.polynomials
    names = {polynomials.generators[k] for k in polynomials.occurring_places(first.parts[0])}
    if any(names.intersection(pair) for pair in setting.conjugates):
        return False
    bases = [base for _, base in sum_of_squares(first.terms()[0]) or ()]
    gone = {m.index(1) for base in bases if len(base) == 1 for m in base if sum(m) == 1}
    return bool(bases) and all(any(m[k] for k in gone) for m in second.terms()[0])
