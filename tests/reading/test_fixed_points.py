r"""Maps by steps: fixed points by letters without an index, and maps in sections of their own."""

import pytest

from tests.reading.test_reading import reading, verdicts

LOGISTIC = r"""The logistic map is $$x_{n+1}=\mu x_n(1-x_n).$$ """


def values(text):
    return [one.value for one in verdicts(text).values()]


@pytest.mark.parametrize(
    ("words", "found"),
    [
        (r"The fixed points are $x=0$ and $x=1-\frac1\mu$.", ["proved", "conditional"]),
        (
            r"It has the fixed point $x^*=1-\frac1\mu$, and its multiplier is $2-\mu$.",
            ["conditional"],
        ),
        (r"Then $x=0$ is a fixed point.", ["proved"]),
    ],
)
def test_a_fixed_point_is_given_by_a_letter_without_steps(words, found):
    assert values(LOGISTIC + words) == found


@pytest.mark.parametrize(
    "words",
    [
        r"The fixed points are $x=1$ and $x=1-\mu$.",
        r"It has the fixed point $x^*=\frac1\mu-1$.",
        r"Then $x=1$ is a fixed point.",
        r"The fixed points of its second iterate are $x=0$ and $x=1-\frac2\mu$.",
    ],
)
def test_what_is_not_fixed_is_not_proved(words):
    assert not any(one.green for one in verdicts(LOGISTIC + words).values())


def test_a_fixed_point_of_two_steps_is_there_at_each():
    text = r"The map is $$x_{n+1}=x_n^2-x_{n-1}.$$ Its fixed points are $x=0$ and $x=2$."
    assert values(text) == ["proved", "proved"]
    assert "proved" not in values(text.replace("x=2", "x=3"))[1:]


@pytest.mark.parametrize("solution", ["a^nx_0", "a^{2n}x_0"])
def test_what_is_given_by_the_number_of_steps_is_not_judged(solution):
    text = rf"The map is $$x_{{n+1}}=ax_n.$$ Its solution is $$x_n={solution}.$$ Then $x_{{n+1}}=ax_n$."
    assert "undecided" not in values(text)
    assert {one.role.name for one in reading(text).formulas if "_0" in one.item.typed.tex} == {
        "other"
    }


SEVERAL = r"""\section{One} Consider the map $$x'=y,\qquad y'=-x.$$ The function $x^2+y^2$ is invariant
under the map.
\section{Two} For the map $x_{n+1}=\mu x_n(1-x_n)$ the fixed points are $x=0$ and $x=1-\frac1\mu$.
\section{Three} Another map is $$x'=x+y,\qquad y'=-x.$$ The function $x^2+xy+y^2$ is invariant under
the map."""


def test_maps_in_sections_of_their_own_have_letters_of_their_own():
    assert values(SEVERAL) == ["proved", "proved", "conditional", "proved"]
    for true, false in [("x^2+xy", "x^2-xy"), ("x^2+y^2", "x^2+2y^2"), (r"\frac1\mu", r"\mu")]:
        assert sum(one.green for one in verdicts(SEVERAL.replace(true, false)).values()) == 3


@pytest.mark.parametrize("word", ["inverse", "linear", "same"])
def test_what_is_made_of_a_map_is_no_other_one(word):
    text = rf"""\section{{One}} Consider the map $$x'=y,\qquad y'=-x+y^2.$$
    \section{{Two}} For the {word} map $$x'=y,\qquad y'=-x$$ the function $x^2+y^2$ is invariant."""
    assert "proved" not in values(text)[1:]
    assert [one.role.name for one in reading(text).formulas].count("law") == 2
