"""The number of real solutions of equations, by the roots of an eliminant."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import combinations
from math import prod

from .evidence import is_combination, locate, minors, numbers_of, squares_of
from .formulas import rational
from .goals import Goal
from .polynomials import Element
from .reading import Json, exponent, integer, items, labels, need, pairs, record, say_all
from .spaces import Space


class Count(Goal):
    """If equations have a real solution in some variables, they have so many, for all constants."""

    KEYS = "equations names number"

    def __init__(self, space: Space, data: Json) -> None:
        self.space, self.stated, self.names = space, data["number"], labels(data["names"])
        need(self.names and {*self.names} <= {*space.variables}, "what is counted are variables")
        need(space.all_real(), "what is counted has to be real")
        with space.statement():
            equations = space.differences(data["equations"])
        divisors = [space.ring.divisors[known].generators() for known in space.known]
        about = {name for generators in divisors for name in generators}
        need(not {*self.names} & about, "a condition is about what is counted")
        self.equations = [only(e, [*self.names, *space.constants]) for e in equations]

    def holds(self, evidence: Json) -> None:
        size = Solutions(self, evidence).number()
        need(size == self.stated, f"the number of solutions is {size}")

    def denied(self, evidence: Json) -> None:
        """There is one solution more for some constants, or another number for all."""
        if "points" not in evidence:
            size = Solutions(self, evidence).number()
            need(size != self.stated, "the number of solutions is as stated")
            return
        points = items(record(evidence, "points", "away")["points"], self.stated + 1)
        numbers = numbers_of(self.space, points)
        found = [locate(self.space, p, self.equations, numbers).images for p in points]
        others = {*self.space.variables, *self.space.constants} - {*self.names}
        for one, other in combinations(found, 2):
            same = all((one[name] - other[name]).vanishes() for name in others)
            need(same, "the points belong to different constants")
            apart = any((one[name] - other[name]).differs() for name in self.names)
            need(apart, "two points may be the same")

    @staticmethod
    def words(data: Json) -> str:
        names, number = ", ".join(data["names"]), data["number"]
        solutions = f"{number} real solution{'s' * (number != 1)} for {names}"
        return f"{say_all(data['equations'])} has exactly {solutions} if it has one"


def only(element: Element, names: Iterable[str]) -> Element:
    """An element, if nothing but some generators, and what is divided by them, is in it."""
    divisors = element.ring.divisors
    for name in element.generators():
        inside = divisors[name].generators() if name in divisors else [name]
        need({*inside} <= {*names}, "there is another name in a formula")
    return element


class Solutions:
    """Equations, and evidence that they have exactly so many real solutions.

    A form s in the variables obeys an eliminant, a polynomial over the constants, and determines
    the variables: solutions are roots. Each root gives a solution. By Hermite, all roots are
    real and distinct if the matrix of their power sums has positive leading minors.
    """

    def __init__(self, goal: Count, evidence: Json) -> None:
        keys = "point root form eliminant solved cofactors quotients factors minors"
        record(evidence, keys, "away")
        self.space = space = goal.space
        self.equations, self.evidence = goal.equations, evidence
        locate(space, evidence["point"], self.equations)
        self.form = only(space.scalar(evidence["form"]), [*goal.names, *space.constants])
        self.eliminant = [self.constant(tree) for tree in items(evidence["eliminant"])]
        need(self.eliminant, "there is no eliminant")
        solved = [items(row, 3) for row in items(evidence["solved"])]
        need([row[0] for row in solved] == goal.names, "the solved names are others")
        self.below = [self.constant(row[2]) for row in solved]
        self.root, self.generator = space.bind(evidence["root"])
        self.above = [self.polynomial(row[1]) for row in solved]
        self.own = [space.scalar(row[0]) for row in solved]

    def number(self) -> int:
        """How many solutions there are."""
        self.solutions_are_roots()
        self.roots_are_solutions()
        self.all_roots_are_real()
        return len(self.eliminant)

    def constant(self, tree: Json) -> Element:
        """The value of a formula in the constants."""
        return only(self.space.scalar(tree), self.space.constants)

    def polynomial(self, tree: Json) -> Element:
        """The value of a formula in the root and the constants."""
        return only(self.space.scalar(tree), [self.root, *self.space.constants])

    def value_of_eliminant(self, value: Element) -> Element:
        """The value of the eliminant."""
        terms = (c * value**k for k, c in enumerate(self.eliminant))
        return self.space.ring.total((*terms, value ** len(self.eliminant)))

    def put(self, element: Element, values: dict[str, Element]) -> Element:
        """An element with values for some generators."""
        generators = {name: self.space.ring.generator(name) for name in element.generators()}
        return self.space.carried(self.space.ring, generators | values)(element)

    def solutions_are_roots(self) -> None:
        """The equations imply the eliminant of the form, and give the variables by the form."""
        goals = [self.value_of_eliminant(self.form)]
        for own, above, below in zip(self.own, self.above, self.below, strict=True):
            goals.append(below * own - self.put(above, {self.root: self.form}))
        rows = items(self.evidence["cofactors"], len(goals))
        for goal, row in zip(goals, rows, strict=True):
            need(
                is_combination(self.space, goal, row, self.equations), "the two sides are not equal"
            )

    def roots_are_solutions(self) -> None:
        """The eliminant implies the equations, and that the form is the root."""
        inverses = map(self.space.inverse, self.below)
        solved = (above * inverse for above, inverse in zip(self.above, inverses, strict=True))
        names = [name for own in self.own for name in own.generators()]
        values = dict(zip(names, solved, strict=True))
        goals = [self.put(e, values) for e in (*self.equations, self.form)]
        goals[-1] = goals[-1] - self.generator
        quotients = items(self.evidence["quotients"], len(goals))
        for goal, tree in zip(goals, quotients, strict=True):
            rest = goal - self.polynomial(tree) * self.value_of_eliminant(self.generator)
            need(rest.vanishes(), "a root of the eliminant is no solution")

    def all_roots_are_real(self) -> None:
        """The leading minors of the matrix of power sums are products of positive factors."""
        factors = [self.positive(data) for data in items(self.evidence["factors"])]
        sums, size = self.power_sums(), len(self.eliminant)
        rows = [items(row, 2) for row in items(self.evidence["minors"], size)]
        for k, (tree, exponents) in enumerate(rows, 1):
            (minor,) = minors(self.space.ring, [sums[j : j + k] for j in range(k)])
            need((number := rational(self.space, tree)) > 0, "a minor is not positive")
            powers = map(exponent, items(exponents, len(factors)))
            parts = (factor**e for factor, e in zip(factors, powers, strict=True))
            whole = prod(parts, start=self.space.ring.number(number))
            need((minor - whole).vanishes(), "a minor is another product")

    def positive(self, data: Json) -> Element:
        """A factor over the constants that is positive wherever there is a solution."""
        record(data, "factor squares", "cofactors granted")
        factor = self.constant(data["factor"])
        rest = factor - squares_of(self.space, data["squares"])
        row = data.get("cofactors", [])
        need(is_combination(self.space, rest, row, self.equations), "a factor is no sum of squares")
        over = self.space.inverse(factor)
        if "granted" in data:  # where the factor vanishes, something granted would
            place, row = items(data["granted"], 2)
            granted = self.space.data.get("nonzero", [])
            gone = self.space.scalar(granted[integer(place, 0, len(granted) - 1)])
            bases = [self.space.scalar(base) for _, base in pairs(data["squares"])]
            same = is_combination(self.space, gone, row, [*bases, *self.equations])
            need(same, "what is granted need not vanish with a factor")
            self.space.implied |= {*over.generators()} & self.space.known.keys()
        return factor

    def power_sums(self) -> list[Element]:
        """The sums of the powers of all roots, by Newton's identities."""
        ring, size = self.space.ring, len(self.eliminant)
        signed, sums = [-c for c in reversed(self.eliminant)], [ring.number(size)]
        for k in range(1, 2 * size - 1):
            parts = [signed[j - 1] * sums[k - j] for j in range(1, min(k - 1, size) + 1)]
            parts += [signed[k - 1] * ring.number(k)] if k <= size else []
            sums.append(ring.total(parts))
        return sums
