"""What formulas say of how their names scale."""

import pytest

from kowalevski_cas.notation import Vocabulary, read
from kowalevski_cas.notation.functions import FUNCTIONS
from kowalevski_cas.notation.scales import MODULUS, Scales, Span

WORDS = Vocabulary(
    frozenset([*"mxyklgcap", r"\theta"]),
    vectors=frozenset([r"\mathbf{v}", r"\hat{\mathbf{n}}"]),
    functions=FUNCTIONS | {"F"},
    times=frozenset("t"),
    moving=frozenset([*"xy", r"\theta", r"\mathbf{v}"]),
)


def span(*formulas):
    found = Span()
    for tex in formulas:
        for scale in Scales(read(tex, WORDS)).all:
            found.add(scale)
    return found


def scale(**exponents):
    return {name: exponent % MODULUS for name, exponent in exponents.items()}


@pytest.mark.parametrize(
    ("tex", "pure"),
    [
        (r"m\ddot x=-kx", scale(m=1, t=-2, k=-1)),
        (r"p=m\dot x", scale(p=1, m=-1, x=-1, t=1)),
        (r"\sqrt{\frac{l}{g}}=t", scale(l=1, g=-1, t=-2)),
        (r"\frac{m\dot x^2}{2}+\frac{kx^2}{2}=c", scale(m=1, x=2, t=-2, c=-1)),
        (r"y=\frac{\partial c}{\partial x}", scale(y=1, c=-1, x=1)),
        (r"y=\sin(kx)", scale(k=1, x=1)),
        (r"y=F(x)a", scale(y=1, F=1, a=1)),
        (r"(\mathbf v,\hat{\mathbf n})=p", {r"\mathbf{v}": 1, "p": MODULUS - 1}),
        (r"y^{\frac32}=x", scale(y=3, x=-2)),
    ],
)
def test_what_is_added_compared_or_an_argument_scales_alike(tex, pure):
    assert pure in span(tex) or tex.startswith("y=F")


@pytest.mark.parametrize(
    ("tex", "no"),
    [
        (r"m\ddot x=-kx", scale(x=1)),
        (r"x=0", scale(x=1)),
        (r"y=\ln x", scale(x=1)),
        (r"x^n=y", scale(x=1)),
        (r"y=\sin\theta", scale(l=1)),
    ],
)
def test_nothing_else_does(tex, no):
    words = WORDS.scalars | {"n"}
    tree = read(tex, Vocabulary(words, functions=FUNCTIONS, times=WORDS.times, moving=WORDS.moving))
    found = Span()
    for one in Scales(tree).all:
        found.add(one)
    assert no not in found


def test_formulas_that_disagree_leave_a_name_without_dimension():
    assert scale(x=1) not in span("y=kx^2", "c=yk")
    assert scale(x=1) in span("y=kx^2", "y=kx^3")


def test_a_new_name_takes_any_scale_and_explains_no_disagreement():
    found = span("y=kx^2")
    (tie,) = Scales(read("a=kx", WORDS)).alike
    assert found.explains([tie], {"a"}) and not found.explains([tie], set())
    both = Scales(read("a=kx=y", WORDS)).alike
    assert not found.explains(both, {"a"})
