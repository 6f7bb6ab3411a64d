"""Places that words name before their equations: “on the plane …”, “the limit cycle, the circle …”."""

import pytest

from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import roles, verdicts

CUBE = r"The equations are \[ \dot x=yz-x(y+z),\quad \dot y=zx-y(z+x),\quad \dot z=xy-z(x+y) . \] "
CYCLE = r"Consider \[ \dot u=\mu u-v-u(u^2+v^2),\qquad \dot v=u+\mu v-v(u^2+v^2) . \] "


@pytest.mark.parametrize("words", ["On the plane $x=y$ we have", "On the line $x=y$ one finds",
                                   "На плоскости $x=y$ имеем"])  # fmt: skip
@pytest.mark.parametrize(("rate", "true"), [(r"\dot x=-x^2", True), (r"\dot x=x^2", False)])
def test_a_rate_on_a_plane(words, rate, true):
    found = verdicts(CUBE + rf"{words} ${rate}$.")[rate]
    assert found.green is true and found is not Verdict.REFUTED


def test_it_holds_there_and_not_in_the_next_sentence():
    text = CUBE + r"On the plane $x=y$ we have $\dot x=-x^2$. Moreover $\dot y=-y^2$."
    assert not verdicts(text)[r"\dot y=-y^2"].green


@pytest.mark.parametrize(
    "words", ["The motion on the plane $x=y$ is slow.", "They meet on the line $x=y$."]
)
def test_where_nothing_is_said_there_nothing_is_supposed(words):
    assert roles(CUBE + words)["x=y"] != "assumption"


@pytest.mark.parametrize(("value", "true"), [(r"\mu", True), (r"2\mu", False)])
def test_a_limit_cycle_is_an_invariant_set(value, true):
    text = rf"{CYCLE} If $\mu>0$, there is one limit cycle, the circle $u^2+v^2={value}$."
    assert [*verdicts(text).values()][-1].green is true


@pytest.mark.parametrize(
    ("words", "claimed"), [("находим", True), ("найдём", True), ("находим из уравнения", False)]
)
def test_what_we_find_is_claimed_and_what_is_found_from_something_is_a_place(words, claimed):
    text = rf"Уравнения движения $$\ddot x=-x-y,\quad\ddot y=-y-x.$$ Складывая их, {words} $$\ddot x+\ddot y+2(x+y)=0.$$"
    found = verdicts(text)
    assert [one.green for one in found.values()] == ([True] if claimed else [])
