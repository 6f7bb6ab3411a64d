"""Rates of another case: what stands behind them is never proved of the law before."""

from itertools import product

import pytest

from tests.reading.test_reading import reading, verdicts
from tests.sample import sampled

LAW = r"""\section{Motion} The equations of motion are
\[\dot u=v,\qquad \dot v=-u-cu^3 .\] Put $K=\frac12v^2+\frac12u^2+\frac c4u^4$. """
BEFORE = (
    "\n\n\\emph{The damped case.} Now $ROW$. ",
    "\n\n\\textbf{Friction.} $ROW$. ",
    "Here the equation becomes $ROW$. ",
    "With friction, $ROW$. ",
    "If damping is added, then $ROW$. ",
    "Let a resistance act besides. Then one gets $ROW$. ",
    "When the medium is viscous we have $\\dot u=v$, $ROW$. ",
    "In the presence of a drag \\[ROW .\\] ",
    "\n\n\\emph{Случай трения.} Теперь $ROW$. ",
    "При наличии сопротивления уравнение принимает вид $ROW$. ",
    "Если добавить трение, то $ROW$. ",
    "Suppose that the spring is a harder one. Then $ROW$. ",
    "Consider a softer spring: $ROW$. ",
    "The oscillator of Duffing obeys $\\dot u=v$, $ROW$. ",
    "A body in a liquid is governed by \\[ROW .\\] ",
    "Рассмотрим другую пружину. Тогда $ROW$. ",
)
ROWS = (
    r"\dot v=-u-cu^3-kv",
    r"\dot v+u+cu^3=-v",
    r"\ddot u=-u-cu^3-k\dot u",
    r"\frac{dv}{dt}=-u-cu^3-v^3",
)
CLAIMS = (
    r"Then $\dot K=0$.",
    r"The function $K$ is conserved.",
    "\n\n\\emph{Energy.} Then \\[ \\frac{dK}{dt}=0 .\\]",
    r"Функция $K$ сохраняется.",
    r"We have $\frac{d}{dt}(v^2+u^2+\frac c2u^4)=0$.",
)


@pytest.mark.parametrize(("words", "row", "claim"), sampled(product(BEFORE, ROWS, CLAIMS), 16))
def test_nothing_is_proved_of_the_old_law_where_words_set_up_another_case(words, row, claim):
    found = verdicts(LAW + words.replace("ROW", row) + claim)
    assert not any(one.green for tex, one in found.items() if tex != r"\dot u=v")
    assert not any(one.value == "refuted" for one in found.values())


@pytest.mark.parametrize(
    "text",
    [
        r"We have $\dot K=0$ in the damped case, where $\dot v=-u-cu^3-kv$.",
        r"With dry friction $\dot v=-u-\operatorname{\nabla}v$, and $\dot K=0$.",
    ],
)
def test_nor_beside_them_nor_where_they_cannot_be_read(text):
    assert not any(one.green for one in verdicts(LAW + text).values())


@pytest.mark.parametrize(
    "words",
    [
        r"Now $\dot v=-u(1+cu^2)$. ",
        r"Here the equation becomes $\ddot u=-u-cu^3$. ",
        r"If $c=0$, then $\dot v=-u$. ",
        r"Now\footnote{With friction $\dot v=-u-cu^3-kv$.} we turn to the energy. ",
        "",
    ],
)
def test_what_follows_from_the_law_changes_nothing(words):
    found = verdicts(LAW + words + r"Then $\dot K=0$.")
    assert found[r"\dot K=0"].green


@pytest.mark.parametrize(
    "row",
    [
        r"\dot{\mathbf{w}}=\mathbf{a}\times\mathbf{w}-k\mathbf{w}",
        r"\dot{\mathbf{w}}=2\mathbf{a}\times\mathbf{w}",
    ],
)
def test_nor_of_the_old_law_of_a_vector(row):
    law = r"The equation of motion is \[\dot{\mathbf{w}}=\mathbf{a}\times\mathbf{w}\] with a constant vector $\mathbf{a}$. "
    claim = r"Then $\frac{d}{dt}(\mathbf{w}\cdot\mathbf{w})=0$."
    assert [*verdicts(law + claim).values()][-1].green
    assert not any(one.green for one in verdicts(law + rf"With a drag, ${row}$. {claim}").values())


def test_another_section_is_of_the_law_again():
    text = r"With friction $\dot v=-u-cu^3-kv$. \section{Energy} We have $\dot K=0$."
    assert verdicts(LAW + text)[r"\dot K=0"].green


def test_the_reader_is_told_why():
    found = reading(LAW + r"With friction $\dot v=-u-v$. Then $\dot K=0$.").formulas[-1]
    assert r"\dot v=-u-v" in found.message and "another law" in found.message


EULER = r"""The equations of motion are \[J\dot{\mathbf u}+\mathbf u\times J\mathbf u=0\] with $J=\operatorname{diag}(A,B,C)$. """
ROWS = r"\[A\dot u_1=(B-C)u_2u_3,\qquad B\dot u_2=(C+A)u_3u_1,\qquad C\dot u_3=(A-B)u_1u_2 .\] "
BEHIND = r"Hence $Au_1^2+Bu_2^2+Cu_3^2$ is an integral."


@pytest.mark.parametrize(
    "words",
    [
        "If we write this in components, we get",
        "Now the equations are, in components,",
        "For the components this gives",
        "When written out, they read",
        "Here the explicit equations are",
        "Теперь в проекциях имеем",
    ],
)
def test_what_fails_where_the_law_is_printed_in_components_is_a_misprint(words):
    found = verdicts(EULER + words + ROWS + BEHIND)
    assert [one.green for one in found.values()] == [True, False, True, True]
    wrong = BEHIND.replace("Au_1^2", "2Au_1^2")
    assert not [*verdicts(EULER + words + ROWS + wrong).values()][-1].green


@pytest.mark.parametrize(
    "words",
    [
        "With friction the equations are, in components,",
        "In the new model, in full,",
        "If a torque acts, that is,",
        "If the body is not free, i.e.,",
    ],
)
def test_another_law_in_components_is_no_misprint(words):
    found = verdicts(EULER + words + ROWS + BEHIND)
    assert not any(one.green for tex, one in found.items() if "u_1^2" in tex)


SPIN = r"""The equations are \[\dot u=avw,\qquad \dot v=bwu,\qquad \dot w=cuv .\]
For every $k$ the point $u=v=0$, $w=k$ is an equilibrium: the body turns about its third axis.
With $u$, $v$ small, the linear equations are
\begin{align} &\dot u=akv,\\ &\dot v=SIGNbku .\end{align}"""


@pytest.mark.parametrize("sign", ["", "-"])
def test_rows_of_one_linear_system_are_not_said_of_one_another(sign):
    found = verdicts(SPIN.replace("SIGN", sign))
    assert [one.green for tex, one in found.items() if "k" in tex][-2:] == [True, not sign]
