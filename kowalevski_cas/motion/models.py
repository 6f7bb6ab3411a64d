r"""Three models of one motion, from the largest to the smallest.

* the nine equations (3), (5), which know nothing of N⁴: an error can leave it;
* the two separated equations, as the equations of Jacobi's sn, cn, dn for each variable: they
  are regular at the turning points and where :math:`s_1=\infty`, and whatever the error, the
  state is on N⁴ and on the right torus;
* the closed form (:mod:`~kowalevski_cas.motion.methods.closed`), which has no errors to pile up.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kowalevski_cas.motion import formulas
from kowalevski_cas.motion.compile import Function
from kowalevski_cas.motion.jacobi import Quadruple
from kowalevski_cas.motion.methods.closed import Closed
from kowalevski_cas.motion.methods.integrators import initial_state
from kowalevski_cas.motion.motion import Motion
from kowalevski_cas.motion.parameters import precision

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Model:
    """An autonomous system: its values at t = 0, their rates, and the states that they mean.

    ``rates`` takes the values as separate numbers; ``states`` takes an array (N, values) and
    returns an array (N, 9).
    """

    start: Array
    rates: Function
    states: Callable[[Array], Array]


def nine(motion: Motion) -> Model:
    """The nine equations."""
    return Model(initial_state(motion), formulas.equations(), lambda values: values)


def separated(motion: Motion) -> Model:
    """The two separated equations, by sn, cn, dn of each variable: six numbers.

    Raises ``ValueError`` where a variable goes from one double root to another: there the
    solution is an exponential, which has no sn, cn, dn.
    """
    closed = Closed(motion, 0.0)
    with precision(128):
        oscillations = motion.oscillations()
        if any(oscillation.kind == "exponential" for oscillation in oscillations):
            raise ValueError("both pairs of roots coincide: an exponential solves the equation")
        (n1, k1, rest1), (n2, k2, rest2) = (
            (float(o.rate), float(o.modulus_square.sqrt()), float(o.complement_square))
            for o in oscillations
        )
    zero = np.zeros(1)
    start = [t / four for *three, four in closed.quadruples(zero, zero) for t in three]
    rates = formulas.jacobi_rates()

    def right(*values: float) -> tuple[float, ...]:
        return (*rates(*values[:3], n1, k1), *rates(*values[3:], n2, k2))

    def meaning(values: Array) -> Array:
        sn1, cn1, _, sn2, cn2, _ = values.T
        return closed.states(_completed(sn1, cn1, rest1), _completed(sn2, cn2, rest2)).T

    return Model(np.concatenate(start), right, meaning)


def _completed(sn: Array, cn: Array, complement: float) -> Quadruple:
    """The quadruple by the quotient of sn and cn alone, on the curves that they have to obey."""
    return sn, cn, np.sqrt(cn**2 + complement * sn**2), np.hypot(sn, cn)
