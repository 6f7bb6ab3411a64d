"""A formula with an index, and the range of that index: a statement for each value."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kowalevski_cas.notation import NotationError, Vocabulary, defined_names, read_display
from kowalevski_cas.notation.latex import to_latex
from kowalevski_cas.notation.open import OpenParser


def statements(tex):
    found = read_display(tex, Vocabulary(times={"t"}), OpenParser)
    return [to_latex(one.formula).replace(" ", "") for one in found]


@given(st.integers(0, 12), st.integers(0, 4))
def test_a_statement_stands_for_all_values_of_its_index(first, more):
    values = range(first, first + more + 2)

    def index(value):
        return str(value) if value < 10 else f"{{{value}}}"

    expected = [rf"\dot{{q}}_{index(k)}=kp_{index(k + 1)}" for k in values]
    every = ",".join(map(str, values))
    assert statements(rf"\dot q_i=kp_{{i+1}},\quad i={every}") == expected
    dots = rf"\dot q_i=kp_{{i+1}} \quad (i={first},\ldots,{values[-1]})"
    assert statements(dots) == expected


@pytest.mark.parametrize(
    ("tex", "expected"),
    [
        (r"x_{ij}=y_ip_j,\ i,j=1,2", "x_{11}=y_1p_1 x_{12}=y_1p_2 x_{21}=y_2p_1 x_{22}=y_2p_2"),
        (r"\{q_i,p_j\}=\delta_{ij},\ i,j=1,2", r"\{q_1,p_1\}=1 \{q_1,p_2\}=0 \{q_2,p_1\}=0 \{q_2,p_2\}=1"),
        (r"x_i=y, i=1,2, \quad z=y_3", "x_1=y x_2=y z=y_3"),
        (r"z=y,\ x_i=iy\ (i=1,2)", "z=y x_1=1y x_2=2y"),
        (r"x_{i+1}=q_{1+2}y_i, i=1,2", "x_2=q_{1+2}y_1 x_3=q_{1+2}y_2"),
        (r"x_i = y_i \quad (i=1,2,\cdots,n)", "x_i=y_i"),
        (r"x_i=\sum_{i=1}^2y_i, i=1,2", r"x_1=\sum_{i=1}^{2}y_i x_2=\sum_{i=1}^{2}y_i"),
        (r"x=\sum_{i\ne j}y_{ij}, i,j=1,2", "x=y_{12}+y_{21}"),
        (r"x=\sum_{i,j}y_{ij}+z, i,j=1,2", "x=(y_{11}+y_{12}+y_{21}+y_{22})+z"),
        (r"x=2\sum_{1\leqslant i<j\leqslant3}y_i z_j", "x=2(y_1z_2+y_1z_3+y_2z_3)"),
        (r"x=\sum_{i=1}^2\sum_{j<i}(y_{ij}+z), j=1,2", "x=0+(y_{21}+z)"),
        (r"x_i=y_i\prod_{j\ne i}z_j,\ i,j=1,2,3", r"x_1=y_1\cdot(z_2z_3) x_2=y_2\cdot(z_1z_3) x_3=y_3\cdot(z_1z_2)"),
        (r"x=\frac{1}{\prod_{j=1}^2(y+z_j)^2}", r"x=\frac{1}{(y+z_1)^2(y+z_2)^2}"),
        (r"x=y^{2}\prod_{j=1}^2z_j", r"x=y^2\cdot(z_1z_2)"),
        (r"x=2y/\prod_{j=2}^3z_j", r"x=\frac{2y}{z_2z_3}"),
        (r"x=\sum_{i=1}^2\sum_{j=1}^2a_{ij}y_j", r"x=(a_{11}y_1+a_{12}y_2)+(a_{21}y_1+a_{22}y_2)"),
        (r"x_{i+2}=x_i, i=1,2", "x_2=x_0 x_3=x_1 x_4=x_2"),
        (r"x_i=x_{i+2}\quad(i=0,1)", "x_0=x_2 x_1=x_3"),
        (r"\begin{align} x_i &= y, \\ z_i &= y, & i&=1,2 \end{align}", "x_1=y x_2=y z_1=y z_2=y"),
    ],
)  # fmt: skip
def test_what_a_range_says(tex, expected):
    assert statements(tex) == expected.split()


@given(st.integers(1, 5), st.sampled_from(["<", r"\le", ">", r"\ge", r"\ne"]), st.booleans())
def test_a_sum_has_the_terms_that_are_printed_below_it(n, sign, free):
    """Of an index beside another one, which is that of the statement, or also of the sum."""
    holds = {"<": int.__lt__, r"\le": int.__le__, ">": int.__gt__, r"\ge": int.__ge__}
    every = range(1, n + 2)
    pairs = [(j, i) for j in every for i in every if holds.get(sign, int.__ne__)(j, i)]

    def total(i=None):
        terms = [f"a_{{{j}{k}}}y_{j}" for j, k in sorted(pairs) if i in (None, k)]
        return "+".join(terms) or "0"

    expected = [f"x_{i}={total(i)}" for i in every] if free else [f"x={total()}"]
    left, values = "x_i" if free else "x", ",".join(map(str, every))
    assert statements(rf"{left}=\sum_{{j{sign} i}}a_{{ji}}y_j,\quad i,j={values}") == expected


@given(st.sampled_from(["1", "i"]), st.sampled_from(["i", "4"]))
def test_the_limits_of_a_sum_hold_whatever_the_range_of_its_index_is(first, last):
    def total(i):
        low, high = (i if end == "i" else int(end) for end in (first, last))
        return "+".join(f"y_{j}z_{i}" for j in range(low, high + 1))

    tex = rf"x_i=\sum_{{j={first}}}^{{{last}}}y_jz_i,\quad i,j=1,2,3,4"
    assert statements(tex) == [f"x_{i}={total(i)}" for i in range(1, 5)]


def test_what_is_defined_has_the_values_as_indices():
    assert [one.names for one in defined_names(r"L_i=2q_{i+1},\ i=1,2")] == [("L_1",), ("L_2",)]


@pytest.mark.parametrize(
    ("tex", "message"),
    [
        ("x=1,2", "a decimal comma"),  # x is no index
        (r"a_{1i}=x_i, i=1,2", "a product, or several indices"),
        (r"x_{2i}=y, i=1,2", "a product, or several indices"),
        (r"x_{i-2}=y, i=1,2", "a product, or several indices"),
        (r"x_{ij}=y, i,j=9,10", "a product, or several indices"),
        (r"x_i=y^i, i=1,2", "is this a power or an index"),
        (r"x_i=\sum_{j=1}^iy_j, i=1,2", "is this a power or an index"),
        (r"x=\prod_jy_j", "print where the product ends"),
        (r"x=\prod_{j=1}^2y_jz", "how far does .* reach"),
        (r"x=\prod_{j=1}^2y_j/z_j", "how far does .* reach"),
        (r"x=\sum_j", "print where the sum begins and ends"),
        (r"x=\sum_{i<j}y_{ij}", "print where the sum begins and ends"),
        (r"x=\sum_{i<2j}y_{ij}, i,j=1,2", "print where the sum begins and ends"),
        (r"x=\sum_{j=1}^{n}y_{kj}, x_i=\sum_{j\ne k}y_{ij}, i=1,2", "print where the sum begins"),
        (r"x=\sum_{j=1,3}y_jz_1, j=1,2,3", "not expected"),
        (r"x_i=\sum_{j\ne i}^{2}y_j, i,j=1,2,3", "print where the sum begins"),
        (r"x_i=\sum_{j=i}y_jz_i, i,j=1,2", "print where the sum begins"),
        (r"x_i=y, i=1,2, z_i=y, i=3,4", "a second range of i"),
    ],
)
def test_what_a_range_does_not_say(tex, message):
    with pytest.raises(NotationError, match=message):
        statements(tex)


@pytest.mark.parametrize("tex", [r"{\dot x}_1={a+b}c", r"x={a+b}, {\rm e}_1={y}", "{{x}}=2"])
def test_a_statement_has_both_its_braces(tex):
    for one in read_display(tex, Vocabulary(), OpenParser):
        assert one.source.count("{") == one.source.count("}")
        (again,) = read_display(one.source, Vocabulary(), OpenParser)
        assert again.formula == one.formula


@pytest.mark.parametrize(
    ("printed", "kept"),
    [
        (r"(i\ne j)", lambda i, j: i != j),
        (r"i<j", lambda i, j: i < j),
        (r"(i\ge j)", lambda i, j: i >= j),
    ],
)
def test_what_is_printed_of_indices_alone_says_for_which_values(printed, kept):
    tex = rf"x_i+x_j,\quad {printed},\quad i=1,2,3,\quad j=1,2,3"
    words = Vocabulary(scalars=frozenset({"x_1", "x_2", "x_3"}))
    wanted = [(i, j) for i in (1, 2, 3) for j in (1, 2, 3) if kept(i, j)]
    found = [one.formula for one in read_display(tex, words)]
    assert found == [read_display(f"x_{i}+x_{j}", words)[0].formula for i, j in wanted]


@pytest.mark.parametrize("printed", [r"(i\ne i)", r"i<j,\quad j<i", r"(i<j),\quad (j\le i)"])
def test_where_no_value_of_the_indices_is_left_nothing_is_said(printed):
    tex = rf"x_i=x_j,\quad {printed},\quad i=1,2,3,\quad j=1,2,3"
    with pytest.raises(NotationError, match="no values of the indices are left"):
        read_display(tex, Vocabulary(scalars=frozenset({"x_1", "x_2", "x_3"})))
