"""A condition in brackets behind a formula is that of this formula, and of no other one."""

import pytest

from tests.reading.test_reading import verdicts

LAW = r"The equation is \[ \ddot q=2q^3+tq+a . \] Its first rational solutions are "
DRIVEN = r"The equations of motion are \[ \dot x=y,\qquad \dot y=-x+ay . \] "


@pytest.mark.parametrize(
    ("first", "second", "greens"),
    [(1, 2, [True, True]), (1, 1, [True, False]), (2, 2, [False, True])],
)
def test_each_row_has_its_own(first, second, greens):
    text = rf"""{LAW}\begin{{align}} &q=-\frac1t \qquad(a={first}),\\
&q=\frac1t-\frac{{3t^2}}{{t^3+4}}\qquad(a={second}). \end{{align}}"""
    assert [one.green for one in verdicts(text).values()] == greens


def test_what_stands_in_words_has_them_too():
    text = DRIVEN + r"Put $E=x^2+y^2$. Then $\dot E=2y^2$ ($a=1$), $\dot E=-2y^2$ (for $a=-1$), "
    found = verdicts(text + r"$\dot E=4y^2$ ($a=3$).")
    assert [one.green for one in found.values()] == [True, True, False]


@pytest.mark.parametrize(("case", "green"), [("$a=0$, $b=0$", True), ("$a=0$", False)])
def test_there_may_be_several(case, green):
    law = r"The equations of motion are \[ \dot x=y,\qquad \dot y=-x+ay^2+bxy . \] "
    found = verdicts(law + rf"The function $x^2+y^2$ is an integral ({case}).")
    assert [one.green for one in found.values()] == [green]


@pytest.mark.parametrize(("other", "greens"), [(0, [True] * 4), (1, [True, True, False, False])])
def test_what_is_given_together_has_one(other, greens):
    text = rf"""There are the solutions \begin{{gather}} x=e^t,\quad y=e^t \qquad (a=2),\\
x=\sin t,\quad y=\cos t \qquad (a={other}). \end{{gather}}"""
    assert [one.green for one in verdicts(DRIVEN + text).values()] == greens


def test_it_is_over_behind_its_formula():
    found = verdicts(DRIVEN + r"With $E=x^2+y^2$ we have $\dot E=0$ ($a=0$). Then $\dot E=2ay^2$.")
    assert [one.green for one in found.values()] == [True, True]
