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
