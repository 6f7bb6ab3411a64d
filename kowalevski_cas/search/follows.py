"""What follows from what is given, by cofactors, and where it does not."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from functools import reduce
from itertools import chain, product
from operator import itemgetter, mul

from kowalevski_cas.algebra.flat import Flat
from kowalevski_cas.algebra.ideals import vanish_on
from kowalevski_cas.algebra.numbers import inverse_of
from kowalevski_cas.algebra.present import formula_rows
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.limits import time_limit
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.evidence import At, Entailment, Point, Proof
from kowalevski_cas.problem.examine import is_real, law, value_of
from kowalevski_cas.problem.goals import Fails, Follows
from kowalevski_cas.problem.place import PointEvaluation
from kowalevski_cas.problem.prune import Reach
from kowalevski_cas.search.cofactors import cofactors
from kowalevski_cas.search.combinations import Combinations, combinations_of, complete
from kowalevski_cas.search.equal_roots import equal_products, proof_by_equal_roots
from kowalevski_cas.search.pieces import proof_by_pieces
from kowalevski_cas.search.place import Candidate, Good, Height, PointFinder, Values
from kowalevski_cas.search.real_cases import RealCases

LARGEST_POWER = 3
"""The largest power of a goal that is combined."""

SIMPLEST = 20
"""Among how many points at which a goal fails the simplest is taken."""

WHERE_IT_FAILS = 3.0
"""Seconds for a proof of what fails at a point of the hypotheses, and holds at another one."""

LARGE = 2000
"""Of a difference with so many terms the values take long: the first point is taken."""


class FollowsFinder(PointFinder):
    """Evidence that equations follow from others, or fail where these hold."""

    def entailment(self, goal: Follows, at: Evaluation) -> Entailment | None:
        """A point of the hypotheses at which the goal holds, and a proof by cofactors.

        Without a point nobody looks for a proof, nor where the goal fails at all points in
        general position: at the first one, if nothing is given.
        """
        known = at.differences(goal.given)
        conclusions = [at.differences(conclusion) for conclusion in goal.conclusions]
        here = known if conclusions else ()
        sides = [e for conclusion in goal.conclusions for p in at.pairs(conclusion) for e in p]
        divided = [*law(goal, at), *known, *sides]

        def holds(there: Candidate | PointEvaluation) -> bool:
            return not conclusions or any(map(there.vanish, conclusions))

        point = self.point(at, here, divided)
        if point is None:
            return Entailment()
        if not holds(PointEvaluation(at, point)):
            point = self.point(at, here, divided, holds, 0) if goal.given else None
            if point is None:
                return None
            # it holds at best where something does not vanish: most that fail at a point are false
            with suppress(TimeoutError), time_limit(WHERE_IT_FAILS):
                return self._proved(goal, at, point, divided)
            return None
        return self._proved(goal, at, point, divided)

    def _proved(
        self, goal: Follows, at: Evaluation, point: Point, divided: Sequence[Element]
    ) -> Entailment | None:
        """A proof by roots, by pieces, or by cofactors."""
        known = at.differences(goal.given)
        goals = alternatives(goal, at) if goal.conclusions else []
        roots = None if known else proof_by_equal_roots(goals, at)
        roots = roots or proof_by_pieces(goals, known, at)
        return Entailment(roots, point) if roots else self._combined(goal, at, point, divided)

    def _combined(
        self, goal: Follows, at: Evaluation, point: Point, divided: Sequence[Element]
    ) -> Entailment | None:
        """A proof by cofactors, or by cases."""
        known = at.differences(goal.given)
        conclusions = [at.differences(conclusion) for conclusion in goal.conclusions]
        here = known if conclusions else ()
        found = rows_of(alternatives(goal, at), known, goal.main)
        entries = [entry for row in found[0] for entry in row] if found else []
        if found is None or any(entry.denominator for entry in entries):
            everywhere = self._at_real_points(goal, conclusions, known, at) or self._by_loci(
                goal, at
            )
            if everywhere is not None:
                return Entailment(everywhere, point)
        if found is None:
            return None
        rows, power = found
        proof = Proof(formula_rows(rows), power=power)
        if not goal.conclusions and self._divides(Entailment(proof), goal):
            return None
        if PointEvaluation(at, point).defines(entries):
            return Entailment(proof, point)
        if _divides_by_zero(entries, known, at, point):
            return None
        return Entailment(proof, self.point(at, here, [*divided, *entries]))

    @staticmethod
    def _at_real_points(
        goal: Follows,
        conclusions: Sequence[Sequence[Element]],
        known: Sequence[Element],
        at: Evaluation,
    ) -> Proof | None:
        """A proof by cases where all are polynomials, or where something is known of signs."""
        everything = (*known, *(one for conclusion in conclusions for one in conclusion))
        if not everything or not is_real(at.setting):
            return None
        plain = known and not at.ring.roots and not any(one.denominator for one in everything)
        if not plain and not _has_signs(goal):
            return None
        equal, differences = equal_products(at)
        known = [*known, *differences]
        found = RealCases(conclusions, known, at.granted).proof(known)
        return found and found._replace(equal=(*equal,))

    @staticmethod
    def _by_loci(goal: Follows, at: Evaluation) -> Proof | None:
        """A proof on a declared locus and off it: there the product with its squares vanishes."""
        goals, known = alternatives(goal, at), at.differences(goal.given)
        if len(goals) != 1 or not is_real(at.setting):
            return None
        for equations, _ in at.setting.loci:
            group = at.differences(equations)
            both = value_of(group) * goals[0]
            off, on = _row(both, known), _row(goals[0], [*known, *group])
            if off is not None and on is not None:
                last = [*(at.ring.zero for _ in known), at.ring.one]
                cases = Proof(formula_rows([on])), Proof(formula_rows([last]))
                return Proof(formula_rows([off]), formula_rows([group, goals]), cases)
        return None

    def _divides(self, shown: Entailment, goal: Follows) -> bool:
        """Whether a proof divides by something, and so shows nothing where that vanishes."""
        at = self.of(goal.space)
        return any(at.scalar(entry).denominator for row in shown.proof.rows for entry in row)

    def failure(
        self, goal: Follows, at: Evaluation, conditions: Sequence[Element] = ()
    ) -> At | None:
        """A point where the given equations and conditions hold; in each conclusion one fails."""
        known = at.differences(goal.given)
        failing = [
            [e for e in at.differences(conclusion) if not e.is_zero]
            for conclusion in goal.conclusions
        ]

        def fail(values: Values) -> bool:
            return all(any(map(inverse_of, map(values, conclusion))) for conclusion in failing)

        everywhere = isinstance(goal, Fails) and not goal.given
        on_pieces = self.on_pieces(known, fail) if everywhere else None

        def good(candidate: Candidate) -> bool:
            some = all(not candidate.vanish(conclusion) for conclusion in failing)
            return some and (on_pieces is None or on_pieces(candidate))

        divided = [*law(goal, at), *known, *(e for conclusion in failing for e in conclusion)]
        divided += [condition.inverse() for condition in conditions]
        # The basis below costs more than points in general position.
        among = None if any(map(_is_large, chain(*failing))) else SIMPLEST
        found = self.simplest(at, known, divided, good, 0, among, False)
        if found and found[0].fractions and among and not conditions:
            found = min(found, self._whole(at, known, divided, good) or found, key=itemgetter(0))
        point = found[1] if found else None
        if point is None and not any(all(vanish_on(conclusion, known)) for conclusion in failing):
            point = self.point(at, known, divided, good, among=among)
        return None if point is None else At(point)

    def _whole(
        self, at: Evaluation, known: Sequence[Element], divided: Sequence[Element], good: Good
    ) -> tuple[Height, Point] | None:
        """A point with whole coordinates, where one variable may vanish, or all but one."""

        def whole(candidate: Candidate) -> bool:
            return candidate.is_whole and good(candidate)

        return self.simplest(at, known, divided, whole, 1, SIMPLEST, False)


def _is_large(element: Element) -> bool:
    """Whether the numerators of an element have many terms."""
    return sum(len(p) for parts, _ in element.summands for p in parts.values()) > LARGE


def _has_signs(goal: Follows) -> bool:
    """Whether the space has roots that stand in no formula of a goal: they say what is real."""
    reach = Reach(goal.space)
    for formula in goal.formulas():
        reach.formula(formula)
    return not reach.names.issuperset(goal.space.roots)


def alternatives(goal: Follows, at: Evaluation) -> list[Element]:
    """What has to vanish: the products of one difference from each conclusion."""
    conclusions = [at.differences(conclusion) for conclusion in goal.conclusions]
    return [reduce(mul, choice, at.ring.one) for choice in product(*conclusions)]


def rows_of(
    goals: Sequence[Element], known: Sequence[Element], main: Sequence[tuple[str, ...]] = ()
) -> tuple[list[list[Element]], int] | None:
    """Rows of cofactors for the goals, or for a power of them; none if they vanish.

    They are sought by division; then by a Gröbner basis, which finds all that there are; then by
    division in main variables, for powers, and with the least condition.
    """
    if all(goal.is_zero for goal in goals):
        return [], 1
    several = len(known) > 1
    rows = complete(combine(goal, known, () if several else main) for goal in goals)
    if rows is not None:
        over = _are_over_roots(rows, known)
        return (over and Combinations(goals, known).rows(goals)) or rows, 1
    if not several and not goals[0].ring.roots:
        return None  # division finds all multiples of a polynomial
    made = combinations_of(goals, known)
    if not several:
        rows = made.rows(goals)
        return None if rows is None else (rows, 1)
    rows = made.rows(goals) or complete(combine(goal, known, main) for goal in goals)
    if rows is not None:
        return rows, 1
    for power in range(2, LARGEST_POWER + 1):
        if (rows := made.rows(goals, power)) is not None:
            return rows, power
    rows = complete(map(made.division_row, goals))
    return None if rows is None else (rows, 1)


def _are_over_roots(rows: Sequence[Sequence[Element]], known: Sequence[Element]) -> bool:
    """Whether cofactors are divided by a root that divides what is known: it may vanish there."""
    flat = Flat(known[0].ring) if known else None
    return any(
        entry.denominator and flat is not None and flat.without_roots(one)[0].parts.keys() - {0}
        for row in rows
        for entry, one in zip(row, known, strict=True)
    )


def _divides_by_zero(
    entries: Sequence[Element], known: Sequence[Element], at: Evaluation, point: Point
) -> bool:
    """Whether something that is divided by vanishes near a point wherever the known ones do."""
    there = PointEvaluation(at, point)
    for divisor in at.ring.divisors_of(entries) if known else ():
        found = rows_of([divisor], known)
        if found and there.defines([entry for row in found[0] for entry in row]):
            return True
    return False


def _row(target: Element, known: Sequence[Element]) -> list[Element] | None:
    """A row for the target that divides by nothing."""
    row = Combinations([target], known).row(target)
    return None if row is None or any(entry.denominator for entry in row) else row


def combine(
    target: Element, known: Sequence[Element], main: Sequence[tuple[str, ...]]
) -> list[Element] | None:
    """Cofactors of the target; one over a cofactor where the one known element is a multiple."""
    row = cofactors(target, known, main) if known else None
    if row is None and len(known) == 1 and not target.is_zero:
        inverse = cofactors(known[0], [target], main)
        with suppress(ZeroDivisionError):  # it divides zero
            row = [inverse[0].inverse()] if inverse else None
    return row
