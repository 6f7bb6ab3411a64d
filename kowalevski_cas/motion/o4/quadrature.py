r"""The two quadratures of O⁴ in floating point, and inverted.

.. math:: \pm\frac{v_1\Delta_1}{y_1}\pm\frac{v_2\Delta_2}{y_2}=0, \qquad
    \pm\frac{n_1\Delta_1}{y_1}\pm\frac{n_2\Delta_2}{y_2}=-dt, \qquad \Delta_k=v_kdn_k-n_kdv_k

Each differential is its mean by dψ and a series of cosines, which converges geometrically. By the
inverse of the matrix of the means both integrals become :math:`\psi_k+{}` sines
:math:`=\theta_k`, with phases θ that are linear in time. The map ψ ↦ θ is a diffeomorphism of the
torus, for its determinant has the factor :math:`n_1v_2-n_2v_1`.

Newton's method with damping mostly finds ψ, from a table if there are many. Where a double root
is near, whole regions of the torus are passed in no time; then two bisections find it: with n − ev
in place of v, e between the arcs, each equation is monotone, the first one in :math:`\psi_2`, and
the second one in :math:`\psi_1` when the first holds.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cached_property

import numpy as np
from flint import arb, arb_mat

from kowalevski_cas.motion.arrays import Array
from kowalevski_cas.motion.jacobi import JacobiFunctions
from kowalevski_cas.motion.o4.arithmetic import FLOATS, Pair
from kowalevski_cas.motion.o4.series import DifferentialSeries, matrix
from kowalevski_cas.motion.o4.sines import SumsOfSines
from kowalevski_cas.motion.o4.uniformization import Uniformization
from kowalevski_cas.motion.parameters import MethodError

SMALLEST = 2.0**-58
"""The coefficients that are left out."""

# the next one would be of the order of its square
NEAR = 1e-10
"""A Newton step after which no other is needed."""

STEPS, HALVINGS = 20, 6
"""Newton steps, and halvings of one, after which bisections go on; it takes about four."""

NODES = 64
"""Phases, of either variable, at which the angles are tabulated: a power of two."""

LAST = 2.0**-51
"""The length of a bracket, relative to π, in which nothing is to be found any more."""


Derived = tuple[Array, Array, Array]


class Quadratures:
    """The phases by the angles, and the angles by the phases.

    Raises :class:`~kowalevski_cas.motion.parameters.MethodError` if with half of the values the
    series would not be the same.
    """

    def __init__(self, series: Sequence[DifferentialSeries], signs: Sequence[int]) -> None:
        means = matrix([integral.means() for integral in series], signs)
        inverse = means.inv()
        self.rates = means.solve(arb_mat([[0], [-1]])).entries()
        self._amplitudes = []
        for sign, integral in zip(signs, series, strict=True):
            found = inverse * arb_mat([[sign * x for x in row] for row in integral.sines()])
            coefficients = np.array(found.tolist(), dtype=float)
            large = np.flatnonzero(np.max(np.abs(coefficients), axis=0) > SMALLEST)
            terms = int(large[-1]) + 1 if len(large) else 1
            if 2 * terms > coefficients.shape[1]:
                raise MethodError("half of the values do not tell the series of the quadratures")
            self._amplitudes.append(coefficients[:, :terms])
        self._forms = np.array(
            (_monotone_forms([integral.by for integral in series]) * means).tolist(), dtype=float
        )
        self._sums = [SumsOfSines(amplitudes) for amplitudes in self._amplitudes]

    def phases(self, angles: Array) -> Array:
        """The phases θ (2, N) by the angles ψ."""
        (one, _), (two, _) = (self._part(place, angle) for place, angle in enumerate(angles))
        return one + two

    def angles(self, phases: Array) -> Array:
        """The angles ψ (2, N) by the phases θ."""
        turns = 2 * np.pi * np.rint(phases / (2 * np.pi))
        aim = phases - turns
        many = aim.shape[1] > NODES * NODES  # the table takes as long as so many phases
        found: Array = self._solve(aim, self._interpolated(aim) if many else aim)
        return found + turns

    def _solve(self, aim: Array, start: Array) -> Array:
        """The angles by the phases, by Newton's method from some nearby."""
        found: Array = np.empty_like(aim)
        left, here = np.arange(aim.shape[1]), start
        rest, slopes = self._missing(here, aim)
        for _ in range(STEPS):
            step = _solution(slopes, rest)
            last = _squares(step) <= NEAR**2
            if 2 * np.count_nonzero(last) >= len(left):  # sorting out fewer takes longer
                found[:, left[last]] = here[:, last] + step[:, last]
                left = left[~last]
                here, step, rest, aim = (x[:, ~last] for x in (here, step, rest, aim))
            if not len(left):
                break
            here, rest, slopes = self._damp(here, step, rest, aim)
        else:
            found[:, left] = self._bisect(aim)
        return found

    def _damp(self, start: Array, step: Array, rest: Array, aim: Array) -> Derived:
        """Where as much of a step leads as diminishes the rest; what then is left, and slopes."""
        before, here = _squares(rest), start + step
        after, slopes = self._missing(here, aim)
        for _ in range(HALVINGS):
            worse = (_squares(after) > before) & (_squares(step) > NEAR**2)
            if not worse.any():
                break
            step[:, worse] /= 2
            here[:, worse] = start[:, worse] + step[:, worse]
            after[:, worse], slopes[:, :, worse] = self._missing(here[:, worse], aim[:, worse])
        return here, after, slopes

    def _bisect(self, aim: Array) -> Array:
        """The angles by two monotone equations, one inside the other."""
        wanted, (by_first, by_second) = self._forms @ aim, self._forms[0]
        reach = 1 + sum(np.sum(np.abs(a[0])) for a in self._amplitudes)
        reach_of_form = sum(np.sum(np.abs(self._forms[0] @ a)) for a in self._amplitudes)
        half = 0.1 + reach_of_form / abs(by_second)
        second = np.empty_like(aim[1])

        def on_first_equation(first: Array) -> tuple[Array, Array]:
            part, (a, c) = self._monotone_part(0, first)

            def inner(angle: Array) -> tuple[Array, Array]:
                other, slopes = self._monotone_part(1, angle)
                return part[0] + other[0] - wanted[0], slopes[0]

            middle = (wanted[0] - by_first * first) / by_second
            second[:] = _monotone_root(inner, middle - half, middle + half)
            other, (b, d) = self._monotone_part(1, second)
            return part[1] + other[1] - wanted[1], c - d * a / b

        first = _monotone_root(on_first_equation, aim[0] - reach, aim[0] + reach)
        on_first_equation(first)
        return np.array([first, second])

    def _monotone_part(self, place: int, angle: Array) -> tuple[Array, Array]:
        """The part of one angle in both monotone forms, and its derivatives."""
        values, slopes = self._part(place, angle)
        return self._forms @ values, self._forms @ slopes

    def _missing(self, angles: Array, aim: Array) -> tuple[Array, Array]:
        """What the phases lack of those aimed at, and their slopes (variable, phase, N)."""
        slopes = np.empty((2, *angles.shape))
        rest = aim
        for place, angle in enumerate(angles):
            values, slopes[place] = self._part(place, angle)
            rest = rest - values
        return rest, slopes

    def _part(self, place: int, angle: Array) -> tuple[Array, Array]:
        """The part of one angle in both phases (2, N), and its derivatives."""
        values, slopes = self._sums[place](angle)
        values[place] += angle
        slopes[place] += 1.0
        return values, slopes

    @cached_property
    def _grid(self) -> Array:
        """The angles less the phases at equidistant phases."""
        nodes = 2 * np.pi / NODES * np.arange(NODES)
        phases = np.array(np.meshgrid(nodes, nodes, indexing="ij")).reshape(2, -1)
        phases -= 2 * np.pi * np.rint(phases / (2 * np.pi))
        difference: Array = self._solve(phases, phases) - phases
        return difference

    def _interpolated(self, phases: Array) -> Array:
        """The angles by the phases, almost."""
        places = phases * (NODES / (2 * np.pi))
        low = np.floor(places)
        (x, y), (i, j) = places - low, low.astype(np.int64)
        rows, columns = ([k & NODES - 1, k + 1 & NODES - 1] for k in (i, j))
        found: Array = phases.copy()
        for row, by_x in zip(rows, (1 - x, x), strict=True):
            for column, by_y in zip(columns, (1 - y, y), strict=True):
                found += self._grid.take(row * NODES + column, axis=1) * (by_x * by_y)
        return found


class Halves:
    """The pair (c, s) of a variable by arrays of angles ψ."""

    def __init__(self, by: Uniformization) -> None:
        self._by, self._quarters = by, by.quarters
        self._functions = JacobiFunctions(by.quarter, by.other_quarter, by.complement_square)

    def __call__(self, angles: Array) -> Pair:
        """The pair; it changes its sign after a turn."""
        turns = np.rint(angles / (2 * np.pi))
        rest = (angles - 2 * np.pi * turns) / np.pi * self._quarters
        quarter = np.rint(rest)
        functions = self._functions(quarter, rest - quarter)
        c, s = self._by.pair(functions, np.where(rest < 0, -1.0, 1.0), FLOATS)
        sign = np.where(turns % 2, -1.0, 1.0)
        return sign * c, sign * s


def _solution(slopes: Array, rest: Array) -> Array:
    """The step (2, N) that by these slopes makes up for a rest; half a turn where it is longer."""
    (a, c), (b, d) = slopes
    step = np.array([d * rest[0] - b * rest[1], a * rest[1] - c * rest[0]])
    with np.errstate(divide="ignore"):
        step /= a * d - b * c
    return np.clip(step, -np.pi, np.pi, out=step)


def _squares(vectors: Array) -> Array:
    """The squares of the lengths of vectors (2, N)."""
    found: Array = vectors[0] * vectors[0] + vectors[1] * vectors[1]
    return found


def _monotone_forms(arcs: Sequence[Uniformization]) -> arb_mat:
    """A row for each of two numbers e between the arcs, of which n − ev is a combination.

    Where both arcs are finite one of them is ∞. Otherwise the first one is in the wider gap.
    """
    known, (first, second) = arcs[0].known, (by.arc for by in arcs)
    (x, y), (low, high) = ([known.root(name) for name in arc.ends] for arc in (first, second))
    if not second.infinite:
        inner = (y + low) / 2 if y < low else (high + x) / 2
        return arb_mat([[1, 0], [-inner, 1]])
    gaps = sorted([(low - y, y + low), (x - high, x + high)], key=lambda gap: -float(gap[0]))
    return arb_mat([[-total / 2, arb(1)] for _, total in gaps])


def _monotone_root(
    function: Callable[[Array], tuple[Array, Array]], low: Array, high: Array
) -> Array:
    """The zero of a monotone function, with its derivative, in a bracket: by Newton or halving."""
    rising = function(high)[0] > 0
    place = (low + high) / 2
    while True:
        value, slope = function(place)
        above = (value > 0) == rising
        low, high = np.where(above, low, place), np.where(above, place, high)
        with np.errstate(divide="ignore", invalid="ignore"):
            newton = place - value / slope
        near = np.abs(newton - place) < (high - low) / 4
        inside = (newton >= low) & (newton <= high) & near
        after = np.where(inside, newton, (low + high) / 2)
        if np.all((np.abs(after - place) <= LAST * np.pi) | (high - low <= LAST * np.pi)):
            return after
        place = after
