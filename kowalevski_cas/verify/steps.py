"""The steps that the program took, from the evidence for each goal."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import isqrt

from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.notation import (
    Derivative,
    Formula,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Relation,
    Vector,
)
from kowalevski_cas.paper.claims.forms import ONE, ZERO, Matrix, applied, matrix, minus, total
from kowalevski_cas.problem.evaluate import Evaluation, Meaningless
from kowalevski_cas.problem.evidence import At, Denial, Evidence, Found, Proof, Roots, Shown
from kowalevski_cas.problem.goals import Count, Exists, Fails, Follows, Goal, Rank
from kowalevski_cas.problem.space import Setting
from kowalevski_cas.verify.outcome import Step
from kowalevski_cas.verify.shown import point, shown, size, written
from kowalevski_cas.verify.statement import Statement, Verdicts, finder_of

LONGEST = 24
"""How many terms something that was computed has at most, for it to be shown."""


def steps(statement: Statement, verdicts: Verdicts) -> tuple[Step, ...]:
    """The steps that the program took, each once."""
    if isinstance(verdicts, Denial):
        goal = statement.goals[verdicts.goal]
        return tuple(_derivatives(goal)) if isinstance(goal, Follows) else ()
    both = zip(statement.goals, verdicts, strict=True)
    return tuple(dict.fromkeys(step for goal, evidence in both for step in _steps(goal, evidence)))


def _steps(goal: Goal, evidence: Evidence) -> Iterator[Step]:
    match goal, evidence:
        case Exists(), Found():
            yield from _found(goal, evidence)
        case Fails(), _:
            return
        case Follows(), Shown(proof, _):
            yield from _derivatives(goal)
            yield from _proof(goal, proof)
        case Rank(), At():
            yield _rank(goal, evidence)
        case Count(), Roots():
            yield _roots(goal, evidence)


# -- derivatives ---------------------------------------------------------------------


def _derivatives(goal: Follows) -> Iterator[Step]:
    """The derivatives that the program generated for left sides."""
    for left, _ in goal.conclusions[0] if goal.conclusions else ():
        for formula in _rates(left):
            yield from _derivative(formula, finder_of(goal.space))


def _rates(formula: Formula) -> Iterator[Derivative]:
    """The derivatives in a formula, the outer ones."""
    if isinstance(formula, Derivative):
        yield formula
    else:
        for child in formula.children():
            yield from _rates(child)


def _derivative(formula: Derivative, at: Evaluation) -> Iterator[Step]:
    try:
        values = at.components(formula)
    except Meaningless:
        return
    if all(value.is_zero for value in values):
        yield Step("The derivative along the vector field vanishes identically.")
    elif (terms := size(values)) > LONGEST:
        yield Step(f"The derivative along the vector field, as generated, has {terms} terms.")
    else:
        parts = tuple(shown(value, at.setting) for value in values)
        right = parts[0] if len(parts) == 1 else Vector(parts)
        words = "The derivative along the vector field, as generated:"
        yield Step(words, (_equal(written(formula, at.setting), right),))


# -- proofs --------------------------------------------------------------------------


def _proof(goal: Follows, proof: Proof) -> Iterator[Step]:
    """The combination that division found, or the cases."""
    at = finder_of(goal.space)
    if proof.product:
        yield _cases(proof, at)
    elif goal.given and proof.rows and len(goal.conclusions) == 1 and proof.power == 1:
        yield _combination(goal, proof, at)


def _cases(proof: Proof, at: Evaluation) -> Step:
    groups = [[at.scalar(entry) for entry in group] for group in proof.product]
    words = "From what is given it follows that a product vanishes; it is shown case by case"
    if size(element for group in groups for element in group) > LONGEST:
        return Step(f"{words}, for each of its {len(groups)} factors.")
    factors = [_squares([shown(element, at.setting) for element in group]) for group in groups]
    return Step(f"{words}, for each factor:", (_equal(_times(factors), ZERO),))


def _squares(group: Sequence[Formula]) -> Formula:
    """An element, or the sum of the squares of several, which vanishes with all of them."""
    return group[0] if len(group) == 1 else total(Power(one, Number(2)) for one in group)


def _combination(goal: Follows, proof: Proof, at: Evaluation) -> Step:
    rows = [[at.scalar(entry) for entry in row] for row in proof.rows]
    terms = size(entry for row in rows for entry in row)
    words = "Left minus right side is a combination of what is given"
    if terms > LONGEST:
        return Step(f"{words}; its coefficients have {terms} terms.")
    lefts = _differences(goal.conclusions[0], at)
    known = _differences(goal.given, at)
    sums = [_sum(row, known, at.setting) for row in rows]
    return Step(f"{words}:", tuple(map(_equal, lefts, sums)))


def _differences(equations: Sequence[tuple[Formula, Formula]], at: Evaluation) -> list[Formula]:
    """Left minus right sides as they are printed; between vectors as they were computed."""
    found: list[Formula] = []
    for sides in equations:
        parts = at.differences((sides,))
        if len(parts) == 1:
            found.append(written(minus(sides), at.setting))
        else:
            found += [shown(part, at.setting) for part in parts]
    return found


def _sum(row: Sequence[Element], known: Sequence[Formula], setting: Setting) -> Formula:
    return total(
        _scaled(shown(entry, setting), one)
        for entry, one in zip(row, known, strict=True)
        if not entry.is_zero
    )


# -- what is found -------------------------------------------------------------------


def _found(goal: Exists, evidence: Found) -> Iterator[Step]:
    """The values of bound names; those of a matrix together."""
    letters: dict[str, list[str]] = {}
    for name in goal.expressions:
        letters.setdefault(name.partition("_")[0], []).append(name)
    for letter, names in letters.items():
        yield _matrix(letter, isqrt(len(names)), goal, evidence)
    if goal.numbers:
        values = [evidence.values[name] for name in goal.numbers]
        equations = tuple(_equal(Name(n), v) for n, v in zip(goal.numbers, values, strict=True))
        yield Step("The numbers that the program found:", equations)


def _matrix(letter: str, rank: int, goal: Exists, evidence: Found) -> Step:
    """A square matrix; a cofactor matrix with the functions that it combines."""
    names = matrix(letter, rank, rank)
    functions, at = _moved(names, goal)
    setting = at.setting
    entries = [
        at.scalar(evidence.values[e.name]) for row in names for e in row if isinstance(e, Name)
    ]
    what = "cofactor matrix" if functions else f"matrix ${letter}$"
    if (terms := size(entries)) > LONGEST:
        return Step(f"The {what} that the program found has {terms} terms.")
    values = [shown(entry, setting) for entry in entries]
    rows = Vector(tuple(Vector(tuple(values[rank * k : rank * (k + 1)])) for k in range(rank)))
    if not functions:
        return Step(f"The {what} that the program found:", (_equal(Name(letter), rows),))
    rates = Vector(tuple(Vector((written(left, setting),)) for left, _ in functions))
    column = Vector(tuple(Vector((written(one, setting),)) for _, one in functions))
    words = "The derivatives are combinations of the functions, with a matrix that was found:"
    return Step(words, (_equal(rates, Product((rows, column))),))


def _moved(names: Matrix, goal: Exists) -> tuple[list[tuple[Derivative, Formula]], Evaluation]:
    """The derivatives that a matrix of names gives, and the functions; and where it lives."""
    first = finder_of(goal.goals[0].space)
    for one in goal.goals:
        if not isinstance(one, Follows) or len(one.conclusions) != 1:
            continue
        lefts = [left for left, _ in one.conclusions[0] if isinstance(left, Derivative)]
        functions = [left.argument for left in lefts]
        if len(functions) == len(names) and list(one.conclusions[0]) == list(
            zip(lefts, applied(names, functions), strict=True)
        ):
            return list(zip(lefts, functions, strict=True)), finder_of(one.space)
    return [], first


def _rank(goal: Rank, evidence: At) -> Step:
    count, setting = len(goal.space.variables), finder_of(goal.space).setting
    words = (
        f"{goal.rank} differentials are independent in the space of dimension {count}, so that "
        f"near this point the common level is a manifold of dimension {count - goal.rank}."
    )
    return Step(words, point=point(evidence.point.values, setting))


def _roots(goal: Count, found: Roots) -> Step:
    at, root = finder_of(goal.space), Name(found.root)
    coefficients = [shown(at.scalar(entry), at.setting) for entry in found.eliminant]
    powers = [ONE, root, *(Power(root, Number(k)) for k in range(2, len(coefficients) + 1))]
    terms = [_scaled(c, p) for c, p in zip(coefficients, powers[:-1], strict=True) if c != ZERO]
    equation = total([powers[-1], *reversed(terms)])
    return Step(
        "The solutions are given by the roots of one equation, all real and distinct:",
        (_equal(root, found.form), _equal(equation, ZERO)),
    )


# -- formulas ------------------------------------------------------------------------


def _equal(left: Formula, right: Formula) -> Relation:
    return Relation((left, right), ("=",))


def _times(factors: Sequence[Formula]) -> Formula:
    """A product, without factors that are one, and without a product in it."""
    flat = [part for f in factors for part in (f.factors if isinstance(f, Product) else (f,))]
    kept = tuple(factor for factor in flat if factor != ONE)
    return Product(kept) if len(kept) > 1 else kept[0] if kept else ONE


def _scaled(coefficient: Formula, factor: Formula) -> Formula:
    """A product with the sign before it."""
    if isinstance(coefficient, Negative):
        return Negative(_scaled(coefficient.argument, factor))
    return _times([coefficient, factor])
