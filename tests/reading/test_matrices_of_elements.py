"""Matrices that are given by their elements, and their commutators."""

import pytest

from kowalevski_cas.reading import CLAIM, LAW, UNREAD
from tests.reading.test_reading import reading, roles, verdicts

TURN = r"""The motion is \[\dot x=y,\qquad \dot y=-x.\] Let $S$ be the matrix with the elements
$S_{11}=x$, $S_{22}=-x$, $S_{12}=y$, $S_{21}=y$, and \[ R=\begin{pmatrix}0&\frac12\\-\frac12&0\end{pmatrix} . \] """


@pytest.mark.parametrize(
    ("claim", "green"),
    [
        (r"\dot S=[R,S]", True),
        (r"\dot S=[S,R]", False),
        (r"\dot S=[R,S+R]", True),
        (r"\dot S=[R,2S]", False),
    ],
)
def test_the_matrix_of_elements_stands_in_a_commutator(claim, green):
    found = verdicts(TURN + rf"Then \[{claim} .\]")
    assert [one.green for one in found.values()] == [green]


def test_the_trace_of_what_is_no_matrix_has_no_meaning():
    """What is made of letters that are no matrices where they stand is open, and breaks nothing."""
    text = TURN + r"Put $W^\pm=S\pm cR$ and $N=W^+W^-$. Then \[\operatorname{tr}N=2x^2 .\]"
    assert not any(one.green for one in verdicts(text).values())


def test_a_letter_with_numbers_is_no_matrix_where_an_element_is_missing():
    text = TURN.replace(", $S_{21}=y$", "") + r"Then \[\dot S=[R,S] .\]"
    assert not any(one.green for one in verdicts(text).values())


def test_a_list_in_brackets_is_no_commutator():
    text = (
        r"The motion is \[\dot x=y,\qquad \dot y=-x.\] The time lies in $[A,B]$, where $A_{11}=1$."
    )
    found = {f.item.typed.tex: f.role.name for f in reading(text).formulas}
    assert found["[A,B]"] in (UNREAD, "other") and CLAIM not in found.values()


def test_another_value_of_a_variable_is_no_change_of_variables():
    text = r"The motion is \[\dot u=v,\qquad \dot v=-u.\] If it starts with $u=V$, it comes to $u=\frac{1-b}{1+b}V$."
    found = reading(text)
    assert len(found.parts.laws) == 1
    assert [*roles(text).values()].count(LAW) == 2


@pytest.mark.parametrize(
    ("claim", "green"),
    [
        (r"\operatorname{tr}G^2=2v^2+2ku^2", True),
        (r"\operatorname{tr}G^2=2v^2-2ku^2", False),
        (r"\frac{d}{dt}\operatorname{tr}G^2=-4cv^2", True),
        (r"\frac{d}{dt}\operatorname{tr}G^2=0", False),
    ],
)
def test_matrices_of_elements_go_on_where_a_force_is_added(claim, green):
    text = r"""\section{Free} The motion is \[\dot u=v,\qquad \dot v=-ku .\] Let $G$ be the matrix with the
    elements $G_{11}=v$, $G_{22}=-v$, $G_{12}=u$, $G_{21}=ku$. Then \[\operatorname{tr}G=v-v .\]
    \section{Damped} Consider now another system with a damping force,
    \[\dot u=v,\qquad \dot v=-ku-cv .\] With the same matrix """
    found = [*verdicts(text + rf"\[{claim} .\]").values()]
    assert [one.green for one in found] == [True, green]


THREE = (
    r"Consider \[\dot x_j=p_j,\qquad\dot p_j=-x_j,\quad j=1,2,3.\] Define the $3\times3$ matrix "
)
TRACE = r"\operatorname{Tr}L=p_1+p_2+p_3"


@pytest.mark.parametrize(
    "element",
    [
        r"p_j\,\delta_{jk}+(1-\delta_{jk})\frac{g}{x_j-x_k}",
        r"p_j\,\delta_{jk}-g\left(1-\delta_{jk}\right)\frac{1}{x_j-x_k}",
    ],
)
def test_a_term_off_the_diagonal_needs_no_value_on_it(element):
    for begins, ends in ((r"\[", r"\]"), (r"\begin{align}", r"\end{align}")):
        matrix = rf"{begins}L_{{jk}}&={element}.{ends}".replace(
            "&", "&" if "align" in begins else ""
        )
        assert verdicts(rf"{THREE}{matrix} Then ${TRACE}$.")[TRACE].green
        wrong = TRACE.replace("+p_3", "-p_3")
        assert not verdicts(rf"{THREE}{matrix} Then ${wrong}$.")[wrong].green


@pytest.mark.parametrize(
    "element",
    [
        r"\frac{g}{x_j-x_k}",
        r"\cos(1-\delta_{jk})",
        r"\cos^2(1-\delta_{jk})",
        r"x_j/(1-\delta_{jk})",
        r"(1-\delta_{jk})^{-1}x_j",
        r"(2-\delta_{jk})x_k",
        r"(1+\delta_{jk})x_jx_k",
        r"(1-\delta_{j1})\frac1{x_j-x_k}",
    ],
)
def test_other_terms_have_their_value(element):
    matrix = rf"\[L_{{jk}}=p_j\,\delta_{{jk}}+{element}.\]"
    assert not verdicts(rf"{THREE}{matrix} Then ${TRACE}$.")[TRACE].green
