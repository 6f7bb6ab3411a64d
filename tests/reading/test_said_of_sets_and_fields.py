"""Orbits are invariant, regions are no claims, and a field may be cited by its equations."""

import pytest

from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import roles, verdicts

THERMOSTAT = r"The equations are \[ \dot q=p,\quad \dot p=-q-\zeta p,\quad \dot\zeta=p^2-T . \] "
AVERAGED = r"The equations are \[ \dot J=-\zeta J,\qquad Q\dot\zeta=J-T . \] "
LORENZ = r"""The equations are \begin{equation}\label{l} \dot x=\sigma(y-x),\quad \dot y=rx-y-xz,\quad
\dot z=xy-bz . \end{equation} """


@pytest.mark.parametrize(
    ("text", "green"),
    [
        ("The axis $q=p=0$ is an orbit.", True),
        ("The plane $q=0$ consists of orbits.", False),
        ("Прямая $q=p=0$ состоит из траекторий.", True),
    ],
)
def test_an_orbit_is_invariant(text, green):
    assert [one.green for one in verdicts(THERMOSTAT + text).values()] == [green]


@pytest.mark.parametrize(("value", "green"), [(r"\sqrt{T/Q}", True), (r"\sqrt{TQ}", False)])
def test_a_frequency_rests_on_all_equations_of_a_point(value, green):
    text = AVERAGED + r"The equilibrium in $J>0$ is $J=T$, $\zeta=0$. The frequency of small "
    text += rf"oscillations about it is \[ \Omega={value} . \]"
    assert verdicts(text)[rf"\Omega={value}"].green is green
    assert roles(text)["J>0"] == "other"


@pytest.mark.parametrize(
    ("value", "verdict"), [("-\\sigma-b-1", Verdict.PROVED), ("-\\sigma-b", Verdict.UNDECIDED)]
)
def test_the_divergence_of_what_is_cited(value, verdict):
    found = verdicts(LORENZ + rf"The divergence of \eqref{{l}} is ${value}$.")
    assert [*found.values()] == [verdict]
