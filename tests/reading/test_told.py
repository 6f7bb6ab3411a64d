"""What words say besides, in the sentence of what is judged, is told; another case is not compared."""

import pytest

from kowalevski_cas.audit.reading import ReadingSession, uncovered
from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import reading, verdicts

TWO = r"For $\ddot x=-x$, $\ddot y=-4y$ the function $\dot x^2+x^2$ is an integral"
PLANE = r"Let $\dot x=ay$, $\dot y=-bx$. Then $bx^2+ay^2$ is constant"


@pytest.mark.parametrize(
    "text",
    [
        PLANE + ", and $x^2+y^2$ is constant only if $a=-b$.",
        PLANE + ". A circular orbit occurs if $x=a$.",
        PLANE + ". The greatest velocity is reached at $x=a$.",
        PLANE + ". The acceleration vanishes if $x=1$.",
        PLANE + ". The force vanishes at $x=0$ and at $x=2$.",
        TWO + r", and $x\dot y-y\dot x$ vanishes identically.",
        TWO + r", and $x\dot y-y\dot x$ keeps its sign.",
        r"Let $\dot x=x-x^3$, $\dot y=-y$. It has the fixed points $(0,0)$, as one sees, and $(2,0)$.",
    ],
)
def test_what_is_said_besides_is_told(text):
    assert uncovered(reading(text))


@pytest.mark.parametrize(
    ("function", "green"), [("y^2", False), (r"\dot y^2+4y^2", True), (r"x\dot y-y\dot x", False)]
)
def test_a_further_integral_may_have_a_noun_before_it(function, green):
    for words in (", likewise the quantity", "; likewise the function"):
        assert verdicts(f"{TWO}{words} ${function}$.")[function].green == green


H = r"The Hamiltonian is $H=\frac12p^2+\frac12\omega^2q^2$. "


@pytest.mark.parametrize(
    "words",
    [
        r"With the units chosen so that $\omega=1$, the equations of motion are $\dot q=p$, $\dot p=-q$.",
        r"Backwards in time the equations of motion are $\dot q=-p$, $\dot p=\omega^2q$.",
        r"With the opposite sign convention Hamilton's equations are $\dot q=-p$, $\dot p=\omega^2q$.",
        r"Let $\omega=2$. The equations of motion are $\dot q=p$, $\dot p=-4q$.",
        r"If $q$ is measured downwards, the equations of motion are $\dot q=-p$, $\dot p=\omega^2q$.",
    ],
)
def test_equations_of_a_special_case_are_not_those_of_the_energy_before_them(words):
    found = ReadingSession(reading(H + words), timeout=5).outcomes.values()
    assert not any(one.verdict is Verdict.REFUTED for one in found)


def test_brackets_of_another_section_may_be_others():
    text = r"""\section{A} The bracket is \[ \{x,y\}=z,\quad\{y,z\}=x,\quad\{z,x\}=y. \]
    \section{B} The bracket is now \[ \{x,y\}=-z,\quad\{y,z\}=x,\quad\{z,x\}=y. \] """
    for function in ("x^2+y^2+z^2", "x^2+y^2-z^2"):
        found = reading(text + f"A Casimir function is ${function}$.")
        outcomes = ReadingSession(found, timeout=5).outcomes.values()
        assert not any(one.verdict.green or one.verdict is Verdict.REFUTED for one in outcomes)


def test_a_force_that_another_equation_gives_refutes_nothing():
    text = r"A block obeys $m\ddot x=P-F$ and $N-mg=0$, with $F=\mu N$. Then $m\ddot x=P-\mu mg$."
    assert verdicts(text)[r"m\ddot x=P-\mu mg"] is Verdict.UNDECIDED


@pytest.mark.parametrize("function", ["x+y", "x-y"])
def test_brackets_of_functions_make_no_others(function):
    text = r"""We have \[ \{x,y\}=1. \] Put $P=x$, $Q=§$. \section{B} Then $\{P,Q\}=1$. The functions
    $P$ and $Q$ are in involution.""".replace("§", function)
    found = reading(text)
    claims = [one.claim for one in found.statements if one.claim is not None]
    assert len(claims) == 1
