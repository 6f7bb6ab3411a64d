"""Energies and momenta in other letters: Hamiltonians by T+V, kinetic energies by ½Σpq̇."""

import pytest

from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import verdicts

SPRING = r"""The energies are \[ T=\tfrac12m\dot s^2+\tfrac12ms^2\dot\alpha^2,\qquad V=\tfrac12cs^2-ms\cos\alpha, \]
and the equations of Lagrange are \[ m\ddot s=ms\dot\alpha^2-cs+m\cos\alpha,\qquad
s\ddot\alpha+2\dot s\dot\alpha+\sin\alpha=0 . \] """
WELL = r"""The Hamiltonian is \[ H=\tfrac12(p_x^2+p_y^2)-\frac kr-Fy,\qquad r=\sqrt{x^2+y^2} . \]
The energy is $H=E$. Introduce $u=r+y$, $v=r-y$. The kinetic energy is
\[ T=\frac{u+v}8\left(\frac{\dot u^2}u+\frac{\dot v^2}v\right), \] and therefore """


def last(text):
    return [*verdicts(text).values()][-1]


@pytest.mark.parametrize(
    ("momenta", "energy", "true"),
    [
        (r"With $p_s=m\dot s$, $p_\alpha=ms^2\dot\alpha$ ", r"\frac{p_\alpha^2}{2ms^2}", True),
        ("", r"\frac{p_\alpha^2}{2ms^2}", True),
        ("", r"\frac{p_\alpha^2}{ms^2}", False),
        ("", r"\frac{p_\alpha^2}{2ms}", False),
    ],
)
def test_a_hamiltonian_is_the_sum_of_the_energies(momenta, energy, true):
    text = rf"{SPRING} {momenta} the Hamiltonian is \[ H=\frac{{p_s^2}}{{2m}}+{energy}+\tfrac12cs^2-ms\cos\alpha . \]"
    assert last(text) is not Verdict.REFUTED
    assert last(text).green is true


@pytest.mark.parametrize(("sign", "true"), [("-", True), ("", False)])
def test_momenta_that_are_not_printed_are_those_of_the_kinetic_energy(sign, true):
    text = rf"{SPRING} We have $\dot p_\alpha={sign}ms\sin\alpha$."
    assert last(text).green is true and last(text) is not Verdict.REFUTED


def test_a_lagrangian_comes_before_the_kinetic_energy():
    """It has terms that are linear in the velocities, and momenta have these."""
    text = r"""The kinetic energy is \[ T=\tfrac12(\dot x^2+\dot y^2). \] The Lagrangian is
    \[ L=\tfrac12(\dot x^2+\dot y^2)+\tfrac b2(x\dot y-y\dot x). \]
    Then \[ \ddot x=b\dot y,\qquad \ddot y=-b\dot x,\qquad {} . \]"""
    assert last(text.replace("{}", r"p_x=\dot x-\tfrac b2y,\qquad \dot p_x=\tfrac b2\dot y")).green


@pytest.mark.parametrize(
    ("claim", "true"),
    [
        (r"H=\frac{2(up_u^2+vp_v^2)}{u+v}-\frac{2k}{u+v}-\frac F2(u-v)", True),
        (r"H=\frac{2(up_u^2+vp_v^2)}{u+v}-\frac{2k}{u+v}+\frac F2(u-v)", False),
        (r"\dot u=\frac{4up_u}{u+v}", True),
        (r"\dot u=\frac{2up_u}{u+v}", False),
    ],
)
def test_momenta_of_new_coordinates(claim, true):
    found = verdicts(rf"{WELL} \[ {claim} . \]")
    assert found[claim].green is true and found[claim] is not Verdict.REFUTED


@pytest.mark.parametrize(("factor", "true"), [("8", True), ("4", False)])
def test_a_kinetic_energy_in_new_coordinates_is_claimed(factor, true):
    (tex,) = (tex for tex in verdicts(WELL.replace("8", factor) + "so.") if tex[0] == "T")
    assert verdicts(WELL.replace("8", factor) + "so.")[tex].green is true


def test_what_stands_with_a_sign_is_named_and_the_next_equation_claims():
    text = rf"{WELL} we separate: \[ 2up_u^2-Eu-\tfrac F2u^2-k=-\beta,\qquad {{}} . \]"
    for sign, true in (("+", True), ("-", False)):
        claim = rf"2vp_v^2-Ev{sign}\tfrac F2v^2-k=\beta"
        assert verdicts(text.replace("{}", claim))[claim].green is true


def test_a_constant_that_has_been_named_is_not_named_again():
    """What it is said to be later is claimed; else what is wrong there would spoil the rest."""
    text = rf"""{WELL} we separate: \[ 2up_u^2-Eu-\tfrac F2u^2-k=-\beta . \] The constant $\beta$ is
    known: put \[ S=yp_x^2-xp_xp_y . \] Comparison shows that $\beta=S$. For the momenta
    \[ p_u^2=\frac E2+\frac{{k-\beta}}{{2u}}+\frac F4u . \]"""
    found = verdicts(text)
    assert not found[r"\beta=S"].green
    assert last(text).green
