"""Chains that are closed: indices are taken modulo a number, and matrices are given by entries."""

import pytest

from kowalevski_cas.reading.index_ranges import period_in
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
