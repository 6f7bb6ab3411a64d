"""A sum of squares vanishes exactly where the equations hold that are said in its place."""

from __future__ import annotations

import pytest

from kowalevski_cas.notation import Name, Negative, Number, Vocabulary, read, to_plain
from kowalevski_cas.problem.finder import finder_of
from kowalevski_cas.problem.space import Adjoined, Space
from kowalevski_cas.verify.real_zeros import real_zeros

WORDS = Vocabulary(frozenset("xyzrabci"))
ROOT = Adjoined("r", Name("x"))
REAL = Space(("x", "y", "z"), constants=("a", "b", "c"), steps=(ROOT,))
UNIT = Adjoined("i", Negative(Number(1)))
COMPLEX = Space(("x", "y"), steps=(UNIT,), conjugates=(("x", "y"),))


def zeros(tex, space=REAL):
    return [to_plain(one) for one in real_zeros(read(tex, WORDS), finder_of(space))]


@pytest.mark.parametrize(
    ("tex", "equations"),
    [
        ("(a^2-b^2)^2+4c^2", ["a² = b²", "c = 0"]),
        ("x^2+y^2+3z^4", ["x = 0", "y = 0", "z = 0"]),
        ("(r^2-a)^2+y^2", ["r² = a", "y = 0"]),
    ],
)
def test_each_square_vanishes(tex, equations):
    assert zeros(tex) == equations


@pytest.mark.parametrize(
    "tex", ["x^2-y^2", "x^2+y", "x^2+y^3", "x^2-3y^2", "x^2", "xy", "x^2+1", "r^2+y^2"]
)
def test_nothing_is_said_of_what_is_no_sum_of_squares_of_what_is_real(tex):
    assert zeros(tex) == []


def test_nothing_is_said_of_what_is_not_its_own_conjugate():
    assert zeros("x^2+y^2", COMPLEX) == []
    assert zeros("(x+y)^2+(xy)^2", COMPLEX) == ["x + y = 0", "xy = 0"]
    assert zeros("(ix-iy)^2+(x+y)^2", COMPLEX) == ["ix = iy", "x + y = 0"]
    assert zeros("(ix+iy)^2+(x+y)^2", COMPLEX) == []
