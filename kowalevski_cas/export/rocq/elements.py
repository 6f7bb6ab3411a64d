"""Polynomials of the checker, as sums of terms in which every quotient is a plain one."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction
from math import lcm, prod

from flint import fmpz

from kowalevski_cas.problem.checker import Element, Ring, quotient
from kowalevski_cas.problem.trees import Tree

SMALL = 168
"""So many primes, those below 1000, are looked for in denominators."""


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
    element: Element
    cofactor: Element


class Elements:
    """How the elements of a ring are written, where some of its divisors do not vanish.

    What is divided by is a number, a variable, or a polynomial that is no monomial:
    ``1/x_1`` and ``1/x_2`` make ``1/(x_1 x_2)``. Each of these inverses is one new
    generator, with one relation to the rest, so that relations never compete.
    """

    def __init__(self, ring: Ring, known: Iterable[str]) -> None:
        self.ring = ring
        self.conditions = [ring.divisors[name] for name in known]
        self.plain: list[Plain] = []
        for k, divisor in sorted(enumerate(self.conditions), key=lambda kd: max(kd[1].terms)):
            _, _, rest = self._factorisation(divisor)
            if len(rest.terms) > 1:
                self._add(k, sum_text(self.terms(rest)), rest)
            else:
                for name, _ in self.ring.exponents(max(rest.terms)):
                    self._add(k, name, ring.generator(name))

    def _add(self, k: int, tree: Tree, element: Element) -> None:
        cofactor = quotient(self.conditions[k], element)
        if cofactor is not None:
            self.plain.append(Plain(k, tree, element, cofactor))

    def terms(self, element: Element) -> list[Term]:
        """The terms of an element."""
        element = element.cleared()
        return [
            self._term(
                Fraction(value, element.below), dict(self.ring.exponents(monomial | element.under))
            )
            for monomial, value in sorted(element.terms.items(), reverse=True)
        ]

    def _factorisation(self, element: Element) -> tuple[Fraction, dict[int, int], Element]:
        """A number and powers of what has plain inverses, and what is left without them."""
        powers: dict[int, int] = {}
        for k, plain in enumerate(self.plain):
            while (rest := quotient(element, plain.element)) is not None:
                element, powers[k] = rest, powers.get(k, 0) + 1
        return element.value() or Fraction(1), powers, element

    def _term(self, value: Fraction, powers: dict[str, int]) -> Term:
        """A term, from powers among which may be those of inverses in the ring."""
        exponents, under = dict[str, int](), list[Tree]()
        for name, e in powers.items():
            if name not in self.ring.divisors:
                exponents[name] = exponents.get(name, 0) + e
                continue
            number, factors, _ = self._factorisation(self.ring.divisors[name])
            value /= number**e
            for k, n in factors.items():
                tree = self.plain[k].tree
                if isinstance(tree, str):
                    exponents[tree] = exponents.get(tree, 0) - n * e
                else:
                    under += [tree] * (n * e)
        under += [name for name, e in exponents.items() for _ in range(-e)]
        return Term(value, {n: e for n, e in exponents.items() if e > 0}, tuple(under))


def sum_text(terms: Iterable[Term]) -> Tree:
    """A sum of terms as one writes it: ``c_1 w_1 / x_1``."""
    summands: list[Tree] = []
    for term in terms:
        top, below = abs(term.coefficient).as_integer_ratio()
        under = [*([below] if below != 1 else []), *term.under]
        product = _product(top, term)
        quotient = ["/", product, *under] if under else product
        summands.append(["-", quotient] if term.coefficient < 0 else quotient)
    return _sum(summands)


def polynomial_text(terms: Iterable[Term], number: int) -> Tree:
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
    below = fmpz(lcm(*(term.coefficient.denominator for term in terms)))
    return prod(int(prime) for prime, _ in below.factor(trial_limit=SMALL))


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
