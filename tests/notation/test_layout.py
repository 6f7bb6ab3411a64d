"""A display falls into the statements that its author meant."""

import pytest

from kowalevski_cas.notation import NotationError, Vocabulary, read_display, split_display, to_latex
from kowalevski_cas.notation import read as read_formula
from kowalevski_cas.notation.layout import statements
from tests.notation import paper


def parts(tex):
    return [tex[start:end] for start, end in split_display(tex)]


COUNTS = {
    "eq1": 1, "eq2": 1, "eq3": 2, "eq4": 3, "kowalevski-case": 3, "eq5": 3, "eq9": 8, "eq10": 9,
    "eq11": 3, "c": 2, "eq13": 3, "U-prime": 2, "eq14": 1, "F-prime": 2, "real-form": 2,
    "eq16": 2, "eq17": 2, "eq18": 1, "eq19": 1, "ratio": 1, "eq20": 2, "eq21": 1,
}  # fmt: skip


@pytest.mark.parametrize("name", COUNTS)
def test_the_displays_of_the_paper_have_as_many_statements_as_rows_say(name):
    assert len(split_display(paper.DISPLAYS[name])) == COUNTS[name]


def test_a_row_that_ends_in_a_sign_runs_on_and_a_repeated_sign_is_one():
    second = read_display(paper.DISPLAYS["eq16"], paper.WORDS)[1].formula
    assert to_latex(second) == (
        r"2[c(\xi_1^2 - \xi_2^2) - (a^2 - b^2)\xi_1\xi_2](\omega_1^2 - \omega_2^2 + \xi_1)"
        r" + [(a^2 - b^2)(\xi_1^2 - \xi_2^2) + 4c\xi_1\xi_2](2\omega_1\omega_2 + \xi_2) = 0"
    )
    [psi] = read_display(paper.DISPLAYS["eq21"], paper.WORDS)
    assert len(psi.formula.members[1].terms) == 2


def test_nested_arrays_are_rows_and_cells():
    assert parts(paper.DISPLAYS["eq10"])[::4] == [
        "x'_1  =  - x_1 w_3  + z_1 w_1",
        "2z'_1  = x_1 w_2  - y_2 w_1",
        r"2\omega'_3 = y_2  - y_1",
    ]


@pytest.mark.parametrize(
    ("tex", "expected"),
    [
        ("a = 0, b = 0", ["a = 0", "b = 0"]),
        (r"$a=0$", ["a=0"]),
        (r"\[ a = 0,\qquad b = 0. \]", ["a = 0", "b = 0"]),
        (r"a = 0 \quad b = 0", ["a = 0", "b = 0"]),
        (r"a = b \qquad (c > 0).", ["a = b", "c > 0"]),
        (r"a = b \qquad ((c+d) \ne 0)", ["a = b", r"(c+d) \ne 0"]),
        (r"a = 0 \text{ and } b = 0", ["a = 0", "b = 0"]),
        (r"a = b \quad + c", [r"a = b \quad + c"]),
        (r"\begin{align} a &= b, \\ c &= d \end{align}", ["a &= b", "c &= d"]),
        (r"\begin{align*} a &= b \\ &= c \\ &= d \end{align*}", [r"a &= b \\ &= c \\ &= d"]),
        (r"\begin{eqnarray} a &=& b + \\ && + c \end{eqnarray}", [r"a &=& b + \\ && + c"]),
        (r"\begin{aligned} a & = b \\ & - c \end{aligned}", [r"a & = b \\ & - c"]),
        (r"a = b \\[-2mm] -c = d", ["a = b", "-c = d"]),
        (r"F = (a+b) \\ (c+d) = 0", [r"F = (a+b)", "(c+d) = 0"]),
        (r"(a+b) \\ \times (c+d) = 0", [r"(a+b) \\ \times (c+d) = 0"]),
        (r"a = (b \\ + c)", [r"a = (b \\ + c)"]),
        (r"\left\{\begin{array}{l} a=0,\\ b=0 \end{array}\right.", ["a=0", "b=0"]),
        (r"\left\{\begin{array}{l} a=0,\\ b=0 \end{array}\right\}", ["a=0", "b=0"]),
        (r"\begin{array}{@{}l@{}} a=0 \cr b=0 \end{array}", ["a=0", "b=0"]),
        (r"a = (b, c)", ["a = (b, c)"]),
        (r"a = b \eqno(12)", ["a = b"]),
        (r"\begin{align} a &= b \\ \Rightarrow c &= d \end{align}", ["a &= b", "c &= d"]),
        (r"a = b \\ & \implies\quad -c = d", ["a = b", "-c = d"]),
        (r"a = b \quad\Rightarrow\quad c = d", [r"a = b \quad\Rightarrow\quad c = d"]),
        (r"a = b \tag{12} % , c", ["a = b"]),
        (r"M=\begin{pmatrix} a & b \\ c & d \end{pmatrix}, x=0", None),
        ("", []),
        (r"\begin{equation}\label{e}\end{equation}", []),
    ],
)
def test_statements(tex, expected):
    if expected is None:
        assert len(parts(tex)) == 2
    else:
        assert parts(tex) == expected


ROWS = [
    (r"\begin{align} a &= b \\ c &= d \end{align}", 2),
    (r"\begin{align} a &= b \\ -c &= d \end{align}", 2),
    (r"\begin{align} a &= b \\ & -c = d \end{align}", 1),
    (r"\begin{align} a &= b && c = d \\ x &= y && z = w \end{align}", 4),
    (r"\begin{eqnarray} a &=& b \\ c &=& d \\ && + e \end{eqnarray}", 2),
    (r"\begin{eqnarray*} a &=& b \\ &=& c \end{eqnarray*}", 1),
    (r"\begin{array}{ll} a = b & -c = d \\ x = y & z = w \end{array}", 4),
    (r"\begin{array}{rcl} a&=&b \\ c&=&d \end{array}", 2),
    (r"\begin{cases} \dot x = y \\ \dot y = -x \end{cases}", 2),
    (r"a & = b \cr c & = d", 2),
]


@pytest.mark.parametrize(("tex", "count"), ROWS)
def test_a_row_that_states_a_relation_is_a_statement_without_a_comma_too(tex, count):
    assert len(parts(tex)) == count


@pytest.mark.parametrize(
    "tex",
    [
        r"a = b \\ (c+d)",
        r"(a+b) \\ c = d",
        r"\begin{align} a &= b \\ & c \end{align}",
        r"a = b \quad c",
        r"a \quad b = c",
        r"a \quad b",
        r"a \\ -b",
        r"\begin{array}{ll} a & b \\ c & d \end{array}",
        r"f = \begin{cases} a, & x = 0 \\ b, & x = 1 \end{cases}",
        r"f = \left\{\begin{array}{l} a \\ b \end{array}\right.",
        r"\left\{\begin{array}{l} a = b \\ c = d \end{array}\right. = e",
        r"\frac{\begin{array}{c} a \\ b \end{array}}{c}",
        r"(a \\ b)",
        "a = 1,5",
        "a = 1{,}000",
    ],
)
def test_what_runs_on_is_not_guessed(tex):
    with pytest.raises(NotationError):
        split_display(tex)


def test_no_name_needs_to_be_known():
    assert parts(r"\dot q_i = \frac{\partial H}{\partial p_i},\ |q| \leq \infty") == [
        r"\dot q_i = \frac{\partial H}{\partial p_i}",
        r"|q| \leq \infty",
    ]


@pytest.mark.parametrize(
    "display, printed",
    [
        (r"a,b>0", ["a > 0", "b > 0"]),
        (r"\dot x=y\qquad(k,m_1>0).", [r"\dot x = y", "k > 0", "m _ 1 > 0"]),
        (r"x=1\quad(k>0,\ m\le1)", ["x = 1", "k > 0", r"m \le 1"]),
        (r"a,b\ne0", [r"a \ne 0", r"b \ne 0"]),
        (r"x+y,b>0", ["x + y", "b > 0"]),
        (r"a,f(x,y)>0", ["a", "f ( x , y ) > 0"]),
        (r"a,b=1", ["a = 1", "b = 1"]),
        (r"x,y,z=-1.", ["x = - 1", "y = - 1", "z = - 1"]),
        (r"a,b=c", ["a", "b = c"]),
        (r"a,b=2c", ["a", "b = 2 c"]),
        (r"a+b,c=1", ["a + b", "c = 1"]),
    ],
)
def test_an_inequality_or_a_number_behind_a_list_of_names_is_said_of_each(display, printed):
    assert [" ".join(t.text for t in one.tokens) for one in statements(display)] == printed


@pytest.mark.parametrize(
    "printed, read",
    [
        ("a^2/2b", r"\frac{a^2}{2b}"),
        ("a/2b^2c-d", r"\frac{a}{2b^2c}-d"),
        ("(a+b)^2/2c+a", r"\frac{(a+b)^2}{2c}+a"),
    ],
)
def test_letters_right_behind_a_number_stand_under_the_slash_with_it(printed, read):
    words = Vocabulary(scalars="abcd")
    assert read_formula(printed, words) == read_formula(read, words)


@pytest.mark.parametrize("printed", ["1/2a", r"a/2\,b", "a/2b(c+d)", "a/b(c+d)"])
def test_what_may_stand_beside_the_slash_is_refused(printed):
    with pytest.raises(NotationError):
        read_formula(printed, Vocabulary(scalars="abcd"))
