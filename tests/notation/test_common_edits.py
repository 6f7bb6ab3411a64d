"""A slip in what is printed once and read several times is undone in all that is read from it."""

import pytest

from kowalevski_cas.notation import Vocabulary, read_display
from kowalevski_cas.notation.common_edits import common_edits, printed_together
from tests.sample import sampled

NAMES = frozenset(f"{letter}_{k}" for letter in "abqprF" for k in "123") | {
    f"m_{{{i}{j}}}" for i in "123" for j in "123"
}
WORDS = Vocabulary(NAMES | {"G", "H"})

SLIPS = [
    (r"F_i=q_i^2+\sum_{j\ne i}\frac{m_{ij}^2}{b_j-b_i},\quad i,j=1,2,3", "b_j-b_i", "b_i-b_j"),
    (r"F_i=q_i^2-p_i^2\quad(i=1,2,3)", "-p", "+p"),
    (r"\dot q_i=2a_iq_i,\quad i=1,2", "2a", "3a"),
    (r"H=\sum_{i\ne j}(q_i^2-b_ip_j^2),\quad i,j=1,2,3", "-b", "+b"),
    (r"H=\sum_{i<j}m_{ij}^2q_ip_j,\quad i,j=1,2,3", "q_ip_j", "q_jp_i"),
    (r"H=\sum_{i\ne j}q_ip_ia_j,\quad i,j=1,2,3", "p_i", "p_j"),
    (r"G=q_1,\quad F_i=q_i^2+2p_i,\quad i=1,2,3", "2p", "p"),
]


def edited(tex):
    """The common edits of each statement of a display, with what is read after them."""
    found = read_display(tex, WORDS)
    for number, statement in enumerate(found, 1):
        for edit in common_edits(found, number, WORDS):
            yield number, statement, edit


@pytest.mark.parametrize(("printed", "slip", "meant"), sampled(SLIPS, 3))
def test_a_slip_is_undone_wherever_it_is_read(printed, slip, meant):
    wanted = [one.formula for one in read_display(printed.replace(slip, meant), WORDS)]
    before = [one.formula for one in read_display(printed, WORDS)]
    wrong = next(k for k, formula in enumerate(before, 1) if formula not in wanted)
    found = [
        {number: edit.formula, **dict(edit.beside)}
        for number, _, edit in edited(printed)
        if number == wrong
    ]
    assert {k: wanted[k - 1] for k in printed_together(printed, wrong)} in found


@pytest.mark.parametrize("printed", sampled([printed for printed, *_ in SLIPS], 2))
def test_an_edit_is_what_is_read_of_its_source(printed):
    for number, statement, edit in edited(printed):
        after = [one.formula for one in read_display(edit.tex, WORDS)]
        changed = {number: edit.formula, **dict(edit.beside)}
        assert {*changed} == {*printed_together(printed, number)}
        before = [one.formula for one in read_display(printed, WORDS)]
        expected = [changed.get(k, formula) for k, formula in enumerate(before, 1)]
        assert after == expected and edit.formula != statement.formula


def test_what_is_read_once_is_left_to_edits_of_one_place():
    for printed in ("G=2q_1-p_1^2", r"H=\sum_{i=1}^3(q_i^2-b_ip_i^2)"):
        assert [*edited(printed)] == []
