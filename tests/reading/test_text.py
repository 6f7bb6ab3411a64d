"""Sentences that footnotes interrupt: their words go on behind the footnote."""

import pytest

from tests.reading.test_reading import roles, verdicts

TOP = r"""The equations of motion are \[\dot{\mathbf u}=\mathbf u\times\frac{\partial K}{\partial\mathbf u} .\]
"""
FORM = r"\[K=\tfrac12(au_1^2+bu_2^2+cu_3^2) .\]"
ROW = r" Hence \[\dot u_1=(c-b)u_2u_3 .\]"
NOTE = r"\footnote{So it is for a body that is symmetric. If it is not, take other axes.}"


@pytest.mark.parametrize(
    "words",
    [
        f"Throughout we assume that the axes are the principal ones,{NOTE}\n",
        f"We choose the axes{NOTE} so that\n",
        f"The axes are the principal ones.{NOTE} Then the form is\n",
    ],
)
def test_what_a_footnote_says_is_not_said_of_the_formula_behind_it(words):
    form = FORM.strip(r"\[].").strip()
    assert roles(TOP + words + FORM + ROW)[form] == "definition"
    assert [*verdicts(TOP + words + FORM + ROW).values()][-1].green
    wrong = ROW.replace("(c-b)", "(c+b)")
    assert not [*verdicts(TOP + words + FORM + wrong).values()][-1].green


def test_what_a_sentence_supposes_before_a_footnote_holds_behind_it():
    law = r"The equations are \[\dot x=y+ax,\qquad \dot y=-x .\] "
    claim = r"the function $x^2+y^2$ is an integral."
    words = r"Let $a=0$.\footnote{With $a=1$ there is none.} Then "
    assert [one.green for one in verdicts(law + words + claim).values()] == [True]
    wrong = r"Let $a=1$.\footnote{With $a=0$ there is one.} Then "
    assert [one.green for one in verdicts(law + wrong + claim).values()] == [False]


BARE = r"The equations are \[\dot x=y,\qquad \dot y=-x\] "


@pytest.mark.parametrize(
    "words",
    [
        r"The linear part at the origin has the eigenvalues $\pm i$.",
        r"We look at the linearisation. The eigenvalues at $(0,0)$ are $\pm i$.",
        r"If terms of the third order are neglected, this does not change.",
    ],
)
def test_a_word_with_a_capital_behind_a_display_begins_a_sentence(words):
    claim = r" We see that $x^2+y^2$ is constant."
    found = verdicts(BARE + words + claim)
    assert found["x^2+y^2"].green
    assert not verdicts(BARE + words + claim.replace("x^2+", "x^2+2"))["x^2+2y^2"].green
