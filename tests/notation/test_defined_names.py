"""What a statement defines is read off its TeX as the reader would name it."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kowalevski_cas.notation import Name, NotationError, Power, Vocabulary, defined_names, read


@pytest.mark.parametrize(
    ("tex", "names", "squares", "matrix"),
    [
        (r"L = \begin{pmatrix} a & b \\ b & c \end{pmatrix}", ["L"], [], True),
        (r"x = \begin{vmatrix} a & b \\ b & c \end{vmatrix}", ["x"], [], False),
        (r"L(q,\dot q_1,t) = \dot q_1^2", [r"L(q,\dot{q}_1,t)"], [], False),
        (r"\dot x = 2", [], [], False),
        (r"x = 1", ["x"], [], False),
        (r"A_1  = A_2  = 2A_3", ["A_1", "A_2"], [], False),
        (r"{\bf e}_1  = (1,0,0)", [r"\mathbf{e}_1"], [], False),
        (r"{\bs \gamma}={\bs \alpha}\times{\bs \beta}", [r"\boldsymbol{\gamma}"], [], False),
        (r"z_1^2  + x_1 y_2  = (a^2  - b^2 ) + 2ic = c_1  = {\rm const}", ["c_1"], [], False),
        (r"H = \omega_1^2 + x \equiv h,", ["H", "h"], [], False),
        (r"\varphi(s) = 4ms^2", [r"\varphi(s)"], [], False),
        (r"f(x, y) = x - y", ["f(x,y)"], [], False),
        (r"R_{12}=-w_1^2", ["R_{12}"], [], False),
        (r"\{M_i,\alpha_j\} = -\varepsilon_{ijk}\alpha_k", [r"\{M_i,\alpha_j\}"], [], False),
        (r"({\bs \alpha},{\bs \alpha}) = a^2", [], ["a"], False),
        (r"{\rm cn}^{2} = 1-{\rm sn}^2", [], [r"\mathrm{cn}"], False),
        (r"r^4 = c_1c_2", [], [], False),
        (r"x^{12} = 1", [], [], False),
        (r"\dot x = v", ["v"], [], False),
        (r"x'_1 = 2", [], [], False),
        (r"-x = (y)", [], [], False),
        (r"f(s+1) = 2, \quad", [], [], False),
        (r"x_1 + x_2", [], [], False),
        (r"x", [], [], False),
    ],
)
def test_the_names_that_a_statement_defines(tex, names, squares, matrix):
    (found,) = defined_names(tex)
    assert found[:3] == (tuple(names), tuple(squares), matrix)


def test_broken_tex_is_an_error():
    with pytest.raises(NotationError):
        defined_names(r"x = {1")


LETTERS = st.sampled_from(
    ["x", "H", r"\omega", r"\ell", r"{\bs \alpha}", r"{\bf M}", r"\mathrm{sn}"]
)
INDICES = st.sampled_from(["", "_1", "_{12}", "_i", r"_{\alpha}", " _2", "_{ k }"])


@given(LETTERS, INDICES, st.booleans())
def test_a_name_is_spelt_as_the_reader_spells_it(letter, index, square):
    ((names, squares, *_),) = defined_names(f"{letter}{index}{'^2' * square} = 3")
    (name,) = squares if square else names
    formula = read(f"{letter}{index}{'^2' * square}", Vocabulary(scalars={name}))
    assert (formula.base if square else formula) == Name(name)
    assert isinstance(formula, Power) == square
