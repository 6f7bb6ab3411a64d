"""Arithmetics, one file each; a library is imported when it is first asked for.

Exact ones decide (:data:`EXACT`); those that look at points screen (:data:`POINTS`).
"""

from __future__ import annotations

import signal
from collections.abc import Iterator
from contextlib import contextmanager
from importlib import import_module

from kowalevski_cas.algebra.points import Points
from kowalevski_cas.algebra.polynomials import Polynomials

Arithmetic = type[Polynomials]

EXACT = ("flint", "symengine", "sympy")
"""The arithmetics that decide, the default first."""

POINTS = ("modular", "ball", "floating")
"""The arithmetics that screen: they look at points."""


def load(name: str) -> Arithmetic:
    """The arithmetic with this name; importing its module imports its library."""
    if name not in EXACT:
        raise ValueError(f"unknown arithmetic “{name}”; there are {', '.join(EXACT)}")
    with _uninterrupted():
        arithmetic: Arithmetic = import_module(f"{__name__}.{name}").Arithmetic
    return arithmetic


def load_points(name: str, seed: int = 1) -> Points:
    """The arithmetic of points with this name; ``seed`` chooses its points."""
    if name not in POINTS:
        raise ValueError(f"unknown arithmetic of points “{name}”; there are {', '.join(POINTS)}")
    with _uninterrupted():
        points: Points = import_module(f"{__name__}.{name}").Arithmetic(seed)
    return points


@contextmanager
def _uninterrupted() -> Iterator[None]:
    """An interruption waits: a compiled library that is half loaded may crash of one."""
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)
