"""New letters: for what moves, or for where it is; and two of them that are the same."""

from itertools import product

import pytest

from kowalevski_cas.reading import ASSUMPTION, CLAIM, DEFINITION
from tests.reading.test_restated import reading, verdicts
from tests.sample import sampled

GREEN = {"PROVED", "CONDITIONAL", "CONFIRMED"}
LETTERS = [("q", "c", "x"), ("r", "l", r"\rho"), (r"\theta", r"\alpha", r"\vartheta")]
"""What moves, where it is at rest, and by how much it deviates from there."""

BEAD = r"A bead moves by \begin{equation}\ddot @q=-k@q+f,\qquad \ddot s=-ns .\end{equation} "


def in_letters(text, letters):
    for print_, own in zip(("@q", "@c", "@x"), letters, strict=True):
        text = text.replace(print_, f"{own} " if own.startswith("\\") else own)
    return text


DEVIATIONS = [
        (r"At rest $@q=@c$ with $@c=f/k$. Put $@q=@c+@x$. Then $\ddot @x=-k@x$.",
         r"\ddot @x=-k@x", "PROVED"),
        (r"At rest $@q=@c$ with $@c=2f/k$. Put $@q=@c+@x$. Then $\ddot @x=-k@x$.",
         r"\ddot @x=-k@x", "REFUTED"),
        (r"Near to the place $@q=@c$, $@c=f/k$, put $@q=@c+@x$. Then $\ddot @x=-k@x+f$.",
         r"\ddot @x=-k@x+f", "REFUTED"),
        (r"At rest $@q=@c$ with $@c=f/k$. Hence $$k@c=f.$$", "k@c=f", "PROVED"),
        (r"At rest $@q=@c$ with $@c=f/k$. Hence $$k@c+f=0.$$", "k@c+f=0", "UNDECIDED"),
]  # fmt: skip


NO_CONSTANTS = [
        r"It is at rest at $@q=@c$, where $@c=f/k$. Then $@c=@q$ always, and $$@q-@c$$ is an integral.",
        r"Put $@q=@c$ at rest, $@c=f/k$; the function $$\dot @q^2+k(@q-@c)^2-s^2$$ is an integral.",
        r"At rest $@q=@c$, where $@c=f/k$. So the velocity vanishes: $\dot @q=0$.",
        r"Let $@q=@c+@x$ near to $@q=@c$. Then $\ddot @x=-k@x$ for every $@c$.",
        r"At rest $@q=@c$ with $@c=-f/k$. Put $@q=@c+@x$; the function $$\dot @x^2+k@x^2$$ is an integral.",
        r"Let $@q=@c$ with $@c=f/k$. Then $\ddot s=0$.",
        r"Let $@q=@c$ with $@c=f/k$. Then $$\dot s^2=n s^2.$$",
        r"It rests at $@q=@c$, $@c=f/k$. The energy $$\tfrac12\dot @q^2+\tfrac12k@q^2-\tfrac12f@q+@c@q$$ is constant.",
]  # fmt: skip


def roles(text):
    found = reading(text).formulas
    return {one.item.printed.tex.strip(): one.role.name for one in found}


@pytest.mark.parametrize("letters", LETTERS)
def test_what_constants_give_behind_is_no_name_for_what_moves(letters):
    text = in_letters(BEAD + r"It is at rest at $@q=@c$, $s=0$, where $@c=f/k$.", letters)
    found = roles(text)
    given = in_letters("@c=f/k", letters).strip()
    assert found[given] in (DEFINITION, ASSUMPTION)
    assert found[in_letters("@q=@c", letters).strip()] in (ASSUMPTION, CLAIM)


@pytest.mark.parametrize(
    ("letters", "text", "claim", "verdict"),
    sampled(((one, *case) for one in LETTERS for case in DEVIATIONS), 5),
)
def test_deviations_are_from_where_it_is(letters, text, claim, verdict):
    found = verdicts(in_letters(BEAD + text, letters))
    got = {tex.replace(" ", ""): one for tex, one in found.items()}
    own = got[in_letters(claim, letters).replace(" ", "")]
    assert own == verdict or {own, verdict} <= GREEN


@pytest.mark.parametrize(("letters", "text"), sampled(product(LETTERS, NO_CONSTANTS), 8))
def test_where_it_is_makes_nothing_constant(letters, text):
    found = verdicts(in_letters(BEAD + text, letters))
    assert not GREEN & {*found.values()}


def test_a_letter_for_what_moves_is_one():
    assert roles(in_letters(BEAD + "We write $@q=@c$. Then $\\ddot @c=-k@c+f$.", LETTERS[0]))["q=c"]
    found = verdicts(in_letters(BEAD, LETTERS[0]) + "Let $w=q$. Then $\\ddot w=-kw+f$.")
    assert found[r"\ddot w=-kw+f"] in GREEN


@pytest.mark.parametrize("names", [("A", "B_{11}"), ("I_1", "I_{11}"), (r"\mu", "n")])
@pytest.mark.parametrize(
    ("factor", "sign", "green"), [("1", "+", True), ("2", "+", False), ("1", "-", False)]
)
def test_two_new_names_are_one(names, factor, sign, green):
    first, second = names
    text = rf"""Put ${first}={second}$. The equations of motion are
    \begin{{equation}}{first} \dot u=v,\qquad\dot v=-u.\end{{equation}}
    The energy \begin{{equation}}{factor}\,{second} u^2{sign}v^2\end{{equation}} is constant."""
    found = verdicts(text)
    assert bool(GREEN & {*found.values()}) is green


@pytest.mark.parametrize("words", ["The length", "We use the length", "With the radius"])
def test_a_letter_is_restricted_where_it_is_first_printed(words):
    text = words + r" $w>0$ of the spring. It moves by \[ \ddot w=-w. \] Then $w>1$."
    found = reading(text).formulas
    names = {one.item.printed.tex: one.role.name for one in found}
    assert names["w>0"] == ASSUMPTION
    assert not GREEN & {*verdicts(text).values()}
