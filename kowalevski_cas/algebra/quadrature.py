"""Definite integrals as sums over values of the integrand."""

from __future__ import annotations

from collections.abc import Iterator

from flint import acb

INTEGRAL = r"\mathrm{int}"
"""The function of the ends, the variable and the integrand that a definite integral is."""
INFINITE = "I_{999}"
"""The name of an infinite end."""

ANY_NODES = tuple((acb(2 * k + 1) / 7, acb(k + 2) / 11) for k in range(7))
"""Places and weights of any sum: what is equal by linearity alone is equal then."""

_WIDTH, _REACH = 8, 4


def nodes() -> Iterator[tuple[acb, acb]]:
    """The places and the weights of the rule of tanh and sinh between 0 and 1."""
    for k in range(-_REACH * _WIDTH, _REACH * _WIDTH + 1):
        t = acb(k) / _WIDTH
        raised = (acb.pi() * t.sinh()).exp()
        yield raised / (1 + raised), acb.pi() * t.cosh() * raised / (1 + raised) ** 2 / _WIDTH
