"""The independent variable by any letter: what is derived by it alone moves with it."""

import pytest

from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import verdicts

LETTERS = ["x", r"\tau", r"\xi", "s", r"\varphi", "z"]


@pytest.mark.parametrize("by", LETTERS)
@pytest.mark.parametrize(
    ("claim", "verdict"),
    [
        (r"\frac{d^2u}{dX^2}=X-u^2", True),
        (r"\frac{d^2u}{dX^2}=X+u^2", False),
        (r"\frac{d}{dX}(uv)=v^2-u^3+X u", True),
        (r"\frac{d}{dX}(uv)=v^2-u^3", False),
    ],
)
def test_a_law_by_another_letter_is_one(by, claim, verdict):
    law = r"The equations are \[ \frac{du}{dX}=v,\qquad \frac{dv}{dX}=X-u^2 . \] Then \[ %s . \]"
    found = verdicts((law % claim).replace("dX", f"d{by} ").replace("X", f"{by} "))
    assert [one.green for one in found.values()] == [verdict]


@pytest.mark.parametrize(
    "words",
    [
        "A prime is the derivative with respect to $x$.",
        "For a function $u=u(x)$ we have the following.",
        "Put $'=d/dx$.",
        "Let us denote the derivative by $x$ with a prime.",
        "Штрих означает производную по $x$.",
    ],
)
@pytest.mark.parametrize(
    ("value", "green"), [("-2/x^2", True), ("-6/x^2", True), ("-3/x^2", False)]
)
def test_solutions_by_it_are_decided(words, value, green):
    text = rf"{words} The equation is \[ u''''+10uu''+5u'^2+10u^3=0 . \] A solution is $u={value}$."
    assert [one.green for one in verdicts(text).values()] == [green]


@pytest.mark.parametrize(
    "text",
    [
        r"The equation is \[ u''+u=0 . \] With $x=kt$ a solution is $u=\sin t$.",
        r"A prime is the derivative by $x$. \[ u''+u=0 . \] A solution is $u=\sin t$.",
        r"The equation is \[ \frac{d^2u}{dx^2}=-u . \] A solution is $u=\sin t$.",
    ],
)
def test_nothing_is_a_time_beside_t(text):
    assert not any(one.green for one in verdicts(text).values())


@pytest.mark.parametrize(("side", "green"), [("+", True), ("-", False)])
def test_a_constant_alone_on_the_right_is_a_force(side, green):
    law = r"The equation \[ \ddot x+\omega^2x^3=F \] with constant $F$ "
    law += rf"has the integral $E=\frac12\dot x^2{side}\frac14\omega^2x^4-Fx$."
    assert [one.green for one in verdicts(law).values()] == [green]


@pytest.mark.parametrize(("value", "green"), [(r"\frac12", True), (r"-\frac12", False)])
def test_four_derivatives_are_read(value, green):
    law = r"The beam obeys \[ \ddddot y+y=0 . \] "
    law += rf"The quantity \[ I=\dot y\dddot y-\frac12\ddot y^2+{value}y^2 \] is an integral."
    found = [*verdicts(law).values()]
    assert found == [Verdict.PROVED if green else Verdict.REFUTED]
