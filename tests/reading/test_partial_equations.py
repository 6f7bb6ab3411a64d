"""Partial differential equations are printed before a reduction, and are not judged."""

import pytest

from kowalevski_cas.reading.known import OTHER
from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_dimensions import found
from tests.reading.test_reading import reading, verdicts

EQUATIONS = [
    "$v_t+vv_x+v_{xxx}=0$",
    r"\[ v_t=kv_{xx}. \]",
    r"$v_{tt}-v_{xx}+\sin v=0$",
    r"\[ i\partial_tv+\partial_x^2v+2v^3=0. \]",
    r"\[ \frac{\partial^2v}{\partial t^2}=c^2\frac{\partial^2v}{\partial x^2}-v^3. \]",
]


@pytest.mark.parametrize("equation", EQUATIONS)
def test_a_partial_differential_equation_is_neither_claimed_nor_a_law(equation):
    text = rf"The equation {equation} has waves $v=g(\zeta)$. They satisfy \[ g''=bg-g^3. \] "
    text += r"An integral is $E=\frac12g'^2-\frac12bg^2+\frac14g^4$. An integral is $F=g'^2-bg^2$."
    (role,) = (one.role for one in reading(text).formulas if "partial diff" in one.role.reason)
    assert role.name == OTHER
    shown = {tex[:1]: one for tex, one in verdicts(text).items()}
    assert shown == {"E": Verdict.PROVED, "F": Verdict.REFUTED}


@pytest.mark.parametrize(
    "equation",
    [
        r"$a_t$ and $a_x$ satisfy $a_t=2a_x$",
        r"$\frac{\partial E}{\partial t}=0$ holds for $E=x^2+y^2$",
        "with $a_x=y$, $a_t=2y$ we have $a_t+a_x=3y$",
    ],
)
def test_what_has_such_indices_or_one_derivative_is_none(equation):
    text = rf"It moves by \[ \dot x=y,\quad\dot y=-x. \] Here {equation}."
    assert not any("partial diff" in one.role.reason for one in reading(text).formulas)


WAVE = r"""Let $v=g(\zeta)$ with $\zeta=x-ct$ travel. Then
\[ g''=cg-3g^2+%s. \] An integral is \[ B=\frac12g'^2-\frac12cg^2+g^3-%s g. \]
A solution has $g=\frac c2\cosh^{-2}\left(\frac12\sqrt c\,\zeta\right)$. """


def test_a_travelling_variable_is_not_doubted_for_its_time():
    assert not found(WAVE % ("A", "A"))
