"""What moves is an exponential where its logarithm is a new variable."""

import pytest

from tests.reading.test_reading import verdicts

AVERAGED = r"The equations are \[ \dot J=-\zeta J,\qquad Q\dot\zeta=J-T . \] "
PREY = r"The equations are \[ \dot x=x(a-by),\qquad \dot y=y(cx-d) . \] Put $u=\ln x$, $v=\ln y$. "


@pytest.mark.parametrize("words", [r"With $x=\ln(J/T)$", r"With $x=\ln\frac JT$", r"With $J=Te^x$"])
@pytest.mark.parametrize(("sign", "green"), [("-", True), ("+", False)])
def test_the_equation_in_it_is_decided(words, sign, green):
    found = verdicts(rf"{AVERAGED}{words} we have \[ Q\ddot x+T(\mathrm e^x{sign}1)=0 . \]")
    assert [one.green for one in found.values()] == [green]


@pytest.mark.parametrize(("claim", "green"), [(r"\dot u=a-be^v", True), (r"\dot u=a-be^u", False)])
def test_there_may_be_several(claim, green):
    found = verdicts(rf"{PREY}Then \[ {claim} . \]")
    assert [one.green for one in found.values()] == [green]


@pytest.mark.parametrize(("sign", "green"), [("-", True), ("+", False)])
def test_an_integral_in_them_is_decided(sign, green):
    found = verdicts(rf"{PREY}The function $H=ce^u-du+be^v{sign}av$ is an integral.")
    assert [one.green for one in found.values()] == [green]


def test_a_logarithm_without_exponentials_stays_one():
    found = verdicts(rf"{AVERAGED}With $x=\ln J$ we have $\dot x=-\zeta$.")
    assert [one.green for one in found.values()] == [True]
