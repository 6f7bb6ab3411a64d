"""Equations in one list are one system, coupled or not; a rate of what is defined beside it is none."""

import pytest

from kowalevski_cas.audit.reading import uncovered
from kowalevski_cas.reading import CLAIM, DEFINITION, LAW
from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import reading, roles, verdicts

THREE = r"Let $\dot x=y$, $\dot y=-x$, $\dot z=-z$. "
DAMPED = r"Consider $\dot x=y$, $\dot y=-x-ky$. "


@pytest.mark.parametrize(
    ("text", "formula", "green"),
    [
        (THREE + r"The points with $x=y=0$ are equilibria.", "x=y=0", False),
        (THREE + r"The points with $x=y=z=0$ are equilibria.", "x=y=z=0", True),
        (r"Let $\dot x=-x$ and $\dot y=1$. The point $x=0$ is an equilibrium.", "x=0", False),
        (
            r"Let $\dot x=-x$, $\dot y=-2y$. The characteristic equation is $§$.",
            r"\lambda+2=0",
            False,
        ),
        (
            r"Let $\dot x=-x$, $\dot y=-2y$. The characteristic equation is $§$.",
            r"(\lambda+1)(\lambda+2)=0",
            True,
        ),
        (r"Let $\dot x=-x$, $\dot y=-2y$. The divergence is $§$.", "-3", True),
        (r"Let $\dot x=-x$, $\dot y=-2y$. The divergence is $§$.", "-1", False),
    ],
)
def test_what_is_said_of_the_system_is_said_of_all_of_it(text, formula, green):
    found = verdicts(text.replace("§", formula))[formula]
    assert found.green == green


@pytest.mark.parametrize(
    ("words", "told"),
    [(r"Its eigenvalues are $\pm i$.", 1), (r"Its eigenvalues are $\pm i$, $-1$.", 0)],
)
def test_of_all_eigenvalues_none_is_left_out(words, told):
    assert len(uncovered(reading(THREE + words))) == told


@pytest.mark.parametrize(
    "words",
    [
        r"We have $\dot E=§$ for $E=x^2+y^2$.",
        r"The equation $\dot E=§$ holds for $E=x^2+y^2$.",
        r"Hence \[ \dot E=§,\qquad E=x^2+y^2. \]",
        r"Hence \[ \dot E=§, \] where $E=x^2+y^2$.",
        r"Since $\dot E=§$ with $E=x^2+y^2$, the motion ends.",
    ],
)
def test_a_rate_of_what_is_given_right_behind_is_claimed(words):
    for rate, verdict in (("-2ky^2", Verdict.PROVED), ("-ky^2", Verdict.REFUTED)):
        text = DAMPED + words.replace("§", rate)
        assert verdicts(text)[rf"\dot E={rate}"] is verdict
        assert roles(text)["E=x^2+y^2"] == DEFINITION


def test_what_follows_from_a_false_rate_is_not_green():
    text = DAMPED + r"The equation $\dot E=-kE$ holds for $E=x^2+y^2$. So $Ee^{kt}$ is an integral."
    assert not verdicts(text)["Ee^{kt}"].green


def test_a_constraint_explains_no_rate():
    text = r"A bead moves by \[ m\ddot x=\lambda x,\qquad m\ddot y=-mg+\lambda y,\qquad y=x^2. \]"
    found = roles(text)
    assert found[r"m\ddot y=-mg+\lambda y"] == LAW and found["y=x^2"] not in (DEFINITION, CLAIM)


APART = r"""The motion is \[ \dot x=y,\qquad\dot y=x-x^3. \] It is bounded.
The second oscillator moves by \[ \dot u=v,\qquad\dot v=2u+u^3. \] """


@pytest.mark.parametrize(
    ("words", "formula", "green"),
    [
        ("The point $(1,0)$ is an equilibrium.", "(1,0)", False),
        ("The point $(0,0)$ is an equilibrium.", "(0,0)", True),
        ("The point $u=v=0$ is an equilibrium.", "u=v=0", True),
        ("The only equilibrium is $u=v=0$.", "u=v=0", True),
        (r"The eigenvalues at the origin are $\pm\sqrt2$.", r"\pm\sqrt2", True),
        (r"The eigenvalues at the origin are $\pm1$.", r"\pm1", False),
        ("The set $x=y=0$ is at rest.", "x=y=0", False),
        ("Of the first system $(1,0)$ is an equilibrium.", "(1,0)", False),
    ],
)
def test_a_system_apart_is_the_one_that_is_spoken_of_behind_it(words, formula, green):
    found = verdicts(APART + words).get(formula)
    assert (found is not None and found.green) == green


@pytest.mark.parametrize(("sign", "green"), [("-", True), ("+", False)])
def test_what_is_of_both_is_claimed_of_both(sign, green):
    function = rf"v^2-2u^2-\frac12u^4+y^2{sign}x^2+\frac12x^4"
    assert verdicts(APART + f"The function ${function}$ is constant.")[function].green == green
