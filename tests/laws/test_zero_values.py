r"""Where a name is given to be zero its functions are known: the sine is 0, the cosine 1."""

import pytest

from kowalevski_cas import System
from kowalevski_cas.verify.outcome import Verdict

PENDULUM = System(r"\ddot\theta=-\omega^2\sin\theta-2\gamma\dot\theta")
GREEN = (Verdict.PROVED, Verdict.CONDITIONAL)


@pytest.mark.parametrize(
    ("equation", "true"),
    [
        (r"\sin\theta=\theta", True),
        (r"\cos\theta=1", True),
        (r"\cos\frac\theta2=1+\sin\theta", True),
        (r"\theta\cos\theta=\sin2\theta", True),
        (r"\cos\theta=\theta", False),
        (r"\cos\theta=-1", False),
        (r"\sin\theta=1+\theta", False),
        (r"\dot\theta=\sin\theta", False),
        (r"\ddot\theta=-2\gamma\dot\theta", True),
    ],
)
def test_at_zero_the_values_of_functions_are_known(equation, true):
    found = PENDULUM.implication(equation, r"\theta=0").verdict
    assert found in GREEN if true else found is Verdict.REFUTED


@pytest.mark.parametrize(
    ("equation", "true"), [(r"e^x=1+x", True), (r"e^{2x}+\cosh x=2", True), (r"e^x=x", False)]
)
def test_so_are_those_of_exponentials(equation, true):
    system = System(r"\dot x=y, \dot y=-x+e^x\sin x")
    found = system.implication(equation, "x=0").verdict
    assert found in GREEN if true else found is Verdict.REFUTED


def test_of_an_angle_that_is_not_given_nothing_is_known():
    system = System(r"\dot x=y, \dot y=-\sin x+\varphi, \dot\varphi=\sin\varphi")
    assert system.implication(r"\sin x+\varphi=\varphi", "x=0").verdict in GREEN
    assert system.implication(r"\sin\varphi=\varphi", "x=0").verdict is Verdict.REFUTED


@pytest.mark.parametrize(("equation", "true"), [(r"\sin(kx)=0", True), (r"\sin(kx)=k", False)])
def test_a_product_vanishes_with_its_factor(equation, true):
    system = System(r"\dot x=y, \dot y=-\sin(kx)+\varphi, \dot\varphi=\sin\varphi")
    found = system.implication(equation, "x=0").verdict
    assert found in GREEN if true else found is Verdict.REFUTED


@pytest.mark.parametrize("value", [r"\theta=1", r"\theta=\gamma", r"\theta=\dot\theta"])
def test_at_another_value_nothing_is_known(value):
    found = PENDULUM.implication(r"\sin\theta=0", value)
    assert found.verdict is Verdict.ERROR
    assert "what equations say of its values is not known" in found.outcome.message
