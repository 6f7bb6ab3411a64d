"""What a reading must not miss: misprints in formulas that words, and nothing else, call claims."""

import pytest

from kowalevski_cas.reading import ASSUMPTION, CLAIM, LAW
from kowalevski_cas.verify.outcome import Verdict

from .test_reading import reading, roles, verdicts

CENTRAL = r"""
\section{Plane} The equations of motion are
\begin{equation}\label{law}
\ddot r=r\dot\varphi^2-\frac{k}{r^2},\qquad \ddot\varphi=-\frac{2\dot r\dot\varphi}{r}\qquad(r>0).
\end{equation}
"""


def test_a_condition_in_brackets_behind_a_law_is_an_assumption():
    found = roles(CENTRAL)
    assert [*found.values()] == [LAW, LAW, ASSUMPTION]


@pytest.mark.parametrize(("right", "verdict"), [("c", "green"), ("2c", "refuted")])
def test_what_a_rate_of_coordinates_defines_is_known_along_the_motion(right, verdict):
    text = (
        CENTRAL
        + rf"""Let $x=r\cos\varphi$, $y=r\sin\varphi$ and $c=x\dot y-y\dot x$. We find
    \[ r^2\dot\varphi={right} . \]"""
    )
    found = verdicts(text)[rf"r^2\dot\varphi={right}"]
    assert (found.green and verdict == "green") or found == verdict


@pytest.mark.parametrize(
    "words",
    [
        "remains an integral if $k$ is a given function of the time.",
        "is also an integral when $k$ depends on time.",
    ],
)
def test_what_is_said_of_a_law_that_is_not_printed_is_not_judged(words):
    found = reading(CENTRAL + rf"Put $F=r^2\dot\varphi$. The function $F$ {words}")
    last = [f for f in found.formulas if f.item.printed.tex.strip() == "F"][-1]
    assert last.role.name == CLAIM and last.claim is None


def test_the_same_words_without_a_condition_are_judged():
    found = verdicts(CENTRAL + r"Put $F=r^2\dot\varphi$. The function $F$ is an integral.")
    assert found["F"] in (Verdict.PROVED, Verdict.CONDITIONAL)
