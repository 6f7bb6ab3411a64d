"""One point is not everywhere: where roots have divisors of zero, a space has several pieces.

The root of f² is f on one of them and −f on the other. A function times 1 − f/√f² is nothing there,
and is independent of others on the other piece.
"""

import random

import pytest

from kowalevski_cas import System
from kowalevski_cas.paper.claims import Independence
from tests.paper.small import Motion

pytestmark = pytest.mark.usefixtures("uncorrected", "here")

FEW, MANY = 1, 8
MARKS = [FEW, pytest.param(MANY, marks=pytest.mark.slow)]
HAMILTON = (
    r"\dot x=\frac{\partial H}{\partial p},\quad \dot y=\frac{\partial H}{\partial q},\quad "
    r"\dot p=-\frac{\partial H}{\partial x},\quad \dot q=-\frac{\partial H}{\partial y},\quad H="
)


def factors(seed):
    """What vanishes on one piece or the other, and what does on none; all of them of x alone."""
    choose = random.Random(seed)
    a, b = choose.randint(1, 3), choose.randint(-2, 2)
    f = choose.choice([f"({a}x+({b}))", f"({a}x^2+({b})x)", f"(x^3-{a})"])
    root = rf"\sqrt{{{f}^2}}"
    some = [rf"(1{sign}\frac{{{f}}}{{{root}}})" for sign in "+-"] + [f"({f}+{root})"]
    n = choose.choice([2, 3, -2])
    return some, [rf"({n}+\frac{{{f}}}{{{root}}})", f"({n}{f}+{root})"], f, root


def claims(factor, seed):
    """Claims that rest on a rank, of functions with a factor in x."""
    choose = random.Random(seed)
    k = choose.randint(1, 3)
    still = System(rf"\dot x=0,\quad \dot y={k}z,\quad \dot z=-{k}y")
    yield still.integral(f"(y^2+z^2){factor}")
    yield still.integral(rf"\ln(1+(y^2+z^2)^2{factor}^2)")
    still.define(r"\{y,z\}=1,\quad \{x,y\}=0,\quad \{z,x\}=0")
    yield still.casimir(f"(x^2+{k}){factor}")
    L = still.define(
        rf"{{\bf L}}=\begin{{pmatrix}}y{factor}&z{factor}\\z{factor}&-y{factor}\end{{pmatrix}}"
    )
    M = still.define(
        rf"{{\bf M}}=\begin{{pmatrix}}0&-\frac{{{k}}}{{2}}\\\frac{{{k}}}{{2}}&0\end{{pmatrix}}"
    )
    yield still.lax(L, M)
    plane = System(HAMILTON + rf"\frac{{1}}{{2}}(p^2+q^2)+{k}x^2")
    plane.define(r"\{x,p\}=1,\quad \{y,q\}=1")
    yield plane.integrable("H", f"q{factor.replace('x', 'q')}")
    paper = Motion(r"\dot x=0, \dot y=0, \dot z=0", "x", "y", "z")
    tex = paper.display(f"h=y,\\quad g=z{factor}")
    scene = paper.scene.adjoining(rf"\sqrt{{{factor.partition('sqrt{')[2].partition('^2}')[0]}^2}}")
    claim = dict(levels=(), equations=(), functions=(*tex,))
    yield paper.outcome(Independence, on=scene.defining(tex), **claim)


@pytest.mark.slow
@pytest.mark.parametrize("many", MARKS)
def test_what_is_nothing_on_one_piece_is_independent_of_nothing(many):
    for seed in range(many):
        for factor in factors(seed)[0][:many]:
            for stated in claims(factor, seed):
                assert not stated.verdict.green, stated


@pytest.mark.parametrize("many", MARKS)
def test_what_is_something_on_each_is(many):
    for seed in range(many):
        for factor in factors(seed)[1][:many]:
            for stated in claims(factor, seed):
                assert stated.verdict.green, stated
