"""When words say that something happens, nothing is supposed; what always holds is claimed."""

import pytest

from kowalevski_cas.reading.known import ASSUMPTION, CLAIM, OTHER
from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import roles, verdicts

PLANE = r"Let \[ \dot x=y,\qquad\dot y=-kx. \] "


@pytest.mark.parametrize(
    ("words", "equation"),
    [
        ("A resonance occurs if $k=4$.", "k=4"),
        ("The resonance $k=4$ takes place.", "k=4"),
        ("A bifurcation takes place only for $k=0$.", "k=0"),
        ("Резонанс имеет место при $k=4$.", "k=4"),
    ],
)
def test_on_what_something_happens_is_not_supposed(words, equation):
    text = PLANE + words + " Then $y^2+4x^2$ is an integral."
    assert roles(text)[equation] == OTHER
    assert not verdicts(text)["y^2+4x^2"].green


def test_what_is_supposed_is():
    text = PLANE + "Let $k=4$. Then $y^2+4x^2$ is an integral."
    assert roles(text)["k=4"] == ASSUMPTION
    assert verdicts(text)["y^2+4x^2"].green


@pytest.mark.parametrize(
    ("words", "verdict"),
    [
        ("Put $a=k+1$, $b=k$. Always $a>b$.", Verdict.PROVED),
        ("Put $a=k+1$, $b=2k$. Clearly $a>b$.", Verdict.UNDECIDED),
        ("Положим $a=k+1$, $b=k$. Очевидно, $a>b$.", Verdict.PROVED),
    ],
)
def test_what_always_holds_of_what_is_given_is_claimed(words, verdict):
    assert roles(PLANE + words)["a>b"] == CLAIM
    assert verdicts(PLANE + words)["a>b"] is verdict


@pytest.mark.parametrize(("ratio", "green"), [("1+k", True), ("1-k", False)])
def test_an_equation_between_constants_of_its_sentence_is_of_no_system(ratio, green):
    text = PLANE + rf"The frequencies of the damped motion are $u=2+2k$, $v=2$, and $u/v={ratio}$."
    assert verdicts(text)[f"u/v={ratio}"].green == green
