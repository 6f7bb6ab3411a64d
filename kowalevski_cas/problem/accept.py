"""Whether evidence proves a goal, or denies it, in one arithmetic.

This is the one function through which every verdict goes; nothing that a search found is
believed before it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from functools import reduce
from itertools import product
from operator import mul
from types import MappingProxyType
from typing import Any

from kowalevski_cas.algebra.numbers import independent, inverse_of, rational
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.notation import Number
from kowalevski_cas.problem.collect import collect_sides
from kowalevski_cas.problem.differentials import differentials, functions_for_differentials, minors
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.evidence import (
    At,
    Departure,
    Entailment,
    Evidence,
    Found,
    Further,
    Minors,
    Proof,
    Regardless,
    Roots,
    Solutions,
)
from kowalevski_cas.problem.examine import Examiner, Unproved, Vacuous, is_real, law, need_point
from kowalevski_cas.problem.goals import (
    Along,
    Count,
    Exists,
    Fails,
    Follows,
    Goal,
    Kernel,
    Rank,
    Simple,
)
from kowalevski_cas.problem.place import Misplaced, Pieces, PointEvaluation
from kowalevski_cas.problem.space import Equation, Meaningless

ZERO = Number(0)


class Judge(Examiner):
    """Decides whether evidence proves or denies goals."""

    def holds(self, goal: Goal, evidence: Evidence) -> None:
        """Accept that a goal holds, or raise :class:`Unproved`."""
        self._decide(goal, evidence, True)

    def denies(self, goal: Goal, evidence: Evidence) -> None:
        """Accept that a goal is false, or raise :class:`Unproved`."""
        self._decide(goal, evidence, False)

    def _decide(self, goal: Goal, evidence: Evidence, sign: bool) -> None:
        try:
            self._rule(goal, evidence, sign)
        except Vacuous:
            raise
        except (Unproved, Misplaced, Meaningless, ZeroDivisionError) as error:
            raise Unproved(str(error)) from None
        except (ValueError, TypeError, LookupError, AttributeError) as error:
            raise Unproved(f"the evidence has another shape: {error}") from None

    def _rule(self, goal: Goal, evidence: Evidence, sign: bool) -> None:
        match goal, evidence, sign:
            case Exists(), Found(), True:
                self._exists(goal, evidence)
            case Exists(), Regardless(), False:
                self._never(goal, evidence)
            case Exists(), _, _:
                raise Unproved("there are no expressions among the evidence")
            case _:
                self._simple(goal, evidence, sign, self.of(goal.space))

    def _simple(
        self,
        goal: Simple,
        evidence: Evidence,
        sign: bool,
        at: Evaluation,
        values: Mapping[str, Element] = MappingProxyType({}),
    ) -> None:
        self.accepted.starts(goal)
        self.accepted.uses([*values.values()])
        self.accepted.divides([*at.hypotheses, *law(goal, at)])
        rule = _RULES.get((type(goal), type(evidence), sign))
        if rule is None:
            raise Unproved("it is no evidence for this goal")
        rule(self, goal, evidence, at, sign)

    # -- what follows --------------------------------------------------------------

    def _everywhere(self, goal: Follows, evidence: Entailment, at: Evaluation, sign: bool) -> None:
        """What was said to fail somewhere follows, without a condition."""
        self._follows(goal, evidence, at, sign)
        self._unconditional(at)

    def _follows(self, goal: Follows, evidence: Entailment, at: Evaluation, sign: bool) -> None:
        if not all(goal.conclusions):
            raise Unproved("nothing is stated")
        need_point(evidence.point)
        known = at.differences(goal.given)
        pairs = [at.pairs(conclusion) for conclusion in goal.conclusions]
        sides = [e for equations in pairs for pair in equations for e in pair]
        self.accepted.divides([*sides, *known])
        alternatives = [[left - right for left, right in pair] for pair in pairs]
        goals = [reduce(mul, choice, at.ring.one) for choice in product(*alternatives)]
        used = list(self._settle(goals, known, evidence.proof, at))
        self.accepted.uses(used)
        if not goal.conclusions:
            self._unconditional(at)
        self._point(at, evidence.point, known if goal.conclusions else ())

    def _fails(self, goal: Follows, evidence: At, at: Evaluation, sign: bool) -> None:
        known = at.differences(goal.given)
        if type(goal) is Fails:
            sides = (pair for conclusion in goal.conclusions for pair in at.pairs(conclusion))
            self.accepted.divides([*known, *(e for pair in sides for e in pair)])
        place = self._point(at, evidence.point, known)
        for conclusion in goal.conclusions:
            values = [(place(a), place(b)) for a, b in at.pairs(conclusion)]
            self.accepted.differs = next((v for v in values if not (v[0] - v[1]).is_zero), None)
            if self.accepted.differs is None:
                raise Unproved("all equations hold at the point")
            if type(goal) is Fails and not goal.given:
                pieces = Pieces(place, ())
                rests = (pieces(left - right) for left, right in at.pairs(conclusion))
                if not any(map(inverse_of, rests)):
                    raise Unproved("all equations may hold on another piece")

    # -- ranks ---------------------------------------------------------------------

    def _rows(self, goal: Rank, at: Evaluation) -> list[list[Element]]:
        functions = functions_for_differentials(goal, at)
        self.accepted.divides(functions)
        return differentials(functions, at)

    def _rank(self, goal: Rank, evidence: At, at: Evaluation, sign: bool) -> None:
        rows = self._rows(goal, at)
        known = at.differences(goal.given)
        place = self._point(at, evidence.point, known)
        pieces = Pieces(place, known)
        if not independent([[pieces(entry) for entry in row] for row in rows]):
            raise Unproved("the differentials may be dependent at the point, or on another piece")
        if (len(rows) == goal.rank) != sign:
            raise Unproved(f"there are {len(rows)} independent differentials")

    def _minors(self, goal: Rank, evidence: Minors, at: Evaluation, sign: bool) -> None:
        all_minors, known = minors(self._rows(goal, at)), at.differences(goal.given)
        if len(evidence.rows) != len(all_minors):
            raise Unproved("there is not a row for each minor")
        used = list(self._settle(all_minors, known, Proof(evidence.rows), at))
        self.accepted.uses(used)
        self._unconditional(at)

    # -- counts --------------------------------------------------------------------

    def _count(self, goal: Count, evidence: Roots, at: Evaluation, sign: bool) -> None:
        from kowalevski_cas.problem.count import check_free, check_roots  # few problems count

        if (len(evidence.eliminant) == goal.number) != sign:
            raise Unproved("it is another number of solutions")
        if not is_real(goal.space):
            raise Unproved("what is counted has to be real")
        known = at.differences(goal.equations)
        away, left = check_roots(goal, evidence, at)
        self.accepted.away[-1].extend(away)
        self.accepted.divides([*known, *left])
        check_free(goal, at, [*self.accepted.divided[-1][1], *away])
        self._point(at, evidence.point, known)

    def _solutions(self, goal: Count, evidence: Solutions, at: Evaluation, sign: bool) -> None:
        from kowalevski_cas.problem.count import check_solutions

        self.accepted.places += check_solutions(goal, evidence, at)

    # -- kernels ---------------------------------------------------------------------

    def _kernel(self, goal: Kernel, evidence: At | Further, at: Evaluation, sign: bool) -> None:
        from kowalevski_cas.problem import kernel  # nor has every one a kernel

        self.accepted.divides([*at.rates.values(), at.scalar(goal.factor)])
        place = self._point(at, evidence.point, ())
        if isinstance(evidence, Further):
            kernel.check_further(goal, evidence.formula, at, place)
        elif sign:
            kernel.check_complete(goal, at, place)
        else:
            kernel.check_no_solution(goal, at, place)

    # -- solutions -------------------------------------------------------------------

    def _along(self, goal: Along, evidence: At | Departure, at: Evaluation, sign: bool) -> None:
        from kowalevski_cas.problem import along  # or follows one motion

        solutions = along.InitialValueProblem(goal, at)
        self._point(at, evidence.point, solutions.differences)
        if isinstance(evidence, Departure):
            along.check_departure(solutions, evidence.order, self.accepted.places[-1])
        else:
            along.check_equal(solutions)

    # -- what exists ---------------------------------------------------------------

    def _exists(self, goal: Exists, evidence: Found) -> None:
        if set(evidence.values) != set(goal.bound):
            raise Unproved("a bound name has no value")
        if set(goal.bound).difference(
            *(f.names() for inner in goal.goals for f in inner.formulas())
        ):
            raise Unproved("a bound name is not used")
        for inner_goal, inner in zip(goal.goals, evidence.evidence, strict=True):
            at = self.of(inner_goal.space)
            mine = {n for f in inner_goal.formulas() for n in f.names() if n in goal.bound}
            values = {n: at.scalar(f) for n, f in evidence.values.items() if n in mine}
            for name in mine & set(goal.numbers):
                if rational(values[name]) is None:
                    raise Unproved(f"{name} is no number")
            self._simple(inner_goal, inner, True, at.binding(values), values)

    def _never(self, goal: Exists, evidence: Regardless) -> None:
        inner = goal.goals[evidence.goal]
        if type(inner) is not Follows or inner.given or len(inner.conclusions) != 1:
            raise Unproved("only an identity can fail whatever the bound names are")
        self.accepted.starts(inner)
        at = self.of(inner.space)
        self.accepted.divides(law(inner, at, goal.bound))
        places = [(w, self._point(at, p, ())) for w, p in evidence.points]
        weighted = [(_rational(place.numbers.scalar(weight)), place) for weight, place in places]
        if not any(self._impossible(goal, sides, at, weighted) for sides in inner.conclusions[0]):
            raise Unproved("with other expressions the equation may hold")

    def _impossible(
        self,
        goal: Exists,
        sides: Equation,
        at: Evaluation,
        weighted: Sequence[tuple[Fraction, PointEvaluation]],
    ) -> bool:
        """Whether the weighted sum of an equation at points is a number other than zero."""
        collected = collect_sides(sides, goal.bound)
        free = at.components(collected.pop((), ZERO))
        for monomial, coefficient in collected.items():
            elements = at.components(coefficient)
            alone = not set(monomial) & set(goal.expressions)
            if not (_adds_to_zero(elements, weighted) if alone else _vanish(elements, weighted)):
                return False
        return not _adds_to_zero(free, weighted)


def _vanish(
    elements: Sequence[Element], weighted: Sequence[tuple[Fraction, PointEvaluation]]
) -> bool:
    return all(place(element).is_zero for _, place in weighted for element in elements)


def _adds_to_zero(
    elements: Sequence[Element], weighted: Sequence[tuple[Fraction, PointEvaluation]]
) -> bool:
    """Whether the weighted sums of values vanish; of several points they have to be rational."""
    if len(weighted) == 1:
        return _vanish(elements, weighted)
    for element in elements:
        if sum((weight * _rational(place(element)) for weight, place in weighted), Fraction(0)):
            return False
    return True


def _rational(number: Element) -> Fraction:
    value = rational(number)
    if value is None:
        raise Unproved("a value at a point is not rational")
    return value


Rule = Callable[[Judge, Any, Any, Evaluation, bool], None]
_RULES: dict[tuple[type, type, bool], Rule] = {
    (Fails, At, True): Judge._fails,
    (Fails, Entailment, False): Judge._everywhere,
    (Follows, Entailment, True): Judge._follows,
    (Follows, At, False): Judge._fails,
    (Rank, At, True): Judge._rank,
    (Rank, At, False): Judge._rank,
    (Rank, Minors, False): Judge._minors,
    (Count, Roots, True): Judge._count,
    (Count, Roots, False): Judge._count,
    (Count, Solutions, False): Judge._solutions,
    (Kernel, At, True): Judge._kernel,
    (Kernel, At, False): Judge._kernel,
    (Kernel, Further, False): Judge._kernel,
    (Along, At, True): Judge._along,
    (Along, Departure, False): Judge._along,
}
"""What checks a kind of evidence for a kind of goal, or against it."""
