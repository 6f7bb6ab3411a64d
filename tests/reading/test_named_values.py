"""Names that words give to the value of a function along the motion, and to nothing else."""

import pytest

from tests.reading.test_reading import verdicts

LAW = (
    r"""The equations of motion are $$\dot x=y,\qquad \dot y=-x-cy.$$ Put $H=\tfrac12(x^2+y^2)$. """
)
RATE = r" Then $$\dot E=-cy^2.$$"


@pytest.mark.parametrize(
    "words",
    [
        "Denote by $E(t)$ the value of $H$ along a solution.",
        "We denote by $E$ the value of $H$ on the trajectory.",
        "Denote by $E$ the value of $H$.",
        "Через $E$ обозначим значение $H$ на решении.",
    ],
)
def test_a_name_stands_for_the_value_of_a_function_along_the_motion(words):
    assert [one.green for one in verdicts(LAW + words + RATE).values()] == [True]
    wrong = RATE.replace("-cy^2", "-cy")
    assert [one.green for one in verdicts(LAW + words + wrong).values()] == [False]


@pytest.mark.parametrize(
    "words",
    [
        "Denote by $E$ the value of $H$ at the origin.",
        "Denote by $E$ the value of $H$ for $t=0$.",
        "Denote by $E$ the value of $H$ where $y=0$.",
        "Denote by $E$ the greatest value of $H$.",
        "Denote by $E$ twice the value of $H$.",
        "Denote by $E$ the mean value of $H$ along a solution.",
        "Denote by $E$ the value of $H$ along a solution of another system.",
        "Denote by $E$ the value that $H$ has at the beginning.",
        "Let $E$ and $F$ be values of $H$ on two solutions.",
        "Denote by $x_0$ and $E$ the values of $x$ and $H$ at the time $t_0$.",
        "Через $E$ обозначим наибольшее значение $H$.",
        "Через $E$ обозначим значение $H$ в начале координат.",
    ],
)
def test_a_value_at_a_place_or_of_something_else_is_none(words):
    assert not any(one.green for one in verdicts(LAW + words + RATE).values())
