"""Whether all polynomials are known that a vector field multiplies by a factor.

The derivatives of the monomials up to a degree are vectors over the field of the rational functions
of the constants. Their rank is at least the one that their residues have modulo a prime at a point
of the constants; so is the rank of what is known to lie in the kernel. If the two add up to the
number of monomials, the kernel is spanned by what is known. Degrees are those over that field: at
the point, and modulo the prime, they can fall.
"""

from __future__ import annotations

from collections.abc import Iterator
from operator import mul

from .elimination import PRIME, rank
from .evidence import locate
from .formulas import Map
from .goals import Goal
from .polynomials import MASK, Element
from .reading import DEGREE, Json, Rejected, integer, items, need, record, say
from .spaces import Space

Residues = dict[int, int]  # by monomials in the variables


class Kernel(Goal):
    """The polynomials with D f = factor f, up to a degree, are combinations of known products."""

    KEYS = "factor solutions integrals weights degree"

    def __init__(self, space: Space, data: Json) -> None:
        self.space, self.ring = space, space.ring
        self.degree = integer(data["degree"], 0, DEGREE)
        weights = items(data["weights"], len(space.variables))
        self.weights = [integer(weight, 1, DEGREE) for weight in weights]
        with space.statement():
            self.factor = space.scalar(data["factor"])
            self.integrals = [space.scalar(tree) for tree in items(data["integrals"])]
            self.solutions = [space.scalar(tree) for tree in items(data["solutions"])]
        self.units = [self.ring.unit[name] for name in space.variables]
        self.constants = [(name, self.ring.unit[name]) for name in space.constants]

    def holds(self, evidence: Json) -> None:
        """At the point of the constants nothing is missing."""
        record(evidence, "point")
        at = locate(self.space, evidence["point"], [])
        columns = [*self._columns(at)]
        need(
            self._rank(columns) + self._rank(self._known_products(at)) == len(columns),
            "one may be missing",
        )

    def denied(self, evidence: Json) -> None:
        """One is missing, or what is listed is no solution."""
        record(evidence, "point", "further")
        at = locate(self.space, evidence["point"], [])
        if "further" not in evidence:
            rests = [self._rest(f, self.factor) for f in self.solutions]
            rests += [self.space.derivative(f) for f in self.integrals]
            need(any(at(rest).differs() for rest in rests), "all that is listed may be solutions")
            return
        degree, further = self._solution(self.space.scalar(evidence["further"]), self.factor, at)
        need(degree <= self.degree, "its degree is too large")
        vectors = [*self._known_products(at), further]
        need(self._rank(vectors) == len(vectors), "it may depend on what is known")

    # polynomials at the point

    def _residues(self, element: Element, at: Map) -> Residues:
        """A polynomial in the variables, at the point of the constants."""
        element = element.cleared()
        self.ring.spend(len(element.terms))
        need({*element.generators()} <= {*self.space.variables, *self.space.constants},
             "a root or a denominator is in the way")  # fmt: skip
        need(element.below % PRIME, "the prime divides a denominator")
        over, found = pow(element.below, -1, PRIME), Residues()
        values: dict[str, int] = {}
        for monomial, coefficient in element.terms.items():
            value = coefficient * over
            for name, unit in self.constants:
                if exponent := monomial >> self.ring.at[name] & MASK:
                    if name not in values:
                        values[name] = self._value(name, at)
                    value = value * pow(values[name], exponent, PRIME) % PRIME
                    monomial -= exponent * unit
            found[monomial] = (found.get(monomial, 0) + value) % PRIME
        return {monomial: value for monomial, value in found.items() if value}

    @staticmethod
    def _value(name: str, at: Map) -> int:
        value = at.images[name].value()
        if value is None or value.denominator % PRIME == 0:
            raise Rejected(f"{name} is not rational at the point")
        return value.numerator * pow(value.denominator, -1, PRIME)

    def _rest(self, element: Element, factor: Element) -> Element:
        return self.space.derivative(element) - factor * element

    def _solution(self, element: Element, factor: Element, at: Map) -> tuple[int, Residues]:
        """A polynomial f with D f = factor f: its degree, and what it is at the point.

        It may have been divided by constants.
        """
        need(self._rest(element, factor).vanishes(), "what is said to be known is no solution")
        value = element.numerator()
        below = self.ring.denominator(element.cleared().under).generators()
        need({*below} <= {*self.space.constants}, "it is no polynomial")
        return self._weight(value), self._residues(value, at)

    def _weight(self, element: Element) -> int:
        both = [
            *zip(self.weights, (self.ring.at[name] for name in self.space.variables), strict=True)
        ]
        weights = (sum(w * (m >> shift & MASK) for w, shift in both) for m in element.terms)
        return max(weights, default=0)

    def _known_products(self, at: Map) -> list[Residues]:
        """The products, up to the degree."""
        zero = self.ring.number(0)
        integrals = [self._solution(f, zero, at) for f in self.integrals]
        integrals = [integral for integral in integrals if integral[0] > 0]
        found = list[Residues]()
        waiting = [(*self._solution(f, self.factor, at), 0) for f in self.solutions]
        while waiting:
            degree, left, start = waiting.pop()
            if left and degree <= self.degree:
                found.append(left)
                for k, (more, one) in enumerate(integrals[start:], start):
                    if degree + more <= self.degree:
                        waiting.append((degree + more, self._product(left, one), k))
        return found

    def _product(self, left: Residues, right: Residues) -> Residues:
        self.ring.spend(len(left) * len(right))
        found = Residues()
        for a, u in left.items():
            for b, v in right.items():
                found[a + b] = (found.get(a + b, 0) + u * v) % PRIME
        return {monomial: value for monomial, value in found.items() if value}

    # the matrix

    def _columns(self, at: Map) -> Iterator[Residues]:
        """What the field, less the factor, makes of each monomial, times one common divisor."""
        self.ring.spend(10 * self._size())
        rates, factor = self._clear_denominators(at)
        steps = [
            [(m - unit, v) for m, v in rate.items()]
            for unit, rate in zip(self.units, rates, strict=True)
        ]
        minus = [(m, -v) for m, v in factor.items()]
        for exponents in self._exponents(len(self.units) - 1, self.degree):
            monomial = sum(map(mul, exponents, self.units))
            found = {monomial + step: v for step, v in minus}
            for e, parts in zip(exponents, steps, strict=True):
                for step, v in parts if e else ():
                    found[monomial + step] = found.get(monomial + step, 0) + e * v
            self.ring.spend(len(found))
            yield {m: rest for m, v in found.items() if (rest := v % PRIME)}

    def _clear_denominators(self, at: Map) -> tuple[list[Residues], Residues]:
        """The rates and the factor, times their common denominator."""
        ring, marks = self.ring, list[Element]()
        for k in range(len(self.units) + 1):
            if (mark := f":{k}") not in ring.at:
                ring.adjoin(mark)
            marks.append(ring.generator(mark))
        rates = [self.space.derivative(ring.generator(name)) for name in self.space.variables]
        parts = [mark * e for mark, e in zip(marks, [*rates, self.factor], strict=True)]
        whole = ring.total(parts).numerator()
        found = [
            self._residues(whole.split(f":{k}").get(1, ring.number(0)), at)
            for k in range(len(marks))
        ]
        return found[:-1], found[-1]

    def _size(self) -> int:
        """The number of monomials, before any of them is made."""
        self.ring.spend(len(self.weights) * self.degree)
        found = [1] * (self.degree + 1)  # up to each degree, in no variable yet
        for weight in self.weights:
            for degree in range(weight, self.degree + 1):
                found[degree] += found[degree - weight]
        return found[-1]

    def _exponents(self, last: int, degree: int) -> Iterator[tuple[int, ...]]:
        """The exponents of the variables up to the last one, up to a degree."""
        if last < 0:
            yield ()
            return
        weight = self.weights[last]
        for e in range(degree // weight + 1):
            if last:
                for rest in self._exponents(last - 1, degree - e * weight):
                    yield (*rest, e)
            else:
                yield (e,)

    def _rank(self, vectors: list[Residues]) -> int:
        return rank(vectors, self.ring.budget)

    @staticmethod
    def words(data: Json) -> str:
        solutions = ", ".join(map(say, data["solutions"]))
        parts = f"linear combinations of products of {solutions}" if solutions else "zero"
        if solutions and data["integrals"]:
            parts += f" with powers of {', '.join(map(say, data['integrals']))}"
        return (
            f"for almost all constants, the polynomials f with D(f) = {say(data['factor'])} * f of "
            f"degree {data['degree']} or less, by the weights {data['weights']}, are {parts}"
        )
