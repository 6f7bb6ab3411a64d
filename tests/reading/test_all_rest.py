"""Where words list *the* equilibria, nothing else is at rest; angles are known up to a turn."""

import random

import pytest

from kowalevski_cas.audit.reading import ReadingSession, uncovered
from kowalevski_cas.paper.claims import Union
from kowalevski_cas.verify.outcome import Verdict
from tests.audit.test_doubted import audited
from tests.reading.test_reading import reading, verdicts
from tests.sample import sampled

WELLS = r"The motion is \[ \dot x=y,\qquad\dot y=x-x^3. \] "
PENDULUM = r"The motion is \[ \dot\theta=p,\qquad\dot p=-k\sin\theta. \] "
BEAD = r"The motion is \[ \ddot\theta=\sin\theta(c\cos\theta-k). \] "
AXES = r"The motion is \[ \dot x=yz,\qquad\dot y=-xz,\qquad\dot z=xy. \] "
PREY = r"Let $a>0$, $b>0$. The motion is \[ \dot x=x(a-y),\qquad\dot y=y(x-b). \] "


def of_all(text):
    """What is said of a list that has all that is at rest, and what is told as not covered."""
    found = reading(text)
    session = ReadingSession(found, timeout=5)
    claims = [one.claim for one in found.statements if isinstance(one.claim, Union)]
    return [session.outcomes[claim.id] for claim in claims], uncovered(found)


@pytest.mark.parametrize(
    "text",
    [
        WELLS + r"The equilibria are $(\pm1,0)$ and $(0,0)$.",
        WELLS + r"The equilibria are the points $(0,0)$, $(1,0)$, $(-1,0)$.",
        WELLS + r"The equilibria are $x=0$ and $x=\pm1$.",
        WELLS + r"Fixed points: $(0,0)$, $(\pm1,0)$.",
        WELLS + r"There are exactly three equilibria: $(1,0)$, $(-1,0)$, $(0,0)$.",
        WELLS + r"Положения равновесия: $(0,0)$, $(1,0)$, $(-1,0)$.",
        WELLS.replace("x-x^3", "x+x^3") + r"The only equilibrium is $(0,0)$.",
        PENDULUM + r"The equilibria are $(0,0)$ and $(\pi,0)$.",
        PENDULUM + r"The equilibria are $\theta=0$, $p=0$ and $\theta=\pi$, $p=0$.",
        BEAD + r"The equilibria are $\theta=0$, $\theta=\pi$ and $\cos\theta=k/c$.",
        AXES + r"The equilibria are $x=y=0$, $y=z=0$ and $x=z=0$.",
        PREY + r"The equilibria are $(0,0)$ and $(b,a)$.",
    ],
)
def test_all_that_is_at_rest_is_listed(text):
    [outcome], left = of_all(text)
    assert outcome.verdict.green
    assert not left


@pytest.mark.parametrize(
    "text",
    [
        WELLS + r"The equilibria are given by $x^2=1$, $y=0$.",
        WELLS + r"The equilibria are $(\pm1,0)$.",
        WELLS + r"The equilibria are $x=\pm1$.",
        WELLS + r"Equilibria: $x=\pm1$.",
        WELLS + r"The system has two equilibria, $(1,0)$ and $(-1,0)$.",
        WELLS + r"The only equilibrium is $(0,0)$.",
        WELLS + r"Положения равновесия системы --- $(0,0)$ и $(1,0)$.",
        PENDULUM + r"The equilibria are $(0,0)$.",
        PENDULUM.replace("sin", "cos") + r"The equilibria are $\theta=\pi/2$, $p=0$.",
        BEAD + r"The equilibria are $\theta=0$ and $\theta=\pi$.",
        AXES + r"The equilibria are $x=y=0$ and $x=z=0$.",
        PREY + r"The equilibria are $(b,a)$.",
    ],
)
def test_what_is_left_out_makes_a_list_unsure(text):
    [outcome], _ = of_all(text)
    assert outcome.verdict is Verdict.UNDECIDED


@pytest.mark.parametrize(
    "words",
    [
        r"The equilibria on the right are $(1,0)$.",
        r"The equilibria for $a>0$ are $(1,0)$.",
        r"The points $(\pm1,0)$ are equilibria of saddle type.",
        r"There are three equilibria, among them $(1,0)$.",
    ],
)
def test_what_is_said_of_some_is_told(words):
    outcomes, left = of_all(WELLS + words)
    assert left and not outcomes


def test_points_of_which_some_are_spoken_are_no_list():
    outcomes, left = of_all(WELLS + r"The points $(\pm1,0)$ are equilibria.")
    assert not outcomes and not left


@pytest.mark.parametrize(
    ("angle", "green"),
    [("0", True), (r"\pi", True), (r"-\pi", True), (r"\frac{\pi}{2}", False), (r"\pi/3", False)],
)
def test_an_angle_at_rest_is_known_by_its_sine_and_cosine(angle, green):
    found = verdicts(PENDULUM + rf"The point $({angle},0)$ is an equilibrium.")
    assert found[f"({angle},0)"].green == green
    turned = PENDULUM.replace("sin", "cos")
    found = verdicts(turned + rf"The points $\theta={angle}$, $p=0$ are equilibria.")
    assert found[rf"\theta={angle}"].green == (angle == r"\frac{\pi}{2}")


def test_an_angle_moves_where_its_sine_does_not():
    text = PENDULUM.replace("sin", "cos") + r"The states with $\cos\theta=0$ are equilibria."
    assert not verdicts(text)[r"\cos\theta=0"].green


def a_list(seed):
    """A system of which the states of rest are known, with all of them, or but one, in a list."""
    rnd = random.Random(seed)
    roots = rnd.sample(range(-3, 4), rnd.choice([2, 3]))
    factors = "".join(f"(x{-root:+d})" + rnd.choice(["", "", "^2"]) for root in roots)
    a, b = rnd.choice([1, 2, 3]), rnd.choice([1, 2, 3])
    law, points = rnd.choice(
        [
            (
                rf"\dot x=y,\quad\dot y={factors}{rnd.choice(['', '(1+x^2)'])}",
                [(r, 0) for r in roots],
            ),
            (rf"\dot x=x({a}-y),\quad\dot y=y(x-{b})", [(0, 0), (b, a)]),
            (r"\dot\theta=p,\quad\dot p=-k\sin\theta", [("0", 0), (r"\pi", 0)]),
        ]
    )
    names = (r"\theta", "p") if "theta" in law else ("x", "y")
    whole = rnd.random() < 0.5
    listed = rnd.sample(points, len(points) - (not whole))
    form = rnd.choice(["({2},{3})", r"{0}={2},\;{1}={3}"])
    words = rnd.choice(
        [
            "The equilibria are",
            "Its fixed points are given by",
            "Fixed points:",
            "Положения равновесия:",
        ]
    )
    places = rnd.choice([" and ", ", "]).join(f"${form.format(*names, *one)}$" for one in listed)
    return rf"The motion is \[ {law}. \] {words} {places}.", whole


@pytest.mark.parametrize("seed", sampled(range(60), 6))
def test_a_list_is_green_if_it_has_all(seed):
    text, whole = a_list(seed)
    found = reading(text)
    outcomes = ReadingSession(found, timeout=5).outcomes.values()
    assert all(one.verdict.green for one in outcomes) == whole, text
    assert not (whole and uncovered(found)), text


@pytest.mark.parametrize(
    ("place", "green"), [(r"\theta=\pi", True), (r"\theta=\frac{\pi}{3}", False)]
)
def test_the_audit_says_of_an_angle_what_is_found(place, green):
    found = audited(PENDULUM + rf"An equilibrium is ${place}$, $p=0$.")
    [formula] = [one for one in found.formulas if one.tex.startswith(r"\theta=")]
    assert formula.verdict == (Verdict.PROVED if green else Verdict.UNDECIDED)


FLOW = r"The motion is \begin{equation}\label{f}\dot x=y,\qquad\dot y=xz,\qquad\dot z=-xy .\end{equation} "


@pytest.mark.parametrize(
    "words",
    [
        r"The equilibria of \eqref{f} form the two families \[(k,0,0),\qquad(0,0,k),\qquad k\in\mathbb R.\]",
        r"The equilibria are $(k,0,0)$ and $(0,0,k)$ with arbitrary $k$.",
        r"The equilibria are $A=(k,0,0)$ and $B=(0,0,n)$, where $k$ and $n$ are arbitrary.",
        r"The equilibria fill the lines $(k,0,0)$, $(0,0,k)$.",
    ],
)
def test_families_of_points_are_listed_with_letters_for_any_number(words):
    (outcome,), told = of_all(FLOW + words)
    assert outcome.verdict.green
    assert not told
    assert all(one.green for one in verdicts(FLOW + words).values())
    wrong = FLOW + words.replace("(0,0,k)", "(0,k,k)").replace("(0,0,n)", "(0,n,n)")
    assert {one.green for one in verdicts(wrong).values()} == {True, False}


@pytest.mark.parametrize(
    "words",
    [
        r"The equilibria form the family $(k,0,0)$, $k\in\mathbb R$.",
        r"Their equilibria are $(0,0,0)$.",
    ],
)
def test_families_that_are_left_out_are_told(words):
    found, told = of_all(FLOW + words.replace("Their", "The"))
    assert not any(outcome.verdict.green for outcome in found)
    assert found or told
