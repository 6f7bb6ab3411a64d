"""The arithmetics in which the phase point on O⁴ is computed: floats, also in arrays, and balls."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from flint import acb, arb

Number = Any
"""A float, an array of floats, or a ball."""

Pair = tuple[Number, Number]


@dataclass(frozen=True)
class Arithmetic:
    """How a ball becomes a number, the square root, and the choice between two forms of numbers.

    ``choose(x, y, z)`` is y where x ≥ 0, and z elsewhere: both are right, and one is sharper.
    """

    number: Callable[[arb], Number]
    root: Callable[[Number], Number]
    choose: Callable[[Number, Sequence[Number], Sequence[Number]], Sequence[Number]]


def _choose_floats(
    condition: Number, positive: Sequence[Number], negative: Sequence[Number]
) -> Sequence[Number]:
    return [np.where(condition >= 0, x, y) for x, y in zip(positive, negative, strict=True)]


def _choose_balls(
    condition: arb | acb, positive: Sequence[Number], negative: Sequence[Number]
) -> Sequence[Number]:
    return positive if condition.real.mid() >= 0 else negative


FLOATS = Arithmetic(float, np.sqrt, _choose_floats)

BALLS = Arithmetic(lambda ball: ball, arb.sqrt, _choose_balls)
