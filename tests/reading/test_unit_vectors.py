"""That a vector is a unit vector is printed once, and holds wherever it stands."""

import pytest

from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import verdicts

BODY = r"""The equations of a body are \[ \dot{\mathbf M}=\mathbf M\times\boldsymbol\omega,\qquad
\dot{\boldsymbol\nu}=\boldsymbol\nu\times\boldsymbol\omega,\qquad \mathbf M=I\boldsymbol\omega . \] """
UNIT = r"The integrals are $(\boldsymbol\nu,\boldsymbol\nu)=1$ and $(\mathbf M,\boldsymbol\nu)=g$. "
PART = r"""Put $\mathbf v=\boldsymbol\nu\times(\boldsymbol\omega\times\boldsymbol\nu)$. Then
\[ \mathbf v^2=\boldsymbol\omega^2{}(\boldsymbol\omega,\boldsymbol\nu)^2 . \]"""
POINT = r"The equations are \[ \dot x_1=x_2z,\quad \dot x_2=-x_1z,\quad \dot x_3=0,\quad \dot z=x_1 . \] "


def last(text):
    return [*verdicts(text).values()][-1]


@pytest.mark.parametrize(("sign", "true"), [("-", True), ("+", False)])
def test_a_claim_of_unit_vectors_says_so(sign, true):
    assert last(BODY + UNIT + PART.replace("{}", sign)).green is true


@pytest.mark.parametrize(
    "said",
    ["", r"If $(\boldsymbol\nu,\boldsymbol\nu)=1$, this is clear. ",
     r"The integrals are $(\boldsymbol\nu,\boldsymbol\nu)=2$ and $(\mathbf M,\boldsymbol\nu)=g$. ",
     r"The integrals are $(\mathbf M,\mathbf M)=1$ and $(\mathbf M,\boldsymbol\nu)=g$. "],
)  # fmt: skip
def test_without_that_it_is_not_granted(said):
    assert last(BODY + said + PART.replace("{}", "-")) is Verdict.UNDECIDED


@pytest.mark.parametrize(
    ("said", "claim", "true"),
    [
        ("x_1^2+x_2^2+x_3^2=1", "f=1-x_3^2", True),
        ("x_1^2+x_2^2+x_3^2=1", "f=1+x_3^2", False),
        # a set, and not the length of what moves
        ("x_1^2+x_2^2=1", "f+x_1^2=1+x_1^2", False),
    ],
)
def test_components_that_are_printed_one_by_one(said, claim, true):
    text = rf"{POINT} Here ${said}$. Put $f=x_1^2+x_2^2$. Then \[ {claim} . \]"
    assert last(text).green is true


FIELD = r"""A point has the Hamiltonian \[ H=\tfrac12(p_x^2+p_y^2+p_z^2)+\tfrac k2(x^2+y^2+z^2)-Fz . \] Let
\[ \mathbf L=\mathbf r\times\mathbf p . \] """


@pytest.mark.parametrize(
    ("words", "rate", "true"),
    [
        (r"Let $\mathbf e$ be the unit vector of the axis of $z$.", r"F\mathbf r\times\mathbf e", True),
        (r"Let $\mathbf e$ be the unit vector of the axis of $z$.", r"F\mathbf e\times\mathbf r", False),
        (r"Let $\mathbf e$ be a unit vector along the $z$-axis.", r"F\mathbf r\times\mathbf e", True),
        (r"Let $\mathbf e$ be the unit vector of the axis of $x$.", r"F\mathbf r\times\mathbf e", False),
        (r"Let $\mathbf e$ be a unit vector near the axis of $z$.", r"F\mathbf r\times\mathbf e", False),
    ],
)  # fmt: skip
def test_a_unit_vector_of_an_axis_in_words(words, rate, true):
    assert last(rf"{FIELD} {words} Then $\dot{{\mathbf L}}={rate}$.").green is true
