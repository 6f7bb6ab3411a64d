r"""Names by their parts: two prints of one name give it, and two names have two prints."""

from itertools import product

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kowalevski_cas.notation import (
    Derivative,
    Name,
    NotationError,
    Number,
    Power,
    Product,
    Vocabulary,
    read,
    to_latex,
    to_plain,
)
from kowalevski_cas.notation.errors import Undeclared
from kowalevski_cas.notation.mathml import to_mathml
from kowalevski_cas.notation.symbol import (
    DIACRITICS,
    FONTS,
    STAR,
    Symbol,
    name_of_rate,
    rate_name,
    symbol,
)
from kowalevski_cas.notation.typst import to_typst

LETTERS = ("x", "q", r"\omega")
INDICES = ("", "1", "12", "1,2", "*", r"\alpha", "x_1", "n", r"\mathrm{eff}", r"\mathbf{n}")
TYPES = ("", *(font for font in FONTS if font != r"\mathrm"))
"""A single letter in upright type is the letter."""

accents = st.lists(st.sampled_from(DIACRITICS), max_size=3).map(tuple)
symbols = st.builds(
    Symbol,
    st.sampled_from(LETTERS),
    st.sampled_from(TYPES),
    accents,
    st.sampled_from(["", STAR]),
    st.sampled_from(INDICES),
)


@st.composite
def prints(draw, parts):
    """A symbol as somebody may print it."""
    text = parts.letter
    if parts.font:
        text = draw(st.sampled_from([f"{parts.font} {text}", f"{parts.font}{{{text}}}"]))
    inner = ""
    index = parts.index if len(parts.index) == 1 else f"{{{parts.index}}}"
    low = f"_{index}" if parts.index else ""
    star = draw(st.sampled_from(["^*", "^{*}", r"^\ast"])) if parts.star else ""
    behind = draw(st.sampled_from([low + star, star + low]))
    if parts.accents and draw(st.booleans()):  # what stands behind, under the innermost accent
        inner, behind = behind, ""
    for accent in reversed(parts.accents):
        text, inner = f"{accent}{{{text}{inner}}}", ""
    return text + behind


def name_of(tex):
    """The name as which a print is read."""
    with pytest.raises(Undeclared) as caught:
        read(tex, Vocabulary())
    return caught.value.name


@given(symbols.flatmap(lambda parts: st.tuples(st.just(parts), prints(parts))))
def test_however_a_name_is_printed_it_has_its_parts(case):
    parts, tex = case
    assert name_of(tex) == parts.name and symbol(parts.name) == parts


@given(symbols, symbols)
def test_names_with_other_parts_are_other_names(one, other):
    assert (one.name == other.name) == (one == other)


@pytest.mark.slow
def test_no_two_prints_of_two_names_are_read_as_one():
    marks = ("", r"\hat", r"\vec", r"\hat\tilde", r"\tilde\hat", r"\hat\hat")
    found = {}
    for letter, font, mark, index, star in product(LETTERS[1:], TYPES, marks, INDICES, ("", "^*")):
        low = f"_{{{index}}}" if index else ""
        tex = f"{mark}{font}{{{letter}}}{low}{star}" if font else f"{mark} {letter}{low}{star}"
        assert found.setdefault(name_of(tex), tex) == tex


@pytest.mark.parametrize("printer", [to_plain, to_mathml, to_typst])
def test_two_names_are_printed_in_two_ways(printer):
    found = {}
    for parts in (
        Symbol("x", font, accents, star, index, primes)
        for font in TYPES
        if font not in (r"\boldsymbol", r"\mathscr") or printer is to_typst
        for accents in ((), *((accent,) for accent in DIACRITICS), DIACRITICS[:2])
        for star, index, primes in product(("", STAR), ("", "1", "n"), ("", "'"))
    ):
        assert found.setdefault(printer(Name(parts.name)), parts) == parts


@given(symbols)
def test_the_formula_of_a_name_reads_back(parts):
    name = Name(parts.name)
    words = Vocabulary(frozenset({parts.name, "a"}))
    dotted = Derivative(name, "dot")
    for formula in (
        name,
        Power(name, Number(2)),
        dotted,
        Derivative(dotted, "dot"),
        Power(dotted, Number(2)),
        Derivative(name, "prime"),
        Product((Name("a"), Power(name, Number(2)))),
        Product((Name("a"), Derivative(name, "prime"))),
    ):
        assert read(to_latex(formula), words) == formula


@given(symbols)
def test_the_rate_of_a_variable_tells_the_variable(parts):
    assert name_of_rate(rate_name(parts.name)) == parts.name


@given(symbols.filter(lambda parts: parts.is_bold))
def test_one_type_for_vectors_is_as_good_as_another(parts):
    for other in parts.in_other_types():
        words = Vocabulary(vectors=frozenset({other.name}))
        assert read(parts.name, words) == Name(other.name)


@pytest.mark.parametrize(
    "tex",
    [
        r"\hat{x+y}", r"\hat 3x", r"\widehat{xy}", r"\hat{(x)}", r"\hat{2x}", r"\hat{x(y)}",
        r"\hat{\frac{x}{y}}", r"\hat{x^2}", r"\hat{}x", r"\hat+x", r"\hat", r"{\hat}x",
    ],
)  # fmt: skip
def test_an_accent_stands_over_one_letter(tex):
    words = Vocabulary(frozenset({"x", "y", r"\hat{x}", r"\hat{y}"}))
    with pytest.raises(NotationError, match="stands over one letter"):
        read(tex, words)


@pytest.mark.parametrize(
    "tex", ["(x)^*", "2^*", "x*y", "x^{**}", "x'^*", "x^{*2}", r"\frac{1}{x}^*", r"\sqrt{x}^*"]
)
def test_a_star_is_raised_on_a_letter(tex):
    with pytest.raises(NotationError, match="is not expected here"):
        read(tex, Vocabulary(frozenset({"x", "y", "x^*"})))


def test_the_type_of_a_letter_ends_before_what_is_no_letter():
    words = Vocabulary(frozenset({"x", r"\mathbf{x}"}))
    assert read(r"\mathbf 3x", words) == Product((Number(3), Name("x")))
