"""Derivatives by what is no time: their letters are no factors, which would cancel."""

import pytest

from tests.reading.test_reading import reading, verdicts

LAW = r"The equations are $$\ddot x=-x,\qquad\ddot y=-y.$$ Let $S=a^2x$ and $T=a^2y$. Then "
FORMS = [
    r"\frac{dS}{da}=ax", r"dS/da=ax", r"{dS\over da}=ax", r"\tfrac{dS}{da}=ax", r"\frac{d}{da}S=ax",
    r"\frac{d(S+T)}{da}=ax+ay", r"\frac{dS+dT}{da}=ax+ay", r"\frac{2dS}{da}=2ax", r"\frac{dS}{2da}=\frac12ax",
    r"\frac{dS}{a\,da}=x", r"a\frac{dS}{da}=S", r"\frac{a\,dS}{S\,da}=1", r"\left(\frac{dS}{da}\right)^2=a^2x^2",
    r"\frac{d^2S}{da^2}=x", r"a\,dS=S\,da", r"\frac{dS}{S}=\frac{da}{a}", r"dS=\frac Sada",
    r"\frac{\delta S}{\delta a}=ax", r"\frac{\Delta S}{\Delta a}=ax", r"\frac{DS}{Da}=ax",
]  # fmt: skip
"""False: they hold of S/a, or of its square, which is left when the letters cancel."""
TYPES = ["d", r"\mathrm d", r"\mathrm{d}", r"{\rm d}", r"\text{d}", r"\operatorname{d}"]


@pytest.mark.parametrize("form", FORMS)
def test_letters_of_differentials_do_not_cancel(form):
    for text in (f"{LAW}${form}$.", f"{LAW}$${form}.$$"):
        assert not any(one.green for one in verdicts(text).values())


@pytest.mark.parametrize("type", TYPES)
def test_nor_do_they_in_any_type(type):
    assert not any(
        one.green for one in verdicts(rf"{LAW}$\frac{{{type} S}}{{{type} a}}=ax$.").values()
    )


@pytest.mark.parametrize(
    ("words", "green"),
    [
        (r"$\frac{x+d}{d}=1+\frac xd$", True),
        (r"$\frac{d}{dt}S=a^2\dot x$", True),
        (r"$\frac{\delta+1}{\delta}=1+\frac1\delta$", True),
        (r"$\frac{DS}{a}=aDx$", True),
        (r"$\frac{DS}{a}=Dx$", False),
    ],
)
def test_letters_that_are_constants_stay_so(words, green):
    found = reading(rf"{LAW}{words}.")
    assert [one.green for one in verdicts(rf"{LAW}{words}.").values()] == [green], found


@pytest.mark.parametrize("form", ["c/d", r"\frac cd", r"\frac{c}{d}", "(c/d)", r"c\cdot1/d"])
def test_d_alone_above_a_line_or_below_it_is_a_letter(form):
    text = r"Consider $\dot x=x(a-by)$, $\dot y=y(-c+dx)$. The only equilibrium with $xy\ne0$ is "
    found = verdicts(f"{text}$x={form}$, $y=a/b$.")
    assert found and all(one.green for one in found.values())
