r"""Truncated power series, over numbers of any kind or over other series."""

from __future__ import annotations

from typing import Any

Coefficient = Any
"""A number of some arithmetic, or a series of a lower level."""


class Series:
    r"""The beginning :math:`c_0+c_1t+\dots+c_{n-1}t^{n-1}` of a power series.

    ``level`` tells the variables of nested series apart: anything of a lower
    level, a number included, is a constant here. Sums and products know as many
    coefficients as the shorter series does.
    """

    __slots__ = ("coefficients", "level")
    __array_ufunc__ = None  # an array of NumPy is a number here, not a container

    def __init__(self, level: int, coefficients: list[Coefficient]) -> None:
        self.level = level
        self.coefficients = coefficients

    def __add__(self, other: Coefficient) -> Series:
        level = level_of(other)
        if level > self.level:
            total: Series = other + self
            return total
        ours = self.coefficients
        if level < self.level:
            return Series(level=self.level, coefficients=[ours[0] + other, *ours[1:]])
        return Series(self.level, [a + b for a, b in zip(ours, other.coefficients, strict=False)])

    __radd__ = __add__

    def __mul__(self, other: Coefficient) -> Series:
        level = level_of(other)
        if level > self.level:
            outer: Series = other * self
            return outer
        ours = self.coefficients
        if level < self.level:
            return Series(self.level, [a * other for a in ours])
        theirs = other.coefficients
        size = min(len(ours), len(theirs))
        product = []
        for k in range(size):
            total = ours[0] * theirs[k]
            for j in range(1, k + 1):
                total = total + ours[j] * theirs[k - j]
            product.append(total)
        return Series(self.level, product)

    __rmul__ = __mul__

    def inverse(self) -> Series:
        """One over the series; raises ``ZeroDivisionError`` if the constant term is zero."""
        ours = self.coefficients
        first = inverse(ours[0])
        found = [first]
        for k in range(1, len(ours)):
            total = ours[1] * found[k - 1]
            for j in range(2, k + 1):
                total = total + ours[j] * found[k - j]
            found.append(-1 * (total * first))
        return Series(self.level, found)

    def root(self, first: Coefficient) -> Series:
        """The square root with this constant term."""
        ours = self.coefficients
        found = [first]
        if len(ours) > 1:
            half = inverse(first + first)
            for k in range(1, len(ours)):
                total = ours[k]
                for j in range(1, k):
                    total = total + -1 * (found[j] * found[k - j])
                found.append(total * half)
        return Series(self.level, found)

    def derivative(self) -> Series:
        """The derivative, of which one coefficient less is known."""
        return Series(self.level, [k * c for k, c in enumerate(self.coefficients)][1:])


def level_of(value: Coefficient) -> int:
    """The level of a series; −1 for numbers."""
    return value.level if isinstance(value, Series) else -1


def inverse(value: Coefficient) -> Coefficient:
    """One over a number or a series."""
    return value.inverse() if isinstance(value, Series) else 1 / value


def power(value: Coefficient, exponent: int) -> Coefficient:
    """A positive whole power, by squaring."""
    result = None
    while True:
        if exponent & 1:
            result = value if result is None else result * value
        exponent >>= 1
        if not exponent:
            return result
        value = value * value
