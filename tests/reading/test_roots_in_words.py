"""What words call the roots of an equation for a letter are these."""

import pytest

from kowalevski_cas.reading import ASSUMPTION, CLAIM
from kowalevski_cas.reading.known import OTHER
from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import roles, verdicts

MOTION = r"The motion is $$\dot x=y,\qquad\dot y=-x.$$ Put $s=x+y$, $p=xy$. "
MAP = r"""Consider the map $$x'=y,\qquad y'=-x+\frac{2ay}{1+y^2}.$$ Put
$$I=x^2y^2+x^2+y^2-2axy.$$ For a given $y$ the numbers $x$ and $y'$ are the roots of the same quadratic
equation $$(1+y^2)\xi^2-2ay\xi+y^2-I=0.$$"""


@pytest.mark.parametrize(
    ("words", "green"),
    [
        ("Then $x$ and $y$ are the roots of the equation $$z^2-sz+p=0.$$", True),
        ("Then $x$ and $y$ are the roots of the equation $$z^2+sz+p=0.$$", False),
        ("Then $x$, $y$ are the two roots of the quadratic polynomial $z^2-sz+2p=0$.", False),
        ("Then $x$ is a root of the equation $z^2-sz+p=0$.", True),
        ("Then $2x$ is a root of the equation $z^2-sz+p=0$.", False),
        ("Then $x$ and $2y$ are the roots of the equation $z^2-sz+p=0$.", False),
        ("Тогда $x$ и $y$ суть корни уравнения $$z^2-sz+p=0.$$", True),
        ("Тогда $x$ и $y$ суть корни уравнения $$z^2-sz-p=0.$$", False),
    ],
)
def test_roots_that_words_name(words, green):
    assert [one.green for one in verdicts(MOTION + words).values()] == [green]


def test_an_image_may_be_a_root():
    assert [*verdicts(MAP).values()][-1].green
    assert not [*verdicts(MAP.replace("-2ay", "-ay")).values()][-1].green


@pytest.mark.parametrize(
    "equation",
    ["s(s^2-(p+q)s+pq)=0", "s-s=0", "(s-p)^2(s-q)=0", "s^3-(p+q)s^2+pqs=0", "(s-p)(s-q)(s-p-q)=0"],
)
def test_the_roots_are_all_roots(equation):
    law = r"The motion is \[ \dot p=q,\qquad \dot q=-p. \] "
    words = r"The numbers $p$ and $q$ are the roots of the equation"
    right = "s^2-(p+q)s+pq=0"
    assert verdicts(rf"{law}{words} \[ {right} .\]")[right].green
    found = verdicts(rf"{law}{words} \[ {equation} .\]").get(equation)
    assert found is None or not found.green


def test_roots_that_are_the_same_are_not_two():
    law = r"The motion is \[ \dot p=q,\qquad \dot q=-p. \] "
    found = verdicts(law + r"The numbers $p$ and $p$ are the roots of \[ (s-p)(s-q)=0 .\]")
    assert not any(one.green for one in found.values())


WELL = r"The motion is \[ \ddot q=aq-3q^2+b. \] "


@pytest.mark.parametrize(
    ("words", "role"),
    [
        ("The turning points, that is, the roots of $q^3-bq=0$, matter.", ASSUMPTION),
        ("We look for the zeros of the function $q^3-bq=0$.", ASSUMPTION),
        ("Here $q$ is a root of $q^3-bq=0$.", ASSUMPTION),
        ("Здесь $q$ есть корень уравнения $q^3-bq=0$.", ASSUMPTION),
        ("The roots of the equation $c^3-bc=0$ are real.", OTHER),
        ("Let $k=6c$, where $c$ is the root of $c^3-bc=0$.", ASSUMPTION),
        ("The roots of the polynomial are real, hence $q^3-bq=0$.", CLAIM),
        ("It has no roots, so $q^3-bq=0$.", CLAIM),
    ],
)
def test_an_equation_of_which_roots_are_spoken_of_is_not_said_to_hold(words, role):
    (found,) = (one for tex, one in roles(WELL + words).items() if "^3-b" in tex)
    assert found == role


@pytest.mark.parametrize(
    "words",
    [
        r"There are two equilibria, namely the roots of \[ {}. \]",
        "There are two equilibria, i.e. the roots of the equation ${}$.",
        "Есть два положения равновесия, а именно корни уравнения ${}$.",
    ],
)
@pytest.mark.parametrize(
    ("equation", "green"), [("3q^2-aq-b=0", True), ("3q^2-aq+b=0", False), ("q^2-aq-b=0", False)]
)
def test_points_of_rest_may_be_the_roots(words, equation, green):
    assert verdicts(WELL + words.format(equation))[equation].green is green


@pytest.mark.parametrize(("equation", "green"), [("3c^2=ac+b", True), ("3c^2=ac", False)])
def test_a_new_letter_that_is_a_root_satisfies_its_equation(equation, green):
    text = rf"{WELL}Let $k=6c$, where $c$ is a root of $3c^2-ac-b=0$. Then ${equation}$."
    assert verdicts(text)[equation].green is green


@pytest.mark.parametrize(
    ("function", "verdict"), [("4x^2+y^2", Verdict.PROVED), ("9x^2+y^2", Verdict.REFUTED)]
)
def test_a_constant_of_the_law_may_be_a_root(function, verdict):
    law = r"It moves by \[ \dot x=y,\quad\dot y=-kx. \] Here $k$ is a root of $k-4=0$. "
    assert verdicts(law + f"The sum ${function}$ is an integral.")[function] is verdict
