"""The chambers of the diagram: none is missed, their walls agree, and motions count the same."""

from fractions import Fraction
from itertools import product

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from kowalevski_cas.motion.chambers import Strips, chambers
from kowalevski_cas.motion.cut import values
from kowalevski_cas.motion.diagram import Fields
from kowalevski_cas.motion.energies import representatives
from kowalevski_cas.motion.levels import count_tori
from kowalevski_cas.motion.walls import CurveO4, walls
from tests.sample import sampled

FIELDS = Fields(Fraction("1.2"), Fraction("0.7"))

shorter = st.one_of(
    st.integers(1, 99).map(lambda n: Fraction(n, 100)),
    st.floats(-3, -1).map(lambda power: Fraction(10.0**power)),
    st.floats(-3, -1).map(lambda power: 1 - Fraction(10.0**power)),
)
energies = st.one_of(st.floats(-0.999, 3), st.floats(3, 100))


def energy(fields, share):
    return Fraction(share) * (fields.a + fields.b)


@pytest.mark.slow
@given(shorter, energies)
def test_no_state_is_outside_of_all_chambers(b, share):
    """States by chance have values in a cell: the diagram has no chamber that was not found."""
    fields = Fields(Fraction(1), b)
    h = energy(fields, share)
    cells = [cell for chamber in chambers(fields, h) for cell in chamber.cells]
    g, root = (x[:200] for x in values(fields, float(h)))
    room = 1e-6 * (np.ptp(g) + np.max(root))
    for x, y in zip(g, root, strict=True):
        inside = False
        for cell in cells:
            if cell.low - room <= y <= cell.high + room:
                left, right = cell.at(float(np.clip(y, cell.low, cell.high)))
                inside |= left - room <= x <= right + room
        assert inside


@given(shorter, energies)
def test_all_walls_of_a_chamber_leave_the_same_numbers_of_tori(b, share):
    """Those of M⁴, N⁴ and O⁴ around it, each counted by its own regimes."""
    fields = Fields(Fraction(1), b)
    found = chambers(fields, energy(fields, share))
    assert found and all(chamber.numbers for chamber in found)
    assert {chamber.tori for chamber in found} <= {1, 2, 4, 8, None}
    assert all(chamber.tori for chamber in found if chamber.depth > 0.1)


@pytest.mark.slow
@given(shorter, energies, st.integers(-20, 20))
def test_in_another_unit_of_time_the_chambers_are_the_same(b, share, power):
    one, unit = Fields(Fraction(1), b), Fraction(2) ** power
    other = Fields(unit, b * unit)
    here, there = (chambers(fields, energy(fields, share)) for fields in (one, other))
    assume(all(chamber.depth > 1e-6 for chamber in here))
    assert [chamber.numbers for chamber in here] == [chamber.numbers for chamber in there]


@given(shorter, energies)
def test_a_wall_is_on_the_curve_of_O4(b, share):
    """Where it begins, ends and in between the polynomial Q has a double root."""
    fields = Fields(Fraction(1), b)
    h = energy(fields, share)
    p_square, product = 1 + float(b) ** 2, float(b) ** 2
    for wall in CurveO4(fields, h).walls():
        for root in (wall.low, (wall.low + wall.high) / 2, wall.high):
            k, g = root**2, wall.g(root)
            Q = np.polynomial.Polynomial(
                [product, -2 * g, float(h) ** 2 + p_square - k, -2 * float(h), 1]
            )
            slopes = Q.deriv().roots()
            real = slopes[abs(slopes.imag) < 1e-5].real
            assert np.min(abs(Q(real))) < 1e-7 * (1 + float(h) ** 2) ** 2


LEVELS = list(product(["0.2", "0.6", "0.9"], (-0.9, -0.5, 0.0, 0.5, 1.0, 1.5)))


@pytest.mark.slow
@pytest.mark.parametrize(("b", "share"), sampled(LEVELS, 1))
def test_motions_that_are_followed_count_the_same_where_a_chamber_is_wide(b, share):
    fields = Fields(Fraction(1), Fraction(b))
    wide = [one for one in chambers(fields, energy(fields, share)) if one.depth > 0.02]
    counted = count_tori(fields, [chamber.level for chamber in wide])
    pairs = zip(counted, wide, strict=True)
    assert wide and all(count in chamber.numbers for count, chamber in pairs)


@pytest.mark.slow
def test_in_nine_of_ten_wide_chambers_by_chance_motions_count_the_same():
    """For as long as they are followed; nearer to a = b they fill their tori more slowly.

    And almost all chambers, however narrow, have walls that leave one number alone.
    """
    random, same, told = np.random.default_rng(6), [], []
    while len(same) < 30:
        fields = Fields(Fraction(1), Fraction(random.uniform(0.1, 0.9)))
        found = chambers(fields, energy(fields, random.uniform(-0.99, 5)))
        told += [chamber.tori is not None for chamber in found]
        wide = [chamber for chamber in found if chamber.depth > 0.02]
        for count, chamber in zip(
            count_tori(fields, [one.level for one in wide]), wide, strict=True
        ):
            same.append(count in chamber.numbers)
    assert np.mean(same) > 0.9 and np.mean(told) > 0.95


def test_a_narrow_chamber_has_eight_tori():
    """Between four elliptic tori of O⁴ and four hyperbolic ones of N⁴, above eight of M⁴."""
    narrow = [chamber for chamber in chambers(FIELDS, Fraction(3)) if chamber.tori == 8]
    assert len(narrow) == 1 and narrow[0].depth < 0.002


def test_below_all_states_there_are_none():
    assert chambers(FIELDS, Fraction(-2)) == []


@pytest.mark.slow
def test_between_separating_energies_the_chambers_stay_the_same():
    low, high = representatives(FIELDS)[3:5]
    types = [Strips(FIELDS, Fraction(h)).type() for h in np.linspace(-0.49, 0.49, 7)]
    assert all(one == types[0] for one in types) and low < 0.5 < high
    assert Strips(FIELDS, Fraction("0.51")).type() != types[0]
    assert len(walls(FIELDS, Fraction(0))) == 8
