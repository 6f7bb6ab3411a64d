"""Exact rational points on polynomial constraints."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import islice

from flint import fmpq, fmpq_mpoly

from kowalevski_cas.arithmetic.numbers import square_root

Plan = list[tuple[fmpq_mpoly, int]]
Assignment = dict[int, Fraction]

ATTEMPTS = 4000
"""How many starting values are tried before the search gives up."""


class NoPoint(LookupError):
    """No exact point was found on the constraints within the attempts allowed."""


def points(
    constraints: Sequence[fmpq_mpoly],
    variables: Sequence[int],
    avoid: Sequence[fmpq_mpoly] = (),
    fixed: Mapping[int, Fraction] | None = None,
) -> Iterator[Assignment]:
    """Rational points where the constraints vanish and the expressions to avoid do not.

    ``variables`` are indices of generators. All but one of the variables of each
    constraint get small values from a fixed sequence; the remaining one is
    solved for, where the equation is linear, or quadratic with a discriminant
    that is a square.
    """
    constraints = [c for c in constraints if not c.is_zero()]
    fixed = dict(fixed or {})
    for plan in islice(_plans(constraints, variables, fixed), 12):
        solved = {variable for _, variable in plan}
        free = [v for v in variables if v not in solved and v not in fixed]
        sequence = _small_numbers()
        for _ in range(ATTEMPTS):
            values = {**fixed, **{v: next(sequence) for v in free}}
            if _complete(plan, values) and not any(_value(a, values).is_zero() for a in avoid):
                yield values


def _plans(
    constraints: list[fmpq_mpoly], variables: Sequence[int], fixed: Mapping[int, Fraction]
) -> Iterator[Plan]:
    """Orders in which the constraints can be solved one variable at a time, linear ones first."""
    occurring = [
        {v for v in variables if v not in fixed and c.degrees()[v] > 0} for c in constraints
    ]

    def extend(chosen: tuple[tuple[int, int], ...]) -> Iterator[tuple[tuple[int, int], ...]]:
        # Built from the last to the first: a variable that is solved for later
        # must not occur in what is solved before.
        left = [k for k in range(len(constraints)) if k not in {c for c, _ in chosen}]
        if not left:
            yield chosen
            return
        later = {v for _, v in chosen}
        choices = [
            (constraints[k].degrees()[v], k, v)
            for k in left
            for v in occurring[k] - later
            if constraints[k].degrees()[v] <= 2
            and not any(v in occurring[other] for other in left if other != k)
        ]
        for _, k, v in sorted(choices):
            yield from extend(((k, v), *chosen))

    for order in extend(()):
        yield [(constraints[k], v) for k, v in order]


def _complete(plan: Plan, values: Assignment) -> bool:
    """Solve the constraints in order, entering what is found; whether all could be solved."""
    for constraint, variable in plan:
        univariate = _value(constraint, values)
        coefficients = [Fraction(0)] * 3
        for exponents, value in univariate.to_dict().items():
            if exponents[variable] != sum(exponents):
                return False
            coefficients[exponents[variable]] = Fraction(int(value.p), int(value.q))
        c, b, a = coefficients
        if a == 0:
            if b == 0:
                return False
            values[variable] = -c / b
            continue
        root = square_root(b * b - 4 * a * c)
        if root is None:
            return False
        values[variable] = (root - b) / (2 * a)
    return True


def _value(polynomial: fmpq_mpoly, values: Mapping[int, Fraction]) -> fmpq_mpoly:
    names = polynomial.context().names()
    return polynomial.subs(
        {names[k]: fmpq(value.numerator, value.denominator) for k, value in values.items()}
    )


def constant(polynomial: fmpq_mpoly, values: Mapping[int, Fraction]) -> Fraction:
    """The value of a polynomial at a point."""
    value = next(iter(_value(polynomial, values).to_dict().values()), fmpq(0))
    return Fraction(int(value.p), int(value.q))


def _small_numbers() -> Iterator[Fraction]:
    """Small non-zero rationals in a fixed irregular order, the same in every run."""
    state = 1
    while True:
        state = state * 1103515245 + 12345 & 0x7FFFFFFF
        numerator = (state >> 16) % 9 - 4
        if numerator:
            yield Fraction(numerator, 1 if (state >> 8) % 4 else 2)
