"""The steps that the program took, from the evidence for each goal."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import product
from typing import Final

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
    Sum,
    Unwritten,
    Vector,
    equal,
    power,
    total,
)
from kowalevski_cas.paper.claims import Claim, ConstantRoot, Dimension
from kowalevski_cas.paper.claims.forms import ONE, ZERO
from kowalevski_cas.paper.elaborate import Elaboration
from kowalevski_cas.problem.evidence import (
    At,
    Denial,
    Entailment,
    Evidence,
    Found,
    Proof,
    Roots,
    Row,
)
from kowalevski_cas.problem.goals import Count, Exists, Fails, Follows, Goal, Rank
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.verify.as_printed import (
    element_formula,
    flat_product,
    point,
    printed_formula,
    signed_product,
    size,
)
from kowalevski_cas.verify.outcome import ReportedStep
from kowalevski_cas.verify.statement import Statement, Verdicts

LONGEST = 24
"""How many terms something that was computed has at most, for it to be shown."""

MOST = 12
"""How many products a combination has at most, for it to be shown."""


_VANISHES: Final = ReportedStep("The derivative along the vector field vanishes identically.")


def steps(statement: Statement, verdicts: Verdicts) -> tuple[ReportedStep, ...]:
    """The steps that the program took; formulas of which the same is said stand together."""
    if isinstance(verdicts, Denial):
        goal = statement.goals[verdicts.goal]
        told = list(_derivatives(goal, statement)) if isinstance(goal, Follows) else []
    else:
        both = zip(statement.goals, verdicts, strict=True)
        told = [s for goal, evidence in both for s in _steps(statement, goal, evidence)]
        follows = all(isinstance(goal, Follows) for goal in statement.goals)
        told = told or [_identical(statement)] * follows
    merged: dict[ReportedStep, dict[Formula, None]] = {}
    for step in told:
        merged.setdefault(step._replace(formulas=()), {}).update(dict.fromkeys(step.formulas))
    return tuple(step._replace(formulas=tuple(formulas)) for step, formulas in merged.items())


def _identical(statement: Statement) -> ReportedStep:
    """That everything vanishes identically: two sides, if the claim is an equation."""
    printed = statement.claim.printed
    formula = None if printed is None else statement.on.texts.formula(printed)
    if isinstance(formula, Relation) and Unwritten() not in formula.nodes():
        return ReportedStep("Written out, this is an identity.")
    return ReportedStep("Written out, each of the equations is an identity.")


def _steps(statement: Statement, goal: Goal, evidence: Evidence) -> Iterator[ReportedStep]:
    claim, legend = statement.claim, statement.legend
    match goal, evidence:
        case Exists(), Found():
            yield from _root(claim, goal, evidence, statement)
            yield from _values_found(goal, evidence, statement)
        case Fails(), _:
            return
        case Follows(), Entailment(proof, _):
            yield from _derivatives(goal, statement)
            yield from _proof(claim, goal, proof, legend[goal.space])
        case Rank(), At():
            yield _rank(claim, goal, evidence, legend[goal.space])
        case Count(), Roots():
            yield _roots(evidence, legend[goal.space])


# -- derivatives ---------------------------------------------------------------------


def _derivatives(goal: Follows, statement: Statement) -> Iterator[ReportedStep]:
    """The derivatives that the program generated for left sides."""
    told: list[ReportedStep] = []
    for left, _ in goal.conclusions[0] if goal.conclusions else ():
        match left:
            case (Derivative() as rate) | Product((Number(), Derivative() as rate)):
                told += _derivative(rate, statement.legend[goal.space])
    yield from [step for step in told if step != _VANISHES] or told[:1]


def _derivative(formula: Derivative, setting: Elaboration) -> Iterator[ReportedStep]:
    try:
        values = setting.finder.components(formula)
    except Meaningless:
        return
    if all(value.is_zero for value in values):
        yield _VANISHES
    elif (terms := size(values)) > LONGEST:
        yield ReportedStep(f"The derivative along the vector field has {terms} terms.")
    else:
        parts = tuple(element_formula(value, setting) for value in values)
        right = parts[0] if len(parts) == 1 else Vector(parts)
        words = "The derivative along the vector field:"
        yield ReportedStep(words, (equal(printed_formula(formula, setting), right),))


# -- proofs --------------------------------------------------------------------------


def _proof(
    claim: Claim, goal: Follows, proof: Proof, setting: Elaboration
) -> Iterator[ReportedStep]:
    """The combination that division found, or the cases."""
    if isinstance(claim, Dimension):
        yield _independent(proof, setting)
    elif proof.product:
        yield _cases(proof, setting)
    elif goal.given and proof.rows:
        yield _combination(goal, proof, setting)


def _independent(proof: Proof, setting: Elaboration) -> ReportedStep:
    """At all points of the set, by how many identities."""
    rows = [*_rows(proof)]
    terms = size(setting.finder.scalar(entry) for row in rows for entry in row)
    words = "The differentials are independent at every point of the set that the hypotheses admit"
    words += f", by {len(rows)} identities whose coefficients have {terms} terms"
    return ReportedStep(words, withheld=True)


def _rows(proof: Proof) -> Iterator[Row]:
    """The rows of a proof and of its cases."""
    yield from proof.rows
    for case in proof.cases:
        yield from _rows(case)


def _cases(proof: Proof, setting: Elaboration) -> ReportedStep:
    groups = [[setting.finder.scalar(entry) for entry in group] for group in proof.product]
    words = "The hypotheses imply that a product vanishes; the proof goes case by case"
    if size(element for group in groups for element in group) > LONGEST:
        return ReportedStep(f"{words}, for each of its factors", withheld=True)
    factors = [
        _squares([element_formula(element, setting) for element in group]) for group in groups
    ]
    return ReportedStep(f"{words}, for each factor:", (equal(flat_product(factors), ZERO),))


def _squares(group: Sequence[Formula]) -> Formula:
    """An element, or the sum of the squares of several, which vanishes with all of them."""
    return group[0] if len(group) == 1 else total(Power(element, Number(2)) for element in group)


def _combination(goal: Follows, proof: Proof, setting: Elaboration) -> ReportedStep:
    rows = [[setting.finder.scalar(entry) for entry in row] for row in proof.rows]
    terms = size(entry for row in rows for entry in row)
    single = len(goal.conclusions) == 1
    what = "difference of the two sides" if single else "product of the differences of their sides"
    what = f"{'a power of ' * (proof.power > 1)}the {what} is a combination of the hypotheses"
    words = f"{what[0].upper()}{what[1:]}" if single else f"One of the alternatives holds: {what}"
    products = sum(not entry.is_zero for row in rows for entry in row)
    if terms > LONGEST or products > MOST:
        return ReportedStep(f"{words}; its coefficients have {terms} terms", withheld=True)
    choices = product(*(_differences(conclusion, setting) for conclusion in goal.conclusions))
    lefts = [power(left, proof.power) for left in map(flat_product, choices)]
    known = _differences(goal.given, setting)
    sums = [_sum(row, known, setting) for row in rows]
    return ReportedStep(f"{words}:", tuple(map(equal, lefts, sums)))


def _differences(
    equations: Sequence[tuple[Formula, Formula]], setting: Elaboration
) -> list[Formula]:
    """Left minus right sides as they are printed; between vectors as they were computed."""
    found: list[Formula] = []
    for sides in equations:
        parts = setting.finder.differences((sides,))
        if len(parts) == 1:
            found.append(printed_formula(_minus(*sides), setting))
        else:
            found += [element_formula(part, setting) for part in parts]
    return found


def _minus(left: Formula, right: Formula) -> Formula:
    terms = left.terms if isinstance(left, Sum) else (left,)
    return total(terms if right == ZERO else (*terms, Negative(right)))


def _sum(row: Sequence[Element], known: Sequence[Formula], setting: Elaboration) -> Formula:
    return total(
        signed_product(element_formula(entry, setting), term)
        for entry, term in zip(row, known, strict=True)
        if not entry.is_zero
    )


# -- what is found -------------------------------------------------------------------


def _root(
    claim: Claim, goal: Exists, evidence: Found, statement: Statement
) -> Iterator[ReportedStep]:
    """A constant root, as the combination of constants that was found."""
    if isinstance(claim, ConstantRoot):
        basis = [statement.on(claim.scene).formula(tex) for tex in claim.basis]
        numbers = [evidence.values[name] for name in goal.numbers]
        found = zip(numbers, basis, strict=True)
        root = total(signed_product(number, root) for number, root in found if number != ZERO)
        said = equal(Name(claim.unknown), root)
        yield ReportedStep("The root that the program found:", (said,))


def _values_found(goal: Exists, evidence: Found, statement: Statement) -> Iterator[ReportedStep]:
    """The equations that are linear in bound names."""
    for inner in goal.goals:
        if not isinstance(inner, Follows):
            continue
        for left, right in inner.conclusions[0] if inner.conclusions else ():
            terms = _linear(right, goal.bound)
            if terms is not None:
                yield _bound_names(left, terms, evidence, statement.legend[inner.space])


def _linear(formula: Formula, bound: Sequence[str]) -> list[tuple[str, Formula]] | None:
    """The bound names and their coefficients; ``None`` if a term is no product of such two."""
    found = []
    for term in formula.terms if isinstance(formula, Sum) else (formula,):
        match term:
            case Product((Name(name), other)) if name in bound:
                found.append((name, other))
            case _:
                return None
    return found


def _bound_names(
    left: Formula, terms: Sequence[tuple[str, Formula]], evidence: Found, setting: Elaboration
) -> ReportedStep:
    values = [setting.finder.scalar(evidence.values[name]) for name, _ in terms]
    what = "derivatives" if isinstance(left, Derivative) else "functions"
    if (many := size(values)) > LONGEST:
        subject = f"The {what[:-1]} of one" if what == "derivatives" else "One function"
        words = "is a linear combination of the relations whose coefficients have"
        return ReportedStep(f"{subject} {words} {many} terms", withheld=True)
    words = f"The {what} are linear combinations of the relations"
    right = _sum(values, [printed_formula(term, setting) for _, term in terms], setting)
    return ReportedStep(f"{words}:", (equal(printed_formula(left, setting), right),))


def _rank(claim: Claim, goal: Rank, evidence: At, setting: Elaboration) -> ReportedStep:
    count = len(goal.space.variables)
    where = point(evidence.point.values, setting)
    if len(goal.functions) == 1 and not isinstance(claim, Dimension):
        others = " is independent of those of the hypotheses" if goal.given else " does not vanish"
        return ReportedStep(
            f"the differential{others}, so the function is not constant.", point=where
        )
    words = (
        f"{goal.rank} differentials are independent in the space of dimension {count}, so that "
        f"near this point the common level is a manifold of dimension {count - goal.rank}"
    )
    words += (
        "." if goal.given else ", and hence they are independent on a dense subset of the space."
    )
    return ReportedStep(words, point=where)


def _roots(found: Roots, setting: Elaboration) -> ReportedStep:
    at, root = setting.finder, Name(found.root)
    coefficients = [element_formula(at.scalar(entry), setting) for entry in found.eliminant]
    powers = [ONE, root, *(Power(root, Number(k)) for k in range(2, len(coefficients) + 1))]
    terms = [
        signed_product(c, p) for c, p in zip(coefficients, powers[:-1], strict=True) if c != ZERO
    ]
    equation = total([powers[-1], *reversed(terms)])
    return ReportedStep(
        "The solutions are given by the roots of one equation, all real and distinct:",
        (equal(root, found.form), equal(equation, ZERO)),
    )
