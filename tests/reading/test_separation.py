"""Where variables are separated: the constant of that, the other time, the coordinate lines."""

import pytest

from kowalevski_cas.audit.reading import ReadingSession
from kowalevski_cas.verify.outcome import Verdict, in_latex
from tests.reading.test_reading import reading
from tests.reading.test_reading import verdicts as by_formula

GREEN = (Verdict.PROVED, Verdict.CONDITIONAL)


def verdicts(text: str) -> list[Verdict]:
    """The verdicts of the printed claims of a text, in their order."""
    return [*by_formula(text).values()]


STARK = (
    r"A point moves by $\ddot x=-\frac{\mu x}{r^3}+E$, $\ddot y=-\frac{\mu y}{r^3}$, $r=\sqrt{x^2+y^2}$,"
    r" with the energy $h=\frac12(\dot x^2+\dot y^2)-\frac{\mu}{r}-Ex$."
    r" We put $x=\frac12(u^2-v^2)$, $y=uv$ and $dt=(u^2%sv^2)\,d\tau$, where primes denote derivatives"
    r" with respect to $\tau$. "
)
OSCILLATORS = (
    r"Two oscillators move by $\ddot x=-x$, $\ddot y=-4y$"
    r" with the energy $h=\frac12(\dot x^2+\dot y^2)+\frac12x^2+2y^2$. "
)


@pytest.mark.parametrize(
    ("text", "right"),
    [
        (
            STARK % "+" + r"This falls into $\frac12u'^2=hu^2+\mu+\frac12Eu^4+\beta$,"
            r" $\frac12v'^2=hv^2+\mu-\frac12Ev^4%s\beta$.",
            "-",
        ),
        (
            OSCILLATORS + r"The energy splits into $\frac12\dot x^2+\frac12x^2=\frac12h+\kappa$"
            r" and $\frac12\dot y^2+2y^2=\frac12h%s\kappa$.",
            "-",
        ),
        (
            OSCILLATORS + r"We have $\dot x^2=\alpha-x^2$, $\dot y^2=2h%s\alpha-4y^2$,"
            r" with a constant $\alpha$.",
            "-",
        ),
    ],
)
def test_a_constant_of_separation_is_the_same_in_all_its_equations(text, right):
    assert {*verdicts(text % right)} <= {*GREEN}
    first, other = verdicts(text % "+")[-2:]
    assert first in GREEN
    assert other not in GREEN


def test_a_misprint_in_another_time_is_blamed_for_what_is_printed_by_it():
    text = (
        r"We obtain $\frac12(u'^2+v'^2)=h(u^2+v^2)+2\mu+\frac12E(u^4-v^4)$."
        r" For $E=0$ we have $u''=2hu$, $v''=2hv$."
    )
    assert {*verdicts(STARK % "+" + text)} <= {*GREEN}
    found = ReadingSession(reading(STARK % "-" + text), timeout=10)
    assert {one.verdict for one in found.outcomes.values()} == {Verdict.REFUTED}
    causes = found.causes
    assert [place.tex for place in causes.misprints] == [r"dt=(u^2-v^2)\,d\tau"]
    (edit,) = causes.misprints.values()
    assert in_latex([edit.formula]) == r"dt = (u^2 + v^2)d\tau"


@pytest.mark.parametrize(
    "lines",
    [r"the lines $\xi=\mathrm{const}$ are ellipses", r"the curves $\eta=\text{const}$ are rays"],
)
def test_coordinate_lines_do_not_take_the_place_of_a_change_of_variables(lines):
    text = (
        r"A point moves by $\ddot x=-x$, $\ddot y=-y$. We put $x=\cosh\xi\cos\eta$, $y=\sinh\xi\sin\eta$,"
        rf" so that {lines}. Then $\dot x^2+\dot y^2=(\cosh^2\xi-\cos^2\eta)(\dot\xi^2%s\dot\eta^2)$."
    )
    assert {*verdicts(text % "+")} <= {*GREEN}
    assert {*verdicts(text % "-")}.isdisjoint(GREEN)


@pytest.mark.parametrize(
    ("law", "energy", "right"),
    [
        (r"\ddot x=-x", r"\frac12\dot x^2+\frac12x^2", r"\dot x^2=%sh-x^2"),
        (r"\ddot x=-x^3", r"\frac12\dot x^2+\frac14x^4", r"\dot x^2=%sh-\frac12x^4"),
        (
            r"\ddot\theta=-\sin\theta",
            r"\frac12\dot\theta^2-\cos\theta",
            r"\dot\theta^2=%sh+2\cos\theta",
        ),
    ],
)
@pytest.mark.parametrize("words", ["with the energy $h=%s$", "It has the energy integral $h=%s$"])
def test_a_velocity_by_the_energy_has_its_coefficient(law, energy, right, words):
    text = f"A point moves by ${law}$. {words % energy}. Then ${right}$."
    assert {*verdicts(text % 2)} <= {*GREEN}
    assert verdicts(text % 3)[-1] not in GREEN
