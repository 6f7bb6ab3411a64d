"""How a motion begins: a solution, and a relation along it, agree with what is said of that."""

from itertools import product

import pytest

from kowalevski_cas.reading.known import BEGINNING
from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import verdicts
from tests.reading.test_restated import reading
from tests.sample import sampled

GREEN = (Verdict.PROVED, Verdict.CONDITIONAL)
SPRING = r"The spring obeys \[ \ddot u+n^2u=0 . \] "
PHASES = r"The equations of motion are \[ \dot u=v,\qquad \dot v=-n^2u . \] "
SWING = r"The pendulum obeys \[ \ddot\psi+n^2\sin\psi=0 . \] "
STONE = r"A stone falls, \[ \ddot u=-g . \] "

AT_REST = [
    r"It starts at rest from $u=b$. Then ",
    r"If $u(0)=b$ and $\dot u(0)=0$, then ",
    r"Let $u=b$, $\dot u=0$ at $t=0$. We find ",
    r"Initially $u=b$ and $\dot u=0$. Hence ",
    r"With the initial values \[ u(t_0)=b,\qquad \dot u(t_0)=0 \] we have ",
    r"It is released at $u=b$ without initial velocity, and ",
    r"В начальный момент $u=b$, $\dot u=0$. Следовательно, ",
    r"Груз отпущен из состояния покоя при $u=b$. Тогда ",
]
KICKED = [
    r"If $u(0)=0$ and $\dot u(0)=b$, then ",
    r"If $u|_{t=0}=0$ and $\dot u\big|_{t=0}=b$, then ",
    r"At $t=0$ we have $u=0$ and $\dot u=b$. Therefore ",
]
TRUE = [
    *product([SPRING], AT_REST, [r"\[ \dot u^2=n^2(b^2-u^2) . \]"]),
    *product([SPRING], KICKED, [r"\[ \dot u^2=b^2-n^2u^2 . \]", r"\[ u=\frac bn\sin nt . \]"]),
    *product([SPRING], AT_REST[:4], [r"\[ u=b\cos nt . \]"]),
    *product([STONE], KICKED, [r"\[ \dot u^2=b^2-2gu . \]", r"\[ u=bt-\frac12gt^2 . \]"]),
    (SPRING, r"If $u(0)=b$ and $\dot u(0)=0$, then ", r"\[ u(t)=b\cos nt . \]"),
    (STONE, r"If $u(0)=u_0$ and $\dot u(0)=b$, then ", r"\[ u(t)=u_0+bt-\frac12gt^2 . \]"),
    (PHASES, r"Initially $u=b$, $v=0$. Hence ", r"\[ v^2+n^2u^2=n^2b^2 . \]"),
    (PHASES, r"Put $h=v^2+n^2u^2$. Initially $u=0$, $v=b$. Hence ", r"\[ h=b^2 . \]"),
    (STONE, r"It is dropped from the height $u=b$, so that ", r"\[ \dot u^2=2g(b-u) . \]"),
    (SWING, r"It is released at $\psi=b$. Then ", r"\[ \dot\psi^2=2n^2(\cos\psi-\cos b) . \]"),
    (SWING, r"On the separatrix ", r"\[ \dot\psi=2n\cos\frac\psi2 . \]"),
    (SPRING, r"If $u(0)=b$ and $\dot u(0)=0$, then $u=b\cos nt$. The general solution is ",
     r"\[ u=B\cos nt+C\sin nt . \]"),
]  # fmt: skip
FALSE = [
    *product([SPRING], AT_REST, [r"\[ \dot u^2=n^2(4b^2-u^2) . \]", r"\[ u=b\sin nt . \]",
                                 r"\[ u=2b\cos nt . \]"]),
    *product([SPRING], KICKED, [r"\[ \dot u^2=b-n^2u^2 . \]", r"\[ u=b\sin nt . \]",
                                r"\[ u=\frac bn\cos nt . \]"]),
    *product([STONE], KICKED, [r"\[ \dot u^2=2b^2-2gu . \]", r"\[ u=2bt-\frac12gt^2 . \]"]),
    (SPRING, r"If $u(0)=b$ and $\dot u(0)=0$, then ", r"\[ u(t)=b\sin nt . \]"),
    (STONE, r"If $u(0)=u_0$ and $\dot u(0)=b$, then ", r"\[ u(t)=u_0+2bt-\frac12gt^2 . \]"),
    (STONE, r"If $u(0)=u_0$ and $\dot u(0)=b$, then ", r"\[ u(t)=bt-\frac12gt^2 . \]"),
    (STONE, r"If $u(0)=u_0$ and $\dot u(0)=b$, then ", r"\[ u(t)=u_0+bt-gt^2 . \]"),
    (PHASES, r"Initially $u=0$, $v=b$. Hence ", r"\[ v^2+n^2u^2=n^2b^2 . \]"),
    (PHASES, r"Put $h=v^2+n^2u^2$. Initially $u=0$, $v=b$. Hence ", r"\[ h=n^2b^2 . \]"),
    (STONE, r"It is dropped from the height $u=b$, so that ", r"\[ \dot u^2=2g(2b-u) . \]"),
    (STONE, r"It is dropped from the height $b$, so that ", r"\[ u=2b-\frac12gt^2 . \]"),
    (STONE, r"It is thrown from $u=0$ with the velocity $b$. Then ", r"\[ u=2bt-\frac12gt^2 . \]"),
    (SPRING, r"The initial velocity is $b$, and $u=0$ at $t=0$. So ", r"\[ u=b\sin nt . \]"),
    (SPRING, r"The solution that vanishes at $t=0$ is ", r"\[ u=b\cos nt . \]"),
    (SPRING, r"The solution with $u=b$ and $\dot u=0$ for $t=0$ is ", r"\[ u=b\sin nt . \]"),
    (SPRING, r"\[ u(0)=b,\quad\dot u(0)=0 \] are the initial values." "\n\n" r"We obtain ",
     r"\[ u=b\sin nt . \]"),
    (SWING, r"It is released at $\psi=b$. Then ", r"\[ \dot\psi^2=2n^2(\cos\psi+\cos b) . \]"),
    (SWING, r"The amplitude is $b$. Then ", r"\[ \dot\psi^2=2n^2(\cos\psi-\cos2b) . \]"),
    (SWING, r"On the separatrix ", r"\[ \dot\psi=2n\sin\frac\psi2 . \]"),
    (SWING, r"All motions have ", r"\[ \dot\psi=2n\cos\frac\psi2 . \]"),
    (SWING, r"On the separatrix ", r"\[ \dot\psi^2=2n^2(1-\cos\psi) . \]"),
    (SWING, r"At the lowest point $\dot\psi=b$, and at the top ", r"\[ \dot\psi^2=b^2-4n^2 . \]"),
]  # fmt: skip


@pytest.mark.parametrize("law, beginning, claim", sampled(TRUE, 12))
def test_what_agrees_with_the_beginning_is_proved(law, beginning, claim):
    assert [*verdicts(law + beginning + claim).values()][-1] in GREEN


@pytest.mark.parametrize("law, beginning, claim", sampled(FALSE, 14))
def test_what_does_not_is_neither_proved_nor_red(law, beginning, claim):
    found = [*verdicts(law + beginning + claim).values()]
    assert not {*GREEN, Verdict.REFUTED} & {*found}


@pytest.mark.parametrize(
    "text",
    [
        PHASES + r"An orbit that starts on $u=0$ leaves it. Then $v^2+n^2u^2$ is an integral.",
        PHASES + r"Orbits starting at $u=0$ return to it. The function $v^2+n^2u^2$ is constant.",
    ],
)
def test_where_orbits_begin_says_nothing_of_integrals(text):
    assert [*verdicts(text).values()] == [Verdict.PROVED]


def test_a_value_at_the_beginning_is_no_law_and_no_definition():
    text = SPRING + r"Let \[ u(0)=b,\qquad \dot u(0)=c . \]"
    assert [one.role.kind for one in reading(text).formulas][1:] == [BEGINNING, BEGINNING]


def test_a_set_on_which_a_motion_stays_is_no_beginning():
    text = r"The equations are \[ \dot u=uv,\qquad \dot v=-v . \] What starts on $u=0$ stays there."
    assert BEGINNING not in [one.role.kind for one in reading(text).formulas]
