"""Proofs in steps: what is shown to vanish is known from there on, so that rows stay short."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from kowalevski_cas.algebra.present import formula_in, formula_rows
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.notation import Formula, Quotient
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.evidence import Entailment, Proof
from kowalevski_cas.problem.examine import law
from kowalevski_cas.problem.fold import divisors_of
from kowalevski_cas.problem.goals import Follows
from kowalevski_cas.search.combinations import Combinations
from kowalevski_cas.search.follows import LARGEST_POWER
from kowalevski_cas.search.place import PointFinder


class ProofStep(NamedTuple):
    """What vanishes: the row combines a power of it from what is known before it."""

    element: Element
    row: list[Element]
    power: int = 1


def steps_to(
    targets: Sequence[Element],
    generators: Sequence[Element],
    units: Sequence[Element],
    conditions: Sequence[Element],
    unknowns: Sequence[str] = (),
) -> tuple[list[ProofStep], list[list[Element]]] | None:
    """Steps after which all targets are combined, and the rows for these.

    Next comes what divides by no condition, and has the shortest row. A target that is longer than
    what is given is no step, for it would make no other row shorter, and no power of it is taken.
    Where there are ``unknowns``, all is linear in them.
    """
    left, steps, rows = [*targets], list[ProofStep](), dict[Element, list[Element]]()
    longest, ring = max(map(_length, generators)), generators[0].ring
    short = {target for target in targets if _length(target) <= longest}
    made = None
    while left:
        known = [*generators, *(step.element for step in steps)]
        made = made or Combinations(left, known, unknowns, units, conditions)
        tried = (
            _combination_row(target, made, target in short and not unknowns) for target in left
        )
        found = [step for step in tried if step is not None]
        if not found:
            return None
        step = min(found, key=_effort)
        left.remove(step.element)
        rows[step.element] = step.row
        if step.element in short:
            made, more = None, _steps_without_division(step)
            steps += more
            rows[step.element] = [*(ring.zero for _ in (*known, *more[1:])), ring.one]
    size = len(generators) + len(steps)
    return steps, [(rows[target] + [ring.zero] * size)[:size] for target in targets]


def _combination_row(target: Element, made: Combinations, powers: bool) -> ProofStep | None:
    """The row of a target, or if there is none and powers are wanted, of the least one."""
    rows = (
        (made.row(target**power), power) for power in range(1, (LARGEST_POWER if powers else 1) + 1)
    )
    return next((ProofStep(target, row, power) for row, power in rows if row is not None), None)


def _effort(step: ProofStep) -> tuple[bool, int]:
    return _denominator(step.row) is not None, sum(map(_length, step.row))


def _length(element: Element) -> int:
    return sum(map(len, element.terms().values()))


def _steps_without_division(step: ProofStep) -> list[ProofStep]:
    """A step; or two, if that is shorter than to divide each entry of the row."""
    element, row, power = step
    factor = _denominator(row)
    if factor is None:
        return [step]
    first = ProofStep(factor * element**power, [factor * entry for entry in row])
    if _length(first.element) > _length(factor) * sum(not entry.is_zero for entry in row):
        return [step]
    return [first, ProofStep(element, [*(factor.ring.zero for _ in row), factor.inverse()], power)]


def _denominator(row: Sequence[Element]) -> Element | None:
    """What the entries of a row are divided by together, without monomials."""
    ring, exponents = row[0].ring, dict[int, int]()
    for entry in row:
        for index, exponent in entry.denominator.items():
            if len(ring.polynomials.terms(ring.divisors[index])) > 1:
                exponents[index] = max(exponent, exponents.get(index, 0))
    product = ring.divisor_product(exponents)
    return None if product is None else ring.element({0: product}, {})


def entailment(
    goal: Follows,
    steps: Sequence[ProofStep],
    rows: Sequence[Sequence[Element]],
    zero: Sequence[Element],
    at: Evaluation,
) -> Entailment | None:
    """The proof of some steps and the last rows, and a point where ``zero`` vanishes."""
    divided = [entry for row in (*rows, *(step.row for step in steps)) for entry in row]
    finder = PointFinder(lambda setting: at)
    point = finder.point(at, zero, [*law(goal, at), *zero, *divided])
    proof = Proof(tuple(tuple(map(_quotient, row)) for row in rows))
    for element, row, power in reversed(steps):
        proof = Proof((tuple(map(_quotient, row)),), formula_rows([[element]]), (proof,), power)
    return None if point is None else Entailment(proof, point)


def _quotient(element: Element) -> Formula:
    """The formula of an element that is divided by one factor after another.

    Of a product of known divisors the checker knows each, but not each product of them.
    """
    formula = formula_in(element)
    if isinstance(formula, Quotient):
        divisors = [f for f, exponent in divisors_of(formula.denominator) for _ in range(exponent)]
        formula = formula.numerator
        for divisor in divisors:
            formula = Quotient(formula, divisor)
    return formula


def in_turn(goal: Follows, at: Evaluation, conditions: Sequence[Element]) -> Entailment | None:
    """A proof that equations follow one after another, away from few of the conditions.

    The point is one where all of them hold.
    """
    known = at.differences(goal.given)
    (targets,) = map(at.differences, goal.conclusions)
    found = steps_to(targets, known, at.ring.divisors_of(known), conditions)
    return found and entailment(goal, *found, [*known, *targets], at)
