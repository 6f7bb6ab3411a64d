"""Indices that are taken modulo a number: what is said of neighbours closes no chain."""

import pytest

from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import verdicts

LATTICES = [
    (r"\dot a_i=a_i(a_{i+1}-a_{i-1})", "a", r"H=\sum_{i=1}^n a_i", r"H=\sum_{i=1}^n ia_i"),
    (r"\dot u_i=u_{i+1}-u_{i-1}", "u", r"H=\sum_{i=1}^n u_i^2", r"H=\sum_{i=1}^n iu_i^2"),
]
SAID = [
    "They are at rest if and only if ${0}_{{i+1}}={0}_{{i-1}}$ for all $i$.",
    "Nothing moves where ${0}_{{i-1}}={0}_{{i+1}}$ for $i=1,\\dots,n$.",
    "",
]


@pytest.mark.parametrize("said", SAID)
@pytest.mark.parametrize(("row", "letter", "true", "false"), LATTICES)
def test_neighbours_that_are_equal_somewhere_leave_the_period(row, letter, true, false, said):
    law = rf"The lattice is $${row},\quad i=1,\dots,n,$$ where the indices are taken modulo $n$, $n\ge4$. "
    for claim, verdict in ((true, Verdict.PROVED), (false, Verdict.REFUTED)):
        text = law + rf"The function ${claim}$ is an integral. " + said.format(letter)
        assert next(iter(verdicts(text).values())) == verdict


BRACKETS = r"""The lattice is $$\dot x_i={ROW},\quad i=1,\dots,n,$$ with indices modulo $n$. Let $n=5$.
The bracket is given by \[ \{x_i,x_{i+1}\}={GIVEN}; \] all others vanish. Let $H=x_1+x_2+x_3+x_4+x_5$.
Then \[ {CLAIM} \]"""


@pytest.mark.parametrize(
    ("row", "given"),
    [(r"x_i(x_{i+1}-x_{i-1})", r"x_ix_{i+1}"), (r"x_i^2(x_{i+1}^2-x_{i-1}^2)", r"x_i^2x_{i+1}^2")],
)
@pytest.mark.parametrize(
    ("claim", "green"),
    [(r"\dot x_i=\{x_i,H\}.", True), (r"\{H,x_5\}=-\dot x_5.", True),
     (r"\dot x_i=\{H,x_i\}.", False), (r"\{H,x_5\}=\dot x_5.", False)],
)  # fmt: skip
def test_brackets_of_neighbours_close_the_chain(row, given, claim, green):
    text = BRACKETS.replace("{ROW}", row).replace("{GIVEN}", given).replace("{CLAIM}", claim)
    found = {*verdicts(text).values()}
    assert (found == {Verdict.PROVED}) == green


@pytest.mark.parametrize(
    ("words", "green"),
    [
        (r"The only equilibria are the points at which \[ a_1=a_2=\dots=a_n. \]", False),
        (r"All equilibria are the points where \[ a_1=a_2=\dots=a_n. \]", False),
        (r"Equilibria are the points where \[ a_1=a_2=\dots=a_n. \]", True),
        (r"The points at which $a_1=a_2=\dots=a_n$ are equilibria.", True),
        (r"The points at which $a_2=a_3=\dots=a_n$ are equilibria.", False),
    ],
)
def test_what_else_is_at_rest_is_not_said_for_any_number(words, green):
    text = rf"""The lattice is $${LATTICES[0][0]},\quad i=1,\dots,n,$$ with indices modulo $n$, $n\ge5$. {words}"""
    assert ({*verdicts(text).values()} == {Verdict.PROVED}) == green
