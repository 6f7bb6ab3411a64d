"""Levels of the three integrals: how many tori they have, and the energies that separate."""

from fractions import Fraction
from itertools import pairwise
from math import hypot, sqrt

import numpy as np
import pytest

from kowalevski_cas.motion import Motion, MotionO4
from kowalevski_cas.motion.diagram import Fields
from kowalevski_cas.motion.energies import kind, separating_energies
from kowalevski_cas.motion.formulas import values_of_offer
from kowalevski_cas.motion.levels import count_tori, on_level
from kowalevski_cas.motion.methods.integrators import initial_state
from kowalevski_cas.motion.section import neighbours
from tests.sample import sampled

FIELDS = Fields(Fraction("1.2"), Fraction("0.7"))
LENGTHS = [("1.2", "0.7"), ("1", "0.4"), ("1", "0.01"), ("1", "0.95"), ("3e8", "2e8")]

ON_THE_BOUNDARY = [
    *(Motion.of(a, b, m, ell=ell) for a, b, m, ell in (("1.2", "0.7", "0.6", "0.9"), ("1.2", "0.7", "0.9", "1.5"), ("1", "0.4", "0.8", "0.9"), ("1", "0.4", "2", "7"))),
    MotionO4.of("1.2", "0.7", "-0.9", "0.6"),
]  # fmt: skip
"""Motions on elliptic tori whose values of the integrals are on the boundary of those of all."""


def level_beside(motion):
    """The values (h, k, g) of a motion beside this one."""
    (beside,) = neighbours(initial_state(motion), [0.1])
    h, k, *_, g, _, _ = values_of_offer("integrals")(*beside)
    return float(h), float(k), float(g)


@pytest.mark.parametrize("motion", sampled(ON_THE_BOUNDARY, 1))
def test_about_elliptic_tori_on_the_boundary_of_all_values_there_is_one_torus_each(motion):
    fields = Fields(motion.parameters.a, motion.parameters.b)
    assert count_tori(fields, [level_beside(motion)]) == [motion.regime.tori]


@pytest.mark.slow
def test_levels_in_chambers_have_one_two_or_four_tori_in_any_unit_of_time():
    levels = [(0.95, 0.629, -0.493), (0.0, 1.57, -0.002), (3.8, 0.0128, 3.398)]
    assert count_tori(FIELDS, levels) == [2, 1, 4]
    nu = 1000
    scaled = [(nu**2 * h, nu**4 * k, nu**6 * g) for h, k, g in levels[1:2]]
    assert count_tori(Fields(nu**2 * FIELDS.a, nu**2 * FIELDS.b), scaled) == [1]


def test_states_on_a_level_are_on_it():
    states = on_level(FIELDS, 2.286, 0.264, 1.958)
    values = np.array(values_of_offer("integrals")(*states.T)[:6]).T
    np.testing.assert_allclose(
        values, [[2.286, 0.264, 1.44, 0.49, 0, 1.958]] * len(states), atol=1e-8
    )
    assert len(states) > 10


@pytest.mark.slow
def test_where_there_is_no_motion_there_are_no_tori():
    assert count_tori(FIELDS, [(-1.0, 100.0, 5.0)]) == [0]


@pytest.mark.parametrize(("a", "b"), sampled(LENGTHS, 1))
def test_the_energies_that_separate_are_those_of_special_motions(a, b):
    """Of the equilibria ±a±b, of O⁴ where σ = 0 or s is ±a, ±b, and where τ₃ = 0; and one more."""
    found = separating_energies(Fields(Fraction(a), Fraction(b)))
    a, b = float(a), float(b)
    ab, p = 2 * sqrt(a * b), sqrt(2) * hypot(a, b)
    known = {-a - b, -ab, -2 * b, b - a, a - b, 2 * b, ab, a + b, p, 2 * a}
    known |= {(3 * a * a + b * b) / (2 * a), (a * a + 3 * b * b) / (2 * b)}
    off = [min(abs(one - other) for other in found) for one in known]
    assert max(off) < 1e-4 * (a + b)
    assert len(found) == len(known) + 1


@pytest.mark.slow
@pytest.mark.parametrize("b", sampled(["0.4", "0.6", "0.75"], 1))
def test_between_them_nothing_changes_on_the_curves(b):
    fields = Fields(Fraction(1), Fraction(b))
    for low, high in pairwise(separating_energies(fields)):
        if high - low > 0.03:
            below, above = (kind(fields, h) for h in ((3 * low + high) / 4, (low + 3 * high) / 4))
            on_M4, _, _, *on_O4 = zip(below, above, strict=True)  # parts of N⁴ may be too narrow
            assert all(one == other for one, other in (on_M4, *on_O4))


@pytest.mark.slow
@pytest.mark.parametrize("b", ["0.2", "0.55", "0.8"])
def test_within_a_chamber_all_levels_have_equally_many(b):
    fields = Fields(Fraction(1), Fraction(b))
    for motion in (Motion.of(1, b, "0.7", ell="2.6"), Motion.of(1, b, "1.5", ell="5")):
        beside = neighbours(initial_state(motion), [0.02, 0.05, 0.1])
        levels = [
            tuple(map(float, np.array(values_of_offer("integrals")(*x))[[0, 1, 5]])) for x in beside
        ]
        assert set(count_tori(fields, levels)) == {motion.regime.tori}
