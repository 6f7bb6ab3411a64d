r"""Fields at any angle: the rotation that makes them orthogonal.

The body is symmetric about its third axis. So the equations keep their form when the pair
(α, β) is turned by χ in its plane and the body axes e1, e2 by the same angle; with
:math:`\tan2\chi=2c/(a^2-b^2)` the new c is zero, and the new a exceeds the new b.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any


def turned(state: Sequence[Any], cos: Any, sin: Any) -> list[Any]:
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
