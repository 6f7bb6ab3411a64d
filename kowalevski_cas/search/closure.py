r"""Derivatives of a function until they close, and what is known of the equation that they obey.

If :math:`f^{(n)}=\sum_k c_kf^{(k)}`, the common zeros of :math:`f,f',\dots,f^{(n-1)}` are an
invariant set, as far as no :math:`c_k` is infinite there.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import comb

from kowalevski_cas.algebra.derivation import gradient
from kowalevski_cas.algebra.linear import determinant
from kowalevski_cas.algebra.numbers import rank
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.evidence import Point
from kowalevski_cas.problem.place import PointEvaluation
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.search.combinations import cofactors_for
from kowalevski_cas.search.place import PointFinder


@dataclass(frozen=True)
class Closure:
    """A function with its derivatives, and the next one as a combination of these, by a row.

    At the real ``point`` they vanish, and the row is not divided by zero.
    """

    at: Evaluation
    chain: tuple[Element, ...]
    row: tuple[Element, ...]
    point: Point

    def is_regular(self) -> bool:
        """Whether the differentials of the chain are independent at the point."""
        names, there = self.at.setting.variables, PointEvaluation(self.at, self.point)
        rows = [[there(entry) for entry in gradient(element, names)] for element in self.chain]
        return rank(rows) == len(rows)

    def is_constant(self) -> bool:
        """Whether the equation of the function has constant coefficients."""
        return all(self.at.derivative(entry).is_zero for entry in self.row)

    def power(self) -> Element | None:
        r"""The q of :math:`y''=qy`, if the function obeys what products of its solutions do.

        It is the symmetric power of that equation: there are as many factors as its order is
        larger than one.
        """
        size = len(self.row)
        if size < 2 or not self.row[-1].is_zero:
            return None
        q = self.row[-2] * self._number(Fraction(1, comb(size + 1, 3)))
        *_, before, last = form = self._form(q)
        left = self.at.derivative(last) - self._number(len(form) - 1) * q * before
        return q if left.is_zero else None

    def integrals(self) -> Iterator[Element]:
        """What is constant by the form of the equation, if it does not vanish identically."""
        found = self._of_constant_coefficients() if self.is_constant() else self._of_power()
        yield from (element for element in found if not element.is_zero)

    def _of_constant_coefficients(self) -> Iterator[Element]:
        """A combination of derivatives, or the determinant of Hankel's matrix of them."""
        if self.row[0].is_zero:
            total = self.chain[-1]
            for entry, lower in zip(self.row[1:], self.chain, strict=False):
                total = total - entry * lower
            yield total
        elif self.row[-1].is_zero:
            size = len(self.row)
            chain = [*self.chain]
            while len(chain) < 2 * size - 1:
                chain.append(self.at.derivative(chain[-1]))
            yield determinant([chain[k : k + size] for k in range(size)])

    def _of_power(self) -> Iterator[Element]:
        """The quadratic invariant of the form of even degree that the function is a value of."""
        q, degree = self.power(), len(self.row) - 1
        if q is None or degree % 2:
            return
        form = self._form(q)
        total = self.at.ring.zero
        for k in range(degree + 1):
            number = self._number((-1) ** k * comb(degree, k))
            total = total + number * form[k] * form[degree - k]
        yield total

    def _form(self, q: Element) -> list[Element]:
        r"""The coefficients, without binomial ones, of a form by a solution and its derivative."""
        degree = len(self.row) - 1
        form = [self.chain[0]]
        for k in range(degree):
            rate = self.at.derivative(form[k])
            if k:
                rate = rate - self._number(k) * q * form[k - 1]
            form.append(rate * self._number(Fraction(1, degree - k)))
        return form

    def _number(self, value: int | Fraction) -> Element:
        return self.at.ring.number(value)


def closures(at: Evaluation, seed: Element, order: int) -> Iterator[Closure]:
    """Where the derivatives of a function close, up to an order.

    First comes the shortest chain, then those with a condition of lower degree, if it is longer.
    None follows after one that needs no condition. A chain without a real point is left out; where
    there is a condition, one in general position is looked for.

    Raises:
        Meaningless: if the function vanishes identically.
    """
    if seed.is_zero:
        raise Meaningless("the function vanishes identically: its zeros are no set")
    finder = PointFinder(lambda setting: at)
    chain, least = [seed], None
    for _ in range(order):
        after = at.derivative(chain[-1])
        row = cofactors_for(after, chain)
        degree = None if row is None else _degree(at, chain, row)
        if row is not None and degree is not None and (least is None or degree < least):
            point = finder.point(at, chain, [*at.law, *chain, *row], most=0 if degree else 2)
            if point is not None:
                least = degree
                yield Closure(at, tuple(chain), tuple(row), point)
        if degree == 0:
            return
        chain.append(after)


def _degree(at: Evaluation, chain: Sequence[Element], row: Sequence[Element]) -> int:
    """The degree of what a row is divided by, beyond what the motion and the function are.

    What the scene takes for granted not to vanish does not count.
    """
    granted = (element.inverse() for element in at.granted)
    own = {k for e in (*chain, *at.rates.values(), *granted) for k in e.denominator}
    found = {k for entry in row for k in entry.denominator} - own
    divisors = (at.ring.polynomials.terms(at.ring.divisors[k]) for k in found)
    return sum(max(map(sum, terms)) for terms in divisors)
