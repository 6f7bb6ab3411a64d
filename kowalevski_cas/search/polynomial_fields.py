"""Vector fields with polynomial components, as searches for what they leave invariant need them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from functools import cached_property
from math import gcd, lcm

from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.notation import Name
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.search.weights import whole_solutions

Exponents = tuple[int, ...]
Terms = dict[Exponents, Fraction]


class PolynomialField:
    """A vector field times the least factor that makes its components polynomials.

    What is constant along a field is so along its multiples. ``names`` are the variables, and
    then the constants, in whose order exponents are given; ``rates`` the components of variables.
    Raises :class:`Meaningless` if roots stand in the field.
    """

    def __init__(self, at: Evaluation) -> None:
        self.at = at
        variables, constants = at.setting.variables, at.setting.constants
        self.names = (*variables, *constants)
        self.size = len(variables)
        rates = [at.rates[name] if name in at.rates else at.ring.zero for name in variables]
        below: dict[int, int] = {}
        for rate in rates:
            if rate.parts.keys() - {0}:
                raise Meaningless("a root stands in the equations of motion")
            for index, exponent in rate.denominator.items():
                below[index] = max(exponent, below.get(index, 0))
        order = [at.ring.polynomials.generators.index(name) for name in self.names]
        self.rates: list[Terms] = []
        for rate in rates:
            missing = {k: n - rate.denominator.get(k, 0) for k, n in below.items()}
            product = at.ring.divisor_product(missing)
            factor = at.ring.one if product is None else Element(at.ring, {0: product}, {})
            terms = (Element(at.ring, rate.parts, {}) * factor).terms().get(0, {})
            self.rates.append({tuple(e[k] for k in order): v for e, v in terms.items()})

    def derivative(self, exponents: Exponents) -> Terms:
        """The derivative of a monomial along the field."""
        total: Terms = {}
        for k, rate in enumerate(self.rates):
            if not exponents[k]:
                continue
            for other, value in rate.items():
                key = tuple(
                    a + b - (j == k) for j, (a, b) in enumerate(zip(exponents, other, strict=True))
                )
                total[key] = total.get(key, Fraction(0)) + exponents[k] * value
        return {key: value for key, value in total.items() if value}

    def element(self, terms: Terms) -> Element:
        """A polynomial in the names as an element of the ring of the evaluation."""
        total = self.at.ring.zero
        for exponents, value in terms.items():
            product = self.at.ring.number(value)
            for name, exponent in zip(self.names, exponents, strict=True):
                if exponent:
                    product = product * self.at.scalar(Name(name)) ** exponent
            total = total + product
        return total

    @cached_property
    def gradings(self) -> list[Exponents]:
        """A basis of the weights of the names for which all components are homogeneous.

        The weight of a component is that of its variable, and one more number that is the same
        for all of them, the weight of one over the time; it stands last.
        """
        width = len(self.names) + 1
        rows = []
        for k, rate in enumerate(self.rates):
            for exponents in rate:
                row = [*exponents, -1]
                row[k] -= 1
                rows.append(row)
        return whole_solutions(rows, width)

    def grade(self, exponents: Exponents) -> Exponents:
        """The weights of a monomial in all gradings: the derivative keeps them together."""
        return tuple(
            sum(w * e for w, e in zip(weights[:-1], exponents, strict=True))
            for weights in self.gradings
        )


def monomials(weights: Sequence[int], weight: int) -> Iterator[Exponents]:
    """All exponents of names with these positive weights that have this weight together."""
    if not weights:
        if weight == 0:
            yield ()
        return
    for first in range(weight // weights[0], -1, -1):
        for rest in monomials(weights[1:], weight - first * weights[0]):
            yield (first, *rest)


def product_of(left: Terms, right: Terms) -> Terms:
    """The product of two polynomials."""
    total: Terms = {}
    for a, u in left.items():
        for b, v in right.items():
            key = tuple(i + j for i, j in zip(a, b, strict=True))
            total[key] = total.get(key, Fraction(0)) + u * v
    return {key: value for key, value in total.items() if value}


def primitive(terms: Terms) -> Terms:
    """The polynomial times the number that makes its coefficients whole and coprime."""
    below = lcm(*(value.denominator for value in terms.values()))
    above = gcd(*(value.numerator * (below // value.denominator) for value in terms.values()))
    sign = 1 if terms[max(terms)] > 0 else -1
    return {key: value * Fraction(sign * below, above) for key, value in terms.items()}


def weight_of(terms: Iterable[Exponents], weights: Sequence[int]) -> int:
    """The largest weight of a term, by the weights of the first names."""
    return max(sum(w * e for w, e in zip(weights, one, strict=False)) for one in terms)
