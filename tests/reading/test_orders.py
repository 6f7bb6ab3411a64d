"""Approximations hold to the order that is printed, or that words name."""

import random

import pytest

from kowalevski_cas.reading.orders import _NUMBERS, _ORDER
from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import verdicts

PENDULUM = (
    r"The motion is \[ \ddot\theta=-\sin\theta. \] Let $E=\tfrac12\dot\theta^2+1-\cos\theta$. "
)
CUBIC = r"The motion is \[ \ddot x=-x-x^2. \] "


@pytest.mark.parametrize(
    ("words", "true"),
    [
        (r"For small $\theta$ we have $\ddot\theta=-\theta$.", True),
        (r"For small $\theta$ we have $\ddot\theta=-\theta$ up to terms of the third order.", True),
        (r"For small $\theta$ we have $\ddot\theta=-\theta$ up to terms of the fifth order.", False),
        (r"For small $\theta$, $\ddot\theta=-\theta+\frac16\theta^3$.", True),
        (r"For small $\theta$, $\ddot\theta=-\theta+\frac13\theta^3$.", False),
        (r"For small $\theta$, $\ddot\theta=-\theta+\frac16\theta^2$.", False),
        (r"For small $\theta$, keeping terms of the third order, $\ddot\theta=-\theta$.", False),
        (r"Для малых колебаний $\ddot\theta=-\theta$ с точностью до членов третьего порядка.", True),
        (r"Для малых колебаний $\ddot\theta=-\theta$ с точностью до членов пятого порядка.", False),
        (r"For small oscillations $E=\tfrac12\dot\theta^2+\tfrac12\theta^2$.", True),
        (r"For small oscillations $E=\tfrac12\dot\theta^2+\theta^2$.", False),
        (r"For small $\theta$ we have $E=\tfrac12\dot\theta^2+\tfrac12\theta^2-\theta^4$.", False),
    ],
)  # fmt: skip
def test_an_approximation_is_right_to_its_order(words, true):
    *_, last = verdicts(PENDULUM + words).values()
    assert last.green == true


@pytest.mark.parametrize(
    ("words", "true"),
    [
        ("Neglecting terms of the second order, for small $x$ we have", True),
        ("Retaining only the linear terms, for small $x$ we have", True),
        ("For small $x$ we have to the second order", False),
    ],
)
def test_what_is_left_out_may_be_wrong(words, true):
    found = verdicts(CUBIC + words + r" $\ddot x=-x$.").get(r"\ddot x=-x")
    assert (found is not None and found.green) == true


@pytest.mark.parametrize("spelled", ["четвертого", "четвёртого"])
def test_an_order_is_read_in_either_spelling(spelled):
    words = rf"Для малых колебаний $\ddot\theta=-\theta$ с точностью до членов {spelled} порядка."
    found = verdicts(PENDULUM + words).get(r"\ddot\theta=-\theta")
    assert found is None or not found.green


def test_every_word_for_an_order_is_known_as_it_is_found():
    for word in _NUMBERS:
        found = _ORDER.search(f"up to terms of the {word} order")
        assert found is not None and found["order"].lower() in _NUMBERS


def polynomial(coefficients):
    return "".join(f"{c:+d}x^{k}" for k, c in coefficients.items() if c) or "0"


@pytest.mark.parametrize("seed", range(8))
def test_a_cut_series_is_green_only_if_all_of_its_orders_are_right(seed):
    draw = random.Random(seed)
    law = {1: -1} | {k: draw.choice([-2, -1, 1, 2]) for k in (2, 3, 4)}
    kept = draw.choice([1, 2, 3])
    claim = {k: law[k] for k in range(1, kept + 1)}
    if seed % 2:
        claim[draw.randint(1, kept)] += draw.choice([1, 3])
    left_out = draw.choice(["second", "third", "fourth"])
    highest = max(["second", "third", "fourth"].index(left_out) + 1, kept)
    right = all(claim.get(k, 0) == law[k] for k in range(1, highest + 1))
    rate = rf"\ddot x={polynomial(claim)}"
    text = rf"The motion is \[ \ddot x={polynomial(law)}. \] For small $x$ we have"
    found = verdicts(rf"{text} ${rate}$ up to terms of the {left_out} order.").get(rate)
    assert right or found is None or not found.green
    assert not right or found is not Verdict.REFUTED


def test_the_value_of_a_variable_at_a_place_is_constant_there():
    text = r"""A body moves by \[ A\dot p=(B-C)qr,\qquad B\dot q=(C-A)rp,\qquad C\dot r=(A-B)pq. \]
    The rotation is $q=r=0$, $p=p_0$. For a motion near to this one we keep only terms of the first
    order: \[ \ddot q=-\frac{(A-B)(A-C)}{BC}p_0^2q. \] About the middle axis, $p=r=0$, $q=q_0$, the
    same reasoning leads to \[ \ddot p=§\frac{(A-B)(B-C)}{AC}q_0^2p. \]"""
    for sign in ("", "-"):
        [*_, verdict] = verdicts(text.replace("§", sign)).values()
        assert verdict.green == (not sign)
