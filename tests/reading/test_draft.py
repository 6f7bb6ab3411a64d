"""What is drafted says what was inferred: the source with these comments makes the same claims."""

import pytest

from kowalevski_cas.reading import read
from kowalevski_cas.reading.draft import draft
from kowalevski_cas.source.text import Source
from tests.reading.test_papers import claimed

OSCILLATOR = r"Consider the oscillator \begin{equation}\label{o}\ddot q+kq=0.\end{equation} "
SOLUTIONS = OSCILLATOR + r"Let $u$ and $v$ be two solutions of \eqref{o}. "
PLANE = r"A point moves by \begin{equation}\label{e}\ddot x=-kx,\qquad\ddot y=-ky.\end{equation} "
EULER = r"The equations of motion are \begin{equation}\label{e}A\dot p=(B-C)qr,\quad B\dot q=(C-A)rp,\quad C\dot r=(A-B)pq.\end{equation} "
TOP = (
    r"The equations of motion are \begin{equation}\label{e}"
    r"\dot{\mathbf L}=\mathbf L\times\mathbf w+P\,\mathbf g\times\mathbf e,\qquad"
    r"\dot{\mathbf g}=\mathbf g\times\mathbf w,\end{equation} where $\mathbf L=\mathbf J\mathbf w$. "
)
CHAIN = (
    r"\section{The ring} Let $q_i$ be coordinates, $i=1,2,3$; the index is taken modulo three. The equations are"
    r"\begin{equation}\label{c}\dot q_i=p_i,\qquad\dot p_i=e^{q_{i-1}-q_i}-e^{q_i-q_{i+1}}.\end{equation}"
    r"We put \[a_i=\tfrac12e^{(q_i-q_{i+1})/2},\qquad b_i=-\tfrac12p_i.\] "
)
MAP = r"Consider the map \[\varphi:(x,y)\mapsto(x',y'),\qquad x'=y,\qquad y'=\frac{a+y}{x}.\] "


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


@pytest.mark.parametrize(
    "text",
    [
        MAP + r"With the reflection $\sigma(x,y)=(y,x)$ it is reversible.",
        MAP + r"Put $\iota(x,y)=\bigl(x,(a+x)/y\bigr)$. Then $x+y+1/x$ is not preserved.",
    ],
)
def test_of_what_is_no_formula_no_comment_is_drafted(text):
    assert_same_claims(text)


@pytest.mark.parametrize(
    "text",
    [
        *(
            EULER + rf"They have the integral \[Ap^2+Bq^2=2h-Cr^2.\] {rest}"
            for rest in ("", r"If $p=0$, then $Bq^2+Cr^2=2h$.", r"Then $2h-Ap^2-Bq^2-Cr^2=0$.")
        ),
        *(
            PLANE + rf"They have the integral \[{energy}\] If $y=0$, then $\dot x^2=2h-kx^2$."
            for energy in (
                r"\tfrac12(\dot x^2+\dot y^2)=h-\tfrac12k(x^2+y^2).",
                r"\dot x^2+\dot y^2-2h=-k(x^2+y^2).",
                r"\dot x^2+\dot y^2=3h-k(x^2+y^2).",
            )
        ),
        TOP
        + r"They have the integral \[\tfrac12\,\mathbf w\cdot\mathbf J\mathbf w=h+P\,\mathbf e\cdot\mathbf g.\]",
    ],
)
def test_the_value_of_an_integral_stays_its_value_among_other_terms(text):
    assert_same_claims(text)


@pytest.mark.parametrize(
    "text",
    [
        rf"Let $a_1,a_2,a_3$ be real and $a_i\neq a_j$ for {words}$i\ne j$. The equations are"
        r"\[\ddot q_i=a_iq_i-q_i^3,\qquad i=1,2,3.\] Then $\frac12\dot q_1^2-\frac12a_1q_1^2+\frac14q_1^4$ is an integral."
        for words in ("", "all ", "any two ")
    ],
)
def test_what_is_said_of_indices_stays_beside_its_formula(text):
    assert_same_claims(text)


@pytest.mark.parametrize(
    "text",
    [
        r"Let $k>0$. " + PLANE + r"Put $c=1+k$. " + words
        for words in (
            r"We see that $c>1$.",
            r"Therefore $c>1$, as we shall need.",
            r"It is clear that $c\ge 2$.",
        )
    ],
)
def test_what_words_say_to_be_found_is_doubted_as_before(text):
    assert_same_claims(text)


@pytest.mark.parametrize(
    "text",
    [
        EULER
        + r"\section{A case}\newtheorem{t}{T}\begin{t}If $A=B$, then $r$ is an integral.\end{t}"
        + rf"Let now $A=B$. {words}"
        for words in (
            r"From \eqref{e} we find $\dot p=(A-C)qr/A$.",
            r"Then \eqref{e} gives $\dot q=(C-A)rp/A$.",
            r"Hence $p^2+q^2$ is an integral.",
        )
    ],
)
def test_what_a_claim_is_drafted_on_leaves_no_other_case_open(text):
    assert_same_claims(text)
