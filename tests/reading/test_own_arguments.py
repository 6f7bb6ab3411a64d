"""What is given by what moves and by the time stands by its name, whatever its arguments."""

import pytest

from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import verdicts

LAW = r"""Consider the Hamiltonian \[ H(q,p,t)=\frac{p^2}2-\Bigl(q^2+\frac t2\Bigr)p-aq . \]
The equations of motion are \[ q'=p-q^2-\frac t2,\qquad p'=2qp+a . \] """


@pytest.mark.parametrize(
    ("claim", "verdict"),
    [
        (r"\sigma'=-\frac12p", Verdict.PROVED),
        (r"\sigma''=-\frac12(2qp+a)", Verdict.PROVED),
        (r"\sigma'=-\frac12q", Verdict.REFUTED),
        (r"\sigma''=-\frac12(2qp-a)", Verdict.REFUTED),
    ],
)
def test_the_energy_along_a_solution(claim, verdict):
    text = LAW + rf"Let $\sigma(t)=H(q(t),p(t),t)$. Then \[ {claim} . \]"
    assert [*verdicts(text).values()] == [verdict]


@pytest.mark.parametrize(("right", "verdict"), [("x+y", True), ("x-y", False)])
def test_an_integral_may_name_the_time(right, verdict):
    law = r"The equations of motion are \[ \dot x=-tx,\qquad \dot y=tx . \] "
    found = verdicts(law + rf"The function \[ F(x,y,t)={right} \] is a first integral.")
    assert [one.green for one in found.values()] == [verdict]


def test_values_at_other_arguments_are_not_taken_for_it():
    text = LAW + r"Let $\sigma(t)=H(q(t),p(t),t)$. Then \[ H(q,p,0)=\sigma . \]"
    assert not any(one.green for one in verdicts(text).values())


@pytest.mark.parametrize(("rate", "green"), [("-ap", True), ("ap", False)])
def test_an_energy_of_a_place_and_a_momentum_that_is_a_rate(rate, green):
    text = r"The motion is \[ \ddot q=-q-a. \] The energy is \[ H(q,p,t)=\tfrac12(p^2+q^2), \] "
    found = verdicts(
        text + rf"and is not conserved; with $p=\dot q$, \[ \frac{{dH}}{{dt}}={rate}. \]"
    )
    assert [one.green for one in found.values()] == [green]
