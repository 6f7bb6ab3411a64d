"""What is drafted says what was inferred: the source with these comments makes the same claims."""

import pytest

from kowalevski_cas.reading import read
from kowalevski_cas.reading.draft import draft
from kowalevski_cas.source.text import Source
from tests.reading.test_papers import claimed

OSCILLATOR = r"Consider the oscillator \begin{equation}\label{o}\ddot q+kq=0.\end{equation} "
SOLUTIONS = OSCILLATOR + r"Let $u$ and $v$ be two solutions of \eqref{o}. "
CHAIN = (
    r"\section{The ring} Let $q_i$ be coordinates, $i=1,2,3$; the index is taken modulo three. The equations are"
    r"\begin{equation}\label{c}\dot q_i=p_i,\qquad\dot p_i=e^{q_{i-1}-q_i}-e^{q_i-q_{i+1}}.\end{equation}"
    r"We put \[a_i=\tfrac12e^{(q_i-q_{i+1})/2},\qquad b_i=-\tfrac12p_i.\] "
)


def assert_same_claims(text):
    """A text, and the same with the comments that are drafted, make the same claims."""
    reading = read(Source("paper.tex", rf"\begin{{document}}{text}\end{{document}}"))
    drafted = draft(reading)
    again = read(drafted)
    assert claimed(again) == claimed(reading)
    assert draft(again).text == drafted.text


@pytest.mark.parametrize(
    "text",
    [
        SOLUTIONS
        + r"Then $\dot u\dot v+kuv$ is constant, and if $q^2=u^2+v^2$, then $q\dot q=u\dot u+v\dot v$.",
        SOLUTIONS
        + r"Let $q=au+bv$. Then $\dot q=a\dot u+b\dot v$, and $W=u\dot v-v\dot u$ is constant.",
        SOLUTIONS + r"Then $u\dot u+v\dot v=0$.",
        *(
            CHAIN
            + r"\section{Two of them} Suppose now that $a_2=a_3=0$. With $a=a_1$ and $b=b_1-b_2$ we obtain"
            + rf"\[{rates}\] {rest}"
            for rates, rest in (
                (r"\dot a=-ab,\qquad\dot b=4a^2,", r"and $4a^2+b^2=c^2$ is constant."),
                (r"\dot b=4a^2,\qquad\dot a=-ab,", "which is easy."),
            )
        ),
    ],
)
def test_rates_that_are_claimed_change_no_law(text):
    assert_same_claims(text)


@pytest.mark.parametrize(
    "text",
    [
        r"The Hamiltonian $H=\tfrac12(p_x^2+p_y^2+p_z^2)-Fz$ gives the canonical equations"
        r"\[\frac{dx}{dt}=\frac{\partial H}{\partial p_x},\quad\dots,\quad\frac{dp_z}{dt}=-\frac{\partial H}{\partial z}.\]"
        r"Then $p_x$ is an integral.",
        r"The Hamiltonian $H=\tfrac12(p_1^2+p_2^2)+q_1q_2$ gives \[\dot q_1=p_1,\quad\dots,\quad\dot p_2=-q_1.\]"
        r"Then $H$ is an integral.",
    ],
)
def test_equations_of_which_not_all_are_printed_are_a_law_as_before(text):
    assert_same_claims(text)
