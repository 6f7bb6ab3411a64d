"""New names for what moves: the equations of motion are those for the new ones, and are claimed."""

import pytest

from kowalevski_cas.audit.reading import ReadingSession
from kowalevski_cas.reading import CLAIM, DEFINITION, read
from kowalevski_cas.source.files import decode
from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import verdicts
from tests.sample import sampled

PLANE = r"""
The equations of motion are
\begin{equation}\label{a} m\ddot x=-kx,\qquad m\ddot y=-ky . \tag{1}\end{equation}
In polar coordinates $x=r\cos\varphi$, $y=r\sin\varphi$ they are
"""
SPACE = r"""
The equations of motion are
\begin{equation} \frac{dx}{dt}=y,\qquad \frac{dy}{dt}=xz,\qquad \frac{dz}{dt}=-xy . \end{equation}
We write $y=k\sin\theta$, $z=k\cos\theta$. Then
"""


def judged(text):
    found = read(decode("paper.tex", (r"\begin{document}" + text + r"\end{document}").encode()))
    outcomes = ReadingSession(found, timeout=20).outcomes
    return {
        f.item.printed.tex.strip(" .,\n"): (f.role.name, f.claim and outcomes[f.claim.id].verdict)
        for f in found.formulas
    }


@pytest.mark.parametrize(
    ("text", "claimed"),
    sampled(
        [
            (PLANE + r"\[ m(\ddot r-r\dot\varphi^2)=-kr . \]", r"m(\ddot r-r\dot\varphi^2)=-kr"),
            (
                PLANE + r"\[ r\ddot\varphi+2\dot r\dot\varphi=0 . \]",
                r"r\ddot\varphi+2\dot r\dot\varphi=0",
            ),
            (SPACE + r"$\frac{d\theta}{dt}=x$.", r"\frac{d\theta}{dt}=x"),
            (SPACE + r"$\frac{dk}{dt}=0$.", r"\frac{dk}{dt}=0"),
        ],
        1,
    ),
)
def test_rates_of_new_names_are_claimed_and_follow(text, claimed):
    found = judged(text)
    role, verdict = found[claimed]
    assert role == CLAIM
    assert verdict.green
    new = {r"x=r\cos\varphi", r"z=k\cos\theta"} & found.keys()
    assert all(found[one][0] == DEFINITION for one in new)


@pytest.mark.slow
def test_a_false_rate_of_a_new_name_is_not_green():
    false = [
        (PLANE + r"\[ m(\ddot r+r\dot\varphi^2)=-kr . \]", r"m(\ddot r+r\dot\varphi^2)=-kr"),
        (SPACE + r"$\frac{d\theta}{dt}=-x$.", r"\frac{d\theta}{dt}=-x"),
    ]
    for text, claimed in false:
        assert judged(text)[claimed][1] in (Verdict.REFUTED, Verdict.UNDECIDED)


def test_a_set_of_fewer_dimensions_is_no_change_of_variables():
    text = SPACE.replace("We write $y=k", r"On it $x=k\tan\theta$, $y=k")
    found = read(decode("paper.tex", (r"\begin{document}" + text + r"\end{document}").encode()))
    assert [law.new for law in found.parts.laws] == [()]


PULSE = r"""
The equations of motion are
\begin{equation} \dot a=-ab,\qquad \dot b=4a^2 . \end{equation}
They have the solution
"""


@pytest.mark.parametrize(
    ("print_of_b", "green"),
    sampled([(r"c\tanh ct", True), (r"c\tanh 2ct", False), (r"2c\tanh ct", False)], 1),
)
def test_functions_of_the_time_solve_the_equations_of_motion(print_of_b, green):
    found = judged(PULSE + rf"\[ a=\frac{{c}}{{2\cosh ct}},\qquad b={print_of_b} . \]")
    verdicts = [verdict for tex, (_, verdict) in found.items() if tex[:2] in ("a=", "b=")]
    assert all(verdict.green for verdict in verdicts) is green
    assert Verdict.REFUTED not in verdicts


def test_of_a_part_of_a_solution_nothing_is_said():
    found = judged(PULSE + r"\[ b=c\tanh ct . \]")
    assert found[r"b=c\tanh ct"] == (CLAIM, None)


@pytest.mark.parametrize(
    ("claim", "verdict"),
    [
        (r"2h=\dot s^2+s^2\dot\psi^2+ks^2+2cs^4", "conditional"),
        (r"2h=\dot s^2+s^2\dot\psi^2+ks^2+cs^4", "refuted"),
        (r"\ddot s-s\dot\psi^2=-ks-4cs^3", "conditional"),
        (r"\ddot s-s\dot\psi^2=-ks-2cs^3", "refuted"),
        (r"s\ddot\psi+2\dot s\dot\psi=0", "conditional"),
        (r"s\ddot\psi+\dot s\dot\psi=0", "refuted"),
    ],
)
def test_a_force_with_a_potential_is_carried_over_to_polar_coordinates(claim, verdict):
    text = (
        r"A particle moves in the field with the potential \[ W=\tfrac12k(u^2+v^2)+c(u^2+v^2)^2 .\] "
        r"Its equations of motion are \[\ddot u=-\frac{\partial W}{\partial u},\qquad"
        r"\ddot v=-\frac{\partial W}{\partial v} .\] It has the integral of energy "
        r"\[h=\tfrac12(\dot u^2+\dot v^2)+W .\] In polar coordinates $u=s\cos\psi$, $v=s\sin\psi$ we get "
        rf"\[{claim} .\]"
    )
    assert [*judged(text).values()][-1][1].value == verdict


ROTATOR = r"The Hamiltonian is \[ H=\frac{p^2}{2m}+\frac{mk^2q^2}2 . \] "


@pytest.mark.parametrize(
    ("words", "claim", "wrong"),
    [
        (r"With $q=\sqrt{\frac{2I}{mk}}\sin\varphi$, $p=\sqrt{2Imk}\cos\varphi$ we have",
         "H=kI", "H=2kI"),
        (r"In the variables \[ q=\sqrt{\frac{2I}{mk}}\sin\varphi,\qquad p=\sqrt{2Imk}\cos\varphi \]",
         r"\dot I=0", r"\dot I=I"),
    ],
)  # fmt: skip
def test_new_variables_of_a_hamiltonian(words, claim, wrong):
    assert verdicts(rf"{ROTATOR}{words} \[ {claim} . \]")[claim].green
    found = verdicts(rf"{ROTATOR}{words} \[ {wrong} . \]").get(wrong)
    assert found is None or not found.green


PARABOLIC = r"""The motion is \[ \ddot x=-\frac{\mu x}{r^3},\qquad \ddot y=-\frac{\mu y}{r^3}, \] where $r=\sqrt{x^2+y^2}$. With
\[ h=\tfrac12(\dot x^2+\dot y^2)-\frac\mu r \] we introduce new coordinates $u$, $v$ and a new time $s$ by
\[ x=u^2-v^2,\qquad y=2uv,\qquad dt=r\,ds . \] A prime is the derivative by $s$. """


@pytest.mark.parametrize(
    "words", ["From the integral of energy we have", "Then", "Therefore the energy gives"]
)
def test_a_change_may_stand_beside_another_time(words):
    right, wrong = r"2(u'^2+v'^2)-h(u^2+v^2)=\mu", r"2(u'^2+v'^2)-h(u^2-v^2)=\mu"
    assert verdicts(rf"{PARABOLIC}{words} \[ {right} .\]")[right].green
    assert not verdicts(rf"{PARABOLIC}{words} \[ {wrong} .\]")[wrong].green


def test_what_is_constant_by_itself_and_has_a_known_value_may_be_no_integral_but_an_identity():
    text = r"The motion is \[ \dot x=ay,\qquad \dot y=-ax .\] The integral is \[ %s .\]"
    known, new = "x^2+(b-x)(b+x)=a^2", "x^2+(a-x)(a+x)=c"
    assert verdicts(text % known)[known] == Verdict.UNDECIDED
    assert verdicts(text % new)[new] == Verdict.REFUTED


def test_a_frame_that_drifts_renames_what_does_not():
    text = r"""The motion is \[ \ddot x=\omega\dot y,\qquad \ddot y=\varepsilon-\omega\dot x .\] In the drifting
    frame \[ x=X+ut,\qquad y=Y,\qquad u=\frac\varepsilon\omega, \] we have
    \[ \ddot X=\omega\dot Y,\qquad \ddot Y=SIGN\omega\dot X .\]"""
    right, wrong = (verdicts(text.replace("SIGN", sign)) for sign in ("-", ""))
    assert right[r"\ddot X=\omega\dot Y"].green and right[r"\ddot Y=-\omega\dot X"].green
    assert not wrong[r"\ddot Y=\omega\dot X"].green


def test_a_letter_of_whatever_is_called_so_is_given_later():
    text = r"""The motion is \[ \dot x=ax,\qquad \dot y=by .\] A function $f$ is called a semi-invariant if
    $\dot f=\kappa f$. For $f=xy$ we have \[ \dot f=FACTORf .\]"""
    assert verdicts(text.replace("FACTOR", "(a+b)"))[r"\dot f=(a+b)f"].green
    found = verdicts(text.replace("FACTOR", "(a-b)")).get(r"\dot f=(a-b)f")
    assert found is None or not found.green


def test_a_constant_that_is_the_sine_of_a_letter_of_its_own_may_be_any():
    text = r"""The motion is \[ \ddot x=2\omega\dot y-kx,\qquad \ddot y=-2\omega\dot x-ky .\] Here
    $\omega=\Omega\sin\lambda$. With \[ x=X\cos\omega t+Y\sin\omega t,\qquad y=-X\sin\omega t+Y\cos\omega t \]
    we have \[ \ddot X=-(kSIGN\omega^2)X,\qquad \ddot Y=-(kSIGN\omega^2)Y .\] If $\lambda=0$, then $x\dot y-y\dot x$ is an integral."""
    right, wrong = (verdicts(text.replace("SIGN", sign)) for sign in "+-")
    found = wrong.get(r"\ddot X=-(k-\omega^2)X")
    assert found is None or not found.green
    assert right[r"x\dot y-y\dot x"].green
    alone = text.partition(" If")[0]
    assert verdicts(alone.replace("SIGN", "+"))[r"\ddot X=-(k+\omega^2)X"].green


@pytest.mark.parametrize("rate", [r"\dot x=y", r"\dot x=xy", r"\frac{dx}{dt}=xy"])
def test_a_dot_beside_equations_with_primes_and_another_time_is_not_judged(rate):
    text = r"Let $x'=xy$, $y'=-x^2$. The time $t$ is introduced by $dt=x\,ds$. Then "
    assert not verdicts(rf"{text}${rate}$.")
    found = verdicts(rf"{text}${rate}$, and $(x^2+y^2)'=0$, $(x^2-y^2)'=0$.")
    assert [*found.values()] == [Verdict.PROVED, Verdict.REFUTED]


TURNING = (
    r"Consider \[\dot\gamma_1=r\gamma_2,\qquad \dot\gamma_2=-r\gamma_1,\qquad"
    r" \dot r=k\gamma_1\gamma_2 .\] "
)
OF_VECTORS = (
    r"Consider \[\dot r=k\gamma_1\gamma_2,\qquad\dot{\boldsymbol\gamma}=\boldsymbol\gamma\times"
    r"\boldsymbol\omega,\qquad \boldsymbol\omega=(0,0,r).\] "
)
IN_SPACE = (
    r"Consider \[\dot r=k\gamma_1\gamma_2,\quad\dot\gamma_1=\gamma_2r-\gamma_3q,\quad"
    r"\dot\gamma_2=-r\gamma_1,\quad\dot\gamma_3=q\gamma_1,\quad \dot q=qr.\]"
    r" The set $q=0$, $\gamma_3=0$ is invariant. "
)


@pytest.mark.parametrize("law", [TURNING, OF_VECTORS, IN_SPACE])
@pytest.mark.parametrize(
    ("claim", "wrong"),
    [
        (r"$\dot\theta=r$.", r"$\dot\theta=-r$."),
        (r"\[\ddot\theta=-k\sin\theta\cos\theta.\]", r"\[\ddot\theta=k\sin\theta\cos\theta.\]"),
        (
            r"\[\dot\theta^2+k\sin^2\theta=\mathrm{const}.\]",
            r"\[\dot\theta^2-k\sin^2\theta=\mathrm{const}.\]",
        ),
    ],
)
@pytest.mark.parametrize("words", ["We put {}. Then ", "The body swings: putting {} we have "])
def test_one_angle_may_give_several_variables_on_a_set(law, claim, wrong, words):
    text = law + words.format(r"$\gamma_1=\cos\theta$, $\gamma_2=-\sin\theta$")
    assert [*verdicts(text + claim).values()][-1] is Verdict.CONDITIONAL
    assert not [*verdicts(text + wrong).values()][-1].green


def test_an_integral_on_a_set_asks_whether_the_motion_stays_there():
    law = TURNING.replace("-r", "-2r")
    text = law + r"We put $\gamma_1=\cos\theta$, $\gamma_2=-\sin\theta$. Then "
    found = verdicts(text + r"\[\dot\theta^2+k\sin^2\theta=\mathrm{const}.\]")
    assert not [*found.values()][-1].green


VECTORS = r"""The equations of motion are
\[ \dot{\mathbf p}=a\,\mathbf p\times\mathbf M,\qquad \dot{\mathbf M}=\mathbf p\times C\mathbf p,\]
where $C=\operatorname{diag}(c_1,c_2,c_3)$. """
GRADIENTS = r"""With $H=\tfrac12aM^2+\tfrac12(c_1p_1^2+c_2p_2^2+c_3p_3^2)$ the equations of motion are
\[ \dot{\mathbf p}=\mathbf p\times\frac{\partial H}{\partial\mathbf M},\qquad \dot{\mathbf M}=\mathbf
M\times\frac{\partial H}{\partial\mathbf M}+\mathbf p\times\frac{\partial H}{\partial\mathbf p} .\] """.replace(
    "aM^2", "a(M_1^2+M_2^2+M_3^2)"
)
ANGLE = [
    r"The set $M_1=M_2=p_3=0$ is invariant. On it the equations become $\dot p_1=aM_3p_2$, "
    r"$\dot p_2=-aM_3p_1$. Setting $p_1=P\sin\theta$, $p_2=P\cos\theta$, we obtain \[ RATE .\]",
    r"The set $M_1=M_2=p_3=0$ is invariant. On it we put $p_1=P\sin\theta$, $p_2=P\cos\theta$. Then \[ RATE .\]",
]


@pytest.mark.parametrize(
    ("law", "words"), [(VECTORS, ANGLE[0]), (VECTORS, ANGLE[1]), (GRADIENTS, ANGLE[0])]
)
@pytest.mark.parametrize(
    "rate",
    [
        r"\dot\theta=aM_3",
        r"\ddot\theta=\tfrac12a(c_2-c_1)P^2\sin2\theta",
        r"\dot\theta^2+a(c_2-c_1)P^2\cos^2\theta=\mathrm{const}",
    ],
)
def test_components_of_vectors_are_given_by_an_angle_on_a_set(law, words, rate):
    assert judged(law + words.replace("RATE", rate))[rate][1].green


def test_an_angle_does_not_turn_the_other_way():
    rate = r"\dot\theta=-aM_3"
    assert not judged(VECTORS + ANGLE[1].replace("RATE", rate))[rate][1].green


def test_off_the_set_the_rate_of_the_angle_is_another_one():
    words = ANGLE[1].replace("On it we put", "We put").replace("RATE", r"\dot\theta=aM_3")
    assert not judged(VECTORS + words)[r"\dot\theta=aM_3"][1].green


@pytest.mark.parametrize("sign", "+-")
def test_a_radius_is_given_on_either_side_before_it_is_a_variable(sign):
    text = (
        r"The equations are \[\dot u=wv,\qquad \dot v=-wu,\qquad \dot w=kuv.\] Let $u^2+v^2=P^2$. "
    )
    text += rf"Setting $u=P\sin\theta$, $v=P\cos\theta$, we obtain \[\ddot\theta={sign}\tfrac12kP^2\sin2\theta .\]"
    assert [*judged(text).values()][-1][1].green is (sign == "+")


OSCILLATOR = r"""Consider the Hamiltonian \[H=\frac12(p_x^2+p_y^2)+\frac{\omega^2}2(x^2+4y^2) .\] Hamilton's equations are
\[\dot x=p_x,\qquad \dot y=p_y,\qquad \dot p_x=-\omega^2x,\qquad \dot p_y=-4\omega^2y .\]
In parabolic coordinates \[x=\xi\eta,\qquad y=\frac12(\xi^2-\eta^2) .\] The momenta transform as
\[p_x=\frac{\eta p_\xi+\xi p_\eta}{\xi^2+\eta^2},\qquad p_y=\frac{\xi p_\xi-\eta p_\eta}{\xi^2+\eta^2} .\] """
SEPARATED = r"""Let $h$ and $\kappa$ be the values of $H$ and $K=p_x(xp_y-yp_x)+\omega^2x^2y$. Then
\[p_\xi^2=2h\xi^2-\omega^2\xi^6+2\kappa,\] \[p_\eta^2=2h\eta^2-\omega^2\eta^6-2\kappa .\]"""


def test_momenta_that_are_changed_in_a_sentence_of_their_own_go_with_their_coordinates():
    form = r"The Hamiltonian becomes \[H=\frac{p_\xi^2+p_\eta^2+\omega^2(\xi^6+\eta^6)}{2(\xi^2+\eta^2)} .\]"
    assert [one.green for one in verdicts(OSCILLATOR + form).values()] == [True]
    assert [one.green for one in verdicts(OSCILLATOR + form.replace("xi^6", "xi^5")).values()] == [
        False
    ]


def test_the_values_of_two_integrals_are_named_at_once():
    text = OSCILLATOR + SEPARATED.replace("$H$ and $K=", "$H$ and $K$, where $K=")
    assert [one.green for one in verdicts(text).values()][-2:] == [True, True]
    assert [one.green for one in verdicts(text.replace("6-2", "6+2")).values()][-2:] == [
        True,
        False,
    ]


def test_derivatives_by_another_time_may_have_a_slash():
    text = (
        OSCILLATOR
        + r"If $dt=(\xi^2+\eta^2)\,d\tau$, then $d\xi/d\tau=p_\xi$ and $d\eta/d\tau=p_\eta$."
    )
    assert [one.green for one in verdicts(text).values()] == [True, True]
    wrong = text.replace(r"d\xi/d\tau=p_\xi", r"d\xi/d\tau=2p_\xi")
    assert [one.green for one in verdicts(wrong).values()] == [False, True]
