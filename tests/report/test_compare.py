"""Where two formulas differ: both are printed as without marks, and no brackets are lost."""

import re
from xml.etree import ElementTree

from hypothesis import given
from hypothesis import strategies as st

from kowalevski_cas.notation import edits, read_display, to_latex, to_plain
from kowalevski_cas.notation.formula import Changed
from kowalevski_cas.notation.mathml import to_mathml
from kowalevski_cas.report.compare import mark_differences, without_marks
from tests.notation.strategies import WORDS, formulas


@st.composite
def pairs(draw):
    """A formula, and what one slip of the pen makes of it."""
    (statement, *_) = read_display(to_latex(draw(formulas)), WORDS)
    found = list(edits(statement, WORDS))
    other = draw(st.sampled_from(found)).formula if found else statement.formula
    return statement.formula, other


def letters(formula):
    return "".join(ElementTree.fromstring(f"<math>{to_mathml(formula)}</math>").itertext())


def unbraced(formula):
    """The LaTeX of a formula without marks, braces and spaces; a bracket may be tall or not."""
    return re.sub(r"\\(Slip|Meant)|\\left|\\right|[{} ]", "", to_latex(formula))


@given(pairs())
def test_marks_are_all_that_is_added(pair):
    for plain, marked in zip(
        pair, [one for (one,) in mark_differences(pair[:1], pair[1:])], strict=True
    ):
        assert to_plain(without_marks(marked)) == to_plain(plain)
        assert letters(marked) == letters(plain)
        assert unbraced(marked) == unbraced(plain)


def marks(formula):
    """The parts of a formula with a mark."""
    if isinstance(formula, Changed):
        return [formula]
    return [mark for child in formula.children() for mark in marks(child)]


@given(pairs())
def test_what_differs_is_marked(pair):
    (printed,), (meant,) = mark_differences(pair[:1], pair[1:])
    assert (printed != pair[0] or meant != pair[1]) == (pair[0] != pair[1])
    assert all(mark.wrong for mark in marks(printed))
    assert not any(mark.wrong for mark in marks(meant))


def test_a_slip_of_one_letter():
    (old, new), _ = read_display(r"x_1=i\ell, x_1=ia", WORDS), 0
    (printed,), (meant,) = mark_differences((old.formula,), (new.formula,))
    assert [to_plain(mark.argument) for mark in (*marks(printed), *marks(meant))] == ["ℓ", "a"]
