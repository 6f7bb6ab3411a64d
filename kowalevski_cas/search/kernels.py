"""Whether all polynomials are known that a field multiplies by a factor, or which one is not."""

from __future__ import annotations

from collections.abc import Iterator

from kowalevski_cas.algebra.kernels import kernel
from kowalevski_cas.algebra.present import formula_in
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.evidence import At, Further
from kowalevski_cas.problem.goals import Kernel
from kowalevski_cas.problem.kernel import LARGEST, check_complete, check_further
from kowalevski_cas.problem.place import Misplaced, Place
from kowalevski_cas.problem.polynomial_fields import (
    PolynomialField,
    monomials,
    number_of_monomials,
)
from kowalevski_cas.search.place import Candidate, PointFinder

POINTS = 3
"""At how many points of the constants it is tried that nothing is missing."""

CONSTANTS = 2
"""The largest degree in the constants of a missing polynomial that is looked for."""


def complete(goal: Kernel, finder: PointFinder) -> At | None:
    """A point of the constants at which nothing is missing."""
    at, names = finder.of(goal.space), finder.names(goal.space)
    found: list[At] = []
    tried = 0

    def good(candidate: Candidate) -> bool:
        nonlocal tried
        tried += 1
        point = candidate.point(names)
        try:
            check_complete(goal, at, Place(at, point))
        except Misplaced:
            return not at.setting.constants or tried == POINTS
        found.append(At(point))
        return True

    finder.point(at, [], _divided(goal, at), good, most=0)
    return next(iter(found), None)


def further(goal: Kernel, finder: PointFinder) -> At | Further | None:
    """A point where what is listed is no solution, or a polynomial that is missing."""
    at, divided = finder.of(goal.space), _divided(goal, finder.of(goal.space))
    rest = next((one for one in _rests(goal, at) if not one.is_zero), None)
    if rest is not None:
        there = finder.point(at, [], [*divided, rest], lambda c: not c(rest).is_zero)
        return None if there is None else At(there)
    point = finder.point(at, [], divided, most=0)
    if point is None:
        return None
    for element in _solutions(goal, at):
        try:
            check_further(goal, formula_in(element), at, Place(at, point))
        except Misplaced:
            continue
        return Further(formula_in(element), point)
    return None


def _divided(goal: Kernel, at: Evaluation) -> list[Element]:
    return [*at.rates.values(), at.scalar(goal.factor)]


def _rests(goal: Kernel, at: Evaluation) -> Iterator[Element]:
    """What vanishes if all that is listed are solutions."""
    for formula in goal.integrals:
        yield at.derivative(at.scalar(formula))
    for formula in goal.solutions:
        element = at.scalar(formula)
        yield at.derivative(element) - at.scalar(goal.factor) * element


def _solutions(goal: Kernel, at: Evaluation) -> Iterator[Element]:
    """The solutions with coefficients that are polynomials in the constants."""
    field = PolynomialField(at, at.scalar(goal.factor))
    others = (1,) * (len(field.names) - field.size)
    own = [e for w in range(goal.degree + 1) for e in monomials(goal.weights, w)]
    for degree in range(CONSTANTS + 1 if others else 1):
        if number_of_monomials(goal.weights, goal.degree) > LARGEST:
            return
        factors = [e for w in range(degree + 1) for e in monomials(others, w)]
        group = [(*a, *b) for a in own for b in factors]
        for vector in kernel([field.derivative(exponents) for exponents in group]):
            yield field.element({e: v for e, v in zip(group, vector, strict=True) if v})
