"""Rational numbers for which an equation holds: from its values at exact points."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from fractions import Fraction
from itertools import islice, product

from flint import fmpq_mat

from kowalevski_cas.algebra.flint import to_flint, to_fraction
from kowalevski_cas.algebra.numbers import rational, square_root
from kowalevski_cas.algebra.present import fraction_formula
from kowalevski_cas.notation import Formula, Negative, Sum
from kowalevski_cas.problem.collect import collect
from kowalevski_cas.problem.goals import Exists, Follows
from kowalevski_cas.search.place import Candidate, PointFinder
from kowalevski_cas.search.real import real_points

SPARE = 3
"""At how many further points numbers have to fit before they are tried as an identity."""

Row = list[Fraction]


def solved_numbers(goal: Exists, finder: PointFinder) -> dict[str, Formula] | None:
    r"""Numbers for which the one equation of the goal, quadratic in a combination, holds.

    In each point the equation is a quadratic one for the combination :math:`\sum_k q_kb_k` of
    the numbers. Where its roots are rational, one of them is the value of the combination:
    as many points as there are numbers determine these, up to the choice of the roots.
    """
    (one,) = goal.goals
    if not isinstance(one, Follows) or one.given or len(one.conclusions) != 1:
        return None
    samples = list(islice(_samples(goal, finder), len(goal.numbers) + SPARE))
    size = len(goal.numbers)
    if len(samples) < size + SPARE:
        return None
    for roots in product(*(roots for roots, _ in samples[:size])):
        solution = _solve([basis for _, basis in samples[:size]], roots)
        if solution is None:
            return None
        if all(_combined(solution, basis) in roots for roots, basis in samples[size:]):
            return dict(zip(goal.numbers, map(fraction_formula, solution), strict=True))
    return None


def _samples(goal: Exists, finder: PointFinder) -> Iterator[tuple[list[Fraction], Row]]:
    """The roots of the equation at points where they are rational, and the basis there."""
    (one,) = goal.goals
    assert isinstance(one, Follows)
    ((sides,),) = one.conclusions
    at = finder.of(one.space)
    collected = collect(Sum((sides[0], Negative(sides[1]))), goal.bound)
    if any(len(monomial) > 2 for monomial in collected):
        return
    elements = {monomial: at.scalar(c) for monomial, c in collected.items()}
    for point in real_points(at, finder.names(one.space)):
        candidate = Candidate(at, point)

        def value(*monomial: str, candidate: Candidate = candidate) -> Fraction:
            """A coefficient there; most points need few to be seen to be of no use."""
            found = rational(candidate(elements[monomial])) if monomial in elements else Fraction(0)
            if found is None:
                raise ArithmeticError("it is irrational")
            return found

        with suppress(ArithmeticError):  # or there is a zero below
            if sample := _quadratic(value, goal.numbers):
                yield sample


def _quadratic(
    value: Callable[..., Fraction], numbers: Sequence[str]
) -> tuple[list[Fraction], Row] | None:
    """The equation as a (Σ q b)² + b (Σ q b) + c with the first b that is not zero being 1."""
    first, a = next(((n, square) for n in numbers if (square := value(n, n))), ("", Fraction(0)))
    if not a:
        return None
    b, c = value(first), value()
    root = square_root(b * b - 4 * a * c)
    if root is None:
        return None
    basis = [Fraction(1) if n == first else value(*_pair(first, n)) / (2 * a) for n in numbers]
    if any(value(name) != b * weight for name, weight in zip(numbers, basis, strict=True)):
        return None
    return [(-b - root) / (2 * a), (-b + root) / (2 * a)], basis


def _pair(a: str, b: str) -> tuple[str, ...]:
    return tuple(sorted((a, b)))


def _combined(weights: Sequence[Fraction], basis: Sequence[Fraction]) -> Fraction:
    return sum((w * b for w, b in zip(weights, basis, strict=True)), Fraction(0))


def _matrix(rows: Sequence[Sequence[Fraction]]) -> fmpq_mat:
    return fmpq_mat([[to_flint(v) for v in row] for row in rows])


def _solve(rows: Sequence[Row], right: Sequence[Fraction]) -> list[Fraction] | None:
    try:
        found = _matrix(rows).solve(_matrix([[value] for value in right]))
    except ZeroDivisionError:
        return None
    return [to_fraction(found[k, 0]) for k in range(len(rows))]


def linear_combination(rows: Sequence[Row], target: Sequence[Fraction]) -> list[Fraction] | None:
    """Weights with which the rows add up to the target, with as few rows as come first."""
    if not rows:
        return None
    columns = [list(column) for column in zip(*rows, strict=True)]
    augmented = [[*column, value] for column, value in zip(columns, target, strict=True)]
    reduced, rank = _matrix(augmented).rref()
    weights = [Fraction(0)] * len(rows)
    for k in range(rank):
        entries = [to_fraction(reduced[k, j]) for j in range(len(rows) + 1)]
        pivot = next(j for j, entry in enumerate(entries) if entry)
        if pivot == len(rows):
            return None
        weights[pivot] = entries[-1]
    return weights
