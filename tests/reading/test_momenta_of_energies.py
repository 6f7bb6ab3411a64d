"""What words call a momentum belongs to the Lagrangian before it."""

import pytest

from kowalevski_cas.reading import CLAIM, DEFINITION
from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import roles, verdicts

CENTRAL = r"The Lagrangian is \[ L=\frac12m(\dot r^2+r^2\dot\varphi^2)+\frac kr. \] "
FIELD = r"Let \[ L=\frac12(\dot x_1^2+\dot x_2^2)+a\dot x_1x_2 \] be the Lagrangian. "


@pytest.mark.parametrize(
    ("law", "words", "right", "wrong"),
    [
        (CENTRAL, r"It leads to the momentum $p_\varphi=§$.", r"mr^2\dot\varphi", r"mr\dot\varphi"),
        (CENTRAL, r"The momenta are \[ p_r=§. \]", r"m\dot r", r"\dot r"),
        (FIELD, r"The momentum $p_1=§$ is conjugate to $x_1$.", r"\dot x_1+ax_2", r"\dot x_1-ax_2"),
        (FIELD, r"Импульс равен $p_2=§$.", r"\dot x_2", r"\dot x_2+ax_1"),
    ],
)
def test_a_momentum_is_the_derivative_of_the_lagrangian(law, words, right, wrong):
    for formula, green in ((right, True), (wrong, False)):
        [(tex, verdict)] = [
            (tex, verdict)
            for tex, verdict in verdicts(law + words.replace("§", formula)).items()
            if tex.startswith("p_")
        ]
        assert verdict.green if green else verdict is Verdict.UNDECIDED, tex


def test_its_name_is_known_from_there_on():
    text = (
        CENTRAL + r"The momentum is $p_\varphi=mr^2\dot\varphi$. Then $p_\varphi$ is an integral."
    )
    assert verdicts(text)["p_\\varphi"].green


@pytest.mark.parametrize(
    "words",
    [
        r"The total momentum is $p_r=m\dot r$.",
        r"The angular momentum is $p_\varphi=mr^2\dot\varphi$.",
        r"The pressure is $p_r=m\dot r$.",
        r"The momentum is $\pi=m\dot r$.",
    ],
)
def test_what_words_do_not_call_so_is_a_definition(words):
    [role] = [
        role for tex, role in roles(CENTRAL + words).items() if tex[0] in "p\\" and "L" not in tex
    ]
    assert role == DEFINITION != CLAIM


PLANE = (
    r"The Hamiltonian is \[ H=\frac12(p_x^2+p_y^2)+ax. \] Put $x=r\cos\varphi$, $y=r\sin\varphi$. "
)
PARABOLIC = (
    r"The Hamiltonian is \[ H=\frac12(p_x^2+p_y^2)+ax. \] Put $x=\frac12(u^2-v^2)$, $y=uv$. "
)


@pytest.mark.parametrize(
    ("change", "name", "right", "wrong"),
    [
        (PLANE, "p_r", r"p_x\cos\varphi+p_y\sin\varphi", r"p_x\cos\varphi-p_y\sin\varphi"),
        (PLANE, r"p_\varphi", r"xp_y-yp_x", r"xp_y+yp_x"),
        (PARABOLIC, "p_u", "up_x+vp_y", "up_x-vp_y"),
        (PARABOLIC, "p_v", "up_y-vp_x", "up_y+vp_x"),
    ],
)
def test_a_momentum_of_a_new_coordinate_is_that_of_the_change(change, name, right, wrong):
    for formula, green in ((right, True), (wrong, False)):
        found = verdicts(change + rf"The conjugate momentum is ${name}={formula}$.")
        verdict = found[f"{name}={formula}"]
        assert verdict.green if green else verdict is Verdict.UNDECIDED


@pytest.mark.parametrize(("power", "green"), [("^2", True), ("", False)])
def test_the_energy_is_known_in_new_momenta(power, green):
    formula = rf"H=\frac12\left(p_r^2+\frac{{p_\varphi^2}}{{r{power}}}\right)+ar\cos\varphi"
    text = rf"""{PLANE} With the momenta \[ p_r=p_x\cos\varphi+p_y\sin\varphi,\qquad
    p_\varphi=xp_y-yp_x \] the Hamiltonian becomes \[ {formula}. \]"""
    assert verdicts(text)[formula].green == green
