"""The ring of the checker beside a second one: FLINT's polynomials, where its operations are done anew.

An element is a fraction there. Inverses are put in, and even powers of roots only when two fractions
are compared: none of the checker's reductions is done again in its way.
"""

from contextlib import contextmanager
from math import prod
from unittest.mock import patch

from flint import Ordering, fmpq, fmpq_mpoly_ctx

from kowalevski_cas.problem.checker.polynomials import WIDTH, Element, Ring

FIRST, THEN = 200, 50
"""How many operations of a check are compared from the beginning, and each how many behind."""


class SecondRing:
    """FLINT's polynomials in the generators of a ring of the checker."""

    def __init__(self, ring):
        self.ring, self.names = ring, [*ring.names]
        self.polynomials = fmpq_mpoly_ctx.get(
            [f"g{k}" for k in range(len(self.names))] or ["g"], Ordering.lex
        )
        self.one = self.polynomials.constant(1)

    def generator(self, name):
        return self.polynomials.gen(self.names.index(name))

    def polynomial(self, terms, below=1):
        """A polynomial from the terms of an element, read by themselves."""
        places = range(len(self.names) or 1)
        data = {
            tuple(monomial >> WIDTH * (k + 1) & (1 << WIDTH) - 1 for k in places): fmpq(c, below)
            for monomial, c in terms.items()
        }
        return self.polynomials.from_dict(data)

    def fraction(self, element):
        """An element as a fraction without inverses."""
        above, below = self.polynomial(element.terms, element.below), self.one
        for k, name in enumerate(self.names):
            under = element.under >> WIDTH * (k + 1) & (1 << WIDTH) - 1
            by_power = {}
            for exponents, c in above.to_dict().items() if name in self.ring.divisors else ():
                rest = (*exponents[:k], 0, *exponents[k + 1 :])
                by_power.setdefault(under + exponents[k], {})[rest] = c
            if most := max(by_power, default=0):
                a, b = self.fraction(self.ring.divisors[name])
                parts = ((self.polynomials.from_dict(t), e) for e, t in by_power.items())
                above = sum((p * b**e * a ** (most - e) for p, e in parts), start=self.one * 0)
                below *= a**most
        return above, below

    def vanishes(self, polynomial):
        """Whether a polynomial is zero by what the roots are."""
        for name in reversed(self.ring.roots):
            place = self.names.index(name)
            by_power = {}
            for exponents, c in polynomial.to_dict().items():
                rest = (*exponents[:place], 0, *exponents[place + 1 :])
                by_power.setdefault(exponents[place], {})[rest] = c
            above, below = self.fraction(self.ring.roots[name])
            most = max(by_power, default=0) // 2
            polynomial = self.polynomials.constant(0)
            for power, terms in by_power.items():
                even = above ** (power // 2) * below ** (most - power // 2)
                odd = self.generator(name) if power % 2 else self.one
                polynomial += self.polynomials.from_dict(terms) * even * odd
            # it is a + b r now, and zero if both are: other roots are put in next in both of them
        return not polynomial

    def agrees(self, element, above, below):
        a, b = self.fraction(element)
        return self.vanishes(a * below - above * b)

    # -- what the operations of the checker should give ----------------------------------

    def times(self, found, one, other):
        (a, b), (c, d) = map(self.fraction, (one, other))
        return self.agrees(found, a * c, b * d)

    def combination(self, found, _, parts, below=1):
        fractions = [(count, *self.fraction(element)) for count, element in parts]
        common = prod((b for _, _, b in fractions), start=self.one)
        above = sum((count * a * (common / b) for count, a, b in fractions), start=self.one * 0)
        return self.agrees(found, above, common * below)

    def partial(self, found, element, name):
        """The inverses are generators like others here."""
        before, after = (
            self.polynomial(e.terms, e.below)
            * prod(
                (self.generator(n) ** k for n, k in self.ring.exponents(e.under)), start=self.one
            )
            for e in (element, found)
        )
        return before.derivative(self.names.index(name)) == after


class Compared:
    """How many operations there were, and how many of them were compared."""

    def __init__(self, first, then):
        self.first, self.then = first, then
        self.done = self.asked = 0
        self._rings, self._is_busy = {}, False

    def second(self, ring):
        key = id(ring), len(ring.names), len(ring.roots), len(ring.divisors)
        if key not in self._rings:
            self._rings[key] = SecondRing(ring)  # which keeps the first: its id is not given again
        return self._rings[key]

    def beside(self, owner, name):
        """The operation of this name, which is compared with that of the second ring."""
        operation = getattr(owner, name)

        def both(this, *arguments):
            found = operation(this, *arguments)
            if not self._is_busy:
                self.done += 1
                if self.done <= self.first or self.done % self.then == 0:
                    self.compare(name, found, this, *arguments)
            return found

        return both

    def compare(self, name, found, this, *arguments):
        self._is_busy = True
        try:
            self.asked += 1
            there = self.second(this if isinstance(this, Ring) else this.ring)
            assert getattr(there, name)(found, this, *arguments), f"{name} is another one in FLINT"
        finally:
            self._is_busy = False


@contextmanager
def compared(first=FIRST, then=THEN):
    """Compare operations of the checker with those of a second ring."""
    both = Compared(first, then)
    times = both.beside(Element, "times")
    with (
        patch.object(Element, "times", times),
        patch.object(Element, "__mul__", times),
        patch.object(Element, "partial", both.beside(Element, "partial")),
        patch.object(Ring, "combination", both.beside(Ring, "combination")),
    ):
        yield both
