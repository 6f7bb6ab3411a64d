r"""Brackets of the elements of a matrix by Kronecker's deltas: :math:`\{M_{ij},M_{kl}\}=\ldots`."""

from itertools import permutations

import pytest

from kowalevski_cas.reading.brackets_of_elements import brackets_of_elements
from tests.reading.test_reading import verdicts
from tests.sample import sampled

SKEW = r"\{S_{ij},S_{kl}\}=\delta_{ik}S_{jl}+\delta_{jl}S_{ik}-\delta_{jk}S_{il}-\delta_{il}S_{jk}"
FULL = r"\{S_{ij},S_{kl}\}=\delta_{jk}S_{il}-\delta_{il}S_{kj}"

BODY = rf"""Let $S=(S_{{ij}})$ be a skew-symmetric $4\times4$ matrix. The equations of motion are
\[ \dot S=[S,W],\qquad W_{{ij}}=g_{{ij}}S_{{ij}},\qquad g_{{ij}}=\frac{{b_i-b_j}}{{a_i-a_j}} .\]
The bracket is \begin{{equation}} {SKEW}. \label{{pb}}\end{{equation}}
Put $H=\frac12\sum_{{i<j}}g_{{ij}}S_{{ij}}^2$, $C=S_{{12}}S_{{34}}-S_{{13}}S_{{24}}+S_{{14}}S_{{23}}$,
$F=S_{{12}}^2+S_{{13}}^2+S_{{23}}^2$. """

TRUE = [
    r"Then \[ \dot S_{ij}=\{S_{ij},H\} .\]",
    r"Then \[ \{C,H\}=0 .\]",
    r"Then \[ \{S_{12},F\}=0 .\]",
    r"Then \[ \frac{dS_{13}}{dt}=\{S_{13},H\} .\]",
]
FALSE = [
    r"Then \[ \dot S_{ij}=\{H,S_{ij}\} .\]",
    r"Then \[ \dot S_{ij}=\{S_{ij},F\} .\]",
    r"Then \[ \{F,H\}=0 .\]",
    r"Then \[ \{S_{14},F\}=0 .\]",
    r"Then \[ \{S_{12},S_{24}\}=S_{14} .\]",
    r"Then \[ \{S_{12},S_{34}\}=S_{14} .\]",
    r"Then \[ \frac{dS_{13}}{dt}=2\{S_{13},H\} .\]",
    r"Then \[ \{C,S_{12}\}=S_{34} .\]",
]


@pytest.mark.parametrize("claim", sampled(TRUE, 2))
def test_what_follows_from_the_brackets_is_proved(claim):
    found = [*verdicts(BODY + claim).values()]
    assert found
    assert all(one.green for one in found)


@pytest.mark.parametrize("claim", sampled(FALSE, 3))
def test_what_does_not_follow_is_not_green(claim):
    found = [*verdicts(BODY + claim).values()]
    assert found
    assert not any(one.green for one in found)


def instances(tex, is_skew=True, order=4):
    return brackets_of_elements(tex, "S", order, is_skew)


def test_each_bracket_is_said_once():
    assert instances(SKEW).count("=") == 15
    assert instances(SKEW).count("=0") == 3
    assert instances(FULL, is_skew=False, order=2).count("=") == 6


@pytest.mark.parametrize("place", range(4))
def test_a_bracket_with_one_wrong_sign_is_no_bracket(place):
    head, _, right = SKEW.partition("=")
    terms = right.replace("-", "+-").split("+")
    terms[place] = terms[place].removeprefix("-") if "-" in terms[place] else f"-{terms[place]}"
    assert not instances(f"{head}={'+'.join(terms).replace('+-', '-')}")


@pytest.mark.parametrize("indices", [one for one in permutations("ijkl") if one != (*"ijkl",)])
def test_letters_in_another_order_say_the_same_or_nothing(indices):
    """Of a skew matrix the order of the letters matters as the left side's does."""
    head, _, right = SKEW.partition("=")
    renamed = right.translate(str.maketrans("ijkl", "".join(indices)))
    assert instances(f"{head}={renamed}") in ("", instances(SKEW), _opposite(instances(SKEW)))


def _opposite(tex):
    """The brackets with the other signs."""
    pairs = [one.split("=") for one in tex.split(r",\quad ")]
    return r",\quad ".join(
        f"{left}={right if right == '0' else right[1:] if right[0] == '-' else f'-{right}'}"
        for left, right in pairs
    )


@pytest.mark.parametrize(
    "tex",
    [
        r"\{S_{ij},S_{kl}\}=\delta_{ik}S_{jl}",
        r"\{S_{ij},S_{ij}\}=\delta_{ij}S_{ij}",
        r"\{S_{ij},S_{kl}\}=\delta_{ik}T_{jl}-\delta_{jl}T_{ik}",
        r"\{S_{ij},S_{kl}\}=0",
        r"\{T_{ij},T_{kl}\}=\delta_{ik}T_{jl}+\delta_{jl}T_{ik}-\delta_{jk}T_{il}-\delta_{il}T_{jk}",
        SKEW.replace(r"+\delta_{jl}S_{ik}", r"+\delta_{jl}S_{ik}^2"),
        SKEW.replace(r"+\delta_{jl}S_{ik}", r"+2\delta_{jl}S_{ik}"),
        SKEW.replace(r"\delta_{ik}S_{jl}+", ""),
    ],
)
def test_what_is_anything_else_gives_no_bracket(tex):
    assert instances(tex) == ""
