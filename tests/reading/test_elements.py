r"""Matrices by letters for their elements: skew :math:`M=(m_{ij})`, and the equations of Euler."""

import pytest

from kowalevski_cas.reading import LAW
from tests.reading.test_reading import reading, verdicts

BODY = r"""Let $L=(l_{ij})$ and $W=(w_{ij})$ be skew-symmetric matrices of order three, with
\[ l_{ij}=(A_i+A_j)w_{ij} .\] The equations of motion are \[ \dot L=[L,W] .\] """


@pytest.mark.parametrize(
    ("claim", "green"),
    [
        (r"The function $F=l_{12}^2+l_{13}^2+l_{23}^2$ is an integral.", True),
        (r"The function $F=l_{12}^2+l_{13}^2-l_{23}^2$ is an integral.", False),
        (r"The function $T=l_{12}w_{12}+l_{13}w_{13}+l_{23}w_{23}$ is an integral.", True),
        (r"The function $T=l_{12}w_{12}+l_{13}w_{13}-l_{23}w_{23}$ is an integral.", False),
        (r"Let $A=\mathrm{diag}(A_1,A_2,A_3)$. Then \[L=AW+WA .\]", True),
        (r"Let $A=\mathrm{diag}(A_1,A_2,A_3)$. Then \[L=AW-WA .\]", False),
        (r"Then \[\operatorname{tr}L^2=-2(l_{12}^2+l_{13}^2+l_{23}^2) .\]", True),
        (r"Then \[\operatorname{tr}L^2=2(l_{12}^2+l_{13}^2+l_{23}^2) .\]", False),
    ],
)
def test_the_free_body_in_matrices(claim, green):
    assert [one.green for one in verdicts(BODY + claim).values()] == [green]


@pytest.mark.parametrize("order", [r"of order four", r"$4\times4$", r"of $so(4)$"])
def test_of_which_order_they_are_words_say(order):
    text = BODY.replace(
        "skew-symmetric matrices of order three", f"skew-symmetric matrices {order}"
    )
    found = reading(text)
    assert len(found.parts.laws[0].variables) == 6
    assert any(one.role.name == LAW for one in found.formulas)


def test_where_nothing_says_of_which_order_a_matrix_is_nothing_moves():
    text = BODY.replace(" of order three", "")
    assert not reading(text).parts.laws


def test_the_elements_of_a_matrix_without_symmetry_are_all_its_own():
    text = r"""Let $P=(p_{ij})$ be a matrix of order two. The equations of motion are \[\dot P=[S,P],\qquad
    S=\begin{pmatrix}0&s\\-s&0\end{pmatrix} .\] The function $F=p_{11}+p_{22}$ is an integral.
    The function $G=p_{12}+p_{21}$ is an integral. The function $D=p_{12}-p_{21}$ is an integral."""
    assert [one.green for one in verdicts(text).values()] == [True, False, True]
