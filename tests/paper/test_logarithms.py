"""First integrals with logarithms, of which only derivatives are stated."""

import pytest

from kowalevski_cas import System
from kowalevski_cas.paper.derivation import Derivation
from kowalevski_cas.verify.outcome import Verdict
from kowalevski_cas.verify.run import Session
from tests.sample import sampled

pytestmark = pytest.mark.usefixtures("uncorrected", "here")

VOLTERRA = r"\dot x=\alpha x-\beta xy,\quad \dot y=\delta xy-\gamma y"
INTEGRAL = r"\delta x-\gamma\ln x+\beta y-\alpha\ln y"


@pytest.fixture(scope="module")
def volterra():
    return System(VOLTERRA)


@pytest.mark.parametrize(
    "tex",
    sampled(
        [
            INTEGRAL,
            INTEGRAL + r"=\mathrm{const}",
            r"\frac{\delta x-\gamma\ln|x|}{\alpha}+\frac{\beta y}{\alpha}-\ln|y|",
            r"-(\gamma\ln x-\delta x)+\beta y-\frac{\alpha}{2}\ln y^2+1",
            r"\delta x+\beta y-\frac{\alpha-\gamma}{2}\ln\frac{y}{x}-\frac{\alpha+\gamma}{2}\ln(xy)",
        ],
        2,
    ),
)
def test_the_integral_of_volterra(volterra, tex):
    claim = volterra.integral(tex)
    assert claim.verdict is Verdict.CONDITIONAL
    assert {"x ≠ 0", "y ≠ 0"} <= set(
        repr(claim).partition("where ")[2].partition(";")[0].split(", ")
    )


@pytest.mark.parametrize(("old", "new"), sampled([("-", "+"), (r"\gamma", r"\alpha"), (r"\ln x", r"\ln y"), ("y", "y^2"), (r"\ln x", r"2\ln x")], 1))  # fmt: skip
def test_a_mutant_is_refuted(volterra, old, new):
    for k in range(INTEGRAL.count(old)):
        pieces = INTEGRAL.split(old)
        mutant = old.join(pieces[: k + 1]) + new + old.join(pieces[k + 1 :])
        assert volterra.integral(mutant).verdict is Verdict.REFUTED, mutant


@pytest.mark.parametrize("tex", [r"\ln\frac{x}{x}", r"\ln x-\ln|x|", r"\ln x^2-2\ln x", r"\ln 2"])
def test_what_is_constant_by_itself_is_no_integral(volterra, tex):
    assert volterra.integral(tex).verdict is Verdict.REFUTED


@pytest.mark.parametrize(
    ("tex", "message"),
    [
        (r"x\ln x", "with a constant factor only"),
        (r"\ln\ln x", "with a constant factor only"),
        (r"(\ln x)^2", "with a constant factor only"),
        (r"\frac{\ln x}{y}", "with a constant factor only"),
        (r"\ln x=\ln y", "is claimed by itself"),
    ],
)
def test_other_functions_with_logarithms_are_not_decided(volterra, tex, message):
    outcome = volterra.integral(tex).outcome
    assert outcome.verdict is Verdict.ERROR and message in outcome.message


DERIVED = [
    (r"\frac{\partial}{\partial x}\ln x=\frac1x", "conditional"),
    (r"\frac{\partial}{\partial x}\ln x=-\frac1x", "refuted"),
    (r"\frac{\partial}{\partial x}\ln|x|=\frac1x", "conditional"),
    (r"\frac{\partial}{\partial x}\ln(x^2+y^2)=\frac{2x}{x^2+y^2}", "conditional"),
    (r"\frac{\partial}{\partial x}\ln(-x)=\frac1x", "conditional"),
    (r"\frac{\partial}{\partial x}\ln(-x)=-\frac1x", "refuted"),
    (r"\frac{\partial}{\partial x}\ln(-x^2)=\frac2x", "error"),  # it is real nowhere
    (r"\frac{\partial^2}{\partial x^2}\ln x=-\frac1{x^2}", "conditional"),
    (r"\frac{\partial^2}{\partial x^2}\ln x=\frac1{x^2}", "refuted"),
    (r"\frac{\partial}{\partial x}\arctan\frac yx=-\frac y{x^2+y^2}", "conditional"),
    (r"\frac{\partial}{\partial x}\arctan\frac yx=\frac y{x^2+y^2}", "refuted"),
    (r"\frac{\partial}{\partial x}\arcsin x=\frac1{\sqrt{1-x^2}}", "conditional"),
    (r"\frac{\partial}{\partial x}\arccos x=\frac1{\sqrt{1-x^2}}", "refuted"),
    (r"\frac{\partial}{\partial x}\ln\cos x=-\tan x", "conditional"),
    (r"\frac{\partial}{\partial x}\ln(\operatorname{dn}(x,k)-k\operatorname{cn}(x,k))=k\operatorname{sn}(x,k)", "conditional"),
    (r"\frac{\partial}{\partial x}\ln(\operatorname{dn}(x,k)+k\operatorname{cn}(x,k))=k\operatorname{sn}(x,k)", "refuted"),
    (r"\frac{d}{dt}\ln y=k+\frac xy", "conditional"),
    (r"\frac{d}{dt}\ln y=k-\frac xy", "refuted"),
    (r"\frac{d}{dt}\arctan y=\frac{ky+x}{1+y^2}", "conditional"),
    (r"\frac{\partial}{\partial x}(x\ln x)=\ln x+1", "error"),  # of the value nothing is known
    (r"\ln x^2=2\ln x", "error"),
    (r"\ln(xy)=\ln x-\ln y", "error"),
    (r"\arctan x=\arctan(-x)", "error"),
]  # fmt: skip


@pytest.mark.parametrize(("tex", "verdict"), sampled(DERIVED, 8))
def test_where_they_are_derived_they_are_known(tex, verdict):
    """At points where they are real; of their values nothing is known."""
    assert System(r"\dot x=1,\quad\dot y=ky+x").identity(tex).verdict == verdict


@pytest.mark.slow
def test_all_arithmetics_and_the_checker_agree(tmp_path):
    from kowalevski_cas.cli import main

    system = System(VOLTERRA, "volterra")
    system.integral(INTEGRAL)
    run = Session(
        Derivation("v", "", "", "", (system.section,)), ["flint", "symengine", "sympy"]
    ).run()
    assert [one.verdict for one in run.outcomes] == [Verdict.CONDITIONAL]
    file = tmp_path / "volterra.py"
    file.write_text(
        f"from kowalevski_cas import System\nv = System(r'{VOLTERRA}')\nv.integral(r'{INTEGRAL}')\n"
        f"v.integral(r'{INTEGRAL.replace('-', '+')}', expect='refuted')\n"
    )
    assert main(["record", str(file)]) == 0 and main(["check", str(file)]) == 0


@pytest.mark.parametrize(
    "tex",
    [
        r"\frac{d}{dt}\ln\frac{\dot x}{x}=\frac{\ddot x}{\dot x}-\frac{\dot x}{x}",
        r"\sqrt{\dot x\dot y}\sqrt{\dot x\dot y}=\dot x\dot y",
    ],
)
def test_a_root_of_rates_is_certified(volterra, tex):
    assert volterra.identity(tex).verdict in (Verdict.CONDITIONAL, Verdict.PROVED)


def test_a_false_equation_with_the_logarithm_of_a_rate_is_refuted(volterra):
    assert volterra.identity(r"\frac{d}{dt}\ln\dot x=\frac{\dot x}{x}").verdict is Verdict.REFUTED
