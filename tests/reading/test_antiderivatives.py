"""Integrals by the time without limits: what they are said to be is derived."""

import pytest

from kowalevski_cas.reading import CLAIM
from kowalevski_cas.verify.outcome import Verdict
from tests.sample import sampled

from .test_reading import reading, verdicts

LAW = r"""The equations of motion are \[ \dot x=y,\qquad \dot y=-\kappa^2x . \] We find
\[ \int %s\,\mathrm{d}t=%s . \]"""


def verdict(inner, value):
    return next((v for tex, v in verdicts(LAW % (inner, value)).items() if "dt" in tex), None)


@pytest.mark.parametrize(
    ("inner", "value"),
    sampled(
        [
            (r"\frac{1}{1-n\tanh^2\lambda t}",
             r"\frac{t}{1-n}-\frac{\sqrt n}{(1-n)\lambda}\operatorname{artanh}(\sqrt n\tanh\lambda t)"),
            (r"\frac{\kappa}{\cosh^2(\kappa t)}", r"\tanh(\kappa t)"),
            (r"te^{-\beta t}", r"-\frac{(1+\beta t)e^{-\beta t}}{\beta^2}"),
            (r"(x+ty)", r"tx"),
        ],
        2,
    ),
)  # fmt: skip
def test_an_integral_is_what_has_this_rate(inner, value):
    assert verdict(inner, value).green


@pytest.mark.parametrize(
    ("inner", "value"),
    sampled(
        [
            (r"\frac{1}{1-n\tanh^2\lambda t}",
             r"\frac{t}{1-n}+\frac{\sqrt n}{(1-n)\lambda}\operatorname{artanh}(\sqrt n\tanh\lambda t)"),
            (r"\frac{1}{\cosh^2(\kappa t)}", r"\tanh(\kappa t)"),
            (r"te^{-\beta t}", r"-\frac{(1-\beta t)e^{-\beta t}}{\beta^2}"),
            (r"2x", r"2tx"),  # x moves
            (r"3y", r"3ty"),
            (r"\sin\kappa t", r"\frac1\kappa\cos\kappa t"),
            (r"t^2", r"\frac{t^3}{2}"),
            (r"\frac1t", r"2\ln t"),
        ],
        3,
    ),
)  # fmt: skip
def test_nothing_else_is(inner, value):
    found = verdict(inner, value)
    assert found in (Verdict.REFUTED, Verdict.UNDECIDED)


@pytest.mark.parametrize("tex", [r"\int_0^t s\,ds=t^2", r"\int y\,dx=xy", r"\int x\,dt=c"])
def test_other_integrals_are_not_read(tex):
    assert CLAIM not in {f.role.name for f in reading(rf"We find \[ {tex} . \]").formulas}
