"""Functions that nothing gives: what is said of them holds for all, and fails for one of them."""

import random

import pytest

from kowalevski_cas import System
from tests.laws.test_prints import FEW

pytestmark = pytest.mark.usefixtures("uncorrected")

POLYNOMIALS = ["{x}^2", "{x}^3-{x}", "-\\frac{{1}}{{{x}}}", "2{x}^4+{x}"]


@FEW
def test_a_potential_may_be_any_function(seed):
    """What is true of V(r) is true where V is given, and what is false is false for some V."""
    chance = random.Random(seed)
    V, r = chance.choice(["V", "U", r"\Phi"]), chance.choice(["r", r"\varrho"])
    phi = chance.choice([r"\varphi", r"\theta"])
    kinetic = rf"\frac m2(\dot {r}^2+{r}^2\dot {phi}^2)"
    laws = {
        rf"L={kinetic}-{V}({r})",
        rf"m(\ddot {r}-{r}\dot {phi}^2)=-{V}'({r}),\ \frac{{d}}{{dt}}(m{r}^2\dot {phi})=0",
    }
    tex = chance.choice(sorted(laws))
    law = System(tex)
    assert f"{V}" not in law.scene.constants and "any function" in repr(law)
    true = [f"{kinetic}+{V}({r})", rf"{r}^2\dot {phi}"]
    false = [f"{kinetic}-{V}({r})", f"{V}({r})", rf"\dot {phi}", rf"{kinetic}+{V}'({r})"]
    for claim in true:
        assert law.integral(claim).verdict.green, (law, claim)
    for claim in false:
        assert law.integral(claim).verdict == "refuted", (law, claim)
    if tex[0] == "L":
        given = System(f"{tex},\\ {V}({r})={chance.choice(POLYNOMIALS).format(x=r)}")
        assert all(given.integral(claim).verdict.green for claim in true)


@FEW
def test_a_hamiltonian_with_any_function(seed):
    chance = random.Random(seed)
    V, (q, p) = chance.choice("VUW"), chance.choice([("q", "p"), ("x", "p_x"), ("q_1", "p_1")])
    law = System(rf"H=\frac{{{p}^2}}{{2m}}+{V}({q})")
    assert law.integral("H").verdict.green
    assert law.identity(rf"\dot {p}=-{V}'({q})").verdict.green
    assert law.identity(rf"\dot {p}={V}'({q})").verdict == "refuted"
    assert law.identity(rf"\{{{p},{V}({q})\}}=-{V}'({q})").verdict.green
    assert law.identity(rf"\{{{p},{V}({q})\}}={V}'({q})").verdict == "refuted"
    assert law.integral(p).verdict == "refuted"


@FEW
def test_a_frequency_may_be_any_function_of_the_time(seed):
    chance = random.Random(seed)
    w = chance.choice([r"\omega^2(t)", r"\omega(t)^2", "k(t)", r"\left(1+f(t)\right)"])
    law = System(rf"\ddot x+{w}x=0,\ \ddot y+{w}y=0")
    assert law.integral(r"x\dot y-y\dot x").verdict.green
    assert law.integral(r"x\dot y+y\dot x").verdict == "refuted"
    assert law.integral(rf"\dot x^2+{w}x^2").verdict == "refuted"


def test_a_force_of_the_time_is_integrated_by_its_integral():
    law = System(r"\dot x=f(t),\ \dot y=2f(t)+z,\ \dot z=0")
    assert law.integral(r"z").verdict == "proved"
    assert law.identity(r"\ddot y=2f'(t)").verdict == "proved"
    assert law.identity(r"\ddot y=f'(t)").verdict == "refuted"
    fall = System(r"m\ddot x=F(x)")
    assert fall.identity(r"m\frac{d}{dt}\ddot x=F'(x)\dot x").verdict == "conditional"


@pytest.mark.parametrize("argument", ["0", "2r", "s", "-r"])
def test_a_function_is_known_at_its_argument_only(argument):
    law = System(r"\ddot r=-V'(r)")
    try:
        assert law.integral(rf"\dot r^2+2V({argument})").verdict == "error"
    except ValueError as error:
        assert "is not known" in str(error)


@pytest.mark.parametrize(
    ("tex", "moving"),
    [
        (r"\ddot x=k(x+1)", "x"), (r"\dot x(t)=y(t),\ \dot y(t)=-x(t)", "x y"),
        (r"\dot x=\varphi(x),\ \varphi(s)=s^2", "x"), (r"\ddot x=-\sin(x)", "x"),
    ],
)  # fmt: skip
def test_what_is_a_product_or_is_given_is_no_unknown_function(tex, moving):
    law = System(tex)
    assert " ".join(law.scene.variables) == moving and not law.scene.jets


def test_of_any_function_no_dependence_and_no_set_is_claimed():
    law = System(r"H=\frac12p^2+V(q)")
    for ask in (
        lambda: law.integrable("H"), lambda: law.invariant("p=0"), lambda: law.find_integrals(2),
        lambda: law.integral("H", given=("p=0",)), lambda: law.implication("p=0", "q=0"),
    ):  # fmt: skip
        with pytest.raises(ValueError, match="may be any"):
            ask()
