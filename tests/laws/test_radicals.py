r"""Roots of higher order, as :math:`\sqrt[3]{x^2}`: of odd order they are real at all points."""

import random

import pytest

from kowalevski_cas import System
from tests.laws.test_prints import FEW

pytestmark = pytest.mark.usefixtures("uncorrected")


@FEW
def test_roots_obey_the_law_of_exponents(seed):
    chance = random.Random(seed)
    n, (k, m) = chance.choice([3, 5]), (chance.randint(1, 4) for _ in "km")
    x = chance.choice(["x", "a"])
    law = System(r"\dot x=ax")
    product = rf"\sqrt[{n}]{{{x}^{k}}}\sqrt[{n}]{{{x}^{m}}}"
    assert law.identity(rf"{product}=\sqrt[{n}]{{{x}^{k + m}}}").verdict.green
    assert law.identity(rf"{product}=\sqrt[{n}]{{{x}^{k + m + 1}}}").verdict == "refuted"
    assert law.identity(rf"\sqrt[{n}]{{{x}}}^{n}={x}").verdict.green
    assert law.identity(rf"\sqrt[{n}]{{-{x}}}=-\sqrt[{n}]{{{x}}}").verdict.green
    assert law.identity(rf"\sqrt[{n}]{{-{x}}}=\sqrt[{n}]{{{x}}}").verdict == "refuted"
    rate = rf"\frac{{{k}}}{{{n}}}a\sqrt[{n}]{{x^{k}}}"
    assert law.identity(rf"\frac{{d}}{{dt}}\sqrt[{n}]{{x^{k}}}={rate}").verdict.green
    assert law.identity(rf"\frac{{d}}{{dt}}\sqrt[{n}]{{x^{k}}}=-{rate}").verdict == "refuted"


@pytest.mark.parametrize(
    "false",
    [
        r"\sqrt[3]{x^3}=|x|", r"\sqrt[3]{x}\sqrt[3]{x^2}=|x|", r"\sqrt[3]{x}=|\sqrt[3]{x}|",
        r"\sqrt[5]{x^6}=|x|\sqrt[5]{x}\cdot\frac{x}{|x|}\cdot\frac{|x|}{x}", r"\sqrt[3]{x^2}=x", r"\sqrt[3]{x}=\sqrt[5]{x}",
    ],
)  # fmt: skip
def test_an_odd_root_has_the_sign_of_what_stands_under_it(false):
    assert not System(r"\dot x=1").identity(false).verdict.green


@pytest.mark.parametrize(
    "formula", [r"\sqrt[4]{x^2}=\sqrt x", r"\sqrt[3]{x+1}=1", r"\sqrt[6]{x^2}=\sqrt[3]{x}"]
)
def test_roots_that_are_not_known_are_refused_with_what_to_print(formula):
    claim = System(r"\dot x=1").identity(formula)
    assert claim.verdict == "error" and "print roots of powers" in claim.outcome.message


def test_even_roots_are_those_of_what_is_positive():
    law = System(r"\dot x=1")
    assert law.identity(r"\sqrt[4]{x}^2=\sqrt x").verdict.green
    assert law.identity(r"\sqrt[4]{x^3}=x^{3/4}").verdict.green
    assert law.identity(r"\sqrt[4]{x^3}=-x^{3/4}").verdict == "refuted"


@pytest.mark.parametrize("supposed", [(), ("x>0",)])
def test_a_hamiltonian_with_cube_roots_has_its_integral(supposed):
    """A potential of Holt, with roots in the Hamiltonian and powers in the integral."""
    holt = System(
        r"H=\frac12(p_x^2+p_y^2)+\frac34\sqrt[3]{x^4}+\frac{y^2+\delta}{\sqrt[3]{x^2}}"
    ).where(*supposed)
    third = r"2p_y^3+3p_x^2p_y+3p_y(-3x^{4/3}+2(y^2+\delta)x^{-2/3})+18p_xyx^{1/3}"
    assert holt.integral("H").verdict.green and holt.integral(third).verdict.green
    assert holt.integral(third.replace("-3x", "+3x")).verdict == "refuted"
