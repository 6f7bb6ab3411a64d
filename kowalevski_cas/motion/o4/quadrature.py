r"""The two quadratures of O⁴, as series, and inverted.

.. math:: \pm\frac{v_1}{\sqrt{R_1}}d\varphi_1\pm\frac{v_2}{\sqrt{R_2}}d\varphi_2=0, \qquad
    \pm\frac{n_1}{\sqrt{R_1}}d\varphi_1\pm\frac{n_2}{\sqrt{R_2}}d\varphi_2=-dt

Each differential is its mean and a series of cosines, which converges geometrically. By the inverse
of the matrix of the means both integrals become :math:`\varphi_k+{}` sines :math:`=\theta_k`, with
phases θ that are linear in time. The map φ ↦ θ is a diffeomorphism of the torus, for its
determinant has the factor :math:`u_1-u_2`; so Newton's method with damping finds φ from anywhere.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from kowalevski_cas.motion.o4.motion import MotionO4
from kowalevski_cas.motion.o4.series import Series, matrix
from kowalevski_cas.motion.o4.variable import Variable

Array = NDArray[np.float64]

BITS = 54
"""How small the terms are that are left out."""

NEAR = 1e-10
"""A Newton step after which no other is needed."""

STEPS = 100
"""After so many the method gives up; it takes about six."""


class Quadratures:
    """The quadratures in floating point."""

    def __init__(self, motion: MotionO4, series: Sequence[Series]) -> None:
        means = matrix(series, motion.orientations)
        self._matrix = np.array(means.tolist(), dtype=float)
        self._variables = [Variable(motion.parameters, arc, float) for arc in motion.arcs]
        self._signs = motion.orientations
        inverse = np.array(means.inv().tolist(), dtype=float)
        self._series = [
            inverse @ (sign * _sines(variable, one.terms(BITS)))
            for sign, variable, one in zip(self._signs, self._variables, series, strict=True)
        ]

    def phases(self, angles: Array) -> Array:
        """The phases θ (2, N) by the angles φ."""
        return angles + sum(map(_sum, self._series, angles))

    def angles(self, phases: Array) -> Array:
        """The angles φ (2, N) by the phases θ; raises ``ArithmeticError`` if none are found."""
        found = phases.copy()
        left = np.arange(phases.shape[1])
        rest = phases - self.phases(found)
        for _ in range(STEPS):
            step = self._step(found[:, left], rest)
            trial = found[:, left] + step
            missing = phases[:, left] - self.phases(trial)
            for _ in range(STEPS):
                worse = np.flatnonzero(
                    (np.hypot(*missing) > np.hypot(*rest)) & (np.hypot(*step) > NEAR)
                )
                if not len(worse):
                    break
                step[:, worse] /= 2
                trial[:, worse] = found[:, left[worse]] + step[:, worse]
                missing[:, worse] = phases[:, left[worse]] - self.phases(trial[:, worse])
            found[:, left] = trial
            more = np.hypot(*step) > NEAR
            left, rest = left[more], missing[:, more]
            if not len(left):
                return found
        raise ArithmeticError("Newton's method has not inverted the quadratures")

    def _step(self, angles: Array, rest: Array) -> Array:
        """Newton's step: the change of the angles that changes the phases by the rest."""
        (a, c), (b, d) = (
            [sign * value for value in variable.differentials(_squares(angle), np.sqrt)]
            for sign, variable, angle in zip(self._signs, self._variables, angles, strict=True)
        )
        x, y = self._matrix @ rest
        step: Array = np.array([d * x - b * y, a * y - c * x]) / (a * d - b * c)
        return step


def _squares(angle: Array) -> tuple[Array, Array]:
    cos = np.cos(angle)
    return (1 + cos) / 2, (1 - cos) / 2


def _sines(variable: Variable, terms: int) -> Array:
    """The coefficients (2, terms) of sin φ, sin 2φ, … in the integrals of the differentials."""
    samples = 4 * terms
    angle = 2 * np.pi / samples * np.arange(samples)
    values = np.array(variable.differentials(_squares(angle), np.sqrt))
    cosines = np.fft.rfft(values)[:, 1 : terms + 1].real * (2 / samples)
    found: Array = cosines / np.arange(1, terms + 1)
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
