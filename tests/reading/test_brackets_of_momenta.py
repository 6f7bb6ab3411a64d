"""Brackets of the components of a momentum, where an angular velocity moves."""

import pytest

from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import verdicts

BODY = r"""The angular momentum is $\mathbf M=(Ap+a,Bq+b,Cr+c)$, and \[\dot{\mathbf M}=\mathbf M\times\boldsymbol\omega,
\qquad\boldsymbol\omega=(p,q,r).\] Put $H=\frac12(Ap^2+Bq^2+Cr^2)$. """
BRACKET = r"\[\{M_1,M_2\}=-M_3,\quad\{M_2,M_3\}=-M_1,\quad\{M_3,M_1\}=-M_2.\] "


@pytest.mark.parametrize(
    ("claim", "green"),
    [
        (r"\dot M_1=\{M_1,H\}", True),
        (r"\dot M_1=-\{M_1,H\}", False),
        (r"\{p,M_1^2+M_2^2+M_3^2\}=0", True),
        (r"\{p,M_1^2+M_2^2-M_3^2\}=0", False),
        (r"\{p,q\}=-\frac{Cr+c}{AB}", True),
        (r"\{p,q\}=\frac{Cr+c}{AB}", False),
        (r"\{M_1,M_2\}=M_3", False),
    ],
)
def test_they_say_what_the_brackets_of_the_variables_are(claim, green):
    found = verdicts(BODY + "The bracket is " + BRACKET + rf"Then ${claim}$.")
    assert found[claim].green is green


@pytest.mark.parametrize(
    "words",
    [
        "The bracket is not " + BRACKET,
        "If it were true that " + BRACKET,
        "The bracket is " + BRACKET.replace("-M_3", "M_3"),
        "The bracket is " + BRACKET.replace("-M_3", "-M_3+1"),
    ],
)
def test_what_is_denied_or_misprinted_makes_nothing_true(words):
    claim = r"\dot M_1=\{M_1,H\}"
    found = verdicts(BODY + words + rf"Then ${claim}$.")
    assert not found.get(claim, Verdict.UNDECIDED).green


def test_a_momentum_that_is_not_linear_gives_none():
    body = BODY.replace("Ap+a", "Ap^2")
    claim = r"\dot M_1=\{M_1,H\}"
    found = verdicts(body + "The bracket is " + BRACKET + rf"Then ${claim}$.")
    assert not found[claim].green
