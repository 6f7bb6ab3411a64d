"""What words call a momentum belongs to the Lagrangian before it."""

import random

import pytest

from kowalevski_cas.reading import CLAIM, DEFINITION
from kowalevski_cas.verify.outcome import Verdict
from tests.audit.test_doubted import audited
from tests.reading.test_reading import roles, verdicts
from tests.sample import sampled

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


@pytest.mark.parametrize(
    ("text", "formula", "verdict"),
    [
        (CENTRAL + r"The momentum is $p_\varphi=§$.", r"mr^2\dot\varphi", Verdict.CONDITIONAL),
        (CENTRAL + r"The momentum is $p_\varphi=§$.", r"mr\dot\varphi", Verdict.UNDECIDED),
    ],
)
def test_the_audit_says_of_the_formula_what_is_found(text, formula, verdict):
    [found] = [
        one for one in audited(text.replace("§", formula)).formulas if one.tex.startswith("p_")
    ]
    assert found.verdict == verdict
    assert ("mr^2" in found.message) == (verdict is Verdict.UNDECIDED)


def a_change(seed):
    """A change of two coordinates by polynomials, with a momentum, and whether it is the right one."""
    rnd = random.Random(seed)
    first, second = ([(rnd.randint(-3, 3) or 1, i, j) for i, j in ((1, 0), (1, 1))] for _ in "xy")
    second[0] = (second[0][0], 0, 2)

    def tex(terms):
        return "+".join(f"({c}){'u' * i}{'v' * j}" for c, i, j in terms)

    name, at = rnd.choice([("u", 1), ("v", 2)])

    def slope(terms):
        by = [(term[0] * term[at], term[1] - (at == 1), term[2] - (at == 2)) for term in terms]
        return tex([one for one in by if one[0]]) or "0"

    right = rnd.random() < 0.5
    sign = "+" if right else "-"
    return (
        rf"""The Hamiltonian is \[ H=\frac12(p_x^2+p_y^2)+ax. \] Put $x={tex(first)}$, $y={tex(second)}$.
        The conjugate momentum is \[ p_{name}=({slope(first)})p_x{sign}({slope(second)})p_y. \]""",
        right,
        slope(second) == "0",
    )


@pytest.mark.parametrize("seed", sampled(range(40), 4))
def test_momenta_of_changes_by_polynomials(seed):
    text, right, alike = a_change(seed)
    [verdict] = [verdict for tex, verdict in verdicts(text).items() if tex.startswith("p_")]
    assert verdict.green == (right or alike), text


@pytest.mark.parametrize(("sign", "true"), [("+", True), ("-", False)])
def test_a_lagrangian_may_end_a_chain(sign, true):
    """In letters that nothing gives it stands first, and in coordinates and velocities at the end."""
    text = r"""A charge moves by $$\ddot x=\omega\dot y,\quad\ddot y=-\omega\dot x.$$ The Lagrangian is
    $$L=T+qW=\tfrac12m(\dot x^2+\dot y^2)+\tfrac12qB(x\dot y-y\dot x),$$ and the canonical momenta are """
    found = verdicts(text + rf"$$p_x=m\dot x-\tfrac12qBy,\quad p_y=m\dot y{sign}\tfrac12qBx.$$")
    assert [one.green for tex, one in found.items() if tex.startswith("p_")] == [True, true]
