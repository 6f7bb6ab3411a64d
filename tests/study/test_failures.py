"""Where methods fail: exactly where it is said, and those that should not fail do not."""

from fractions import Fraction

import pytest

from kowalevski_cas.pictures import style
from study import failures
from study.failures import branch, cancellation, differences, phase, primes, separatrix
from tests.sample import sampled


@pytest.mark.parametrize(
    ("method", "refuted"),
    sampled(
        [
            ("flint", [5, 5, 5]),
            ("modular", [5, 5, 5]),
            ("ball", [5, 5, 0]),
            ("floating", [5, 0, 0]),
        ],
        1,
    ),
)
def test_a_small_difference_is_seen_by_exact_methods_alone(method, refuted):
    assert differences.count_refuted(method, [5, 40, 200])["refuted"] == refuted


@pytest.mark.slow
def test_a_small_prime_accepts_what_is_false_and_a_large_one_hardly():
    row = primes.count_accepting([13, 4129])
    shares = [n / of for n, of in zip(row["accepted"], row["points"], strict=True)]
    assert shares[0] > 1 / 20 > shares[1]
    assert all(share <= bound for share, bound in zip(shares, row["bound"], strict=True))


def test_principal_roots_multiply_to_the_principal_root_or_to_its_negative():
    angles, signs = branch.angles(16), branch.products(16)["signs"]
    for b, line in zip(angles, signs, strict=True):
        for a, sign in zip(angles, line, strict=True):
            if abs(a + b) != 1:  # on the cut floating point decides by its rounding
                assert sign == ("+" if -1 < a + b <= 1 else "-")


def test_balls_lose_digits_towards_theta_0_and_fractions_none():
    lost = {
        name: cancellation.relative_errors(name, [0, 8, 18])["errors"]
        for name in ("flint", "ball", "floating")
    }
    assert lost["flint"] == [0, 0, 0]
    assert lost["ball"][0] < 1e-13 < 1e-10 < lost["ball"][1] < 1 < lost["ball"][2]
    # in floating point the equation is as printed, and its sides are alike until nothing is finite
    assert max(lost["floating"][:2]) < 1e-13
    assert lost["floating"][2] is None


def test_a_point_has_the_theta_that_is_asked_for():
    at = {name: re for name, (re, _) in cancellation.point_at(Fraction(1, 100)).items()}
    xi = at[r"\alpha_1"] - at[r"\beta_2"], at[r"\alpha_2"] + at[r"\beta_1"]
    assert xi[0] ** 2 + xi[1] ** 2 == Fraction(1, 100) ** 2


@pytest.mark.slow
def test_an_integrator_loses_the_motion_near_a_separating_curve_and_the_closed_form_does_not():
    near, at = separatrix.errors("dop853", [1, 30])["errors"]
    assert near < 1e-9 < 1e-6 < at
    assert max(separatrix.errors("closed", [1, 15, 40])["errors"]) < 1e-13


def test_a_phase_that_is_rounded_once_is_lost_like_t_and_the_closed_form_keeps_it():
    early, late = phase.errors(phase.round_phases, [4, 12])["errors"]
    assert 1e6 < late / early < 1e10
    assert max(phase.errors(phase.load("closed"), [0, 12, 30])["errors"]) < 1e-13


@pytest.mark.slow
def test_every_way_to_fail_has_a_panel_with_all_its_methods():
    tasks = list(failures.measure(quick=True))
    assert {task.case for task in tasks} == set(failures.WAYS)
    with style():
        figure = failures.draw(rows := [task.row() for task in tasks])
    titles = [axes.get_title(loc="left") for axes in figure.axes]
    assert titles == [way.TITLE for way in failures.WAYS.values()]
    for axes, name in list(zip(figure.axes, failures.WAYS, strict=True))[3:]:
        assert len(axes.lines) == sum(
            r["case"] == name and r["verdict"] == "measured" for r in rows
        )
