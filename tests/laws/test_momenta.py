r"""Momenta of papers: what gives the vector of which the rate is printed moves, and is no constant."""

import random

import pytest

from tests.laws.test_prints import FEW
from tests.reading.test_reading import verdicts

pytestmark = pytest.mark.usefixtures("uncorrected")


def claims(*formulas):
    return "".join(f"The function ${one}$ is a first integral. " for one in formulas)


@FEW
def test_what_gives_the_momentum_moves(seed):
    """It stands before the equations, among them, or behind; false is what is true of constants."""
    chance = random.Random(seed)
    M, w = chance.choice([("M", r"\omega"), ("K", r"\omega"), ("L", r"\Omega")])
    M, w, g = (rf"\mathbf {M}", rf"\boldsymbol{w}", r"\boldsymbol\gamma")
    tensor = r"$\mathbf I=\operatorname{diag}(A,B,C)$"
    ball = chance.random() < 0.5
    more = rf"+D{g}\times({w}\times{g})" if ball else ""
    gives = rf"{M}=\mathbf I{w}{more}"
    law = rf"\dot{{{M}}}={M}\times{w},\quad\dot{{{g}}}={g}\times{w}"
    place = chance.choice(["before", "beside", "behind"])
    beside = rf",\quad {gives}" if place == "beside" else ""
    text = rf"The equations of motion are $${law}{beside}.$$ "
    if place == "before":
        text = rf"Let $${gives}$$ be the angular momentum, where {tensor}. {text}"
    else:
        behind = f"{gives}" if place == "behind" else ""
        text += f"Here $${behind}$$ and {tensor}. " if behind else f"Here {tensor}. "
    true = [rf"{M}^2", rf"({M},{g})", rf"({M},{w})"]
    false = [rf"({w},{g})", rf"({M},\mathbf I{w})" if ball else rf"{w}^2"]
    found = verdicts(text + claims(*true, *false))
    assert all(found[one].green for one in true), (text, found)
    assert not any(found[one].green for one in false), (text, found)


@FEW
def test_where_each_gives_the_other_one_of_them_moves(seed):
    chance = random.Random(seed)
    rows = [r"$\mathbf M=\mathbf I\boldsymbol\omega$", r"$\boldsymbol\omega=\mathbf I^{-1}\mathbf M$"]  # fmt: skip
    chance.shuffle(rows)
    text = (
        r"The equations of motion are $$\dot{\mathbf M}=\mathbf M\times\boldsymbol\omega,\quad"
        r"\dot{\boldsymbol\gamma}=\boldsymbol\gamma\times\boldsymbol\omega.$$ "
        rf"Here {rows[0]}, {rows[1]} and $\mathbf I=\operatorname{{diag}}(A,B,C)$. "
    )
    true, false = r"(\mathbf M,\boldsymbol\gamma)", r"(\boldsymbol\omega,\boldsymbol\gamma)"
    found = verdicts(text + claims(true, false))
    assert found[true].green and not found[false].green, (text, found)
    assert all(found[tex.strip("$")].green for tex in rows[1:] if tex.strip("$") in found), found


def test_a_momentum_by_components_says_which_of_them_move():
    text = (
        r"The equations of motion are $$\dot{\mathbf M}=\mathbf M\times\boldsymbol\omega,\quad"
        r"\dot{\boldsymbol\gamma}=\boldsymbol\gamma\times\boldsymbol\omega.$$ "
        r"Here $\boldsymbol\omega=(p,q,r)$ and $\mathbf M=(Ap,Bq,Cr)$. "
    )
    true, *false = ("Ap^2+Bq^2+Cr^2", "Ap^2+Bq^2", r"(\boldsymbol\omega,\boldsymbol\gamma)")
    found = verdicts(text + claims(true, *false))
    assert found[true].green and not any(found[one].green for one in false), found
