"""The motion as curves: for how long, how finely, and its torus as a net."""

from __future__ import annotations

import numpy as np

from kowalevski_cas.motion.arrays import Array
from kowalevski_cas.motion.attitude import frames
from kowalevski_cas.motion.methods.closed import Closed, states
from kowalevski_cas.motion.motion import Motion
from kowalevski_cas.motion.o4.closed import ClosedO4
from kowalevski_cas.motion.o4.motion import MotionO4
from kowalevski_cas.motion.oscillation import Oscillation

ARRIVED = 12.0
"""The argument nt at which a motion that tends to rest is as good as there."""


def periods(motion: Motion | MotionO4) -> tuple[float, float]:
    """The periods of the two angles of the torus; infinite where one of them only tends to rest.

    A variable that rests has the period zero.
    """
    if isinstance(motion, MotionO4):
        return ClosedO4(motion, 1.0).periods
    first, second = (_period(oscillation) for oscillation in motion.oscillations())
    return first, second


def _period(oscillation: Oscillation) -> float:
    """The time after which not only s, but also S and f have the same values again."""
    if oscillation.kind == "rest":
        return 0.0
    if oscillation.kind != "elliptic":
        return np.inf
    return float(4 * oscillation.quarter / oscillation.rate) / oscillation.arc.components


def times(motion: Motion | MotionO4, turns: float, points: int) -> Array:
    """Equidistant times in which the slower angle makes so many turns, or comes to rest."""
    slower = max(periods(motion))
    if isinstance(motion, MotionO4) or np.isfinite(slower):
        return np.linspace(0.0, turns * slower or 1.0, points)
    rates = [float(o.rate) for o in motion.oscillations() if o.kind not in ("rest", "elliptic")]
    reach = ARRIVED / min(rates)
    return np.linspace(-reach, reach, points)


def orbit(motion: Motion | MotionO4, turns: float, points: int) -> Array:
    """The states (N, 9) along the motion."""
    return states(motion, times(motion, turns, points))


def net(motion: Motion, lines: int, points: int) -> list[Array]:
    """Curves (N, 9) on the torus on which one of its angles rests, so many of each kind."""
    whole = [period if np.isfinite(period) else 0.0 for period in periods(motion)]
    closed = Closed(motion, max(*whole, 1.0))
    turns = np.linspace(0.0, 1.0, points)
    found = []
    for share in np.arange(lines) / lines:
        for first, second in ((turns, share), (share, turns)):
            one, two = (
                part * np.ones(points) * period
                for part, period in zip((first, second), whole, strict=True)
            )
            found.append(closed.torus(one, two).T)
    return found


def in_space(orbit: Array) -> Array:
    """The angular velocity (N, 3) by the axes of :func:`frames`, along an orbit (N, 9)."""
    found: Array = np.einsum("nij,nj->ni", frames(orbit), orbit[:, :3])
    return found
