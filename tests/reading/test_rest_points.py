"""Points of rest and linear parts as papers print them: lists, names, marked letters, matrices."""

import pytest

from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import verdicts
from tests.sample import sampled

GREEN = (Verdict.PROVED, Verdict.CONDITIONAL)
RIVALS = r"Consider the system \[ \dot x=x(c-x-ay),\qquad \dot y=y(k-bx-y) . \] "
SWING = r"The pendulum obeys \[ \ddot\psi=-n^2\sin\psi . \] "
FLOW = r"""The equations are
\[ \dot x=s(y-x),\quad \dot y=rx-y-xz,\quad \dot z=xy-kz . \] """

POINTS = [
    (RIVALS + r"The equilibrium is \[ x^*=P,\qquad y^*=Q . \]",
     r"\frac{c-ak}{1-ab}", r"\frac{k-bc}{1-ab}"),
    (RIVALS + r"The interior equilibrium $(x_0,y_0)$ has \[ x_0=P,\qquad y_0=Q . \]",
     r"\frac{c-ak}{1-ab}", r"\frac{k-bc}{1-ab}"),
    (RIVALS + r"The steady state is given by \[ \bar x=P,\quad\bar y=Q . \]",
     r"\frac{c-ak}{1-ab}", r"\frac{k-bc}{1-ab}"),
    (RIVALS + r"There is an equilibrium at $A=\left(P,Q\right)$.",
     r"\frac{c-ak}{1-ab}", r"\frac{k-bc}{1-ab}"),
    (RIVALS + r"The points $(0,0)$ and $(P,Q)$ are equilibria.", "c", "0"),
    (RIVALS + r"The rest points are \[ E_0=(0,0),\quad E_1=(P,Q) . \]", "0", "k"),
    (RIVALS + r"Точка $(P,Q)$ является положением равновесия.", "c", "0"),
    (FLOW + r"If $r>1$, the point $(P,\sqrt{k(r-1)},Q)$ is an equilibrium.",
     r"\sqrt{k(r-1)}", "r-1"),
]  # fmt: skip
EIGENVALUES = [
    RIVALS + r"At the fixed point $E_1=(c,0)$ the eigenvalues are $P$ and $Q$.",
    RIVALS + r"The Jacobian at $(c,0)$ has the eigenvalues $P$ and $Q$.",
    RIVALS + r"The eigenvalues of the Jacobian matrix at the point $(c,0)$ are $P$ and $Q$.",
    RIVALS + r"At $(c,0)$ the eigenvalues of the linear part are \[ \mu_1=P,\qquad\mu_2=Q . \]",
    RIVALS + r"The characteristic equation at $(c,0)$ is \[ (\mu-(P))(\mu-(Q))=0 . \]",
]
MATRICES = [
    (RIVALS + r"The Jacobian matrix is \[ J=\begin{pmatrix}P&-ax\\-by&Q\end{pmatrix} . \]",
     "c-2x-ay", "k-bx-2y"),
    (RIVALS + r"The Jacobian at $(c,0)$ is \[ J=\begin{pmatrix}P&-ac\\0&Q\end{pmatrix} . \]",
     "-c", "k-bc"),
    (SWING + r"The linear part at $\psi=0$ is \[ \begin{pmatrix}0&P\\Q&0\end{pmatrix} . \]",
     "1", "-n^2"),
    (FLOW + r"""The matrix of the linear part at the origin is
     \[ \begin{pmatrix}-s&s&0\\P&-1&0\\0&0&Q\end{pmatrix} . \]""", "r", "-k"),
]  # fmt: skip
TRUE = [*POINTS, *MATRICES, *((text, "-c", "k-bc") for text in EIGENVALUES)]
FALSE = [
    (text, one, other)
    for text, p, q in TRUE
    for one, other in ((f"{p}+1", q), (p, f"2({q})+1"), (q, f"{p}+3"))
]
OTHERS = [
    RIVALS + r"Let $A=\begin{pmatrix}2&0\\0&3\end{pmatrix}$. Its eigenvalues are $2$ and $3$.",
    RIVALS + r"There is no equilibrium at $(c,k)$.",
    RIVALS + r"The fixed point of the map is $(2,3)$.",
    RIVALS + r"After the shift the equilibrium $(x_0,y_0)$ becomes $(0,0)$.",
    RIVALS + r"The Jacobian of the change at $(c,0)$ is $\begin{pmatrix}1&0\\0&2\end{pmatrix}$.",
    RIVALS + r"The eigenvalues at $(c,0)$ of the matrix of rivalry are $5$ and $6$.",
    r"The system is \[ \dot y=-x,\quad\dot x=y-1 . \] Its equilibrium is $(0,1)$.",
    r"The system is \[ \dot\beta=1-\alpha,\quad\dot\alpha=\beta . \] Its equilibrium is $(0,1)$.",
    r"The system is \[ \dot\eta=1-\xi,\quad\dot\xi=\eta . \] Its equilibrium is $(0,1)$.",
]


def written(text, one, other):
    return text.replace("P", one).replace("Q", other)


@pytest.mark.parametrize("text, one, other", sampled(TRUE, 9))
def test_what_is_said_of_points_of_rest_is_proved(text, one, other):
    found = [*verdicts(written(text, one, other)).values()]
    assert found and {*found} <= {*GREEN}


@pytest.mark.parametrize("text, one, other", sampled(FALSE, 12))
def test_no_other_values_are(text, one, other):
    assert not {*GREEN} >= {*verdicts(written(text, one, other)).values()}


@pytest.mark.parametrize("text", OTHERS)
def test_of_other_things_nothing_is_claimed(text):
    assert not {Verdict.REFUTED, Verdict.UNDECIDED} & {*verdicts(text).values()}


def test_a_point_after_a_point_of_rest_has_eigenvalues_of_its_own():
    text = RIVALS + r"The point $(c,0)$ is an equilibrium. Let $A=2$. Its eigenvalues are $7$."
    assert [*verdicts(text).values()] == [Verdict.PROVED]
