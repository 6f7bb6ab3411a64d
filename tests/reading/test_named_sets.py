"""Sets that have names, and what is said on them."""

import pytest

from kowalevski_cas.reading import CLAIM, DEFINITION
from kowalevski_cas.reading.named_sets import without_set_names
from kowalevski_cas.source.displays import find_formulas
from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import reading, roles, verdicts

FLOW = r"""The motion is
\begin{equation}\label{flow}
\dot x=y+xz,\qquad \dot y=-x+yz,\qquad \dot z=1-z-x^2-y^2 .
\end{equation}
"""


@pytest.mark.parametrize(
    ("tex", "name", "left"),
    [
        (r"$\Gamma=\{f=0\}$", r"\Gamma", "f=0"),
        (r"$\mathcal C:\quad u^2+v^2=1,\ w=0$", r"\mathcal C", r"u^2+v^2=1,\ w=0"),
        (r"$E_1:\ u=v$", "E_1", "u=v"),
        (r"$a:b=2:1$", "", "a:b=2:1"),
        (r"$M=\{1,2\}$", "", r"M=\{1,2\}"),
        (r"$L=\{p,q\}=1$", "", r"L=\{p,q\}=1"),
    ],
)
def test_a_name_of_a_set_stands_before_its_equations(tex, name, left):
    ((formula, found),) = without_set_names(find_formulas(tex))
    assert found == name and formula.tex.strip() == left


@pytest.mark.parametrize("named", [r"$\Gamma=\{z=0\}$", r"$\Gamma:\ z=0$"])
def test_what_is_said_on_a_named_set_is_said_where_its_equations_hold(named):
    text = FLOW + rf"Consider the plane {named}. On $\Gamma$ we have \[\dot x=y.\] "
    assert verdicts(text)[r"\dot x=y"].green
    false = text.replace(r"\[\dot x=y", r"\[\dot x=2y")
    assert verdicts(false)[r"\dot x=2y"] is Verdict.UNDECIDED


def test_what_is_said_elsewhere_is_not_said_on_the_set():
    text = FLOW + r"Consider the plane $\Gamma=\{z=0\}$. The first equation gives \[\dot x=y.\]"
    assert not verdicts(text)[r"\dot x=y"].green


def test_the_equations_of_a_named_set_define_it():
    assert roles(FLOW + r"Consider the plane $\Gamma=\{z=0\}$.").popitem()[1] == DEFINITION


def test_what_follows_a_set_with_where_is_said_of_it():
    text = r"The motion is \[\dot x=-x+yw,\qquad \dot y=-y-xw,\] where $w=x^2-c^2$ with a constant $c$. "
    said = r"The circle is given by \[K:\quad x^2+y^2=c^2,\] where $w=-y^2$. Otherwise $w=-y^2$."
    found = [f for f in reading(text + said).formulas if f.item.printed.tex == "w=-y^2"]
    assert found[0].role.name == CLAIM
    assert [o.printed.tex.strip(" \n") for o in found[0].on] == ["x^2+y^2=c^2"]
    assert not found[1].on


def test_a_restriction_that_is_dropped_is_not_supposed():
    text = FLOW + r"Without the restriction $z=0$ we have \[\dot x=y.\]"
    assert not verdicts(text)[r"\dot x=y"].green
    assert roles(text)["z=0"] not in ("assumption", CLAIM)


def test_a_display_gives_a_point_at_rest():
    text = r"The motion is \[\dot x=y,\qquad \dot y=b-x^2y-cx.\] There is one more equilibrium, due to nobody, \begin{equation}x=\frac bc,\quad y=0.\end{equation}"
    found = verdicts(text)
    assert [one.green for one in found.values()] == [True]
    false = text.replace(r"\frac bc", r"\frac cb")
    assert not any(one.green for one in verdicts(false).values())
