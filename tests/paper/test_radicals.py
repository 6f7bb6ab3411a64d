"""Powers with fractions as exponents: of what is positive, and derived as powers are."""

import random
from fractions import Fraction

import pytest

from kowalevski_cas import System
from tests.laws.test_prints import FEW

pytestmark = pytest.mark.usefixtures("uncorrected")


def raised(name, exponent, chance):
    """A power in one of the ways to print it."""
    above, below = abs(exponent.numerator), exponent.denominator
    sign = "-" if exponent < 0 else ""
    printed = [f"{sign}{above}/{below}", rf"{sign}\frac{{{above}}}{{{below}}}"]
    return f"{name}^{{{chance.choice(printed)}}}"


@FEW
def test_the_energy_of_a_power_of_the_coordinate(seed):
    chance = random.Random(seed)
    name = chance.choice(["x", "q_1", r"\varrho"])
    below = chance.choice([3, 4, 5, 6])
    above = chance.choice([k for k in range(-7, 9) if k % below and k != -below])
    n = Fraction(above, below)
    k = chance.choice([1, -2, 3])
    law = System(rf"\ddot {name}={-k}{raised(name, n, chance)}")
    whole = Fraction(k) / (n + 1)
    factor = rf"\frac{{{whole.numerator}}}{{{whole.denominator}}}"
    potential = raised(name, n + 1, chance) if (n + 1).denominator > 1 else f"{name}^{{{n + 1}}}"
    energy = rf"\frac12\dot {name}^2+{factor}{potential}"
    assert law.integral(energy).verdict.green, (law, energy)
    assert law.integral(energy.replace(factor, f"2{factor}")).verdict == "refuted"
    other = raised(name, n + 1 + Fraction(1, below), chance)
    assert law.integral(rf"\frac12\dot {name}^2+{factor}{other}").verdict == "refuted"


@pytest.mark.slow
@FEW
def test_powers_of_one_name_obey_the_rules_of_powers(seed):
    chance = random.Random(seed)
    system = System(r"\dot x=y,\ \dot y=-x")
    below = chance.choice([3, 4, 5])
    a, b = (Fraction(k, below) for k in chance.choice([(1, 1), (-2, 1), (1, -2), (7, -1), (2, -3)]))
    left = f"{raised('x', a, chance)}{raised('x', b, chance)}"
    assert system.identity(f"{left}={raised('x', a + b, chance)}").verdict.green
    assert system.identity(f"{left}={raised('x', a + b + 1, chance)}").verdict == "refuted"
    power, factor = raised("x", a, chance), rf"\frac{{{a.numerator}}}{{{a.denominator}}}"
    assert system.identity(rf"x\frac{{d}}{{dt}}{power}={factor}y{power}").verdict.green
    assert system.identity(rf"x\frac{{d}}{{dt}}{power}=2{factor}y{power}").verdict == "refuted"


@pytest.mark.slow
def test_a_root_beside_is_a_power_too():
    system = System(r"\ddot x=-x^{-1/3}+\sqrt x")
    true = r"\frac12\dot x^2+\frac32x^{2/3}-\frac23x^{3/2}"
    assert system.integral(true).verdict.green
    assert system.integral(true.replace("-", "+")).verdict == "refuted"
    assert system.identity(r"\sqrt x\sqrt x=x").verdict == "proved"


@pytest.mark.slow
def test_brackets_derive_by_what_is_under_the_power():
    system = System(r"H=\frac12p^2+kq^{5/3}")
    assert system.integral("H").verdict.green
    assert system.identity(r"\{p,q^{2/3}\}=-\frac23q^{-1/3}").verdict.green
    assert system.identity(r"\{p,q^{2/3}\}=\frac23q^{-1/3}").verdict == "refuted"


@pytest.mark.parametrize("tex", [r"\ddot x=-(x^2+1)^{1/3}", r"\dot x=\sin x+x^{1/3}"])
def test_what_is_no_name_has_no_such_power(tex):
    with pytest.raises(ValueError, match=r"fractions are exponents of|stands under functions"):
        System(tex)


@pytest.mark.slow
@FEW
def test_a_power_with_a_constant_is_derived_also_by_its_base(seed):
    chance = random.Random(seed)
    n, k = chance.choice([("n", "k"), (r"\gamma", "a"), ("m", r"\mu")])
    orbit = System(
        rf"H=\frac12\left(p_r^2+\frac{{p_\varphi^2}}{{r^2}}\right)+\frac{{{k}}}{{r^{{{n}}}}}"
    )
    assert orbit.integral("H").verdict == "conditional"
    assert (
        orbit.integral(rf"\frac12p_r^2+\frac{{p_\varphi^2}}{{2r^2}}-{k} r^{{-{n}}}").verdict
        == "refuted"
    )
    assert orbit.identity(rf"\{{p_r,r^{{{n}}}\}}=-{n} r^{{{n}-1}}").verdict.green
    assert orbit.identity(rf"\{{p_r,r^{{{n}}}\}}=-r^{{{n}-1}}").verdict == "refuted"
    fall = System(rf"\ddot x=-{k} x^{{-{n}}}")
    energy = rf"\frac12\dot x^2+{k}\frac{{x^{{1-{n}}}}}{{1-{n}}}"
    assert fall.integral(energy).verdict == "conditional"
    assert fall.integral(energy.replace(f"+{k}", f"-{k}")).verdict == "refuted"
