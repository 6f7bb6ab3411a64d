"""A stage at one point modulo a prime: quick to ask whether a formula can be true at all.

Nothing is proved here. It screens the many candidates for a correction: a
formula that does not vanish at the point is false, one that does is then
decided exactly.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from kowalevski_cas.arithmetic.polynomials import Terms
from kowalevski_cas.arithmetic.tower import Element
from kowalevski_cas.notation import Formula
from kowalevski_cas.stage.evaluate import StageError, Triple, Value, scalar
from kowalevski_cas.stage.stage import Stage

PRIME = 2**61 - 259
"""A prime that is 5 modulo 8: -1 has a square root, and roots are easy to take."""


class Jet:
    """A residue with its derivative along the field (``None`` where that is not known)."""

    __slots__ = ("rate", "value")

    def __init__(self, value: int, rate: int | None) -> None:
        self.value = value
        self.rate = rate

    @property
    def is_zero(self) -> bool:
        """Whether the residue vanishes."""
        return self.value == 0

    def __add__(self, other: Jet) -> Jet:
        known = self.rate is not None and other.rate is not None
        rate = (self.rate + other.rate) % PRIME if known else None  # type: ignore[operator]
        return Jet((self.value + other.value) % PRIME, rate)

    def __neg__(self) -> Jet:
        return Jet(-self.value % PRIME, None if self.rate is None else -self.rate % PRIME)

    def __sub__(self, other: Jet) -> Jet:
        return self + (-other)

    def __mul__(self, other: Jet) -> Jet:
        rate = None
        if self.rate is not None and other.rate is not None:
            rate = (self.value * other.rate + self.rate * other.value) % PRIME
        return Jet(self.value * other.value % PRIME, rate)

    def inverse(self) -> Jet:
        """One over the residue; raises ``ZeroDivisionError`` for zero."""
        if self.value == 0:
            raise ZeroDivisionError("division by zero at the point")
        inverse = pow(self.value, -1, PRIME)
        rate = None if self.rate is None else -self.rate * inverse * inverse % PRIME
        return Jet(inverse, rate)

    def __truediv__(self, other: Jet) -> Jet:
        return self * other.inverse()

    def __pow__(self, exponent: int) -> Jet:
        if exponent < 0:
            return self.inverse() ** -exponent
        result = Jet(1, 0)
        for _ in range(exponent):
            result = result * self
        return result


class _Residues:
    """What evaluation asks of a ring."""

    zero = Jet(0, 0)
    one = Jet(1, 0)

    @staticmethod
    def number(value: int | Fraction) -> Jet:
        value = Fraction(value)
        return Jet(value.numerator * pow(value.denominator, -1, PRIME) % PRIME, 0)


class ResidueStage(Stage):
    """The stage ``exact`` at a point modulo :data:`PRIME`, chosen by ``seed``.

    Values of subformulas are remembered, by identity, so that a formula that
    shares most of its tree with earlier ones costs little.
    """

    def __init__(self, exact: Stage, seed: int = 1) -> None:
        self.exact = exact
        self.scene = exact.scene
        self.texts = exact.texts
        self.ring = _Residues()  # type: ignore[assignment]
        self.half = self.ring.number(Fraction(1, 2))
        self.memory: dict[tuple[int, bool], tuple[Formula, Value]] = {}
        self._jets: dict[tuple[str, bool], Value] = {}
        self._generators, self._point_roots = _point(exact, seed)

    def jet(self, element: Element) -> Jet:
        """The value of an exact element and of its derivative at the point."""
        return Jet(self._residue(element), self._residue(self.exact.derivative(element)))

    def value(self, name: str, conjugated: bool = False) -> Value:
        key = (name, conjugated)
        if key not in self._jets:
            exact = self.exact.value(name, conjugated)
            # Jets stand for elements here: evaluation asks the same of both.
            jets: Any = self.jet(exact) if isinstance(exact, Element) else map(self.jet, exact)
            self._jets[key] = jets if isinstance(exact, Element) else Triple(jets)
        return self._jets[key]

    def derivative(self, element: Element) -> Element:
        jet: Jet = element  # type: ignore[assignment]
        if jet.rate is None:
            raise StageError("only first derivatives are screened")
        return Jet(jet.rate, None)  # type: ignore[return-value]

    def root(self, radicand: Formula, conjugated: bool = False) -> Element:
        value = scalar(radicand, self, conjugated)
        for square, root in self.exact.declared_roots():
            if (self.jet(square) - value).is_zero:  # type: ignore[operator]
                return self.jet(root)  # type: ignore[return-value]
        raise StageError("no root of this is declared")

    def symbolic_power(self, base: Formula, exponent: str) -> Element:
        return self.jet(self.exact.symbolic_power(base, exponent))  # type: ignore[return-value]

    def time_factor(self, mark: str, conjugated: bool) -> Element:
        return self.jet(self.exact.time_factor(mark, conjugated))  # type: ignore[return-value]

    def _residue(self, element: Element) -> int:
        total = _numerator(element, self._generators, self._point_roots)
        ring = element.ring
        for index, exponent in element.denominator.items():
            divisor = _evaluate(ring.polynomials.terms(ring.divisors[index]), self._generators)
            total = total * pow(divisor, -exponent, PRIME) % PRIME
        return total % PRIME


def _point(exact: Stage, seed: int) -> tuple[list[int], list[int]]:
    """Residues for the generators at which every radicand is a square, and the roots."""
    ring = exact.ring
    state = seed
    while True:
        generators = []
        for _ in ring.polynomials.generators:
            state = (state * 6364136223846793005 + 1442695040888963407) % 2**64
            generators.append(state % PRIME)
        roots: list[int] = []
        for radicand in ring.radicands:
            found = _square_root(_numerator(radicand, generators, roots))
            if found is None:
                break
            roots.append(found)
        else:
            return generators, roots


def _numerator(element: Element, generators: list[int], roots: list[int]) -> int:
    total = 0
    for mask, terms in element.terms().items():
        value = _evaluate(terms, generators)
        for bit, root in enumerate(roots):
            if mask >> bit & 1:
                value = value * root % PRIME
        total += value
    return total % PRIME


def _square_root(square: int) -> int | None:
    """A square root modulo a prime that is 5 modulo 8, if there is one."""
    root = pow(square, (PRIME + 3) // 8, PRIME)
    if root * root % PRIME != square:
        root = root * pow(2, (PRIME - 1) // 4, PRIME) % PRIME
    return root if root * root % PRIME == square else None


def _evaluate(terms: Terms, values: list[int]) -> int:
    total = 0
    for exponents, coefficient in terms.items():
        product = coefficient.numerator * pow(coefficient.denominator, -1, PRIME)
        for value, exponent in zip(values, exponents, strict=True):
            if exponent:
                product = product * pow(value, exponent, PRIME) % PRIME
        total += product
    return total % PRIME
