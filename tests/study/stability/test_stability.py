"""Where methods fail: each experiment beside its exact answer."""

from fractions import Fraction

import pytest

from kowalevski_cas.algebra import load_points
from kowalevski_cas.pictures import save
from kowalevski_cas.search.place import Candidate
from study import load
from study.paper import both, paper
from study.stability import branch, degenerate, precision, primes, swell, theta

SLOW = ("theta", "degenerate", "primes", "precision")
NAMES = ["branch", *(pytest.param(name, marks=pytest.mark.slow) for name in SLOW)]


@pytest.mark.parametrize("name", NAMES)
def test_every_experiment_is_a_step_with_a_picture(name, tmp_path):
    step = load(name)
    rows = [task.row() for task in step.measure(quick=True)]
    assert rows and all(row["verdict"] != "error" for row in rows)
    for chart, figure in step.draw(rows).items():
        assert chart.startswith("stability-") and save(figure, tmp_path, chart).stat().st_size > 0


def test_near_theta_zero_floating_point_loses_everything_in_the_initial_variables_only():
    exponents = [0, 8, 150]
    for case in ("F1', initial variables", "F2', initial variables"):
        errors = theta.lost("floating", case, exponents)["errors"]
        assert errors[0] < -12 and errors[1] > -2 and errors[2] is None
    for case in ("F1', complex variables", "F2', complex variables"):
        assert max(theta.lost("floating", case, exponents)["errors"]) < -13
        assert max(theta.lost("ball", case, exponents)["errors"]) < -15


@pytest.mark.parametrize("case", theta.CASES)
def test_near_theta_zero_the_exact_answer_stays(case):
    assert theta.lost("exact", case, [0, 30, 150])["verdict"] == "proved"


def test_motions_leave_16_where_xi_vanishes_though_two_derivatives_do_as_well():
    first, second = theta.order_of_leaving("E_1"), theta.order_of_leaving("E_2")
    assert (first["order"], second["order"]) == (2, 3)
    assert Fraction(first["value"]) != 0 != Fraction(second["value"])


def test_the_principal_root_jumps_on_every_turn_and_the_continued_one_changes_sign():
    found = branch.loop(64)
    assert found["jumps"] == 2
    half = len(found["turns"]) // 2
    assert found["continued"][half] == pytest.approx(-1) and found["principal"][
        half
    ] == pytest.approx(1)


def test_the_product_of_the_roots_is_the_root_of_the_product_or_its_negative_by_the_angles():
    exact, computed = branch.rule(16)["signs"], branch.products(16)["signs"]
    for a, row, other in zip(branch.angles(16), exact, computed, strict=True):
        for b, sign, seen in zip(branch.angles(16), row, other, strict=True):
            assert abs(a + b) == 1 or sign == seen
    assert {sign for row in exact for sign in row} == {1, -1}


def test_what_is_said_of_the_root_is_true_of_both_roots():
    found = branch.both_roots()
    assert len(found["claims"]) >= 10 and all(found["claims"].values())
    assert found["F1 changes its sign"]
    assert branch.undeclared()["verdict"] == "refused"


@pytest.mark.parametrize("family", degenerate.FAMILIES)
def test_the_exact_rank_drops_at_the_degeneration_only_and_the_computed_one_before(family):
    exact = degenerate.exact_ranks(family, [0, 20])
    assert exact["verdict"] == "measured" and exact["ranks"] == [5, 5, 4]
    computed = degenerate.singular_values(family, [0, 8, 20])
    assert computed["ranks"] == [5, 5, 4]
    assert computed["smallest"][0] > computed["smallest"][1] > computed["smallest"][2]


def test_the_points_near_a_degeneration_lie_on_16():
    exact, _ = both(paper().claims["eq16.invariance"].scene)
    for family in degenerate.FAMILIES:
        for distance in (Fraction(1, 7), Fraction(0)):
            at = Candidate(exact, degenerate.point_near(family, distance))
            assert at.vanish(degenerate.relations(exact))


def test_n4_is_no_manifold_of_dimension_four_for_degenerate_fields():
    for place in degenerate.AT:
        said = degenerate.claims_at(place, quick=True)["claims"]
        assert said["N4-dimension"] == "fails", place


def test_small_primes_accept_what_is_false_and_within_the_bound():
    found = primes.accepted("eq10.1", [5, 1009], 200)
    assert 0 < found["accepted"][0] <= found["bound"][0]
    assert found["accepted"][1] <= max(found["bound"][1], 3 / 200)


def test_one_seed_can_be_deceived_and_no_other_one():
    assert primes.bad_reduction()["accepted"] == [True] + [False] * 7
    assert primes.denominator()["verdict"] == "undecided"


def test_a_ball_takes_as_many_bits_as_the_near_miss_has():
    exponents = [10, 40]
    few, many = precision.bits("eq12", exponents)["bits"]
    assert 33 <= few <= 80 and 132 <= many <= 200
    assert precision.verdicts("floating", "eq12", exponents)["refuted"][1] is False
    for sure in (
        precision.verdicts("modular", "eq12", exponents),
        precision.exactly("eq12", exponents),
    ):
        assert sure["refuted"] == [True, True]


def test_derivatives_swell_for_polynomials_and_not_for_points():
    assert swell.decide({"method": "flint", "order": 2})["verdict"] == "proved"
    found = swell.decide({"method": "modular", "order": 12})
    assert found["verdict"] == "probable" and found["bound"] < 1e-20
    assert load_points("modular").name == "modular"


@pytest.mark.slow
def test_a_limit_is_a_timeout(monkeypatch):
    monkeypatch.setattr(swell, "SECONDS", 3.0)
    (task,) = (t for t in swell.measure(quick=False) if (t.method, t.case) == ("sympy", "D^16"))
    found = task.run()
    assert found["verdict"] == "timeout" and found["reason"] == "3 s"
