"""Constraints with multipliers, as they are printed: the motion is on them, and so is what is claimed."""

import random

import pytest
from sympy import Symbol, latex

from kowalevski_cas import System
from tests.laws.test_prints import FEW

pytestmark = pytest.mark.usefixtures("uncorrected")

x, y, z = XYZ = [Symbol(letter) for letter in "xyz"]
CURVES = [(x**2 + y**2, "x^2+y^2=a^2"), (x * y, "xy=1"), (y - x**2, "y=x^2"), (x + 2 * y, "x+2y=0")]
SURFACES = [
    (x**2 + y**2 + z**2, r"x^2+y^2+z^2=\ell^2"),
    (x**2 + y**2 - z, "x^2+y^2=z"),
    (x**2 + 2 * y**2 + 3 * z**2, "x^2+2y^2+3z^2=1"),
    (x - y + z, "x-y+z=0"),
]


@pytest.mark.slow
@FEW
def test_energy_is_constant_where_the_reaction_is_normal(seed):
    chance = random.Random(seed)
    several = chance.random() < 0.5
    names = XYZ if several else XYZ[:2]
    f, printed = chance.choice(SURFACES if several else CURVES)
    U = chance.choice([2 * names[-1], x**2, x**2 - 3 * y**2, x * y])
    m, multiplier = chance.choice(["", "m"]), chance.choice([r"\lambda", r"2\lambda", r"-\lambda"])

    def law(f):
        rows = [
            rf"{m}\ddot {n}={latex(-U.diff(n))}{'' if multiplier[0] == '-' else '+'}{multiplier}\cdot({latex(f.diff(n))})"
            for n in names
        ]
        rows.insert(chance.randrange(len(rows) + 1), printed)
        return System(",\\ ".join(rows))

    squares = "+".join(rf"\dot {n}^2" for n in names)
    kinetic = rf"\frac{{{m or 1}}}2({squares})"
    system = law(f)
    assert all(str(n) in system.scene.variables for n in names)
    assert not {r"\lambda", "x", "y"} & {*system.scene.constants}
    assert system.integral(f"{kinetic}+({latex(U)})").verdict.green, system
    assert system.integral(f"{kinetic}-({latex(U)})").verdict == "refuted"
    assert system.identity(printed).verdict.green
    assert system.identity(f"{printed.replace('=', '+1=')}").verdict == "refuted"
    rough = law(f + 3 * x * names[-1] + x)  # the reaction is not normal
    assert rough.integral(f"{kinetic}+({latex(U)})").verdict == "refuted"


@pytest.mark.slow
@FEW
def test_a_body_that_does_not_turn_about_an_axis_keeps_its_energy(seed):
    """Suslov's problem, in components and with vectors."""
    chance = random.Random(seed)
    a = [chance.randint(-2, 3) or 1 for _ in range(3)]
    letter = chance.choice([r"\lambda", r"\mu"])
    rows = [
        rf"I_{i}\dot\omega_{i}=(I_{j}-I_{k})\omega_{j}\omega_{k}+{letter}\cdot({a[i - 1]})"
        for i, j, k in ((1, 2, 3), (2, 3, 1), (3, 1, 2))
    ]
    constraint = "".join(rf"{a[k]:+}\omega_{k + 1}" for k in range(3)).lstrip("+") + "=0"
    vectors = (
        r"\mathbf I\dot{\boldsymbol\omega}=\mathbf I\boldsymbol\omega\times\boldsymbol\omega"
        rf"+{letter}\boldsymbol a,\ (\boldsymbol a,\boldsymbol\omega)=0,\ "
        r"\mathbf I=\operatorname{diag}(I_1,I_2,I_3)"
    )
    for tex in (",\\ ".join([*rows, constraint]), vectors):
        body = System(tex)
        assert body.integral(r"\sum_{i=1}^3I_i\omega_i^2").verdict == "conditional"
        assert body.integral(r"\sum_{i=1}^3I_i^2\omega_i^2").verdict == "refuted"


@pytest.mark.slow
def test_a_sleigh_has_a_constraint_that_is_not_integrable():
    sleigh = System(
        r"m\ddot x=\lambda\sin\varphi,\ m\ddot y=-\lambda\cos\varphi,\ I\ddot\varphi=0,\ "
        r"\dot x\sin\varphi-\dot y\cos\varphi=0"
    )
    energy = r"\frac m2(\dot x^2+\dot y^2)+\frac I2\dot\varphi^2"
    assert sleigh.integral(energy).verdict == "conditional"
    assert sleigh.integral(r"\dot x\cos\varphi+\dot y\sin\varphi").verdict == "conditional"
    assert sleigh.integral(r"\dot x").verdict == "refuted"


@pytest.mark.parametrize(
    ("tex", "message"),
    [
        (r"\ddot x=\lambda x/r,\ \ddot y=\lambda y/r,\ x^2+y^2=r^2", "a constraint, or a name"),
        (r"\ddot x=\lambda x+\lambda_1,\ \ddot y=\lambda y,\ x^2+y^2=1", "print as many"),
        (
            r"\ddot x=\lambda y,\ \ddot y=-\lambda x,\ x^2+y^2=1",
            "gives no multiplier|do not determine",
        ),
        (r"\ddot x=\lambda^2x,\ \ddot y=\lambda y,\ x^2+y^2=1", "do not stand linearly"),
    ],
)
def test_what_is_no_constraint_with_its_multiplier_is_refused(tex, message):
    with pytest.raises(ValueError, match=message):
        System(tex)


@pytest.mark.parametrize(
    "tex",
    [
        r"\ddot x=-\frac{\mu x}{r^3},\ \ddot y=-\frac{\mu y}{r^3},\ x^2+y^2=r^2",
        r"\ddot x=-\lambda x/r^3,\ \ddot y=-\lambda y/r^3,\ r^2=x^2+y^2",
        r"\dot u_i=\lambda u_i(u_{i+1}-u_{i-1}),\ i=1,2,3,\ u_{i+3}=u_i",
        r"\dot{\mathbf M}=\lambda\mathbf M\times\boldsymbol\omega,\ \mathbf M=\mathbf I\boldsymbol\omega,"
        r"\ \mathbf I=\operatorname{diag}(a,b,c)",
    ],
)
def test_a_name_beside_a_constant_is_no_constraint(tex):
    assert not System(tex).law.constraints


def test_on_constraints_only_what_is_claimed_of_sets_is_claimed():
    system = System(r"\ddot x=\lambda x,\ \ddot y=\lambda y,\ x^2+y^2=1")
    assert system.invariant("x=0", r"\dot x=0").verdict.green
    with pytest.raises(ValueError, match="not known on constraints"):
        system.darboux("x", "0")
