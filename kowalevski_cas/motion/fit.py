"""The motion on N⁴ nearest to a state, by the method of Gauss and Newton.

Where x1x2 is almost zero the printed formulas for the constants and phases divide by it, and lose
the digits that the state still has: the constants, the phases and the state are smooth functions
of each other there too.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction

import numpy as np

from kowalevski_cas.motion.arrays import Array
from kowalevski_cas.motion.methods.ball import enclosures
from kowalevski_cas.motion.motion import Motion
from kowalevski_cas.motion.parameters import Inadmissible, Parameters
from kowalevski_cas.motion.phases import as_fraction

STEPS = 3

SMALL = Fraction(1, 2**80)
"""The change of a constant or a phase, of its size, by which derivatives are found."""

BITS = 192


def nearest(motion: Motion, state: Sequence[Fraction], weights: Array) -> Motion:
    """The motion through the point of N⁴ nearest to a state, near which another motion begins.

    The fields stay as they are; differences from the state are multiplied by the weights. On a
    separating curve, where the state does not tell the phases, the motion is left as it is.
    """
    oscillations = motion.oscillations()
    if any(oscillation.kind != "elliptic" for oscillation in oscillations):
        return motion
    known = motion.parameters
    values = [known.m, as_fraction(known.ell), *motion.origins]
    times = (1 / as_fraction(oscillation.rate) for oscillation in oscillations)
    sizes = [abs(known.m), Fraction(1), *times]

    def moved(values: Sequence[Fraction]) -> Motion:
        m, ell, t1, t2 = values
        parameters = Parameters.of(known.a, known.b, m, ell)
        return replace(motion, parameters=parameters, origins=(t1, t2))

    def off(values: Sequence[Fraction]) -> list[Fraction]:
        (there,) = enclosures(moved(values), [0.0], BITS)
        return [as_fraction(x) - y for x, y in zip(there, state, strict=True)]

    try:
        for _ in range(STEPS):
            here = off(values)
            columns = []
            for place, size in enumerate(sizes):
                beside = off([x + (k == place) * size * SMALL for k, x in enumerate(values)])
                columns.append([float((x - y) / SMALL) for x, y in zip(beside, here, strict=True)])
            jacobian = np.array(columns).T * weights[:, None]
            step, *_ = np.linalg.lstsq(jacobian, -weights * [float(x) for x in here])
            values = [
                x + Fraction(float(part)) * size
                for x, part, size in zip(values, step, sizes, strict=True)
            ]
        return moved(values)
    except (Inadmissible, ArithmeticError):
        return motion
