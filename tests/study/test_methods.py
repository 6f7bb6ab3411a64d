from __future__ import annotations

from time import sleep

import pytest

from study.labelled import labelled_set
from study.methods import ACCEPTED, NONE, REJECTED, STARTED, ExportProgram, method, methods, typed
from study.methods.certificates import answer
from study.methods.typed import decide
from tests.sample import sampled

FOUND = {one.name: one for one in methods()}


@pytest.fixture(scope="module")
def statements():
    found = labelled_set(0, ["kharlamov2002"])
    return {statement.id.removeprefix("kharlamov2002/"): statement for statement in found}


@pytest.mark.slow
@pytest.mark.parametrize(
    "name", sampled([name for name in FOUND if name not in ("rocq", "floating")], 1, seed=3)
)
def test_a_method_accepts_what_is_true_and_rejects_what_is_not(statements, name):
    one = FOUND[name]
    assert one.decide(statements["c1"])["verdict"] == ACCEPTED
    false = one.decide(statements["c1/vanishes at small integers"])
    assert false["verdict"] == REJECTED
    assert false["seconds"] > 0


@pytest.mark.parametrize(
    "name", sampled(["flint", "symengine", "sympy", "checker", "pari", "modular"], 1)
)
def test_points_at_which_a_near_miss_vanishes_deceive_no_method(statements, name):
    if name not in FOUND:
        pytest.skip("it is not installed")
    for kind in ("coefficient off by 10^-20", "vanishes at real points", "true only for a=b"):
        assert FOUND[name].decide(statements[f"eq12/{kind}"])["verdict"] == REJECTED


@pytest.mark.slow
def test_expand_leaves_something_of_a_true_identity_with_a_root(statements):
    problem = statements["F1-prime"].statement.problem
    assert decide("expand", problem)["verdict"] == REJECTED
    assert decide("ratsimp", problem)["verdict"] == ACCEPTED


@pytest.mark.slow
def test_two_roots_that_are_printed_with_one_constant_are_both_typed():
    found = labelled_set(0, ["kharlamov_savushkin2004"])
    for one in [one for one in found if one.id.endswith(("/N4.4", "/squares.2", "/rates.2"))]:
        assert one.truth and decide("cancel", one.statement.problem)["verdict"] == ACCEPTED


def test_a_limit_of_time_or_memory_is_no_answer(statements, copies, monkeypatch):
    def slow(_):
        sleep(60)

    def large(_):
        return bytearray(2**34)

    for call, seconds, reason in ((slow, 0.2, "0.2 s"), (large, 20.0, "4096 MiB")):
        by_hand = typed.ByHand("expand")
        monkeypatch.setattr(method, "SECONDS", seconds)
        monkeypatch.setattr(by_hand, "prepare", lambda one: one.statement.problem)
        monkeypatch.setitem(typed.CALLS, "expand", call)
        found = by_hand.decide(statements["c1"])
        assert (found["verdict"], found["reason"]) == ("timeout", reason)


def test_what_a_start_takes_is_measured_with_a_file_that_is_read():
    for one in FOUND.values():
        if isinstance(one, ExportProgram) and one.name != "rocq":
            found = one.start()
            assert found["verdict"] == STARTED and 0 < found["seconds"] < 10


def test_an_objection_that_does_not_say_no_is_no_answer():
    assert answer("")["verdict"] == ACCEPTED
    assert answer("fails: 7 statement")["verdict"] == REJECTED
    assert answer("Attempt to save an incomplete proof")["verdict"] == NONE
