"""Where a condition is violated: points of a locus at which a statement fails."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import combinations

from kowalevski_cas.algebra.ideals import vanish_on
from kowalevski_cas.algebra.present import fraction_formula
from kowalevski_cas.notation import Formula, Number, Product, Sum
from kowalevski_cas.paper.claims.forms import minus, rate, vanishes
from kowalevski_cas.paper.elaborate import Elaboration
from kowalevski_cas.paper.scene import Locus
from kowalevski_cas.problem.accept import Judge
from kowalevski_cas.problem.evidence import Denial, Point
from kowalevski_cas.problem.examine import Unproved
from kowalevski_cas.problem.finder import finder_of
from kowalevski_cas.problem.goals import Count, Exists, Fails, Follows, Goal
from kowalevski_cas.problem.place import PointEvaluation
from kowalevski_cas.problem.space import Equation
from kowalevski_cas.problem.trees import FormatError, Tree, encode
from kowalevski_cas.verify.certificate import Stored, Supported
from kowalevski_cas.verify.statement import Statement, Verdicts

ORDERS = 3
"""Up to which order derivatives are looked at for a motion that leaves a set."""


def goals_where_violated(statement: Statement) -> Iterator[tuple[Tree, str]]:
    """What may fail where a condition is violated: the condition, and the digest of a problem."""
    for setting in dict.fromkeys([*statement.legend.values(), statement.on(statement.claim.scene)]):
        for locus in setting.scene.loci:
            for goal in _candidates(statement, setting, locus):
                alone = Statement(statement.claim, statement.on, (goal,))
                yield encode(setting.formula(locus.condition)), alone.digest


def failure_on(
    statement: Statement, setting: Elaboration, locus: Locus, stored: Stored | None
) -> Supported | None:
    """What fails on a locus, as a certificate has it; what is found, if none says anything of it.

    Raises :class:`FormatError` if the evidence of the certificate does not show it.
    """
    condition = setting.formula(locus.condition)
    known = None if stored is None else stored.failures(statement, encode(condition))
    for goal in _candidates(statement, setting, locus) if known != [] else ():
        alone = Statement(statement.claim, statement.on, (goal,))
        if known is None:
            verdicts = _evidence_at_locus(alone.goals[0], condition)
        else:
            verdicts = next((v for entry in known if (v := entry.verdicts(alone))), None)
        if verdicts is None:
            continue
        evidence = verdicts.evidence if isinstance(verdicts, Denial) else verdicts[0]
        judge = Judge(finder_of)
        try:
            (judge.denies if isinstance(goal, Count) else judge.holds)(alone.goals[0], evidence)
            if not all(
                place.vanish([place.at.scalar(condition)]) for place in judge.accepted.places
            ):
                raise Unproved("the condition holds there")
        except Unproved as error:
            if stored is None or known is None:
                continue
            raise FormatError(f"what fails for {locus.words}: {error}") from None
        return Supported(alone, verdicts, judge.accepted)
    return None


def _evidence_at_locus(goal: Goal, condition: Formula) -> Verdicts | None:
    """Evidence that a goal fails, or is denied, where a condition is violated."""
    from kowalevski_cas.search.find import Finder  # most evidence is read
    from kowalevski_cas.search.levels import more_solutions
    from kowalevski_cas.search.singular import dependence_at

    finder = Finder(finder_of)
    if isinstance(goal, Count):
        zero = finder_of(goal.space).scalar(condition)
        solutions = more_solutions(goal, finder, [zero])
        return None if solutions is None else Denial(0, solutions)
    singular = dependence_at(goal) if isinstance(goal, Fails) else None
    evidence = singular or finder.proof(goal)
    return None if evidence is None else (evidence,)


def _candidates(
    statement: Statement, setting: Elaboration, locus: Locus
) -> Iterator[Fails | Count]:
    """What may fail on a locus: conclusions, derivatives of a set that should stay, counts.

    The conclusions are those over any space with the locus, as one with more constants.
    """
    for goal in statement.claimed:
        space = getattr(goal, "space", None)
        if type(goal) is Follows and isinstance(space, Elaboration) and locus in space.scene.loci:
            there = (*space.equations(locus.equations), vanishes(space.formula(locus.condition)))
            yield Fails(space, goal.conclusions, (*goal.given, *there))
        if isinstance(goal, Exists):
            for inner in goal.goals:
                if isinstance(inner, Follows) and inner.given and inner.space is setting:
                    there = setting.equations(locus.equations)
                    yield from _leaves_set(setting, inner.given, there)
    yield from (goal for goal in statement.claimed if isinstance(goal, Count))


def _leaves_set(
    setting: Elaboration, relations: tuple[Equation, ...], there: tuple[Equation, ...]
) -> Iterator[Fails]:
    """That a derivative of a function of a set is not zero somewhere on it."""
    rates = [minus(sides) for sides in relations]
    for _ in range(ORDERS):
        rates = [rate(formula) for formula in rates]
        for formula in rates:
            yield Fails(setting, ((vanishes(formula),),), (*relations, *there))


def say_nothing_on(setting: Elaboration, given: tuple[Equation, ...], locus: Locus) -> bool:
    """Whether all equations that are given follow from those of a locus."""
    at = setting.finder
    there = at.differences(setting.equations(locus.equations))
    return all(vanish_on(at.differences(given), there))


def circle_of(
    goal: Count, places: Sequence[PointEvaluation]
) -> tuple[PointEvaluation, PointEvaluation] | None:
    """Two solutions p and q such that p cos φ + q sin φ is one for every φ.

    There an equation of degree d is a trigonometric polynomial of degree d: it vanishes
    identically if it has 2d + 1 zeros. At p and at q, where tan φ/2 is 0 and 1, it has two.
    """
    at = places[0].at
    equations = at.differences(goal.equations)
    monomials = (m for e in equations for terms in e.terms().values() for m in terms)
    # with t = 0 and 1, which are p and q, these are 2d + 1
    angles = range(2, 2 * max(map(sum, monomials), default=0) + 1)
    for one, other in combinations(places, 2):
        if all(_between(one, other, t, goal).vanish(equations) for t in angles):
            return one, other
    return None


def _between(one: PointEvaluation, other: PointEvaluation, t: int, goal: Count) -> PointEvaluation:
    """The point p cos φ + q sin φ for tan φ/2 = t; the constants are those of p."""
    cosine, sine = (fraction_formula(Fraction(n, 1 + t * t)) for n in (1 - t * t, 2 * t))
    values = dict(one.point.values)
    for name in goal.names:
        pair = values.get(name, Number(0)), other.point.values.get(name, Number(0))
        values[name] = Sum((Product((cosine, pair[0])), Product((sine, pair[1]))))
    return PointEvaluation(one.at, Point(values))
