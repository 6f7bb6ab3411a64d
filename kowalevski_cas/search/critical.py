r"""Critical points along a surface: which equations define them, in both directions.

Weights of the variables are found under which the equations of the set and the surface g = v
are homogeneous, and the function is made homogeneous by powers of g/v, which is 1 there. On the
surface the derivatives :math:`g_i\partial_j-g_j\partial_i`, and :math:`\partial_i` where g is
free of the variable, do not see these powers.

*Forward*: the homogeneous function is a combination of products of two of the equations, so
that its derivatives vanish with them.

*Converse*: a tree of cases. Its targets are the derivatives along the surface and the
combinations of them along the gradients, and the cross product of the gradients, of the
equations in the variables of which the surface is free.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import combinations, combinations_with_replacement, permutations
from operator import mul

from kowalevski_cas.algebra.derivation import gradient
from kowalevski_cas.algebra.numbers import rational
from kowalevski_cas.algebra.polynomials import Terms
from kowalevski_cas.algebra.present import written
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.algebra.weights import weights
from kowalevski_cas.notation import Formula
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.evidence import At, Evidence, Point, Proof, Shown
from kowalevski_cas.problem.space import Equation
from kowalevski_cas.search.cases import Row, Splitter
from kowalevski_cas.search.cofactors import cofactors
from kowalevski_cas.search.place import Candidate, Good, PointFinder

PYTHAGOREAN = Fraction(3, 5)


class Critical:
    """The critical points of ``function`` on the surface ``level``, and ``equations`` of a set.

    ``granted`` are expressions that are assumed not to vanish; with ``zero_level`` the function
    is to vanish, too. ``names`` are those to which a point gives values.
    """

    def __init__(
        self,
        at: Evaluation,
        function: Formula,
        level: Equation,
        equations: Sequence[Equation],
        granted: Sequence[Formula],
        zero_level: bool,
        names: Sequence[str],
    ) -> None:
        self.at, self.zero_level = at, zero_level
        self.finder = PointFinder(lambda setting: at, lambda setting: names)
        self.variables = at.setting.variables
        self.function = at.scalar(function)
        self.level, self.value = (at.scalar(side) for side in level)
        self.beside = self.level - self.value
        self.goals = at.differences(equations)
        self.granted = [*map(at.scalar, granted), self.level]
        self.slopes = gradient(self.level, self.variables)

    # -- the two directions ----------------------------------------------------------

    def forward(self, main: Sequence[tuple[str, ...]]) -> Shown | None:
        """The derivatives vanish on the set: they are combinations of its equations."""
        homogeneous = self._homogeneous()
        if homogeneous is None:
            return None
        pairs = [a * b for a, b in combinations_with_replacement(self.goals, 2)]
        row = cofactors(homogeneous, pairs, main)
        excess = self._excess(homogeneous)
        point = self._point_of_the_set()
        if row is None or excess is None or point is None:
            return None
        zero = self.at.ring.zero
        rows = [[zero] * len(self.goals) for _ in excess]
        places = combinations_with_replacement(range(len(self.goals)), 2)
        slopes = [self._derivatives(goal) for goal in self.goals]
        for factor, (i, j) in zip(row, places, strict=True):
            for k, change in enumerate(self._derivatives(factor)):
                rows[k][j] = rows[k][j] + change * self.goals[i] + factor * slopes[i][k]
                rows[k][i] = rows[k][i] + factor * slopes[j][k]
            if self.zero_level:
                rows[-1][j] = rows[-1][j] + factor * self.goals[i]
        whole = [[*entries, -e] for entries, e in zip(rows, excess, strict=True)]
        return Shown(Proof(written(whole)), point)

    def converse(self) -> Evidence | None:
        """Critical points lie on the set: a proof by cases; or a point of an open case."""
        homogeneous = self._homogeneous()
        if homogeneous is None:
            return None
        excess = self._excess(homogeneous)
        if excess is None:
            return None
        targets, rows = self._targets(homogeneous), self._rows(excess)
        splitter = Splitter(targets, self.goals, self.granted, rows, len(excess), self.value)
        proof = splitter.proof(len(excess) + 1)
        if splitter.open:
            point = self._point_off_the_set(splitter.open)
            return None if point is None else At(point)
        point = self._point_of_the_set()
        return None if point is None or proof is None else Shown(proof, point)

    # -- the function and its derivatives ------------------------------------------------

    def _homogeneous(self) -> Element | None:
        """The function made homogeneous; ``None`` if that is impossible."""
        terms = [element.terms().get(0, {}) for element in (*self.goals, self.level)]
        found = weights(terms)
        if found is None or not rational(self.value) or self.function.denominator:
            return None
        parts: dict[int, Terms] = {}
        for exponents, coefficient in self.function.terms().get(0, {}).items():
            weight = sum(e * w for e, w in zip(exponents, found, strict=True))
            parts.setdefault(weight, {})[exponents] = coefficient
        (unit,) = {sum(e * w for e, w in zip(m, found, strict=True)) for m in terms[-1]}
        ratio = self.level * self.value.inverse()
        total = self.at.ring.zero
        for weight, part in parts.items():
            power, rest = divmod(max(parts) - weight, unit)
            if rest:
                return None
            total = total + self.at.ring.from_terms({0: part}) * ratio**power
        return total

    def _derivatives(self, function: Element) -> Row:
        """The derivatives along a frame of tangent fields, those free of the level first."""
        partial = gradient(function, self.variables)
        on = [k for k, slope in enumerate(self.slopes) if not slope.is_zero]
        free = [partial[k] for k in range(len(self.variables)) if k not in on]
        return free + [
            self.slopes[i] * partial[j] - self.slopes[j] * partial[i]
            for i, j in combinations(on, 2)
        ]

    def _rates(self, function: Element) -> Row:
        """The derivatives along the surface; the function as well, if its zeros are meant."""
        rates = self._derivatives(function)
        return [*rates, function] if self.zero_level else rates

    def _excess(self, homogeneous: Element) -> Row | None:
        """By how much the rates of the homogeneous function differ, over that of the surface."""
        found = []
        pairs = zip(self._rates(self.function), self._rates(homogeneous), strict=True)
        for own, other in pairs:
            difference = other - own
            part = difference.parts.get(0, self.at.ring.polynomials.zero)
            quotient, rest = divmod(part, self.beside.parts[0])
            if rest or difference.denominator:
                return None
            found.append(self.at.ring.element({0: quotient}, {}))
        return found

    def _fields(self) -> list[Row]:
        """Gradients of the equations, and their cross products, in the variables that are free."""
        names = zip(self.variables, self.slopes, strict=True)
        free = tuple(name for name, slope in names if slope.is_zero)
        fields = [gradient(goal, free) for goal in self.goals]
        if len(free) == 3:
            fields += [
                [a[i] * b[j] - a[j] * b[i] for i, j in ((1, 2), (2, 0), (0, 1))]
                for a, b in combinations(fields, 2)
            ]
        return fields

    def _targets(self, homogeneous: Element) -> Row:
        """The critical equations and consequences of them."""
        critical = self._derivatives(homogeneous)
        along = (sum(map(mul, field, critical), self.at.ring.zero) for field in self._fields())
        targets = [*critical, *along]
        return [*targets, homogeneous] if self.zero_level else targets

    def _rows(self, excess: Row) -> list[Row]:
        """The targets of the tree of cases, as combinations of the rates and the surface."""
        ring, size = self.at.ring, len(excess)
        rates = [
            [*(ring.one if k == j else ring.zero for j in range(size)), more]
            for k, more in enumerate(excess)
        ]
        fields = []
        for field in self._fields():
            row = [ring.zero] * (size + 1)
            for component, rate in zip(field, rates[: len(field)], strict=True):
                row = [a + component * b for a, b in zip(row, rate, strict=True)]
            fields.append(row)
        count = size - self.zero_level
        return [*rates[:count], *fields, *rates[count:]]

    # -- points ------------------------------------------------------------------------

    def _point_of_the_set(self) -> Point | None:
        """A point of the set, on the surface, where what is granted does not vanish."""
        zero = [*self.goals, self.beside]
        points = (self._point([*zero, *plane]) for plane in self._planes())
        return next(filter(None, points), None)

    def _planes(self) -> Iterator[list[Element]]:
        """Planes that a quadric meets in rational points: a coordinate 0, another one 3/5."""
        ring = self.at.ring
        on = [n for n, s in zip(self.variables, self.slopes, strict=True) if not s.is_zero]
        for first, second in permutations(on, 2):
            yield [ring.generator(first), ring.generator(second) - ring.number(PYTHAGOREAN)]
        yield []

    def _point_off_the_set(self, cases: Sequence[Row]) -> Point | None:
        """A critical point where an equation of the set fails, in one of the open cases."""
        critical = self._rates(self.function)

        def good(candidate: Candidate) -> bool:
            return candidate.vanish(critical) and not candidate.vanish(self.goals)

        in_order = sorted(cases, key=lambda one: sum(len(e.parts[0]) for e in one))
        points = (self._point([*known, self.beside], good) for known in in_order)
        return next(filter(None, points), None)

    def _point(self, zero: Row, good: Good = lambda candidate: True) -> Point | None:
        divided = [granted.inverse() for granted in self.granted]
        return self.finder.point(self.at, zero, divided, good, most=0)
