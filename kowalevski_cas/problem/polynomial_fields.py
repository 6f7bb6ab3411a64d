"""Vector fields with polynomial components, as searches for what they leave invariant need them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import cached_property
from itertools import product
from math import comb
from operator import add, mul

from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.algebra.weights import whole_solutions
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.space import Meaningless

Exponents = tuple[int, ...]
Terms = dict[Exponents, Fraction]


class PolynomialField:
    """A vector field times the least factor that makes its components polynomials.

    What is constant along a field is so along its multiples. ``names`` are the variables, and
    then the constants, in whose order exponents are given; ``rates`` the components of variables,
    and ``factor`` an element that is multiplied likewise.
    Raises :class:`Meaningless` if roots stand in the field.
    """

    def __init__(self, at: Evaluation, factor: Element | None = None) -> None:
        self.at = at
        variables, constants = at.setting.own_variables, at.setting.constants
        self.names = (*variables, *constants)
        self.size = len(variables)
        rates = [at.rates[name] if name in at.rates else at.ring.zero for name in variables]
        below: dict[int, int] = {}
        for rate in (*rates, factor or at.ring.zero):
            for index, exponent in rate.denominator.items():
                below[index] = max(exponent, below.get(index, 0))
        self.multiple = at.ring.one
        """The least factor."""
        if (divisor := at.ring.divisor_product(below)) is not None:
            self.multiple = Element(at.ring, {0: divisor}, {})
        self.rates = [self._times(rate, below) for rate in rates]
        self.factor = self._times(factor or at.ring.zero, below)

    def polynomial(self, element: Element) -> Terms:
        """An element times what it divides by, which no variable stands in."""
        ring = self.at.ring
        moving = {ring.polynomials.generators.index(name) for name in self.names[: self.size]}
        for index in element.denominator:
            if not moving.isdisjoint(ring.polynomials.occurring_places(ring.divisors[index])):
                raise Meaningless("a variable stands below the line")
        return self._times(element, element.denominator)

    def _times(self, element: Element, below: Mapping[int, int]) -> Terms:
        """An element times powers of divisors that make a polynomial of it."""
        ring = self.at.ring
        if element.parts.keys() - {0}:
            raise Meaningless("a root stands in the equations of motion")
        missing = {k: n - element.denominator.get(k, 0) for k, n in below.items()}
        product = ring.divisor_product(missing)
        factor = ring.one if product is None else Element(ring, {0: product}, {})
        terms = (Element(ring, element.parts, {}) * factor).terms().get(0, {})
        order = [ring.polynomials.generators.index(name) for name in self.names]
        if any(sum(e) != sum(e[k] for k in order) for e in terms):
            raise Meaningless("a power stands in the equations of motion")
        return {tuple(e[k] for k in order): v for e, v in terms.items()}

    def derivative(self, exponents: Exponents) -> Terms:
        """The derivative of a monomial along the field, less the factor times the monomial."""
        return derivative(exponents, self.rates, self.factor)

    def element(self, terms: Terms) -> Element:
        """A polynomial in the names as an element of the ring of the evaluation."""
        generators = self.at.ring.polynomials.generators
        order = [self.names.index(name) if name in self.names else -1 for name in generators]
        padded = (((*e, 0), value) for e, value in terms.items())  # no power stands in it
        return self.at.ring.from_terms({0: {tuple(e[k] for k in order): v for e, v in padded}})

    @cached_property
    def gradings(self) -> list[Exponents]:
        """A basis of the weights of the names for which all components are homogeneous.

        The weight of a component is that of its variable, and one more number that is the same
        for all of them, the weight of one over the time; it stands last.
        """
        return self._gradings(len(self.names))

    @cached_property
    def weights(self) -> list[Exponents]:
        """A basis of the weights of the variables, where constants have the weight 0."""
        return [weights[:-1] for weights in self._gradings(self.size)]

    @property
    def positive_weights(self) -> Exponents | None:
        """The smallest positive weights of the variables, if there are any with small factors."""
        found = []
        for factors in product(range(-2, 3), repeat=min(len(self.weights), 4)):
            columns = zip(*self.weights, strict=True)
            weights = tuple(sum(map(mul, factors, column)) for column in columns)
            if all(weight > 0 for weight in weights):
                found.append(weights)
        return min(found, key=lambda weights: (sum(weights), weights), default=None)

    def _gradings(self, width: int) -> list[Exponents]:
        """The weights of the first names, and of one over the time."""
        rows = []
        for k, rate in enumerate(self.rates):
            for exponents in rate:
                row = [*exponents[:width], -1]
                row[k] -= 1
                rows.append(row)
        rows += ([*exponents[:width], -1] for exponents in self.factor)
        return whole_solutions(rows, width + 1)

    def grade(self, exponents: Exponents) -> Exponents:
        """The weights of a monomial in all gradings: the derivative keeps them together."""
        return tuple(
            sum(w * e for w, e in zip(weights[:-1], exponents, strict=True))
            for weights in self.gradings
        )


def derivative(exponents: Exponents, rates: Sequence[Terms], factor: Terms) -> Terms:
    """The derivative of a monomial if variables have these rates, less a multiple of it."""
    total: Terms = {tuple(map(add, exponents, other)): -value for other, value in factor.items()}
    for k, rate in enumerate(rates):
        if not exponents[k]:
            continue
        lower = (*exponents[:k], exponents[k] - 1, *exponents[k + 1 :])
        for other, value in rate.items():
            key, more = tuple(map(add, lower, other)), exponents[k] * value
            total[key] = total[key] + more if key in total else more
    return {key: value for key, value in total.items() if value}


def monomials(weights: Sequence[int], weight: int) -> Iterator[Exponents]:
    """All exponents of names with these positive weights that have this weight together."""
    match weights:
        case []:
            yield from () if weight else ((),)
        case [last]:
            yield from () if weight % last else ((weight // last,),)
        case [first, *others]:
            for power in range(weight // first, -1, -1):
                for rest in monomials(others, weight - power * first):
                    yield (power, *rest)


def number_of_monomials(weights: Sequence[int], weight: int) -> int:
    """How many monomials have at most this weight."""
    if all(w == 1 for w in weights):
        return comb(len(weights) + weight, weight)
    counts = [1] * (weight + 1)
    for one in weights:
        for k in range(one, weight + 1):
            counts[k] += counts[k - one]
    return counts[weight]


def weight_of(terms: Iterable[Exponents], weights: Sequence[int]) -> int:
    """The largest weight of a term, by the weights of the first names; 0 if there is none."""
    sums = (sum(w * e for w, e in zip(weights, term, strict=False)) for term in terms)
    return max(sums, default=0)
