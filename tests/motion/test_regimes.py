"""The regimes: which there are, where the radicands are non-negative, and how many tori."""

import itertools
import re
from fractions import Fraction
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st

from kowalevski_cas.motion import (
    Inadmissible,
    Motion,
    Parameters,
    all_regimes,
    coincidences,
    formulas,
    load,
    regime_of,
)
from kowalevski_cas.motion.formulas import values_of_offer
from kowalevski_cas.motion.parameters import ball, extreme_ell, precision
from kowalevski_cas.motion.point import on_N4
from kowalevski_cas.motion.regimes import coordinates, tori
from kowalevski_cas.paper.closed_form import ClosedForm
from tests.motion.regions import EVERY_REGIME, SEPARATING, motion

A, B = Fraction(1), Fraction(2, 5)
positive = st.fractions(Fraction(1, 20), 3, max_denominator=40)
signed = st.fractions(-4, 4, max_denominator=40)

few = settings(max_examples=settings.default.max_examples // 6)
"""Motions through all tori of their constants are dear."""


def mirror(regime):
    """Whether it takes the negative root of x1x2 throughout."""
    return regime.sign > 0 and regime.order.index("C") < regime.order.index("-b")


def radicands(m, ell, s1, s2):
    """S1², S2², f1², f2² as they are printed."""

    def phi(s):
        return 4 * m * s**2 - 4 * ell * s + (ell**2 - 1) / m

    return s1**2 - A**2, B**2 - s2**2, -phi(s1), phi(s2)


@given(signed, signed)
def test_there_is_a_regime_exactly_where_all_radicands_are_somewhere_non_negative(m, ell):
    assume(m)
    # The radicands change sign at the roots only: try these, and a point in each gap.
    roots = sorted([A, -A, B, -B, (ell + 1) / (2 * m), (ell - 1) / (2 * m)])
    points = [*roots, *(sum(pair) / 2 for pair in pairwise(roots)), roots[0] - 1, roots[-1] + 1]
    first = any(min(radicands(m, ell, s, Fraction(0))[::2]) >= 0 for s in points)
    second = any(min(radicands(m, ell, Fraction(0), s)[1::2]) >= 0 for s in points)
    try:
        regime_of(Parameters.of(A, B, m, ell))
    except Inadmissible:
        assert not (first and second)
    else:
        assert first and second


@given(signed, signed)
def test_on_the_arcs_the_radicands_are_positive(m, ell):
    assume(m)
    try:
        regime = regime_of(Parameters.of(A, B, m, ell))
    except Inadmissible:
        assume(False)
    parameters = Parameters.of(A, B, m, ell)
    ends = []
    for arc in (regime.s1, regime.s2):
        low, high = (x * ell + y for x, y in (coordinates(parameters, r) for r in arc.ends))
        ends.append([low + 1, high - 1] if arc.infinite else [(low + high) / 2])
    for s1 in ends[0]:
        assert min(radicands(m, ell, s1, ends[1][0])) >= 0


def test_the_mirror_keeps_the_number_of_tori():
    for m, ell in EVERY_REGIME:
        there = regime_of(Parameters.of(A, B, m, ell))
        back = regime_of(Parameters.of(A, B, m, -Fraction(ell)))
        assert there.tori == back.tori
        assert mirror(there) + mirror(back) == (there.sign > 0)


def test_three_regimes_for_positive_m_and_nine_for_negative():
    regimes = [regime for regime in all_regimes() if not mirror(regime)]
    assert [r.tori for r in regimes if r.sign > 0] == [1, 2, 4]
    assert [r.tori for r in regimes if r.sign < 0] == [1, 2, 4, 2, 4, 2, 4, 2, 1]


def labels(parameters, signs):
    """The signs that states along a motion tell, where they matter: the names of its torus."""
    moved = Motion(parameters, (Fraction(1, 3), Fraction(-1, 7)), signs)
    found = set()
    for state in load("closed")(moved, np.linspace(0, 9, 4)):
        told = on_N4(state.tolist())
        # Where s1 < 0 a state tells −ℓ, the same motion by the other root of x1x2.
        if parameters.ell_sign in (0, told.parameters.ell_sign):
            arcs = (told.regime.s1, told.regime.s2)
            pairs = zip(told.signs, arcs, strict=True)
            found.add(tuple(sign for sign, arc in pairs if arc.components == 2))
    return frozenset(found)


def named(parameters):
    """The tori by all the names that their states tell."""
    return {labels(parameters, signs) for signs in itertools.product((1, -1), repeat=2)}


@pytest.mark.slow
@few
@given(signed, signed, st.sampled_from([B, Fraction(0), Fraction(3, 4)]))
@example(Fraction(-1), Fraction(1, 10), Fraction(0))
def test_each_torus_has_signs_of_its_own_and_keeps_them(m, ell, b):
    assume(abs(m) > Fraction(1, 10) and abs(ell) > Fraction(1, 20))
    if m > 0:
        m, ell = m / 4, abs(ell)
    else:
        ell /= 4
    try:
        parameters = Parameters.of(A, b, m, ell)
        regime_of(parameters)
    except Inadmissible:
        assume(False)
    assume(not coincidences(parameters))
    found = named(parameters)
    assert all(len(names) == 1 for names in found)
    assert len(found) == tori(parameters)


@pytest.mark.slow
@few
@given(st.fractions(-3, Fraction(-1, 10), max_denominator=40), st.sampled_from([B, 0]))
@example(Fraction(-3, 5), B)
@example(Fraction(-2), B)
def test_on_the_curve_where_ell_vanishes_tori_are_the_same_in_pairs_or_not(m, b):
    parameters = Parameters.of(A, b, m, 0)
    assume(coincidences(parameters) == ["ℓ = 0"])
    assert regime_of(parameters).tori == 4
    assert len(named(parameters)) == tori(parameters)


# -- real points of N⁴ ---------------------------------------------------------------


def sampled(seed, count):
    """States of N⁴ that no formula of the solution made: random frames, ω from (16)."""
    random = np.random.default_rng(seed)
    found = []
    while len(found) < count:
        frame, _ = np.linalg.qr(random.normal(size=(3, 3)))
        alpha, beta = float(A) * frame[0], float(B) * frame[1]
        x, y = alpha[0] - beta[1], alpha[1] + beta[0]
        # The second of (16) with c = 0 is P(ω1² − ω2² + ξ1) + Q(2ω1ω2 + ξ2) = 0; turn ω so that
        # it reads |P + iQ|·(u² − v²) + rest = 0 and take u freely.
        p, q = -2 * x * y, x**2 - y**2
        size, angle = np.hypot(p, q), np.arctan2(q, p) / 2
        u = random.normal() * random.choice([0.1, 0.5, 2])
        square = u**2 + (p * x + q * y) / size
        if square < 0:
            continue
        v = np.sqrt(square) * random.choice([-1, 1])
        w = complex(u, v) * np.exp(1j * angle)
        omega3 = 2 * ((x * w.real + y * w.imag) * alpha[2] + (y * w.real - x * w.imag) * beta[2])
        found.append([w.real, w.imag, omega3 / (x**2 + y**2), *alpha, *beta])
    return np.array(found)


def test_every_real_point_lies_in_a_regime_and_every_regime_has_points():
    states = sampled(3, 600)
    *_, first, second = values_of_offer("integrals")(*states.T)
    assert np.max(np.abs(first)) < 1e-12 and np.max(np.abs(second)) < 1e-11
    names = formulas.source().offers[ClosedForm]().constants.expressions
    values = dict(zip(names, values_of_offer("constants")(*states.T), strict=True))
    m = (2 * values["G"] - values["p^2"] * values["H"]) / values["c_1c_2"]
    root = np.sqrt(values["x_1x_2"])
    ell = (values["w_1w_2"] + values["x_1x_2+z_1z_2"] * m) / root
    r_square = float(A**2 - B**2)
    seen = set()
    for k in range(len(states)):
        parameters = Parameters.of(A, B, float(m[k]), float(ell[k]))
        regime = regime_of(parameters)
        seen.add(regime)
        with precision(64):
            ends = {
                root: float(parameters.value(*coordinates(parameters, root)))
                for root in regime.order
            }
        for arc, sign in ((regime.s1, 1), (regime.s2, -1)):
            s = (values["x_1x_2+z_1z_2"][k] + sign * r_square) / (2 * root[k])
            low, high = (ends[name] for name in arc.ends)
            inside = (s - low + 1e-9, high - s + 1e-9)
            assert max(inside) > 0 if arc.infinite else min(inside) > 0
    assert seen == {regime for regime in all_regimes() if not mirror(regime)}
    assert all(ell[m > 0] > 0)  # with the positive root of x1x2


# -- the separating curves -------------------------------------------------------------


@given(positive, st.sampled_from([1, -1]), st.sampled_from([1, -1]), st.sampled_from([A, B]))
@example(Fraction(1, 2), 1, 1, A)
def test_regimes_meet_where_roots_coincide(m, sign, side, length):
    for sign_of_m in (1, -1):
        ell = sign * 2 * length * sign_of_m * m + side
        found = coincidences(Parameters.of(A, B, sign_of_m * m, ell))
        assert any(name.strip("AC =-") == ("a" if length == A else "b") for name in found)


def test_what_the_coincidences_are():
    names = {
        words: coincidences(motion(*region).parameters) for words, region in SEPARATING.items()
    }
    assert names["s1 rests"] == ["A = a"]
    assert names["both rest"] == ["C = -b", "A = a"]
    assert names["s1 goes from one double root to the other"] == ["C = a", "A = -a", "ℓ = 0"]
    assert coincidences(motion("0.8", "0.9").parameters) == []


@given(signed.filter(bool), signed)
def test_the_least_and_the_greatest_ell(m, ell):
    bound = extreme_ell(A, B, m)
    allowed = abs(ell) >= bound if m > 0 else abs(ell) <= bound
    try:
        Motion(Parameters.of(A, B, m, ell))
    except Inadmissible as error:
        assert not allowed
        said = re.search(r"\|ℓ\| [≥≤] (\S+),", str(error))
        assert Motion(Parameters.of(A, B, m, said[1]))
        assert abs(Fraction(said[1]) - bound) < Fraction(1, 10**9) * (1 + abs(bound))
    else:
        assert allowed


@given(signed.filter(bool), st.fractions(-50, 50, max_denominator=40), st.sampled_from([B, 0]))
def test_the_energies_that_are_proposed_have_motions(m, h, b):
    try:
        Motion(Parameters.at_energy(A, b, m, h))
    except Inadmissible as error:
        bounds = re.findall(r"(?:h ≥|and ≤) ([-+.e\d]*\d)", str(error))
        assert len(bounds) == (1 if m > 0 else 2)
        for bound in bounds:
            assert Motion(Parameters.at_energy(A, b, m, bound))


def test_the_modulus_is_between_zero_and_one_and_its_complement_is_exact():
    for region in [*EVERY_REGIME, *SEPARATING.values()]:
        with precision(200):
            for oscillation in motion(*region).oscillations():
                square, complement = oscillation.modulus_square, oscillation.complement_square
                assert square >= 0 and complement >= 0
                assert (square + complement - 1).contains(0)
                assert abs(square + complement - 1) < ball(Fraction(1, 2**190))
