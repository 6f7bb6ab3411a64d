"""What a reader is told of a decision: conditions, counterexamples, and the steps taken."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from kowalevski_cas.algebra.present import formula_of
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.notation import (
    Derivative,
    Formula,
    Name,
    Negative,
    Number,
    Product,
    Relation,
    Sum,
    Vector,
)
from kowalevski_cas.paper.claims import Dimension
from kowalevski_cas.paper.elaborate import Elaboration
from kowalevski_cas.paper.scene import Locus
from kowalevski_cas.problem.accept import Accepted, Judge, Unproved
from kowalevski_cas.problem.evaluate import Evaluation, Meaningless
from kowalevski_cas.problem.evidence import (
    At,
    Denial,
    Evidence,
    Found,
    Minors,
    Proof,
    Regardless,
    Roots,
    Shown,
    Solutions,
)
from kowalevski_cas.problem.goals import (
    Count,
    Exists,
    Fails,
    Follows,
    Goal,
    Rank,
)
from kowalevski_cas.problem.place import Place, number_formula
from kowalevski_cas.verify.conditions import Divided, conditions_of, implies, same
from kowalevski_cas.verify.loci import failure_on, rank_on
from kowalevski_cas.verify.outcome import Condition, Counterexample, Point, Step, Value
from kowalevski_cas.verify.statement import Statement, Verdicts, finder_of

LONGEST = 24
"""How many terms a derivative has at most that is shown."""


# -- conditions ----------------------------------------------------------------------


def conditions(statement: Statement, accepted: Accepted, explain: bool) -> tuple[Condition, ...]:
    """The conditions of a statement that holds; with witnesses that they are needed, if asked."""
    found = []
    for setting, formula in _needed(statement, conditions_of(accepted)):
        locus = _locus(setting, formula)
        condition = Condition(formula, "the formulas divide by it")
        if locus is not None and explain:
            condition = _where_it_fails(statement, setting, locus, condition)
        found.append(condition)
    known = {condition.expression for condition in found}
    for setting, locus, witness in _larger_sets(statement):
        expression = setting.texts.expression(locus.condition)
        if expression not in known:
            found.append(Condition(expression, witness.words, witness))
    return tuple(found)


def _needed(statement: Statement, conditions: list[Divided]) -> list[Divided]:
    """Conditions without those that say the same on the claim's own scene, or follow there."""
    own = statement.on(statement.claim.scene)
    named = [own.texts.expression(locus.condition) for locus in own.scene.loci]
    kept: list[Divided] = []
    for setting, formula in sorted(conditions, key=lambda c: c[0] is not own):
        landmark = next((name for name in named if same(formula, name, own)), None)
        if not any(same(formula, other, own) for _, other in kept):
            kept.append((setting, formula) if landmark is None else (own, landmark))
    return [
        (setting, formula)
        for setting, formula in kept
        if not any(f is not formula and implies(formula, f, own) for _, f in kept)
    ]


def _locus(setting: Elaboration, formula: Formula) -> Locus | None:
    """The declared locus where a condition is violated, if there is one."""
    loci = setting.scene.loci
    return next((x for x in loci if setting.texts.expression(x.condition) == formula), None)


def _where_it_fails(
    statement: Statement, setting: Elaboration, locus: Locus, condition: Condition
) -> Condition:
    """A condition with a point of its locus where the statement fails, if one is found."""
    found = failure_on(statement, setting, locus)
    if found is None:
        return condition
    goal, evidence = found
    judge = Judge(finder_of)
    try:
        judge.holds(goal, evidence) if isinstance(goal, Fails) else judge.denies(goal, evidence)
    except Unproved:
        return condition
    witness = _against(statement, goal, evidence, judge.accepted)
    return Condition(condition.expression, f"it fails for {locus.words}", witness)


def _larger_sets(
    statement: Statement,
) -> Iterator[tuple[Elaboration, Locus, Counterexample]]:
    """Loci on which a set has another dimension, with a point each."""
    for goal in statement.goals:
        if not isinstance(goal, Rank) or not isinstance(statement.claim, Dimension):
            continue
        assert isinstance(goal.space, Elaboration)
        for locus in goal.space.scene.loci:
            found = rank_on(statement, goal, goal.space, locus)
            if found is None or found[0] == goal.rank:
                continue
            count = len(goal.space.variables)
            own, claimed = count - found[0], count - goal.rank
            words = f"for {locus.words} the set has dimension {own}"
            shown = _point(Place(goal.space.finder, found[1]))
            yield goal.space, locus, Counterexample(shown, Number(own), Number(claimed), words)


# -- counterexamples -----------------------------------------------------------------


def counterexample(
    statement: Statement, denial: Denial, accepted: Accepted
) -> Counterexample | None:
    """The point at which a denied goal fails, with the two values there."""
    return _against(statement, statement.goals[denial.goal], denial.evidence, accepted)


def _against(
    statement: Statement, goal: Goal, evidence: Evidence, accepted: Accepted
) -> Counterexample | None:
    if isinstance(evidence, Solutions) and isinstance(goal, Count):
        return _solutions(goal, accepted)
    if isinstance(evidence, Roots) and isinstance(goal, Count):
        words = "the number of solutions, all of which are real, and the one claimed"
        number = Number(len(evidence.eliminant))
        return Counterexample(_point(accepted.places[-1]), number, Number(goal.number), words)
    if isinstance(evidence, Minors) or not accepted.places:
        return None
    place = accepted.places[-1]
    if isinstance(goal, Rank):
        own = len(place.at.setting.variables) - _size(goal, place.at)
        claimed = len(place.at.setting.variables) - goal.rank
        words = "the dimension by the rank at this point, and the dimension claimed"
        return Counterexample(_point(place), Number(own), Number(claimed), words)
    if accepted.differs is not None:
        left, right = map(number_formula, accepted.differs)
        return Counterexample(_point(place), left, right, _words(goal))
    if isinstance(evidence, Regardless) and isinstance(goal, Exists):
        return _regardless(goal, evidence, place)
    return None


def why(goal: Goal, evidence: Evidence) -> str:
    """Why a goal is denied, where no two values say so."""
    match goal, evidence:
        case Fails(), Shown():
            return "what is said to fail somewhere holds everywhere"
        case Follows(conclusions=()), At():
            return "there is a real point where none is said to be"
        case Rank(), Minors():
            return "the differentials depend on each other everywhere"
    return ""


def _words(goal: Goal) -> str:
    if isinstance(goal, Follows) and goal.given:
        return "the two sides at a point where what is given holds"
    return ""


def _size(goal: Rank, at: Evaluation) -> int:
    return len(goal.functions) + len(at.differences(goal.given))


def _regardless(goal: Exists, evidence: Regardless, place: Place) -> Counterexample | None:
    """What is left of an equation at a point where all bound names drop out."""
    from kowalevski_cas.problem.collect import collect

    one = goal.goals[evidence.goal]
    assert isinstance(one, Follows)
    for left, right in one.conclusions[0]:
        free = collect(Sum((left, Negative(right))), goal.bound).get((), Number(0))
        value = place(place.at.scalar(free))
        if not value.is_zero:
            words = "the derivative at a point where no combination can give it, and zero"
            return Counterexample(_point(place), number_formula(value), Number(0), words)
    return None


def _solutions(goal: Count, accepted: Accepted) -> Counterexample:
    """The solutions that are listed, each name with the number of the solution."""
    values: dict[Formula, Value] = {}
    first = accepted.places[0]
    for name in first.point.values:
        if name not in goal.names:
            values[_named(first, name)] = first.point.values[name]
    for number, place in enumerate(accepted.places, 1):
        assert isinstance(place.at.setting, Elaboration)
        vectors = place.at.setting.scene.vectors
        for vector, names in vectors.items():
            entries = tuple(place.point.values.get(name, Number(0)) for name in names)
            if any(entry != Number(0) for entry in entries):
                values[Name(f"{vector}_{number}")] = Vector(entries)
    words = "the number of solutions that are listed, and the one claimed"
    shown = len(accepted.places)
    return Counterexample(Point(values), Number(shown), Number(goal.number), words)


def _point(place: Place) -> Point:
    return Point({_named(place, name): value for name, value in place.point.values.items()})


def _named(place: Place, name: str) -> Formula:
    """A name as the paper prints it."""
    setting = place.at.setting
    return setting.texts.expression(name) if isinstance(setting, Elaboration) else Name(name)


# -- steps ---------------------------------------------------------------------------


def steps(statement: Statement, verdicts: Verdicts) -> tuple[Step, ...]:
    """The steps that the program took."""
    if isinstance(verdicts, Denial):
        goal = statement.goals[verdicts.goal]
        return tuple(_derivatives(goal)) if isinstance(goal, Follows) else ()
    told: list[Step] = []
    for goal, evidence in zip(statement.goals, verdicts, strict=True):
        told += _steps(goal, evidence)
    return tuple(dict.fromkeys(told))


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
            assert isinstance(goal.space, Elaboration)
            count = len(goal.space.variables)
            yield Step(
                f"{goal.rank} differentials are independent at a point in the space of dimension "
                f"{count}, so that the set near it is a manifold of dimension {count - goal.rank}."
            )
        case Count(), Roots():
            yield from _roots(goal, evidence)


def _derivatives(goal: Follows) -> Iterator[Step]:
    """The derivatives that the program generated for left sides."""
    at = finder_of(goal.space)
    for equations in goal.conclusions[:1]:
        for left, _ in equations:
            if isinstance(left, Derivative):
                yield from _derivative(left, at)


def _derivative(left: Formula, at: Evaluation) -> Iterator[Step]:
    words = "The derivative along the vector field, as generated"
    try:
        values = at.components(left)
    except Meaningless:
        return
    for value in values:
        terms = sum(map(len, value.terms().values()))
        if terms > LONGEST:
            yield Step(f"{words}, has {terms} terms.")
        else:
            yield Step(f"{words}:", (_equal(left, _shown(value, at)),))


def _proof(goal: Follows, proof: Proof) -> Iterator[Step]:
    """The combination that division found, or the cases."""
    if proof.cases:
        yield Step("It is shown case by case: in each, a factor of a consequence vanishes.")
    if not proof.rows or not goal.given:
        return
    at = finder_of(goal.space)
    names = [Product((Name(f"g_{{{k + 1}}}"),)) for k in range(len(proof.rows[0]))]
    row = [at.scalar(entry) for entry in proof.rows[0]]
    terms = [
        _scaled(_shown(c, at), Name(f"g_{{{k + 1}}}")) for k, c in enumerate(row) if not c.is_zero
    ]
    if len(row) == len(names) and sum(len(c.terms()) for c in row) < LONGEST:
        words = "Left minus right side, as a combination of what is given, $g_k=0$:"
        yield Step(words, (_total(terms),))


def _found(goal: Exists, evidence: Found) -> Iterator[Step]:
    """The values of bound names; those of a matrix as a matrix."""
    letters: dict[str, list[str]] = {}
    for name in evidence.values:
        letters.setdefault(name.partition("_")[0], []).append(name)
    for letter, names in letters.items():
        values = [_written(name, goal, evidence) for name in names]
        size = int(len(names) ** 0.5)
        if goal.numbers:
            equations = tuple(_equal(Name(n), v) for n, v in zip(names, values, strict=True))
            yield Step("The numbers that the program found:", equations)
        elif size * size == len(names):
            rows = tuple(Vector(tuple(values[size * i : size * (i + 1)])) for i in range(size))
            yield Step("The matrix that the program found:", (_equal(Name(letter), Vector(rows)),))


def _written(name: str, goal: Exists, evidence: Found) -> Formula:
    """The value of a bound name in the names of the setting in which it stands first."""
    for one in goal.goals:
        at = finder_of(one.space)
        try:
            return _shown(at.scalar(evidence.values[name]), at)
        except Meaningless:
            continue
    return evidence.values[name]


def _roots(goal: Count, found: Roots) -> Iterator[Step]:
    root = Name(found.root)
    powers = [
        Product((c, root)) if k == 1 else c if k == 0 else Product((c, _power(root, k)))
        for k, c in enumerate(found.eliminant)
        if c != Number(0)
    ]
    equation = Sum((_power(root, len(found.eliminant)), *reversed(powers)))
    yield Step(
        "The solutions are given by the roots of one equation, all real and distinct:",
        (_equal(root, found.form), _equal(equation, Number(0))),
    )


def _power(base: Formula, exponent: int) -> Formula:
    from kowalevski_cas.notation import Power

    return Power(base, Number(exponent))


def _shown(element: Element, at: Evaluation) -> Formula:
    setting = at.setting
    assert isinstance(setting, Elaboration)
    return formula_of(element, setting.texts.vocabulary)


def _equal(left: Formula, right: Formula) -> Relation:
    return Relation((left, right), ("=",))


def _scaled(coefficient: Formula, factor: Formula) -> Formula:
    if isinstance(coefficient, Negative):
        return Negative(_scaled(coefficient.argument, factor))
    if coefficient == Number(1):
        return factor
    own = coefficient.factors if isinstance(coefficient, Product) else (coefficient,)
    return Product((*own, factor))


def _total(terms: Sequence[Formula]) -> Formula:
    return Sum(tuple(terms)) if len(terms) > 1 else next(iter(terms), Number(0))
