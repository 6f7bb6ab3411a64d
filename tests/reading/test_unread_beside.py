"""What cannot be read takes nothing from the statements that stand in its display."""

import pytest

from kowalevski_cas.verify.outcome import Verdict
from tests.audit.test_doubted import audited
from tests.reading.test_reading import reading, verdicts

LAW = r"The motion is \[ \ddot x=-x. \] Put $E=\frac12(\dot x^2+x^2)$. Then "
UNREAD = [
    r"\frac1{2\pi}\oint\dot x\,dx=E",
    r"\lim_{t\to\infty}\frac xt=0",
    r"\int_0^T\dot x^2\,dt=J",
]


@pytest.mark.parametrize("unread", UNREAD)
def test_the_others_are_judged(unread):
    for claim, verdict in ((r"\dot E=0", Verdict.PROVED), (r"\dot E=x", Verdict.REFUTED)):
        for display in (rf"{unread},\qquad {claim}", rf"{claim},\qquad {unread}"):
            assert verdicts(LAW + rf"\[ {display}. \]")[claim] is verdict


def test_a_law_has_its_other_equations():
    law = r"Further \[ \dot y=x,\qquad \oint\dot x\,dx=E,\qquad \dot z=y^2. \] "
    assert verdicts(LAW + law + r"Then \[ \ddot z=2xy. \]")[r"\ddot z=2xy"].green
    assert not verdicts(LAW + law + r"Then \[ \ddot z=2x. \]")[r"\ddot z=2x"].green


@pytest.mark.parametrize(
    "display",
    [
        r"\dot E=x,\qquad t\to\infty",
        r"\dot E=x,\qquad \text{if }\oint x\,dx=0",
        r"\dot E=x,\qquad T=2\pi\to\infty",
    ],
)
def test_what_may_be_a_condition_leaves_nothing_to_refute(display):
    assert Verdict.REFUTED not in verdicts(LAW + rf"\[ {display}. \]").values()


def test_each_stands_once_in_the_list():
    found = reading(LAW + rf"\[ {UNREAD[0]},\qquad\dot E=0. \]").formulas
    assert [one.item.printed.tex.strip(" .") for one in found][-2:] == [UNREAD[0], r"\dot E=0"]


@pytest.mark.parametrize(("claim", "verdict"), [(r"\dot E=0", "proved"), (r"\dot E=x", "refuted")])
def test_the_report_has_the_others_at_their_places(claim, verdict):
    display = rf"\begin{{equation}}\label{{a}} {UNREAD[0]},\qquad {claim}. \end{{equation}}"
    found = [one for one in audited(LAW + display).formulas if one.tex.strip(" .") == claim]
    assert [(one.verdict, one.label) for one in found] == [(verdict, "a")]


def test_comments_count_all_statements_of_a_formula():
    display = rf"\[ {UNREAD[0]},\qquad\dot E=x. \]"
    assert Verdict.REFUTED in verdicts(LAW + display).values()
    said = verdicts(LAW + "\n%kc: 2 skip\n" + display)
    assert Verdict.REFUTED not in said.values()


@pytest.mark.parametrize("between", [r",\quad ", r".\] Here \["])
def test_vectors_by_which_what_moves_is_given_are_not_constant(between):
    law = r"With the tensor of inertia $\mathbf A$ \[\dot{\mathbf G}=\mathbf G\times\mathbf w"
    text = rf"{law}{between}\mathbf G=\mathbf A\mathbf w+\mathbf A.\] "
    assert not verdicts(text + r"Then $(\mathbf G,\mathbf w)$ is an integral.")
