"""A claim is not mended by deriving a constant: with both sides zero anything holds."""

import pytest

from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import verdicts

LAW = r"The law is \[ \dot x=\frac{y}{l^2},\qquad \dot y=-\frac{x}{l^2}. \] "


@pytest.mark.parametrize(
    "text",
    [
        r"Let $H=\ln l$. It is Hamiltonian, \[ k\dot x=\frac{\partial H}{\partial y},\quad"
        r" k\dot y=-\frac{\partial H}{\partial x}. \]",
        r"Let $a=l^2$. Then \[ \dot a=ka(x-y). \]",
    ],
)
def test_a_derivative_of_a_constant_mends_nothing(text):
    found = verdicts(LAW + text)
    assert found
    assert {*found.values()} == {Verdict.UNDECIDED}
