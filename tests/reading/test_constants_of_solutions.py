"""What is printed behind a solution of its constants: for which of them it is one."""

import pytest

from kowalevski_cas.reading import DEFINITION
from tests.reading.test_restated import reading, verdicts

QUARTIC = r"""The equation of motion is
\begin{equation}\label{law} \ddot q+cq+eq^3=0. \end{equation} """
TRIED = r"We try \[ q=A\operatorname{cn}(pt,m) \] and determine $p$ and $m$ by \eqref{law}:"
CONSTANTS = r"\[ p^2=c+eA^2,\qquad m^2=\frac{eA^2}{2(c+eA^2)}. \]"
GREEN = ("PROVED", "CONDITIONAL")
CN = r"q=A\operatorname{cn}(pt,m)"


def test_a_solution_has_the_constants_that_are_found_behind_it():
    text = QUARTIC + TRIED + CONSTANTS + r"Moreover, \[ 2p^2m^2=eA^2. \]"
    found = verdicts(text)
    assert found[CN] in GREEN and found["2p^2m^2=eA^2"] in GREEN
    assert sum(one.role.name == DEFINITION for one in reading(text).formulas) == 2


@pytest.mark.parametrize(
    "printed, wrong", [("2(c+", "3(c+"), ("p^2=c+", "p^2=c-"), ("{eA^2}", "{eA}")]
)
def test_with_other_constants_it_is_none(printed, wrong):
    text = QUARTIC + TRIED + CONSTANTS.replace(printed, wrong)
    assert verdicts(text)[CN] == "UNDECIDED"


@pytest.mark.parametrize(
    "words",
    [
        r"$q=B\sin(wt)$ is a solution with $w^2=c$.",
        r"A solution is $q=B\sin(wt)$; this works for $w^2=c$.",
        r"A solution is $q=B\sin(wt)$. We find that it fits if \[ w^2=c. \]",
    ],
)
def test_constants_stand_beside_a_solution_or_in_the_next_sentence(words):
    law = r"The equation of motion is \[ \ddot q=-cq. \] "
    assert verdicts(law + words)[r"q=B\sin(wt)"] in GREEN
    assert verdicts(law + words.replace("w^2=c", "w^2=2c"))[r"q=B\sin(wt)"] == "UNDECIDED"


@pytest.mark.parametrize(
    "words",
    [
        r"A solution is $q=B\sin(wt)$. If $w=2$, it has the period $\pi$.",
        r"A solution is $q=B\sin(wt)$. \section{Other springs} There $w^2=c$.",
        r"A solution is $q=B\sin(wt)$. It is known. There are others. For these $w^2=4c$.",
        r"A solution is $q=B\sin(wt)$, where $w^2=cw$.",
        r"A solution is $q=B\sin(wt)$, where $w^2=c+q$.",
    ],
)
def test_other_equations_say_nothing_of_its_constants(words):
    found = verdicts(r"The equation of motion is \[ \ddot q=-cq. \] " + words)
    assert found.get(r"q=B\sin(wt)", "UNDECIDED") == "UNDECIDED"


def test_each_solution_has_its_own_constants():
    text = (
        r"The equation of motion is \[ \ddot q=-cq. \] A solution is $q=B\sin(wt)$, where $w^2=c$. "
    )
    other = r"\section{Growth} Another one is $q=Be^{wt}$, where $w^2=-c$."
    assert {*verdicts(text + other).values()} <= {*GREEN}
    other = r"\section{Growth} Another one is $q=Be^{wt}$, where $w^2=c$."
    assert verdicts(text + other)[r"q=Be^{wt}"] == "UNDECIDED"


DRIFT = r"""The motion is \[ \ddot x-2\dot y=3x,\qquad \ddot y+2\dot x=0 .\] The second equation gives $\dot y+2x=c$
with a constant $c$, and the general solution is \[ x=%s+a\cos(t+b),\qquad y=%s-3ct-2a\sin(t+b) .\]"""


@pytest.mark.parametrize(
    ("x", "y", "green"), [("2c", "d", True), ("c", "d", False), ("2c", "c", False)]
)
def test_a_value_that_words_name_may_be_a_constant_of_the_general_solution(x, y, green):
    found = verdicts(DRIFT % (x, y))
    solved = [found.get(rf"x={x}+a\cos(t+b)"), found.get(rf"y={y}-3ct-2a\sin(t+b)")]
    assert [one in GREEN for one in solved] == [green] * 2


def test_a_rate_that_words_name_is_a_constant_of_all_that_is_solved_together():
    text = r"""The motion is \[ \ddot x=-kx,\qquad\ddot y=0. \] Hence $\dot y=c$ with a constant $c$, and the
    general solution is \[ x=a\cos(\sqrt kt+b),\qquad y=%s. \]"""
    assert verdicts(text % "ct+d")[r"x=a\cos(\sqrt kt+b)"] in GREEN
    assert verdicts(text % "ct").get(r"x=a\cos(\sqrt kt+b)") not in GREEN
    assert verdicts(text % "2ct+d").get("y=2ct+d") not in GREEN


TURNING = r"""The motion is \[ A\dot p=(B-C)qr,\qquad B\dot q=(C-A)rp,\qquad C\dot r=(A-B)pq .\] {CASE} Then $r=r_0$ is
constant, and with $n=\frac{C-A}{A}r_0$ the general solution is \[ p=k\cos(nt+s),\qquad q={SIGN}k\sin(nt+s) .\]"""


@pytest.mark.parametrize(
    ("case", "sign", "green"),
    [("Let $A=B$.", "", True), ("Let $A=B$.", "-", False), ("", "", False)],
)
def test_what_words_keep_constant_is_given_with_a_solution(case, sign, green):
    found = verdicts(TURNING.replace("{CASE}", case).replace("{SIGN}", sign))
    assert (found.get(r"p=k\cos(nt+s)") in GREEN) == green
    assert (found.get(rf"q={sign}k\sin(nt+s)") in GREEN) == green
