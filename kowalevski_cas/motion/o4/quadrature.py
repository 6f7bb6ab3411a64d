r"""The two quadratures of O⁴ in floating point, and inverted.

.. math:: \pm\frac{v_1\Delta_1}{y_1}\pm\frac{v_2\Delta_2}{y_2}=0, \qquad
    \pm\frac{n_1\Delta_1}{y_1}\pm\frac{n_2\Delta_2}{y_2}=-dt, \qquad \Delta_k=v_kdn_k-n_kdv_k

Each differential is its mean by dφ and a series of cosines, which converges geometrically. By the
inverse of the matrix of the means both integrals become :math:`\varphi_k+{}` sines
:math:`=\theta_k`, with phases θ that are linear in time. The map φ ↦ θ is a diffeomorphism of the
torus, for its determinant has the factor :math:`n_1v_2-n_2v_1`; so Newton's method with damping
finds φ from anywhere.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from kowalevski_cas.motion.arrays import Array
from kowalevski_cas.motion.o4.motion import MotionO4
from kowalevski_cas.motion.o4.point import VariableO4, cosines
from kowalevski_cas.motion.o4.series import DifferentialSeries, matrix
from kowalevski_cas.motion.parameters import Inadmissible

BITS = 54
"""How small the terms are that are left out."""

NEAR = 1e-10
"""A Newton step after which no other is needed."""

STEPS = 100
"""Newton steps, or halvings of one, after which the method gives up; it takes about six."""


class Quadratures:
    """The phases by the angles, and the angles by the phases."""

    def __init__(self, motion: MotionO4, series: Sequence[DifferentialSeries]) -> None:
        means = matrix(series, motion.orientations)
        self._means = np.array(means.tolist(), dtype=float)
        self._variables = [VariableO4(motion.parameters, arc, float) for arc in motion.arcs]
        self._signs = motion.orientations
        inverse = np.array(means.inv().tolist(), dtype=float)
        self._series = [
            inverse @ (sign * _sines(variable, one.terms(BITS)))
            for sign, variable, one in zip(self._signs, self._variables, series, strict=True)
        ]

    def phases(self, angles: Array) -> Array:
        """The phases θ (2, N) by the angles φ."""
        one, two = map(_sum, self._series, angles)
        found: Array = angles + one + two
        return found

    def angles(self, phases: Array) -> Array:
        """The angles φ (2, N) by the phases θ.

        Raises :class:`~kowalevski_cas.motion.parameters.Inadmissible` if none are found.
        """
        found, left = phases.copy(), np.arange(phases.shape[1])
        rest = phases - self.phases(found)
        for _ in range(STEPS):
            step = self._step(found[:, left], rest)
            step, rest = self._damp(found[:, left], step, rest, phases[:, left])
            found[:, left] += step
            more = np.hypot(*step) > NEAR
            left, rest = left[more], rest[:, more]
            if not len(left):
                return found
        raise Inadmissible(
            "Newton's method does not invert the quadratures: two roots are too close; s or τ "
            "farther from those where the tori of O⁴ degenerate would do"
        )

    def _damp(self, start: Array, step: Array, rest: Array, aim: Array) -> tuple[Array, Array]:
        """The step, or as much of it as diminishes the rest, and what then is left."""
        before, after = np.hypot(*rest), aim - self.phases(start + step)
        for _ in range(STEPS):
            worse = (np.hypot(*after) > before) & (np.hypot(*step) > NEAR)
            if not worse.any():
                break
            step[:, worse] /= 2
            after[:, worse] = aim[:, worse] - self.phases(start[:, worse] + step[:, worse])
        return step, after

    def _step(self, angles: Array, rest: Array) -> Array:
        """Newton's step: the change of the angles that changes the phases by the rest."""
        (a, c), (b, d) = (
            [sign * value for value in variable.differentials(cosines(angle, np.cos), np.sqrt)]
            for sign, variable, angle in zip(self._signs, self._variables, angles, strict=True)
        )
        x, y = self._means @ rest
        step: Array = np.array([d * x - b * y, a * y - c * x]) / (a * d - b * c)
        return step


def _sines(variable: VariableO4, terms: int) -> Array:
    """The coefficients (2, terms) of sin φ, sin 2φ, … in the integrals of the differentials."""
    samples = 4 * terms
    angles = 2 * np.pi * np.arange(samples, dtype=float) / samples
    values = np.array(variable.differentials(cosines(angles, np.cos), np.sqrt))
    cosine = np.fft.rfft(values)[:, 1 : terms + 1].real * (2 / samples)
    found: Array = cosine / np.arange(1, terms + 1)
    return found


def _sum(coefficients: Array, angle: Array) -> Array:
    """Both series of sines (2, N)."""
    sines, twice = np.empty((coefficients.shape[1] + 1, len(angle))), 2 * np.cos(angle)
    sines[0], sines[1] = 0.0, np.sin(angle)
    for before, here, after in zip(sines, sines[1:], sines[2:], strict=False):
        np.multiply(twice, here, out=after)
        after -= before
    found: Array = coefficients @ sines[1:]
    return found
