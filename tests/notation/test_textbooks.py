"""What textbooks of mechanics print is read, and printed again in all formats."""

import pytest

from kowalevski_cas.notation import (
    Application,
    Commutator,
    CrossProduct,
    Derivative,
    Modulus,
    Name,
    Negative,
    NotationError,
    Number,
    Partial,
    Power,
    Product,
    Quotient,
    Relation,
    Sum,
    Summation,
    Vector,
    read,
    read_display,
    to_latex,
    to_plain,
)
from kowalevski_cas.notation.mathml import to_mathml
from kowalevski_cas.notation.typst import to_typst
from tests.notation.textbooks import FORMULAS, WORDS

x, y, p, q, H, theta = map(Name, ["x", "y", "p", "q", "H", r"\theta"])
r, gamma = Name(r"\mathbf{r}"), Name(r"\boldsymbol{\gamma}")
two = Number(2)

ONE_READING = {
    r"\frac{dx}{dt}": Derivative(x, "t"),
    "dx/dt": Derivative(x, "t"),
    r"\mathrm{d}x/\mathrm{d}t": Derivative(x, "t"),
    r"dx/dt\,y": Product((Derivative(x, "t"), y)),
    "d^2x/dt^2": Derivative(Derivative(x, "t"), "t"),
    "x(t)": x,
    r"\dot x(t)": Derivative(x, "dot"),
    "x(t)^2": Power(x, two),
    r"\partial H/\partial p": Partial(H, "p"),
    r"-\partial H/\partial q_1": Negative(Partial(H, "q_1")),
    r"\frac{\partial L}{\partial \dot q}": Partial(Name("L"), r"\dot{q}"),
    r"\frac{\partial L}{\partial \dot{q}_1}": Partial(Name("L"), r"\dot{q}_1"),
    r"\frac{\partial L}{\partial \dot{q_1}}": Partial(Name("L"), r"\dot{q}_1"),
    r"\frac{\partial^2 H}{\partial q\partial p}": Partial(Partial(H, "p"), "q"),
    r"\frac{\partial H}{\partial\mathbf r}": Partial(H, r"\mathbf{r}"),
    "0.5": Quotient(Number(1), two),
    "12.0": Number(12),
    "0.125x": Product((Quotient(Number(1), Number(8)), x)),
    r"{x \over y}": Quotient(x, y),
    r"x{q+1 \over 2}": Product((x, Quotient(Sum((q, Number(1))), two))),
    r"\cos\omega t": Application(r"\cos", (Product((Name(r"\omega"), Name("t"))),)),
    r"\sin\omega x": Application(r"\sin", (Product((Name(r"\omega"), Name("x"))),)),
    r"\cos2\omega t\,\sin\theta": Product(
        (
            Application(r"\cos", (Product((two, Name(r"\omega"), Name("t"))),)),
            Application(r"\sin", (theta,)),
        )
    ),
    r"\sin\omega(t-q)": Application(
        r"\sin", (Product((Name(r"\omega"), Sum((Name("t"), Negative(q))))),)
    ),
    r"\sin\theta(1-\cos\theta)": Product(
        (Application(r"\sin", (theta,)), Sum((Number(1), Negative(Application(r"\cos", (theta,))))))
    ),
    r"\operatorname{tg}\frac\theta2": Application(r"\tan", (Quotient(theta, two),)),
    r"{\rm sn}^2(q,k)": Power(Application(r"\mathrm{sn}", (q, Name("k"))), two),
    r"\sh x\ch x": Product((Application(r"\sinh", (x,)), Application(r"\cosh", (x,)))),
    r"\sum_{i=1}^3 p_i^2": Summation("i", Number(1), Number(3), Power(Name("p_i"), two)),
    r"\sum_{i=1}^{3} ip_i + x": Sum(
        (Summation("i", Number(1), Number(3), Product((Name("i"), Name("p_i")))), x)
    ),
    "e^{-x}": Application(r"\exp", (Negative(x),)),
    r"\sin 2\theta": Application(r"\sin", (Product((two, theta)),)),
    r"\sin\frac{1}{2}\theta": Application(r"\sin", (Product((Quotient(Number(1), two), theta)),)),
    r"p(x')^2": Product((p, Power(Derivative(x, "prime"), two))),
    r"p(\dot x)^2": Product((p, Power(Derivative(x, "dot"), two))),
    r"\sin\theta\cos\theta": Product(
        (Application(r"\sin", (theta,)), Application(r"\cos", (theta,)))
    ),
    "|x|": Modulus(x),
    r"\left|x\right|y": Product((Modulus(x), y)),
    r"\|\mathbf r\|^3": Power(Modulus(r), Number(3)),
    r"\boldsymbol\gamma^2": Power(gamma, two),
    r"[\mathbf A,\mathbf B]": Commutator(Name(r"\mathbf{A}"), Name(r"\mathbf{B}")),
    r"x \leqslant y": Relation((x, y), (r"\le",)),
    "x ≥ y": Relation((x, y), (r"\ge",)),
    r"\left|\begin{array}{cc} x & y \\ p & q \end{array}\right|": Application(
        r"\det", (Vector((Vector((x, y)), Vector((p, q)))),)
    ),
    r"\frac{\partial L}{\partial\dot{\mathbf r}} + \mathbf p": Sum(
        (Partial(Name("L"), r"\dot{\mathbf{r}}"), Name(r"\mathbf{p}"))
    ),
    r"\dot q_{r_{0}}": Derivative(Name("q_{r_0}"), "dot"),
    "p_{O'} x": Product((Name("p_{O'}"), x)),
    "H := x": Relation((H, x), ("=",)),
    r"H \coloneqq x": Relation((H, x), ("=",)),
    r"\nabla U": Partial(Name("U"), r"\mathbf{r}"),
    r"\nabla(U+V)": Partial(Sum((Name("U"), Name("V"))), r"\mathbf{r}"),
    r"\mathbf r\times\frac{\partial H}{\partial\mathbf r}": CrossProduct(
        r, Partial(H, r"\mathbf{r}")
    ),
}


@pytest.mark.parametrize("tex", ONE_READING)
def test_a_formula_of_a_textbook_has_one_reading(tex):
    assert read(tex, WORDS) == ONE_READING[tex]


@pytest.mark.parametrize("tex", [*FORMULAS, *ONE_READING])
def test_what_was_read_is_printed_so_that_it_reads_the_same(tex):
    for statement in read_display(tex, WORDS):
        assert read(to_latex(statement.formula), WORDS) == statement.formula
        for printer in (to_mathml, to_plain, to_typst):
            assert printer(statement.formula)


def test_two_signs_are_two_statements():
    found = [statement.formula for statement in read_display(r"x = \pm y \mp p", WORDS)]
    assert found == [read("x = +y - p", WORDS), read("x = -y + p", WORDS)]


@pytest.mark.parametrize(
    ("tex", "message"),
    [
        (r"\sum_{i} p_i", "print where the sum begins and ends"),
        (r"\sum_{i<3} p_i", "print where the sum begins and ends"),
        ("p_i", "p_i is not declared here"),
        (r"\sum_{i=1}^3 p_i + p_i", "p_i is not declared here"),
        (r"\sum_{i=1}^3 k_i", "k_i is not declared here"),
        ("p(t)", "a product, or p at this argument?"),
        ("x(y)", "a product, or x at this argument?"),
        (r"\nabla\times\mathbf r", "print by what it derives"),
        (r"\int_0^1 x", "an integral cannot be read"),
        (r"\sin\theta(x+y)", r"how far does \sin reach?"),
        (r"\frac{d}{dt}x\sin y", "how far does the derivative by t reach?"),
        (r"\sin\theta t", r"how far does \sin reach?"),
        (r"\langle x, y\rangle", "declare the vectors of this product"),
        ("[x, y]", "a list in these brackets cannot be read"),
        ("|x|y||", "the formula breaks off here"),
        (r"\mathbf r^3", "a number is expected here, not a vector"),
        ("x = 1.5.2", "write a zero before the decimal point"),
        (r"\partial H", "a derivative is expected here"),
        (r"x = \pm y", "the sign \\pm is that of two statements; read_display reads both"),
    ],
)
def test_what_is_not_understood_is_said_with_the_place(tex, message):
    with pytest.raises(NotationError) as caught:
        read(tex, WORDS)
    assert str(caught.value).startswith(message)
