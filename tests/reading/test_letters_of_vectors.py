"""Vectors in plain letters, and capitals that act on vectors."""

import pytest

from tests.reading.test_reading import verdicts

TOP = r"""The equations of a heavy rigid body are
\[ \dot K=K\times w+P\nu\times s,\qquad\dot\nu=\nu\times w,\] where $K=Jw$ and $s$ is constant. """
BODY = r"""Euler's equations \[ A\dot w+w\times Aw=0 \] hold, where $w=(w_1,w_2,w_3)$. """
FIELD = r"""Consider \[ \dot a=n\times a,\] where $n=(0,0,k)$. """
BOLD = r"""The equations of a heavy rigid body are
\[ \dot{\mathbf K}=\mathbf K\times\mathbf w+\mathbf n\times\mathbf s,\qquad\dot{\mathbf n}=\mathbf n\times\mathbf w,\]
where $\mathbf K=J\mathbf w$ and $\mathbf s$ is constant. """

TURNED = r"""With \[ \{L_i,L_j\}=\varepsilon_{ijk}L_k,\quad\{L_i,\nu_j\}=\varepsilon_{ijk}\nu_k,\quad\{\nu_i,\nu_j\}=0 \]
the Hamiltonian is $H=\frac12(L_1^2+L_2^2+2L_3^2)-\nu_1$. """


@pytest.mark.parametrize(
    ("law", "function", "wrong"),
    [
        (TOP, r"(K,\nu)", r"(K,s)"),
        (TOP, r"\frac12(K,w)+P(\nu,s)", r"\frac12(K,w)-P(\nu,s)"),
        (BODY, r"(Aw,w)", r"(w,w)"),
        (BODY, r"|Aw|^2", r"|w|^2"),
        (FIELD, r"a_3", r"a_1"),
        (FIELD, r"|a|^2", r"a_1a_2"),
        # all components move, though the Hamiltonian has some of them only
        (TURNED, r"(L,\nu)", r"(L,L)"),
        (TURNED, r"(L_1^2-L_2^2+2\nu_1)^2+(2L_1L_2+2\nu_2)^2", r"(L_1^2-L_2^2-2\nu_1)^2+(2L_1L_2+2\nu_2)^2"),
        (BOLD, r"(\mathbf K,\mathbf n)", r"(\mathbf K,\mathbf s)"),
        (BOLD, r"\frac12(\mathbf K,\mathbf w)+(\mathbf n,\mathbf s)", r"(\mathbf w,\mathbf n)"),
    ],
)  # fmt: skip
def test_factors_of_crosses_are_vectors_and_what_acts_on_them_is_a_matrix(law, function, wrong):
    assert verdicts(law + f"The function ${function}$ is an integral.")[function].green
    assert not verdicts(law + f"The function ${wrong}$ is an integral.")[wrong].green


def test_components_in_brackets_belong_to_the_bold_letter():
    text = TURNED + r"The function $(\mathbf L,\boldsymbol\nu)$ is an integral."
    assert verdicts(text)[r"(\mathbf L,\boldsymbol\nu)"].green


@pytest.mark.parametrize(
    ("text", "claim"),
    [
        # signs of multiplication, sizes and products of sets make no vectors
        (r"The equation is \[\dot u=k\times u.\] The function $u^2$ is an integral.", "u^2"),
        (r"Let $B$ be an $m\times n$ matrix and \[\dot m=n,\quad\dot n=-m.\] "
         r"The function $m\cdot n$ is an integral.", r"m\cdot n"),
        (r"On the torus $T=S\times S$ \[\dot x=y,\quad\dot y=-x.\] The function $x\cdot y$ is an integral.",
         r"x\cdot y"),
    ],
)  # fmt: skip
def test_other_crosses_make_no_vectors(text, claim):
    assert not any(verdict.green for verdict in verdicts(text).values())


@pytest.mark.parametrize(
    "text",
    [
        r"\[ \dot{\mathbf L}=\mathbf L\times\mathbf u,\] $\mathbf u=(aL_1,bL_2,cL_3)$. Then $\langle L,L\rangle=1$ and ",
        r"Let $L\in\mathbb R^3$, \[ \dot{\mathbf L}=\mathbf L\times\mathbf u,\] $\mathbf u=(aL_1,bL_2,cL_3)$. Then ",
        r"\[ \dot{\mathbf L}=\mathbf L\times\mathbf u,\quad\dot{\vec L}=\vec L\times\vec u \] Then ",
        r"Let $\mathbf L=(x,y,z)$, $\mathbf u=(x,y,w)$ and \[ \dot{\mathbf L}=\mathbf L\times\mathbf u. \] Then ",
    ],
)  # fmt: skip
def test_no_two_vectors_share_components(text):
    assert verdicts(text + r"the function $|\mathbf L|^2$ is an integral.")[r"|\mathbf L|^2"].green
