"""Rates that are given by names, and derivatives of what is given by its name alone."""

import pytest

from kowalevski_cas.reading.known import LAW, LEVEL
from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import roles, verdicts


@pytest.mark.parametrize(
    "text",
    [
        r"Let \[ \dot x=f(x,y),\qquad\dot y=g(x,y), \] where $f(x,y)=y$, $g(x,y)=-x$. ",
        r"Let \[ \dot x=f,\qquad\dot y=g \] with $f=y$ and $g=-x$. ",
        r"Let $f=y$, $g=-x$ and \[ \dot x=f,\qquad\dot y=g. \] ",
    ],
)
def test_a_rate_by_a_name_is_a_row_where_the_name_is_given_by_what_moves(text):
    assert verdicts(text + "Then $x^2+y^2$ is an integral.")["x^2+y^2"] is Verdict.PROVED
    assert verdicts(text + "Then $x^2-y^2$ is an integral.")["x^2-y^2"] is Verdict.REFUTED


@pytest.mark.parametrize("words", ["Then $w=-gt$.", "On the orbit $v=w$.", ""])
def test_a_rate_that_is_a_new_name_is_called_so(words):
    found = roles(r"A body falls: \[ \ddot y=-g. \] Let $\dot y=w$. " + words)
    assert found[r"\dot y=w"] == LEVEL != LAW


POTENTIAL = r"The motion is \[ \ddot\theta=a\sin\theta\cos\theta-k\sin\theta. \] With \[ U=-\frac12a\sin^2\theta-k\cos\theta \] "


@pytest.mark.parametrize(
    ("formula", "green"),
    [
        (r"\ddot\theta=-U'(\theta)", True),
        (r"\ddot\theta=U'(\theta)", False),
        (r"U''(\theta)=k\cos\theta-a\cos2\theta", True),
        (r"U''(\theta)=k\cos\theta-a\cos\theta", False),
        (r"U''(0)=k-a", True),
        (r"U''(0)=k+a", False),
    ],
)
def test_what_is_given_by_its_name_is_a_function_where_its_derivative_has_an_argument(
    formula, green
):
    text = POTENTIAL + rf"we have $U'(\theta)=\frac{{dU}}{{d\theta}}$ and ${formula}$."
    [*_, verdict] = verdicts(text).values()
    assert verdict.green == green


def test_a_law_may_have_such_a_derivative():
    text = r"Let \[ V=\frac12x^2+x^4. \] The motion is \[ \ddot x=-V'(x). \] "
    assert verdicts(text + r"So $\frac12\dot x^2+V$ is an integral.")[r"\frac12\dot x^2+V"].green
    assert not verdicts(text + r"So $\frac12\dot x^2-V$ is an integral.")[
        r"\frac12\dot x^2-V"
    ].green
