"""The bifurcation diagram of the whole top: its values, its regions, and real points in them."""

from fractions import Fraction
from itertools import product

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from kowalevski_cas.motion import Inadmissible, load
from kowalevski_cas.motion.critical import residuals
from kowalevski_cas.motion.cut import rotations, section, values
from kowalevski_cas.motion.diagram import Fields
from kowalevski_cas.motion.formulas import INTEGRALS, values_of_offer
from kowalevski_cas.motion.o4.parameters import ParametersO4
from kowalevski_cas.motion.o4.regimes import regime_of
from kowalevski_cas.motion.pictures.regions import fill_regions
from kowalevski_cas.motion.pictures.subsystems import separating_curves
from kowalevski_cas.pictures import new_figure
from tests.motion.levels_on_M4 import at_level, by_chance, critical_levels, pieces
from tests.motion.test_closed import motions
from tests.motion.test_critical import state_of
from tests.sample import sampled

FIELDS = Fields(Fraction(6, 5), Fraction(7, 10))
OTHERS = [FIELDS, Fields(Fraction(1), Fraction(2, 5)), Fields(Fraction(2), Fraction(19, 10))]


shares = st.floats(0.01, 0.99)


def at(states):
    return dict(zip(INTEGRALS, values_of_offer("integrals")(*np.atleast_2d(states).T), strict=True))


def points_on_O4(count, seed):
    """Real states of O⁴ with s, by its rational formulas."""
    random = np.random.default_rng(seed)
    w = random.normal(size=(count, 2)) @ (1, 1j)
    z = random.normal(size=(count, 2)) @ (1, 1j)
    omega3, eta, s = random.normal(size=(3, count))
    both, product = omega3 * abs(z) ** 2 / 2, omega3 * s * abs(w) ** 2
    x = (1j * eta - both + product) / (w * z).conj()
    y = (1j * eta - both - product) / (w.conj() * z) - 2 * s
    return s, [state_of(*numbers) for numbers in zip(x, y, z, w, omega3, strict=True)]


@given(motions())
def test_states_of_N4_have_the_values_on_N4(motion):
    known = motion.parameters
    assume(known.b > 0)
    found = at(load("closed")(motion, np.array([0.3])))
    k, g = Fields(known.a, known.b).on_N4(found["H"], float(known.m))
    size = 1 + abs(found["K"]) + abs(found["G"]) + float(known.p_square) * abs(found["H"])
    assert np.all(abs(k - found["K"]) < 1e-11 * size)
    assert np.all(abs(g - found["G"]) < 1e-11 * size)


def test_states_of_M4_have_the_values_on_M4():
    states, j, h = by_chance(FIELDS, 100)
    found = at(states)
    k, g = FIELDS.on_M4(h, j)
    assert np.ptp(j) > 1
    assert found["H"] == pytest.approx(h) and found["G"] == pytest.approx(g)
    assert k == pytest.approx(found["K"], abs=1e-12)


@pytest.mark.parametrize("fields", sampled(OTHERS, 1))
def test_every_state_of_M4_is_on_a_torus_that_is_counted(fields):
    _, j, h = by_chance(fields, 20_000)
    assert {*fields.tori_on_M4(h, j).tolist()} == {1, 2, 4}


@pytest.mark.slow
@given(st.sampled_from(OTHERS), st.floats(-1.2, 2.5), st.floats(0.01, 3))
def test_there_are_states_of_M4_where_tori_are_counted_and_nowhere_else(fields, h, j):
    size = float(fields.a + fields.b)
    h, j = h * size, j * size**1.5
    beside = fields.tori_on_M4(h + size * np.array([-0.05, 0, 0.05]), np.full(3, j))
    assume(len({*beside.tolist()}) == 1)  # in a thin region states may not be hit
    assert (len(at_level(fields, h, j)) > 0) == (beside[0] > 0)


LEVELS_OF_M4 = [
    *((fields, *level) for fields in OTHERS[:2]
      for level in ((1.6, 0.08, 4), (1.4, 0.3, 2), (1.2, 1.0, 1), (0.5, 0.3, 1))),
    *((OTHERS[2], *level) for level in ((1.1, 0.02, 4), (1.5, 0.02, 2), (1.2, 0.3, 1))),
]  # fmt: skip
"""Fields, values of H by a + b and of J3 by its power 3/2, and how many tori have them."""


@pytest.mark.parametrize(("fields", "h", "j", "tori"), sampled(LEVELS_OF_M4, 3))
def test_tori_of_M4_are_told_apart_by_signs(fields, h, j, tori):
    """Of (r² + u)ω1 − jα3, for each gap of values u with R(u) > 0: there it does not vanish."""
    size, p, r = float(fields.a + fields.b), *fields._pr
    h, j = h * size, j * size**1.5
    assert fields.tori_on_M4(np.array([h]), np.array([j])) == tori
    u = np.polynomial.Polynomial([0, 1])
    square = u**2 - r**4
    roots = (-(square**2) - 2 * h * j**2 * square + 2 * j**4 * (u - p**2)).roots()
    ends = np.sort(roots[roots.imag == 0].real)
    middles = (ends[::2] + ends[1::2]) / 2
    states = at_level(fields, h, j)
    signs = (r**2 + middles) * states[:, :1] - j * states[:, 5:6] > 0
    assert len({*map(tuple, signs.tolist())}) == tori


@pytest.mark.slow
@pytest.mark.parametrize(("fields", "h", "j", "tori"), LEVELS_OF_M4)
def test_motions_on_M4_fill_as_many_tori_as_are_counted(fields, h, j, tori):
    size = float(fields.a + fields.b)
    assert pieces(fields, h * size, j * size**1.5) == tori


@pytest.mark.slow
@pytest.mark.parametrize("starts", [8, pytest.param(200, marks=pytest.mark.slow)])
def test_where_H_and_J3_are_dependent_on_M4_two_roots_coincide(starts):
    p, r = FIELDS._pr
    levels = [*critical_levels(FIELDS, starts)]
    assert len(levels) > starts / 2
    for h, j in levels:
        xi = np.polynomial.Polynomial([0, 1])
        roots = ((xi**2 + 2 * h * xi + 2 * p**2) ** 2 - 4 * r**4 - 4 * j**2 * xi).roots()
        gaps = abs(roots[:, None] - roots) + np.eye(4) * np.max(abs(roots))
        assert np.min(gaps) < 1e-3 * np.max(abs(roots))


@given(st.sampled_from(OTHERS), st.floats(0.02, 0.98), st.sampled_from([1, 2, 3]), shares)
def test_where_two_roots_coincide_there_are_one_or_two_circles_on_M4_and_O4(
    fields, place, case, share
):
    a, b, (p, r) = float(fields.a), float(fields.b), fields._pr
    low, high = {1: (r**2, (a + b) ** 2), 2: ((a - b) ** 2, r**2), 3: (-(r**2), 0.0)}[case]
    e = low + place * (high - low)
    s = np.sqrt(2 * p**2 - e - r**4 / e) / 2 * (-1 if case == 1 else 1)
    h, k, g = fields.on_O4(np.array([s]), np.array([e]))
    (j,) = fields.j(h, g)
    # where the line Y = e + 2sW meets α3 = 0, and the two sides β3 = 0
    right = (e + r**2) / (2 * (a - s))
    left, upper = (r**2 - e) / (2 * (s + b)), (r**2 - e) / (2 * (s - b))
    first, last = {1: (upper, right), 2: (left, right), 3: (left, upper)}[case]
    assert 0 < first < last
    W = first + share * (last - first)
    Y = e + 2 * s * W
    alpha3, beta3 = np.sqrt(
        [(Y + r**2) ** 2 - 4 * (a * W) ** 2, 4 * (b * W) ** 2 - (Y - r**2) ** 2]
    )
    z = (alpha3 + 1j * beta3) / (2 * r)
    w = j * z.real / (r**2 + e) - 1j * j * z.imag / (r**2 - e)
    state = state_of(
        -(w**2), ((z**2 - r**2) / w**2).conj(), z, w, j / W - 2 * (w * z.conj()).real / W
    )
    found = at(state)
    assert abs(w) ** 2 == pytest.approx(W)
    assert found["H"] == pytest.approx(h, abs=1e-9) and found["G"] == pytest.approx(g, abs=1e-9)
    assert max(residuals(state[None])[name] for name in ("M4", "O4")) < 1e-8
    assert k == pytest.approx(0, abs=1e-9)


def test_states_of_O4_have_the_values_on_O4_and_lie_in_its_regimes():
    for s, state in zip(*points_on_O4(100, 1), strict=True):
        found = at(state)
        p_square = found["a^2"] + found["b^2"]
        r_square = np.sqrt((found["a^2"] - found["b^2"]) ** 2 + 4 * found["c"] ** 2)
        a, b = np.sqrt((p_square + r_square) / 2), np.sqrt((p_square - r_square) / 2)
        fields = Fields(Fraction(float(a[0])), Fraction(float(b[0])))
        s = np.array([s])
        tau = fields.tau(s, found["H"])
        _, k, g = fields.on_O4(s, tau)
        assert k == pytest.approx(found["K"], rel=1e-6, abs=1e-6 * float(p_square[0]) ** 2)
        assert g == pytest.approx(found["G"], rel=1e-6, abs=1e-6 * float(p_square[0]) ** 2)
        assert fields.regimes(s, tau)[0] >= 0


@pytest.mark.parametrize("fields", sampled(OTHERS, 1))
def test_the_regimes_of_a_grid_are_those_of_each_place(fields):
    random = np.random.default_rng(7)
    s, tau = random.normal(size=(2, 400)) * [[float(fields.a)], [2 * float(fields.a) ** 2]]
    kinds, regimes = fields.regimes(s, tau)
    for place, kind in enumerate(kinds):
        known = ParametersO4(fields.a, fields.b, Fraction(s[place]), Fraction(tau[place]))
        try:
            assert regimes[kind] == regime_of(known) and kind >= 0
        except Inadmissible:
            assert kind == -1


def test_the_curves_are_where_roots_coincide():
    for words, _, s, tau in separating_curves(FIELDS, (-5.0, 5.0)):
        sigma, kappa_square = FIELDS.squares(s, tau)
        inner = np.isfinite(tau) & (abs(tau) < 50)
        if words == "$k=0$":
            assert np.nanmax(abs(kappa_square[inner]) / (1 + s[inner] ** 2)) < 1e-9
        if words == r"$\sigma=0$":
            assert np.nanmax(abs(sigma[inner])) < 1e-9


@pytest.mark.slow
@pytest.mark.parametrize(("fields", "share"), sampled(product(OTHERS, [-0.6, 0.1, 0.95, 1.7]), 1))
def test_the_critical_values_enclose_those_of_all_states(fields, share):
    h = share * float(fields.a + fields.b)
    g, root = values(fields, h)
    axes = new_figure().subplots()
    width, height = np.ptp(g), root.max()
    axes.set(
        xlim=(g.min() - 0.1 * width, g.max() + 0.1 * width), ylim=(-0.1 * height, 1.1 * height)
    )
    curves = [curve[:2] for some in section(fields, h) for curve in some]
    inside = fill_regions(axes, curves, (g, root))
    assert not inside[[0, 0, -1, -1], [0, -1, 0, -1]].any()
    assert 0.1 < inside.mean() < 0.8


@pytest.mark.parametrize("fields", OTHERS)
@given(st.floats(0.01, 4))
def test_rotations_are_off_O4_where_the_energy_is_small(fields, share):
    # y1y2 − x1x2 = 4ab where the fields turn the same way as the axes, −4ab where not.
    a, b = float(fields.a), float(fields.b)
    h = -a - b + share * (a + b)
    assume(abs(h**2 - 4 * a * b) > 1e-3)
    alone = [off for _, _, off in rotations(fields, h)]
    assert alone[0] == (h**2 < 4 * a * b)
    assert not any(alone[1:])


def test_one_field_is_refused():
    with pytest.raises(Inadmissible, match="those of two fields"):
        Fields(Fraction(1), Fraction(0))
