"""That differentials are independent at each point of a set."""

from __future__ import annotations

from collections.abc import Sequence

from kowalevski_cas.algebra.linear import inverse
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.notation import Formula
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.evidence import Entailment
from kowalevski_cas.problem.goals import Follows
from kowalevski_cas.search.proof_steps import ProofStep, entailment, steps_to

Matrix = list[list[Element]]

Key = tuple[int, tuple[int, ...]]
"""A monomial: the roots in it, as a mask, and exponents."""


def regular(
    goal: Follows,
    at: Evaluation,
    functions: Sequence[Formula],
    multipliers: Sequence[str],
    conditions: Sequence[Element],
) -> Entailment | None:
    """A proof that multipliers vanish one after another, and a point of the set, where they do.

    They are those of the differentials of ``functions``. It may divide by what the set itself does,
    and by few of the ``conditions``.
    """
    known = at.differences(goal.given)
    (targets,) = map(at.differences, goal.conclusions)
    sparse = _sparse([at.scalar(function) for function in functions], at)
    generators = [_replace_multiplier(element, sparse, multipliers, at) for element in known]
    found = steps_to(targets, generators, at.ring.divisors_of(known), conditions, multipliers)
    if found is None:
        return None
    back, zero = inverse(sparse), at.ring.zero
    steps = []
    for step in found[0]:
        element, *row = (
            _replace_multiplier(e, back, multipliers, at) for e in (step.element, *step.row)
        )
        steps.append(ProofStep(element, row))
    rows = [
        [
            sum((sparse[j][k] * row[n] for j, row in enumerate(found[1])), zero)
            for n in range(len(found[1][0]))
        ]
        for k in range(len(multipliers))
    ]
    return entailment(goal, steps, rows, [*known, *targets], at)


def _replace_multiplier(
    element: Element, matrix: Matrix, multipliers: Sequence[str], at: Evaluation
) -> Element:
    """An element with the k-th multiplier replaced by the sum of the j-th times entry j, k."""
    own = [at.ring.generator(name) for name in multipliers]
    values = {
        name: sum((m * row[k] for m, row in zip(own, matrix, strict=True)), at.ring.zero)
        for k, name in enumerate(multipliers)
    }
    return at.image(element, lambda name: values.get(name) or at.ring.generator(name))


def _sparse(functions: Sequence[Element], at: Evaluation) -> Matrix:
    """Combinations with numbers that share no leading terms, from which cofactors are short.

    Those that are divided by something stay as they are.
    """
    ring, size = at.ring, len(functions)
    matrix = [[ring.one if j == k else ring.zero for k in range(size)] for j in range(size)]
    rows = list(functions)
    for j in range(size):
        key = None if rows[j].denominator else _leading_minor(rows[j])
        if key is None:
            continue
        over = _coefficient(rows[j], key).inverse()
        rows[j], matrix[j] = rows[j] * over, [entry * over for entry in matrix[j]]
        for k in range(size):
            if k == j or rows[k].denominator:
                continue
            factor = _coefficient(rows[k], key)
            rows[k] = rows[k] - factor * rows[j]
            matrix[k] = [a - factor * b for a, b in zip(matrix[k], matrix[j], strict=True)]
    return matrix


def _leading_minor(element: Element) -> Key | None:
    return next(((mask, own) for mask, part in element.terms().items() for own in part), None)


def _coefficient(element: Element, key: Key) -> Element:
    mask, exponents = key
    return element.ring.number(element.terms().get(mask, {}).get(exponents, 0))
