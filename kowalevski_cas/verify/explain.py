"""What a reader is told of a decision: conditions and counterexamples."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress

from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.notation import (
    Application,
    Derivative,
    Formula,
    Name,
    Number,
    Partial,
    Relation,
    Vector,
    equal,
    to_latex,
    total,
)
from kowalevski_cas.paper.claims import (
    Casimir,
    Claim,
    CriticalSet,
    Dimension,
    FirstIntegral,
    Involution,
    Jacobi,
    LiouvilleIntegrable,
)
from kowalevski_cas.paper.claims.forms import ZERO
from kowalevski_cas.paper.denominators import shape_of
from kowalevski_cas.paper.elaborate import Elaboration
from kowalevski_cas.paper.scene import Locus
from kowalevski_cas.problem.collect import collect_sides
from kowalevski_cas.problem.differentials import chosen
from kowalevski_cas.problem.evidence import (
    At,
    Denial,
    Evidence,
    Minors,
    Regardless,
    Roots,
    Shown,
    Solutions,
)
from kowalevski_cas.problem.examine import Accepted
from kowalevski_cas.problem.goals import Count, Exists, Fails, Follows, Goal, Rank
from kowalevski_cas.problem.place import Place, number_formula
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.verify.certificate import Stored, Supported
from kowalevski_cas.verify.conditions import Divided, conditions_of, implies
from kowalevski_cas.verify.loci import circle_of, drop_on, failure_on, rank_on, say_nothing_on
from kowalevski_cas.verify.outcome import Condition, Counterexample, Point, Value
from kowalevski_cas.verify.shown import named, point, scaled, written
from kowalevski_cas.verify.statement import Statement

SHORT = 160
"""The most letters of an equation in LaTeX that is named within a sentence."""

MANY = "infinitely many"
"""How many solutions there are on a circle."""


# -- conditions ----------------------------------------------------------------------


def conditions(
    statement: Statement, accepted: Accepted, stored: Stored | None
) -> tuple[Condition, ...]:
    """The conditions of a statement that holds, with witnesses that they are needed.

    These are those of a certificate; what it says nothing of is looked for.
    """
    found = []
    for setting, formula, locus in _lacking(statement, accepted):
        condition = Condition(formula, "the formulas divide by it")
        if locus and (failure := failure_on(statement, setting, locus, stored)):
            condition = _where_it_fails(statement, setting, locus, formula, failure)
        found.append(condition)
    known = [condition.expression for condition in found]
    singular = {condition.expression: condition for condition in _singular(statement, known)}
    return tuple(singular.get(condition.expression, condition) for condition in found)


def failures(
    statement: Statement, accepted: Accepted, stored: Stored | None
) -> dict[Formula, Supported | None]:
    """What fails where conditions are violated that have a locus."""
    return {
        setting.formula(locus.condition): failure_on(statement, setting, locus, stored)
        for setting, _, locus in _lacking(statement, accepted)
        if locus is not None
    }


def _lacking(
    statement: Statement, accepted: Accepted
) -> Iterator[tuple[Elaboration, Formula, Locus | None]]:
    """What may not vanish, each with the declared locus where it does, if there is one."""
    for setting, formula in _needed(statement, conditions_of(accepted)):
        loci = setting.scene.loci
        own = (x for x in loci if setting.texts.expression(x.condition) == formula)
        yield setting, formula, next(own, None)


def _needed(statement: Statement, conditions: list[Divided]) -> list[Divided]:
    """Conditions without those that say the same on the claim's own scene, or follow there."""
    own = statement.on(statement.claim.scene)
    kept: dict[object, Divided] = {}
    values: dict[object, Element] = {}
    for setting, formula in sorted(conditions, key=lambda c: c[0] is not own):
        key: object = formula
        with suppress(Meaningless):
            value = own.finder.scalar(own.plain(formula))
            values[key := shape_of(value)] = value
        landmark = own.divisors.landmarks.get(key)
        kept.setdefault(key, (setting, formula) if landmark is None else (own, landmark))
    for key, value in reversed([*values.items()]):  # of two that vanish together one stays
        if any(implies(value, other, own) for k, other in values.items() if k != key):
            del kept[key], values[key]
    return [*kept.values()]


def _where_it_fails(
    statement: Statement, setting: Elaboration, locus: Locus, formula: Formula, failure: Supported
) -> Condition:
    """A condition with a point of its locus where the statement fails."""
    (goal,), verdicts = failure.statement.goals, failure.verdicts
    evidence = verdicts.evidence if isinstance(verdicts, Denial) else verdicts[0]
    witness = _against(statement, goal, evidence, failure.accepted)
    words = f"it fails for {locus.words}"
    if isinstance(goal, Fails) and say_nothing_on(setting, goal.given, locus):
        words = f"for {locus.words} the equations hold identically, and motions leave the set"
    if witness is not None and witness.left == MANY:
        words = f"for {locus.words} there are {MANY}"
    return Condition(formula, words, witness)


def _singular(statement: Statement, known: Sequence[Formula]) -> Iterator[Condition]:
    """Loci of known conditions where a set has another dimension, or is singular; with points."""
    goal = statement.goals[0]
    if not isinstance(statement.claim, Dimension) or not isinstance(goal, Rank):
        return
    assert isinstance(goal.space, Elaboration)
    for locus in goal.space.scene.loci:
        expression = goal.space.texts.expression(locus.condition)
        if expression not in known:
            continue
        found = rank_on(statement, goal, goal.space, locus)
        if found is not None and found[0] < goal.rank:
            count = len(goal.space.variables)
            own, claimed = count - found[0], count - goal.rank
            words = f"near this point the set has dimension {own}, not {claimed}"
            there = point(found[1].values, goal.space)
            against = Counterexample(there, Number(own), Number(claimed), words)
            said = f"for {locus.words} the set has dimension {own}"
            yield Condition(expression, said, against)
        elif dropped := drop_on(statement, goal, goal.space, locus):
            words = f"only {dropped[0]} of the {goal.rank} differentials are independent"
            there = point(dropped[1].values, goal.space)
            against = Counterexample(there, Number(dropped[0]), Number(goal.rank), words)
            yield Condition(expression, f"for {locus.words} the set is singular", against)


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
        number = len(evidence.eliminant)
        words = f"the number of solutions, all of them real, is {number}, not {goal.number}"
        there = _at(accepted.places[-1])
        return Counterexample(there, Number(number), Number(goal.number), words)
    if isinstance(evidence, Minors) or not accepted.places:
        return None
    place = accepted.places[-1]
    if isinstance(goal, Rank):
        own = len(place.at.setting.variables) - len(chosen(goal, place.at))
        claimed = len(place.at.setting.variables) - goal.rank
        words = f"by the rank at this point the dimension is {own}, not {claimed}"
        return Counterexample(_at(place), Number(own), Number(claimed), words)
    if accepted.differs is not None:
        left, right = map(number_formula, accepted.differs)
        words = _words(statement, goal, place, (to_latex(left), to_latex(right)))
        return Counterexample(_at(place), left, right, words)
    if isinstance(evidence, Regardless) and isinstance(goal, Exists):
        return _regardless(goal, evidence, place)
    return None


def _at(place: Place) -> Point:
    return point(place.point.values, place.at.setting)


def _words(statement: Statement, goal: Goal, place: Place, values: tuple[str, str]) -> str:
    """What fails at a point, if not what is printed; ``values`` are the two sides there."""
    assert isinstance(goal, Follows)
    own, other = values
    left, right = (written(side, place.at.setting) for side in _failing(goal, place))
    order = 0
    while isinstance(left, Derivative):
        left, order = left.argument, order + 1
    if order and right == Number(0):
        which = ("", "second ", "third ")[min(order, 3) - 1]
        of = to_latex(left)
        whose = f" of ${of}$" if len(of) < SHORT else " of a given function" if goal.given else ""
        return f"the {which}derivative{whose} along the motion is ${own}$, not $0$"
    if isinstance(statement.claim, Casimir | Involution | Jacobi | LiouvilleIntegrable):
        if not order:
            return f"a bracket is ${own}$, not $0$"
        rate = f"the derivative of ${to_latex(left)}$ is ${own}$"
        return f"{rate}, and its bracket with the Hamiltonian ${other}$"
    if right == Number(0) and any(isinstance(one, Partial) for one in left.nodes()):
        return f"a derivative of the function is ${own}$, so the point is not critical"
    sides = to_latex(equal(left, right))
    what = f" of ${sides}$" if not order and len(sides) < SHORT else ""
    if not goal.given:
        printed = statement.claim.formulas(statement.on.texts)
        said = {member for one in printed if isinstance(one, Relation) for member in one.members}
        if said & {left, right} or not what:
            return ""
    words = f"the left side{what} is ${own}$, not ${other}$"
    if isinstance(statement.claim, CriticalSet):
        return f"{words}, at this critical point"
    return f"{words}, though the hypotheses hold" if goal.given else words


def _failing(goal: Follows, place: Place) -> tuple[Formula, Formula]:
    """The first equation of the last conclusion that does not hold at a point."""
    return next(
        sides for sides in goal.conclusions[-1] if not place.vanish(place.at.differences((sides,)))
    )


def why(claim: Claim, goal: Goal, evidence: Evidence) -> str:
    """Why a goal of a claim is denied, where no two values say so."""
    match goal, evidence:
        case Fails(), Shown() if isinstance(claim, FirstIntegral):
            if claim.given:
                return "the function is constant everywhere, not on this set only"
            return "the function is constant by itself"
        case Fails(), Shown():
            return "what is said to fail somewhere holds everywhere"
        case Follows(conclusions=()), At():
            return "there is a real point where none is said to be"
        case Rank(functions=(_,), given=()), Minors():
            return "the function is constant by itself"
        case Rank(), Minors():
            return "the differentials depend on each other everywhere"
    return ""


def _regardless(goal: Exists, evidence: Regardless, place: Place) -> Counterexample | None:
    """What is left of an equation at a point where all bound names drop out."""
    one = goal.goals[evidence.goal]
    assert isinstance(one, Follows)
    for sides in one.conclusions[0]:
        free = collect_sides(sides, goal.bound).get((), Number(0))
        value = place(place.at.scalar(free))
        if not value.is_zero:
            left = number_formula(value)
            words = (
                f"the derivative is ${to_latex(left)}$, "
                "and every combination of the functions is $0$"
            )
            return Counterexample(_at(place), left, Number(0), words)
    return None


def _solutions(goal: Count, accepted: Accepted) -> Counterexample:
    """The solutions that are listed, each name with the number of the solution."""
    first = accepted.places[0]
    values: dict[Formula, Value] = {
        named(name, first.at.setting): value
        for name, value in first.point.values.items()
        if name not in goal.names
    }
    if circle := circle_of(goal, accepted.places):
        points: list[Mapping[str, Formula]] = [_on_circle(*circle)]
        words = f"a solution for every $\\varphi$, so that there are {MANY}, not {goal.number}"
        shown: Value = MANY
    else:
        points = [place.point.values for place in accepted.places]
        many = f"these are {len(points)} solutions" if len(points) > 1 else "this is a solution"
        words = f"{many}, and there are to be {goal.number or 'none'}"
        shown = Number(len(points))
    assert isinstance(first.at.setting, Elaboration)
    for number, own in enumerate(points, 1):
        for vector, names in first.at.setting.scene.vectors.items():
            entries = tuple(own.get(name, ZERO) for name in names)
            if any(entry != ZERO for entry in entries):
                values[Name(vector if circle else f"{vector}_{number}")] = Vector(entries)
    return Counterexample(Point(values), shown, Number(goal.number), words)


def _on_circle(one: Place, other: Place) -> dict[str, Formula]:
    """The points p cos φ + q sin φ."""
    angle = Name(r"\varphi")
    waves = [Application(function, (angle,)) for function in (r"\cos", r"\sin")]
    found = {}
    for name, value in one.point.values.items():
        pair = zip((value, other.point.values.get(name, ZERO)), waves, strict=True)
        found[name] = total(scaled(factor, wave) for factor, wave in pair if factor != ZERO)
    return found
