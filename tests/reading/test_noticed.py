"""What a reading must not miss: misprints in formulas that words, and nothing else, call claims."""

import pytest

from kowalevski_cas.reading import ASSUMPTION, CLAIM, DEFINITION, LAW
from kowalevski_cas.verify.outcome import Verdict

from .test_reading import reading, roles, verdicts

CENTRAL = r"""
\section{Plane} The equations of motion are
\begin{equation}\label{law}
\ddot r=r\dot\varphi^2-\frac{k}{r^2},\qquad \ddot\varphi=-\frac{2\dot r\dot\varphi}{r}\qquad(r>0).
\end{equation}
"""


def test_a_condition_in_brackets_behind_a_law_is_an_assumption():
    found = roles(CENTRAL)
    assert [*found.values()] == [LAW, LAW, ASSUMPTION]


@pytest.mark.parametrize(("right", "verdict"), [("c", "green"), ("2c", "refuted")])
def test_what_a_rate_of_coordinates_defines_is_known_along_the_motion(right, verdict):
    text = (
        CENTRAL
        + rf"""Let $x=r\cos\varphi$, $y=r\sin\varphi$ and $c=x\dot y-y\dot x$. We find
    \[ r^2\dot\varphi={right} . \]"""
    )
    found = verdicts(text)[rf"r^2\dot\varphi={right}"]
    assert (found.green and verdict == "green") or found == verdict


@pytest.mark.parametrize(
    "words",
    [
        "remains an integral if $k$ is a given function of the time.",
        "is also an integral when $k$ depends on time.",
    ],
)
def test_what_is_said_of_a_law_that_is_not_printed_is_not_judged(words):
    found = reading(CENTRAL + rf"Put $F=r^2\dot\varphi$. The function $F$ {words}")
    last = [f for f in found.formulas if f.item.printed.tex.strip() == "F"][-1]
    assert last.role.name == CLAIM and last.claim is None


def test_the_same_words_without_a_condition_are_judged():
    found = verdicts(CENTRAL + r"Put $F=r^2\dot\varphi$. The function $F$ is an integral.")
    assert found["F"] in (Verdict.PROVED, Verdict.CONDITIONAL)


VOLTERRA = r"""
Four populations feed on each other,
\[ \dot u_1=u_1u_2,\quad \dot u_2=u_2(u_3-u_1),\quad \dot u_3=u_3(u_4-u_2),\quad \dot u_4=-u_4u_3 . \]
"""
WRONG = r"I=u_1u_3+u_2u_3+u_2u_4"


@pytest.mark.parametrize(
    "words",
    [
        rf"The sum $S=u_1+u_2+u_3+u_4$ is an integral, and there is one more: \[ {WRONG} . \]",
        rf"There has to be an integral besides the sum. It is of the second degree: \[ {WRONG} . \]",
        rf"One integral is the sum. A second one is known as well. It reads \[ {WRONG} . \]",
        rf"The motion separates with the constant \[ {WRONG} . \]",
        rf"Сумма есть интеграл. Имеется ещё один. Он имеет вид \[ {WRONG} . \]",
    ],
)
def test_an_integral_is_claimed_by_the_words_that_announce_it(words):
    assert verdicts(VOLTERRA + words)[WRONG] in (Verdict.REFUTED, Verdict.UNDECIDED)


@pytest.mark.parametrize(
    "words",
    [
        rf"The sum is an integral. It is easy to see what is measured by \[ {WRONG} . \]",
        rf"No function of the second degree is an integral. It reads \[ {WRONG} . \]",
        rf"The sum is an integral. We put \[ {WRONG} . \]",
        rf"With $c=1$, and with the constant \[ {WRONG} , \] we go on.",
    ],
)
def test_other_words_announce_no_integral(words):
    assert roles(VOLTERRA + words)[WRONG] == DEFINITION


def test_a_tensor_and_a_moment_may_both_be_bold_capitals():
    text = r"""The body turns by
    \[ \mathbf J\dot{\boldsymbol\omega}=\mathbf J\boldsymbol\omega\times\boldsymbol\omega,\qquad
    \mathbf J=\mathop{\rm diag}(A,B,C) . \]
    Let $\boldsymbol K=\mathbf J\boldsymbol\omega$. Then
    $\dot{\boldsymbol K}=\boldsymbol K\times\boldsymbol\omega$."""
    assert {f.role.name for f in reading(text).formulas} == {LAW, DEFINITION, CLAIM}


@pytest.mark.parametrize(("sign", "green"), [("+", True), ("-", False)])
def test_the_rates_of_a_potential_with_logarithms_are_known(sign, green):
    text = rf"""The motion in the plane is given by
    \[ \ddot x_i=-\frac{{\partial U}}{{\partial x_i}},\qquad U=k\ln(x_1^2+x_2^2) , \]
    $i=1,2$. Therefore \[ \ddot x_1{sign}\frac{{2kx_1}}{{x_1^2+x_2^2}}=0 . \]"""
    found = verdicts(text)[rf"\ddot x_1{sign}\frac{{2kx_1}}{{x_1^2+x_2^2}}=0"]
    assert found.green is green


def test_a_range_of_an_index_that_the_text_gives_holds_from_its_sentence_on():
    text = r"""The points with the coordinates $x_i$, $i=1,2$, move by
    \[ \dot x_i=v_i,\qquad \dot v_i=-kx_i . \] The functions $v_i^2+kx_i^2$ are integrals."""
    found = reading(text).formulas
    assert [f.role.name for f in found].count(LAW) == 4
    assert [f.role.name for f in found].count(CLAIM) == 2


def test_a_polynomial_is_a_function_where_nothing_is_derived_by_its_argument():
    text = r"""\[ \dot u=v,\qquad \dot v=u . \] Let \[ R(x)=x^2+h, \] where $R$ is a polynomial, and
    $h=v^2-u^2$. Then \[ \dot u^2=R(u) . \]"""
    assert verdicts(text)[r"\dot u^2=R(u)"] is Verdict.PROVED
