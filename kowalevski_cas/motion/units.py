r"""Units of time: the same motion is (νω, ν²α, ν²β) in a time that runs ν times as fast.

So whatever has a tolerance works on states whose size is about 1, and what it says is relative to
the size of the state. Units are powers of two: to change them rounds nothing.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from decimal import Decimal
from fractions import Fraction
from typing import Final

import numpy as np

from kowalevski_cas.motion.arrays import Array

WEIGHTS = np.array([1] * 3 + [2] * 6)
"""Those of ω, α, β."""

_CONSTANTS: Final = {
    "a": 2, "b": 2, "c": 4, "h": 2, "k": 4, "g": 6, "m": -2, "l": 0, "s": 2, "tau": 4
}  # fmt: skip
"""The weights of the constants, of which the unit of time has the weight −1."""


def unit_of(states: Array) -> Array:
    """The exponents of the powers of two nearest above the sizes of states (…, 9).

    >>> int(unit_of(np.array([0, 0, 1e-30, 1e-61, 0, 0, 0, 0, 0])))
    -99
    """
    omega, fields = (np.max(np.abs(part), axis=-1) for part in (states[..., :3], states[..., 3:]))
    exponents: Array = np.frexp(np.maximum(omega, np.sqrt(fields)))[1]
    return exponents


def in_unit(states: Array, exponents: Array) -> Array:
    """The states in a unit of time in which a rate of this power of two is 1.

    >>> in_unit(np.array([4.0, 0, 0, 16.0, 0, 0, 0, 0, 0]), np.array(2))[[0, 3]]
    array([1., 1.])
    """
    scaled: Array = np.ldexp(states, -np.asarray(exponents)[..., None] * WEIGHTS)
    return scaled


def numbers_in_unit(state: Sequence[Fraction], exponent: int) -> list[Fraction]:
    """The nine numbers of a state in such a unit of time, exactly."""
    weighted = zip(state, WEIGHTS.tolist(), strict=True)
    return [x * power(-weight * exponent) for x, weight in weighted]


def power(exponent: int) -> Fraction:
    """A power of two."""
    return Fraction(2) ** exponent


def without_unit(constants: Mapping[str, float], exponent: int) -> dict[str, float | str]:
    """The values of constants by those in such a unit of time; in digits what no float holds."""
    return {name: scale(value, _CONSTANTS[name] * exponent) for name, value in constants.items()}


def scale(value: float, exponent: int) -> float | str:
    """The number times a power of two; its digits where that is no float.

    >>> scale(0.5, 3), scale(0.0, -5000), scale(-1.0, -2000)
    (4.0, 0.0, '-8.709809816217217e-603')
    """
    with np.errstate(over="ignore"):
        whole = float(np.ldexp(value, exponent))
    if np.isfinite(whole) and (whole or not value):
        return whole
    return f"{Decimal(value) * Decimal(2) ** exponent:.16g}"
