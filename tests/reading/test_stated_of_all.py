"""Sentences that speak of all motions claim something: they are listed, and none is suspected."""

import pytest

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
