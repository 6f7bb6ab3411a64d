"""Letters that are named as all the roots of a polynomial: Vieta's relations, and their rates."""

import pytest

from kowalevski_cas.reading.known import OTHER
from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import roles, verdicts
from tests.sample import sampled

WAVE = r"""Waves obey $$f''=cf-3f^2+a,$$ so that
\begin{equation}\label{c}(f')^2=-2f^3+cf^2+2af+2b.\end{equation} """
SUM, PRODUCT = r"f_1+f_2+f_3=\frac c2", "f_1f_2f_3=b"


WORDS = [
    r"Let $f_1<f_2<f_3$ be the roots of the right-hand side of \eqref{c}. Then",
    r"Denote by $f_1$, $f_2$ and $f_3$ the zeros of $-2f^3+cf^2+2af+2b$. Then",
    r"The cubic on the right has the roots $f_1,f_2,f_3$. Hence",
    r"With the roots $f_1$, $f_2$, $f_3$ of the cubic $2f^3-cf^2-2af-2b$ we find",
    r"The roots of $2f^3-cf^2-2af-2b$ are denoted by $f_1,f_2,f_3$. Then",
    r"We write $$(f')^2=-2(f-f_1)(f-f_2)(f-f_3).$$ Comparing coefficients, we get",
    r"Пусть $f_1,f_2,f_3$ — корни многочлена $2f^3-cf^2-2af-2b$. Тогда",
    r"Обозначим через $f_1,f_2,f_3$ корни многочлена $2f^3-cf^2-2af-2b$. Тогда",
]


@pytest.mark.parametrize("words", sampled(WORDS, 2))
def test_roots_that_words_or_factors_name_have_the_relations_of_vieta(words):
    found = verdicts(rf"{WAVE} {words} $${SUM},\qquad {PRODUCT}.$$")
    assert found[SUM] is found[PRODUCT] is Verdict.PROVED


@pytest.mark.parametrize("words", [WORDS[0], pytest.param(WORDS[5], marks=pytest.mark.slow)])
def test_other_relations_are_false(words):
    found = verdicts(rf"{WAVE} {words} $$f_1+f_2+f_3=c,\qquad f_1f_2f_3=-b.$$")
    assert [one.green for one in found.values()][-2:] == [False, False]


ROOTS = WAVE + r"Let $f_1<f_2<f_3$ be the roots of the right-hand side of \eqref{c}. "


@pytest.mark.parametrize(
    ("claim", "green"),
    sampled(
        [
            (r"(f')^2=-2(f-f_1)(f-f_2)(f-f_3)", True),
            (r"(f')^2=2(f_1-f)(f-f_2)(f-f_3)", True),
            (r"(f')^2=2(f-f_1)(f-f_2)(f-f_3)", False),
            (r"(f')^2=-2(f-f_1)(f-f_2)(f+f_3)", False),
            (r"f_1^2+f_2^2+f_3^2=\frac{c^2}4+2a", True),
            (r"f_1^2+f_2^2+f_3^2=\frac{c^2}4-2a", False),
            (r"f_3-f_1>0", True),
            (r"f_1-f_2>0", False),
        ],
        3,
    ),
)
def test_what_follows_from_the_relations_of_vieta(claim, green):
    assert verdicts(rf"{ROOTS} Then $${claim}.$$")[claim].green is green


def test_a_double_root():
    text = ROOTS.replace("f_1<f_2<f_3", "f_1,f_2,f_3")
    true, false = r"2f_1+f_3=\frac c2", "f_1f_3=b"
    found = verdicts(rf"{text} If $f_1=f_2$, then $${true},\qquad {false}.$$")
    assert found[true].green
    assert not found[false].green


def test_the_equation_is_that_of_the_general_case():
    case = r"\section{Case} Let $a=b=0$. Then $$(f')^2=f^2(c-2f).$$ \section{Waves} In general"
    found = verdicts(rf"{WAVE} {case} $$(f')^2=-2(f-f_1)(f-f_2)(f-f_3).$$ So ${PRODUCT}$.")
    assert found[PRODUCT].green


def test_the_letters_of_other_roots_are_named_anew():
    again = r"\section{Rest} Let $f_1,f_2$ be the roots of $3f^2-cf-a$. They have"
    found = verdicts(rf"{ROOTS} {again} $$f_1+f_2=\frac c3,\qquad f_1f_2=\frac a3.$$")
    assert [one.green for one in found.values()][-2:] == [True, False]


@pytest.mark.parametrize(
    ("roots", "of"),
    [("z_1,z_2,z_3", "z^2-h^2"), ("z_1,z_2", "z^3-h^2"), ("z_1,z_2", r"\sin z+z^2")],
)
def test_of_another_number_of_roots_nothing_is_known(roots, of):
    law = r"The oscillator is $$\ddot x=-x,$$ with the energy $$h=\frac12\dot x^2+\frac12x^2.$$"
    sum = "+".join(roots.split(",")) + "=0"
    assert not verdicts(rf"{law} Let ${roots}$ be the roots of ${of}$. Then $${sum}.$$")[sum].green


def test_roots_that_are_not_real_prove_nothing():
    law = r"The oscillator is $$\ddot x=-x,$$ with the energy $$h=\frac12\dot x^2+\frac12x^2.$$"
    text = rf"{law} Let $z_1<z_2$ be the roots of $z^2+h^2+1$. Then $$z_1+z_2=5,\quad z_1z_2=-7.$$"
    assert [one.green for one in verdicts(text).values()][-2:] == [False, False]


def test_roots_of_a_polynomial_with_integrals():
    top = r"""The spherical pendulum has the Lagrangian
    $$L=\frac12(\dot\theta^2+\dot\varphi^2\sin^2\theta)-\cos\theta.$$ The integrals are
    $$j=\dot\varphi\sin^2\theta,\qquad
    h=\frac12(\dot\theta^2+\dot\varphi^2\sin^2\theta)+\cos\theta.$$
    Let $u_1<u_2<u_3$ be the roots of $2(h-u)(1-u^2)-j^2$."""
    true, false = "u_1u_2+u_2u_3+u_3u_1=-1", "u_1u_2u_3=h"
    found = verdicts(rf"{top} Then $${true},\qquad {false}.$$")
    assert found[true].green
    assert not found[false].green


PLANE = r"""The particle has the Hamiltonian
$$H=\frac12(p_1^2+p_2^2)+\frac12(a_1q_1^2+a_2q_2^2)+\frac12(q_1^2+q_2^2)^2.$$ """
ELLIPTIC = r"""The elliptic coordinates $u$ and $v$ are the roots of the equation
$$\frac{q_1^2}{z-a_1}+\frac{q_2^2}{z-a_2}=1.$$ """


@pytest.mark.parametrize(
    ("claim", "green"),
    sampled(
        [
            ("u+v=a_1+a_2+q_1^2+q_2^2", True),
            ("u+v=a_1+a_2-q_1^2-q_2^2", False),
            ("uv=a_1a_2+a_1q_2^2+a_2q_1^2", True),
            ("uv=a_1a_2+a_1q_1^2+a_2q_2^2", False),
            (r"q_1^2=-\frac{(a_1-u)(a_1-v)}{a_1-a_2}", True),
            (r"q_1^2=\frac{(a_1-u)(a_1-v)}{a_1-a_2}", False),
            (r"\dot u+\dot v=2q_1p_1+2q_2p_2", True),
            (r"\dot u+\dot v=q_1p_1+q_2p_2", False),
        ],
        4,
    ),
)
def test_coordinates_that_are_roots_move_with_the_coefficients(claim, green):
    assert verdicts(rf"{PLANE} {ELLIPTIC} Then $${claim}.$$")[claim].green is green


def test_an_equation_of_which_roots_are_named_does_not_hold_always():
    found = roles(PLANE + ELLIPTIC)
    assert found[r"\frac{q_1^2}{z-a_1}+\frac{q_2^2}{z-a_2}=1"] == OTHER


LAX = (
    PLANE
    + r"""Put $$B=1+\frac{q_1^2}{z+a_1}+\frac{q_2^2}{z+a_2},\qquad r^2=q_1^2+q_2^2.$$
Let $\lambda_1,\lambda_2$ be the zeros of $B$, $$B=\frac{(z-\lambda_1)(z-\lambda_2)}{(z+a_1)(z+a_2)},$$ """
)


@pytest.mark.parametrize(
    ("claim", "green"),
    sampled(
        [
            (r"q_1^2=\frac{(a_1+\lambda_1)(a_1+\lambda_2)}{a_2-a_1}", True),
            (r"q_1^2=\frac{(a_1+\lambda_1)(a_1+\lambda_2)}{a_1-a_2}", False),
            (r"r^2=-(\lambda_1+\lambda_2+a_1+a_2)", True),
            (r"r^2=\lambda_1+\lambda_2+a_1+a_2", False),
        ],
        2,
    ),
)
def test_zeros_of_an_element_of_a_matrix(claim, green):
    found = verdicts(rf"{LAX} so that $${claim}.$$")
    assert [one.green for one in found.values()] == [True, green]


@pytest.mark.slow
@pytest.mark.parametrize(("factor", "green"), [("4", True), ("2", False)])
def test_the_rate_of_a_zero_is_that_of_dubrovin(factor, green):
    curve = r"""With the integrals
    $$F=p_1^2+a_1q_1^2+q_1^2(q_1^2+q_2^2)-\frac{(q_1p_2-q_2p_1)^2}{a_1-a_2},\qquad
    G=p_2^2+a_2q_2^2+q_2^2(q_1^2+q_2^2)+\frac{(q_1p_2-q_2p_1)^2}{a_1-a_2}$$
    put $$P(z)=(z+a_1)^2(z+a_2)^2\Bigl(z-\frac F{z+a_1}-\frac G{z+a_2}\Bigr).$$ """
    rate = rf"\dot\lambda_1^2=\frac{{{factor}P(\lambda_1)}}{{(\lambda_1-\lambda_2)^2}}"
    assert verdicts(rf"{LAX} {curve} Then $${rate}.$$")[rate].green is green


@pytest.mark.slow
@pytest.mark.parametrize(("sign", "green"), [("", True), ("-", False)])
def test_roots_on_a_sphere(sign, green):
    sphere = r"""The point moves by $$\dot q_1=p_1,\ \dot q_2=p_2,\ \dot q_3=p_3,\quad
    \dot p_1=-a_1q_1+\nu q_1,\ \dot p_2=-a_2q_2+\nu q_2,\ \dot p_3=-a_3q_3+\nu q_3,\qquad
    \nu=a_1q_1^2+a_2q_2^2+a_3q_3^2-p_1^2-p_2^2-p_3^2,$$
    with the constraints $q_1^2+q_2^2+q_3^2=1$, $q_1p_1+q_2p_2+q_3p_3=0$.
    The sphero-conical coordinates $u_1,u_2$ are the roots of the equation
    $\sum_{i=1}^3\frac{q_i^2}{z-a_i}=0$."""
    claim = rf"q_1^2={sign}\frac{{(a_1-u_1)(a_1-u_2)}}{{(a_1-a_2)(a_1-a_3)}}"
    assert verdicts(rf"{sphere} Then $${claim}.$$")[claim].green is green


ENERGY = r"""The law is $$\ddot x=a-3x^2$$ with the energy $h=\frac12\dot x^2-ax+x^3$. """


@pytest.mark.parametrize(
    "words",
    sampled(
        [
            "Let $u_1,u_2,u_3$ be the square roots of the zeros of $h+as-s^3$. Then",
            "Let $u_1,u_2,u_3$ be the inverse roots of $h+as-s^3$. Then",
            "The squares of $u_1,u_2,u_3$ are the roots of $h+as-s^3$. Then",
            "The numbers $u_1,u_2,u_3$ are twice the roots of $h+as-s^3$. Then",
            "The numbers $u_1,u_2,u_3$ are not the roots of $h+as-s^3$. Then",
            "Let $u_1,u_2,u_3$ be the roots of the derivative of $h+as-s^3$. Then",
            "The derivative of $h+as-s^3$ has the roots $u_1,u_2,u_3$. Then",
            "Пусть квадраты чисел $u_1,u_2,u_3$ — корни многочлена $h+as-s^3$. Тогда",
        ],
        2,
    ),
)
def test_other_words_beside_roots_name_none(words):
    claim = "u_1u_2+u_2u_3+u_3u_1=-a"
    assert verdicts(rf"{ENERGY} {words} $${claim}.$$")[claim] is Verdict.UNDECIDED
