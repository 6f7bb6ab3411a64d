"""What is supposed by citing it, imposed, or left for what was before: other systems and wordings."""

import pytest

from kowalevski_cas.audit.reading import ReadingSession
from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import reading, verdicts
from tests.sample import sampled

HOLDS = r"""Let $ab\ne0$. The motion is $$\dot x=ay,\quad \dot y=bx,\quad \dot z=z(x-y).$$
\section{A case} {IMPOSED} \begin{equation}\label{case} a+b=0. \end{equation}
Then the set \begin{equation}\label{set} z=0 \end{equation} is invariant.
\section{There} {SAID} \[ {CLAIM} \]"""
IMPOSED = [
    "We impose the condition", "We require that", "Requiring the motion to be bounded we take",
    "The constants are subject to the relation", "Потребуем, чтобы было", "Наложим условие",
]  # fmt: skip
SAID = [
    r"Suppose that \eqref{case} and \eqref{set} hold. The motion is a rotation then. Therefore",
    r"Let \eqref{case}, \eqref{set} be satisfied. We find that",
    r"Under the conditions \eqref{case} and \eqref{set} we have",
    r"Assume \eqref{case} and \eqref{set}. Nothing else is needed. Consequently",
    r"Пусть выполнены \eqref{case} и \eqref{set}. Движение простое. Поэтому",
]
TRUE = [r"a\dot x^2+b\dot y^2=a^3(y^2-x^2)+z", r"\dot x^2+\dot y^2=a^2(x^2+y^2)+z"]
FALSE = [r"\dot x^2+\dot y^2=a^2(x^2-y^2)+z", r"x\dot x+y\dot y=axy+z"]
TEXTS = [
    (HOLDS.replace("{IMPOSED}", one).replace("{SAID}", said).replace("{CLAIM}", claim), claim, true)
    for one in IMPOSED
    for said in SAID
    for claims, true in ((TRUE, True), (FALSE, False))
    for claim in claims
]


@pytest.mark.parametrize(("text", "claim", "true"), sampled(TEXTS, 5))
def test_what_is_cited_as_supposed_is_in_force_to_the_end_of_the_section(text, claim, true):
    found = verdicts(text)[claim]
    assert found.green == true and (found != Verdict.REFUTED or not true)


@pytest.mark.parametrize(
    "said",
    [
        r"The relation \eqref{case} has been studied before. Therefore",
        r"Suppose that \eqref{set} holds. Therefore",
        r"We do not suppose \eqref{case} and \eqref{set}. Still",
    ],
)
def test_what_is_only_cited_or_not_all_of_it_proves_nothing(said):
    text = HOLDS.replace("{IMPOSED}", IMPOSED[0]).replace("{SAID}", said)
    found = verdicts(text.replace("{CLAIM}", TRUE[1]))[TRUE[1]]
    assert not found.green


def test_what_is_supposed_in_another_section_is_not():
    text = HOLDS.replace("{IMPOSED}", IMPOSED[0]).replace(
        "{SAID}", rf"{SAID[0]} $x=x$. \section{{All}} Thus"
    )
    assert not verdicts(text.replace("{CLAIM}", TRUE[1]))[TRUE[1]].green


UNDER = r"""The motion is $$\dot x=y,\quad \dot y=-kx-cy.$$ Suppose that \begin{equation}\label{none} c=0.
\end{equation} Put $F=y^2+kx^2$. {SAID} $\dot F={RATE}$."""


@pytest.mark.parametrize(
    ("said", "rate", "green"),
    [
        (r"Under the condition \eqref{none} we see", "0", True),
        (r"Under condition \eqref{none}", "0", True),
        (r"При условии \eqref{none}", "0", True),
        (r"Under the condition \eqref{none}", "y", False),
        (r"При условии \eqref{none}", "x", False),
        (r"The condition", "0", False),
    ],
)
def test_behind_a_condition_that_is_cited_stands_what_holds_under_it(said, rate, green):
    found = verdicts(UNDER.replace("{SAID}", said).replace("{RATE}", rate))
    assert found.get(rf"\dot F={rate}", Verdict.UNDECIDED).green == green


def test_words_that_contain_another_one_deny_nothing():
    text = r"Движение есть $$\dot x=y,\quad \dot y=-x.$$ После несложных преобразований $\dot x^2=y^2$."
    assert [one.green for one in verdicts(text).values()] == [True]


TOP = r"""The body moves by \[ A\dot p=(B-C)qr,\qquad B\dot q=(C-A)rp,\qquad C\dot r=(A-B)pq . \]
It has the integrals \[ 2T=Ap^2+Bq^2+Cr^2,\qquad G^2=A^2p^2+B^2q^2+C^2r^2 . \] """
ON_LEVEL = [
    "On the level $G^2=2BT$ we have", "For $G^2=2BT$ we have", "On the separatrices, where $G^2=2BT$, we have",
    "If $G^2=2BT$, then", "On the level $G^2=2BT$ the motion is simple: on it",
    "On the surface $G^2=2BT$ the motion is simple. On this surface",
    "На уровне $G^2=2BT$ имеем", "При $G^2=2BT$ имеем",
]  # fmt: skip
ELSEWHERE = ["For $G^2=2BT$ the motion is simple. In all cases", "For $G^2=2AT$ we have"]


@pytest.mark.parametrize("words", sampled(ON_LEVEL, 4))
def test_that_two_integrals_are_tied_is_supposed_and_not_claimed(words):
    found = verdicts(rf"{TOP}{words} \[ A(A-B)p^2=C(B-C)r^2 .\]")
    assert "G^2=2BT" not in found and found["A(A-B)p^2=C(B-C)r^2"].green
    found = verdicts(rf"{TOP}{words} \[ A(A-B)p^2=C(B+C)r^2 .\]")
    assert not found["A(A-B)p^2=C(B+C)r^2"].green


@pytest.mark.parametrize("words", ELSEWHERE)
def test_elsewhere_they_are_not_tied(words):
    found = verdicts(rf"{TOP}{words} \[ A(A-B)p^2=C(B-C)r^2 .\]")
    assert not found["A(A-B)p^2=C(B-C)r^2"].green


BATH = r"The system is \[\dot x=p,\qquad \dot p=-x-zp,\qquad Q\dot z=p^2-1 .\] "


@pytest.mark.parametrize(
    ("words", "greens"),
    [
        (
            r"There is no equilibrium: $\dot x=0$ implies $p=0$, and then $\dot z=-1/Q\ne0$.",
            [True, True],
        ),
        (
            r"There is no equilibrium: $\dot x=0$ implies $p=1$, and then $\dot z=-1/Q\ne0$.",
            [False, True],
        ),
        (r"Here $p=0$ implies $\dot x=0$.", [True]),
        (r"Here $p=0$ implies $\dot p=0$.", [False]),
        (r"Here $p=0$ implies $\dot p=-x$. The function $p$ satisfies $\dot p=-x$.", [True, False]),
        (r"Here $p=0$ влечёт $\dot x=0$.", [True]),
    ],
)
def test_what_implies_something_is_supposed_there_alone(words, greens):
    found = reading(BATH + words)
    outcomes = ReadingSession(found, timeout=20).outcomes
    assert [outcomes[f.claim.id].verdict.green for f in found.formulas if f.claim] == greens


@pytest.mark.parametrize(
    "words",
    [
        "If we adjoin the equation $\\dot s=z$,",
        "Let us append the equation $\\dot s=z$; then",
        "Присоединим уравнение $\\dot s=z$; тогда",
    ],
)
@pytest.mark.parametrize(("sign", "green"), [("+", True), ("-", False)])
def test_an_equation_may_be_adjoined_among_words(words, sign, green):
    claim = rf" the function \[ W=\frac12(x^2+p^2+Qz^2){sign}s \] is an integral."
    *_, last = verdicts(BATH + words + claim).values()
    assert last.green is green


def test_what_is_put_for_complex_variables_with_real_letters_refutes_nothing():
    text = r"""Let \[ i\dot a=Vbc,\qquad i\dot b=Va\bar c,\qquad i\dot c=Va\bar b .\]
    Put $a=-ix$, $b=y$, $c=z$ with real $x,y,z$. Then $y^2-z^2$ is a first integral."""
    assert not any(one is Verdict.REFUTED for one in verdicts(text).values())


def test_what_is_supposed_in_a_part_before_all_headings_is_left_behind_them():
    top = r"Consider $\dot p=(b-c)qr$, $\dot q=(c-a)rp$, $\dot r=(a-b)pq$. In this section $a=b$. "
    both = top + r"Then $r$ is an integral. \section{Motions} The function $3r$ is an integral."
    found = verdicts(both)
    assert found["r"].green
    assert not found["3r"].green
    assert verdicts(both.replace("In this section", "Throughout"))["3r"].green


ENERGIES = [
    (r"From the integral of energy $$\frac m2(\dot x^2+\dot y^2)+mgy=\frac m2v_0^2$$ it follows that", "m"),
    (r"From the energy integral $$\frac12(\dot x^2+\dot y^2)+gy=\frac12v_0^2$$ we find", "1"),
    (r"Из интеграла энергии $$\frac m2(\dot x^2+\dot y^2)+mgy=\frac m2v_0^2$$ следует, что", "m"),
]  # fmt: skip


@pytest.mark.parametrize(("twice", "true"), [("2", True), ("3", False)])
@pytest.mark.parametrize(("words", "mass"), ENERGIES)
def test_what_is_deduced_from_an_integral_holds_with_its_value(words, mass, twice, true):
    """Where the mass stands in all terms of the integral it is supposed without it: it is not zero."""
    law = r"A ball moves by $$\ddot x=0,\qquad\ddot y=-g.$$ "
    found = verdicts(law + rf"{words} $${mass}(\dot x^2+\dot y^2)={mass}(v_0^2-{twice}gy).$$")
    assert [one.green for one in found.values()] == [True, true]


def test_what_is_not_deduced_from_an_integral_does_not_rest_on_it():
    law = r"A ball moves by $$\ddot x=0,\qquad\ddot y=-g.$$ "
    energy = r"The integral of energy is $$\frac12(\dot x^2+\dot y^2)+gy=\frac12v_0^2.$$ Moreover, $$\dot x^2+\dot y^2=v_0^2-2gy.$$"
    assert [one.green for one in verdicts(law + energy).values()] == [True, False]


ROTATING = r"""The equations of motion are
$$\ddot x-2\dot y=x-x(x^2+y^2)-\mu x,\qquad\ddot y+2\dot x=y-y(x^2+y^2)+\mu y.$$
Put $$C=x^2+y^2-\tfrac12(x^2+y^2)^2-\mu x^2+\mu y^2-\dot x^2-\dot y^2.$$
The equilibria are determined by the equations $$x-x(x^2+y^2)-\mu x=0,\qquad y-y(x^2+y^2)+\mu y=0.$$ """


@pytest.mark.parametrize(
    "words", ["At this point", "The value of the constant at this point is", "В этой точке"]
)
def test_at_an_equilibrium_that_words_speak_of_nothing_moves(words):
    found = ROTATING + rf"We find \[x=\sqrt{{1-\mu}},\qquad y=0.\] {words} "
    assert verdicts(found + r"$$C=\tfrac12(1-\mu)^2.$$")[r"C=\tfrac12(1-\mu)^2"].green
    assert not verdicts(found + r"$$C=\tfrac12(1+\mu)^2.$$")[r"C=\tfrac12(1+\mu)^2"].green


def test_at_one_of_several_points_it_may_be_otherwise():
    """With the root for y it would hold at one of both points."""
    found = ROTATING + r"We find $x=0$, $y=\pm\sqrt{1+\mu}$. At these points "
    tex = r"Cy=\tfrac12(1+\mu)^2\sqrt{1+\mu}"
    assert not verdicts(found + rf"$${tex}.$$")[tex].green
