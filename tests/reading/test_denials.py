"""Denials, comparisons and hearsay: what words take back is not claimed, and the rest is.

Each text has a function that is constant, and one that is not; nothing that is false is green.
"""

from itertools import product

import pytest

from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import verdicts
from tests.sample import sampled

LAWS = (
    (r"Let $\dot x=-x$, $\dot y=y$. ", "xy", "x^3y"),
    (r"The equations are \[\dot x=y,\quad \dot y=-x-x^3.\] ", r"y^2+x^2+\frac12x^4", "y^2+x^2"),
    (r"The equations of motion are $\ddot x=-x$, $\ddot y=-y$. ", r"x\dot y-y\dot x", r"x\dot y"),
    (r"Пусть $\dot p=qr$, $\dot q=-pr$, $\dot r=0$. ", "p^2+q^2", "p^2+r"),
)  # fmt: skip
"""Equations of motion, what is constant by them, and what is not."""
TAKEN_BACK = (
    "The function $T$ is far from being an integral.", "The function $T$ is far from constant.",
    "The function $T$ is hardly an integral.", "The function $T$ can hardly be conserved.",
    "The functions $F$ and $T$ are hardly integrals.", "$T$ is scarcely constant.",
    "The functions $T$ and $F$ are not integrals.", "$T$ is by no means an integral.",
    "The function $T$ is anything but constant.", "The function $T$ is seldom conserved.",
    "The function $T$ ceases to be an integral.", "The function $T$ is not even constant.",
    "The function $T$ is conserved only on the mean.", "On the average $T$ is constant.",
    "The function $T$ is constant in the mean.", "The function $T$ is only conserved on circles.",
    "Only on the axis is $T$ constant.", "The function $T$ is constant only along two orbits.",
    "For few motions only $T$ is constant.", "For a few motions only, $T$ is an integral.",
    "Students often say that $T$ is an integral. They are wrong.",
    "Some believe that $T$ is an integral.", "Engineers say that $T$ is constant.",
    "The function $T$ is an integral. This is wrong.", "The function $T$ is constant. It is false.",
    "It was hoped that $T$ is an integral. However, this is not so.",
    "The function $T$ is supposedly an integral.", "They write: $T$ is constant. It is a mistake.",
    "The reader might expect that $T$ is an integral, but only $F$ is.", "One would think that $T$ is constant.",
    "At first sight $T$ is an integral; in fact it is not.", "At first glance the function $T$ is conserved.",
    "It seems that $T$ is an integral, but this is an illusion.", "It might appear that $T$ is constant.",
    "Imagine for a moment that $T$ is conserved.", "A naive guess is that $T$ is an integral.",
    "Nobody has shown that $T$ is an integral.", "The error consists in the statement that $T$ is constant.",
    "The function $T$ is an integral of another system.", "The function $T$ is constant by the law of other equations.",
    "A function such as $T$ is an integral if its derivative vanishes.",
    "Допустим противное: $T$ — интеграл.", "Может показаться, что $T$ — интеграл.",
    "На первый взгляд $T$ сохраняется.", "Никто не доказал, что $T$ — интеграл.",
    "Функция $T$ — интеграл другой системы уравнений.",
    "Функция $T$ вряд ли является интегралом.", "Функция $T$ отнюдь не интеграл.",
    "Функция $T$ сохраняется лишь в среднем.", "В среднем $T$ постоянна.",
    "Лишь для немногих движений $T$ постоянна.", "Функция $T$ — интеграл. Это неверно.",
    "Многие думают, что $T$ сохраняется. Они ошибаются.", "Функция $T$ якобы сохраняется.",
)  # fmt: skip
CLAIMED = (
    "It is seen at first sight that $T$ is an integral.", "The function $T$ is an integral, as one might expect.",
    "It is not clear at first sight, but $T$ is an integral.", "Nobody doubts that $T$ is an integral.",
    "It seems to be new that $T$ is an integral.", "The error is small, for $T$ is an integral.",
    "На первый взгляд неясно, что $T$ — интеграл.", "The function $T$ is an integral; there is no other one.",
    "It is far from obvious that $T$ is an integral.", "It is far from trivial that $T$ is constant.",
    "It is hardly surprising that $T$ is an integral.", "Hardly by accident, $T$ is an integral.",
    "The function $T$ is an integral. This is not so in the presence of friction.",
    "The function $T$ is an integral. It is a mistake to think that all are known.",
    "The function $T$ is an integral. They are well known.", "The theorem says that $T$ is constant.",
    "The function $T$ is an integral not only near the origin.",
    "The function $T$, unlike $F$, is an integral.", "Unlike $F$, the function $T$ is an integral.",
    "The function $T$, in contrast to the function $F$, is an integral.",
    "The integral is $T$, unlike $F$.", "The function $T$ is conserved, rather than $F$.",
    "The function $T$, as opposed to $F$, is conserved.",
    "Функция $T$, в отличие от $F$, является интегралом.", "Интегралом является $T$, а не $F$.",
    "Далеко не очевидно, что $T$ — интеграл.",
)  # fmt: skip
COMPARED = (
    "The function $F$, in contrast to $T$, is an integral.", "The function $F$, unlike $T$, is an integral.",
    "Unlike $T$, the function $F$ is an integral.", "The integral is $F$, unlike $T$.",
    "The function $F$, as opposed to the function $T$, is conserved.", "The integral is $F$, and not $T$.",
    "In contrast to $T$, the function $F$ is constant.", "The function $F$ is conserved, rather than $T$.",
    "Функция $F$, в отличие от $T$, является интегралом.", "В отличие от $T$, функция $F$ постоянна.",
)  # fmt: skip


def verdict(law, words):
    """That of the function that is constant, in a text of some words behind a law."""
    text, true, false = law
    found = verdicts(text + words.replace("$T$", f"${true}$").replace("$F$", f"${false}$"))
    assert not (false in found and found[false].green)
    assert found.get(true) is not Verdict.REFUTED
    return found.get(true)


@pytest.mark.parametrize(("law", "words"), sampled(product(LAWS, TAKEN_BACK + COMPARED), 10))
def test_what_is_taken_back_is_not_proved(law, words):
    found = verdict(law, words)
    assert found is None or not found.green


@pytest.mark.parametrize(("law", "words"), sampled(product(LAWS, CLAIMED), 6))
def test_what_is_said_beside_it_takes_nothing_back(law, words):
    found = verdict(law, words)
    assert found is not None and found.green
