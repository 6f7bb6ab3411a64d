"""Chains that are closed: indices are taken modulo a number, and matrices are given by entries."""

import pytest

from kowalevski_cas.reading.index_ranges import period_in
from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import reading, verdicts

RING = r"""Let $i=1,2,3$; the index is taken modulo three. The equations are
\[ \dot x_i=x_i(x_{i+1}-x_{i-1}) . \] """


@pytest.mark.parametrize(
    ("words", "period"),
    [
        ("the index is taken modulo three", 3),
        ("indices run modulo $4$", 4),
        ("индексы берутся по модулю трём", 3),
        ("the masses are counted modulo three", 0),
        ("the index runs over three values", 0),
    ],
)
def test_words_give_indices_a_period(words, period):
    assert period_in(words, [], {}) == period


def test_a_closed_chain_has_the_integrals_of_its_period():
    found = verdicts(RING + r"The sum $x_1+x_2+x_3$ is constant, and $x_1+2x_2+x_3$ is constant.")
    assert [one.green for one in found.values()] == [True, False]


def test_what_is_claimed_for_all_indices_is_claimed_for_those_beside_the_period():
    claims = r"Put $y_i=x_ix_{i+1}$. Then \[ \dot y_i=y_i(x_{i+2}-x_{i-1}) . \]"
    found = reading(RING + claims)
    rates = [f for f in found.formulas if f.claim is not None]
    assert len(rates) == 3 and all(found == () for found in (f.constants for f in rates))


def test_without_words_a_chain_has_no_period():
    found = reading(RING.replace("taken modulo three", "that of a mass"))
    assert not any(f.item.printed.display.id.startswith("period") for f in found.formulas)


@pytest.mark.slow
def test_what_is_given_by_a_table_is_a_matrix():
    text = r"""The equations are \[ \dot x=y,\qquad \dot y=-x . \] With the matrices
    \[ L=\begin{pmatrix}x&y\\y&-x\end{pmatrix},\qquad M=\begin{pmatrix}0&1\\-1&0\end{pmatrix} \]
    we have \[ 2\dot L=ML-LM,\qquad \dot L=ML-LM . \]"""
    assert sorted(one.green for one in verdicts(text).values()) == [False, True]


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
        (r"Equilibria are the points where \[ a_1=a_2=\dots=a_n. \]", False),
        (r"The points at which $a_1=a_2=\dots=a_n$ are equilibria.", True),
        (r"The points at which $a_2=a_3=\dots=a_n$ are equilibria.", False),
    ],
)
def test_what_else_is_at_rest_is_not_said_for_any_number(words, green):
    text = rf"""The lattice is $${LATTICES[0][0]},\quad i=1,\dots,n,$$ with indices modulo $n$, $n\ge5$. {words}"""
    assert ({*verdicts(text).values()} == {Verdict.PROVED}) == green
