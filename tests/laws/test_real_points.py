"""A real point that satisfies the hypotheses is found on conics and products of them, if one is."""

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from kowalevski_cas import System
from kowalevski_cas.paper.claims import Implication
from kowalevski_cas.paper.derivation import Scene, Section
from tests.paper.small import decide

pytestmark = pytest.mark.usefixtures("uncorrected", "here")

STILL = r"\dot x=0,\ \dot y=0,\ \dot z=0,\ \dot s=0,\ \dot c=0,\ \dot k=0"
positive = st.integers(1, 9)
few = settings(max_examples=8)


def verdict(conclusion, *equations):
    return str(System(STILL).implication(conclusion, given=equations).verdict)


@pytest.mark.slow
@few
@given(positive, positive, positive)
def test_an_ellipse_has_points_and_with_a_negative_side_none(a, b, c):
    """Whether or not it has rational ones."""
    assert verdict(f"({a}x^2+{b}y^2)^2={c**2}", f"{a}x^2+{b}y^2={c}") == "proved"
    assert verdict("x=y", f"{a}x^2+{b}y^2=-{c}") == "undecided"


@pytest.mark.slow
@few
@given(positive, positive, positive)
def test_what_fails_on_an_ellipse_is_refuted_there(a, b, c):
    assert verdict(f"{a}x^2={c}", f"{a}x^2+{b}y^2={c}") == "refuted"


@pytest.mark.slow
@few
@given(positive, positive)
def test_on_the_curve_of_jacobi_s_functions_points_are_found(a, b):
    curve = ("s^2+c^2=1", "z^2+k^2s^2=1")
    assert verdict(f"c={a}z", *curve) == "refuted"
    assert verdict(f"{b}s^2+{b}c^2={b}", *curve) == "proved"


@pytest.mark.parametrize("line", ["sx=cy", "sx+cy=1", "s+x=c+y"])
def test_two_circles_and_a_line_between_them(line):
    circles = ("s^2+c^2=1", "x^2+y^2=1")
    assert verdict("s=x+2", *circles, line) == "refuted"


@pytest.mark.slow
@few
@given(st.integers(-4, 4), st.integers(1, 5))
def test_a_value_of_a_sine_is_one_of_an_angle(m, n):
    """And no angle has a larger one."""
    assume(m)
    section = Section("1", "")
    scene = Scene(variables=("x",), constants=("a",))
    place = section.display("given", rf"\cos(x+a)=\frac{{{m}}}{{{n}}}")[1]
    square = rf"\sin^2(x+a)=\frac{{{n**2 - m**2}}}{{{n**2}}}"
    printed = section.display("d", square)[1]
    [outcome] = decide(section, Implication("c", scene, "", printed=printed, given=(place,)))
    assert str(outcome.verdict) == ("proved" if abs(m) <= n else "undecided")
