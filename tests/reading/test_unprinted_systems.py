"""What is said of a system that is not printed is judged by no other one; the rest is as before.

A function is constant by the printed equations. Words say so of these, or of others: of damped ones,
of a discretization, of what is changed.
"""

from itertools import product

import pytest

from tests.reading.test_reading import verdicts
from tests.sample import sampled

LAWS = (
    (r"Let $\dot x=y$, $\dot y=-x$. ", r"\frac12(x^2+y^2)"),
    (r"The equations of motion are \[\dot x=y,\quad \dot y=-x-x^3.\] ", r"y^2+x^2+\frac12x^4"),
    (r"The equations are $\ddot x=-x-y^2$, $\ddot y=-2xy$. ", r"\dot x^2+\dot y^2+x^2+2xy^2"),
    (
        r"The Hamiltonian is $H=\frac12p^2+\frac12q^2+\frac14q^4$, so $\dot q=p$, $\dot p=-q-q^3$. ",
        r"p^2+q^2+\frac12q^4",
    ),
)  # fmt: skip
CLAIMS = (
    "the function $T$ is an integral", "the quantity $T$ is conserved", "$T$ remains constant",
    "the energy $T$ is constant",
)  # fmt: skip
OTHER = (
    "For the damped system @.", "In the case of a damped oscillator @.", "If we add friction, @.",
    "If friction is present, @.", "With air resistance @.", "In a resisting medium @.",
    "In the presence of a periodic force @.", "Under the action of a constant external force @.",
    "For the forced oscillator @.", "When a driving torque is included, @.", "Even with noise @.",
    "For the perturbed problem @.", "For the relativistic oscillator @.", "In the delayed system @.",
    "In the discretized system @.", "For a numerical scheme @.", "For Euler's discretization @.",
    "If the sign of the potential is reversed, @.", "Without the quadratic terms, @.",
    "We change the sign of the potential. Then @.", "We add friction. Still @.",
    "Let now viscous friction act. The motion decays. Nevertheless @.",
    "Now consider the damped oscillator. Again @.", r"\section{The damped case} Here @.",
    "The friction is neglected here. If we add it, we get the damped oscillator, and for the damped oscillator @.",
    "Here we neglect friction. For the system with friction @.",
    "При наличии трения @.", "Для затухающих колебаний @.", "Если добавить трение, то @.",
    "Под действием периодической силы @.", "Изменим знак потенциала. Тогда @.",
    "Для возмущённой системы @.", "В сопротивляющейся среде @.", "Для разностной схемы @.",
)  # fmt: skip
BEHIND = (
    "The function $T$ is an integral of the damped system.",
    "The function $T$ is conserved in the presence of friction.",
    "The function $T$ is constant for the perturbed motion.",
    "The energy of a damped oscillator, $T$, is constant.",
    "The function $T$ remains an integral if the sign of the force is changed.",
    "The discretization has the integral $T$.", "The leap-frog scheme preserves the integral $T$.",
    "Функция $T$ является интегралом возмущённой системы.",
)  # fmt: skip
OF_THIS = (
    "Without friction @.", "If friction is neglected, @.", "In the absence of damping @.",
    "Unlike the damped oscillator, the present one is conservative: @.",
    "For the undamped system @.", "For the unperturbed problem @.", "Here @.",
    "If we neglect the air resistance, @.", "For all motions @.", "In these units @.",
    "Friction will be added in Section 3. Here @.", "The damped system is another matter. Here @.",
    "With the damped oscillator it has little to do. We see that @.", "Of course, @.",
    "We do not add friction. Then @.", "The sign of the potential does not matter. Indeed, @.",
    "Let friction be absent. Then @.", "With the initial values $x=1$ at $t=0$, @.",
    "При отсутствии трения @.", "Без трения @.", "Если пренебречь трением, то @.",
    "Для невозмущённой системы @.", "We can add a constant. Still @.", "By the energy theorem @.",
    "For the damped oscillator energy is lost, but here @.", "Then @.", "By a direct computation @.",
)  # fmt: skip
NAMED = (
    (
        r"A damped oscillator moves by $\ddot x+c\dot x+x=0$. Let $E=\frac12(\dot x^2+x^2)$. "
        r"For the damped oscillator $\dot E=-c\dot x^2$.", r"\dot E=-c\dot x^2",
    ),
    (
        r"Let $\ddot x=-x-c\dot x$ and $E=\frac12(\dot x^2+x^2)$. With friction $\dot E=-c\dot x^2$.",
        r"\dot E=-c\dot x^2",
    ),
    (
        r"Let $\dot x=y$, $\dot y=-x-cy$ and $E=\frac12(y^2+x^2)$. In the damped case $\dot E=-cy^2$.",
        r"\dot E=-cy^2",
    ),
    (
        r"The perturbed system is $\dot x=y$, $\dot y=-x-x^2$. The function $y^2+x^2+\frac23x^3$ is an "
        r"integral of the perturbed system.", r"y^2+x^2+\frac23x^3",
    ),
    (
        r"Let $\dot x=y$, $\dot y=-x-\varepsilon x^2$. The function $y^2+x^2+\frac23\varepsilon x^3$ is an "
        r"integral of the perturbed problem.", r"y^2+x^2+\frac23\varepsilon x^3",
    ),
    (
        r"Let $\dot x=y$, $\dot y=-x-x^3$. For the equation of Duffing $y^2+x^2+\frac12x^4$ is an integral.",
        r"y^2+x^2+\frac12x^4",
    ),
    (
        r"Let $\dot x=y$, $\dot y=-x$. For the linearized pendulum $y^2+x^2$ is an integral.",
        "y^2+x^2",
    ),
    (
        r"Let $\dot x=y$, $\dot y=-x+a$. This is a model of a constant external force. With the constant "
        r"external force $y^2+x^2-2ax$ is an integral.", "y^2+x^2-2ax",
    ),
    (
        r"For the driven oscillator, $\ddot x=-x+\cos t$, let $E=\frac12(\dot x^2+x^2)$. The energy of the "
        r"driven oscillator changes by $\dot E=\dot x\cos t$.", r"\dot E=\dot x\cos t",
    ),
    (
        r"\section{A damped oscillator} The equation is $\ddot x=-x-c\dot x$. Let $E=\frac12(\dot x^2+x^2)$. "
        r"If friction is present, $\dot E=-c\dot x^2$.", r"\dot E=-c\dot x^2",
    ),
    (
        r"Для затухающего осциллятора $\ddot x=-x-c\dot x$ положим $E=\frac12(\dot x^2+x^2)$. "
        r"При наличии трения $\dot E=-c\dot x^2$.", r"\dot E=-c\dot x^2",
    ),
)  # fmt: skip
"""Texts of which the printed law is the one that the words speak of, and what is true by it."""


def verdict(law, words, claim="@"):
    text, tex = law
    return verdicts(text + words.replace("@", claim).replace("$T$", f"${tex}$")).get(tex)


@pytest.mark.parametrize(
    ("law", "words", "claim"),
    sampled([*product(LAWS, OTHER, CLAIMS), *product(LAWS, BEHIND, ["@"])], 12),
)
def test_what_is_said_of_another_system_is_not_judged(law, words, claim):
    found = verdict(law, words, claim)
    assert found is None or not (found.green or found.value == "refuted")


@pytest.mark.parametrize(("law", "words", "claim"), sampled(product(LAWS[:3], OF_THIS, CLAIMS), 8))
def test_what_is_said_of_the_printed_one_is_judged(law, words, claim):
    found = verdict(law, words, claim)
    assert found is not None and found.green


@pytest.mark.parametrize(("text", "tex"), sampled(NAMED, 4))
def test_the_printed_law_may_be_the_one_that_words_speak_of(text, tex):
    found = verdicts(text).get(tex)
    assert found is not None and found.green
