"""Deviations from a point, and what is linear in them."""

import re

import pytest

from tests.reading.test_reading import verdicts
from tests.sample import sampled

PREY = r"The model is \[ \dot x=x(a-by),\qquad\dot y=y(-c+dx) .\] "
WELL = r"The system is \[ \dot u=v,\qquad\dot v=u-u^3-kv .\] "
ROD = r"The equation of motion is \[ \ddot s=s-s^3 .\] "
HOOP = r"""The equation is \[ \ddot\chi=n^2\sin\chi\cos\chi-k\sin\chi .\] It rests at the angle $\chi_0$ with
\[ \cos\chi_0=\frac k{n^2} .\] """
BODY = (
    r"""The body turns by \[ A\dot p=(B-C)qr,\qquad B\dot q=(C-A)rp,\qquad C\dot r=(A-B)pq .\] """
)
SPRING = r"The equation is \[ \ddot u=-bu+cu^3 .\] "
TRUE = [
    (PREY + r"Near the equilibrium put $x=\frac cd+p$, $y=\frac ab+q$. In the linear approximation",
     r"\dot p=-\frac{bc}dq", r"\dot p=-\frac{bc}dp"),
    (PREY + r"Put $x=\frac cd(1+p)$, $y=\frac ab(1+q)$. The linear terms are", r"\dot q=cp", r"\dot q=ap"),
    (PREY + r"Let $x=x_0+\xi$, $y=y_0+\eta$ with $x_0=\frac cd$, $y_0=\frac ab$. Linearising, we get",
     r"\dot\eta=dy_0\xi", r"\dot\eta=dx_0\xi"),
    (WELL + r"Setting $u=1+w$ and neglecting terms of the second order we find near $v=0$",
     r"\dot v=-2w-kv", r"\dot v=-3w-kv"),
    (WELL + r"In the neighbourhood of $u=-1$, $v=0$ put $u=-1+w$. Then",
     r"\dot v=-2w-kv", r"\dot v=w-kv"),
    (WELL + r"Near $(1,0)$ let $u=1+\xi$, $v=\eta$. The linearised system is",
     r"\dot\eta=-2\xi-k\eta", r"\dot\eta=-2\xi-\eta"),
    (WELL + r"The linearised equations near the origin are", r"\dot v=u-kv", r"\dot v=-u-kv"),
    (WELL + r"Подставим $u=-1+\xi$, $v=\eta$; линейная часть имеет вид",
     r"\dot\eta=-2\xi-k\eta", r"\dot\eta=2\xi-k\eta"),
    (ROD + r"With $s=1+\eta$ we get in the first approximation", r"\ddot\eta=-2\eta", r"\ddot\eta=2\eta"),
    (ROD + r"For small $s$ we have", r"\ddot s=s", r"\ddot s=-s"),
    (HOOP + r"Put $\chi=\chi_0+\xi$ and neglect the squares of $\xi$,",
     r"\ddot\xi=-n^2\sin^2\chi_0\,\xi", r"\ddot\xi=-n^2\cos^2\chi_0\,\xi"),
    (HOOP + r"Put $\chi=a+\xi$ and neglect the squares of $\xi$,",
     r"\ddot\xi=n^2\sin a\cos a-k\sin a+(n^2\cos 2a-k\cos a)\xi",
     r"\ddot\xi=n^2\sin a\cos a-k\sin a+(n^2\cos 2a+k\cos a)\xi"),
    (BODY + r"It turns with $p=n$, $q=r=0$. Writing $p=n+\xi$ and keeping only the linear terms we have",
     r"B\dot q=(C-A)nr", r"B\dot q=(A-C)nr"),
    (SPRING + r"There is equilibrium at $u=a$ with \[ a^2=\frac bc .\] We put $u=a+\xi$ and linearize,",
     r"\ddot\xi=2b\xi", r"\ddot\xi=3b\xi"),
]  # fmt: skip


def last(text):
    """The verdict on the formula that is printed last; it may be not judged."""
    printed = re.findall(r"\\\[ (.*?)(?: \.)?\\\]", text)[-1]
    return verdicts(text).get(printed)


@pytest.mark.parametrize("words, true, false", sampled(TRUE, 6))
def test_what_is_linear_holds_to_the_first_order(words, true, false):
    assert last(rf"{words} \[ {true} .\]").green
    found = last(rf"{words} \[ {false} .\]")
    assert found is not None and found.value == "undecided"


@pytest.mark.parametrize(
    "text",
    [
        PREY + r"Put $x=x_0+p$, $y=y_0+q$. In the linear approximation \[ \dot p=-bx_0q .\]",
        PREY + r"Put $x=\frac cd+p$, $y=\frac ab+q$. To the second order \[ \dot p=-\frac{bc}dq .\]",
        PREY + r"Near the equilibrium put $x=\frac cd+p$, $y=\frac ab+q$. Then \[ \dot p=-\frac{bc}dq+pq .\]",
        PREY + r"Put $x=\frac cd+p$, $y=\frac ab+q$. Then \[ \dot p=-\frac{bc}dq .\]",
        WELL + r"Put $u=1+w$. The linear part at $u=0$, $v=0$ is \[ \dot v=-2w-kv .\]",
        WELL + r"Put $u=1+w$. The linear part is \[ \dot v=-2w-kv .\]",
        WELL + r"Put $u=1+w$. Near $v=1$ the linear part is \[ \dot w=v-1 .\]",
        WELL + r"With $u=1+w$ the linear part at $v=0$ is not \[ \dot v=-2w-kv .\]",
        ROD + r"For small $\varepsilon$ we have \[ \ddot s=s .\]",
    ],
)  # fmt: skip
def test_what_is_not_known_to_be_linear_there_is_not_green(text):
    found = last(text)
    assert found is None or not found.green


@pytest.mark.parametrize("word", ["with", "where", "for which"])
@pytest.mark.parametrize(
    ("given", "green"), [(r"a^2=\frac bc", True), (r"ca^2=b", True), (r"a^2=2\frac bc", False)]
)
def test_a_place_of_rest_is_where_the_words_behind_it_say(word, given, green):
    text = rf"{SPRING}There is an equilibrium at $u=a$ {word} \[ {given} .\]"
    assert verdicts(text)["u=a"].green is green


HANGING = r"""The spring pendulum moves by \[ \ddot r=r\dot\varphi^2+g\cos\varphi-\frac km(r-l_0),\]
\[ r\ddot\varphi=-2\dot r\dot\varphi-g\sin\varphi. \] """


@pytest.mark.parametrize(
    "words",
    [
        r"""At rest $\varphi=0$ and $r=l$, where \[ l=l_0+\frac{mg}k. \]
        Writing $r=l+\xi$ and retaining only the linear terms in $\xi$ and $\varphi$ we get""",
        r"""With $r=l+\xi$, $l=l_0+mg/k$, retaining only the linear terms in $\xi$ and $\varphi$,""",
    ],
)
def test_what_is_small_deviates_from_zero(words):
    text = (
        HANGING + words + r" \[ \ddot\xi=-\frac km\xi,\qquad\ddot\varphi=-\frac gLENGTH\varphi . \]"
    )
    for length in ("l", "{l_0}"):
        found = verdicts(text.replace("LENGTH", length))
        assert found[r"\ddot\xi=-\frac km\xi"].green
        assert found[rf"\ddot\varphi=-\frac g{length}\varphi"].green == (length == "l")
