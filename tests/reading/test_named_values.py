"""Names that words give to the value of a function along the motion, and to nothing else."""

import pytest

from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import verdicts

LAW = (
    r"""The equations of motion are $$\dot x=y,\qquad \dot y=-x-cy.$$ Put $H=\tfrac12(x^2+y^2)$. """
)
RATE = r" Then $$\dot E=-cy^2.$$"


@pytest.mark.parametrize(
    "words",
    [
        "Denote by $E(t)$ the value of $H$ along a solution.",
        "We denote by $E$ the value of $H$ on the trajectory.",
        "Denote by $E$ the value of $H$.",
        "Через $E$ обозначим значение $H$ на решении.",
    ],
)
def test_a_name_stands_for_the_value_of_a_function_along_the_motion(words):
    assert [one.green for one in verdicts(LAW + words + RATE).values()] == [True]
    wrong = RATE.replace("-cy^2", "-cy")
    assert [one.green for one in verdicts(LAW + words + wrong).values()] == [False]


@pytest.mark.parametrize(
    "words",
    [
        "Denote by $E$ the value of $H$ at the origin.",
        "Denote by $E$ the value of $H$ for $t=0$.",
        "Denote by $E$ the value of $H$ where $y=0$.",
        "Denote by $E$ the greatest value of $H$.",
        "Denote by $E$ twice the value of $H$.",
        "Denote by $E$ the mean value of $H$ along a solution.",
        "Denote by $E$ the value of $H$ along a solution of another system.",
        "Denote by $E$ the value that $H$ has at the beginning.",
        "Let $E$ and $F$ be values of $H$ on two solutions.",
        "Denote by $x_0$ and $E$ the values of $x$ and $H$ at the time $t_0$.",
        "Через $E$ обозначим наибольшее значение $H$.",
        "Через $E$ обозначим значение $H$ в начале координат.",
        "Here $H$ has a constant $E$ in it.",
        "Let $H$ be measured with a constant $E$.",
    ],
)
def test_a_value_at_a_place_or_of_something_else_is_none(words):
    assert not any(one.green for one in verdicts(LAW + words + RATE).values())


FREE = r"""The equations of motion are $$\dot x=y,\qquad \dot y=-x+ax^2.$$
The Hamiltonian $H=\tfrac12(x^2+y^2)-\tfrac13ax^3$ is constant. Hence $$y^2=2h-x^2+\tfrac23ax^3,$$ """


@pytest.mark.parametrize(
    "words",
    [
        "where $h$ is the value of $H$.",
        "where $h$ is the constant value of the integral $H$ along a motion.",
        "where $h$ denotes the constant of the energy $H$.",
        "where $h$ is the energy.",
        "where $h$ is the energy constant.",
        "where $h$ is the value of $H$, and the motion is simple.",
        "где $h$ — постоянная энергии.",
        "где $h$ есть значение интеграла $H$.",
    ],
)
def test_a_letter_is_explained_behind_a_formula_as_the_value_of_a_function(words):
    assert all(one.green for one in verdicts(FREE + words).values())
    wrong = (FREE + words).replace(r"\tfrac23a", r"\tfrac13a")
    found = [*verdicts(wrong).values()]
    assert not found[-1].green
    assert (found[-1] is Verdict.REFUTED) <= ("$H$" in words)


@pytest.mark.parametrize(
    "words",
    [
        "where $h$ is the value of $H$ at the saddle.",
        "where $h$ is the value of $H$, at the origin.",
        "where $h$ is half the value of $H$.",
        "where $h$ is the height.",
        "if $h$ is the energy.",
    ],
)
def test_a_letter_that_is_called_otherwise_is_no_such_value(words):
    assert not [*verdicts(FREE + words).values()][-1].green


ENERGY = r"""The motion is \[\ddot x=-kx-\beta x^3 .\]
The energy is \[E=\tfrac12\dot x^2+\tfrac12kx^2+\tfrac14\beta x^4 .\] """
NAMED = [
    "We denote its value by $h$.",
    "Let $h$ be the value of $E$.",
    "Call $h$ the constant value of $E$.",
    "The value of $E$ is denoted by $h$.",
    "We denote the value of $E$ by $h$.",
    "It is conserved, and we denote its constant by $h$.",
    "Here $E$ has the constant value $h$.",
    "We write $h$ for the value of $E$.",
    "Consider motions with energy $h$.",
    "Let $h$ be the energy.",
    "Calling $h$ the value of $E$ we go on.",
    "We denote the energy constant by $h$.",
]


@pytest.mark.parametrize("words", NAMED)
def test_the_name_of_a_value_is_no_name_of_a_multiple_of_it(words):
    text = rf"{ENERGY}{words} Then \[\dot x^2=Nh-kx^2-\tfrac12\beta x^4 .\]"
    assert [*verdicts(text.replace("N", "2")).values()][-1].green
    assert not [*verdicts(text.replace("N", "3")).values()][-1].green


CITED = r"""The equations of motion are $$\dot x=y,\qquad \dot y=-x.$$ An integral is
\begin{equation}\label{G} G=x^2+y^2. \end{equation} """


@pytest.mark.parametrize(
    "words",
    [
        r"Let $f$ be the constant of the integral (\ref{G}).",
        r"Denote by $f$ the value of \eqref{G}.",
        r"It has a level, where $f$ is the constant of the integral~\eqref{G}.",
        r"Обозначим через $f$ постоянную интеграла \eqref{G}.",
    ],
)
def test_a_letter_is_the_value_of_what_words_cite(words):
    assert (
        verdicts(CITED + words + r" Then $$\dot x^2=f-x^2.$$")[r"\dot x^2=f-x^2"] is Verdict.PROVED
    )
    assert (
        verdicts(CITED + words + r" Then $$\dot x^2=f+x^2.$$")[r"\dot x^2=f+x^2"] is Verdict.REFUTED
    )


@pytest.mark.parametrize(
    "words",
    [
        r"Let $f$ be twice the constant of the integral (\ref{G}).",
        r"Let $f$ be the constant of (\ref{G}) at $x=1$.",
        r"Let $f$ be the square root of the constant of (\ref{G}).",
    ],
)
def test_a_letter_for_something_else_of_what_is_cited_is_no_value(words):
    assert not verdicts(CITED + words + r" Then $$\dot x^2=f-x^2.$$")[r"\dot x^2=f-x^2"].green
