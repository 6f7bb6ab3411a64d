"""Polynomials of the checker, as sums of terms in which every quotient is a plain one."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction

from kowalevski_cas.proof import checker
from kowalevski_cas.proof.trees import Tree


@dataclass(frozen=True)
class Term:
    """A coefficient, the powers of names, and what is divided by, as often as it is."""

    coefficient: Fraction
    powers: dict[str, int]
    under: tuple[Tree, ...]


@dataclass(frozen=True)
class Plain:
    """A variable or polynomial with a plain inverse.

    ``condition`` is the position of the condition by which it is not zero, since it is
    one of its factors, beside the ``cofactor``.
    """

    condition: int
    tree: Tree
    element: checker.Element
    cofactor: checker.Element


class Elements:
    """How the elements of a space are written.

    What is divided by is a number, a variable, or a polynomial that is no monomial:
    ``1/x_1`` and ``1/x_2`` make ``1/(x_1 x_2)``. Each of these inverses is one new
    generator, with one relation to the rest, so that relations never compete.
    """

    def __init__(self, space: checker.Space) -> None:
        self.space = space
        self.plain: list[Plain] = []
        for k, divisor in sorted(
            enumerate(space.divisors.values()), key=lambda kd: max(kd[1].terms)
        ):
            _, _, rest = self._factored(divisor)
            if len(rest.terms) > 1:
                tree = written(self.terms(rest)) if rest is not divisor else space.nonzero[k]
                self._add(k, tree, rest, divisor)
            else:
                for name in self._powers(max(rest.terms)):
                    self._add(k, name, space.generator(name), divisor)

    def _add(self, k: int, tree: Tree, element: checker.Element, divisor: checker.Element) -> None:
        cofactor = self._quotient(divisor, element)
        if cofactor is not None:
            self.plain.append(Plain(k, tree, element, cofactor))

    def terms(self, element: checker.Element) -> list[Term]:
        """The terms of an element."""
        return [
            self._term(Fraction(value, element.below), self._powers(monomial))
            for monomial, value in sorted(element.terms.items(), reverse=True)
        ]

    def inverse(self, element: checker.Element) -> list[Term]:
        """The terms of one over an element.

        Raises:
            Rejected: it may be zero.
        """
        value, powers, rest = self._factored(element)
        if rest.terms.keys() == {0}:
            return [_over(value, [(self.plain[k], e) for k, e in powers.items()], {})]
        return self.terms(element.inverse())

    def _factored(
        self, element: checker.Element
    ) -> tuple[Fraction, dict[int, int], checker.Element]:
        """A number and powers of what has plain inverses, and what is left without them."""
        powers: dict[int, int] = {}
        for k, plain in enumerate(self.plain):
            while (quotient := self._quotient(element, plain.element)) is not None:
                element, powers[k] = quotient, powers.get(k, 0) + 1
        value = Fraction(element.terms[0], element.below) if element.terms.keys() == {0} else 1
        return Fraction(value), powers, element

    def _quotient(self, top: checker.Element, below: checker.Element) -> checker.Element | None:
        """An exact quotient of polynomials, or none."""
        space, lead = self.space, max(below.terms)
        quotient, least = space.number(0), self._powers(lead)
        while top.terms:
            first = max(top.terms)
            powers = self._powers(first)
            if any(powers.get(name, 0) < e for name, e in least.items()):
                return None
            value = Fraction(top.terms[first], top.below) / Fraction(below.terms[lead], below.below)
            term = checker.Element(space, {first - lead: value.numerator}, value.denominator)
            quotient, top = quotient + term, top - term * below
        return quotient

    def _term(self, value: Fraction, powers: dict[str, int]) -> Term:
        """A term, from powers among which may be those of inverses in the space."""
        over: list[tuple[Plain, int]] = []
        for name, e in powers.items():
            if name in self.space.divisors:
                number, plain, _ = self._factored(self.space.divisors[name])
                value /= number**e
                over += [(self.plain[k], n * e) for k, n in plain.items()]
        return _over(
            1 / value, over, {n: e for n, e in powers.items() if n not in self.space.divisors}
        )

    def _powers(self, monomial: int) -> dict[str, int]:
        shifts = self.space.at.items()
        powers = ((name, monomial >> shift & checker.MASK) for name, shift in shifts)
        return {name: e for name, e in powers if e}


def _over(value: Fraction, over: Iterable[tuple[Plain, int]], powers: dict[str, int]) -> Term:
    """A term, divided by a number and by powers of what has plain inverses."""
    exponents, under = dict(powers), list[Tree]()
    for plain, e in over:
        if isinstance(plain.tree, str):
            exponents[plain.tree] = exponents.get(plain.tree, 0) - e
        else:
            under += [plain.tree] * e
    under += [name for name, e in exponents.items() for _ in range(-e)]
    return Term(1 / value, {n: e for n, e in exponents.items() if e > 0}, tuple(under))


def written(terms: Iterable[Term]) -> Tree:
    """A sum of terms as one writes it: ``c_1 w_1 / x_1``."""
    summands: list[Tree] = []
    for term in terms:
        top, below = abs(term.coefficient).as_integer_ratio()
        under = [*([below] if below != 1 else []), *term.under]
        product = _product(top, term)
        quotient = ["/", product, *under] if under else product
        summands.append(["-", quotient] if term.coefficient < 0 else quotient)
    return _sum(summands)


def undivided(terms: Iterable[Term], number: int) -> Tree:
    """A polynomial in names and plain inverses: ``c_1 w_1 (1/x_1)``.

    Numbers have the inverse of one number only, which has the primes of all denominators.
    """
    summands = []
    for term in terms:
        e, value = 0, term.coefficient
        while value.denominator != 1:
            e, value = e + 1, value * number
        inverses: list[Tree] = [["/", 1, tree] for tree in term.under]
        inverses += [_power(["/", 1, number], e)] if e else []
        summands.append(_product(int(value), term, inverses))
    return _sum(summands)


def number(terms: Iterable[Term]) -> int:
    """The product of the primes in the denominators of terms, as far as they are small."""
    found = 1
    for term in terms:
        rest = term.coefficient.denominator
        for prime in range(2, min(rest, 1000) + 1):
            if rest % prime == 0 and found % prime:
                found *= prime
            while rest % prime == 0:
                rest //= prime
        found *= rest
    return found


def _product(coefficient: int, term: Term, inverses: Iterable[Tree] = ()) -> Tree:
    factors: list[Tree] = [_power(name, e) for name, e in term.powers.items()]
    factors += inverses
    if abs(coefficient) != 1 or not factors:
        factors.insert(0, abs(coefficient))
    product = ["*", *factors] if len(factors) > 1 else factors[0]
    return ["-", product] if coefficient < 0 else product


def _power(tree: Tree, e: int) -> Tree:
    return tree if e == 1 else ["^", tree, e]


def _sum(summands: list[Tree]) -> Tree:
    return ["+", *summands] if len(summands) > 1 else summands[0] if summands else 0
