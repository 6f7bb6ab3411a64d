"""What is printed is what is read."""

import pytest

from kowalevski_cas.library import available, load
from kowalevski_cas.notation import (
    Application,
    Conjugate,
    Constant,
    CrossProduct,
    Derivative,
    Diagonal,
    ImaginaryPart,
    Name,
    Negative,
    NotationError,
    Number,
    Partial,
    PoissonBracket,
    Power,
    Product,
    Quotient,
    RealPart,
    Relation,
    Root,
    ScalarProduct,
    Sum,
    Unwritten,
    Vector,
    Vocabulary,
    read,
    read_display,
    split_display,
    subtree,
    to_latex,
)
from tests.notation import paper

WORDS = Vocabulary(
    scalars=frozenset(
        r"a b c d i m n k x_1 x_2 w_1 F F_1 U_1 U_2 U_{12} z_1 s \ell \omega_1 \omega_2".split()
    ),
    vectors=frozenset([r"\boldsymbol{\alpha}", r"\boldsymbol{\beta}", r"\mathbf{e}_1"]),
    matrices=frozenset([r"\mathbf{I}"]),
    functions=frozenset([r"\varphi", r"\sin"]),
    times=frozenset(["t", r"\tau"]),
)
a, b, c, d, m, n, k, x_1, x_2 = map(Name, ["a", "b", "c", "d", "m", "n", "k", "x_1", "x_2"])
w_1, alpha, beta = Name("w_1"), Name(r"\boldsymbol{\alpha}"), Name(r"\boldsymbol{\beta}")
tau = Name(r"\tau")


def prime(formula):
    return Derivative(formula, "prime")


def dot(formula):
    return Derivative(formula, "dot")


ONE_READING = {
    # sums, products, signs
    "ab": Product((a, b)),
    "a + b - c": Sum((a, b, Negative(c))),
    "-ab": Negative(Product((a, b))),
    "+a": a,
    "a + -b": Sum((a, Negative(b))),
    "a(-b)": Product((a, Negative(b))),
    "(a+b)+c": Sum((Sum((a, b)), c)),
    "(ab)c": Product((Product((a, b)), c)),
    "((a+b))c": Product((Sum((a, b)), c)),
    "{a+b}c": Sum((a, Product((b, c)))),
    r"a \cdot b c": Product((a, b, c)),
    r"3\times 3": Product((Number(3), Number(3))),
    "c(w_1+x_1)": Product((c, Sum((w_1, x_1)))),
    "c(ab)^2": Product((c, Power(Product((a, b)), Number(2)))),
    r"c\cdot(ab)": Product((c, Product((a, b)))),
    "2(a)": Product((Number(2), a)),
    "[a]\\{b\\}": Product((a, b)),
    r"\{a,b\}": PoissonBracket(a, b),
    r"c\{a,b\}^2": Product((c, Power(PoissonBracket(a, b), Number(2)))),
    r"\{\{a,b\},c\}": PoissonBracket(PoissonBracket(a, b), c),
    "2ab": Product((Number(2), a, b)),
    # quotients and roots
    r"\frac12": Quotient(Number(1), Number(2)),
    r"\frac123": Product((Quotient(Number(1), Number(2)), Number(3))),
    r"\frac ab": Quotient(a, b),
    r"\tfrac{a}b": Quotient(a, b),
    r"{\frac{a}{b}}(c)": Product((Quotient(a, b), c)),
    "ab/c": Quotient(Product((a, b)), c),
    "ab/cd": Quotient(Product((a, b)), Product((c, d))),
    "a/b/c": Quotient(Quotient(a, b), c),
    r"\sqrt k": Root(k),
    r"\sqrt {a /b }": Root(Quotient(a, b)),
    r"\sqrt2k": Product((Root(Number(2)), k)),
    # powers and indices
    "x_1^2": Power(x_1, Number(2)),
    "x^2_1": Power(x_1, Number(2)),
    "x _{1} ^{2}": Power(x_1, Number(2)),
    "U_{12}": Name("U_{12}"),
    "a^{m-1}b": Product((Power(a, Sum((m, Negative(Number(1))))), b)),
    r"a^\frac12": Power(a, Quotient(Number(1), Number(2))),
    "(a+b)^2": Power(Sum((a, b)), Number(2)),
    "2^m": Power(Number(2), m),
    # primes, dots, bars
    "x'_1": prime(x_1),
    "x_1'": prime(x_1),
    "x_1^{\\prime}": prime(x_1),
    "x_1^\\prime": prime(x_1),
    "x_1''": prime(prime(x_1)),
    "x_1^{\\prime\\prime}": prime(prime(x_1)),
    "x_1'^2": Power(prime(x_1), Number(2)),
    r"2\ell '": Product((Number(2), prime(Name(r"\ell")))),
    "(a+b)'": prime(Sum((a, b))),
    "(a+b)^{\\prime}": prime(Sum((a, b))),
    r"\dot \omega _1": dot(Name(r"\omega_1")),
    r"\dot{\omega}_1": dot(Name(r"\omega_1")),
    r"\dot{\omega_1}": dot(Name(r"\omega_1")),
    r"\dot x_1^2": Power(dot(x_1), Number(2)),
    r"\ddot x_1": dot(dot(x_1)),
    r"\dot {\bs \alpha}": dot(alpha),
    r"\dot{(ab)}": dot(Product((a, b))),
    r"\overline {U_1 }": Conjugate(Name("U_1")),
    r"\bar U_1": Conjugate(Name("U_1")),
    r"\overline{a+b}c": Product((Conjugate(Sum((a, b))), c)),
    # derivatives written out
    r"\frac {d F_1} {d\tau}": Derivative(Name("F_1"), r"\tau"),
    r"\frac{d}{d\tau}(a-b)": Derivative(Sum((a, Negative(b))), r"\tau"),
    r"\frac d{dt} F": Derivative(Name("F"), "t"),
    r"\frac{d}{dt}(a+b)c": Product((Derivative(Sum((a, b)), "t"), c)),
    r"\frac{d^2F}{dt^2}": Derivative(Derivative(Name("F"), "t"), "t"),
    r"\frac{{\rm d}F}{{\rm d}t}": Derivative(Name("F"), "t"),
    r"\frac{a}{d\tau}": Quotient(a, Product((d, tau))),
    r"\frac{da}{db}": Quotient(Product((d, a)), Product((d, b))),
    # parts and functions
    r"{\mathop{\rm Re}\nolimits} (ab)": RealPart(Product((a, b))),
    r"\Im[a]b": Product((ImaginaryPart(a), b)),
    r"\operatorname{Re} a + b": Sum((RealPart(a), b)),
    r"\varphi(s)": Application(r"\varphi", (Name("s"),)),
    r"\varphi^2(s)": Power(Application(r"\varphi", (Name("s"),)), Number(2)),
    r"a\sin b": Product((a, Application(r"\sin", (b,)))),
    # vectors
    r"({\bf e}_1, {\bs \alpha})": ScalarProduct(Name(r"\mathbf{e}_1"), alpha),
    r"(\bm{e}_1, \mathbf{\alpha})": ScalarProduct(Name(r"\mathbf{e}_1"), alpha),
    "{\\bf\ne}_1": Name(r"\mathbf{e}_1"),
    r"{\bs \alpha}\cdot{\bs \beta}": ScalarProduct(alpha, beta),
    r"a{\bs \alpha} \times {\bs \beta}": CrossProduct(Product((a, alpha)), beta),
    r"({\bf I}{\bs \alpha}, {\bs \beta})": ScalarProduct(
        Product((Name(r"\mathbf{I}"), alpha)), beta
    ),
    "(1,0,0)": Vector((Number(1), Number(0), Number(0))),
    "(a,b)": Vector((a, b)),
    r"\mathop{\rm diag}\nolimits(a, b,c)": Diagonal((a, b, c)),
    r"\begin{pmatrix} a & -b \\ 0 & c \end{pmatrix}": Vector(
        (Vector((a, Negative(b))), Vector((Number(0), c)))
    ),
    r"\left(\begin{array}{c} a \\ b \end{array}\right)": Vector((a, b)),
    # words and relations
    "a = b = {\\rm const}": Relation((a, b, Constant()), ("=", "=")),
    r"a \neq \text{const}.": Relation((a, Constant()), (r"\ne",)),
    r"a \equiv k,": Relation((a, k), (r"\equiv",)),
    "ab + ...": Sum((Product((a, b)), Unwritten())),
    r"a + \ldots": Sum((a, Unwritten())),
    # what typesetting adds does not matter
    r"\displaystyle{\left( a \right.\! + \bigl. b \Bigr) ~\,c} % the end": Product(
        (Sum((a, b)), c)
    ),
    r"\phantom{-}a \hspace{2mm} b\nonumber\label{eq1}": Product((a, b)),
}


@pytest.mark.parametrize("tex", ONE_READING)
def test_a_formula_has_one_reading(tex):
    assert read(tex, WORDS) == ONE_READING[tex]
    assert read(to_latex(read(tex, WORDS)), WORDS) == ONE_READING[tex]


@pytest.mark.parametrize("name", available())
def test_every_display_of_a_derivation_is_read_as_it_stands(name):
    derivation = load(name)
    words = derivation.texts().vocabulary
    for display in derivation.displays():
        statements = read_display(display.tex, words)
        assert statements
        assert [(s.start, s.end) for s in statements] == list(split_display(display.tex))
        for statement in statements:
            assert read(to_latex(statement.formula), words) == statement.formula


def test_the_dynamic_equation_is_i_omega_crossed_with_omega():
    first = read_display(paper.DISPLAYS["eq2"], paper.WORDS)[0].formula
    inertia, omega = Name(r"\mathbf{I}"), Name(r"\boldsymbol{\omega}")
    assert first.members[0] == Product((inertia, dot(omega)))
    assert first.members[1].terms[0] == CrossProduct(Product((inertia, omega)), omega)


def test_a_span_is_the_source_that_printed_the_node():
    tex = r"$$ F_1 = {\frac {a} {b }}(x'_1 - [c]) $$"
    [statement] = read_display(tex, WORDS)
    printed = {path: tex[start:end] for path, (start, end) in statement.spans.items()}
    assert printed[()] == statement.source == r"F_1 = {\frac {a} {b }}(x'_1 - [c])"
    assert printed[(1, 0)] == r"\frac {a} {b }"
    assert printed[(1, 0, 1)] == "b"
    assert printed[(1, 1)] == "(x'_1 - [c])"
    assert printed[(1, 1, 0)] == "x'_1"
    assert printed[(1, 1, 1)] == "- [c]"
    assert printed[(1, 1, 1, 0)] == "[c]"
    assert subtree(statement.formula, (1, 1, 0, 0)) == x_1


@pytest.mark.parametrize(
    "tex",
    [
        "a/b c",
        r"a/b\cdot c",
        r"\frac{d}{dt} ab",
        r"\Re ab",
        r"\Re(a)^2",
        r"\sin a b",
        r"{\bs\alpha}\times{\bs\beta}\times{\bs\alpha}",
        r"{\bs\alpha}\cdot{\bs\beta}\cdot{\bs\alpha}",
        "[a,b]",
        "c(ab)",
        r"\langle a \rangle",
        r"({\bs\alpha}, a)",
        "x_12",
        "x_1^10",
        "a^0.5",
        r"\frac{d^12}{da^{12}}c",
    ],
)
def test_what_can_be_read_in_two_ways_is_not_read(tex):
    with pytest.raises(NotationError):
        read(tex, WORDS)


@pytest.mark.parametrize("number", ["2", r"\frac12", r"\tfrac{3}4"])
@pytest.mark.parametrize("derived", ["(x_1+x_2)", r"\left[x_1x_2\right]", "x_1^2", "x_1"])
def test_a_number_behind_a_derivative_goes_with_what_is_derived(number, derived):
    bare, in_brackets = (
        read(rf"\frac{{d}}{{d\tau}}{one}+a", WORDS)
        for one in (number + derived, rf"\left({number}{derived}\right)")
    )
    assert bare == in_brackets
    with pytest.raises(NotationError, match="how far does the derivative"):
        read(rf"\frac{{d}}{{d\tau}}{number}{derived}a", WORDS)


def test_a_power_behind_the_argument_is_that_of_the_derivative():
    words = Vocabulary(scalars=frozenset({"x"}), functions=frozenset({"V"}))
    slope = Partial(Application("V", (Name("x"),)), "x")
    assert read("V'(x)", words) == slope
    assert read("V'(x)^2", words) == Power(slope, Number(2))
    assert read("V''(x)^3", words) == Power(Partial(slope, "x"), Number(3))
