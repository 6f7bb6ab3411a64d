"""Polynomials of the checker, as sums of terms in which every quotient is a plain one."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction

from kowalevski_cas.proof import checker
from kowalevski_cas.proof.trees import Tree


@dataclass(frozen=True, slots=True)
class Term:
    """A coefficient, the powers of names, and what is divided by, as often as it is."""

    coefficient: Fraction
    powers: dict[str, int]
    under: tuple[Tree, ...]


class Elements:
    """How the elements of a space are written.

    What is divided by is a number, a variable, or a polynomial that is no monomial:
    ``1/x_1`` and ``1/x_2`` make ``1/(x_1 x_2)``. Each of these inverses is one new
    generator, with one relation to the rest, so that relations never compete.
    """

    def __init__(self, space: checker.Space) -> None:
        self.space = space

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
        if len(element.terms) == 1:
            ((monomial, value),) = element.terms.items()
            powers = self._powers(monomial)
            if powers.keys() <= {tree for _, tree in self.plain() if isinstance(tree, str)}:
                return [
                    self._term(Fraction(element.below, value), {n: -e for n, e in powers.items()})
                ]
        return self.terms(element.inverse())

    def plain(self) -> list[tuple[int, Tree]]:
        """What has a plain inverse, save a number: variables and polynomials that are no monomials.

        Each comes after the position of the condition by which it is not zero.
        """
        found: dict[str, tuple[int, Tree]] = {}
        for k, divisor in enumerate(self.space.divisors.values()):
            names = self._monomial(divisor)
            for tree in [self.space.nonzero[k]] if names is None else names:
                found.setdefault(str(tree), (k, tree))
        return list(found.values())

    def _term(self, value: Fraction, powers: dict[str, int]) -> Term:
        """A term, from powers that may be negative, or those of inverses in the space."""
        exponents, under = dict[str, int](), list[Tree]()
        for name, e in powers.items():
            if name not in self.space.divisors:
                exponents[name] = exponents.get(name, 0) + e
                continue
            divisor = self.space.divisors[name]
            if (names := self._monomial(divisor)) is None:
                under += [self.space.nonzero[list(self.space.divisors).index(name)]] * e
                continue
            (lead,) = divisor.terms.values()
            value /= Fraction(lead, divisor.below) ** e
            for other, k in names.items():
                exponents[other] = exponents.get(other, 0) - k * e
        under += [name for name, e in exponents.items() for _ in range(-e)]
        return Term(value, {n: e for n, e in exponents.items() if e > 0}, tuple(under))

    def _monomial(self, divisor: checker.Element) -> dict[str, int] | None:
        """The powers of variables in a divisor without sums; their inverses are known then."""
        if len(divisor.terms) > 1:
            return None
        powers = self._powers(next(iter(divisor.terms)))
        return None if any(name in self.space.divisors for name in powers) else powers

    def _powers(self, monomial: int) -> dict[str, int]:
        shifts = self.space.at.items()
        powers = ((name, monomial >> shift & checker.MASK) for name, shift in shifts)
        return {name: e for name, e in powers if e}


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
