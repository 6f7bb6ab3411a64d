"""How many real solutions there are: by the roots of an eliminant, and by listing some."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import combinations

from kowalevski_cas.algebra.factors import exact_quotient
from kowalevski_cas.algebra.hermite import hermite_minors
from kowalevski_cas.algebra.numbers import rational
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.notation import Formula, Name
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.evidence import Factor, Roots, Row, Solutions
from kowalevski_cas.problem.goals import Count
from kowalevski_cas.problem.place import Misplaced, PointEvaluation
from kowalevski_cas.problem.space import Space
from kowalevski_cas.problem.trees import LARGEST_EXPONENT


def check_roots(goal: Count, found: Roots, at: Evaluation) -> tuple[list[Element], list[Element]]:
    r"""Check that the solutions are the roots of the eliminant, all real and distinct.

    * With the form s of the unknowns, e(s) = 0 and d x = n(s) follow from the equations: every
      solution comes from a root of e.
    * The equations and s, with n/d for x, are multiples of e: every root gives a solution where
      no d vanishes, and different roots different ones.
    * The minors of Hermite are products of factors that are sums of squares where there is a
      solution: all roots are real and distinct where no factor vanishes.

    Returns elements that have the factors and the denominators below them, and those that are
    left without factors that something granted implies; raises :class:`Misplaced` if a check fails.
    """
    if found.root in (*goal.space.variables, *goal.space.constants, *goal.space.roots):
        raise Misplaced(f"{found.root} is no new name")
    if {name for name, _, _ in found.solved} != set(goal.names):
        raise Misplaced("a variable is not solved for")
    known = at.differences(goal.equations)
    inner = Evaluation(Space((), (*at.setting.constants, found.root)), at.polynomials)
    used = [*_roots_of_solutions(found, at, known), *_solutions_of_roots(found, inner, at, known)]
    factors = []
    for entry in found.factors:
        factor, row = _factor(entry, at, known)
        factors.append(factor)
        used += row
    _minors(found, inner, [inner.scalar(entry.factor) for entry in found.factors])
    below = [at.scalar(denominator) for _, _, denominator in found.solved]
    implied = []
    for factor, entry in zip(factors, found.factors, strict=True):
        if entry.granted is not None:
            used += _check_granted(entry, *entry.granted, at, known)
            implied.append(factor)
    left = [_without(element, implied) for element in (*factors, *below)]
    return [*used, *_inverses([*factors, *below])], [*used, *_inverses(left)]


def _inverses(elements: Sequence[Element]) -> list[Element]:
    return [element.inverse() for element in elements]


def check_free(goal: Count, at: Evaluation, elements: Sequence[Element]) -> None:
    """Refuse divisors, and what is granted, in which something stands that is counted.

    Solutions where one of these vanishes would not be counted.
    """
    polynomials = at.ring.polynomials
    counted = {polynomials.generators.index(name) for name in goal.names}
    granted = _inverses(at.granted)
    for divisor in at.ring.divisors_of([*elements, *granted]):
        if not counted.isdisjoint(polynomials.occurring_places(divisor.parts[0])):
            raise Misplaced("a condition is about what is counted")


def _without(element: Element, factors: list[Element]) -> Element:
    """A polynomial without these factors, as far as it is a product of them and numbers."""
    for factor in factors:
        while rational(element) is None:
            quotient = exact_quotient(element.terms()[0], factor.terms()[0])
            if quotient is None:
                break
            element = element.ring.from_terms({0: quotient})
    return element


def _check_granted(
    entry: Factor, place: int, row: Row, at: Evaluation, known: list[Element]
) -> list[Element]:
    """Check that a factor does not vanish, for something granted would vanish with it."""
    rest = at.scalar(at.setting.nonzero[place])
    bases = [at.scalar(base) for _, base in entry.squares]
    cofactors = [at.scalar(cofactor) for cofactor in row]
    for cofactor, element in zip(cofactors, [*bases, *known], strict=True):
        rest = rest - cofactor * element
    if not rest.is_zero:
        raise Misplaced("what is granted is not shown to vanish with a factor")
    return cofactors


def eliminant_value(found: Roots, at: Evaluation) -> Element:
    """The value of the eliminant."""
    root = at.scalar(Name(found.root))
    total = root ** len(found.eliminant)
    for power, coefficient in enumerate(found.eliminant):
        total = total + at.scalar(coefficient) * root**power
    return total


def _roots_of_solutions(found: Roots, at: Evaluation, known: list[Element]) -> list[Element]:
    """Check that solutions are roots; what stands in the evidence is returned."""
    bound = at.binding({found.root: at.scalar(found.form)})
    used = [at.scalar(found.form), *map(at.scalar, found.eliminant)]
    goals = [eliminant_value(found, bound)]
    for name, above, below in found.solved:
        goals.append(bound.scalar(below) * bound.scalar(Name(name)) - bound.scalar(above))
    for goal, row in zip(goals, found.rows, strict=True):
        entries = [bound.scalar(entry) for entry in row]
        for entry, element in zip(entries, known, strict=True):
            goal = goal - entry * element
        if not goal.is_zero:
            raise Misplaced("a solution is not shown to be a root")
        used += entries
    return used


def remainders(
    found: Roots, inner: Evaluation, at: Evaluation, known: Sequence[Element]
) -> tuple[dict[str, Element], list[Element]]:
    """The unknowns through the root, and what is left of the equations and of the form by them."""
    solved = {n: inner.scalar(a) / inner.scalar(b) for n, a, b in found.solved}

    def value(name: str) -> Element:
        return solved[name] if name in solved else inner.scalar(Name(name))

    form = inner.image(at.scalar(found.form), value) - inner.scalar(Name(found.root))
    return solved, [*(inner.image(element, value) for element in known), form]


def _solutions_of_roots(
    found: Roots, inner: Evaluation, at: Evaluation, known: list[Element]
) -> Iterator[Element]:
    """Check that roots are solutions; one over what the evidence divides by is yielded."""
    solved, rests = remainders(found, inner, at, known)
    equation = eliminant_value(found, inner)
    quotients = [inner.scalar(quotient) for quotient in found.quotients]
    for rest, quotient in zip(rests, quotients, strict=True):
        if not (rest - quotient * equation).is_zero:
            raise Misplaced("a root is not shown to give a solution")
    indices = {k for e in (*solved.values(), *quotients, equation) for k in e.denominator}
    for index in indices:
        yield at.image(Element(inner.ring, {0: inner.ring.divisors[index]}, {})).inverse()


def _factor(entry: Factor, at: Evaluation, known: list[Element]) -> tuple[Element, list[Element]]:
    """A factor, which has to be a sum of squares modulo the equations, and the cofactors."""
    factor = at.scalar(entry.factor)
    rest = factor
    for number, base in entry.squares:
        rest = rest - square(number, base, at)
    row = [at.scalar(cofactor) for cofactor in entry.row]
    for cofactor, element in zip(row, known, strict=bool(row)):
        rest = rest - cofactor * element
    if not rest.is_zero:
        raise Misplaced("a factor is not shown to be a sum of squares")
    return factor, row


def square(number: Formula, base: Formula, at: Evaluation) -> Element:
    """A square with a positive rational factor; raises :class:`Misplaced` if it may be negative."""
    factor, value = at.scalar(number), at.scalar(base)
    if (rational(factor) or Fraction(0)) <= 0:
        raise Misplaced("a square has no positive factor")
    if not (at.scalar(base, True) - value).is_zero:
        raise Misplaced("a square is one of what is not real")
    return factor * value**2


def _minors(found: Roots, inner: Evaluation, factors: list[Element]) -> None:
    coefficients = [inner.scalar(coefficient) for coefficient in found.eliminant]
    minors = hermite_minors(coefficients)
    for minor, (number, powers) in zip(minors, found.minors, strict=True):
        if any(power > LARGEST_EXPONENT for power in powers):
            raise Misplaced("a power of a factor is too large")
        value = inner.scalar(number)
        if (rational(value) or Fraction(0)) <= 0:
            raise Misplaced("a minor is not shown to be positive")
        for factor, power in zip(factors, powers, strict=True):
            value = value * factor**power
        if not (minor - value).is_zero:
            raise Misplaced("a minor is another one")


def check_solutions(goal: Count, found: Solutions, at: Evaluation) -> list[PointEvaluation]:
    """Check that more points than there should be are solutions for the same constants."""
    places = [PointEvaluation(at, point) for point in found.points]
    known = at.differences(goal.equations)
    if len(places) <= goal.number or not all(place.vanish(known) for place in places):
        raise Misplaced("these are not more solutions")
    first = found.points[0].values
    for point in found.points:
        if {n: v for n, v in point.values.items() if n not in goal.names} != {
            n: v for n, v in first.items() if n not in goal.names
        }:
            raise Misplaced("the constants are not the same")
    for one, other in combinations(places, 2):
        if all(_same(name, one, other) for name in goal.names):
            raise Misplaced("a solution is listed twice")
    return places


def _same(name: str, one: PointEvaluation, other: PointEvaluation) -> bool:
    a, b = (place.numbers.scalar(_value(place, name)) for place in (one, other))
    return str(a.terms()) == str(b.terms())


def _value(place: PointEvaluation, name: str) -> Formula:
    return place.point.values[name]
