"""What is so at a place, in a case, approximately or of one motion is not claimed of all."""

import pytest

from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import verdicts
from tests.sample import sampled

PENDULUM = r"The equation of motion is $l\ddot\theta+g\sin\theta=0$. "
EULER = r"Euler's equations are \[A\dot p=(B-C)qr,\quad B\dot q=(C-A)rp,\quad C\dot r=(A-B)pq.\] "


@pytest.mark.parametrize(
    "words",
    sampled(
        [
            r"Assuming $\theta$ to be small we get $l\ddot\theta+g\theta=0$.",
            r"As long as $|\theta|\ll1$, we obtain $l\ddot\theta+g\theta=0$.",
            r"Ограничиваясь линейными членами, получаем $l\ddot\theta+g\theta=0$.",
            r"Если принять $\theta$ малым, то получаем $l\ddot\theta+g\theta=0$.",
            r"In weightlessness we get $\ddot\theta=0$.",
            r"Hence at the lowest point $\ddot\theta=0$.",
            r"Hence $\ddot\theta=0$ at this moment.",
            r"Consequently in equilibrium $\ddot\theta=0$.",
        ],
        3,
    ),
)
def test_what_is_so_in_some_circumstance_is_not_refuted(words):
    assert Verdict.REFUTED not in verdicts(PENDULUM + words).values()


@pytest.mark.parametrize(
    "words",
    sampled(
        [
            r"For a body with equal moments the right-hand sides vanish; hence $\dot p=0$.",
            r"For a ball, therefore, $p$, $q$, $r$ are constant.",
            r"Consequently for a symmetric body $\dot r=0$.",
            r"Hence in a permanent rotation $\dot p=0$, $\dot q=0$, $\dot r=0$.",
            r"We find that $\dot r=0$ twice in a period.",
            r"Therefore $\dot r=0$ if the body is symmetric.",
            r"It would follow that $\dot r=1$, which is absurd.",
            r"Если тело симметрично, то $\dot r=0$.",
            r"Отсюда в положении равновесия $\dot p=0$.",
            r"For some motions $\dot p=0$.",
            r"Initially $\dot p=0$.",
            r"If $p$ is constant, then $\dot p=0$.",
            r"Neglecting the product of $q$ and $r$, we get $\dot p=0$.",
            r"The equality $\dot p=0$ means that $p$ is constant.",
            r"The case $\dot p=0$ is excluded.",
            r"We require $\dot p=0$.",
            r"We do not have $\dot p=0$.",
            r"We ask whether $\dot p=0$.",
            r"Many authors write $\dot p=0$.",
            r"Suppose, on the contrary, that $\dot p=0$.",
            r"Точки, где $\dot p=0$, суть точки возврата.",
            r"Im Gleichgewicht ist $\dot p=0$.",
            r"À l'équilibre $\dot p=0$.",
        ],
        6,
    ),
)
def test_what_is_so_of_some_bodies_or_motions_is_not_refuted(words):
    assert Verdict.REFUTED not in verdicts(EULER + words).values()


@pytest.mark.parametrize(
    "words",
    [
        "Hence",
        "It follows that",
        "Differentiating, we obtain",
        "Hence, on the other hand,",
        "Hence, in particular,",
        "On differentiating we find",
        "In this way we find",
    ],
)
def test_without_one_it_is(words):
    (found,) = verdicts(rf"{PENDULUM}{words} \[l\dddot\theta=g\dot\theta\cos\theta.\]").values()
    assert found == Verdict.REFUTED


@pytest.mark.parametrize(
    ("words", "green"),
    [
        (r"Hence $\dot\theta^2=\frac{4g}{l}\cos^2\frac\theta2$.", False),
        (r"Integrating, we obtain $\dot\theta^2=\frac{2g}{l}\cos\theta$.", False),
        (r"On the separatrix $\dot\theta^2=\frac{4g}{l}\cos^2\frac\theta2$.", True),
        (r"On the separatrix $\dot\theta^2=\frac{2g}{l}\cos^2\frac\theta2$.", False),
        (r"Integrating, we obtain $\dot\theta^2=\frac{2g}{l}\cos\theta+h$.", True),
    ],
)
def test_what_is_deduced_of_all_motions_needs_a_constant(words, green):
    (found,) = verdicts(PENDULUM + words).values()
    assert found.green == green and found != Verdict.REFUTED


def test_a_rate_on_a_circle_is_no_law():
    text = r"""The Lagrangian is \[ L=\tfrac12(\dot r^2+r^2\dot\varphi^2)-U(r). \]
    Hence \[ \ddot r=r\dot\varphi^2-U'(r). \] The energy
    \[ h=\tfrac12\dot r^2+\frac{c^2}{2r^2}+U(r),\qquad c=r^2\dot\varphi, \] is conserved.
    A circle $r=r_0$ is described with the angular velocity $\dot\varphi=\Omega$."""
    found = verdicts(text)
    assert Verdict.REFUTED not in found.values()
    assert sum(one.green for one in found.values()) >= 2


@pytest.mark.parametrize(
    ("words", "judged"),
    [
        (r"Suppose that $p^2+q^2$ is constant. Then $C=A+B$.", 0),
        (r"If $p^2+q^2$ is constant, then $A=B$.", 0),
        (r"The function $p^2+q^2$ is constant.", 1),
        (r"If $A=B$, then $r$ is constant.", 1),
    ],
)
def test_what_is_supposed_to_be_constant_is_not_claimed(words, judged):
    assert len(verdicts(EULER + words)) == judged


@pytest.mark.parametrize("words", ["e.g., a lamina", "for example a lamina", "например, пластину"])
def test_what_an_example_has_defines_no_constant_of_a_law(words):
    text = rf"{EULER} Consider, {words}, where $C=A+B$. For an ellipsoid $p^2+q^2$ is constant."
    assert not any(one.green for one in verdicts(text).values())


def test_a_false_claim_under_a_printed_condition_is_refuted():
    (found,) = verdicts(EULER + r"The function $p^2+q$ is an integral if $A=B$.").values()
    assert found == Verdict.REFUTED


def test_what_is_supposed_where_it_stops_all_motion_is_not_left_out():
    text = r"The equations are $\dot x=by$, $\dot y=-bx$. If $b=0$, then $\dot x=0$."
    assert not [one for one in verdicts(text).values() if one == Verdict.REFUTED]


@pytest.mark.parametrize(
    ("words", "claim", "green"),
    [
        ("", r"\dot x^2=x^2", False),
        (r" and $x\to0$ as $t\to\infty$", r"\dot x^2=x^2", True),
        (r" and $x\to0$ as $t\to\infty$", r"\dot x^2=2x^2", False),
    ],
)
def test_what_a_motion_tends_to_says_of_which_it_is_deduced(words, claim, green):
    assert verdicts(rf"Let $\ddot x=x${words}. Hence ${claim}$.")[claim].green == green


@pytest.mark.parametrize(
    "words",
    [
        r"As soon as the first two of the moments are equal, $r$ is an integral.",
        r"The first two moments being equal, $r$ is constant.",
        r"The body is at rest: $\dot r=0$. Later it is pushed.",
        r"The body has on its steady rotations the property $p^2+q^2=1$.",
    ],
)
def test_what_words_suppose_of_constants_or_of_a_state_is_not_refuted(words):
    found = verdicts(EULER + words)
    assert Verdict.REFUTED not in found.values() and not any(v.green for v in found.values())


def test_what_is_said_of_all_is_refuted():
    words = r"The pendulum has on every motion the integral $\dot\theta^2+\frac{2g}l\cos\theta$."
    assert [*verdicts(PENDULUM + words).values()] == [Verdict.REFUTED]
