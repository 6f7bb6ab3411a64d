"""Where a modulus is 0 or 1 elliptic functions are others: what is true then is not refuted."""

import pytest

from kowalevski_cas import System
from tests.sample import sampled

pytestmark = pytest.mark.usefixtures("uncorrected", "here")

ONES = ("1", "-1", r"\frac{2}{2}", "2-1", "k-k+1")
ZEROS = ("0", "k-k", r"\frac{0}{3}")
TRUE = [
    *((one, rf"\operatorname{{sn}}(x,{one})=\tanh x") for one in ONES),
    *((one, rf"\operatorname{{cn}}(x,{one})=\operatorname{{dn}}(x,{one})") for one in ONES),
    *((one, rf"\operatorname{{sn}}(x,{one})=\sin x") for one in ZEROS),
    *((one, rf"\operatorname{{dn}}(x,{one})=1") for one in ZEROS),
]


@pytest.mark.parametrize(("modulus", "tex"), TRUE)
def test_what_is_true_of_a_modulus_0_or_1_is_not_refuted(modulus, tex):
    assert System(r"\dot x=1,\ \dot y=kx").identity(tex).verdict != "refuted"


@pytest.mark.parametrize(
    ("relation", "right", "wrong"),
    sampled(
        [
            ("k=1", r"\tanh x", r"\sin x"),
            ("k^2=1", r"\tanh x", r"\sin x"),
            ("k=0", r"\sin x", r"\tanh x"),
        ],
        1,
    ),
)
def test_nor_where_the_constants_make_it_so(relation, right, wrong):
    special = System(r"\dot x=1,\ \dot y=kx").where(relation)
    assert special.identity(rf"\operatorname{{sn}}(x,k)={right}").verdict != "refuted"
    assert special.identity(rf"\operatorname{{sn}}(x,k)={wrong}").verdict in (
        "refuted",
        "undecided",
    )


@pytest.mark.parametrize("modulus", sampled(["k", r"\frac12", "k^2"], 1))
def test_of_another_modulus_it_is(modulus):
    system = System(r"\dot x=1,\ \dot y=kx")
    assert system.identity(rf"\operatorname{{sn}}(x,{modulus})=\tanh x").verdict == "refuted"


@pytest.mark.parametrize("m", sampled([1, 2, 3], 1))
@pytest.mark.parametrize(("sign", "sine"), [("-", r"\sinh"), ("", r"\sin")])
def test_where_the_discriminant_vanishes_that_of_weierstrass_is_elementary(m, sign, sine):
    """With a double root; what is true then is not refuted, and of a simple one it is false."""
    system = System(r"\dot x=1,\ \dot y=y")
    g_2, g_3 = rf"\frac{{{4 * m**4}}}{{3}}", rf"{sign}\frac{{{8 * m**6}}}{{27}}"
    value = rf"\frac{{{m**2}}}{{{sine}^2({m}x)}}{'+' if sign else '-'}\frac{{{m**2}}}{{3}}"
    assert system.identity(rf"\wp(x,{g_2},{g_3})={value}").verdict != "refuted"
    assert not system.identity(rf"\wp(x,{g_2},{g_3}+1)={value}").verdict.green
    assert system.identity(r"\wp(x,0,0)=\frac{1}{x^2}").verdict.green


@pytest.mark.parametrize("name", ["g_2=3a^2, g_3=a^3", "g_2=12a^4, g_3=-8a^6"])
def test_nor_where_definitions_make_it_vanish(name):
    system = System(r"\dot x=1,\ \dot y=ay")
    for definition in name.split(", "):
        system.define(definition)
    assert system.identity(r"\wp(x,g_2,g_3)=\frac{1}{x^2}").verdict != "refuted"
