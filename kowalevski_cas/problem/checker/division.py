"""Division by what is known not to vanish.

A formula of a statement may divide by all that does not vanish identically: it is about the
points where its formulas are defined, and what it divides by becomes one more divisor that
is known not to vanish there. A formula of the evidence divides by known divisors only.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from fractions import Fraction
from functools import reduce
from math import gcd

from .polynomials import Element, Ring, Terms
from .reading import BITS, Json, Rejected, need, say


def primitive(element: Element) -> tuple[Fraction, Element]:
    """A number, and integers without a common factor, of which a polynomial is the product."""
    terms = element.terms
    common = gcd(*terms.values()) * (-1 if terms[max(terms)] < 0 else 1)
    rest = {m: c // common for m, c in terms.items()}
    return Fraction(common, element.below), Element(element.ring, rest, 1, element.bits)


def is_number(element: Element) -> bool:
    """Whether a fraction is a number wherever it is defined."""
    element = element.cleared()
    if not element.under:
        return element.value() is not None
    below = element.ring.denominator(element.under)
    return primitive(element)[1].terms == primitive(below)[1].terms


def quotient(element: Element, divisor: Element) -> Element | None:
    """A polynomial over a primitive one, if that is a polynomial; neither has roots."""
    ring = element.ring
    ring.spend(1 + (len(element.terms) + len(divisor.terms) >> 2))
    guard, first, last = ring.guard, max(divisor.terms), min(divisor.terms)
    degrees, divisor_degrees = (reduce(ring.larger, each.terms, 0) for each in (element, divisor))
    # in each generator the degrees of a quotient and of its divisor add up
    if element.terms and (degrees | guard) - divisor_degrees & guard != guard:
        return None
    rest, out, bits = dict(element.terms), Terms(), element.bits
    while rest:
        top, low = max(rest), min(rest)
        count, left = divmod(rest[top], divisor.terms[first])
        if left or ((top | guard) - first & (low | guard) - last & guard) != guard:
            return None
        bits = max(bits, count.bit_length())
        need(bits <= BITS, "a number is too large")
        ring.spend((len(divisor.terms) + len(rest)) * (1 + (count.bit_length() >> 6)))
        out[top - first] = count
        for m, c in divisor.terms.items():
            rest[m + top - first] = rest.get(m + top - first, 0) - count * c
            if not rest[m + top - first]:
                del rest[m + top - first]
    return Element(ring, out, element.below, bits)


def tree_of(element: Element) -> Json:
    """The formula of a polynomial of which no generator is an inverse."""
    ring, parts = element.ring, list[Json]()
    ring.spend(1 + (len(element.terms) * len(ring.at) >> 3))
    for m, c in sorted(element.terms.items(), reverse=True):
        powers = [name if e == 1 else ["^", name, e] for name, e in ring.exponents(m)]
        factors = powers if powers and abs(c) == 1 else [abs(c), *powers]
        part = factors[0] if len(factors) == 1 else ["*", *factors]
        parts.append(["-", part] if c < 0 else part)
    whole = parts[0] if len(parts) == 1 else ["+", *parts] if parts else 0
    return whole if element.below == 1 else ["/", whole, element.below]


class Divisors:
    """The inverses that are ``known``, generators of a ring, each with words for its divisor."""

    def __init__(self, ring: Ring) -> None:
        self.ring = ring
        self.stating = True
        self.known: dict[str, str] = {}
        self.entered = list[Element]()  # what does not vanish, and may be a factor of one of these
        self.norms = set[str]()  # may vanish where what was divided by does not
        self.implied = set[str]()  # known by what is taken for granted
        self.used = set[str]()  # the norms by which something is divided

    @contextmanager
    def statement(self, stating: bool = True) -> Iterator[None]:
        """Formulas that are read here belong to the statement, or do not."""
        before, self.stating = self.stating, stating
        yield
        self.stating = before

    def inverse(self, element: Element, words: str = "") -> Element:
        """One over the element; one that was found is there wherever its divisors are known.

        The words are for the case that a new divisor has to be entered.
        """
        element = element.cleared()
        self.ring.spend(len(element.terms))
        key = element.below, element.under, frozenset(element.terms.items())
        found = self.ring.inverses.get(key)
        if not found or not self._below(found) <= self.known.keys():
            found = self.ring.inverses[key] = self._inverse(element, words)
        self.used |= self._below(found) & self.norms
        return found

    def _below(self, element: Element) -> set[str]:
        """The divisors below an element."""
        return {*element.written()} & self.ring.divisors.keys()

    def _inverse(self, element: Element, words: str) -> Element:
        """What is below the element, and its other values, over its norm."""
        if (number := element.value()) is not None:
            need(number, "it divides by zero")
            return self.ring.number(1 / number)
        above, norm = element.numerator().normed()
        exact = above.value() is not None
        words = words if above.value() == 1 else ""
        need(norm.terms, "it divides by zero")
        parts = [above, *map(self.ring.denominator, (element.under, norm.under))]
        content, norm = primitive(norm)
        parts.append(self.ring.number(1 / content))
        for name in self.known:
            if norm.terms.keys() == {0}:
                break
            while (rest := quotient(norm, self.ring.divisors[name])) is not None:
                norm = rest
                parts.append(self.ring.generator(name))
        for factor in self.entered:
            while norm.value() is None and (rest := quotient(norm, factor)) is not None:
                norm = rest
                parts.append(self._part(factor, words, exact))
        if norm.value() is None:
            parts.append(self._part(norm, words, exact))
        return self.ring.product(parts)

    def _part(self, norm: Element, words: str, exact: bool) -> Element:
        """One over a polynomial that divides a known divisor, or becomes one."""
        for name in self.known:
            if (rest := quotient(self.ring.divisors[name], norm)) is not None:
                return rest * self.ring.generator(name)
        if not self.stating:
            raise Rejected(f"it divides by what may be zero: {say(tree_of(norm)):.200}")
        same = (n for n, divisor in self.ring.divisors.items() if divisor.terms == norm.terms)
        if not (name := next(same, "")):
            name = f"1/{len(self.ring.divisors)}"
            self.ring.adjoin(name)
            self.ring.invert(name, norm)
        self.known[name] = words or say(tree_of(norm))
        self.norms |= set() if exact else {name}
        return self.ring.generator(name)

    def enter(self, element: Element, words: str) -> None:
        """Know that an element does not vanish."""
        with self.statement():
            self.inverse(element, words)
        _, norm = element.numerator().normed()
        self.entered += [primitive(norm)[1]] if norm.value() is None else []

    @contextmanager
    def granting(self) -> Iterator[None]:
        """What is entered here is taken for granted; its norms are not used by that."""
        before, used = {*self.known}, {*self.used}
        yield
        self.implied, self.used = self.implied | (self.known.keys() - before), used

    def supposed(self) -> list[Element]:
        """What has to differ from zero, beside what is taken for granted."""
        implied = self.implied - self.used
        return [self.ring.divisors[name] for name in self.known if name not in implied]
