"""What is printed of functions on pages without a law: derivatives, changes of variables, solutions."""

import pytest

from kowalevski_cas.reading import ASSUMPTION, CLAIM, DEFINITION
from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import roles, verdicts

WAVE = r"""The equation is \[ w_s+w_{zzz}-6ww_z=0 . \]
A solution of it is \[ w(z,s)=-2\kappa^2\operatorname{sech}^2(\kappa(z-%ss)) . \]"""
BEAM = r"""Across the layer \[ \nu\frac{\partial^2 v}{\partial z^2}=%sb . \]
There $v=0$ at $z=0$. The solution is \[ v=\frac{b}{2\nu}z(2a-z) . \]"""
SPHERE = r"""Let \[ X=R\sin\alpha,\qquad Y=R\cos\alpha . \] Then
\[ \frac{\partial(X,Y)}{\partial(R,\alpha)}=\begin{pmatrix}\sin\alpha&R\cos\alpha\\%s&-R\sin\alpha\end{pmatrix} . \]"""


@pytest.mark.parametrize(
    ("text", "right", "wrong"),
    [
        (WAVE, r"4\kappa^2", [r"4\kappa", r"2\kappa^2"]),
        (BEAM, "-", ["", "-2"]),
        (SPHERE, r"\cos\alpha", [r"\cos R", r"\sin\alpha"]),
    ],
)
def test_what_a_function_satisfies_is_judged(text, right, wrong):
    (true,) = [v for tex, v in verdicts(text % right).items() if "partial" in tex or "w_s" in tex]
    assert true.green
    for one in wrong:
        assert not any(
            v.green for tex, v in verdicts(text % one).items() if "partial" in tex or "w_s" in tex
        )


@pytest.mark.parametrize(
    ("rate", "green"),
    [(r"-n^2 Q", True), (r"-n Q", False), (r"n^2 Q", False), (r"-n^2 Q+A", False)],
)  # fmt: skip
def test_a_function_of_the_time_is_derived_without_a_law(rate, green):
    text = rf"The motion is \[ Q=A\cos(nt)+B\sin(nt) . \] Hence \[ \ddot Q={rate} . \]"
    assert verdicts(text)[rf"\ddot Q={rate}"].green is green


def test_a_function_that_is_printed_at_its_arguments_once_is_that_function():
    text = r"Put \[ K(u,v)=u^2+3uv . \] Then \[ \frac{\partial K}{\partial u}=2u+%sv . \]"
    assert [one.green for one in verdicts(text % "3").values()] == [True]
    assert [one.green for one in verdicts(text % "2").values()] == [False]


@pytest.mark.parametrize(
    "words",
    ["As before, with $c=2$, ", "For a given value ", "For constant $c$, the sum of both is "],
)
def test_a_display_that_completes_a_main_clause_is_claimed(words):
    text = rf"Put $u=c+1$. {words}\[ u^2=c^2+2c+1 . \]"
    assert roles(text)["u^2=c^2+2c+1"] == CLAIM


@pytest.mark.parametrize("words", ["Suppose that", "We restrict ourselves to the case", "Let"])
def test_what_words_suppose_is_supposed(words):
    text = rf"The motion is $\dot u=c\,b$. {words} \[ c=2b . \] Then $u$ moves."
    assert roles(text)["c=2b"] == ASSUMPTION


def test_the_letters_of_what_stands_before_are_explained_behind_it():
    text = r"Put $E=u^2+4v^2$. Then \[ \frac{u^2}{M^2}+\frac{v^2}{N^2}=1 \] with the axes \[ M=\sqrt E,\quad N=%s . \]"
    assert roles(text % r"\tfrac12\sqrt E")[r"M=\sqrt E"] == DEFINITION
    first = r"\frac{u^2}{M^2}+\frac{v^2}{N^2}=1"
    assert verdicts(text % r"\tfrac12\sqrt E")[first].green
    assert not verdicts(text % r"2\sqrt E")[first].green


def test_coordinates_that_are_given_later_satisfy_what_was_said():
    text = r"For the radius $R$ we have \[ X^2+Y^2=R^2 . \] By the angle $\eta$ \[ X=R\cos\eta,\qquad Y=%s\sin\eta . \]"
    assert verdicts(text % "R")["X^2+Y^2=R^2"].green
    assert not verdicts(text % "")["X^2+Y^2=R^2"].green


def test_a_row_before_the_law_may_be_of_another_system():
    text = r"""In $\ddot u+n^2u=\sin kt$ the force is another one. The equation of motion is
    \[ \ddot u+n^2u=\cos kt . \]"""
    assert Verdict.REFUTED not in verdicts(text).values()
