r"""An acceleration alone on a side: by a force, as in :math:`m\ddot x=F`, or what a name stands for."""

import pytest

from kowalevski_cas.reading import LAW
from tests.reading.test_reading import reading, verdicts

PUSHED = r"Two bodies push each other: \[ a\ddot u = S,\qquad b\ddot v = -S . \] "
FALLING = r"A stone falls by \[ \ddot u = b . \] "


def roles(text):
    return [f.role.name for f in reading(text).formulas]


def last(text):
    return [*verdicts(text).values()][-1]


def test_what_acts_back_on_another_body_is_a_force():
    assert roles(PUSHED)[:2] == [LAW, LAW]
    assert last(PUSHED + r"The momentum \[ P = a\dot u + b\dot v \] is constant.").green
    assert not last(PUSHED + r"The momentum \[ P = a\dot u - b\dot v \] is constant.").green


@pytest.mark.parametrize("sign, green", [("+", True), ("-", False)])
def test_the_reduced_mass_follows(sign, green):
    text = rf"With $z=u-v$ and \[ \mu=\frac{{ab}}{{a{sign}b}} \] we have \[ \mu\ddot z = S . \]"
    assert last(PUSHED + text).green is green


@pytest.mark.parametrize("number, green", [("2", True), ("", False), ("3", False), ("-2", False)])
def test_a_body_that_falls_has_an_equation_of_motion(number, green):
    text = rf"The function \[ K=\dot u^2-{number}bu \] is an integral."
    assert last(FALLING + text.replace("--", "+")).green is green


@pytest.mark.parametrize(
    "text",
    [
        r"The equation of motion is \[ \ddot u = -n^2u . \] It moves with the acceleration \[ \ddot u = b . \]",
        r"The equation of motion is \[ \ddot u = -n^2u . \] Put \[ \ddot u = b . \]",
        r"The acceleration is \[ \ddot u = b . \]",
        r"It moves, and \[ \ddot u = b \] is an integral.",
        r"It moves with the velocity \[ \dot u = b . \]",
    ],
)
def test_what_is_only_named_is_no_equation_of_motion(text):
    assert roles(text)[-1] != LAW
