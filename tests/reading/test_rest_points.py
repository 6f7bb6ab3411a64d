"""Points of rest and linear parts as papers print them: lists, names, marked letters, matrices."""

import pytest

from kowalevski_cas.audit.reading import ReadingSession
from kowalevski_cas.verify.outcome import Verdict
from tests.audit.test_doubted import audited
from tests.reading.test_reading import reading, verdicts
from tests.sample import sampled

GREEN = (Verdict.PROVED, Verdict.CONDITIONAL)
RIVALS = r"Consider the system \[ \dot x=x(c-x-ay),\qquad \dot y=y(k-bx-y) . \] "
SWING = r"The pendulum obeys \[ \ddot\psi=-n^2\sin\psi . \] "
FLOW = r"""The equations are
\[ \dot x=s(y-x),\quad \dot y=rx-y-xz,\quad \dot z=xy-kz . \] """

CYCLE = r"""Three species compete: \[ \dot x=x(1-x-ay-bz),\quad\dot y=y(1-bx-y-az),\quad
\dot z=z(1-ax-by-z) . \] """
LINE = r"The system is \[ \dot u=-mv,\qquad\dot v=mu , \] where $m=au+bv$. "

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
    (CYCLE + r"There is one interior equilibrium, namely \[ x=y=z=\frac{P}{Q} . \]", "1", "1+a+b"),
    (CYCLE + r"The only interior equilibrium is $x=y=z=\frac{P}{Q}$.", "1", "1+a+b"),
    (CYCLE + r"Имеется одно внутреннее положение равновесия, а именно $x=y=z=\frac{P}{Q}$.",
     "1", "1+a+b"),
    (LINE + r"There is a line of equilibria $((P)c,(Q)c)$.", "b", "-a"),
    (LINE + r"Every point $((P)c,(Q)c)$ is an equilibrium.", "b", "-a"),
    (LINE + r"The points $((P)c,(Q)c)$ with arbitrary $c$ are equilibria.", "b", "-a"),
    (LINE + r"It consists of the equilibria \[ u=(P)c,\qquad v=(Q)c , \] where $c$ is any constant.",
     "b", "-a"),
    (LINE + r"Она состоит из положений равновесия \[ u=(P)c,\qquad v=(Q)c , \] где $c$ --- "
     r"произвольная постоянная.", "b", "-a"),
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
    LINE + r"There is an equilibrium $(u_0,v_0)$.",
    LINE + r"There is an equilibrium $(2c,c)$, where $c$ is found from $c^3=a$.",
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


SYSTEM = r"The system is \[ \dot x=y,\qquad\dot y=x-x^3 .\] "


@pytest.mark.parametrize(
    "words",
    [
        r"The points $x=\pm VALUE$, $y=0$ are equilibria.",
        r"The equilibria are $x=\pm VALUE$, $y=0$ and $x=0$, $y=0$.",
        r"The points $y=0$, $x=\pm VALUE$ are at rest.",
        r"The states $x=\pm VALUE$, $y=0$ are stationary.",
        r"The points \[ x=\pm VALUE,\qquad y=0 \] are fixed points.",
        r"Точки $x=\pm VALUE$, $y=0$ неподвижны.",
        r"The equilibria are \[ C_\pm=(\pm VALUE,0) . \]",
        r"The equilibria are $C_{1,2}=(\pm VALUE,0)$.",
        r"The origin is an equilibrium. There are also $C_\pm=(\pm VALUE,0)$.",
        r"The origin is an equilibrium. If we look further there are two others \[ C_{\pm}=(\pm VALUE,0) . \]",
    ],
)
def test_upper_signs_go_together_and_lower_ones(words):
    found, wrong = (
        [v for tex, v in listed(SYSTEM + words.replace("VALUE", one)) if "pm" in tex]
        for one in "12"
    )
    assert len(found) == len(wrong) == 2
    assert all(one.green for one in found) and not any(one.green for one in wrong)


def listed(text):
    """The verdicts on what a text claims, with what it prints, in its order."""
    found = reading(text)
    outcomes = ReadingSession(found, timeout=20).outcomes
    judged = (*found.formulas, *found.statements)
    return [(f.item.printed.tex, outcomes[f.claim.id].verdict) for f in judged if f.claim]


@pytest.mark.parametrize(
    "words",
    [
        r"The particle at $x=2$ is at rest when it starts.",
        r"The points $x=\pm1$, $y=1$ are at rest.",
        r"The point $x=1$ is at rest.",
        r"The signs in $x=\pm1$, $y=0$ are fixed by the beginning.",
    ],
)
def test_what_is_not_at_rest_is_not_green(words):
    assert not any(one.green for _, one in listed(SYSTEM + words))


ORIGIN = [
    r"The origin is WORDan equilibrium.",
    r"The origin is WORDa fixed point.",
    r"Начало координат — положение равновесия.",
]


@pytest.mark.parametrize("words", ORIGIN)
def test_nothing_moves_at_the_origin(words):
    [(_, found)] = listed(SYSTEM + words.replace("WORD", ""))
    [(_, wrong)] = listed(SYSTEM.replace("x-x^3", "1-x^3") + words.replace("WORD", ""))
    assert found.green and wrong.value == "undecided"


@pytest.mark.parametrize("word", ["not ", "the only state that is ", "if $a=1$ ", "perhaps "])
def test_what_says_more_of_the_origin_is_not_judged(word):
    assert not listed(SYSTEM + ORIGIN[0].replace("WORD", word))


@pytest.mark.parametrize(
    "more", ["of the map $x'=x+1$", "of the other system", "of $\\dot x=x+1$", "for $a=0$"]
)
def test_the_origin_may_be_a_point_of_rest_of_something_else(more):
    found = listed(SYSTEM + ORIGIN[1].replace("WORD", "").replace(".", f" {more}."))
    assert not any(one.green for _, one in found)


@pytest.mark.parametrize(
    ("words", "left"),
    [
        (r"The only equilibrium is $x=0$, $y=0$.", True),
        (r"All equilibria are given by $x=0$, $y=0$.", True),
        (r"Единственное положение равновесия есть $x=0$, $y=0$.", True),
        (r"An equilibrium is $x=0$, $y=0$.", False),
    ],
)
def test_that_there_are_no_others_is_not_decided_or_listed(words, left):
    found = audited(rf"Consider \[\dot x=y,\qquad\dot y=-\sin x.\] {words}")
    claimed = [one for one in found.statements if not one.verdict.green]
    assert bool(found.uncovered or claimed) == left


@pytest.mark.parametrize(
    ("equations", "greens"),
    [
        ("$y=0$ and $x-x^3=0$", {True}),
        ("$y=0$ and $x(1-x^2)=0$", {True}),
        ("$y=0$ and $x-x^2=0$", {False}),  # where is x = -1?
        ("$y=0$ and $x-x^4=0$", {False}),
        ("$y=0$", {False}),
    ],
)
@pytest.mark.parametrize(
    "words", ["The equilibria are found from the equations ", "The equilibria are determined by "]
)
def test_equations_from_which_equilibria_are_found_leave_none_out(words, equations, greens):
    text = rf"Consider \[\dot x=y,\qquad\dot y=x-x^3.\] {words}{equations}."
    assert {one.green for one in verdicts(text).values()} == greens


STATE = r"""The model is \[ \dot S=kN-bSI-kS,\qquad \dot I=bSI-(c+k)I . \] The endemic state is
\[ S_*=\frac{c+k}b,\qquad I_*=\frac{kN}{c+k}-\frac kb . \] """


@pytest.mark.parametrize(
    "words", ["Small deviations $s=S-S_*$ from it obey", "Near it $s=S-S_*$ obeys"]
)
def test_what_small_deviations_obey_is_not_false_because_it_is_approximate(words):
    text = rf"{STATE}{words} \[ \ddot s+(k+bI_*)\dot s+b^2S_*I_*s=0 . \]"
    found = [verdict for tex, verdict in listed(text) if "ddot" in tex]
    assert Verdict.REFUTED not in found
