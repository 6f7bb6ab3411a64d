"""What a paper says of the flow as a whole: divergences, multipliers, densities of measures."""

import pytest

from kowalevski_cas.reading import CLAIM
from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import reading, verdicts

PLANE = r"The plane system is \[ \dot u=-v+uv,\qquad \dot v=u+au^2+bv^2 . \] "
BATH = r"""The equations are \[ \dot x=y,\qquad \dot y=-x-zy,\qquad \dot z=y^2-1 . \]
Let $E=\frac12(x^2+y^2+z^2)$. """


@pytest.mark.parametrize(
    ("words", "density", "green"),
    [
        (r"It has the integrating factor \[ M={} .\]", "(1-u)^{-1-2b}", True),
        (r"It has the integrating factor \[ M={} .\]", "(1-u)^{1-2b}", False),
        (r"The function ${}$ is a last multiplier.", "(1-u)^{-1-2b}", True),
        (r"Множитель Якоби --- \[ {} .\]", "(1-u)^{-1-2b}", True),
    ],
)
def test_a_multiplier_in_the_plane(words, density, green):
    (found,) = verdicts(PLANE + words.replace("{}", density)).values()
    assert found.green is green


@pytest.mark.parametrize(
    ("words", "green"),
    [
        (r"The measure with the density $e^{-E}$ is preserved.", True),
        (r"The measure with the density $e^{E}$ is preserved.", False),
        (r"There is an invariant measure with density \[ \mu=e^{-E} . \]", True),
        (r"The divergence of the field is $-z$.", True),
        (r"The divergence of the field is $z$.", False),
        (r"Its divergence is \[ -z . \]", True),
        (r"We find $\operatorname{div}=-z$.", True),
        (r"We find $\operatorname{div}=-y$.", False),
        (r"The divergence of the field is \[ -z<1-z . \]", True),
        (r"The divergence of the field is \[ -y<1-y . \]", False),
        (r"The divergence of the field is \[ -z<-z-1 . \]", False),
        (r"We find \[ \operatorname{div}=-z<1-z . \]", True),
        (r"We find \[ \operatorname{div}=z<1+z . \]", False),
    ],
)
def test_what_a_flow_does_to_volumes(words, green):
    (found,) = verdicts(BATH + words).values()
    assert found.green is green


@pytest.mark.parametrize(
    "words",
    [
        r"The function $e^{-E}$ is not a last multiplier.",
        r"Is the measure with the density $e^{-E}$ preserved?",
        r"Consider the measure with the density $e^{-E}$.",
        r"The density of the gas is $x^2$.",
        r"With the integrating factor $e^{-x}$ another equation is solved.",
        r"The multiplier $\mu=xy$ of Lagrange is small.",
    ],
)
def test_what_is_denied_or_said_of_something_else_is_no_density(words):
    made = {f.role.kind for f in reading(BATH + words).formulas if f.role.name == CLAIM}
    assert made.isdisjoint({"measure", "divergence"})


PUMP = r"The equations are $$\dot x=hy-ax+yz,\quad\dot y=hx-by-xz,\quad\dot z=-cz+xy.$$ "


@pytest.mark.parametrize(
    "words",
    [
        r"The right-hand side is a vector field $\mathcal X$, with $$\operatorname{div}\mathcal X={}.$$",
        r"The phase flow contracts volumes: $\nabla\cdot\mathbf f={}$.",
        r"For the phase flow $\mathrm{div}\,(X)={}$.",
    ],
)
def test_the_divergence_of_a_field_that_is_only_named_is_that_of_the_motion(words):
    for value, green in (("-(a+b+c)", True), ("-(a-b+c)", False)):
        assert [one.green for one in verdicts(PUMP + words.replace("{}", value)).values()] == [
            green
        ]


@pytest.mark.parametrize("value", ["0", "-(a+b+c)"])
@pytest.mark.parametrize(
    "words",
    [
        r"In the field $\mathbf B=(x,y,-2z)$ we have $\operatorname{div}\mathbf B={}$.",
        r"The magnetic field satisfies $\operatorname{div}\mathbf B={}$.",
        r"The field $\mathcal X$ of another system has $$\operatorname{div}\mathcal X={}.$$",
        r"Maxwell's equation is $\nabla\cdot\mathbf E={}$.",
    ],
)
def test_the_divergence_of_another_field_is_not_that_of_the_motion(words, value):
    found = {*verdicts(PUMP + words.replace("{}", value)).values()}
    assert found <= {Verdict.UNDECIDED}
