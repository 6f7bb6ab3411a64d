"""Linear equations near a place: which place it is, and which letters deviate from it."""

import pytest

from kowalevski_cas.audit.reading import uncovered
from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import reading, verdicts

GREEN = (Verdict.PROVED, Verdict.CONDITIONAL)
EULER = r"Consider Euler's equations \[\dot p=(b-c)qr,\quad\dot q=(c-a)rp,\quad\dot r=(a-b)pq.\] "
WELL = r"A point moves by \[\ddot x=x-x^3.\] "
FIELD = r"Consider $\dot x=y$, $\dot y=x-x^3-ky$. "


@pytest.mark.parametrize(
    ("text", "right", "wrong"),
    [
        (
            EULER + r"The point $p=q=0$, $r=r_0$ is an equilibrium. With $p,q$ small, the linear"
            r" equations are $\dot p=(b-c)r_0q$, $\dot q=%sr_0p$.",
            "(c-a)",
            "(a-c)",
        ),
        (
            EULER + r"The point $(0,0,r_0)$ is an equilibrium. The linearized equations are"
            r" $\dot p=(b-c)r_0q$, $\dot q=%sr_0p$, $\dot r=0$.",
            "(c-a)",
            "(b-a)",
        ),
        (
            EULER + r"The linearization at $(0,r_0,0)$ is $\dot p=(b-c)r_0r$, $\dot r=%sr_0p$.",
            "(a-b)",
            "(b-a)",
        ),
        (WELL + r"For the small deviation $\xi=x-1$ we find $\ddot\xi+%s\xi=0$.", "2", "3"),
        (
            WELL + r"In the neighbourhood of the equilibrium $x=1$ the deviation $\xi=x-1$"
            r" satisfies $\ddot\xi%s2\xi=0$.",
            "+",
            "-",
        ),
        (WELL + r"Near $x=1$ we have $\ddot x=2-%sx$.", "2", "3"),
        (WELL + r"Near the origin we have $\ddot x=%sx$.", "", "-"),
        (
            FIELD + r"Let $\xi=x-1$. For small $\xi$ and $y$ we have approximately"
            r" $\ddot\xi+%s\dot\xi+2\xi=0$.",
            "k",
            "2k",
        ),
        (
            FIELD + r"Near the point $(1,0)$ we put $x=1+\xi$ and obtain in the first approximation"
            r" $\dot\xi=y$, $\dot y=%s\xi-ky$.",
            "-2",
            "2",
        ),
        (
            FIELD + r"Near $x=1$, $y=0$ we put $x=1+\xi$, $y=\eta$ and obtain the linear system"
            r" $\dot\xi=\eta$, $\dot\eta=-2\xi%sk\eta$.",
            "-",
            "+",
        ),
    ],
)
def test_a_linear_equation_is_judged_at_its_place(text, right, wrong):
    linear = [*verdicts(text % right).values()]
    assert {*linear} <= {*GREEN}
    assert {*verdicts(text % wrong).values()} - {*GREEN}


def test_what_a_linear_system_is_near_is_the_law_and_not_the_linear_one():
    text = FIELD + r"Near $x=1$, $y=0$ we put $x=1+\xi$, $y=\eta$ and obtain the linear system"
    found = verdicts(text + r" $\dot\xi=\eta$, $\dot\eta=-2\xi-k\eta$.")
    assert [*found] == [r"\dot\xi=\eta", r"\dot\eta=-2\xi-k\eta"]


@pytest.mark.parametrize(
    "words",
    [
        r"The points $(0,0,r_0)$ and $(p_0,0,0)$ are equilibria. The linearized equations are",
        r"The point $(0,0,r_0)$ is an equilibrium, $q$ is small. We have",
    ],
)
def test_of_several_places_or_of_none_nothing_is_proved(words):
    found = verdicts(EULER + words + r" $\dot p=(b-c)r_0q$, $\dot q=(c-a)r_0p$.")
    rates = [verdict for formula, verdict in found.items() if formula.startswith(r"\dot")]
    assert {*rates}.isdisjoint(GREEN)


PENDULUM = r"A pendulum moves by \[\ddot\theta=-\frac gl\sin\theta+w^2\sin\theta\cos\theta.\] "
RUSSIAN = PENDULUM.replace("A pendulum moves by", "Рассмотрим уравнение")


@pytest.mark.parametrize(
    ("text", "right", "wrong"),
    [
        (
            PENDULUM + r"The position $\theta=0$ is an equilibrium. The frequency $\Omega$ of small"
            r" oscillations about it is given by the formula $\Omega^2=\frac gl%sw^2$.",
            "-",
            "+",
        ),
        (
            RUSSIAN + r"Положение $\theta=0$ является равновесием. Частота малых колебаний $\Omega$"
            r" около этого положения определяется формулой \[\Omega^2=\frac gl%sw^2.\]",
            "-",
            "+",
        ),
        (
            r"The averaged system is \[\dot J=-\zeta J,\qquad \dot\zeta=\frac{J-T}{Q}.\] It has the"
            r" only equilibrium $J=T,\ \zeta=0$ in $J>0$. The frequency of small oscillations about"
            r" it is \[\Omega=\sqrt{%s}.\]",
            "T/Q",
            "TQ",
        ),
        (
            PENDULUM + r"The period $T$ of small oscillations about $\theta=0$ is"
            r" $T=%s\pi\sqrt{\frac{l}{g-lw^2}}$.",
            "2",
            "",
        ),
        (
            PENDULUM + r"Small oscillations about $\theta=0$ have the period"
            r" $2\pi\left(\frac gl%sw^2\right)^{-1/2}$.",
            "-",
            "+",
        ),
    ],
)
def test_frequencies_and_periods_of_small_oscillations(text, right, wrong):
    assert [*verdicts(text % right).values()][-1] in GREEN
    assert [*verdicts(text % wrong).values()][-1] not in GREEN


def test_a_period_that_is_judged_is_not_told_besides():
    text = PENDULUM + r"The period of small oscillations about $\theta=0$ is $T=%s$."
    judged = reading(text % r"2\pi\sqrt{\frac{l}{g-lw^2}}")
    assert not [one for one in uncovered(judged) if "period" in one.kind]
    longer = PENDULUM + r"The period of the oscillations is $T=2\pi\sqrt{\frac lg}$."
    assert [one for one in uncovered(reading(longer)) if "period" in one.kind]
