r"""Sums of sines of an angle, and their derivatives, by Taylor polynomials about equidistant nodes.

However many terms there are, an angle takes the same time.
"""

from __future__ import annotations

from math import factorial

import numpy as np

from kowalevski_cas.motion.arrays import Array

DEGREE = 7
"""Of the polynomials."""

LAST = 2.0**-56
"""What is left out of the sums, beside terms of the size one."""

FEWEST = 64
"""Nodes; their number is a power of two."""


class SumsOfSines:
    r"""Functions :math:`\sum_k a_k\sin k\psi` with a row of coefficients each."""

    def __init__(self, coefficients: Array) -> None:
        rows, terms = coefficients.shape
        orders = np.arange(1, terms + 1)

        def left_out(nodes: int) -> float:
            steps = (np.pi / nodes * orders) ** (DEGREE + 1) / factorial(DEGREE + 1)
            return float(np.max(np.abs(coefficients) @ steps))

        nodes = FEWEST
        while nodes <= 2 * terms or left_out(nodes) > LAST:
            nodes *= 2
        self._nodes, self._step = nodes, 2 * np.pi / nodes
        self._taylor = np.empty((DEGREE + 1, rows, nodes))
        for power, values in enumerate(self._taylor):
            # the derivative of this order by e^{ikψ}, of which the real part is what is looked for
            spectrum = np.zeros((rows, nodes // 2 + 1), dtype=complex)
            spectrum[:, 1 : terms + 1] = coefficients * orders**power * 1j ** (power - 1)
            values[:] = np.fft.irfft(spectrum, nodes) * (nodes / 2 / factorial(power))

    def __call__(self, angle: Array) -> tuple[Array, Array]:
        """The values (rows, N) at angles (N,), and the derivatives."""
        nearest = np.rint(angle / self._step)
        rest = angle - nearest * self._step
        # a power of two: the nodes of other turns are the same ones
        place = nearest.astype(np.int64) & (self._nodes - 1)
        value, *others = self._taylor.take(place, axis=2)[::-1]
        slope = np.zeros_like(value)
        for coefficient in others:
            slope *= rest
            slope += value
            value *= rest
            value += coefficient
        return value, slope
