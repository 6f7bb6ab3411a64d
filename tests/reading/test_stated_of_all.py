"""Sentences that speak of all motions claim something: they are listed, and none is suspected."""

import pytest

from kowalevski_cas.reading.uncovered import OF_LAW
from tests.audit.test_doubted import audited
from tests.sample import sampled

LAW = r"The equations of motion are \[ \dot u=-u+u^3,\qquad \dot w=uw . \] "


@pytest.mark.parametrize(
    ("sentence", "cue"),
    sampled(
        [
            ("For $t>0$ we have $u<1$, whatever the initial values are.", "whatever"),
            ("Each orbit with $w>0$ is a circle.", "Each orbit"),
            ("The axis $u=0$ is approached by any solution.", "any solution"),
            ("Regardless of the initial values the body comes to rest.", "Regardless of"),
            ("При любых начальных значениях тело остановится.", "При любых"),
            ("Каждое движение ограничивается осью.", "Каждое движение"),
        ],
        3,
    ),
)
def test_what_is_said_of_all_motions_is_listed(sentence, cue):
    found = audited(LAW + sentence)
    assert [one.cue for one in found.uncovered] == [cue]
    assert not any(one.wrong for one in found.formulas)


@pytest.mark.parametrize(
    "sentence", ["Each of these is printed below.", "In any case we write $w$ for it."]
)
def test_other_words_claim_nothing(sentence):
    assert not audited(LAW + sentence).uncovered


@pytest.mark.parametrize(
    ("sentence", "cue"),
    [
        ("The equilibrium $u=0$, $w=0$ is stable.", "stable"),
        ("The unstable equilibrium is $u=1$, $w=0$.", "unstable"),
        ("The function $we^{-t}u^{-1}(1-u^2)^{1/2}$ is a positive definite integral.", "positive definite"),
        (r"The motion with $w=0$ has the period $T=\frac\pi2$.", "period"),
        (r"Hence $u\to1$ as $t\to\infty$.", "tends"),
        ("Равновесие $u=0$, $w=0$ устойчиво.", "устойчиво"),
    ],
)  # fmt: skip
def test_what_no_formula_states_is_listed_beside_what_is_judged(sentence, cue):
    assert [one.cue for one in audited(LAW + sentence).uncovered] == [cue]


CENTRE = r"Let $\dot x=y$, $\dot y=-x$. "


@pytest.mark.parametrize(
    ("sentence", "cue"),
    sampled(
        [
            ("The energy $x^2+y^2$ is constant and equal to $1$.", "constant and equal to"),
            (r"The energy $x^2+y^2$ is constant and equal to $\frac12$.", "constant and equal to"),
            ("The function $x^2+y^2$ is the only first integral.", "the only first integral"),
            ("$x^2+y^2$ is an integral; there are no other integrals.", "no other integrals"),
            ("Every function of $x$ and $y$, say $x^2+y^2$, is an integral.", "Every function"),
            (r"The solution $x=\sin t$, $y=\cos t$ has the period $\pi$.", "period"),
            (r"The solution $x=\sin t$, $y=\cos t$ is of period $3\pi$.", "period"),
            ("The integrals $x^2+y^2$ and $x^4+2x^2y^2+y^4$ are in involution.", "in involution"),
            ("Функция $x^2+y^2$ — единственный интеграл.", "единственный интеграл"),
            ("Функция $x^2+y^2$ постоянна и равна $1$.", "постоянна и равна"),
            ("Интегралы $x^2+y^2$ и $x^4+2x^2y^2+y^4$ находятся в инволюции.", "в инволюции"),
            ("Любая функция от $x$, как $x^2+y^2$, сохраняется.", "Любая функция"),
        ],
        4,
    ),
)
def test_a_word_that_is_stronger_than_the_formula_is_listed(sentence, cue):
    assert [one.cue for one in audited(CENTRE + sentence).uncovered] == [cue]


@pytest.mark.parametrize(
    "sentence",
    [
        "The energy $x^2+y^2$ is constant and equal to $h$.",
        "The only thing to be seen is that $x^2+y^2$ is an integral.",
        "The function $x^2+y^2$ is an integral that does not depend on time.",
        "The function $x^2+y^2$ is constant and $x$ is not.",
    ],
)
def test_a_word_that_is_as_strong_is_not(sentence):
    found = audited(CENTRE + sentence)
    assert not found.uncovered and any(one.verdict == "proved" for one in found.formulas)


@pytest.mark.parametrize(
    "sentence",
    [
        r"The function $x\cos t-y\sin t$ is an integral that does not depend on time.",
        r"The function $x\cos t-y\sin t$ is a time-independent integral.",
        "The function $x^2+y^2$ is constant for $t<0$ and grows for $t>0$.",
        "The function $x^2+y^2$ is conserved at first, but later it decreases.",
        r"Функция $x\cos t-y\sin t$ — интеграл, не зависящий явно от времени.",
    ],
)
def test_nor_is_anything_proved_that_its_sentence_takes_back(sentence):
    assert not any(one.verdict == "proved" for one in audited(CENTRE + sentence).formulas)


WELL = r"The motion is \[ \dot x=y,\qquad\dot y=x-x^3 . \] "


@pytest.mark.parametrize(
    ("sentence", "kind"),
    sampled(
        [
            (r"The equilibria are $x=\pm1$, $y=0$, and there are no others.", "all rest"),
            (r"The points $x=\pm1$, $y=0$ exhaust the equilibria.", "all rest"),
            (r"The complete list of the equilibria is $x=\pm1$, $y=0$.", "all rest"),
            (r"The equilibria are the two points $x=\pm1$, $y=0$.", "all rest"),
            (r"Apart from $x=y=0$ there are no equilibria.", "all rest"),
            (
                r"The system has no equilibrium, and $y^2-x^2+\frac12x^4$ is an integral.",
                "all rest",
            ),
            (r"The curve $y^2=x^2-\frac12x^4$ is a closed orbit.", "orbit"),
            (r"The integral $y^2-x^2+\frac12x^4$ is bounded from above.", "motion"),
            (
                r"$y^2-x^2+\frac12x^4$ is an integral, and this does not hold for its half.",
                "otherwise",
            ),
        ],
        4,
    ),
)
def test_what_goes_further_than_a_formula_is_listed_beside_it(sentence, kind):
    found = audited(WELL + sentence)
    assert kind in [one.kind.partition(":")[0] for one in found.uncovered]
    assert not any(one.wrong for one in found.formulas)


def test_what_is_judged_to_be_all_is_not_listed():
    found = audited(WELL + r"The equilibria are the solutions of \[ y=0,\qquad x-x^3=0 . \]")
    assert not found.uncovered


OSCILLATOR = r"The motion is \[ \dot x=y,\qquad\dot y=-x . \] "


@pytest.mark.parametrize(
    ("sentence", "listed"),
    [
        (r"Let $u$ be the square of $x$. Then \[ \ddot u=-4u, \] and $\dot u^2+4u^2$ is constant.", True),
        (r"The distance $r$ satisfies \[ \ddot r=-r . \] Therefore $\dot r^2+r^2$ is constant.", True),
        (r"The variational equations are \[ \dot u=w,\qquad\dot w=-2u . \]", True),
        (r"Let $u$ satisfy \[ \ddot u=-4u . \] Then $\dot u^2+4u^2$ is constant.", False),
        (r"Put $u=x^2$. Then \[ \ddot u=2y^2-2x^2 . \]", False),
        (r"With $u=x+y$ and $v=x-y$ we get \[ \dot u=-v,\qquad\dot v=u . \]", False),
    ],
)  # fmt: skip
def test_equations_for_letters_that_only_words_explain_are_listed(sentence, listed):
    found = audited(OSCILLATOR + sentence)
    assert [one.kind for one in found.uncovered if one.kind == OF_LAW] == [OF_LAW] * listed
