"""Evidence for a goal, or against it: found with FLINT, and never believed here."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import reduce
from itertools import combinations, islice, product

from kowalevski_cas.algebra.linear import determinant
from kowalevski_cas.algebra.numbers import Substitution, gaussian, number_ring, rank
from kowalevski_cas.algebra.points import ExactPoint
from kowalevski_cas.algebra.present import formula_in
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.problem.accept import is_real
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.evidence import At, Evidence, Minors, Point, Proof, Shown
from kowalevski_cas.problem.goals import (
    Count,
    Exists,
    Fails,
    Follows,
    Goal,
    Positive,
    Rank,
)
from kowalevski_cas.problem.place import Misplaced, Place, number_formula
from kowalevski_cas.problem.space import Setting
from kowalevski_cas.search.cofactors import cofactors
from kowalevski_cas.search.real import real_points

Of = Callable[[Setting], Evaluation]
Good = Callable[["Candidate"], bool]

TRIES = 12
"""How many points of one kind are looked at."""


LARGEST_POWER = 3
"""The largest power of a goal that is combined."""


class Candidate:
    """An exact point, before anybody has checked it: the values of elements there."""

    def __init__(self, at: Evaluation, point: ExactPoint) -> None:
        self.at = at
        self.numbers = number_ring(at.polynomials)
        values = {name: gaussian(self.numbers, *value) for name, value in point.items()}
        self._value = Substitution(at.ring, values, self.numbers, roots={})
        for bit, name in enumerate(at.ring.roots):
            below = at.ring.below[bit]
            if name not in values:
                root = self._value.root(self(at.ring.radicands[bit]))
            else:
                root = values[name] if below is None else values[name] * self(below)
            self._value.roots[bit] = root

    def __call__(self, element: Element) -> Element:
        """The value there; raises ``ZeroDivisionError`` on a zero of the denominator."""
        return self._value(element)

    def vanish(self, elements: Sequence[Element]) -> bool:
        """Whether all elements vanish there."""
        return all(self(element).is_zero for element in elements)

    def point(self, names: Sequence[str]) -> Point:
        """The point as evidence; raises :class:`Misplaced` where a value cannot be written."""
        from kowalevski_cas.notation import Name

        values = {name: number_formula(self(self.at.scalar(Name(name)))) for name in names}
        return Point(values)


class Finder:
    """Evidence for the goals of one problem.

    ``of`` evaluates spaces with FLINT, ``names`` are those to which a point of a space gives
    values. With ``points`` false nothing but proofs is looked for.
    """

    def __init__(self, of: Of, names: Callable[[Setting], Sequence[str]]) -> None:
        self.of = of
        self.names = names

    def proof(self, goal: Goal, at: Evaluation | None = None) -> Evidence | None:
        """Evidence that a goal holds."""
        match goal:
            case Exists():
                from kowalevski_cas.search.bound import found

                return found(goal, self)
            case Fails():
                return self.failure(goal, at or self.of(goal.space))
            case Follows():
                return self.shown(goal, at or self.of(goal.space))
            case Rank():
                return self.independent(goal, at or self.of(goal.space))
            case Positive():
                from kowalevski_cas.search.positive import positive

                return positive(goal, self)
            case Count():
                from kowalevski_cas.search.count import roots

                return roots(goal, self)

    def refutation(self, goal: Goal) -> Evidence | None:
        """Evidence that a goal is false."""
        match goal:
            case Exists():
                from kowalevski_cas.search.bound import never

                return never(goal, self)
            case Fails():
                shown = self.shown(goal, self.of(goal.space))
                return None if shown is None or self._divides(shown, goal) else shown
            case Follows():
                return self.failure(goal, self.of(goal.space))
            case Rank():
                return self.dependent(goal)
            case Positive():
                return None
            case Count():
                from kowalevski_cas.search.count import others

                return others(goal, self)

    # -- what follows --------------------------------------------------------------

    def shown(self, goal: Follows, at: Evaluation) -> Shown | None:
        """A proof by cofactors, and a point of the hypotheses."""
        known = at.differences(goal.given)
        goals = alternatives(goal, at)
        found = self.rows(goals, known, goal.main)
        if found is None:
            return None
        rows, power = found
        proof = self._everywhere(goal, at, rows) if power == 1 else None
        if proof is not None:
            rows = []
        else:
            proof = Proof(tuple(tuple(map(formula_in, row)) for row in rows), power=power)
        if not goal.conclusions and self._divides(Shown(proof), goal):
            return None
        if not (goal.conclusions and goal.given):
            return Shown(proof)
        divided = [e for row in rows for e in row]
        divided += [e for one in goal.conclusions for p in at.pairs(one) for e in p]
        point = self.point(at, known, [*divided, *known])
        return None if point is None else Shown(proof, point)

    def _divides(self, shown: Shown, goal: Follows) -> bool:
        """Whether a proof divides by something, and so shows nothing where that vanishes."""
        at = self.of(goal.space)
        return any(at.scalar(entry).denominator for row in shown.proof.rows for entry in row)

    def _everywhere(
        self, goal: Follows, at: Evaluation, rows: Sequence[Sequence[Element]]
    ) -> Proof | None:
        """A proof by cases that needs no condition, where the rows divide by one declared locus.

        Either the locus is met, where the goal follows by another division, or it is not.
        """
        goals, known = alternatives(goal, at), at.differences(goal.given)
        if len(goals) != 1 or len(rows) != 1 or not is_real(at.setting):
            return None
        below: dict[int, int] = {}
        for entry in rows[0]:
            for index, exponent in entry.denominator.items():
                below[index] = max(exponent, below.get(index, 0))
        own = {index for element in [*goals, *known] for index in element.denominator}
        if set(below) - own != set(below) or len(below) != 1:
            return None
        ((index, exponent),) = below.items()
        for equations, condition in at.setting.loci:
            if not (
                at.scalar(condition) - Element(at.ring, {0: at.ring.divisors[index]}, {})
            ).is_zero:
                continue
            group = at.differences(equations)
            total = reduce(Element.__add__, (e * e for e in group))
            there = cofactors(goals[0], [*known, *group], ())
            if there is None or any(entry.denominator for entry in there):
                continue
            if (total - at.scalar(condition)).is_zero:
                factor = total**exponent * goals[0] ** (exponent - 1)
                row = [entry * factor for entry in rows[0]]
                last = [*(at.ring.zero for _ in known), at.ring.one]
                return Proof(
                    (tuple(map(formula_in, row)),),
                    (tuple(map(formula_in, group)), (formula_in(goals[0]),)),
                    (
                        Proof((tuple(map(formula_in, there)),)),
                        Proof((tuple(map(formula_in, last)),)),
                    ),
                    exponent,
                )
        return None

    @staticmethod
    def rows(
        goals: Sequence[Element], known: Sequence[Element], main: Sequence[tuple[str, ...]] = ()
    ) -> tuple[list[list[Element]], int] | None:
        """Rows of cofactors for the goals, or for a power of them; none if they vanish."""
        if all(goal.is_zero for goal in goals):
            return [], 1
        for power in range(1, LARGEST_POWER + 1 if len(known) > 1 else 2):
            rows = [combined(goal**power, known, main) for goal in goals]
            if None not in rows:
                return [row for row in rows if row is not None], power
        return None

    def failure(self, goal: Follows, at: Evaluation) -> At | None:
        """A point where the given equations hold and in each conclusion one fails."""
        known = at.differences(goal.given)
        failing = [[e for e in at.differences(one) if not e.is_zero] for one in goal.conclusions]
        if not all(failing):
            return None

        def good(candidate: Candidate) -> bool:
            return all(not candidate.vanish(one) for one in failing)

        divided = [*known, *(e for one in failing for e in one)]
        point = self.point(at, known, divided, good)
        return None if point is None else At(point)

    # -- ranks ---------------------------------------------------------------------

    def independent(self, goal: Rank, at: Evaluation) -> At | None:
        """A point where all differentials are independent, if they are as many as claimed."""
        return self._independent(goal, at) if self._count(goal, at) == goal.rank else None

    def dependent(self, goal: Rank) -> Evidence | None:
        """A point where another number is independent, or minors that vanish."""
        at = self.of(goal.space)
        if self._count(goal, at) != goal.rank:
            return self._independent(goal, at)
        rows = self._gradients(goal, at)
        columns = combinations(range(len(goal.space.variables)), len(rows))
        minors = (determinant([[row[k] for k in chosen] for row in rows]) for chosen in columns)
        return Minors(()) if all(minor.is_zero for minor in minors) else None

    def _count(self, goal: Rank, at: Evaluation) -> int:
        return len(goal.functions) + len(at.differences(goal.given))

    def _gradients(self, goal: Rank, at: Evaluation) -> list[list[Element]]:
        chosen = [at.scalar(f) for f in goal.functions] + at.differences(goal.given)
        return [[at.partial(f, name) for name in goal.space.variables] for f in chosen]

    def _independent(self, goal: Rank, at: Evaluation) -> At | None:
        rows, known = self._gradients(goal, at), at.differences(goal.given)

        def good(candidate: Candidate) -> bool:
            return rank([[candidate(entry) for entry in row] for row in rows]) == len(rows)

        divided = [*known, *(entry for row in rows for entry in row)]
        point = self.point(at, known, divided, good)
        return None if point is None else At(point)

    # -- points --------------------------------------------------------------------

    def point(
        self,
        at: Evaluation,
        zero: Sequence[Element] = (),
        divided: Sequence[Element] = (),
        good: Good = lambda candidate: True,
    ) -> Point | None:
        """A real point where elements vanish, nothing is divided by zero, and all is good.

        It is sought among points in general position, and then where one or two variables vanish.
        """
        avoid = [at.scalar(formula) for formula in at.setting.nonzero]
        avoid += divisors(at, divided)
        names = self.names(at.setting)
        norms = [self._norm(at, element) for element in zero]
        for further in self._sections(at):
            for point in islice(real_points(at, [*norms, *further], avoid), TRIES):
                try:
                    candidate = Candidate(at, point)
                    if candidate.vanish(zero) and good(candidate):
                        found = candidate.point(names)
                        Place(at, found)
                        return found
                except (ZeroDivisionError, Misplaced):
                    continue
        return None

    def _sections(self, at: Evaluation) -> Iterator[Sequence[Element]]:
        """Nothing more, then one or two variables that vanish; powers are 1 where known."""
        setting = at.setting
        one = at.ring.one
        fixed: list[Element] = []
        for name in setting.powers:
            step = setting.step(name)
            base = getattr(step, "base", None)
            assert base is not None
            fixed += [at.ring.generator(name) - one, at.scalar(base) - one]
        variables = [at.ring.generator(name) for name in setting.variables]
        for size in range(3):
            for chosen in combinations(variables, size):
                yield [*fixed, *chosen]

    @staticmethod
    def _norm(at: Evaluation, element: Element) -> Element:
        """The element times its conjugates by the roots that are no variables."""
        for bit, name in enumerate(element.ring.roots):
            inside = any(mask >> bit & 1 for mask in element.parts)
            if inside and name != "i" and name not in at.setting.coordinates:
                element = element * element.conjugate_root(bit)
        return element


def alternatives(goal: Follows, at: Evaluation) -> list[Element]:
    """What has to vanish: the products of one difference from each conclusion."""
    conclusions = [at.differences(one) for one in goal.conclusions]
    return [reduce(Element.__mul__, choice, at.ring.one) for choice in product(*conclusions)]


def combined(
    target: Element, known: Sequence[Element], main: Sequence[tuple[str, ...]]
) -> list[Element] | None:
    """Cofactors of the target; one over a cofactor where the one known element is a multiple."""
    row = cofactors(target, known, main) if known else None
    if row is None and len(known) == 1 and not target.is_zero:
        inverse = cofactors(known[0], [target], main)
        row = [inverse[0].inverse()] if inverse and not inverse[0].is_zero else None
    return row


def divisors(at: Evaluation, elements: Sequence[Element]) -> list[Element]:
    """What elements are divided by, each once."""
    indices = sorted({index for element in elements for index in element.denominator})
    return [Element(at.ring, {0: at.ring.divisors[index]}, {}) for index in indices]
