"""What a statement defines is read off its TeX as the reader would name it."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kowalevski_cas.notation import Name, NotationError, Power, Vocabulary, heads, read


@pytest.mark.parametrize(
    ("tex", "names", "squares"),
    [
        (r"x = 1", ["x"], []),
        (r"A_1  = A_2  = 2A_3", ["A_1", "A_2"], []),
        (r"{\bf e}_1  = (1,0,0)", [r"\mathbf{e}_1"], []),
        (r"{\bs \gamma}={\bs \alpha}\times{\bs \beta}", [r"\boldsymbol{\gamma}"], []),
        (r"z_1^2  + x_1 y_2  = (a^2  - b^2 ) + 2ic = c_1  = {\rm const}", ["c_1"], []),
        (r"H = \omega_1^2 + x \equiv h,", ["H", "h"], []),
        (r"\varphi(s) = 4ms^2", [r"\varphi(s)"], []),
        (r"f(x, y) = x - y", ["f(x,y)"], []),
        (r"R_{12}=-w_1^2", ["R_{12}"], []),
        (r"\{M_i,\alpha_j\} = -\varepsilon_{ijk}\alpha_k", [r"\{M_i,\alpha_j\}"], []),
        (r"({\bs \alpha},{\bs \alpha}) = a^2", [], ["a"]),
        (r"{\rm cn}^{2} = 1-{\rm sn}^2", [], [r"\mathrm{cn}"]),
        (r"r^4 = c_1c_2", [], []),
        (r"x^{12} = 1", [], []),
        (r"\dot x = v", ["v"], []),
        (r"x'_1 = 2", [], []),
        (r"-x = (y)", [], []),
        (r"f(s+1) = 2, \quad", [], []),
        (r"x_1 + x_2", [], []),
        (r"x", [], []),
    ],
)
def test_the_names_that_a_statement_defines(tex, names, squares):
    ((found, found_squares),) = heads(tex)
    assert (list(found), list(found_squares)) == (names, squares)


def test_broken_tex_is_an_error():
    with pytest.raises(NotationError):
        heads(r"x = {1")


LETTERS = st.sampled_from(
    ["x", "H", r"\omega", r"\ell", r"{\bs \alpha}", r"{\bf M}", r"\mathrm{sn}"]
)
INDICES = st.sampled_from(["", "_1", "_{12}", "_i", r"_{\alpha}", " _2", "_{ k }"])


@given(LETTERS, INDICES, st.booleans())
def test_a_name_is_spelt_as_the_reader_spells_it(letter, index, square):
    ((names, squares),) = heads(f"{letter}{index}{'^2' * square} = 3")
    (name,) = squares if square else names
    formula = read(f"{letter}{index}{'^2' * square}", Vocabulary(scalars={name}))
    assert (formula.base if square else formula) == Name(name)
    assert isinstance(formula, Power) == square
