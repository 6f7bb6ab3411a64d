"""The conditions of a statement that holds, with witnesses that they are necessary."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress

from kowalevski_cas.algebra.numbers import rank
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.notation import Formula, Number
from kowalevski_cas.paper.denominators import Shape
from kowalevski_cas.paper.elaborate import Elaboration
from kowalevski_cas.paper.scene import Locus
from kowalevski_cas.problem.differentials import factors_of_multipliers, multipliers
from kowalevski_cas.problem.evidence import Denial, Point
from kowalevski_cas.problem.examine import Accepted
from kowalevski_cas.problem.finder import finder_of
from kowalevski_cas.problem.goals import Fails, Rank
from kowalevski_cas.problem.place import PointEvaluation
from kowalevski_cas.problem.space import Meaningless, all_names
from kowalevski_cas.verify.as_printed import point
from kowalevski_cas.verify.certificate import Stored, Supported
from kowalevski_cas.verify.conditions import Divided, conditions_of, implies
from kowalevski_cas.verify.counterexamples import MANY, against
from kowalevski_cas.verify.loci import failure_on, say_nothing_on
from kowalevski_cas.verify.outcome import Condition, Counterexample
from kowalevski_cas.verify.real_zeros import real_zeros
from kowalevski_cas.verify.statement import Statement


def conditions(
    statement: Statement, accepted: Accepted, stored: Stored | None
) -> tuple[tuple[Condition, ...], dict[Formula, Supported | None]]:
    """The conditions of a statement that holds, with witnesses that they are needed.

    These are those of a certificate; what it says nothing of is looked for. With them, what fails
    where a condition is violated that has a locus, or that nothing was found.
    """
    found: list[Condition] = []
    failures: dict[Formula, Supported | None] = {}
    for setting, formula, locus in _conditions_with_loci(statement, accepted):
        condition = Condition(formula, "the formulas divide by it")
        if locus is not None:
            failure = failure_on(statement, setting, locus, stored)
            failures[setting.formula(locus.condition)] = failure
            if failure is not None:
                condition = _where_it_fails(statement, setting, locus, formula, failure)
                condition = condition._replace(zeros=real_zeros(formula, setting.finder))
        found.append(condition)
    return tuple(found), failures


def _conditions_with_loci(
    statement: Statement, accepted: Accepted
) -> Iterator[tuple[Elaboration, Formula, Locus | None]]:
    """What may not vanish, each with the declared locus where it does, if there is one."""
    printed = statement.claim.formulas(statement.on.texts)
    conditions = conditions_of(accepted, statement.legend, printed)
    for setting, formula in _independent_conditions(statement, conditions):
        loci = setting.scene.loci
        matching = (x for x in loci if setting.texts.expression(x.condition) == formula)
        yield setting, formula, next(matching, None)


def _independent_conditions(statement: Statement, conditions: list[Divided]) -> list[Divided]:
    """Conditions without those that say the same on the claim's own scene, or follow there."""
    setting_of_claim = statement.on(statement.claim.scene)
    kept: dict[object, Divided] = {}
    values: dict[object, Element] = {}
    # those of the claim's own scene come first, so that of several words theirs are kept
    for setting, formula in sorted(conditions, key=lambda c: c[0] is not setting_of_claim):
        key: object = formula
        with suppress(Meaningless):
            value = setting_of_claim.finder.scalar(setting_of_claim.plain(formula))
            values[key := Shape(value)] = value
        landmark = setting_of_claim.divisors.landmarks.get(key)
        kept.setdefault(
            key, (setting, formula) if landmark is None else (setting_of_claim, landmark)
        )
    for key, value in reversed([*values.items()]):  # of two that vanish together one stays
        if any(implies(value, other, setting_of_claim) for k, other in values.items() if k != key):
            del kept[key], values[key]
    return [*kept.values()]


def _where_it_fails(
    statement: Statement, setting: Elaboration, locus: Locus, formula: Formula, failure: Supported
) -> Condition:
    """A condition with a point of its locus where the statement fails."""
    if statement.claim.is_kind("Dimension"):
        return _where_it_is_singular(statement, locus, formula, failure)
    (goal,), verdicts = failure.statement.goals, failure.verdicts
    evidence = verdicts.evidence if isinstance(verdicts, Denial) else verdicts[0]
    witness = against(failure.statement, goal, evidence, failure.accepted)
    words = f"it fails for {locus.words}"
    if isinstance(goal, Fails) and say_nothing_on(setting, goal.given, locus):
        words = f"for {locus.words} the equations hold identically, and motions leave the set"
    if witness is not None and witness.left == MANY:
        words = f"for {locus.words} there are {MANY}"
    return Condition(formula, words, witness)


def _where_it_is_singular(
    statement: Statement, locus: Locus, formula: Formula, failure: Supported
) -> Condition:
    """A condition with a point of its locus where differentials of a set are dependent.

    That is certified; a dimension of the set on the locus is computed only, and the words say so.
    """
    from kowalevski_cas.verify.singular import dimension_at  # only sets are singular

    (goal,), (place,) = failure.statement.goals, failure.accepted.places
    assert isinstance(goal, Fails)
    rows = factors_of_multipliers(goal, place.at)
    count = rank([[*map(place, row)] for row in rows])
    setting = failure.statement.legend[goal.space]
    names = {*multipliers(goal)}
    names |= {bar for name, bar in goal.space.conjugates if name in names}
    values = {n: v for n, v in place.point.values.items() if n not in names}
    says = f"only {count} of the {len(rows)} differentials are independent"
    witness = Counterexample(point(values, setting), Number(count), Number(len(rows)), says)
    words = f"for {locus.words} the differentials are dependent"
    level = statement.goals[0]
    assert isinstance(level, Rank)
    there = statement.legend[level.space].equations(locus.equations)
    at_point = {name: values[name] for name in all_names(level.space) if name in values}
    dimension = dimension_at(level, there, PointEvaluation(finder_of(level.space), Point(at_point)))
    if dimension is not None:
        words += f"; there the set has dimension {dimension}, which is computed, not certified"
    return Condition(formula, words, witness, singular=True)
