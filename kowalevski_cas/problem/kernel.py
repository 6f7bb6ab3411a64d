"""Whether all polynomials are known that a vector field multiplies by a factor.

The derivatives of all monomials are columns of a matrix. Its rank at one point of the constants,
modulo a prime, is at most the true one for almost all of them, and so is that of what is known. If
the two add up to the number of monomials, nothing is missing. Degrees are those for almost all
constants: at special ones, and modulo the prime, they fall.
"""

from __future__ import annotations

from collections.abc import Sequence

from kowalevski_cas.algebra.elimination import rank
from kowalevski_cas.algebra.kernels import residue
from kowalevski_cas.algebra.numbers import rational
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.notation import Formula, Name
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.goals import Kernel
from kowalevski_cas.problem.place import Misplaced, PointEvaluation
from kowalevski_cas.problem.polynomial_fields import PolynomialField, number_of_monomials, weight_of
from kowalevski_cas.problem.residues import ResidueField, Residues, Weighted, dimension, products

DEGREE = 1_000
"""The largest degree that is looked at, of the checker as well."""

LARGEST = 100_000
"""The largest number of monomials that anybody looks at."""


class KernelAtPoint:
    """The polynomials of a goal up to its degree, modulo a prime, for residues of the constants.

    Raises :class:`Misplaced` if there are too many, or if a value has no residue.
    """

    def __init__(self, goal: Kernel, at: Evaluation, values: Sequence[int | None]) -> None:
        self.goal, self.at = goal, at
        if len(goal.weights) != len(at.setting.variables) or min(goal.weights, default=0) < 1:
            raise Misplaced("there is not a positive weight for each variable")
        if not 0 <= goal.degree <= DEGREE:
            raise Misplaced(f"a degree is at most {DEGREE}")
        if (size := number_of_monomials(goal.weights, goal.degree)) > LARGEST:
            raise Misplaced(f"{size} monomials are too many")
        self.factor = at.scalar(goal.factor)
        self.field = PolynomialField(at, self.factor)
        self.residues = ResidueField(self.field.rates, self.field.factor, values)

    def dimension(self) -> int:
        """The dimension of the space of all solutions."""
        return dimension(self.residues, self.goal.weights, self.goal.degree)

    def known(self) -> list[Residues]:
        """The products that span the kernel; raises :class:`Misplaced` if one is no solution."""
        integrals = [self.solution(f, self.at.ring.zero) for f in self.goal.integrals]
        integrals = [integral for integral in integrals if integral[0] > 0]
        solutions = [self.solution(f, self.factor) for f in self.goal.solutions]
        return [product for f in solutions for product in products(f, integrals, self.goal.degree)]

    def solution(self, formula: Formula, factor: Element) -> Weighted:
        """A polynomial f with D f = factor f: its degree, and what it is at the point."""
        element = self.at.scalar(formula)
        if not (self.at.derivative(element) - factor * element).is_zero:
            raise Misplaced("what is said to be known is no solution")
        terms = self.field.polynomial(element)
        return weight_of(terms, self.goal.weights), self.residues.residues(terms)


def _values(at: Evaluation, place: PointEvaluation) -> tuple[int | None, ...]:
    """The residues of the constants at a point, of those that stand there and are rational."""
    names = at.setting.constants
    given = [
        rational(place(at.scalar(Name(n)))) if n in place.point.values else None for n in names
    ]
    return tuple(None if value is None else residue(value) for value in given)


def check_complete(goal: Kernel, at: Evaluation, place: PointEvaluation) -> None:
    """Check that nothing is missing; raises :class:`Misplaced`."""
    ansatz = KernelAtPoint(goal, at, _values(at, place))
    if ansatz.dimension() > rank(ansatz.known()):
        raise Misplaced("there may be more polynomials")


def check_further(goal: Kernel, formula: Formula, at: Evaluation, place: PointEvaluation) -> None:
    """Check that a polynomial belongs to the kernel and is independent of what is known there."""
    ansatz = KernelAtPoint(goal, at, _values(at, place))
    degree, further = ansatz.solution(formula, ansatz.factor)
    if degree > goal.degree:
        raise Misplaced("its degree is too large")
    vectors = [*ansatz.known(), further]
    if rank(vectors) != len(vectors):
        raise Misplaced("it may depend on what is known")


def check_no_solution(goal: Kernel, at: Evaluation, place: PointEvaluation) -> None:
    """Check that something which is said to be known is no solution at the point."""
    factor = at.scalar(goal.factor)
    both = [(f, factor) for f in goal.solutions] + [(f, at.ring.zero) for f in goal.integrals]
    for formula, multiple in both:
        element = at.scalar(formula)
        if not place(at.derivative(element) - multiple * element).is_zero:
            return
    raise Misplaced("all that is said to be known are solutions there")
