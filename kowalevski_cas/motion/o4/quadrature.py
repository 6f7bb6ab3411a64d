r"""The two quadratures of O⁴, as series, and inverted.

.. math:: \pm\frac{v_1}{\sqrt{R_1}}d\varphi_1\pm\frac{v_2}{\sqrt{R_2}}d\varphi_2=0, \qquad
    \pm\frac{n_1}{\sqrt{R_1}}d\varphi_1\pm\frac{n_2}{\sqrt{R_2}}d\varphi_2=-dt

Each differential is its mean and a series of cosines, which converges geometrically. By the inverse
of the matrix of the means both integrals become :math:`\varphi_k+{}` sines :math:`=\theta_k`, with
phases θ that are linear in time. The map φ ↦ θ is a diffeomorphism of the torus, for its
determinant has the factor :math:`u_1-u_2`; so Newton's method with damping finds φ from anywhere.
"""

from __future__ import annotations

import numpy as np
from flint import arb_mat
from numpy.typing import NDArray

from kowalevski_cas.motion.o4.motion import MotionO4
from kowalevski_cas.motion.o4.variable import Variable
from kowalevski_cas.motion.parameters import Inadmissible

Array = NDArray[np.float64]

SAMPLES = (64, 1 << 15)
"""How many values of a differential are taken at first, and at most."""

NOISE = 1e-16
"""The terms that are left out, relative to the largest."""

NEAR = 1e-10
"""A Newton step after which no other is needed."""

STEPS = 100
"""After so many the method gives up; it takes about six."""


class Quadratures:
    """The quadratures in floating point, with the exact matrix of the means."""

    def __init__(self, motion: MotionO4, matrix: arb_mat) -> None:
        self._matrix = np.array(matrix.tolist(), dtype=float)
        self._variables = [Variable(motion.constants, arc, float) for arc in motion.arcs]
        self._signs = motion.orientations
        inverse = np.array(matrix.inv().tolist(), dtype=float)
        self._series = [
            inverse @ (sign * _sines(variable))
            for sign, variable in zip(self._signs, self._variables, strict=True)
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


def _sines(variable: Variable) -> Array:
    """The coefficients (2, terms) of sin φ, sin 2φ, … in the integrals of the differentials.

    Raises :class:`~kowalevski_cas.motion.parameters.Inadmissible` if there are too many.
    """
    samples, most = SAMPLES
    while samples <= most:
        angle = 2 * np.pi / samples * np.arange(samples)
        values = np.array(variable.differentials(_squares(angle), np.sqrt))
        cosines = np.fft.rfft(values)[:, 1:].real * (2 / samples)
        seen = abs(cosines) > NOISE * abs(values).max(axis=1, keepdims=True)
        terms = int(np.flatnonzero(seen.any(axis=0)).max(initial=0)) + 1
        if 3 * terms < samples:
            found: Array = cosines[:, :terms] / np.arange(1, terms + 1)
            return found
        samples *= 2
    raise Inadmissible(
        "two roots are so close that the series of the quadratures do not converge: any s or τ "
        "farther from those where the tori of O⁴ degenerate would do"
    )


def _sum(coefficients: Array, angle: Array) -> Array:
    """Both series of sines (2, N), by Clenshaw's recurrence."""
    twice = 2 * np.cos(angle)
    one, two = np.zeros((2, len(angle))), np.zeros((2, len(angle)))
    for pair in coefficients.T[::-1]:
        one, two = pair[:, None] + twice * one - two, one
    found: Array = np.sin(angle) * one
    return found
