"""A motion as it was followed: times, states, constants, and how well the integrals were kept."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property

import numpy as np

from kowalevski_cas.motion import formulas
from kowalevski_cas.motion.arrays import Array
from kowalevski_cas.motion.attitude import quaternions
from kowalevski_cas.motion.critical import SETS, on, residuals
from kowalevski_cas.motion.diagram import Fields
from kowalevski_cas.motion.frequencies import frequencies
from kowalevski_cas.motion.general import AnyMotion, General
from kowalevski_cas.motion.motion import Motion
from kowalevski_cas.motion.o4 import transverse as o4
from kowalevski_cas.motion.o4.motion import MotionO4
from kowalevski_cas.motion.parameters import Inadmissible, precision
from kowalevski_cas.motion.regimes import coincidences, tori
from kowalevski_cas.motion.transverse import exponent, kind, kind_at
from kowalevski_cas.motion.units import in_unit, unit_of

INTEGRALS = {"H": "H", "K": "K", "G": "G", "a^2": "a2", "b^2": "b2", "c": "c"}
"""The integrals whose drift is told, and their names there."""


@dataclass(frozen=True)
class Trajectory:
    """States of shape (N, 9) at times of shape (N,).

    ``radii`` (N,) are those of enclosures: no number of a state is farther from the exact one.
    ``also`` is what else is told of it: its ``frequencies``, the ``attitude`` at each state.
    """

    motion: AnyMotion
    times: Array
    states: Array
    radii: Array | None = None
    also: tuple[str, ...] = ()

    @property
    def rows(self) -> list[list[float]]:
        """Each state as nine numbers; there is no −0."""
        rows: list[list[float]] = (self.states + 0.0).tolist()
        return rows

    @property
    def invariants(self) -> dict[str, object]:
        """The constants of the motion, how far it begins from a given state, and the drift."""
        return {**self.motion.constants, "off": self.motion.off, "drift": self.drift}

    @cached_property
    def attitude(self) -> Array:
        """The quaternions (N, 4) that turn the body's axes into those of space."""
        return quaternions(self.states)

    @cached_property
    def drift(self) -> dict[str, float]:
        """The largest change of each integral, relative to what it is for the size of the state.

        Those of the fields alone are relative to the fields, which are tiny for a fast top.
        """
        states = in_unit(self.states, unit_of(self.states[0]))
        fields = np.max(np.abs(states[0, 3:])) ** 2 or 1.0
        sizes = {"a^2": fields, "b^2": fields, "c": fields}
        values = formulas.values_of_offer("integrals")(*states.T)
        return {
            INTEGRALS[name]: float(np.max(np.abs(value - value[0]) / sizes.get(name, 1.0)))
            for name, value in zip(formulas.INTEGRALS, map(np.atleast_1d, values), strict=True)
            if name in INTEGRALS
        }

    @cached_property
    def critical_sets(self) -> dict[str, object]:
        """On which of M⁴, N⁴, O⁴ the motion is, and the residuals: the first and the largest.

        A residual is None where the equations of N⁴ say nothing, at x1x2 = 0.
        """
        found = residuals(self.states)
        first = {name: float(found[name][0]) for name in SETS}
        if isinstance(self.motion, Motion):
            first["N4"] = np.fmin(first["N4"], self.motion.off)
        if isinstance(self.motion, MotionO4):
            first["O4"] = min(first["O4"], self.motion.off)
        largest = {name: float(np.fmax.reduce(found[name])) for name in SETS}
        return {
            "on": on(first),
            "residuals": {"first": _without_nan(first), "largest": _without_nan(largest)},
        }

    @property
    def regime(self) -> dict[str, object]:
        """The regime: the roots in order, the arcs of s1 and s2, the tori, the moduli k², |λ|."""
        motion = self.motion
        if isinstance(motion, General):
            return {"none": motion.why, **self._on_M4(motion)}
        if isinstance(motion, MotionO4):
            return {
                "order": str(motion.regime),
                "u1": str(motion.regime.u1),
                "u2": str(motion.regime.u2),
                "tori": motion.regime.tori,
                "transversely": o4.kind_at(motion.point)
                if motion.point
                else o4.kind(motion.parameters),
            }
        regime = motion.regime
        with precision(64):
            squares = [float(o.modulus_square) for o in motion.oscillations()]
        return {
            "order": str(regime),
            "s1": str(regime.s1),
            "s2": str(regime.s2),
            "tori": tori(motion.parameters),
            "k1_squared": squares[0],
            "k2_squared": squares[1],
            "lambda": abs(exponent(motion.parameters)),
            "transversely": kind_at(motion.point) if motion.point else kind(motion.parameters),
            "separating": coincidences(motion.parameters),
        }

    @property
    def frequencies(self) -> dict[str, object]:
        """The frequencies, the rotation number and the actions of the torus, or why it has none."""
        if isinstance(self.motion, General):
            return {"none": self.motion.why}
        try:
            found = frequencies(self.motion)
        except Inadmissible as error:
            return {"none": str(error)}
        return {
            "frequencies": list(found.frequencies),
            "rotation_number": found.rotation_number,
            "actions": list(found.actions),
        }

    def _on_M4(self, motion: General) -> dict[str, object]:
        """The number of tori on the level of a motion on M⁴ that fills one of them."""
        values = motion.constants_in_unit
        p_square = values["a"] ** 2 + values["b"] ** 2
        r_square = np.hypot(values["a"] ** 2 - values["b"] ** 2, 2 * values["c"])
        longer, shorter = np.sqrt([(p_square + r_square) / 2, max(p_square - r_square, 0.0) / 2])
        if self.critical_sets["on"] != ["M4"] or not 0 < shorter < longer:
            return {}
        fields = Fields(Fraction(longer), Fraction(shorter))
        h, g = np.array([values["h"]]), np.array([values["g"]])
        return {"tori": int(fields.tori_on_M4(h, fields.j(h, g))[0])}


def _without_nan(values: dict[str, float]) -> dict[str, float | None]:
    return {name: None if np.isnan(value) else value for name, value in values.items()}
