r"""The two frequencies of a torus of N⁴ or O⁴, its rotation number, and its actions.

A motion is linear in two phases, and the state is a function of them; the shifts of the phases that
change no state are a lattice. The frequencies belong to a basis of it, so the state is a Fourier
series :math:`\sum a_{jk}e^{i(j\omega_1+k\omega_2)t}` with all whole j, k, and no other pair tells
more: only a basis can be changed. The action of a circle γ of the basis is

.. math:: I = \frac1{2\pi}\oint_\gamma (2\omega_1\,d\eta_1+2\omega_2\,d\eta_2+\omega_3\,d\eta_3),

where dη is the turn of the body along γ, in its own axes. On N⁴ or O⁴, with fields that stay as
they are, :math:`dH=\omega_1dI_1+\omega_2dI_2`.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from flint import arb_mat

from kowalevski_cas.motion.arrays import Array
from kowalevski_cas.motion.attitude import frames
from kowalevski_cas.motion.methods.closed import Closed
from kowalevski_cas.motion.motion import Motion
from kowalevski_cas.motion.o4.closed import ClosedO4
from kowalevski_cas.motion.o4.motion import MotionO4
from kowalevski_cas.motion.o4.series import DifferentialSeries, matrix
from kowalevski_cas.motion.o4.uniformization import uniformize
from kowalevski_cas.motion.parameters import Inadmissible, precision

BITS = 192
"""The precision of the rates."""

PLACES = 7
"""Points of the torus at which shifts by half a turn are tried."""

FEWEST, MOST = 64, 1 << 16
"""Points of a circle, doubled until an action stays what it is."""

SAME = 1e-12
"""The change of an action at which it counts as the same, relative to its terms."""

INERTIA = np.array([2.0, 2.0, 1.0])
"""The moments of inertia."""


@dataclass(frozen=True)
class Frequencies:
    """What a torus has: frequencies in radians per unit of time, positive; and its actions."""

    frequencies: tuple[float, float]
    actions: tuple[float, float]

    @property
    def rotation_number(self) -> float:
        """The quotient of the first frequency by the second one."""
        return self.frequencies[0] / self.frequencies[1]


def frequencies(motion: Motion | MotionO4) -> Frequencies:
    """The frequencies and actions of the torus of a motion.

    Raises :class:`~kowalevski_cas.motion.parameters.Inadmissible` where a variable rests or tends
    to rest, and for a single field.

    >>> found = frequencies(Motion.of(a=1, b="0.4", m="0.8", ell="0.9"))
    >>> [round(value, 6) for value in found.frequencies]
    [0.694393, 0.41459]
    """
    unit = motion.parameters.unit
    torus = _Torus(motion.in_unit(unit))
    basis = torus.basis()
    rates = np.linalg.solve(basis, torus.rates)
    basis *= np.sign(rates)
    actions = [torus.action(circle) for circle in basis.T]
    (one, two), (first, second) = np.ldexp([np.abs(2 * np.pi * rates), actions], unit).tolist()
    return Frequencies((one, two), (first, second))


def shift_basis(motion: Motion | MotionO4) -> Array:
    """A basis of the shifts of the phases, in turns, that change no state: one for each regime."""
    return _Torus(motion).basis()


def turn_rates(motion: Motion | MotionO4) -> Array:
    """How often each phase turns in a unit of time, to the precision of FLINT's context.

    Raises :class:`~kowalevski_cas.motion.parameters.Inadmissible` where a variable rests or tends
    to rest.
    """
    if isinstance(motion, MotionO4):
        series = [DifferentialSeries(uniformize(motion.parameters, arc)) for arc in motion.arcs]
        means = matrix([integral.means() for integral in series], motion.orientations)
        rates = means.solve(arb_mat([[0], [-1]])).entries()
        return np.array([float(rate) for rate in rates]) / (4 * np.pi)
    oscillations = motion.oscillations()
    if any(oscillation.kind != "elliptic" for oscillation in oscillations):
        raise Inadmissible("a variable rests, or tends to rest: the motion fills no torus")
    return np.array(
        [float(oscillation.rate / (4 * oscillation.quarter)) for oscillation in oscillations]
    )


class _Torus:
    """The states by two phases, in turns, after which they are the same; the turns per time."""

    def __init__(self, motion: Motion | MotionO4) -> None:
        with precision(BITS):
            self.rates = turn_rates(motion)
        if isinstance(motion, MotionO4):
            self._closed: Closed | ClosedO4 = ClosedO4(motion, 1.0)
            self._whole = np.full(2, 4 * np.pi)
        else:
            self._whole = 1 / self.rates
            self._closed = Closed(motion, float(np.max(self._whole)))

    def __call__(self, turns: Array) -> Array:
        """The states (N, 9) at phases (2, N)."""
        first, second = self._whole[:, None] * turns
        found: Array = self._closed.torus(first, second).T
        return found

    def basis(self) -> Array:
        """A basis of the shifts that change no state, a column each: whole turns, or half ones."""
        places = np.random.default_rng(4).uniform(size=(2, PLACES))
        here = self(places)
        kept = [
            shift
            for shift in ((0.5, 0.0), (0.0, 0.5), (0.5, 0.5))
            if np.allclose(self(places + np.array(shift)[:, None]), here, rtol=1e-6, atol=1e-9)
        ]
        if len(kept) == 3:
            return np.diag([0.5, 0.5])
        if kept == [(0.5, 0.5)]:
            return np.array([[0.5, 0.5], [0.5, -0.5]])
        sides = [0.5 if shift in kept else 1.0 for shift in ((0.5, 0.0), (0.0, 0.5))]
        return np.diag(sides)

    def action(self, circle: Array) -> float:
        """The action of the circle along a shift."""
        before, count = np.inf, FEWEST
        while count <= MOST:
            share = np.arange(count) / count
            states = self(circle[:, None] * share)
            momenta = INERTIA * states[:, :3]
            terms = np.sum(momenta * _turns(frames(states)), axis=1)
            action, size = float(np.mean(terms)), float(np.mean(np.abs(terms)))
            if abs(action - before) <= SAME * size:
                return action
            before, count = action, 2 * count
        raise Inadmissible("roots are too close for the actions")


def _turns(axes: Array) -> Array:
    """The turns of the body by a phase of 2π, from axes (N, 3, 3) around a circle."""
    count = len(axes)
    orders = np.fft.fftfreq(count, 1 / count)
    orders[count // 2] = 0.0
    spectrum = np.fft.fft(axes, axis=0) * (1j * orders)[:, None, None]
    changes = np.fft.ifft(spectrum, axis=0).real
    # Each axis u, fixed in space, changes by u × dη: so the sum of u × du is −2 dη.
    found: Array = -np.sum(np.cross(axes, changes), axis=1) / 2
    return found
