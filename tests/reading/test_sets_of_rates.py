r"""Sets on which rates vanish, printed side by side or in a chain: :math:`x=\dot x=0`."""

from itertools import product

import pytest

from tests.reading.test_restated import verdicts
from tests.sample import sampled

GREEN = {"PROVED", "CONDITIONAL", "CONFIRMED"}
LETTERS = [("q", "s"), ("x", "y"), (r"\theta", r"\rho"), ("u_1", "u_2")]
LAW = r"""A body moves by \begin{equation}\ddot @q=-\sin @q\,(1+@s),\qquad
\ddot @s=-@s+\dot @q^2 .\end{equation} """

TRUE = [
    r"The set $@q=0$, $\dot @q=0$ is invariant.",
    r"The set $\dot @q=0$, $@q=0$ is invariant.",
    r"The set where $@q=0$ and $\dot @q=0$ is invariant.",
    r"The point $@q=0$, $@s=0$, $\dot @q=0$, $\dot @s=0$ is an equilibrium.",
]
FALSE = [
    r"The set $@s=0$, $\dot @s=0$ is invariant.",
    r"The set where $\dot @s=0$ and $@s=0$ is invariant.",
    r"The plane $@s=\dot @s=0$ is invariant.",
    r"The set $@q=0$, $\dot @s=0$ is invariant.",
    r"The set $@q=\dot @s=0$ is invariant.",
    r"The axis $@q=@s=0$ is invariant.",
    r"The sets $@q=0$ or $\dot @q=0$ are invariant.",
    r"The sets $@q=0$ and $\dot @s=0$ are invariant.",
    r"The point $@q=0$, $\dot @q=0$ is an equilibrium.",
    r"The point $@q=\dot @q=0$ is an equilibrium.",
    r"If $@q=\dot @q=0$ at one time, then $@s=\dot @s=0$.",
    r"The set $@q=0$, $\dot @q=0$ is not invariant.",
    r"Then $@q=0$, $\dot @q=0$, and nothing moves.",
    r"On the plane $@q=\dot @q=0$ we have $\ddot @s=@s$.",
]


def judged(text, letters):
    for print_, own in zip(("@q", "@s"), letters, strict=True):
        text = text.replace(print_, f"{{{own}}}")
    return {*verdicts(text).values()}


@pytest.mark.parametrize(("text", "letters"), sampled(product(TRUE, LETTERS), 4))
def test_sets_that_no_motion_leaves(text, letters):
    found = judged(LAW + text, letters)
    assert found and found <= GREEN


@pytest.mark.parametrize(("text", "letters"), sampled(product(FALSE, LETTERS), 14))
def test_sets_that_some_motion_leaves(text, letters):
    assert not GREEN & judged(LAW + text, letters)


@pytest.mark.parametrize(
    "text",
    [
        r"The set $@q=\dot @q=0$ is invariant.",
        r"On the axis $@q=\dot @q=0$ nothing turns.",
        r"Suppose that $@q=\dot @q=0$.",
        r"The point $@q=0$, $\dot @q=0$ is an equilibrium.",
    ],
)
def test_what_holds_on_a_set_is_no_equation_that_is_refuted(text):
    pendulum = r"A pendulum swings by \begin{equation}\ddot @q=-k\sin @q .\end{equation} "
    assert "REFUTED" not in judged(pendulum + text, LETTERS[2])


@pytest.mark.parametrize(
    ("chain", "green"), [(r"x=\dot x=0", True), (r"y=\dot y=0", False), ("x=y=0", False)]
)
def test_a_chain_is_a_set(chain, green):
    law = r"A body moves by \[ \ddot x=-x(1+y),\qquad \ddot y=-y+\dot x^2 . \] "
    found = verdicts(law + f"The set ${chain}$ is invariant.")
    assert bool(found) and bool(GREEN & {*found.values()}) is green


FREE = r"Consider the system $\dot u=v$, $\dot v=-u+u^3$. "


@pytest.mark.parametrize(
    "text",
    [
        "Where $RATES$ we have $v=0$.",
        "At the points with $RATES$ we have $v=0$.",
        "If $RATES$, then $v=0$.",
        "The conditions $RATES$ give $v=0$.",
        "In equilibrium $RATES$, hence $v=0$.",
        r"The points of rest are found from \[ RATES. \]",
        "В положении равновесия $RATES$.",
    ],
)
def test_rates_that_vanish_where_something_rests_are_no_claim(text):
    found = verdicts(FREE + text.replace("RATES", r"\dot u=\dot v=0"))
    assert "REFUTED" not in found.values()


def test_what_is_concluded_of_rates_is_one():
    tex = r"\dot u=\dot v=0"
    assert verdicts(FREE + f"Hence ${tex}$.")[tex] == "REFUTED"


@pytest.mark.parametrize(
    ("words", "named"),
    [
        ("The set $x_i=0$ is invariant.", {"PROVED"}),
        ("The planes $x_i=0$, $i=1,2,3$, are invariant.", {"PROVED"}),
        ("The point $x_i=1/3$ is an equilibrium.", {"PROVED"}),
        ("The set $x_i=1$ is invariant.", {"REFUTED"}),
        (r"The points $x_i=\pm1$ are equilibria.", {"UNDECIDED"}),
    ],
)
def test_an_equation_for_each_index_is_a_set(words, named):
    law = r"Consider \[ \dot x_i=x_i(1-x_1-x_2-x_3),\qquad i=1,2,3. \] "
    assert {*verdicts(law + words).values()} == named


@pytest.mark.parametrize("where", ["where", "for", "if", "when", "at", "on the line"])
@pytest.mark.parametrize(("place", "green"), [("x=1", True), ("x=2", False), (r"x=\pm1", False)])
def test_words_behind_rates_say_where_they_vanish(where, place, green):
    text = r"Let \[ \dot x=y,\qquad\dot y=x-x^2. \] "
    found = verdicts(rf"{text}Hence $\dot y=0$ {where} ${place}$.")
    assert (found[r"\dot y=0"] == "PROVED") == green
    assert found[r"\dot y=0"] != "REFUTED" or not green


def test_one_of_two_places_is_not_enough():
    text = r"Let \[ \dot x=y,\qquad\dot y=x-x^2. \] Hence $\dot y=0$ for $x=1$ or $x=2$."
    assert verdicts(text)[r"\dot y=0"] != "PROVED"
