"""Equations of motion at random: two readers that share no code find the same rates in them."""

import cmath
import random
from contextlib import suppress

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from sympy import lambdify

from kowalevski_cas import System
from kowalevski_cas.notation import (
    Name,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Root,
    Sum,
    to_latex,
)
from tests.laws.test_prints import field
from tests.notation import numbers as n
from tests.notation.second_reader import Words, read

MOVING, STILL = ["x", "y", r"\theta"], ["a", "k_1", r"\omega"]
WORDS = Words(
    ranks=dict.fromkeys(["x", "y", "theta", "a", "k_1", "omega"], 0),
    functions=set(),
    times={"dot", "t"},
    moving={"x", "y", "theta"},
)

_names = st.sampled_from([*MOVING, *STILL]).map(Name)
_several = lambda items: st.lists(items, min_size=2, max_size=3).map(tuple)  # noqa: E731
_formulas = st.recursive(
    st.one_of(_names, st.integers(1, 20).map(Number)),
    lambda inner: st.one_of(
        st.builds(Sum, _several(st.one_of(inner, inner.map(Negative)))),
        st.builds(Product, _several(inner)),
        st.builds(Quotient, inner, inner),
        st.builds(Power, inner, st.integers(1, 3).map(Number)),
        st.builds(Power, _names, st.just(Quotient(Number(3), Number(2)))),
        st.builds(Root, _names),
    ),
    max_leaves=8,
)
RATES = {"x": [r"\dot x", r"\frac{dx}{dt}", "dx/dt"], "y": [r"\dot{y}", "dy/dt"]}
RATES[r"\theta"] = [r"\dot\theta", r"\frac{d\theta}{dt}"]
NOISE = [("(", r"\left("), (")", r"\right)"), (r"\frac", r"\dfrac"), ("+", r"\,+\,")]


@st.composite
def prints(draw):
    """Equations of motion in one of the ways to print them."""
    rows = []
    for name in MOVING:
        left, right = draw(st.sampled_from(RATES[name])), to_latex(draw(_formulas))
        scale = draw(st.sampled_from(["", "2", "a", "-"]))
        rows.append((name, f"{scale}{left}", right))
    noise = [pair for pair in NOISE if draw(st.booleans())]
    if {"(", ")"} & {one for one, _ in noise}:
        noise = [*{*noise, *NOISE[:2]}]
    tex = [f"{left}={right}" for _, left, right in rows]
    for one, other in noise:
        tex = [row.replace(one, other) for row in tex]
    order = draw(st.permutations(tex))
    form = draw(st.sampled_from([",\\quad ", ",\\ ", "\\\\\n"]))
    return form.join(order)


def value_of(name, point):
    """The value of a name, or of the root of one."""
    root = name.startswith("sqrt")
    value = complex(point.scalar(name.removeprefix("sqrt"))[()])
    return cmath.sqrt(value) if root else value


def rates_agree(tex, seed):
    """Whether the rates of a system solve its equations, as the second reader reads them."""
    system = System(tex)
    found = field(system)
    point = n.Point(seed, {"dot", "t"})
    symbols = {s for rate in found.values() for s in rate.free_symbols}
    at = {s: value_of(str(s), point) for s in symbols}
    rates = {
        name: complex(lambdify([*at], rate, "cmath")(*at.values())) for name, rate in found.items()
    }
    for name, rate in rates.items():  # the rates by both marks are those that were found
        point.scalar(name).terms |= {("dot",): rate, ("t",): rate}
    return all(
        abs(left[()] - right[()]) <= 1e-6 * (1 + abs(right[()]))
        for (left, right), _ in read(tex, WORDS, point)
    )


@pytest.mark.slow
@given(prints(), st.integers(0, 10**6))
@settings(max_examples=25, suppress_health_check=[HealthCheck.too_slow])
def test_two_readers_find_the_same_rates(tex, seed):
    with suppress(ArithmeticError):  # a pole
        assert rates_agree(tex, seed), tex


@pytest.mark.parametrize("seed", range(3))
def test_a_sign_more_is_seen(seed):
    chance = random.Random(seed)
    tex = chance.choice([r"\dot x=ay-x^2,\ \dot y=x", r"dx/dt=\sqrt y,\ \frac{dy}{dt}=-x"])
    assert rates_agree(tex, seed)
    system, other = field(System(tex)), field(System(tex.replace("=", "=-", 1)))
    assert system != other
