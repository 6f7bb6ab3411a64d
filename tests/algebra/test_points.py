"""What balls and floating point say at points, beside what is true."""

from fractions import Fraction
from random import Random

import numpy as np
import pytest
from flint import ctx

from kowalevski_cas.algebra import POINTS, load_points
from kowalevski_cas.algebra.ball import (
    PRECISIONS,
    NewtonSystem,
    ball_point,
    exact_balls,
    number,
    random_point,
    rank,
    square_root,
)
from kowalevski_cas.algebra.floating import newton
from kowalevski_cas.algebra.points import Question
from kowalevski_cas.algebra.programs import Programs

every = pytest.mark.parametrize("name", POINTS)


def ring(*names):
    programs = Programs(names)
    return programs, *(programs.generator(name) for name in names)


def answer(name, question, seed=1):
    return load_points(name, seed).answer(question)


@every
def test_an_identity_is_not_denied(name):
    programs, x, y = ring("x", "y")
    s = programs.adjoin("s", x * y)
    found = answer(name, Question(programs, [(s + x) * (s - x) - x * y + x**2, s**4 - x**2 * y**2]))
    assert found.holds and "seed 1" in found.words


@every
def test_what_is_false_is_denied_at_a_point(name):
    programs, x, y = ring("x", "y")
    found = answer(name, Question(programs, [x * y - x]))
    assert found.holds is False and set(found.point) == {"x", "y"}


@every
def test_what_is_defined_nowhere_is_no_success(name):
    programs, x, _ = ring("x", "y")
    found = answer(name, Question(programs, [programs.one / (x - x * programs.one)]))
    assert found.holds is None and found.words


@every
def test_ranks_at_points(name):
    programs, x, y = ring("x", "y")
    rows = [[x, y], [x * x, x * y], [y, x]]
    assert answer(name, Question(programs, rows=rows, rank=2)).holds
    assert answer(name, Question(programs, rows=rows, rank=1)).holds is False
    assert answer(name, Question(programs, rows=rows, rank=3)).holds is False


@every
def test_what_has_to_move_somewhere(name):
    programs, x, y = ring("x", "y")
    assert answer(name, Question(programs, somewhere=[x - x, y])).holds
    assert not answer(name, Question(programs, somewhere=[x - x * programs.one])).holds


def tiny(exponent):
    programs, x, y = ring("x", "y")
    near = programs.number(1 + Fraction(1, 10**exponent))
    return Question(programs, [near * x * y - y * x])


def test_a_coefficient_off_by_little_is_seen_by_all_but_floating_point():
    assert answer("modular", tiny(20)).holds is False
    assert answer("ball", tiny(20)).holds is False
    assert answer("floating", tiny(8)).holds is False
    assert answer("floating", tiny(20)).holds  # wrong, which is why it is not trusted


def test_a_ball_says_how_far_it_sees():
    assert answer("ball", tiny(100)).holds is False
    beyond = answer("ball", tiny(1000))
    assert beyond.holds and 0 < beyond.radius < 2.0 ** (-PRECISIONS[-1] / 2)


def test_a_ball_needs_more_bits_for_less():
    words = [answer("ball", tiny(e)).words for e in (5, 30, 60)]
    assert ["64 bits" in words[0], "128 bits" in words[1], "256 bits" in words[2]] == [True] * 3


def test_roots_in_balls_keep_away_from_the_cut():
    for value in (-4, 4, -1, 9):
        root = square_root(number(Fraction(value)))
        assert (root * root - value).contains(0) and float(root.rad()) < 1e-10


def test_only_sure_pivots_count():
    sure, vague = number(Fraction(3)), number(Fraction(1, 3)) * 3 - 1
    assert rank([[sure, sure], [sure, sure + vague]])[0] == 1
    assert rank([[sure, vague], [vague, sure]])[0] == 2


def test_a_solution_is_enclosed_and_no_other():
    programs, x, y, z = ring("x", "y", "z")
    equations = [x**2 + y**2 - programs.one, z * x - y]
    system = NewtonSystem(programs, equations)
    start = random_point(programs.generators, Random(3))
    with ctx.workprec(128):
        found = system.solve(exact_balls(start))
        at = ball_point(programs, found)
        assert all(at(e).contains(0) and float(at(e).rad()) < 1e-30 for e in equations)
        assert all(not at(e + programs.number(Fraction(1, 10**20))).contains(0) for e in equations)
    with pytest.raises(ZeroDivisionError):
        NewtonSystem(programs, [x**2]).solve(exact_balls(start))  # a double root is never enclosed


@every
def test_what_follows_on_a_set_and_what_does_not(name):
    programs, x, y, _ = ring("x", "y", "z")
    circle = x**2 + y**2 - programs.one
    square = (x**2 - y**2) ** 2 + programs.number(4) * x**2 * y**2 - programs.one
    assert answer(name, Question(programs, [square], [circle])).holds
    assert answer(name, Question(programs, [square + x - y], [circle])).holds is False


def test_newton_reaches_a_set():
    programs, x, y, z = ring("x", "y", "z")
    equations = [x**2 + y**2 - programs.one, z * x - y]
    start = {n: np.full(64, v + 0.3j) for n, v in (("x", 0.4), ("y", 0.7), ("z", 1.1))}
    found = newton(programs, equations, start, {})
    assert np.allclose(found["x"] ** 2 + found["y"] ** 2, 1)
    assert np.allclose(found["z"] * found["x"], found["y"])


def test_numbers_too_large_for_floating_point_are_no_success():
    programs, x, _ = ring("x", "y")
    found = answer("floating", Question(programs, [programs.number(10**400) * x]))
    assert found.holds is None and "too large" in found.words
