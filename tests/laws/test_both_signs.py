"""Claims with both signs: true for each sign, or for one of them at each point, and else red."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kowalevski_cas import System

pytestmark = pytest.mark.usefixtures("uncorrected", "here")

SIGN = st.sampled_from([r"\pm", r"\mp"])
FACTOR = st.integers(1, 3)


def oscillator():
    return System(r"\dot x=y,\quad \dot y=-x")


@given(FACTOR, SIGN, SIGN, FACTOR)
def test_signs_on_both_sides_belong_together(k, left, right, other):
    claim = oscillator().identity(rf"(x{left}{k}y)^2=x^2{right}{2 * other}xy+{k * k}y^2")
    assert claim.verdict == ("proved" if (left, k) == (right, other) else "refuted")
    assert len(claim.parts) == 2


@pytest.mark.slow
@given(FACTOR, FACTOR, SIGN)
def test_signs_on_one_side_are_one_of_two_at_each_point(k, other, sign):
    claim = oscillator().implication(f"x={sign}{k}y", given=f"x^2={other * other}y^2")
    assert claim.verdict == ("proved" if k == other else "refuted")
    one = oscillator().implication(f"x={k}y", given=f"x^2={k * k}y^2")
    assert one.verdict != "proved"  # but where x is not -ky


@pytest.mark.parametrize(
    ("tex", "verdict"),
    [
        (r"\cos(x\pm y)=\cos x\cos y\mp\sin x\sin y", "proved"),
        (r"\cos(x\pm y)=\cos x\cos y\pm\sin x\sin y", "refuted"),
        (r"\sqrt{x^2}=\pm x", "proved"),
        (r"\sqrt{x^2}=\pm y", "refuted"),
        (r"|x|=\pm 2x", "refuted"),
    ],
)
def test_of_functions_as_well(tex, verdict):
    assert oscillator().identity(tex).verdict == verdict


def test_a_claim_of_both_signs_is_as_true_as_the_worse():
    assert oscillator().integral(r"\pm(x^2+y^2)").verdict == "proved"
    assert oscillator().integral(r"x^2\pm y^2").verdict == "refuted"
    assert oscillator().integral(r"x^2\mp y^2").verdict == "refuted"
    assert oscillator().inequality(r"x^2+y^2\ge\pm2xy").verdict == "proved"
    assert oscillator().inequality(r"x^2+xy\ge\pm xy").verdict == "refuted"


@given(FACTOR, FACTOR, SIGN)
def test_what_is_supposed_for_both_signs_is_claimed_for_both(k, other, sign):
    law = System(r"\dot x=ay,\quad \dot y=-bx").where(rf"a={sign}{k}b")
    even, odd = law.identity(rf"a^2={other * other}b^2"), law.identity(rf"a={other}b")
    assert even.verdict == ("proved" if k == other else "refuted")
    assert odd.verdict == "refuted"  # for one of the signs
    same, opposite = (
        law.identity(rf"a={one}{k}b") for one in (sign, {"p": r"\mp", "m": r"\pm"}[sign[1]])
    )
    assert (same.verdict, opposite.verdict) == ("proved", "refuted")


def test_what_is_defined_for_both_signs_is_known_for_both():
    law = System(r"\dot x=ay,\quad \dot y=-ax")
    both = law.where(r"a=\pm b")
    F = both.define(r"F=b^2x^2+a^2y^2")
    assert both.integral(F).verdict == "proved"
    assert both.where("b=2").identity("a^2=4").verdict == "proved"
    assert law.scene.constants == ("a",)
    with pytest.raises(ValueError, match="of one case, or of one sign"):
        both.find_integrals(2)
