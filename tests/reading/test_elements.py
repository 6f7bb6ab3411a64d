r"""Matrices by letters for their elements: skew :math:`M=(m_{ij})`, and the equations of Euler."""

import pytest

from kowalevski_cas.reading import LAW
from tests.reading.test_reading import reading, verdicts
from tests.sample import sampled

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


FACTORS = r"""Let $K=(K_{ij})$ be a skew-symmetric $3\times3$ matrix. The equations of motion are
\[ \dot K=[K,W],\qquad W_{ij}=g_{ij}K_{ij},\qquad g_{ij}=\frac{b_i-b_j}{a_i-a_j} .\] """
"""Elements by those of a skew matrix with factors: what is below the diagonal follows."""

AGREES = [
    r"The function $F=K_{12}^2+K_{13}^2+K_{23}^2$ is an integral.",
    r"The function $G=g_{12}K_{12}^2+g_{13}K_{13}^2+g_{23}K_{23}^2$ is an integral.",
    r"In the components, \[ \dot K_{12}=(g_{13}-g_{23})K_{13}K_{23} .\]",
    r"Let $A=\mathrm{diag}(a_1,a_2,a_3)$, $B=\mathrm{diag}(b_1,b_2,b_3)$. Then \[[K,B]+[A,W]=0 .\]",
    r"""Let $A=\mathrm{diag}(a_1,a_2,a_3)$, $B=\mathrm{diag}(b_1,b_2,b_3)$. Put $L(\lambda)=K+\lambda A$,
    $N(\lambda)=W+\lambda B$. Then \[\dot L=[L,N] .\]""",
]
DISAGREES = [
    r"The function $F=K_{12}^2+K_{13}^2-K_{23}^2$ is an integral.",
    r"The function $G=g_{12}K_{12}^2-g_{13}K_{13}^2+g_{23}K_{23}^2$ is an integral.",
    r"The function $G=a_1K_{12}^2+a_2K_{13}^2+a_3K_{23}^2$ is an integral.",
    r"In the components, \[ \dot K_{12}=(g_{13}+g_{23})K_{13}K_{23} .\]",
    r"In the components, \[ \dot K_{12}=(a_1-a_2)K_{13}K_{23} .\]",
    r"Then \[ K_{31}=K_{13} .\]",
    r"Let $A=\mathrm{diag}(a_1,a_2,a_3)$, $B=\mathrm{diag}(b_1,b_2,b_3)$. Then \[[K,B]=[A,W] .\]",
    r"For $b_i=a_i^2$ one has $g_{12}=a_1-a_2$.",
    r"""Let $A=\mathrm{diag}(a_1,a_2,a_3)$, $B=\mathrm{diag}(b_1,b_2,b_3)$. Put $L(\lambda)=K+\lambda A$,
    $N(\lambda)=W-\lambda B$. Then \[\dot L=[L,N] .\]""",
    r"""Let $A=\mathrm{diag}(a_1,a_2,a_3)$. Put $L(\lambda)=K+\lambda A$. The eigenvalues of $L(2)$ are
    constant: \[\dot L=0 .\]""",
]


@pytest.mark.parametrize("claim", sampled(AGREES, 3))
def test_elements_with_factors(claim):
    found = [*verdicts(FACTORS + claim).values()]
    assert found
    assert all(one.green for one in found)


@pytest.mark.parametrize("claim", sampled(DISAGREES, 3))
def test_what_fails_for_elements_with_factors_is_not_green(claim):
    assert not any(one.green for one in verdicts(FACTORS + claim).values())


def test_what_is_said_for_special_constants_is_no_part_of_the_law():
    special = r"For $b_i=a_i^2$ it is the body. The function $F=(a_1+a_2)K_{12}^2+(a_1+a_3)K_{13}^2$ is an integral."
    assert not any(one.green for one in verdicts(FACTORS + special).values())


def test_rates_of_elements_before_the_matrix_equation_are_the_law():
    text = r"""The equations of motion are \[\dot x=ay,\qquad \dot y=-ax .\] With
    $L=\begin{pmatrix}x&y\\y&-x\end{pmatrix}$, $N=\frac a2\begin{pmatrix}0&1\\-1&0\end{pmatrix}$ they are
    \[\dot L=NL-LN .\]"""
    assert [one.green for one in verdicts(text).values()] == [True]
    assert [one.green for one in verdicts(text.replace("NL-LN", "LN-NL")).values()] == [False]


@pytest.mark.parametrize(
    ("claim", "green"),
    [
        (r"The function $F=K_{12}^2+K_{13}^2+K_{23}^2$ is an integral.", True),
        (r"The function $F=K_{12}^2+K_{13}^2+2K_{23}^2$ is an integral.", False),
        (r"Then \[\dot K_{12}=0 .\]", False),
        (r"Then \[\dot K_{12}=(a_1-a_2)K_{13}K_{23} .\]", True),
        (r"Then \[\dot K_{12}=(a_2-a_1)K_{13}K_{23} .\]", False),
    ],
)
def test_factors_may_be_said_behind_the_law(claim, green):
    law = FACTORS.partition(r",\qquad g_{ij}")[0] + r" .\] Here $g_{ij}=a_i+a_j$. "
    assert [one.green for one in verdicts(law + claim).values()] == [green]


@pytest.mark.parametrize("factor", ["a_i-2a_j", "a_i", "b_{ij}"])
def test_factors_that_are_not_symmetric_make_no_law(factor):
    law = FACTORS.partition(r",\qquad g_{ij}")[0] + rf",\qquad g_{{ij}}={factor} .\] "
    assert not reading(
        law + r"The function $F=K_{12}^2+K_{13}^2+K_{23}^2$ is an integral."
    ).parts.laws


@pytest.mark.parametrize(
    ("equation", "green"), [("NL-LN", True), ("LN-NL", False), ("2NL-2LN", False)]
)
def test_a_matrix_equation_before_the_equations_of_motion_is_claimed(equation, green):
    text = rf"""The equation of Lax is \[\dot L={equation},\qquad L=\begin{{pmatrix}}x&y\\y&-x\end{{pmatrix}},\qquad
    N=\frac a2\begin{{pmatrix}}0&1\\-1&0\end{{pmatrix}} .\]
    It is equivalent to the equations of motion \[\dot x=ay,\qquad \dot y=-ax .\]"""
    assert [one.green for one in verdicts(text).values()] == [green]
