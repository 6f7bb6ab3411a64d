"""What acts beside a Hamiltonian or a Lagrangian: words tell it, and nothing is proved without it."""

import pytest

from tests.reading.test_reading import reading, verdicts

PAIR = r"""Two masses on a line have the Lagrangian
\[ L=\tfrac12(\dot x^2+\dot y^2)-\tfrac k2(x-y)^2 . \]"""
MOMENTUM = r" The momentum $P=\dot x+\dot y$ is conserved."
OSCILLATOR = r"The Hamiltonian of an oscillator is \[ H=\tfrac12(p^2+q^2) . \] "
DISC = r"""A disc has the Lagrangian
\[ L=\tfrac12m\dot x^2+\tfrac14mR^2\dot\varphi^2+mgx\sin\alpha . \] """
SPIN = r" The spin $S=\tfrac12mR^2\dot\varphi$ is conserved."


def reasons(text):
    """Why what is called an integral is not judged."""
    found = [one for one in reading(text).formulas if one.role.kind == "integral"]
    return [one.message for one in found if one.claim is None]


@pytest.mark.parametrize(
    "words",
    [
        r"A friction force $-c\dot x$ acts on the first.",
        "The second is damped.",
        r"Moreover a force $\beta$ acts on the first.",
        r"The dissipation function is $D=c\dot x^2$.",
        "The medium is viscous.",
        r"The generalised forces are $Q_1=\beta y$, $Q_2=0$.",
        r"На первую действует сила трения $-c\dot x$.",
        "Среда оказывает сопротивление.",
        "The resistance of the air is linear.",
        "There is no friction between them, but the air damps the first.",
        "The first moves without friction; the second is damped.",
        "Трение между ними отсутствует, но среда оказывает сопротивление.",
        "The function of Rayleigh is given below.",
    ],
)
def test_nothing_is_proved_by_a_lagrangian_beside_other_forces(words):
    assert [one.green for one in verdicts(PAIR + MOMENTUM).values()] == [True]
    assert not verdicts(f"{PAIR} {words} {MOMENTUM}")
    assert "more acts" in reasons(f"{PAIR} {words} {MOMENTUM}")[0]


@pytest.mark.parametrize(
    "words",
    [
        "There is no friction.",
        "We neglect the resistance of the air.",
        "Without damping the motion is bounded.",
        "Gravity acts on neither of them.",
        "Friction is not considered.",
        "Such pairs were studied by Rayleigh.",
        "The electrical resistance is high.",
        "If there were friction, all would come to rest.",
        "Трение отсутствует.",
    ],
)
def test_forces_that_do_not_act_hinder_no_proof(words):
    assert [one.green for one in verdicts(f"{PAIR} {words} {MOMENTUM}").values()] == [True]


def test_forces_of_another_section_hinder_no_proof_here():
    text = (
        rf"\section{{Friction}} A damped disc comes to rest. \section{{A pair}} {PAIR} {MOMENTUM}"
    )
    assert [one.green for one in verdicts(text).values()] == [True]
    later = rf"{PAIR} {MOMENTUM} \section{{Friction}} The pair is damped now. {MOMENTUM}"
    assert not [one for one in verdicts(rf"\section{{A pair}} {later}").values()][1:]


def test_a_printed_law_has_all_that_acts():
    text = r"""An oscillator is damped: \[ \dot q=p,\qquad \dot p=-q-cp . \]
    The energy $H=\tfrac12(p^2+q^2)$ is conserved."""
    assert [one.green for one in verdicts(text).values()] == [False]


def test_a_sentence_may_be_skipped_that_tells_of_a_force():
    told = "\n%kc: skip sentence\nThe model is damped in the next paper.\n"
    energy = "The function $F=p^2+q^2$ is a first integral."
    assert not verdicts(OSCILLATOR + told.replace("%kc: skip sentence", "") + energy)
    assert [one.green for one in verdicts(OSCILLATOR + told + energy).values()] == [True]


@pytest.mark.parametrize(
    "words",
    [
        "It rolls without slipping.",
        "It cannot slip sideways.",
        "This constraint is nonholonomic.",
        "Он катится без проскальзывания.",
    ],
)
def test_what_rolls_has_more_than_a_lagrangian(words):
    assert [one.green for one in verdicts(DISC + SPIN).values()] == [True]
    assert not verdicts(DISC + words + SPIN)


def test_with_one_degree_of_freedom_what_rolls_is_described_by_a_lagrangian():
    text = r"""A disc rolls without slipping down a plane. The Lagrangian is
    \[ L=\tfrac34m\dot x^2+mgx\sin\alpha . \]
    The energy $E=\tfrac34m\dot x^2-mgx\sin\alpha$ is conserved."""
    assert [one.green for one in verdicts(text).values()] == [True]
