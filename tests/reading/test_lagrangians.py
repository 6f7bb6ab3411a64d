"""A Lagrangian, and equations that follow from it: they are claimed, also where they look closed."""

import pytest

from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import roles, verdicts
from tests.sample import sampled

SPHERICAL = r"""Let $\theta$, $\varphi$ be angles. Then
\[ L=\frac A2(\dot\theta^2+\dot\varphi^2\sin^2\theta)-P\cos\theta . \] """
TOP = (
    SPHERICAL
    + r"""The coordinate $\varphi$ is cyclic, hence \[ k=A\dot\varphi\sin^2\theta \] is constant.
The equation for $\theta$ is \[ A\ddot\theta=A\dot\varphi^2\sin\theta\cos\theta+P\sin\theta . \]
The energy is \[ h=\frac A2(\dot\theta^2+\dot\varphi^2\sin^2\theta)+P\cos\theta . \]
With $u=\cos\theta$ we obtain \[ \dot\varphi=\frac k{A(1-u^2)} \] and
\[ A^2\dot u^2=2A(h-Pu)(1-u^2)-k^2 . \]"""
)


@pytest.mark.parametrize(
    ("right", "wrong"),
    sampled(
        [
            ("k=A\\dot", "k=P\\dot\\theta+A\\dot"),
            (r"+P\sin\theta", r"-P\sin\theta"),
            (r"+P\cos\theta . \]" + "\nWith", r"-P\cos\theta . \]" + "\nWith"),
            (r"\frac k{A(1-u^2)}", r"\frac k{A(1+u^2)}"),
            ("(1-u^2)-k^2", "(1-u^2)+k^2"),
        ],
        2,
    ),
)
def test_integrals_of_a_lagrangian_do_not_stand_for_it(right, wrong):
    assert all(one.green for one in verdicts(TOP).values())
    assert not all(one.green for one in verdicts(TOP.replace(right, wrong)).values())


@pytest.mark.parametrize("name", ["The overdamped motion obeys", "In the gradient flow"])
def test_rates_of_all_coordinates_to_a_lower_order_are_another_law(name):
    rows = r"\dot\theta=k\sin\theta,\qquad\dot\varphi=0"
    found = roles(SPHERICAL.replace("Then", "The Lagrangian is") + rf"{name} \[ {rows} . \]")
    assert [found[row] for row in rows.split(r",\qquad")] == ["law", "law"]


KEPLER = r"""The equations are \[ \ddot x=-\frac{\mu x}{r^3},\qquad \ddot y=-\frac{\mu y}{r^3},\qquad
r=\sqrt{x^2+y^2} . \] Introduce a new independent variable $s$ by \[ dt=r\,ds . \] """


@pytest.mark.parametrize(
    ("row", "verdict"),
    [
        (r"x''=\frac{r'x'}{r}-\frac{\mu x}{r}", Verdict.CONDITIONAL),
        (r"x''=\frac{r'x'}{r}-\frac{\mu x}{r^2}", Verdict.REFUTED),
    ],
)
def test_primes_are_by_the_time_that_differentials_give(row, verdict):
    text = rf"{KEPLER}With a prime for the derivative by $s$ we have \[ {row} . \]"
    assert verdicts(text)[row] is verdict
