"""Functions that nothing gives: what is said of them holds for all, and fails for one of them."""

import random

import pytest

from kowalevski_cas import System
from tests.laws.test_prints import FEW

pytestmark = pytest.mark.usefixtures("uncorrected")

POLYNOMIALS = ["{x}^2", "{x}^3-{x}", "-\\frac{{1}}{{{x}}}", "2{x}^4+{x}"]


@pytest.mark.slow
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


@pytest.mark.slow
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


@pytest.mark.slow
@FEW
def test_a_potential_is_derived_by_what_moves(seed):
    """It is the same potential however its derivative is printed, and a function of no more."""
    chance = random.Random(seed)
    U, x = chance.choice(["U", "V", r"\Pi"]), chance.choice(["x", "s", r"\xi", "q_1"])
    rate = chance.choice([rf"\dot {x}", rf"\frac{{d{x}}}{{dt}}"])
    by = chance.choice(
        [
            rf"\frac{{d{U}}}{{d{x}}}", rf"\frac{{\partial {U}}}{{\partial {x}}}", rf"{U}'({x})",
            rf"\frac{{\mathrm d{U}({x})}}{{\mathrm d{x}}}", rf"d{U}/d{x}",
            rf"\partial {U}/\partial {x}",
        ]
    )  # fmt: skip
    law = System(
        rf"{rate}=v,\ m\frac{{dv}}{{dt}}=-{by}" if "frac" in rate else rf"{rate}=v,\ m\dot v=-{by}"
    )
    named = chance.choice([U, f"{U}({x})"])
    assert law.integral(rf"\frac{{mv^2}}{{2}}+{named}").verdict.green, law
    assert law.integral(rf"\frac{{mv^2}}{{2}}-{named}").verdict == "refuted", law
    assert law.integral(named).verdict == "refuted", law
    assert law.identity(rf"m\dot v=-\frac{{d{U}}}{{d{x}}}").verdict.green
    assert law.identity(rf"m\dot v=\frac{{d{U}}}{{d{x}}}").verdict == "refuted"


@pytest.mark.slow
@FEW
def test_a_potential_may_be_a_function_of_all_coordinates(seed):
    chance = random.Random(seed)
    names = chance.choice([("x", "y"), ("q_1", "q_2"), ("r", r"\theta")])
    U, form = chance.choice("UVW"), chance.choice(["hamilton", "newton", "vector", "lagrange"])
    listed, (x, y) = ",".join(names), names
    if form == "hamilton":
        px, py = ("p_1", "p_2") if "_" in x else (f"p_{x}", f"p_{y}")
        law = System(rf"H=\frac12({px}^2+{py}^2)+{U}({listed})")
        kinetic = rf"\frac12({px}^2+{py}^2)"
    else:
        kinetic = rf"\frac12(\dot {x}^2+\dot {y}^2)"
        law = System(
            {
                "newton": rf"\ddot {x}=-\frac{{\partial {U}}}{{\partial {x}}},\ "
                rf"\ddot {y}=-\frac{{\partial {U}}}{{\partial {y}}}",
                "vector": rf"\ddot{{\mathbf r}}=-{chance.choice(['', 'o'])}"
                rf"\nabla {U},\ \mathbf r=({listed})".replace("-o", "-"),
                "lagrange": rf"L={kinetic}-{U}({listed})",
            }[form]
        )
    assert law.integral(f"{kinetic}+{U}").verdict.green, law
    for false in (f"{kinetic}-{U}", kinetic, U):
        assert law.integral(false).verdict == "refuted", (law, false)


@pytest.mark.slow
@FEW
def test_a_potential_of_the_distance_turns_no_moment(seed):
    """A function of the length of a vector has a gradient along it; one of the vector has any."""
    chance = random.Random(seed)
    r, bold = chance.choice([("r", r"\mathbf r"), ("q", r"\boldsymbol q"), ("r", r"\vec r")])
    parts, U = chance.choice(["(x,y)", "(x,y,z)"]), chance.choice(["U", "V"])
    length = chance.choice(["", rf",\ {r}=|{bold}|"])
    gradient = chance.choice([rf"\nabla {U}({r})", rf"{U}'({r})\frac{{{bold}}}{{{r}}}"])
    central = System(rf"m\ddot{{{bold}}}=-{gradient},\ {bold}={parts}{length}")
    energy = rf"\frac m2\dot{{{bold}}}^2"
    assert central.integral(r"x\dot y-y\dot x").verdict.green, central
    assert central.integral(f"{energy}+{U}({r})").verdict.green, central
    assert central.integral(f"{energy}-{U}({r})").verdict == "refuted"
    any_force = System(rf"m\ddot{{{bold}}}=-\nabla {U}({bold}),\ {bold}={parts}")
    assert any_force.integral(f"{energy}+{U}").verdict.green
    assert any_force.integral(r"x\dot y-y\dot x").verdict == "refuted"


@pytest.mark.slow
def test_of_canonical_equations_any_hamiltonian_is_an_integral():
    law = System(r"\dot q=\frac{\partial H}{\partial p},\ \dot p=-\frac{\partial H}{\partial q}")
    assert law.integral("H").verdict == "proved"
    assert law.integral("p").verdict == "refuted"
    other = System(r"\dot q=\frac{\partial H}{\partial p},\ \dot p=\frac{\partial H}{\partial q}")
    assert other.integral("H").verdict == "refuted"
    depends_on_time = System(r"H=\frac{p^2}{2m}+V(q,t)")
    assert depends_on_time.integral("H").verdict == "refuted"
    assert depends_on_time.identity(r"\frac{dH}{dt}=\frac{\partial V}{\partial t}").verdict.green
