"""That differentials are independent at each point of a set."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import chain

from kowalevski_cas.algebra.linear import solve
from kowalevski_cas.algebra.present import formula_in, written
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.notation import Formula, Quotient
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.evidence import Proof, Shown
from kowalevski_cas.problem.fold import divisors_of
from kowalevski_cas.problem.goals import Follows
from kowalevski_cas.problem.space import Setting
from kowalevski_cas.search.groebner import Combinations
from kowalevski_cas.search.place import PointFinder

Matrix = list[list[Element]]


def regular(
    goal: Follows,
    at: Evaluation,
    functions: Sequence[Formula],
    multipliers: Sequence[str],
    conditions: Sequence[Element],
    names: Callable[[Setting], Sequence[str]],
) -> Shown | None:
    """A proof that multipliers vanish one after another, and a point of the set, where they do.

    They are those of the differentials of ``functions``. It may divide by what the set itself does,
    and by few of the ``conditions``.
    """
    known = at.differences(goal.given)
    (targets,) = map(at.differences, goal.conclusions)
    sparse = _sparse([at.scalar(function) for function in functions], at)
    generators = [_changed(element, sparse, multipliers, at) for element in known]
    steps = _steps(targets, generators, multipliers, at.ring.divided_by(known), conditions)
    if steps is None:
        return None
    one, zero, size = at.ring.one, at.ring.zero, len(multipliers)
    columns = [solve(sparse, [one if k == j else zero for k in range(size)]) for j in range(size)]
    back = [[column[k] for column in columns] for k in range(size)]
    own = {target: weights for target, weights in zip(targets, sparse, strict=True)}
    last = [
        [*(zero for _ in known), *(own[e][k] if e in own else zero for e, _ in steps)]
        for k in range(size)
    ]
    used, proof = [*chain.from_iterable(last)], Proof(written(last))
    for element, row in reversed(steps):
        step, *entries = (_changed(e, back, multipliers, at) for e in (element, *row))
        used += entries
        proof = Proof((tuple(map(_in_turn, entries)),), written([[step]]), (proof,))
    finder = PointFinder(lambda setting: at, names)
    point = finder.point(at, [*known, *targets], [*known, *used])
    return None if point is None else Shown(proof, point)


Step = tuple[Element, list[Element]]
"""What vanishes, and the row that combines it from what is known before it."""


def _steps(
    targets: Sequence[Element],
    generators: Sequence[Element],
    multipliers: Sequence[str],
    units: Sequence[Element],
    conditions: Sequence[Element],
) -> list[Step] | None:
    """How targets vanish in turn: each is known from there on; the shortest row comes next.

    A target over conditions takes two steps, so that a row is not divided entry by entry.
    """
    left, steps = [*targets], list[Step]()
    while left:
        known = [*generators, *(element for element, _ in steps)]
        made = Combinations(left, known, multipliers, units, conditions)
        rows = [(target, row) for target in left if (row := made.row(target)) is not None]
        if not rows:
            return None
        target, row = min(rows, key=lambda one: sum(map(_length, one[1])))
        factor = _denominator(row)
        if not (factor - factor.ring.one).is_zero:
            steps.append((factor * target, [factor * entry for entry in row]))
            row = [factor.ring.zero] * len(row) + [factor.inverse()]
        steps.append((target, row))
        left.remove(target)
    return steps


def _denominator(row: Sequence[Element]) -> Element:
    """What the entries of a row are divided by together, without monomials."""
    ring, exponents = row[0].ring, dict[int, int]()
    for entry in row:
        for index, exponent in entry.denominator.items():
            if len(ring.polynomials.terms(ring.divisors[index])) > 1:
                exponents[index] = max(exponent, exponents.get(index, 0))
    product = ring.divisor_product(exponents)
    return ring.one if product is None else ring.element({0: product}, {})


def _length(element: Element) -> int:
    return sum(map(len, element.terms().values()))


def _in_turn(element: Element) -> Formula:
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


def _changed(
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
        key = None if rows[j].denominator else _leading(rows[j])
        if key is None:
            continue
        over = _coefficient(rows[j], key, at).inverse()
        rows[j], matrix[j] = rows[j] * over, [entry * over for entry in matrix[j]]
        for k in range(size):
            if k == j or rows[k].denominator:
                continue
            factor = _coefficient(rows[k], key, at)
            rows[k] = rows[k] - factor * rows[j]
            matrix[k] = [a - factor * b for a, b in zip(matrix[k], matrix[j], strict=True)]
    return matrix


Key = tuple[int, tuple[int, ...]]
"""A monomial: the roots but i, as a mask, and exponents."""


def _leading(element: Element) -> Key | None:
    unit = _unit(element)
    return next(
        ((mask & ~unit, exponents) for mask, part in element.terms().items() for exponents in part),
        None,
    )


def _coefficient(element: Element, key: Key, at: Evaluation) -> Element:
    """The coefficient of a monomial, a number in which i may stand."""
    mask, exponents = key
    unit, terms, ring = _unit(element), element.terms(), at.ring
    real = ring.number(terms.get(mask, {}).get(exponents, 0))
    if not unit:
        return real
    return real + ring.generator("i") * ring.number(terms.get(mask | unit, {}).get(exponents, 0))


def _unit(element: Element) -> int:
    """The mask of i; 0 if there is no i."""
    roots = element.ring.roots
    return 1 << roots.index("i") if "i" in roots else 0
