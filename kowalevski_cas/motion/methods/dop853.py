"""Explicit Runge–Kutta of order 8, by SciPy."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from kowalevski_cas.motion.general import AnyMotion
from kowalevski_cas.motion.methods.integrators import TOLERANCE, initial_state, integrate


def states(
    motion: AnyMotion, times: NDArray[np.float64], tolerance: float = TOLERANCE
) -> NDArray[np.float64]:
    """The states at these times, an array of shape (N, 9)."""
    return integrate("DOP853", initial_state(motion), times, tolerance)
