r"""A motion on N⁴: its constants, its regime, and where it is at t = 0; and a motion off N⁴.

The closed form in the time t − t_j, with signs ±1 that choose the torus where there are
several, is the motion; :func:`~kowalevski_cas.motion.point.on_N4` finds them for a state.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property

import numpy as np

from kowalevski_cas.motion.frame import fields, straighten
from kowalevski_cas.motion.oscillation import Oscillation
from kowalevski_cas.motion.parameters import Parameters, Real, precision, usable
from kowalevski_cas.motion.regimes import Arc, Regime, regime_of, signs_of, without_rounding
from kowalevski_cas.motion.units import in_unit, power, without_unit


@dataclass(frozen=True)
class Motion:
    """A motion by its constants and phases.

    ``origins`` are the times t1, t2 at which s1 and s2 are at the first root p of their
    arcs (see :mod:`~kowalevski_cas.motion.oscillation`). ``signs`` are those of S1 and S2 just
    after t1 and t2: where an arc has two components they choose the torus, elsewhere the other
    sign is the same motion half a period later.
    ``arcs`` are those that the regime does not tell: of a variable that stays on a double root,
    or goes down from the upper of two.
    ``turn`` is (cos χ, sin χ) of the rotation that brings (α, β) = c to zero. ``point`` is the
    state at t = 0 from which integrators start, where it is not that of the closed form, which
    is ``off`` it by so much of its size (ω and fields each of their own).

    Raises :class:`~kowalevski_cas.motion.parameters.Inadmissible` where there is no motion.
    """

    parameters: Parameters
    origins: tuple[Fraction, Fraction] = (Fraction(0), Fraction(0))
    signs: tuple[int, int] = (1, 1)
    arcs: tuple[Arc | None, Arc | None] = (None, None)
    turn: tuple[Fraction, Fraction] = (Fraction(1), Fraction(0))
    point: tuple[float, ...] | None = None
    off: float = 0.0

    def __post_init__(self) -> None:
        """Refuse constants that leave no real motion."""
        _ = self.regime

    @staticmethod
    def of(
        a: Real,
        b: Real,
        m: Real,
        *,
        ell: Real | None = None,
        h: Real | None = None,
        c: Real = 0,
        origins: Sequence[Real] = (0, 0),
        torus: int = 1,
    ) -> Motion:
        r"""The motion in fields of lengths a, b with the scalar product c, by m and ℓ or h.

        ``torus`` is one of those of the regime, numbered from 1. Raises
        :class:`~kowalevski_cas.motion.parameters.Inadmissible` where there is no motion, and
        ``ValueError`` for what is not a finite number, and unless one of ℓ and h is given.
        """
        if (ell is None) == (h is None):
            raise ValueError("one of ℓ and h is needed" + ", not both" * (h is not None))
        longer, shorter, turn = straighten(usable(a), usable(b), usable(c))
        make, last = (Parameters.of, ell) if h is None else (Parameters.at_energy, h)
        assert last is not None
        parameters = make(longer, shorter, usable(m), usable(last))
        t1, t2 = map(usable, origins)
        if all(turn):
            parameters = without_rounding(parameters)
        return Motion(parameters, (t1, t2), signs_of(parameters, torus), turn=turn)

    @cached_property
    def regime(self) -> Regime:
        """The regime of its constants."""
        return regime_of(self.parameters)

    def in_unit(self, unit: int) -> Motion:
        """The same motion in a unit of time in which a rate of this power of two is 1."""
        first, second = (time * power(unit) for time in self.origins)
        point = self.point and tuple(in_unit(np.array(self.point), np.array(unit)).tolist())
        parameters = self.parameters.in_unit(unit)
        return replace(self, parameters=parameters, origins=(first, second), point=point)

    @property
    def constants(self) -> dict[str, float | str]:
        """The lengths a, b of the fields and their scalar product c, the integrals, m and ℓ."""
        return without_unit(self.constants_in_unit, self.parameters.unit)

    @property
    def constants_in_unit(self) -> dict[str, float]:
        """The constants in a unit of time in which a is about 1."""
        known = self.parameters.in_unit(self.parameters.unit)
        a, b, c = fields(known.p_square, known.r_square, self.turn)
        values = (known.h, known.k, known.g, known.m)
        named = {name: float(value) for name, value in zip("hkgm", values, strict=True)}
        with precision(64):
            return {"a": a, "b": b, "c": c, **named, "l": float(known.ell)}

    def oscillations(self) -> tuple[Oscillation, Oscillation]:
        """The separated equations, solved anew at the precision of FLINT's context."""
        first, second = self.arcs
        return (
            Oscillation(self.parameters, first or self.regime.s1, True),
            Oscillation(self.parameters, second or self.regime.s2, False),
        )
