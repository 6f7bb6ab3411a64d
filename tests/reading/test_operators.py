"""The letter of an operator that derives: what it gives is a rate, and no product."""

import pytest

from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import roles, verdicts

SAID = [
    (r"Write $\mathrm D=\mathrm d/\mathrm dt$. ", r"\mathrm D"),
    (r"\newcommand{\D}{\mathcal{D}}Let $\D\equiv\frac{d}{dt}$. ", r"\D"),
    (r"Here $D$ denotes the derivative with respect to time. ", "D"),
    (r"We write $D$ for $d/dt$. ", "D"),
    (r"Let $D_t$ be the differentiation with respect to $t$. ", "D_t"),
    (r"Пусть $D$ — оператор дифференцирования по времени. ", "D"),
    ("", r"\partial_t"),
    ("", "d_t"),
]
LAW = r"The equations of motion are \[ D q=p,\qquad D p=-q^3 . \] "
TRUE = ["D^2q=-q^3", r"\frac12D(q^2)=qp", "D^3q=-3q^2p", r"D\left(p^2+\frac12q^4\right)=0", "Dq\\,Dp=-pq^3"]  # fmt: skip
FALSE = ["D^2q=q^3", r"\frac12D(q^2)=qp^2", "D^3q=-3q^2", r"D\left(p^2+q^4\right)=0", "Dq\\,Dp=pq^3"]  # fmt: skip


def _with(tex, letter):
    return tex.replace("D", f"{letter} ")


@pytest.mark.parametrize(("words", "letter"), SAID)
def test_what_an_operator_gives_is_decided(words, letter):
    claims = " ".join(rf"Then \[ {_with(claim, letter)} . \]" for claim in TRUE)
    assert [*verdicts(words + _with(LAW, letter) + claims).values()] == [Verdict.PROVED] * len(TRUE)


@pytest.mark.parametrize("claim", FALSE)
def test_what_it_does_not_give_is_not_proved(claim):
    words, letter = SAID[0]
    found = verdicts(rf"{words}{_with(LAW, letter)} Then \[ {_with(claim, letter)} . \]")
    assert [one.green for one in found.values()] == [False]


@pytest.mark.parametrize("claim", ["Dq^2=2qp", "Dqp=p^2-q^4"])
def test_how_far_it_reaches_is_not_guessed(claim):
    assert not verdicts(rf"{SAID[0][0]}{_with(LAW, SAID[0][1])} Then ${_with(claim, SAID[0][1])}$.")


def test_a_letter_that_is_given_otherwise_is_none():
    law = r"The equations are \[ \dot q=p,\quad\dot p=-q . \] Let $D$ be the derivative by time. "
    assert [*verdicts(law + r"Put $D=q^2$. Then $Dp=q^2p$.").values()] == [Verdict.PROVED]
    law = r"The equations are \[ \dot q=p,\quad\dot p=-q . \] Put $D=q^2$. "
    assert [*verdicts(law + r"Then $Dp=q^2p$.").values()] == [Verdict.PROVED]


@pytest.mark.parametrize(("rate", "verdict"), [("sw", True), ("-sw", False), ("w", False)])
def test_the_law_may_be_by_the_other_time(rate, verdict):
    law = r"""The equations of motion are
\[ \frac{dq}{d\tau}=\frac{\pi}{s^2},\quad \frac{d\pi}{d\tau}=-q,\quad \frac{ds}{d\tau}=w,\quad
\frac{dw}{d\tau}=\frac{\pi^2}{s^3}-\frac Ts . \] Let $d\tau=s\,dt$. """
    found = [*verdicts(law + rf"Then $\frac{{ds}}{{dt}}={rate}$.").values()]
    assert [one.green for one in found] == [verdict]
    found = [*verdicts(law + rf"Then $\dot s={rate}$, and $\frac{{d\pi}}{{d\tau}}=-q$.").values()]
    assert [one.green for one in found] == [verdict, True]
    assert "law" in {*roles(law).values()}


@pytest.mark.parametrize(
    "words",
    [
        "Here $p$ is the time derivative of $q$.",
        "Here $p$ denotes the derivative with respect to time of the coordinate.",
        "Let $p$ be the derivative with respect to $t$ of $q$.",
    ],
)
def test_the_derivative_of_something_is_no_operator(words):
    law = r"The equations are \[ \dot q=p,\quad\dot p=-q . \] " + words
    assert [*verdicts(law + r" Put $w=pq$. Then $pq^2=wq$.").values()] == [Verdict.PROVED]
