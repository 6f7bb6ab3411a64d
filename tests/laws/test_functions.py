r"""The edges of functions: branches, periods, poles, moduli, and roots and logarithms of negatives.

What is true is never refuted there, and what is false never proved.
"""

import re
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kowalevski_cas import System
from kowalevski_cas.notation import (
    Application,
    Name,
    Number,
    Power,
    Quotient,
    Sum,
    Vocabulary,
    read,
    to_latex,
)
from kowalevski_cas.notation.functions import FAMILY_OF, FUNCTIONS
from kowalevski_cas.paper.claims import EqualSolutions, Identity
from kowalevski_cas.paper.derivation import Scene, Section
from kowalevski_cas.problem import checker
from tests.laws.identities import FALSE, TRUE
from tests.paper.small import decide
from tests.sample import sampled

pytestmark = pytest.mark.usefixtures("uncorrected", "here")

MOTION = r"\dot x=y,\quad\dot y=-a\sin x"
QUARTER = r"\operatorname{sn}(K,k)=1,\quad\operatorname{cn}(K,k)=0,\quad\operatorname{dn}(K,k)=k'"
ROOT = re.compile(r"\\sqrt ?(\{(?:[^{}]|\{(?:[^{}]|\{[^{}]*\})*\})*\}|\w)")


def outcome_of(tex):
    """What becomes of an identity of the angle of a pendulum, with all that it prints declared."""
    section = Section("1", "")
    scene = Scene(variables=("x", "y"), constants=("a", "b", "g_2", "g_3"))
    scene = scene.moving(section.display("motion", MOTION))
    if "k" in tex:
        scene = scene.having(constants=("k",))
        scene = scene.solving("k'", section.display("moduli", "k^2+k'^2=1")[1])
    if "K" in tex and "K(" not in tex:
        scene = scene.having(constants=("K",)).taking(section.display("values", QUARTER))
    if r"\pi" in tex:
        scene = scene.having(constants=(r"\pi",))
    if re.search(r"(?<![a-z\\])i", tex):
        scene = scene.with_unit(section.display("i", "i^2=-1")[1])
    inside = [one if len(one) == 1 else one[1:-1] for one in ROOT.findall(tex)]
    inside += [f"({one})^2" for one in re.findall(r"\|([^|]*)\|", tex)]
    scene = scene.adjoining(*dict.fromkeys(rf"\sqrt{{{one}}}" for one in inside))
    [outcome] = decide(
        section, Identity("c", scene, "", printed=section.display("d", tex)[1]), timeout=20
    )
    return outcome


@pytest.mark.parametrize("tex", sampled(FALSE, 1))
def test_a_false_identity_is_never_proved(tex):
    assert not outcome_of(tex).verdict.green


@pytest.mark.parametrize("tex", sampled(TRUE, 10))
def test_a_true_identity_is_never_refuted(tex):
    assert str(outcome_of(tex).verdict) != "refuted"


NOT_POSITIVE = ["x", "x-1", "2y+1", "x^3", "xy", r"\sin x", r"\cos2x", r"\tan x", r"\sinh x", r"\tanh x", r"\operatorname{sn}(x,k)", r"\operatorname{cn}(x,k)", "e^x-1"]  # fmt: skip
POSITIVE = ["x^2", "1+x^2", "x^4+y^2", r"\cosh x", "e^x", r"1+\cos x", r"\sin^2x", r"\cosh x+\sinh x", r"\wp^2(x)", "2+e^{-x}"]  # fmt: skip


@pytest.mark.parametrize("tex", sampled(NOT_POSITIVE, 3))
def test_a_root_of_a_square_is_not_what_has_either_sign(tex):
    """Over the whole real line: it is false, and its opposite is as well."""
    for sign in ("", "-"):
        assert str(outcome_of(rf"\sqrt{{({tex})^2}}={sign}({tex})").verdict) == "refuted"


@pytest.mark.parametrize("tex", sampled(POSITIVE, 3))
def test_a_root_of_a_square_is_what_is_not_negative(tex):
    """That is not refuted, and of its opposite nothing is proved."""
    assert str(outcome_of(rf"\sqrt{{({tex})^2}}={tex}").verdict) != "refuted"
    assert not outcome_of(rf"\sqrt{{({tex})^2}}=-({tex})").verdict.green


@pytest.mark.parametrize("tex", sampled(["x^2", "x^2+y^2", "1+x^2", "x^2y^2", "(x-1)^2", r"\sin^2x", r"e^x", r"\cosh x"], 3))  # fmt: skip
def test_of_logarithms_and_roots_of_what_is_negative_nothing_is_said(tex):
    """They are real nowhere, or where little is left."""
    for said in (
        rf"\frac{{\partial}}{{\partial x}}\ln(-({tex}))=0",
        rf"\frac{{\partial}}{{\partial x}}\ln(-({tex}))=\frac{{\partial}}{{\partial x}}\ln(-({tex}))",
        rf"\sqrt{{-({tex})}}=\sqrt{{-({tex})}}+1",
        rf"\frac{{\partial}}{{\partial x}}\arcsin(1+{tex})=0",
    ):
        assert not outcome_of(said).verdict.green


POLES = [
    *((rf"\operatorname{{n{f}}}(x,k)\operatorname{{{f}n}}(x,k)=1", "sn") for f in "scd"),
    (r"\operatorname{cs}(x,k)\operatorname{sn}(x,k)=\operatorname{cn}(x,k)", "sn"),
    (r"\tg x\cos x=\sin x", "sin"),
    (r"\ctg x\sin x=\cos x", "sin"),
    (r"\sec x\cos x=1", "sin"),
    (r"\csc x\sin x=1", "sin"),
    (r"(1+\cos x)\tan^2\frac x2=1-\cos x", "sin"),
    (r"\coth x\sinh x=\cosh x", "sinh"),
    (r"\operatorname{csch}x\sinh x=1", "sinh"),
    (r"\wp'(x)^2=4\wp^3(x)-g_2\wp(x)-g_3", "wp"),
    (r"\frac{\partial}{\partial x}\zeta(x)=-\wp(x)", "wp"),
]


@pytest.mark.parametrize(("tex", "function"), sampled(POLES, 4))
def test_poles_are_conditions(tex, function):
    """By what vanishes there: a function of its family, or 1/℘."""
    outcome = outcome_of(tex)
    nodes = [node for one in outcome.conditions for node in one.expression.nodes()]
    met = {node.function for node in nodes if isinstance(node, Application)}
    assert str(outcome.verdict) == "conditional" and any(function in one for one in met)


@pytest.mark.slow
@given(
    st.sampled_from(["2", "3", r"\frac32", r"\frac{k}{1}", r"1+k^2"]), st.sampled_from([0, 1, 2])
)
def test_a_modulus_above_one_leads_to_one_below(modulus, wrong):
    """As solutions of one system; with another factor or another function they are none."""
    section = Section("1", "")
    scene = Scene(constants=("k",), nonzero=("k",), time="z")
    inner = rf"(({modulus})z,\frac{{1}}{{{modulus}}})"
    own = rf"(z,{modulus})"
    sides = [rf"\frac{{1}}{{{modulus}}}\operatorname{{sn}}{inner}", rf"\operatorname{{dn}}{inner}", rf"\operatorname{{cn}}{inner}"]  # fmt: skip
    for k, verdicts in ((None, ("proved", "conditional")), (wrong, ("refuted", "undecided"))):
        rows = [side if n != k else f"-{side}" for n, side in enumerate(sides)]
        tex = r",\quad ".join(rf"\operatorname{{{f}n}}{own}={row}" for f, row in zip("scd", rows, strict=True))  # fmt: skip
        display = section.display(f"d{k}", tex)
        section.claims.clear()
        [outcome] = decide(section, EqualSolutions(f"c{k}", scene, "", equations=(*display,)))
        assert str(outcome.verdict) in verdicts, tex


@pytest.mark.parametrize("function", sampled(sorted(FAMILY_OF), 8))
def test_what_is_printed_of_a_function_is_read_as_it_was(function):
    names = Vocabulary(frozenset(["u", "v", "k", "n", "g_2", "g_3"]), functions=FUNCTIONS)
    first = Sum((Name("u"), Quotient(Name("v"), Number(2))))
    parameters = tuple(map(Name, FAMILY_OF[function].parameters))
    for arguments in ((first,), (first, *parameters)):
        formula = Power(Application(function, arguments), Number(2))
        assert read(to_latex(formula), names) == formula


def test_the_checker_knows_no_function_by_name():
    words = {word for name in FAMILY_OF for word in re.findall(r"[a-z]{2,}", name)} - {"mathrm"}
    texts = [path.read_text("utf-8") for path in Path(checker.__file__).parent.glob("*.py")]
    assert texts and not words & {word for text in texts for word in re.findall("[a-z]+", text)}


def test_beside_a_potential_that_may_be_any_functions_are_derived_as_well():
    system = System(r"\dot x=p,\ \dot p=-V'(x)-\sin x-x\cos x")
    rate, cosine = r"\frac{\partial}{\partial x}(V(x)+x\sin x)=V'(x)+\sin x", r"+x\cos x"
    assert system.identity(rate + cosine).verdict.green
    assert not system.identity(rate).verdict.green
    assert system.integral(r"\frac12p^2+V(x)+x\sin x").verdict.green
    assert not system.integral(r"\frac12p^2+V(x)+\sin x").verdict.green
