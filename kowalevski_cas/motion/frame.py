r"""Fields at any angle: the rotation that makes them orthogonal.

The body is symmetric about its third axis. So the equations keep their form when the pair
(α, β) is turned by χ in its plane and the body axes e1, e2 by the same angle; with
:math:`\tan2\chi=2c/(a^2-b^2)` the new c is zero, and the new a exceeds the new b.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from typing import Any

from flint import arb

from kowalevski_cas.motion.parameters import Inadmissible, Real, ball, precision, root, usable
from kowalevski_cas.motion.phases import as_fraction

BITS = 320
"""To how many bits constants and phases are found where they are irrational."""


def state_from_numbers(state: Sequence[Real]) -> list[Fraction]:
    """The nine numbers of a state (ω, α, β); raises ``ValueError`` for what is none."""
    given = [usable(value) for value in state]
    if len(given) != 9:
        raise ValueError(f"a state has nine numbers, ω, α, β; {len(given)} are given")
    return given


def rotate(state: Sequence[Any], cos: Any, sin: Any) -> list[Any]:
    """The nine variables (ω, α, β) after the turn by the angle with this cosine and sine."""
    omega, alpha, beta = (_about_third(state[k : k + 3], cos, sin) for k in (0, 3, 6))
    return [
        *omega,
        *(cos * x + sin * y for x, y in zip(alpha, beta, strict=True)),
        *(cos * y - sin * x for x, y in zip(alpha, beta, strict=True)),
    ]


def _about_third(vector: Sequence[Any], cos: Any, sin: Any) -> tuple[Any, Any, Any]:
    """The components of a vector by axes turned about the third one."""
    x, y, z = vector
    return cos * x + sin * y, cos * y - sin * x, z


def turn_of(a_square: Fraction, b_square: Fraction, c: Fraction) -> tuple[Fraction, Fraction]:
    """The cosine and sine of the angle χ that makes the fields orthogonal, a > b."""
    if c == 0:
        return Fraction(a_square > b_square), Fraction(a_square < b_square)
    twice = arb.atan2(ball(2 * c), ball(a_square - b_square))
    sine, cosine = (twice / 2).sin_cos()
    return as_fraction(cosine), as_fraction(sine)


def straighten(
    a: Fraction, b: Fraction, c: Fraction
) -> tuple[Fraction, Fraction, tuple[Fraction, Fraction]]:
    """The lengths of the fields after the turn that makes them orthogonal, and the turn.

    Raises :class:`~kowalevski_cas.motion.parameters.Inadmissible` where no two vectors have
    the lengths a, b and the scalar product c.
    """
    for name, length in (("a", a), ("b", b)):
        if length < 0:
            raise Inadmissible(f"the length {name} = {float(length):g} is negative")
    if abs(c) > a * b:
        raise Inadmissible(
            f"c = {float(c):g} is no scalar product of fields of lengths {float(a):g} and "
            f"{float(b):g}; |c| ≤ {float(a * b):g} would do"
        )
    if c == 0:
        return max(a, b), min(a, b), turn_of(a, b, c)
    with precision(BITS):
        r_square = root((a**2 - b**2) ** 2 + 4 * c**2)
        longer = root((a**2 + b**2 + r_square) / 2)
        return longer, root(a**2 * b**2 - c**2) / longer, turn_of(a**2, b**2, c)


def fields(
    p_square: Fraction, r_square: Fraction, turn: tuple[Fraction, Fraction]
) -> tuple[float, float, float]:
    """The lengths of the fields and their scalar product before the turn."""
    cos, sin = turn
    difference = r_square * (cos**2 - sin**2)
    squares = (p_square + difference) / 2, (p_square - difference) / 2
    a, b = (math.sqrt(max(square, Fraction(0))) for square in squares)
    return a, b, float(r_square * cos * sin)
