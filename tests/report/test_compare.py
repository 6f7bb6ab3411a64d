"""Where two formulas differ: both are printed as without marks, and no brackets are lost."""

import re
from math import prod
from xml.etree import ElementTree

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kowalevski_cas.notation import (
    Name,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Root,
    edits,
    read,
    read_display,
    to_latex,
    to_plain,
)
from kowalevski_cas.notation.formula import Changed
from kowalevski_cas.notation.mathml import to_mathml
from kowalevski_cas.report.compare import mark_differences, ratio_of_sides, without_marks
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


SMALL = st.integers(-1, 1)


@given(SMALL, SMALL, st.integers(-2, 2), st.booleans())
def test_the_ratio_of_the_sides_is_what_was_forgotten(x, ell, root, negative):
    """Whatever stands beside it, and whether it was forgotten or put below the line."""
    own = {r"x_1": x, r"\ell": ell, r"\sqrt{x_1\ell}": root}
    parts = {1: [r"(i+a)"], -1: [r"(d+1)"]}
    for factor, exponent in own.items():
        parts[1 if exponent > 0 else -1] += [factor] * abs(exponent)
    right = rf"{'-' * negative}\frac{{{''.join(parts[1])}}}{{{''.join(parts[-1])}}}"
    printed, meant = (read(f"m={side}", WORDS) for side in (r"\frac{i+a}{d+1}", right))
    ratio = ratio_of_sides([printed], [meant])
    value = (-1) ** negative * 4.0**x * 9.0**ell * 6.0**root
    if ratio is None:
        assert value == 1
    else:
        at = {"x_1": 4.0, r"\ell": 9.0}
        assert abs(evaluate(ratio, at) - value) < 1e-9


def evaluate(formula, at):
    """A value of a ratio of powers."""
    match formula:
        case Number(value):
            return value
        case Name(name):
            return at[name]
        case Negative(argument):
            return -evaluate(argument, at)
        case Root(argument):
            return evaluate(argument, at) ** 0.5
        case Quotient(above, below):
            return evaluate(above, at) / evaluate(below, at)
        case Power(base, exponent):
            return evaluate(base, at) ** evaluate(exponent, at)
        case Product(factors):
            return prod(evaluate(factor, at) for factor in factors)
    raise AssertionError(formula)


@pytest.mark.parametrize("meant", ["m=i-a", "m=i+a+d", "m+1=i+a", r"m=\frac{i+a}{d+1}"])
def test_a_ratio_that_is_long_explains_nothing(meant):
    assert ratio_of_sides([read("m=i+a", WORDS)], [read(meant, WORDS)]) is None


@pytest.mark.parametrize("printer", [to_mathml, to_latex])
def test_of_terms_that_differ_by_a_sign_the_sign_is_marked(printer):
    pair = [read("m=i+a", WORDS)], [read("m=i-a", WORDS)]
    for (formula,), sign in zip(mark_differences(*pair), "+-", strict=True):
        marked = formula.members[1].terms[1]
        assert marked.sign and printer(without_marks(formula)) != printer(formula)
        shown = to_latex(formula)
        assert f"{{{sign}}}" in shown and shown.endswith("a")
