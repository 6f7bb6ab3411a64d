r"""Derivatives of a function until they close, and what is known of the equation that they obey.

If :math:`f^{(n)}=\sum_k c_kf^{(k)}`, the common zeros of :math:`f,f',\dots,f^{(n-1)}` are an
invariant set, as far as no :math:`c_k` is infinite there.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from math import comb

from kowalevski_cas.algebra.linear import determinant
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.search.cofactors import cofactors


@dataclass(frozen=True)
class Closure:
    """A function with its derivatives, and the next one as a combination of these, by a row."""

    at: Evaluation
    chain: tuple[Element, ...]
    row: tuple[Element, ...]

    @property
    def divided(self) -> bool:
        """Whether the row is divided by something that the motion and the function are not."""
        own = {index for element in self.chain for index in element.denominator}
        return any(entry.denominator.keys() - own for entry in self.row)

    @property
    def constant(self) -> bool:
        """Whether the equation of the function has constant coefficients."""
        return all(self._still(entry) for entry in self.row)

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
        found = self._of_constant_coefficients() if self.constant else self._of_power()
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

    def _still(self, element: Element) -> bool:
        return self.at.derivative(element).is_zero

    def _number(self, value: int | Fraction) -> Element:
        return self.at.ring.number(value)


def closures(at: Evaluation, seed: Element, order: int) -> Iterator[Closure]:
    """Where the derivatives of a function close, up to an order: the shortest chains first.

    The last one, if there is any, needs no condition; those before it do. What they are divided
    by has the least degree.
    """
    chain = [seed]
    for _ in range(order):
        after = at.derivative(chain[-1])
        row = cofactors(after, chain, ())
        if row is not None:
            closure = Closure(at, tuple(chain), tuple(row))
            yield closure
            if not closure.divided:
                return
        chain.append(after)
