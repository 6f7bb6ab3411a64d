r"""Printed formulas as functions of numbers: what an exact arithmetic read, as Python source.

A formula is evaluated once on its scene, exactly; the element that comes out is
written as an expression in ``+``, ``-``, ``*``, ``/``. So the function takes whatever
has these operations: floats, NumPy arrays, balls, symbols of another library.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from typing import Any

from kowalevski_cas.algebra.polynomials import Terms
from kowalevski_cas.algebra.tower import Element

Function = Callable[..., tuple[Any, ...]]


def function(elements: Sequence[Element], arguments: Sequence[str]) -> Function:
    r"""The function of ``arguments`` whose values are the elements.

    ``arguments`` are generators or roots of the elements' ring; each element may use
    no others. Products of two or more arguments that occur again are computed once.

    >>> from kowalevski_cas.algebra import load
    >>> from kowalevski_cas.algebra.tower import Ring
    >>> ring = Ring(load("flint")(("x", "y")))
    >>> x, y = ring.generator("x"), ring.generator("y")
    >>> function([x * x / y, x - y], ["x", "y"])(3.0, 2.0)
    (4.5, 1.0)
    """
    writer = _CodeWriter({name: f"v{index}" for index, name in enumerate(arguments)})
    results = [writer.element(element) for element in elements]
    names = ", ".join(writer.names.values())
    lines = [f"def compiled({names}):", *writer.lines, f"    return ({', '.join(results)},)"]
    space: dict[str, Any] = {}
    exec("\n".join(lines), {"__builtins__": {}}, space)
    compiled: Function = space["compiled"]
    return compiled


class _CodeWriter:
    """Python source for elements; ``lines`` holds the products that are used again."""

    def __init__(self, names: dict[str, str]) -> None:
        self.names = names
        self.lines: list[str] = []
        self._products: dict[tuple[str, ...], str] = {}

    def element(self, element: Element) -> str:
        ring = element.ring
        terms = [
            (coefficient, [*self._factors(ring.polynomials.generators, exponents), *roots])
            for mask, polynomial in element.terms().items()
            for roots in [[self.names[n] for k, n in enumerate(ring.roots) if mask >> k & 1]]
            for exponents, coefficient in polynomial.items()
        ]
        above = self._sum(terms)
        below = [
            self._polynomial(ring.polynomials.terms(ring.divisors[k]), ring.polynomials.generators)
            for k, exponent in sorted(element.denominator.items())
            for _ in range(exponent)
        ]
        return f"({above})/({'*'.join(f'({b})' for b in below)})" if below else above

    def _polynomial(self, terms: Terms, generators: tuple[str, ...]) -> str:
        return self._sum([(c, list(self._factors(generators, e))) for e, c in terms.items()])

    def _factors(self, generators: Sequence[str], exponents: Sequence[int]) -> Iterator[str]:
        for name, exponent in zip(generators, exponents, strict=True):
            yield from [self.names[name]] * exponent if exponent else ()

    def _sum(self, terms: list[tuple[Fraction, list[str]]]) -> str:
        """A sum of products; a common coefficient is written once."""
        if not terms:
            return "0"
        scales = {abs(coefficient) for coefficient, _ in terms}
        scale = scales.pop() if len(scales) == 1 and len(terms) > 1 else Fraction(1)
        text = ""
        for coefficient, factors in terms:
            value = coefficient / scale
            text += "-" if value < 0 else "+"
            text += _clear_denominators(self._product(factors) if factors else "1", abs(value))
        text = text.removeprefix("+")
        return text if scale == 1 else _clear_denominators(f"({text})", scale)

    def _product(self, factors: list[str]) -> str:
        """A product by halves, each half a line of its own."""
        if len(factors) == 1:
            return factors[0]
        key = tuple(sorted(factors))
        if key not in self._products:
            middle = len(key) // 2
            left, right = self._product(list(key[:middle])), self._product(list(key[middle:]))
            name = f"p{len(self._products)}"
            self._products[key] = name
            self.lines.append(f"    {name} = {left}*{right}")
        return self._products[key]


def _clear_denominators(text: str, value: Fraction) -> str:
    """A positive multiple, by whole numbers only: they are exact in every arithmetic."""
    above = text if value.numerator == 1 else f"{value.numerator}*{text}"
    return above if value.denominator == 1 else f"{above}/{value.denominator}"
