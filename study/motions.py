"""What the steps about motions share: two motions, the integrators, errors."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from time import process_time
from typing import Any

import numpy as np
from numpy.typing import NDArray

from kowalevski_cas.motion import Motion, Parameters, load
from kowalevski_cas.motion.general import AnyMotion
from kowalevski_cas.motion.methods import taylor
from kowalevski_cas.motion.methods.integrators import integrate
from study.charts import digit, display_name

Array = NDArray[np.float64]
Integrator = Callable[[Array, Array, float], Array]

CONSTANTS = {"m > 0": ("1.2", "0.7", "0.6", "0.9"), "m < 0": ("1.2", "0.7", "-0.5", "0.33")}
"""The constants a, b, m, ℓ of a motion on an elliptic torus, and of one on a hyperbolic torus."""

MOTIONS = {name: Motion(Parameters.of(*constants)) for name, constants in CONSTANTS.items()}

INTEGRATORS: dict[str, Integrator] = {
    "dop853": partial(integrate, "DOP853"),
    "radau": partial(integrate, "Radau"),
    "lsoda": partial(integrate, "LSODA"),
    "taylor": taylor.integrate,
}
"""The states at some times, by the state at t = 0, the times, and a tolerance."""


def parameters(name: str) -> str:
    """The constants of a motion, as a caption gives them."""
    a, b, m, ell = CONSTANTS[name]
    return rf"$a={a}$, $b={b}$, $m={m}$, $\ell={ell}$"


def tolerances(of: Mapping[str, float]) -> str:
    """The tolerances of integrators, as a caption gives them."""
    return ", ".join(f"{digit(tolerance)} ({display_name(name)})" for name, tolerance in of.items())


def relative_error(motion: AnyMotion, found: Array, times: Array) -> float:
    """The largest error of states (N, 9), each relative to the state, as rigorous balls have it."""
    exact = load("ball")(motion, times)
    return float(np.max(np.linalg.norm(found - exact, axis=1) / np.linalg.norm(exact, axis=1)))


def time_call(run: Callable[[], Any]) -> tuple[float, Any]:
    """The seconds of processor time that a call took, and its result."""
    begin = process_time()
    result = run()
    return process_time() - begin, result
