"""The motion through any state: in closed form where there is one, and without."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass
from fractions import Fraction
from itertools import product
from math import hypot
from typing import Any, NoReturn

import numpy as np

from kowalevski_cas.motion import formulas, point
from kowalevski_cas.motion.methods.ball import start_on_O4
from kowalevski_cas.motion.motion import Motion
from kowalevski_cas.motion.o4.motion import MotionO4
from kowalevski_cas.motion.o4.parameters import Degenerate
from kowalevski_cas.motion.o4.start import on_O4
from kowalevski_cas.motion.parameters import Inadmissible, Real, exact, usable
from kowalevski_cas.motion.units import in_unit, unit_of, without_unit

BESIDE = Fraction(1, 2**200)
"""How near constants are to those at which two roots coincide: no float sees the difference."""


@dataclass(frozen=True)
class General:
    """A motion that is known by its state at t = 0 alone, which integrators follow.

    ``why`` says why it has no closed form.
    """

    point: tuple[float, ...]
    why: str
    off: float = 0.0

    @property
    def constants(self) -> dict[str, float | str]:
        """The values of a, b, c and of the three integrals; in digits what no float holds."""
        return without_unit(self.constants_in_unit, int(unit_of(np.array(self.point))))

    @property
    def constants_in_unit(self) -> dict[str, float]:
        """The constants in a unit of time in which the size of the state is about 1."""
        state = np.array(self.point)
        state = in_unit(state, unit_of(state))
        found = formulas.values_of_offer("integrals")(*state)
        values = dict(zip(formulas.INTEGRALS, map(float, found), strict=True))
        lengths = {"a": hypot(*state[3:6]), "b": hypot(*state[6:])}
        return {**lengths, "c": values["c"], **{name.lower(): values[name] for name in "HKG"}}

    @property
    def parameters(self) -> NoReturn:
        """Raises :class:`~kowalevski_cas.motion.parameters.Inadmissible`, with the reason."""
        raise Inadmissible(
            f"there is no closed form, but integrators follow the motion: {self.why}"
        )


def with_constants_of_O4(s: Real, tau: Real, **given: Any) -> MotionO4 | General:
    """The motion on O⁴ by its constants, also where two roots coincide: there without closed form.

    The state at t = 0 is the limit of those with constants beside, on either side where there are
    motions. Arguments and errors are those of :meth:`~kowalevski_cas.motion.o4.motion.MotionO4.of`.
    """
    try:
        return MotionO4.of(s=s, tau=tau, **given)
    except Degenerate as error:
        for by_s, by_tau in product((BESIDE, -BESIDE, Fraction(0)), repeat=2):
            with suppress(Inadmissible):
                near = MotionO4.of(s=exact(s) * (1 + by_s), tau=exact(tau) * (1 + by_tau), **given)
                return General(tuple(start_on_O4(near).tolist()), str(error))
        raise


AnyMotion = Motion | MotionO4 | General
"""A motion on N⁴, on O⁴, or one of which only the state at t = 0 is known."""


def through(state: Sequence[Real]) -> AnyMotion:
    """The motion that is at the state (ω, α, β), nine numbers, at t = 0.

    It is in closed form, on N⁴ or on O⁴, only if that returns to the state. Raises ``ValueError``
    for what is no state: another count of numbers, or one that is not finite.
    """
    refused = []
    for closed in (point.on_N4, on_O4):
        try:
            return closed(state)
        except Inadmissible as error:
            refused.append(str(error))
    return General(tuple(float(usable(value)) for value in state), "; ".join(refused))
