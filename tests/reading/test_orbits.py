"""Derivatives along orbits: of what moves by what moves, and of what is given by one name."""

import pytest

from tests.reading.test_reading import reading, verdicts
from tests.sample import sampled

PLANET = r"""A planet moves by \[ \ddot r-r\dot\varphi^2=-\frac\mu{r^2},\qquad
r\ddot\varphi+2\dot r\dot\varphi=0 .\] """
PREY = r"The model is \[ \dot x=x(a-by),\qquad\dot y=y(kx-c) .\] "
ORBITS = [
    (PLANET + r"With $u=1/r$ and $r^2\dot\varphi=c$ we find",
     r"\frac{d^2u}{d\varphi^2}+u=\frac\mu{c^2}", r"\frac{d^2u}{d\varphi^2}-u=\frac\mu{c^2}"),
    (PLANET + r"Since $r^2\dot\varphi=h$ we have, with $u=1/r$,",
     r"\dot r=-h\frac{du}{d\varphi}", r"\dot r=h\frac{du}{d\varphi}"),
    (PLANET + r"Put $h=r^2\dot\varphi$. Then",
     r"\dot r=\frac h{r^2}\frac{dr}{d\varphi}", r"\dot r=\frac hr\frac{dr}{d\varphi}"),
    (PREY + r"The orbits satisfy",
     r"\frac{dy}{dx}=\frac{y(kx-c)}{x(a-by)}", r"\frac{dy}{dx}=\frac{y(kx+c)}{x(a-by)}"),
    (r"The pendulum moves by \[ \dot q=p,\qquad\dot p=-\sin q .\] Dividing, we get",
     r"p\,dp/dq=-\sin q", r"p\,dp/dq=\sin q"),
    (r"The motion is \[ \ddot x=-V'(x) .\] With $v=\dot x$ we have",
     r"v\frac{dv}{dx}=-V'(x)", r"\frac{dv}{dx}=-V'(x)"),
    (r"A stone moves by \[ \ddot x=0,\qquad\ddot y=-g .\] Hence",
     r"\frac{d^2y}{dx^2}=-\frac g{\dot x^2}", r"\frac{d^2y}{dx^2}=-\frac g{\dot x}"),
]  # fmt: skip


@pytest.mark.parametrize("words, true, false", sampled(ORBITS, 4))
def test_quotients_of_rates(words, true, false):
    (*_, right), (*_, wrong) = (
        [*verdicts(rf"{words} \[ {one} .\]").values()] for one in (true, false)
    )
    assert right.green and wrong.value == "undecided"


POTENTIALS = [
    r"With the potential $V=\frac12kx^2$ the motion is \[ m\ddot x=-\frac{dV}{dx} .\]",
    r"The motion is \[ m\ddot x=-\frac{dV}{dx},\qquad V=\frac14x^4 .\]",
    r"The motion is \[ m\ddot x=-\frac{dV}{dx} .\]",
    r"Let $V=\frac{l^2}{2mx^2}+W(x)$. The motion is \[ m\ddot x=-\frac{dV}{dx} .\]",
    r"The motion is \[ m\ddot x=-V'(x),\qquad V(x)=\frac14x^4-\frac12x^2 .\]",
    r"The motion is \[ m\ddot x=-V'(x) ,\] and $V(x)=\frac12kx^2$ is the potential.",
]


@pytest.mark.parametrize("law", POTENTIALS)
def test_a_force_is_the_slope_of_its_potential(law):
    right = verdicts(law + r" The energy $\frac12m\dot x^2+V$ is an integral.")
    wrong = verdicts(law + r" The energy $\frac12m\dot x^2-V$ is an integral.")
    assert [one.green for one in right.values()] == [True]
    assert not any(one.green for one in wrong.values())


QUARTIC = r"The motion is \[ \ddot x=-V'(x),\quad V(x)=\frac14x^4-\frac12x^2 .\] "
PRIMES = [
    (QUARTIC, r"V''(x)=3x^2-1", r"V''(x)=3x^2"),
    (QUARTIC, r"V'(x)^2=x^6-2x^4+x^2", r"V'(x)^2=x^6-x^4+x^2"),
    (QUARTIC, r"\frac{d}{dt}V(x)=V'(x)\dot x", r"\frac{d}{dt}V(x)=V'(x)x"),
    (QUARTIC, r"\ddot x=x-x^3", r"\ddot x=x^3-x"),
]


@pytest.mark.parametrize("law, true, false", sampled(PRIMES, 2))
def test_a_prime_derives_what_is_given_at_its_argument(law, true, false):
    (*_, right), (*_, wrong) = (
        [*verdicts(rf"{law} Then \[ {one} .\]").values()] for one in (true, false)
    )
    assert right.green and not wrong.green


@pytest.mark.parametrize(
    "text",
    [
        r"The Hamiltonian is \[ H=\frac12(p^2+q^2),\qquad\dot q=p,\qquad\dot p=-q .\] Then \[ \frac{dH}{dq}=0 .\]",
        r"The motion is \[ \dot x=y,\qquad\dot y=-x .\] With $z=x^2+y^2$ \[ \frac{dz}{dx}=0 .\]",
        r"The curves obey \[ \frac{dy}{dx}=-\frac xy .\] The system is \[ \dot x=y,\qquad\dot y=x .\]",
        PREY + r"It is not true that \[ \frac{dy}{dx}=\frac{y(kx-c)}{x(a-by)} .\]",
    ],
)  # fmt: skip
def test_partial_derivatives_and_other_curves_are_not_green(text):
    formulas = [one for one in reading(text).formulas if one.claim is not None]
    printed = {one.item.printed.tex.strip(" .,") for one in formulas}
    found = verdicts(text)
    assert not any(found[tex].green for tex in printed if "frac" in tex)


def test_the_orbits_alone_are_no_law():
    assert not verdicts(r"The orbits are given by \[ \frac{dy}{dx}=-\frac xy .\]")
