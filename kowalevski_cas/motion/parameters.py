r"""The constants of a motion: the fields a, b and the integrals m, \ell, all exact.

Everything that decides (which regime, which roots coincide) is a sign of a linear
expression in :math:`\ell` with rational coefficients. :math:`\ell` itself is rational or,
when the energy is given, the square root of a rational number; so these signs are exact.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from decimal import ROUND_CEILING, ROUND_FLOOR, Context, Decimal
from fractions import Fraction
from functools import cached_property
from typing import Any

from flint import arb, ctx

from kowalevski_cas.algebra.flint import to_flint
from kowalevski_cas.algebra.numbers import square_root
from kowalevski_cas.motion.phases import as_fraction
from kowalevski_cas.motion.units import power

Real = int | float | str | Fraction
"""What may be given as a number; a string is read as the decimal or quotient that it prints."""


LARGEST = Fraction(10**50)
"""In units of a, what is given, and 1/m, may be as large: then floats can hold all constants."""


class Inadmissible(ValueError):
    """Constants for which there is no motion on N⁴; the message says why and what would do."""


class MethodError(ArithmeticError):
    """A method to follow a motion that gave up; the message says why."""


@dataclass(frozen=True)
class Lengths:
    """The lengths of two fields at right angles."""

    a: Fraction
    b: Fraction

    @property
    def p_square(self) -> Fraction:
        """p² = a² + b²."""
        return self.a**2 + self.b**2

    @property
    def r_square(self) -> Fraction:
        """r² = a² − b²."""
        return self.a**2 - self.b**2

    @property
    def unit(self) -> int:
        """The exponent of a unit of time in which a is about 1."""
        return int((self.a.numerator.bit_length() - self.a.denominator.bit_length()) / 2)


@dataclass(frozen=True)
class Parameters(Lengths):
    r"""The constants of a motion on N⁴ in fields of lengths a > b ≥ 0 at right angles.

    ``ell_square`` with ``ell_sign`` (−1, 0 or 1) is :math:`\ell`, which is the square root of
    a rational number when the energy is prescribed. Make one by :meth:`of` or :meth:`at_energy`.
    """

    m: Fraction
    ell_square: Fraction
    ell_sign: int

    def __post_init__(self) -> None:
        """Refuse lengths that do not separate, m = 0, and what floats would not hold."""
        if self.b < 0 or self.a < 0:
            short = "a" if self.a < 0 else "b"
            raise Inadmissible(f"the length {short} = {float(self.a if self.a < 0 else self.b):g}"
                               " is negative; a > b ≥ 0 is needed")  # fmt: skip
        if self.a <= self.b:
            equal = "equal, and then r = 0: the variables s1, s2 do not separate"
            wrong = "in the wrong order: call the longer field α and its length a"
            words = equal if self.a == self.b else wrong
            raise Inadmissible(
                f"a = {float(self.a):g} and b = {float(self.b):g} are {words}; a > b ≥ 0 is needed"
            )
        refuse_extremes({"am": self.a * self.m, "ℓ²": self.ell_square / LARGEST})
        if abs(self.a * self.m) * LARGEST < 1:
            words = "almost 0" if self.m else "0"
            raise Inadmissible(
                f"m = {words}: the roots (ℓ±1)/2m are at infinity; m > 0 or m < 0 would do"
            )

    @staticmethod
    def of(a: Real, b: Real, m: Real, ell: Real) -> Parameters:
        r"""The constants a, b, m and :math:`\ell`.

        Raises :class:`Inadmissible` unless a > b ≥ 0 and m ≠ 0, and ``ValueError`` for
        what is not a finite number.
        """
        fields, value = (exact(a), exact(b), exact(m)), exact(ell)
        return Parameters(*fields, value**2, _sign(value))

    @staticmethod
    def at_energy(a: Real, b: Real, m: Real, h: Real) -> Parameters:
        r"""The constants a, b, m and the energy h, by :math:`\ell^2=2p^2m^2+2hm+1`, ℓ ≥ 0."""
        first = Parameters.of(a, b, m, 0)
        refuse_extremes({"h/a": exact(h) / first.a})
        square = 2 * first.p_square * first.m**2 + 2 * exact(h) * first.m + 1
        if square < 0:
            raise Inadmissible(
                f"ℓ² = 2p²m²+2hm+1 = {float(square):.6g} is negative; "
                f"{energies(first.a, first.b, first.m)} would do"
            )
        return Parameters(first.a, first.b, first.m, square, int(square > 0))

    def in_unit(self, unit: int) -> Parameters:
        """The same in a unit of time in which a rate of this power of two is 1."""
        a, b, m = self.a * power(-2 * unit), self.b * power(-2 * unit), self.m * power(2 * unit)
        return Parameters(a, b, m, self.ell_square, self.ell_sign)

    # -- ℓ, and linear expressions in it -------------------------------------------

    def sign(self, slope: Fraction, constant: Fraction) -> int:
        r"""The sign of slope·ℓ + constant, exactly."""
        left = self.ell_sign * _sign(slope)
        right = _sign(constant)
        if left * right >= 0:
            return left or right
        return left * _sign(slope**2 * self.ell_square - constant**2)

    def value(self, slope: Fraction, constant: Fraction) -> arb:
        r"""The value of slope·ℓ + constant, to the full relative precision of FLINT's context."""
        if self.rational_ell is not None:
            return ball(slope * self.rational_ell + constant)
        term = ball(slope) * self.ell_sign * ball(self.ell_square).sqrt()
        if _sign(slope) * self.ell_sign * _sign(constant) >= 0:
            return term + ball(constant)
        # The numerator of the difference of squares is rational: nothing cancels.
        return ball(slope**2 * self.ell_square - constant**2) / (term - ball(constant))

    @cached_property
    def rational_ell(self) -> Fraction | None:
        r""":math:`\ell`, if it is rational."""
        size = square_root(self.ell_square)
        return None if size is None else self.ell_sign * size

    @property
    def ell(self) -> arb:
        r""":math:`\ell` at the precision of FLINT's context."""
        return self.value(Fraction(1), Fraction(0))

    # -- the other constants, all rational ------------------------------------------

    @property
    def h(self) -> Fraction:
        r"""The energy: :math:`\ell^2=2p^2m^2+2hm+1` solved for h."""
        return (self.ell_square - 1 - 2 * self.p_square * self.m**2) / (2 * self.m)

    @property
    def k(self) -> Fraction:
        """The constant of K: r⁴m²."""
        return self.r_square**2 * self.m**2

    @property
    def g(self) -> Fraction:
        """The constant of the third integral: 2g − p²h = r⁴m."""
        return (self.r_square**2 * self.m + self.p_square * self.h) / 2


def extreme_ell(a: Fraction, b: Fraction, m: Fraction) -> Fraction:
    """The least |ℓ| of a motion if m > 0, the greatest if m < 0."""
    return max(2 * a * m - 1, 1 - 2 * b * m) if m > 0 else 1 - 2 * b * m


def energies(a: Fraction, b: Fraction, m: Fraction) -> str:
    """In words the energies of the motions with this m; those that it names have motions."""
    at_ell, at_zero = (
        (square - 1 - 2 * (a**2 + b**2) * m**2) / (2 * m)
        for square in (extreme_ell(a, b, m) ** 2, Fraction(0))
    )
    least = f"h ≥ {round_towards(at_ell, up=True)}"
    return least if m > 0 else f"{least} and ≤ {round_towards(at_zero, up=False)}"


def round_towards(value: Fraction, up: bool) -> str:
    """A number to twelve digits, rounded towards one side."""
    towards = Context(prec=12, rounding=ROUND_CEILING if up else ROUND_FLOOR)
    quotient = towards.divide(Decimal(value.numerator), Decimal(value.denominator))
    return f"{quotient.normalize(towards):g}"


def exact(value: Real) -> Fraction:
    """The number as a fraction; raises ``ValueError`` unless it is finite and can be written out.

    >>> exact("0.3"), exact(0.5)
    (Fraction(3, 10), Fraction(1, 2))
    """
    if isinstance(value, str) and len(value) > 1000:
        raise ValueError("a number of more than 1000 characters")
    if isinstance(value, str):
        _, _, exponent = value.lower().partition("e")
        if exponent.strip().lstrip("+-").isdigit() and len(exponent.strip()) > 4:
            raise ValueError(f"“{value}” is too large or too small")
    try:
        return Fraction(value)
    except (ValueError, OverflowError, ZeroDivisionError):
        raise ValueError(f"“{value}” is not a finite number") from None


def usable(value: Real) -> Fraction:
    """The number as a fraction; raises ``ValueError`` unless it is finite and a float holds it."""
    number = exact(value)
    try:
        held = float(number) != 0 or number == 0
    except OverflowError:
        held = False
    if not held:
        size = "large" if abs(number) > 1 else "small"
        raise ValueError(f"“{value}” is too {size}: no float holds it; take other units")
    return number


def refuse_extremes(values: Mapping[str, Fraction]) -> None:
    """Refuse constants that are huge in units of a: there are motions, which integrators follow."""
    for name, value in values.items():
        if abs(value) > LARGEST:
            raise Inadmissible(f"|{name}| is too large: {float(LARGEST):g} is the most")


def root(square: Fraction) -> Fraction:
    """The root of a rational number, at the precision of FLINT's context if it is irrational."""
    exactly = square_root(square)
    return as_fraction(ball(square).sqrt()) if exactly is None else exactly


def ball(value: Fraction) -> arb:
    """A rational number as a ball at the precision of FLINT's context."""
    return arb(to_flint(value))


def precision(bits: int) -> Any:
    """A context in which FLINT computes with so many bits."""
    return ctx.workprec(bits)


def _sign(value: Fraction) -> int:
    return (value > 0) - (value < 0)
