"""What ``motion`` does with states and constants at the edges: other methods, other units."""

from __future__ import annotations

import json
from decimal import Decimal

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from kowalevski_cas.cli import main
from kowalevski_cas.motion import Motion, MotionO4, load, through
from kowalevski_cas.motion.methods import closed as closed_form
from tests.motion.test_closed import relative

closed = load("closed")

FAST = "--a 1.2 --b 0.7 --s 1 --tau=-1e8 --until 10 --samples 3".split()


def test_a_fast_top_is_followed_in_closed_form(capfd):
    assert main(["motion", *FAST]) == 0
    out, err = capfd.readouterr()
    assert not err and max(json.loads(out)["invariants"]["drift"].values()) < 1e-14


def test_where_the_closed_form_gives_up_balls_follow_the_motion_and_this_is_said(
    capfd, monkeypatch, copies
):
    monkeypatch.setattr(closed_form, "PROMISE", 1e-18)
    assert main(["motion", *FAST]) == 0
    out, err = capfd.readouterr()
    assert "ball follows the motion" in err and '"radius"' in out


@pytest.mark.slow
def test_a_state_of_any_size_is_followed_and_no_constant_is_lost(capfd):
    """In another unit of time it is the same motion; what no float holds is told in digits."""
    for power in (-60, -200, 40):
        numbers = [f"{x}e{power}" for x in (1, 2, 3)] + [f"{x}e{2 * power}" for x in (1, 0, 2)]
        numbers = numbers if power > -200 else [f"{x}e-200" for x in (1, 2, 3, 1, 0, 2)]
        assert main(["motion", "--point", *numbers, "0", numbers[3], "0", "--until", "0"]) == 0
        invariants = json.loads(capfd.readouterr().out)["invariants"]
        assert all(Decimal(str(invariants[name])) != 0 for name in "abh")
        point = ["--point", *numbers, "0", numbers[3], "0", "--until", "0", "--format", "table"]
        assert main(["motion", *point]) == 0
        assert f"a = {float(invariants['a']):.6g}"[:6] in capfd.readouterr().out


@pytest.mark.slow
def test_a_small_or_large_state_is_printed_in_units_of_its_size(capfd):
    for size, power in ((-6, -12), (-140, -280), (-158, -300)):
        state = [f"{x}e{size}" for x in (1, 2, 3)] + [f"{x}e{2 * size}" for x in (1, 0, 0, 0, 4, 1)]
        assert main(["motion", "--point", *state, "--until", "0", "--format", "table"]) == 0
        table = capfd.readouterr().out
        assert f"ω in units of 1e{size}, α, β in units of 1e{power}" in table
        assert power == -300 or "  1.0000  2.0000  3.0000  1.0000" in table
    large = [f"{x}e30" for x in (1, 2, 3)] + [f"{x}e60" for x in (1, 0, 0, 0, 4, 1)]
    assert main(["motion", "--point", *large, "--until", "0", "--format", "table"]) == 0
    assert "ω in units of 1e30, α, β in units of 1e60" in capfd.readouterr().out
    assert main(["motion", *FAST, "--format", "table"]) == 0
    assert "in units of" not in capfd.readouterr().out


def test_a_state_beside_a_set_is_followed_where_it_is(capfd):
    """Not its neighbour on the set, which may leave it, unless that is asked for."""
    on_N4 = json.loads(_printed(capfd, ["--a", "1", "--b", "0.4", "--m", "0.8", "--l", "0.9"]))
    state = on_N4["states"][0]
    point = [repr(x) for x in (*state["omega"], *state["alpha"], *state["beta"])]
    point[2] = repr(float(point[2]) + 3e-11)
    near = json.loads(_printed(capfd, ["--point", *point], "dop853 follows it"))["states"]
    assert near[0]["omega"][2] == float(point[2])


WHOLE = st.integers(-140, 140)

ON = {
    "N⁴": Motion.of(1, "0.4", "0.8", ell="0.9"),
    "N⁴, hyperbolic": Motion.of(1, "0.4", "-0.8", ell="0.5"),
    "O⁴": MotionO4.of("1.2", "0.7", "-0.9", "0.6", angles=(1, 2)),
}


@pytest.mark.slow
@settings(suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(st.sampled_from(sorted(ON)), st.integers(0, 8), st.floats(-12.9, -8))
def test_what_is_followed_begins_at_the_given_state(capfd, name, place, power):
    """Whatever little it is off N⁴ or O⁴, and whoever follows it says so where it is another."""
    state = closed(ON[name], np.array([0.7]))[0]
    state[place] += 10.0**power
    capfd.readouterr()
    assert main(["motion", "--point", *map(repr, state.tolist()), "--until", "0"]) == 0
    out, err = capfd.readouterr()
    first = json.loads(out)["states"][0]
    begun = np.array([*first["omega"], *first["alpha"], *first["beta"]])
    assert np.max(abs(begun - state)) < 1e-13 * np.max(abs(state)) * 2
    assert through(state.tolist()).off < 1e-13 or "dop853 follows it" in err


@pytest.mark.slow
@settings(suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(st.sampled_from(sorted(ON)), st.sampled_from([-140, -60, -25, 25, 60, 140]) | WHOLE)
def test_in_any_unit_the_closed_form_follows_a_state_that_has_one(capfd, name, power):
    """Nobody else does, the same numbers come out, and the constants are those of the unit."""
    times, scales = (
        np.array([0.7, 0.7 + 1e4]),
        np.repeat([10.0**power, 10.0 ** (2 * power)], (3, 6)),
    )
    first, last = closed(ON[name], times)
    point = map(repr, (first * scales).tolist())
    capfd.readouterr()
    until = f"{1e4 / 10.0**power!r}"
    assert main(["motion", "--point", *point, "--until", until, "--samples", "2"]) == 0
    out, err = capfd.readouterr()
    found = json.loads(out)
    end = found["states"][1]
    assert not err and "none" not in found["regime"]
    assert (
        relative(np.array([end["omega"] + end["alpha"] + end["beta"]]) / scales, last[None]) < 1e-9
    )
    a = Decimal(str(found["invariants"]["a"])) / Decimal(10) ** (2 * power)
    assert float(a) == pytest.approx(float(ON[name].parameters.a))


def test_near_two_edges_of_O4_an_integrator_follows_and_this_is_said(capfd):
    known = ["--a", "1.2", "--b", "0.7", "--s", "1.199999999803243", "--tau", "0.25000000065345684"]
    _printed(capfd, known, "two pairs of roots are so close")


def test_where_two_roots_coincide_an_integrator_follows_and_the_regime_says_why(capfd):
    known = ["--a", "1.2", "--b", "0.7", "--s", "1.2", "--tau=-0.5"]
    found = json.loads(_printed(capfd, known))
    assert found["regime"]["none"] == "-κ = -τ-r², or almost: the tori of O⁴ degenerate"
    assert max(found["invariants"]["drift"].values()) < 1e-11
    assert main(["motion", *known, "--method", "closed"]) == 2
    assert "no closed form, but integrators follow" in capfd.readouterr().err


def _printed(capfd, arguments, said=""):
    assert main(["motion", *arguments, "--until", "1", "--samples", "2"]) == 0
    out, err = capfd.readouterr()
    assert said in err
    return out
