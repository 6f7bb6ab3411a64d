"""Vector fields as operators: what they give is a derivative along the motion, and no product."""

import pytest

from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import verdicts

FLOW = r"""\newcommand{\X}{\mathcal X}The equations of motion are
\[ \dot x=x(1-x-ay-bz),\quad \dot y=y(1-bx-y-az),\quad \dot z=z(1-ax-by-z) . \] """
SAID = [
    (r"We denote by $\X$ the vector field of this system. Let $s=x+y+z$. ", r"\X"),
    (r"Let $V$ be the vector field of this system, and let $s=x+y+z$. ", "V"),
    (r"The corresponding vector field $W$ acts on functions. Put $s=x+y+z$. ", "W"),
    (r"Пусть $V$ — векторное поле системы и $s=x+y+z$. ", "V"),
]
TRUE = [r"F(xyz)=xyz(3-(1+a+b)s)", r"F s=s-(x^2+y^2+z^2)-(a+b)(xy+yz+zx)", r"F\left(xy\right)=xy(2-(1+b)x-(1+a)y-(a+b)z)"]  # fmt: skip
FALSE = [
    r"F(xyz)=xyz(2-(1+a+b)s)", r"F s=s(1-s)", r"F s=s-(x^2+y^2+z^2)-(a-b)(xy+yz+zx)",
    r"F\left(xy\right)=xy(2-(1+a)x-(1+a)y-(a+b)z)",
]  # fmt: skip


@pytest.mark.parametrize(("words", "letter"), SAID)
def test_what_a_field_gives_is_decided(words, letter):
    for claim in TRUE:
        found = verdicts(FLOW + words + rf"Then \[ {claim.replace('F', letter)} . \]")
        assert [*found.values()][-1] is Verdict.PROVED
    for claim in FALSE:
        found = verdicts(FLOW + words + rf"Then \[ {claim.replace('F', letter)} . \]")
        assert not any(one.green for one in found.values())


def test_one_value_of_it_does_not_define_the_field():
    words = SAID[0][0] + r"Suppose that $a+b=2$. Then \[ \X s=s(2-s) . \] Hence \[ \X s=2s-s^2 . \]"
    assert not any(one.green for one in verdicts(FLOW + words).values())


@pytest.mark.parametrize(
    "words", [r"Put $X=x+y$ and $s=xyz$.", r"The norm $X$ of the field is $X=x+y$. Put $s=xyz$."]
)
def test_other_letters_are_factors(words):
    assert [*verdicts(FLOW + words + r" Then \[ Xs=xyz(x+y) . \]").values()] == [Verdict.PROVED]


@pytest.mark.parametrize(
    "words",
    [
        r"Let $V$ be the vector field of the adjoint system. Then \[ V x=-x(1-x-ay-bz) . \]",
        r"We denote by $V$ the vector field $x\partial_y$. Then \[ V y=y(1-bx-y-az) . \]",
        r"The vector field $V$ of the linear system is simpler. Then \[ V x=x(1-x-ay-bz) . \]",
        r"The vector field $V$ is $V=x\partial_x$. Then \[ V x=x(1-x-ay-bz) . \]",
        r"Let $V$ be the vector field of the system of the next section. Then \[ V x=x . \]",
    ],
)
def test_of_other_fields_nothing_is_judged(words):
    assert not verdicts(FLOW + words)


def test_the_derivative_of_constants_is_not_judged():
    assert not verdicts(FLOW + r"We find that \[ \frac{d}{dt}(l^2)=0,\quad\frac d{dt}(l+m)=0 . \]")
