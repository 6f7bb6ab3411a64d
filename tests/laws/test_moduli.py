"""Where a modulus is 0 or 1 elliptic functions are others: what is true then is not refuted."""

import pytest

from kowalevski_cas import System

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
    [
        ("k=1", r"\tanh x", r"\sin x"),
        ("k^2=1", r"\tanh x", r"\sin x"),
        ("k=0", r"\sin x", r"\tanh x"),
    ],
)
def test_nor_where_the_constants_make_it_so(relation, right, wrong):
    special = System(r"\dot x=1,\ \dot y=kx").where(relation)
    assert special.identity(rf"\operatorname{{sn}}(x,k)={right}").verdict != "refuted"
    assert special.identity(rf"\operatorname{{sn}}(x,k)={wrong}").verdict in (
        "refuted",
        "undecided",
    )


@pytest.mark.parametrize("modulus", ["k", r"\frac12", "k^2"])
def test_of_another_modulus_it_is(modulus):
    system = System(r"\dot x=1,\ \dot y=kx")
    assert system.identity(rf"\operatorname{{sn}}(x,{modulus})=\tanh x").verdict == "refuted"
