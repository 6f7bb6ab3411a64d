"""What exists: expressions from equations that are linear in them, numbers from points."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from itertools import islice

from kowalevski_cas.algebra.linear import Singular, solve
from kowalevski_cas.algebra.numbers import rational
from kowalevski_cas.algebra.present import formula_in, fraction_formula
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.notation import Formula, Number
from kowalevski_cas.problem.collect import Collected, collect_sides
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.evidence import Evidence, Found, Point, Regardless
from kowalevski_cas.problem.examine import law
from kowalevski_cas.problem.goals import Exists, Fails, Follows, Simple
from kowalevski_cas.problem.place import Misplaced
from kowalevski_cas.problem.space import Equation, all_names
from kowalevski_cas.search.cofactors import cofactors
from kowalevski_cas.search.combinations import cofactors_for
from kowalevski_cas.search.numbers import linear_combination, solve_for_numbers
from kowalevski_cas.search.place import Candidate, PointFinder
from kowalevski_cas.search.real import real_points

Linear = tuple[Formula, dict[str, Formula]]
"""An equation as what is free of bound names, and the coefficients of those, with sum zero."""

Prove = Callable[[Simple, Evaluation], Evidence | None]
"""What finds a proof of a goal in an evaluation of its space."""

WEIGHTED = 24
"""At how many points an equation is looked at, to see that no numbers fit."""


def find_bound_values(goal: Exists, finder: PointFinder, prove: Prove) -> Found | None:
    """Values for the bound names, and the evidence that ``prove`` finds for each goal with them."""
    if goal.numbers:
        values = solve_for_numbers(goal, finder)
        if values is None:
            return None
    else:
        values = {}
        for one in goal.goals:
            if isinstance(one, Follows) and not isinstance(one, Fails) and not one.given:
                found_here = _linear(one, goal, values, finder.of(one.space))
                if found_here is None:
                    return None
                values |= found_here
    if values.keys() != set(goal.bound):
        return None
    evidence: list[Evidence] = []
    for one in goal.goals:
        at = finder.of(one.space)
        inner = prove(one, at.binding(_values_in_goal(one, values, at)))
        if inner is None:
            return None
        evidence.append(inner)
    return Found({name: values[name] for name in goal.bound}, tuple(evidence))


def _values_in_goal(goal: Simple, values: dict[str, Formula], at: Evaluation) -> dict[str, Element]:
    """The values of the bound names that stand in a goal."""
    mine = {name for formula in goal.formulas() for name in formula.names()}
    return {name: at.scalar(value) for name, value in values.items() if name in mine}


def _linear(
    goal: Follows, exists: Exists, values: dict[str, Formula], at: Evaluation
) -> dict[str, Formula] | None:
    """The names that the equations of a goal are linear in, solved for."""
    unknown = [name for name in exists.bound if name not in values]
    at = at.binding(_values_in_goal(goal, values, at))
    rows = [_row(sides, unknown) for sides in goal.conclusions[0]]
    found_here: dict[str, Formula] = {}
    waiting = [row for row in rows if row[1]]
    while waiting:
        group = _group(waiting)
        waiting = [row for row in waiting if row not in group]
        solution = _solve_for_values(group, at, goal)
        if solution is None:
            return None
        found_here |= {name: formula_in(value) for name, value in solution.items()}
    return found_here


def _row(sides: Equation, unknown: Sequence[str]) -> Linear:
    collected = collect_sides(sides, unknown)
    free = collected.pop((), Number(0))
    if any(len(monomial) > 1 for monomial in collected):
        return free, {}
    return free, {name: coefficient for (name,), coefficient in collected.items()}


def _group(rows: list[Linear]) -> list[Linear]:
    """The equations that share their unknowns, one way or another, with the first one."""
    names, size = set(rows[0][1]), 0
    while size != len(names):
        size = len(names)
        for _, coefficients in rows:
            if names & coefficients.keys():
                names |= coefficients.keys()
    return [row for row in rows if names & row[1].keys()]


def _solve_for_values(
    group: list[Linear], at: Evaluation, goal: Follows
) -> dict[str, Element] | None:
    """One equation is divided by its coefficients; several are a linear system.

    At last it is divided in what moves, by constants that then are conditions.
    """
    names = list(dict.fromkeys(name for _, coefficients in group for name in coefficients))
    if len(group) == 1:
        free, coefficients = group[0]
        known = [at.scalar(c) for c in coefficients.values()]
        target, moving = -at.scalar(free), tuple(at.setting.variables)
        row = cofactors_for(target, known, goal.main) or cofactors(target, known, (moving,))
        return None if row is None else dict(zip(coefficients, row, strict=True))
    zero = at.ring.zero
    matrix = [[at.scalar(cs[name]) if name in cs else zero for name in names] for _, cs in group]
    if len(matrix) != len(names):
        return None
    try:
        solved = solve(matrix, [[-at.scalar(free)] for free, _ in group])
        return {name: value for name, (value,) in zip(names, solved, strict=True)}
    except Singular:
        return None


def never(goal: Exists, finder: PointFinder) -> Regardless | None:
    """Points at which an identity fails whatever the bound names are."""
    for index, inner in enumerate(goal.goals):
        if isinstance(inner, Fails) or not isinstance(inner, Follows) or inner.given:
            continue
        for sides in inner.conclusions[0]:
            collected = collect_sides(sides, goal.bound)
            none = _no_numbers if goal.numbers else _no_expressions
            at = finder.of(inner.space)
            points = none(collected, finder, at, law(inner, at, goal.bound))
            if points is not None:
                return Regardless(index, points)
    return None


def _no_expressions(
    collected: Collected, finder: PointFinder, at: Evaluation, divided: Sequence[Element]
) -> tuple[tuple[Formula, Point], ...] | None:
    """A point where all that multiplies bound names vanishes, and the rest does not."""
    free = at.scalar(collected.pop((), Number(0)))
    if free.is_zero:
        return None
    known = [at.scalar(coefficient) for coefficient in collected.values()]
    divided = [*divided, free, *known]
    point = finder.point(at, known, divided, lambda candidate: not candidate(free).is_zero)
    return None if point is None else ((Number(1), point),)


def _no_numbers(
    collected: Collected, finder: PointFinder, at: Evaluation, divided: Sequence[Element]
) -> tuple[tuple[Formula, Point], ...] | None:
    """Points with weights at which an equation adds up to a number."""
    monomials = sorted(collected)
    elements = [at.scalar(collected[monomial]) for monomial in monomials]
    names = all_names(at.setting)
    rows: list[list[Fraction]] = []
    candidates: list[Candidate] = []
    for point in islice(real_points(at, names), 40 * WEIGHTED):
        candidate = Candidate(at, point)
        try:
            values = [rational(candidate(element)) for element in elements]
            _ = [candidate(element) for element in divided]
            candidate.point(names)
        except (ZeroDivisionError, Misplaced):
            continue
        if all(value is not None for value in values):
            rows.append([value or Fraction(0) for value in values])
            candidates.append(candidate)
        if len(rows) == WEIGHTED:
            break
    target = [Fraction(monomial == ()) for monomial in monomials]
    weights = linear_combination(rows, target)
    if weights is None or () not in monomials:
        return None
    chosen = [(w, c) for w, c in zip(weights, candidates, strict=True) if w]
    return tuple((fraction_formula(weight), c.point(names)) for weight, c in chosen)
