"""Methods to follow a motion, one file each; its library is imported when it is asked for.

Each module has a function ``states(motion, times)``: the states (ω, α, β) at the times, an
array of shape (N, 9). The integrators start from the state of the closed form at t = 0, or
from any other; see :mod:`~kowalevski_cas.motion.methods.integrators`.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from kowalevski_cas.motion.arrays import Array
    from kowalevski_cas.motion.general import AnyMotion

METHODS = {
    "closed": "the closed form in floating point: any time, no accumulated error",
    "ball": "the closed form in balls: rigorous, at any precision",
    "dop853": "SciPy's explicit Runge–Kutta method of order 8",
    "radau": "SciPy's implicit Runge–Kutta method of order 5",
    "lsoda": "SciPy's multistep method that switches between Adams and BDF",
    "taylor": "heyoka's Taylor method (an extra)",
}

_SCIPY = {"dop853": "DOP853", "radau": "Radau", "lsoda": "LSODA"}


def load(name: str) -> Callable[[AnyMotion, Array], Array]:
    """The function ``states`` of the method with this name."""
    if name not in METHODS:
        raise ValueError(f"unknown method “{name}”; there are {', '.join(METHODS)}")
    states: Callable[..., Array]
    states = import_module(f"{__name__}.{'integrators' if name in _SCIPY else name}").states
    return partial(states, method=_SCIPY[name]) if name in _SCIPY else states
