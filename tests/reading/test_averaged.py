"""Averaged equations are a law of their own: what fails by it may be meant of the exact ones."""

import pytest

from tests.reading.test_reading import reading, verdicts

SAME_LETTERS = r"""Consider the equations
$$\dot a=\varepsilon a(1-a^2)\sin^2\psi,\qquad \dot\psi=1.$$
Averaging over $\psi$ gives $$\dot a=\frac{\varepsilon}{2}a(1-a^2).$$
The points of rest of the averaged equation are $a=0$ and $a=1$. The function $b=a^2$ satisfies
$$\dot b=\varepsilon b(1-b).$$"""

NEW_LETTERS = r"""Consider $$\ddot x+\varepsilon\dot x^3+x=0.$$
Let $x=r\cos(t+\phi)$, $\dot x=-r\sin(t+\phi)$. The averaged equations are
$$\dot r=-\frac38\varepsilon r^3,\qquad\dot\phi=0.$$ They have the solution
$$r=\frac{r_0}{\sqrt{1+\frac34\varepsilon r_0^2t}}.$$
By the exact equation the energy $E=\frac12(\dot x^2+x^2)$ decreases: $$\dot E=-\varepsilon\dot x^4.$$"""


def values(text):
    return [one.value for one in verdicts(text).values()]


def test_averaged_equations_are_a_law_in_the_letters_of_the_exact_ones():
    assert values(SAME_LETTERS) == ["proved"] * 3


@pytest.mark.parametrize(
    "true, false", [("$a=1$", "$a=2$"), (r"\varepsilon b(1-b)", r"2\varepsilon b(1-b)")]
)
def test_what_fails_by_averaged_equations_is_not_sure(true, false):
    found = values(SAME_LETTERS.replace(true, false))
    assert sorted(found) == ["proved", "proved", "undecided"]


def test_averaged_equations_for_an_amplitude_have_solutions():
    found = verdicts(NEW_LETTERS)
    assert found[r"r=\frac{r_0}{\sqrt{1+\frac34\varepsilon r_0^2t}}"].green
    assert not any(one.green for one in values_of_r(NEW_LETTERS.replace(r"\frac34", r"\frac38")))


def values_of_r(text):
    return [one for tex, one in verdicts(text).items() if tex.startswith("r=")]


def test_what_derives_what_the_exact_equations_move_is_of_these():
    assert verdicts(NEW_LETTERS)[r"\dot E=-\varepsilon\dot x^4"].green
    false = NEW_LETTERS.replace(r"-\varepsilon\dot x^4", r"-\varepsilon\dot x^3")
    assert verdicts(false)[r"\dot E=-\varepsilon\dot x^3"].value == "undecided"


@pytest.mark.parametrize(
    "words",
    [
        r"To first order in $\varepsilon$, averaging yields",
        r"The averaged equation for the amplitude reads",
        r"После усреднения получаем",
        r"Усредняя по фазе, находим",
    ],
)
def test_words_that_call_equations_averaged(words):
    text = rf"""Consider $$\dot x=y,\qquad\dot y=-x-\varepsilon y.$$ {words} $$\dot r=-\frac\varepsilon2r.$$
    Its solution is $r=r_0e^{{-\varepsilon t/2}}$. Its only point of rest is $r=0$."""
    assert values(text) == ["proved", "proved"]
    assert "refuted" not in values(text.replace("$r=0$", "$r=1$"))
    assert values(text.replace("$r=0$", "$r=1$"))[-1] != "proved"


@pytest.mark.parametrize(
    "words", ["Without averaging we have", "Before averaging we note that", "We find that"]
)
def test_what_is_not_averaged_is_claimed_of_the_exact_equations(words):
    text = rf"""Consider $$\ddot x+x=\varepsilon(1-x^2)\dot x.$$ {words}
    $$\dot E=\varepsilon(1-x^2)\dot x^2,\qquad E=\tfrac12(\dot x^2+x^2).$$"""
    assert "law" not in [one.role.name for one in reading(text).formulas[1:]]
    assert "proved" in values(text)
    assert "proved" not in values(text.replace(r"\dot x^2,", r"\dot x,"))


def test_a_section_on_another_equation_in_the_old_letter_has_its_law():
    text = rf"""\section{{A cubic friction}} {NEW_LETTERS}
    \section{{Duffing}} The equation $$\ddot x+x+\varepsilon x^3=0$$ has the integral
    $$h=\tfrac12\dot x^2+\tfrac12x^2+\tfrac14\varepsilon x^4.$$"""
    assert values(text)[-1] == "proved"
    assert values(text.replace(r"\tfrac14", r"\tfrac13"))[-1] == "refuted"
