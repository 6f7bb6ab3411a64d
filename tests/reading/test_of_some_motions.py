"""Equations with rates that words only suppose of some motions: they are neither true nor false."""

from itertools import product

import pytest

from tests.reading.test_reading import verdicts
from tests.sample import sampled

LAWS = [r"Consider $\ddot x=-x+y$, $\ddot y=-y-x^2$. ", r"Consider $\dot x=y$, $\dot y=-x+x^2$. "]
EQUATIONS = [
    r"\dot x=\dot y=0", r"\dot x=\dot y", r"x=\dot x", r"\dot x^2+\dot y^2=1", r"\ddot x=\ddot y=0",
    r"x\dot y=y\dot x", r"\dot x=-x", r"\ddot x+\dot y=0",
]  # fmt: skip
WORDS = [
    "If $C$, then the motion is simple.", "Where $C$, the force vanishes.",
    "At the moment when $C$ the body turns.", "The motions with $C$ are special.",
    "Let us seek motions for which $C$.", "It is impossible that $C$.",
    "The points at which $C$ form a curve.", "Assume that $C$ at some moment.",
    "When does $C$ hold?", "The condition $C$ singles out a surface.",
    "Пусть в некоторый момент $C$.", "Движения, для которых $C$, исключены.",
    "Если $C$, то движение простое.",
]  # fmt: skip
TEXTS = [law + words.replace("C", tex) for law, tex, words in product(LAWS, EQUATIONS, WORDS)]


@pytest.mark.parametrize("text", sampled(TEXTS, 24))
def test_what_is_supposed_of_some_motions_is_not_judged(text):
    found = verdicts(text)
    assert not any(v.name in ("PROVED", "CONDITIONAL", "REFUTED") for v in found.values())


@pytest.mark.parametrize(
    "words", ["Then $C$.", "Therefore $C$.", "We obtain \\[ C. \\]", "Let us compute $C$."]
)
def test_what_is_concluded_is_refuted(words):
    tex = r"\dot x^2+\dot y^2=1"
    assert verdicts(LAWS[1] + words.replace("C", tex))[tex].name == "REFUTED"


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("tex", [r"\frac{dx}{dt}=0", r"\dot x=-x", r"\dot y=1"])
@pytest.mark.parametrize(
    "words", [r"We ask for solutions with \[ C. \]", r"There are motions for which \[ C. \]"]
)
def test_what_is_displayed_of_some_motions_is_no_law(law, tex, words):
    found = verdicts(law + words.replace("C", tex))
    assert not any(v.name in ("PROVED", "CONDITIONAL", "REFUTED") for v in found.values())
