r"""A letter that is a matrix by words, or by :math:`A^T=-A`, is no number: nothing is judged by it."""

import pytest

from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import verdicts
from tests.sample import sampled

LAW = r"Let $\dot{\mathbf x}=A\mathbf x$ "
SAID = [
    rf"{LAW}with $A^T=-A$.",
    rf"{LAW}with $A^\top=-A$.",
    rf"{LAW}with $A^{{\mathrm T}}=-A$.",
    rf"{LAW}with a skew-symmetric matrix $A$.",
    r"Let $\dot{\mathbf x}=AB\mathbf x$ with matrices $A$ and $B$.",
]


@pytest.mark.parametrize("text", sampled(SAID, 2))
@pytest.mark.parametrize("claim", [r"$\mathbf x^2$", r"$|\mathbf x|$"])
def test_nothing_is_said_of_what_a_matrix_without_elements_moves(text, claim):
    assert not verdicts(f"{text} Then {claim} is constant.")


def test_a_letter_that_is_a_period_is_an_exponent():
    text = r"Let $\ddot x=-\omega^2x$, and let $T=2\pi/\omega$ be the period, $N=C^T$. Then "
    found = verdicts(text + r"$\dot x^2+\omega^2x^2$ is an integral.")
    assert [*found.values()] == [Verdict.PROVED]


def test_a_matrix_beside_a_law_leaves_it_as_it_is():
    text = r"The matrix $J$ of $\dot x=y$, $\dot y=-x$ is skew. The function "
    assert [one.green for one in verdicts(rf"{text}$x^2+y^2$ is an integral.").values()] == [True]
    assert [one.green for one in verdicts(rf"{text}$x^2-y^2$ is an integral.").values()] == [False]
