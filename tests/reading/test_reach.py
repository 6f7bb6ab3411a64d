"""How far a sine reaches: to an angle that moves, or over a bracket with the time."""

import pytest

from kowalevski_cas.reading.reach import with_reach
from kowalevski_cas.source.displays import TypedFormula


def dotted(tex, moving):
    (found,) = with_reach([TypedFormula(tex, 0, len(tex), "$")], moving)
    return found.tex


@pytest.mark.parametrize(
    "printed, read",
    [
        (r"\sin\theta(a-b)", r"\sin\theta\cdot(a-b)"),
        (r"\cos^2\theta\left(a\cos\theta-(b)\right)c", r"\cos^2\theta\cdot\left(a\cos\theta-(b)\right)c"),
        (r"\sin\omega(t-t_0)+1", r"\sin(\omega(t-t_0))+1"),
        (r"\cos2k\left(x-ct\right)", r"\cos(2k\left(x-ct\right))"),
        (r"\sin a(b-c)", r"\sin a(b-c)"),
        (r"\sin\theta(t)", r"\sin\theta(t)"),
        (r"\sin\omega(t", r"\sin\omega(t"),
    ],
)  # fmt: skip
def test_reach(printed, read):
    assert dotted(printed, {r"\theta"}) == read
