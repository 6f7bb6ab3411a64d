"""What is printed below a line is a condition wherever it stands, also where it cancels."""

from itertools import product

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from kowalevski_cas import System
from kowalevski_cas.notation import to_latex
from kowalevski_cas.paper.claims import Identity
from kowalevski_cas.paper.derivation import Scene
from kowalevski_cas.verify.outcome import Verdict
from tests.laws.test_falsehoods import value
from tests.paper.small import Paper

pytestmark = pytest.mark.usefixtures("here")

SYSTEM = System(r"\dot x=y,\quad \dot y=z+c,\quad \dot z=x")
for definition in (
    r"F=\frac1y", r"G(x)=\frac{x}{y}", r"\{x,z\}=1",
    r"{\bf A}=\begin{pmatrix}F&1\\0&x\end{pmatrix}",
):  # fmt: skip
    SYSTEM.define(definition)

LEAVES = (
    r"\frac1y", "F", "G(x)", "G(0)", r"\frac{x-x}{y}", r"\frac{y^2}{y}", "y^{-1}", r"\det{\bf A}",
    r"\operatorname{tr}{\bf A}", "F-F", "Fy",
)  # fmt: skip
AROUND = (
    "0(%s)", "(%s)-(%s)", "(%s)^0", "(%s)^2", "-(%s)", "x+(%s)", r"z\cdot(%s)", r"\frac{(%s)}{2}",
    r"\frac{z}{7z+(%s)}", r"(7z+(%s))^{-2}",
    r"\frac{d}{dt}\left(%s\right)", r"\frac{\partial}{\partial z}\left(%s\right)",
    r"\{x,(%s)\}", r"\{(%s),1\}", r"\sum_{i=0}^1i\cdot(%s)", r"\sum_{i=0}^0i\cdot(%s)",
)  # fmt: skip


@pytest.mark.slow
@given(st.sampled_from(LEAVES), st.lists(st.sampled_from(AROUND), max_size=3))
def test_what_is_divided_by_is_named(formula, around):
    for one in around:
        formula = one.replace("%s", formula)
    outcome = SYSTEM.identity(f"{formula}={formula}").outcome
    assert outcome.verdict is Verdict.CONDITIONAL
    named = [to_latex(condition.expression) for condition in outcome.conditions]
    # within another condition it is seen below a line, or as F
    assert any(one == "y" or "}{y}" in one or "F" in one for one in named)


@settings(max_examples=settings.default.max_examples // 2)
@given(st.sampled_from(LEAVES), st.sampled_from(AROUND))
def test_what_the_motion_divides_by_is_named(formula, around):
    """Also where nothing is left of it: the equations of motion say nothing where it vanishes."""
    assume("F" not in formula or "dt" not in around)  # F would move by an equation of its own
    formula = around.replace("%s", formula)
    given = r"F=\frac1y,\ G(x)=\frac xy,\ \{x,z\}=1,\ {\bf A}=\begin{pmatrix}F&1\\0&x\end{pmatrix}"
    system = System(rf"\dot u=({formula})-({formula}),\ \dot x=y,\ \dot y=z,\ \dot z=x,\ {given}")
    outcome = system.integral("u").outcome
    assert outcome.verdict is Verdict.CONDITIONAL
    assert "y" in [to_latex(condition.expression) for condition in outcome.conditions]


@pytest.mark.parametrize("conjugates", [(), (("x", "y"),)])
@given(st.integers(1, 3), st.integers(1, 3))
def test_a_sum_of_squares_vanishes_with_each_of_them_if_these_are_real(conjugates, a, b):
    """At x = 1 + i, y = 1 - i the sum of the squares is zero, and x is not."""
    paper = Paper()
    paper.scene = Scene("s", variables=("x", "y"), conjugates=conjugates)
    squares = f"{a}x^2+{b}y^2" if not conjugates else f"{a}(x^2+y^2)"
    formula = rf"\frac{{1}}{{{squares}}}+\frac1x"
    outcome = paper.outcome(Identity, f"{formula}={formula}")
    named = [to_latex(condition.expression) for condition in outcome.conditions]
    assert ("x" in named) and len(named) == 1 + bool(conjugates)


@given(
    st.lists(st.sampled_from(["x^2+y^2", "x^2+2y^2", "x^4+y^2", "y^2+z^4", "x", "z"]), min_size=1)
)
def test_of_conditions_that_follow_from_each_other_one_is_named(below):
    """Some condition vanishes at each point where a denominator does."""
    formula = "+".join(rf"\frac{{1}}{{{one}}}" for one in below)
    outcome = SYSTEM.identity(f"{formula}={formula}").outcome
    named = [to_latex(condition.expression) for condition in outcome.conditions]
    for point in product((0, 1), repeat=3):
        if any(vanishes(one, point) for one in below):
            assert any(vanishes(one, point) for one in named)


@given(st.sampled_from(LEAVES[:1] + LEAVES[4:7]), st.sampled_from(["1", "x", "xy"]))
def test_a_root_of_zero_remembers_what_that_was_divided_by(formula, factor):
    paper = Paper()
    place = paper(rf"r^2={factor}\cdot({formula})-{factor}\cdot({formula})")
    paper.scene = Scene("s", variables=("x", "y"), roots={"r": place})
    named = paper.outcome(Identity, "r=0").conditions
    assert [to_latex(condition.expression) for condition in named] == ["y"]


@given(
    st.sampled_from(
        [one for one in LEAVES if "F" not in one and "G" not in one and "A" not in one]
    ),
    st.sampled_from([r"\{x,z\}", r"\{z,x\}", r"\{x^2,z\}", r"\{xy,x+z\}", r"\{x,\{x,z\}\}"]),
    st.booleans(),
)
def test_a_bracket_of_zero_remembers_what_that_was_divided_by(formula, bracket, turned):
    """What is not printed of the brackets divides by nothing."""
    pair = r"\{z,x\}" if turned else r"\{x,z\}"
    motion = rf"\dot x=y,\ \dot y=z,\ \dot z=x,\ {pair}=({formula})-({formula})"
    outcome = System(motion).identity(f"{bracket}=0").outcome
    assert [to_latex(condition.expression) for condition in outcome.conditions] == ["y"]


BELOW = {
    "x": lambda x, y: x,
    "y": lambda x, y: y,
    "y+1": lambda x, y: y + 1,
    "(x-y)": lambda x, y: x - y,
    "(x+y)^2": lambda x, y: (x + y) ** 2,
}


@given(
    st.sampled_from([*BELOW]),
    st.sampled_from(
        [r"\frac{r^2}{%}=\frac{x}{%}", r"r^2+\frac1{%}=x+\frac1{%}", r"r^2-x=\frac{x-x}{%}",
         r"r^2=x\frac{%}{%}=x", r"r^2\frac{%}{%}=x"]
    ),
    st.sets(st.sampled_from([*BELOW])),
)  # fmt: skip
def test_the_square_of_a_root_remembers_what_its_equation_divides_by(below, equation, granted):
    """Where that vanishes, a condition does, or what is granted."""
    paper = Paper()
    place = paper(equation.replace("%", below))
    paper.scene = Scene("s", variables=("x", "y"), roots={"r": place}, nonzero=tuple(granted))
    outcome = paper.outcome(Identity, "r^2=x")
    assert outcome.verdict.green
    for x, y in product(range(-2, 3), repeat=2):
        if BELOW[below](x, y) == 0:
            excluded = any(BELOW[one](x, y) == 0 for one in granted)
            conditions = [value(one.expression, {"x": x, "y": y}) for one in outcome.conditions]
            assert excluded or 0 in conditions


FACTORS = ("x", "y", "(x+y)", "(x-2y)", "(x^2+y)")
SOME = st.lists(st.sampled_from(FACTORS), min_size=1, unique=True)


@given(SOME, SOME)
def test_what_is_granted_of_a_product_is_granted_of_its_factors(granted, below):
    paper = Paper()
    paper.scene = Scene("s", variables=("x", "y"), nonzero=("".join(granted),))
    formula = rf"\frac{{1}}{{{''.join(below)}}}"
    outcome = paper.outcome(Identity, f"{formula}={formula}")
    named = {to_latex(condition.expression).replace(" ", "") for condition in outcome.conditions}
    assert named == {one.strip("()") for one in {*below} - {*granted}}


SIGNED = {
    "x": lambda x, r: x,
    "r": lambda x, r: r,
    "(x+r)": lambda x, r: x + r,
    "(x-r)": lambda x, r: x - r,
    "(x+2r)": lambda x, r: x + 2 * r,
    "(x^2+r^2)": lambda x, r: x * x + r * r,
}
SOME_SIGNED = st.lists(st.sampled_from([*SIGNED]), min_size=1, max_size=3, unique=True)


@given(SOME_SIGNED, SOME_SIGNED)
def test_what_is_granted_with_one_sign_of_a_root_is_not_granted_with_the_other(granted, below):
    """Where a denominator vanishes, a condition does, or what is granted."""
    paper = Paper()
    place, nonzero = paper("r^2=y"), ("".join(granted),)
    paper.scene = Scene("s", variables=("x", "y"), roots={"r": place}, nonzero=nonzero)
    formula = rf"\frac{{1}}{{{''.join(below)}}}"
    named = paper.outcome(Identity, f"{formula}={formula}").conditions
    for x, r in product(range(-2, 3), repeat=2):
        if any(SIGNED[one](x, r) == 0 for one in below):
            excluded = any(SIGNED[one](x, r) == 0 for one in granted)
            at = {"x": x, "r": r, "y": r * r}
            assert excluded or any(value(one.expression, at) == 0 for one in named)


def vanishes(tex, point):
    """Whether a sum of powers with positive coefficients does."""
    return not any(value and name in tex for name, value in zip("xyz", point, strict=True))
