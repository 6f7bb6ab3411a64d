"""What a family says of some values of its indices only: nothing, or nothing new."""

import pytest

from kowalevski_cas.reading.known import ASSUMPTION, CLAIM, DEFINITION, OTHER
from tests.audit.test_doubted import audited
from tests.reading.test_reading import reading

PLANE = r"The motion is \[\ddot x_i=-x_i,\qquad i=1,2.\] "
SPECIES = r"The species obey \[\dot x_i=x_i\Bigl(r_i+\sum_{j=1}^2a_{ij}x_j\Bigr),\qquad i=1,2.\] "


def decided(text):
    return [f.verdict in ("proved", "conditional") for f in audited(text).formulas if f.claims]


@pytest.mark.parametrize(
    ("words", "role"),
    [
        (r"The functions $L_{ij}=x_i\dot x_j-x_j\dot x_i$ are integrals.", DEFINITION),
        (r"The functions $x_i\dot x_j-x_j\dot x_i$ are integrals.", OTHER),
    ],
)
def test_of_a_product_that_is_skew_the_diagonal_is_zero_and_claims_nothing(words, role):
    found = [f.role.name for f in reading(PLANE + words).formulas[2:]]
    assert found.count(role) == 2 and found.count(CLAIM) == 2
    assert decided(PLANE + words) == [True] * 2
    assert True not in decided(PLANE + words.replace("-x_j", "-2x_j"))


def test_what_is_zero_for_all_indices_is_claimed():
    found = reading(PLANE + r"The functions $L_{ij}=x_ix_j-x_jx_i$ are integrals.")
    assert [f.role.name for f in found.formulas[2:]] == [CLAIM] * 4


@pytest.mark.parametrize("sign", ["-", ""])
def test_of_coefficients_that_are_exchanged_one_half_gives_the_other(sign):
    words = f"Let $a_{{ij}}={sign}a_{{ji}}$ and $r_i=0$. Then $x_1+x_2$ is constant."
    found = reading(SPECIES + words)
    same = [f for f in found.formulas if f.item.typed.tex.startswith("a_") and f.role.name == OTHER]
    assert len(same) == 1
    assert decided(SPECIES + words) == [bool(sign)]


def test_what_is_its_own_opposite_is_supposed_to_be_zero():
    words = "If $a_{ij}=-a_{ji}$ and $r_i=0$, then $x_1+x_2$ is constant."
    assert decided(SPECIES + words) == [True]
    supposed = [f for f in reading(SPECIES + words).formulas if f.role.name == ASSUMPTION]
    assert len(supposed) == 5
    assert decided(SPECIES + words.replace("-a_{ji}", "a_{ji}")) == [False]


def test_of_integrals_that_are_constant_for_some_indices_only_none_is_refuted():
    text = r"""The quantities $I_k=\operatorname{tr}L^k$, $k=1,2$, are integrals of
    \[\dot a=ab,\quad \dot b=-a^2.\] Here \[L=\begin{pmatrix}b&a\\a&-b\end{pmatrix}.\]"""
    verdicts = [f.verdict for f in audited(text).formulas if f.claims]
    assert verdicts == ["undecided", "proved"]
    alone = text.replace(
        r"quantities $I_k=\operatorname{tr}L^k$, $k=1,2$, are integrals",
        r"quantity $I=\operatorname{tr}L$ is an integral",
    )
    assert [f.verdict for f in audited(alone).formulas if f.claims] == ["refuted"]


CHAINS = [
    r"The system $\dot x_k=x_k(x_{k+1}-x_{k-1})$, $k=1,\dots,n$, with $x_{k+n}=x_k$, has the integral ",
    r"The chain $\dot x_k=x_{k+1}-x_{k-1}$ with the condition $x_{k+n}=x_k$ has the integral ",
]


@pytest.mark.parametrize("chain", CHAINS)
@pytest.mark.parametrize(("integral", "true"), [("x_k", True), ("x_k^3", False)])
def test_how_the_indices_of_a_chain_go_on_is_no_integral(chain, integral, true):
    assert decided(rf"{chain}$\sum_k{integral}$.") == [true]


def test_of_a_map_the_period_is_claimed():
    assert decided("The map $x_{n+1}=-x_n$ has $x_{n+2}=x_n$.") == [True]
    assert decided("The map $x_{n+1}=-x_n$ has $x_{n+3}=x_n$.") == [False]
