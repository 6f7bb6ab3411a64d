r"""Names by their parts: two prints of one name give it, and two names have two prints."""

import subprocess
import sys
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
    Relation,
    Vocabulary,
    decorations,
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
INDICES = (
    "",
    "1",
    "12",
    "1,2",
    "*",
    "+",
    "-",
    "1+",
    r"\alpha",
    "x_1",
    "n",
    r"\mathrm{eff}",
    r"\mathbf{n}",
)
RAISED_AS = {"": ("",), STAR: ("^*", "^{*}", r"^\ast"), "^+": ("^+", "^{+}"), "^-": ("^-", "^{-}")}
"""How a sign may be raised on a letter."""
TYPES = ("", *(font for font in FONTS if font != r"\mathrm"))
"""A single letter in upright type is the letter."""

accents = st.lists(st.sampled_from(DIACRITICS), max_size=3).map(tuple)
symbols = st.builds(
    Symbol,
    st.sampled_from(LETTERS),
    st.sampled_from(TYPES),
    accents,
    st.sampled_from(["", STAR, "^+", "^-"]),
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
    star = draw(st.sampled_from(RAISED_AS[parts.raised]))
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
    for letter, font, mark, index, star in product(LETTERS[1:], TYPES, marks, INDICES, RAISED_AS):
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
        for star, index, primes in product(RAISED_AS, ("", "1", "n", "+"), ("", "'"))
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


NEW = r"""
import sys
from importlib.util import module_from_spec, spec_from_file_location
spec = spec_from_file_location("kowalevski_cas.notation.decorations", sys.argv[1])
sys.modules[spec.name] = decorations = module_from_spec(spec)
spec.loader.exec_module(decorations)
decorations.ACCENTS[r"\breve"] = decorations.Accent("\u0306", "\u02d8", "breve({})")
decorations.RAISED[r"\dagger"] = decorations.RaisedSign("\u2020", "\u2020", "dag")

from kowalevski_cas.notation import Vocabulary, read, to_latex, to_plain
from kowalevski_cas.notation.mathml import to_mathml
from kowalevski_cas.notation.open import OpenParser
from kowalevski_cas.notation.symbol import symbol
from kowalevski_cas.notation.typst import to_typst
for tex in (r"\breve x_1^{\dag}", r"\breve{x_1^\dagger}", r"\breve{x}^\dagger_1"):
    name = read(tex, Vocabulary(), OpenParser)
    assert to_latex(name) == r"\breve{x}^\dagger_1", to_latex(name)
    assert symbol(name.name).accents == (r"\breve",) and symbol(name.name).index == "1"
    assert read(to_latex(name), Vocabulary(), OpenParser) == name
    print(to_plain(name), to_typst(name), to_mathml(name), ascii(to_plain(name)))
others = to_latex(read(r"x^*+x^{\dagger}+\hat x", Vocabulary(), OpenParser))
assert others == r"x^* + x^\dagger + \hat{x}", others
"""


def test_a_new_decoration_is_a_line_of_one_table(tmp_path):
    """It is read in all ways of writing it, printed in all formats, and no other name."""
    script = tmp_path / "new.py"
    script.write_text(NEW, encoding="utf-8")
    command = [sys.executable, str(script), decorations.__file__]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    (line,) = {*done.stdout.splitlines()}
    assert all(part in line for part in ("†", "breve(", "<mo>˘</mo>", "x\\u0306\\u2081\\u2020"))


@pytest.mark.parametrize("tex", [r"v_\perp", r"v_{\perp}"])
def test_a_direction_is_an_index_and_a_relation_elsewhere(tex):
    words = Vocabulary(scalars=frozenset({r"v_{\perp}", "x", "y"}))
    assert read(tex, words) == Name(r"v_{\perp}")
    assert to_plain(read(f"{tex}^2=x", words)).startswith("v")
    assert read(r"x\perp y", words) == Relation((Name("x"), Name("y")), (r"\perp",))
    with pytest.raises(NotationError):
        read(r"v_{x\perp}", words)
