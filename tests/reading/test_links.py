r"""Chains of constants: :math:`b=2\sigma>0` supposes an equation, and an inequality."""

import pytest

from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import reading, verdicts
from tests.sample import sampled

LORENZ = r"The Lorenz system is $\dot x=\sigma(y-x)$, $\dot y=\rho x-y-xz$, $\dot z=xy-bz$. "
EULER = r"Consider $\dot p=(b-c)qr$, $\dot q=(c-a)rp$, $\dot r=(a-b)pq$. "
BODY = r"Let $A\dot p=(B-C)qr$, $B\dot q=(C-A)rp$, $C\dot r=(A-B)pq$. "
PAIRS = [
    (rf"{LORENZ}Let $b=2\sigma>0$. With $F=x^2-2\sigma z$ we have ", r"$\dot F=-2\sigma F$."),
    (rf"{LORENZ}With $F=x^2-2\sigma z$ and $b=2\sigma=2$ we have ", r"$\dot F=-2F$."),
    (r"Let $\dot x=-bx$, $0<b=2a<1$. Then ", r"$\dot x=-2ax$."),
    (r"The parameters satisfy $b=2a>0$, and $\dot x=-bx$. Then ", r"$\dot x=-2ax$."),
    (r"Let $\dot x=-bx$ and $b=2a\ne0$. We have ", r"$\dot x=-2ax$."),
    (rf"{EULER}Let $a=b>c$. Then ", r"$\dot p=(a-c)qr$."),
    (rf"{BODY}For $A=B=2C>0$ we have ", r"$2\dot p=qr$."),
    (r"Let $\dot x=y$, $\dot y=-\omega^2x$, where $\omega^2=g/l>0$. Then ", r"$l\dot y=-gx$."),
    (r"Let $\dot x=y$, $\dot y=-kx$, where $y(0)=0$ and $x(0)=a>0$. Then ", r"$y^2+kx^2=ka^2$."),
    (r"For $a,b=1$ the system $\dot x=ay$, $\dot y=-bx$ gives ", r"$\ddot x=-x$."),
]


@pytest.mark.parametrize(("given", "claim"), sampled(PAIRS, 3))
def test_each_link_of_a_chain_is_supposed(given, claim):
    assert [one.green for one in verdicts(given + claim).values()] == [True]
    false = claim.removesuffix("$.") + "+1$."
    assert [one.green for one in verdicts(given + false).values()] == [False]


@pytest.mark.parametrize(("name", "true"), [("r", True), ("p", False)])
def test_of_a_symmetric_body_one_component_is_constant(name, true):
    found = verdicts(rf"{BODY}Let $A=B>C$. Then ${name}$ is an integral.")
    assert [*found.values()] == [Verdict.CONDITIONAL if true else Verdict.REFUTED]


def test_what_moves_is_in_one_chain():
    text = r"Let $\dot x=y$, $\dot y=-x-ky$, $k>0$, and $E=x^2+y^2$. Then $\dot E=-2ky^2\le0$."
    assert [one.green for one in verdicts(text).values()] == [True]


def test_the_links_are_where_the_chain_is():
    found = reading(r"Let $\dot x=-bx$ and $b=2a>0$. We have $\dot x=-2ax$.")
    printed = {one.item.printed.tex.strip() for one in found.formulas}
    assert printed == {r"\dot x=-bx", "b=2a", "2a>0", r"\dot x=-2ax"}


@pytest.mark.parametrize(("right", "true"), [("y", True), ("x", False)])
def test_brackets_with_one_value_are_in_one_chain(right, true):
    text = rf"""Let $H=\frac12(p_x^2+p_y^2)+\frac12(x^2+y^2)$ and $K=xp_y-yp_x$. Then $\{{K,x\}}={right}$,
    where $\{{x,p_x\}}=\{{y,p_y\}}=1$."""
    assert [one.green for one in verdicts(text).values()] == [true]
