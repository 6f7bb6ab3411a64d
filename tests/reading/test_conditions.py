r"""Conditions on constants that words print, and that are supposed where they are cited."""

import pytest

from tests.reading.test_reading import verdicts

EULER = r"""The Euler--Poisson equations are
\[A\dot p=(B-C)qr+Pz_0g_2,\quad B\dot q=(C-A)pr+P(x_0g_3-z_0g_1),\quad C\dot r=(A-B)pq-Px_0g_2,\]
\[\dot g_1=rg_2-qg_3,\quad\dot g_2=pg_3-rg_1,\quad\dot g_3=qg_1-pg_2 .\] """
HESS = r"\begin{equation}A(B-C)x_0^2=C(A-B)z_0^2\label{h}\end{equation} "
FOUND = f"{EULER}Hess found the condition {HESS}under which there is a particular integral. "
SET = r"\[f\equiv Ax_0p+Cz_0r=0\] is invariant. "
RATE = r"\[\dot f=x_0(B-C)qr+z_0(A-B)pq=\frac{z_0(A-B)}{Ax_0}qf .\]"


@pytest.mark.parametrize(
    ("words", "green"),
    [
        (r"If \eqref{h} holds, the relation", True),
        (r"Under the condition \eqref{h} the relation", True),
        (r"The relation", False),
        (r"If \eqref{h} does not hold, the relation", False),
        (r"If we differentiate \eqref{h}, the relation", False),
        (r"When the condition \eqref{h} is violated, the relation", False),
    ],
)
def test_a_condition_holds_where_it_is_cited(words, green):
    assert any(one.green for one in verdicts(f"{FOUND}{words} {SET}").values()) is green
    wrong = verdicts(f"{FOUND}{words} {SET.replace('+C', '-C')}")
    assert not any(one.green for one in wrong.values())


@pytest.mark.slow
def test_it_reaches_from_a_theorem_to_its_proof():
    theorem = rf"\begin{{theorem}}If \eqref{{h}} holds, the relation {SET}\end{{theorem}}"
    proof = rf"\begin{{proof}}We have {RATE}\end{{proof}}"
    assert [one.green for one in verdicts(FOUND + theorem + proof).values()] == [True, True]
    alone = theorem.replace(r"If \eqref{h} holds, the", "The")
    assert [one.green for one in verdicts(FOUND + alone + proof).values()] == [False, False]


def test_who_cites_what_is_supposed_does_not_leave_it():
    text = rf"{EULER}Suppose that {HESS}. If \eqref{{h}} holds, the relation {SET}"
    assert [one.green for one in verdicts(text).values()] == [True]


def test_who_denies_it_leaves_it():
    text = rf"{EULER}Suppose that {HESS}. If \eqref{{h}} does not hold, the relation {SET}"
    assert not any(one.green for one in verdicts(text).values())


def test_a_rate_of_what_a_chain_names_is_no_other_law():
    text = rf"{EULER}Suppose that {HESS}. Then the relation {SET}We find \[\dot f=x_0(B-C)qr+z_0(A-B)pq .\]"
    assert [one.green for one in verdicts(text).values()] == [True, True]
    assert [one.green for one in verdicts(text.replace("+z_0", "-z_0")).values()] == [True, False]


SPHERE = r"""A particle moves by \[\ddot{\mathbf n}=\mathbf g-(\mathbf g\cdot\mathbf n)\mathbf n-\dot{\mathbf n}^2\,\mathbf n,\]
where $\mathbf n$ is WHAT. The energy $E=\frac12\dot{\mathbf n}^2-\mathbf g\cdot\mathbf n$ is conserved."""


def test_a_unit_vector_by_words_keeps_its_length():
    assert [one.green for one in verdicts(SPHERE.replace("WHAT", "a unit vector")).values()] == [
        True
    ]
    assert [one.green for one in verdicts(SPHERE.replace("WHAT", "a vector")).values()] == [False]
    wrong = SPHERE.replace("WHAT", "a unit vector").replace(r"-\mathbf g\cdot", r"+\mathbf g\cdot")
    assert [one.green for one in verdicts(wrong).values()] == [False]


def test_a_letter_before_a_vector_and_its_derivative_is_no_matrix():
    text = r"""The angle obeys \[B\theta''+F\sin\theta=0 .\] Then \[\tfrac12B\theta'^2-F\cos\theta\] is constant.
    In space the moment is $\mathbf M=B\,\mathbf t\times\mathbf t'$."""
    assert next(iter(verdicts(text).values())).green


def test_dots_of_which_words_speak_are_not_the_primes_of_the_law():
    text = r"""Consider the equation \[y''+\frac2x\,y'+y^5=0,\] where the prime stands for $d/dx$. Put $s=\ln x$, and let
    the dot be the derivative with respect to $s$. The variable \[V=-\frac{xy'}y\] satisfies \[\dot V=V(1-V) .\]"""
    assert not [*verdicts(text).values()]


TOP = r"""The Euler--Poisson equations are
\[A\dot p=(B-C)qr+Pz_0g_2,\quad B\dot q=(C-A)pr+P(x_0g_3-z_0g_1),\quad C\dot r=(A-B)pq-Px_0g_2,\]
\[\dot g_1=rg_2-qg_3,\quad\dot g_2=pg_3-rg_1,\quad\dot g_3=qg_1-pg_2 .\] Hess found the condition
\begin{equation}A(B-C)x_0^2=C(A-B)z_0^2\label{h}\end{equation} under which there is a particular integral.
\begin{theorem}If \eqref{h} holds, WHAT \[f\equiv Ax_0p+Cz_0r=0\] is invariant. \end{theorem}
\begin{proof}We have \[\dot f=\frac{z_0(A-B)}{Ax_0}qf .\]\end{proof}"""


def test_a_condition_of_a_theorem_holds_in_its_own_sentence():
    one = verdicts(TOP.replace("WHAT", "the relation"))
    two = verdicts(TOP.replace("WHAT", "there is an invariant set. In general the relation"))
    assert len(one) == len(two) == 2
    assert all(verdict.green for verdict in one.values())
    assert not any(verdict.green for verdict in two.values())
