"""What bars, roots and logarithms mean where names are complex, by their values at points."""

from dataclasses import replace
from itertools import product

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from kowalevski_cas.paper.claims import FirstIntegral, Identity, Reality
from kowalevski_cas.paper.derivation import Scene
from tests.paper.small import Paper

pytestmark = pytest.mark.usefixtures("uncorrected")

SMALL = st.integers(-2, 2)
POINTS = [complex(*point) for point in product(range(-2, 3), repeat=2)]
"""Values of x; that of y is the conjugate one."""


def scene(paper, unit, **more):
    return Scene(
        "s", variables=("x", "y"), conjugates=(("x", "y"),), unit=paper("i^2=-1") if unit else None,
        vectors={r"\mathbf{v}": ("x", "y")}, **more
    )  # fmt: skip


@given(st.booleans(), st.booleans(), SMALL, SMALL)
def test_the_square_of_a_modulus(unit, real, a, b):
    """It has the value at all points, or that of the square, which is another one."""
    paper = Paper()
    p, q = (a * a, 2 * a * b) if real else (a * b, a * a + b * b)
    r = b * b if real else p
    same = all(
        abs(a * x + b * y) ** 2 == pytest.approx(p * x * x + q * x * y + r * y * y)
        for x in POINTS
        for y in [x.conjugate()]
    )
    tex = f"|{a}x+({b})y|^2={p}x^2+({q})xy+({r})y^2"
    assert paper.verdict(Identity, tex, on=scene(paper, unit)) == ("proved" if same else "refuted")


@given(st.booleans(), SMALL, SMALL)
def test_the_length_of_a_complex_vector(unit, p, q):
    paper = Paper()
    tex = rf"|\mathbf{{v}}|^2={p}(x^2+y^2)+{q}xy"
    same = (p, q) == (0, 2)
    assert paper.verdict(Identity, tex, on=scene(paper, unit)) == ("proved" if same else "refuted")


@given(SMALL, SMALL)
def test_a_real_root_is_one_of_what_is_positive_somewhere(a, b):
    """With x = u + iv the square is (2a + b) u^2 + (b - 2a) v^2."""
    assume((a, b) != (0, 0))
    paper = Paper()
    square = paper(f"r^2={a}(x^2+y^2)+({b})xy")
    found = paper.verdict(
        Reality, on=scene(paper, True, roots={"r": square}), real=("r",), imaginary=()
    )
    assert found == ("proved" if max(2 * a + b, b - 2 * a) > 0 else "error")


@given(SMALL.filter(bool), SMALL, SMALL)
def test_the_logarithm_of_a_modulus(turning, growing, rate):
    """With x' = (growing + i turning) x that of x grows at the rate growing."""
    paper = Paper()
    field = paper.all(
        rf"\dot x=({growing}+({turning})i)x,\quad \dot y=({growing}-({turning})i)y,\quad\dot z={rate}"
    )
    on = replace(scene(paper, True), variables=("x", "y", "z"), field=field)
    found = paper.verdict(FirstIntegral, r"\ln|x|-z", on=on)
    assert found == ("conditional" if growing == rate else "refuted")
