"""A Hamiltonian in other coordinates gives equations of motion in these, to the end of a section."""

import pytest

from tests.reading.test_reading import verdicts

LAW = r"The equations of motion are \[ \ddot x=-x,\qquad \ddot y=-y . \] "
POLAR = r"""In polar coordinates the Hamiltonian is
\[ H=\frac12\left(p_r^2+\frac{p_\varphi^2}{r^2}\right)+\frac12r^2 . \] """
PARABOLIC = r"""In the new variables the Hamiltonian is
\[ H=\frac{p_\xi^2+p_\eta^2}{2(\xi^2+\eta^2)}+\frac{\xi^4+\eta^4}{\xi^2+\eta^2} . \] """


@pytest.mark.parametrize(
    ("claim", "green"),
    [
        (r"\dot p_r=\frac{p_\varphi^2}{r^3}-r", True),
        (r"\dot p_r=\frac{p_\varphi^2}{r^2}-r", False),
        (r"\dot p_\varphi=0", True),
        (r"\dot\varphi=\frac{p_\varphi}{r^2}", True),
        (r"\dot\varphi=\frac{p_\varphi}{r}", False),
    ],
)
def test_its_equations_are_decided(claim, green):
    found = verdicts(rf"{LAW}{POLAR}Hence \[ {claim} . \]")
    assert [one.green for one in found.values()] == [green]


@pytest.mark.parametrize(("sign", "green"), [("+", True), ("-", False)])
def test_the_variables_separate_on_its_level(sign, green):
    text = rf"""On the level $H=E$ the variables separate,
\[ \frac12p_\xi^2+\xi^4-E\xi^2=c,\qquad \frac12p_\eta^2{sign}\eta^4-E\eta^2=-c . \]"""
    assert [one.green for one in verdicts(LAW + PARABOLIC + text).values()] == [True, green]


def test_the_first_law_is_there_in_the_next_section():
    text = rf"\section{{A}}{LAW}\section{{B}}{POLAR}Hence $\dot p_\varphi=0$. \section{{C}}"
    found = verdicts(text + r"The function $x\dot y-y\dot x$ is an integral.")
    assert [one.green for one in found.values()] == [True, True]


ATWOOD = r"""The equations of motion are \[ 4\ddot r=r\dot\theta^2-g(3-\cos\theta),\qquad
r\ddot\theta+2\dot r\dot\theta+g\sin\theta=0 . \] """


@pytest.mark.parametrize(("value", "green"), [("2", True), ("4", False)])
def test_a_rate_beside_its_value_is_claimed(value, green):
    text = r"They have the solutions with $\theta=0$, $\dot\theta=0$, for which "
    found = verdicts(ATWOOD + text + rf"\[ \ddot r=-\kappa,\qquad \kappa=\frac g{value} . \]")
    assert [one.green for one in found.values()] == [green]


OSCILLATOR = r"The Hamiltonian is \[H=\frac{1}{2}(p_x^2+p_y^2)+\frac12\omega^2(x^2+y^2) .\] "


@pytest.mark.parametrize(
    ("words", "form", "wrong"),
    [
        (
            r"In polar coordinates, $x=r\cos\varphi$, $y=r\sin\varphi$, it becomes",
            r"H=\frac12\left(p_r^2+\frac{p_\varphi^2}{r^2}\right)+\frac12\omega^2r^2",
            (r"{r^2}", "{r}"),
        ),
        (
            r"Put $x=\frac12(u^2-v^2)$, $y=uv$. Then",
            r"H=\frac{p_u^2+p_v^2}{2(u^2+v^2)}+\frac18\omega^2(u^2+v^2)^2",
            (r"\frac18", r"\frac14"),
        ),
    ],
)
def test_in_coordinates_that_are_printed_it_is_claimed(words, form, wrong):
    text = rf"{OSCILLATOR}{words} \[{form} .\]"
    assert [one.green for one in verdicts(text).values()] == [True]
    assert [one.green for one in verdicts(text.replace(*wrong)).values()] == [False]
