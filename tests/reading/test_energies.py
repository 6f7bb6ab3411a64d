"""Equations of motion beside their Lagrangian, or their Hamiltonian: both are printed, both checked."""

import pytest

from kowalevski_cas.audit.reading import ReadingSession
from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import reading, verdicts

LAGRANGIAN = r"""The Lagrangian is \[ L=\frac12 M(\dot u^2+\dot v^2)-\frac12c(u-v)^2-bu . \]
The equations of motion are \[ M\ddot u=%s,\qquad M\ddot v=-c(v-u) . \]"""
HAMILTONIAN = r"""The Hamiltonian is \[ H=\frac{p_u^2}{2M}+\frac{p_v^2}{2Mu^2}-\frac ku . \]
The canonical equations are \[ \dot u=\frac{p_u}M,\qquad \dot v=\frac{p_v}{%s},\qquad
\dot p_u=\frac{p_v^2}{Mu^3}-\frac k{u^2},\qquad \dot p_v=0 . \]"""


def ends(text):
    found = reading(text)
    outcomes = ReadingSession(found, timeout=20).outcomes
    return [outcomes[one.claim.id] for one in found.statements if one.claim is not None]


@pytest.mark.parametrize(
    ("text", "right", "wrong"),
    [
        (LAGRANGIAN, "-c(u-v)-b", ["-c(u-v)+b", "-c(u-v)", "-c(u+v)-b", "-2c(u-v)-b"]),
        (HAMILTONIAN, "Mu^2", ["Mu", "M"]),
    ],
)
def test_rows_are_those_of_the_printed_energy(text, right, wrong):
    assert all(one.verdict.green for one in ends(text % right))
    for row in wrong:
        found = [one.verdict.green for one in ends(text % row)]
        assert found.count(False) == 1, row


@pytest.mark.slow
def test_a_row_with_another_sign_is_blamed():
    found = ReadingSession(reading(LAGRANGIAN % "-c(u-v)+b"), timeout=20)
    assert found.outcomes
    (edit,) = found.causes.misprints.values()
    assert r"\ddot{u} = -c(u - v) - b" in str(edit.words) or edit.formula is not None


@pytest.mark.parametrize(
    "more",
    [
        LAGRANGIAN % r"-c(u-v)-b-n\dot u",  # another force has a constant of its own
        LAGRANGIAN.replace("The equations", "There is friction. The equations") % "-c(u-v)",
    ],
)
def test_where_more_may_act_nothing_is_claimed(more):
    assert not ends(more)


def test_a_hamiltonian_is_constant_whatever_its_letters_are():
    (found,) = ends(HAMILTONIAN.replace("p_u", "n") % "Mu^2")
    assert found.verdict.green and "constant" in found.words
    (found,) = ends(HAMILTONIAN.replace("p_u", "n").replace("-\\frac ku", "+\\frac ku") % "Mu^2")
    assert found.verdict is Verdict.UNDECIDED


SECOND_ORDER = r"""The Hamiltonian is
\[ H=\frac1{2m}(p_u^2+p_v^2)+\frac12k(u^2+v^2)+\frac c4(u^2+v^2)^2 . \]
%s \[ m\ddot u=%s,\qquad m\ddot v=-kv-cv(u^2+v^2) . \]"""
FORCE = "-ku-cu(u^2+v^2)"


@pytest.mark.parametrize("words", ["Hence", "The equations of motion are", "Отсюда"])
def test_equations_of_the_second_order_are_those_of_the_hamiltonian(words):
    assert [one.verdict.green for one in ends(SECOND_ORDER % (words, FORCE))] == [True, True]
    for wrong in ("-ku+cu(u^2+v^2)", "-ku-cu(u^2-v^2)", "-kv-cu(u^2+v^2)"):
        first, second = ends(SECOND_ORDER % (words, wrong))
        assert first.verdict is Verdict.UNDECIDED and second.verdict.green


@pytest.mark.parametrize(
    "words",
    [
        "With friction the equations of motion are",
        "In another problem we have",
        "In the linear approximation the equations of motion are",
        "In dimensionless time, hence,",
    ],
)
def test_of_another_case_they_are_not_claimed(words):
    assert not ends(SECOND_ORDER % (words, "-ku"))


IN_MOMENTA = r"""The system has the Hamiltonian
\[ H=\frac12(p_1^2+p_2^2)+\frac12(aq_1^2+bq_2^2)+\frac12(q_1^2+q_2^2)^2 \] BRACKETS.
We write $r^2=q_1^2+q_2^2$ and $l=q_1p_2-q_2p_1$. The equations of motion read
\[ \ddot q_1=-aq_1-2r^2q_1,\qquad \ddot q_2=-bq_2-2r^2q_2 . \] One has \[ \dot l=(a-b)q_1q_2 . \]
The function \[ F=p_1^2+aq_1^2+q_1^2r^2-\frac{l^2}{a-b} \] is an integral."""
BRACKETS = ["", r"with $\{q_i,p_j\}=\delta_{ij}$", r"with $\{q_1,p_1\}=\{q_2,p_2\}=1$"]


@pytest.mark.parametrize("brackets", BRACKETS)
def test_momenta_move_by_the_hamiltonian_where_equations_of_the_second_order_are_printed(brackets):
    text = IN_MOMENTA.replace("BRACKETS", brackets)
    found = verdicts(text)
    assert all(one.green for one in found.values()) and len(found) >= 4
    assert all(one.verdict.green for one in ends(text))
    for printed, wrong in [
        (r"\dot l=(a-b)", r"\dot l=(a+b)"),
        (r"-\frac{l^2}{a-b}", r"+\frac{l^2}{a-b}"),
        ("F=p_1^2", "F=p_2^2"),
    ]:
        assert not all(one.green for one in verdicts(text.replace(printed, wrong)).values())


def test_where_the_equations_are_not_those_of_the_hamiltonian_only_they_are_judged():
    found = verdicts(IN_MOMENTA.replace("BRACKETS", "").replace("=-aq_1-2r", "=-aq_1+2r"))
    assert [*found.values()] == [Verdict.UNDECIDED, Verdict.PROVED]


ORBIT = r"The Lagrangian is \[ L=\frac12m(\dot r^2+r^2\dot\varphi^2)-U(r) . \] "


@pytest.mark.slow
@pytest.mark.parametrize(
    ("row", "is_green"),
    [
        (r"m(\ddot r-r\dot\varphi^2)=-\frac{dU}{dr}", True),
        (r"m(\ddot r+r\dot\varphi^2)=-\frac{dU}{dr}", False),
        (r"m(\ddot r-r\dot\varphi^2)=\frac{dU}{dr}", False),
    ],
)
def test_rows_with_a_potential_of_which_nothing_is_said(row, is_green):
    text = (
        rf"{ORBIT}The equations of motion are \[ {row},\qquad\frac d{{dt}}(mr^2\dot\varphi)=0 . \]"
    )
    assert all(one.verdict.green for one in ends(text)) is is_green and ends(text)


@pytest.mark.parametrize(
    ("text", "row", "wrong"),
    [
        (ORBIT + r"The momentum $l=mr^2\dot\varphi$ is conserved, and \[ ROW . \]",
         r"m\ddot r=\frac{l^2}{mr^3}-U'(r)", r"m\ddot r=\frac{l^2}{mr^2}-U'(r)"),
        (r"The Hamiltonian is \[ H=\frac{p_r^2}{2m}+\frac{p_\varphi^2}{2mr^2}+U(r) . \] Hence"
         r"\[ \dot r=\frac{p_r}m,\quad\dot\varphi=\frac{p_\varphi}{mr^2},\quad ROW . \]",
         r"\dot p_r=\frac{p_\varphi^2}{mr^3}-U'(r)", r"\dot p_r=\frac{p_\varphi^2}{2mr^3}-U'(r)"),
    ],
)  # fmt: skip
def test_equations_for_some_of_the_coordinates_follow(text, row, wrong):
    right, other = ([*verdicts(text.replace("ROW", one)).values()] for one in (row, wrong))
    assert right and all(one.green for one in right)
    assert not all(one.green for one in other)


@pytest.mark.parametrize(
    "text",
    [
        ORBIT
        + r"Consider now a spring, \[ m\ddot r=-kr . \] Then $m\dot r^2+kr^2$ is an integral.",
        r"The first system has the Lagrangian \[ L=\frac12(\dot x^2+\dot y^2)-\frac12(x^2+y^2) . \]"
        r" The second one is \[ \ddot x=-x^3 . \] It has the integral $\dot x^2+\frac12x^4$.",
    ],
)
def test_equations_for_one_coordinate_that_need_no_other_are_a_law(text):
    assert [one.green for one in verdicts(text).values()] == [True]


def test_a_row_of_special_motions_is_not_claimed_of_all():
    found = ends(ORBIT + r"For circular orbits \[ m\ddot r=0 . \]")
    assert all(one.verdict is not Verdict.REFUTED for one in found)


LATTICE = r"The lattice is given by \[ H=\frac12(p_1^2+p_2^2)+e^{q_1-q_2} . \] Then $p_1+p_2$ is an integral."


def test_coordinates_and_momenta_say_that_it_is_a_hamiltonian():
    assert [one.green for one in verdicts(LATTICE).values()] == [True]
    found = verdicts(LATTICE.replace("p_1+p_2$", "p_1-p_2$"))
    assert [one.value for one in found.values()] == ["refuted"]


@pytest.mark.parametrize(
    "text",
    [
        LATTICE.replace("lattice", "ball that rolls without sliding"),
        LATTICE.replace("lattice", "charge in a magnetic field"),
        LATTICE + " There is friction.",
        LATTICE + " The equations are not Hamilton's but gradient ones.",
        LATTICE + " The motion is damped.",
        LATTICE + " These variables are not the canonical ones.",
        LATTICE.replace("e^{q_1-q_2}", "V"),
        LATTICE.replace("p", "M"),
        LATTICE.replace("^2", ""),
        LATTICE.replace("The lattice", "It is not true that the lattice"),
        r"For a top \[ H=\frac12(Ap^2+Bq^2+Cr^2) . \] Then $r$ is an integral.",
        r"In a fluid \[ H=\frac12(aM_1^2+bM_2^2)+\frac12(cp_1^2+dp_2^2) . \] Then $p_1$ is an integral.",
    ],
)
def test_other_energies_move_nothing(text):
    assert not any(one.green for one in verdicts(text).values())


@pytest.mark.parametrize(
    ("text", "right", "wrong"),
    [
        (
            r"Let $H=\frac12p^2+\frac12q^2$ be the Hamiltonian. The canonical equations are $\dot q=p$, $\dot p=%s$.",
            "-q",
            ["q", "-2q"],
        ),
        (
            r"Let $H=\frac12p^2+U(q)$ with $U=\frac14q^4$. Hence \[\dot q=p,\qquad \dot p=%s .\]",
            "-q^3",
            ["-q^2", "q^3"],
        ),
    ],
)
def test_a_hamiltonian_in_words_behind_it_or_from_which_a_law_is_deduced(text, right, wrong):
    assert [one.verdict.green for one in ends(text % right)] == [True, True]
    for one in wrong:
        assert [end.verdict.green for end in ends(text % one)] == [True, False]


def test_a_law_with_another_force_is_not_that_of_the_energy_before_it():
    text = r"Let $H=\frac12p^2+\frac14q^4$. With friction we thus have \[\dot q=p,\qquad \dot p=-q^3-cp .\]"
    assert not ends(text)


PAIR = r"""Two particles have the Hamiltonian \[ H=\frac12(p_1^2+p_2^2)+\frac{g^2}{(x_1-x_2)^2} .\]
Thus for the first one \[ \ddot x_1=\frac{2g^2}{(x_1-x_2)^3} .\] """


@pytest.mark.parametrize(
    ("claim", "green"),
    [
        (r"Let $I=x_1^2+x_2^2$. Then \[ \ddot I=4H .\]", True),
        (r"Let $I=x_1^2+x_2^2$. Lagrange's identity gives \[ \ddot I=4H .\]", True),
        (r"Let $I=x_1^2+x_2^2$. Then \[ \ddot I=2H .\]", False),
        (r"The moment \[ J=x_1+x_2-t(p_1+p_2) \] is an integral.", True),
        (r"The moment \[ J=x_1-x_2-t(p_1-p_2) \] is an integral.", False),
    ],
)
def test_one_of_several_equations_of_newton_is_not_the_law_beside_a_hamiltonian(claim, green):
    *_, last = verdicts(PAIR + claim).values()
    assert last.green is green


def test_behind_another_hamiltonian_nothing_is_refuted_by_the_first():
    more = r"""\section{Two bodies} Let \[ H_0=\frac12(p_1^2+p_2^2)+\frac12k(x_1-x_2)^2 .\]
    The distance $r=x_1-x_2$ obeys \[ \ddot r=-2kr .\]"""
    *_, last = verdicts(PAIR + more).values()
    assert last is Verdict.UNDECIDED


def test_an_energy_behind_equations_among_words_is_not_their_law():
    text = r"Let $\dot q=p$, $\dot p=-q$. The transformation $Q=%sq$, $P=p$ is canonical, and $H=\frac12(P^2+Q^2)$ is conserved."
    assert [one.green for one in verdicts(text % "2").values()] == [False]
    assert [one.green for one in verdicts(text % "").values()] == [True]


PLANE = (
    r"A particle of mass $m$ moves in the plane. The potential is $U=\frac12k(x^2+y^2)$. We have "
)


@pytest.mark.parametrize(
    ("text", "right"),
    [
        (PLANE + r"\[ m\ddot x=-kx,\qquad m\ddot y=-ky . \]", [True, True]),
        (PLANE + r"\[ m\ddot x=-kx,\qquad m\ddot y=ky . \]", [True, False]),
        (PLANE + r"\[ \ddot x=-\frac kmx,\qquad\ddot y=-\frac kmy . \]", [True, True]),
        (r"The potential energy of the mass $m$ is $V=mgz$. Then \[ \ddot z=-g . \]", [True]),
        (
            r"For the potential $V=x^2y$ we have \[ \ddot x=-2xy,\qquad\ddot y=-x . \]",
            [True, False],
        ),
        # an angle, a force that is no slope, and what is no potential of a force
        (r"The pendulum has the potential $V=-mgl\cos q$, and \[ \ddot q=-\frac gl\sin q . \]", []),
        (r"For the potential $V=x^2$ with friction, \[ \ddot x=-2x-\mu\dot x . \]", []),
        (r"In the effective potential $V=x^2$ we have \[ \ddot x=-x . \]", []),
        (r"With the force function $U=-x^2$ we have \[ \ddot x=-2x . \]", []),
    ],
)
def test_accelerations_are_those_of_a_potential(text, right):
    found = reading(text + " The motion is integrable.")
    outcomes = ReadingSession(found).outcomes
    told = [one for one in found.statements if one.claim and one.role.kind == "energy"]
    assert [outcomes[one.claim.id].verdict.green for one in told] == right
    assert not any(outcomes[one.claim.id].verdict is Verdict.REFUTED for one in told)


@pytest.mark.parametrize(
    ("text", "right", "wrong"),
    [
        (
            r"Let $H=\frac12p^2+\frac14q^4$. Hamilton's equations are $\dot q=p$, $\dot p=§$.",
            "-q^3",
            "q^3",
        ),
        (r"Let $H=\frac12p^2+\frac14q^4$. Then $\dot q=p$, $\dot p=§$.", "-q^3", "q^3"),
        (
            r"The energy is $H=\frac12p^2+\frac12q^2$, the equations of motion read $\dot q=p$, $\dot p=§$.",
            "-q",
            "q",
        ),
        (r"Let $L=\frac12\dot q^2-\frac12q^2$. The equation of motion is $\ddot q=§$.", "-q", "q"),
        (
            r"Let $E=\frac12\dot q^2+\frac12q^2$ be the energy. The motion is $\ddot q=§$.",
            "-q",
            "q",
        ),
        (
            r"A mass moves by \[ m\ddot x=-kx. \] The energy is $E=\frac12m\dot x^2+§$.",
            r"\frac12kx^2",
            "kx^2",
        ),
        (
            r"Let $\ddot q_1=-e^{q_1-q_2}$, $\ddot q_2=e^{q_1-q_2}$. The energy is "
            r"$H=\frac12(\dot q_1^2+\dot q_2^2)§e^{q_1-q_2}$.",
            "+",
            "-",
        ),
        (
            r"A point moves by \[ \ddot{\mathbf r}=-\mu\mathbf r/r^3. \] "
            r"The energy is $h=\frac12\dot{\mathbf r}^2§\frac\mu r$.",
            "-",
            "+",
        ),
    ],
)
def test_equations_behind_an_energy_are_its_own_and_an_energy_behind_equations_theirs(
    text, right, wrong
):
    assert [one.verdict.green for one in ends(text.replace("§", right))].count(False) == 0
    assert not all(one.verdict.green for one in ends(text.replace("§", wrong)))


@pytest.mark.parametrize(
    "text",
    [
        r"Let $L=\frac12\dot q^2-\frac12q^2$. With friction the equation of motion is $\ddot q=-q-k\dot q$.",
        r"Let $E=\frac12\dot q^2+\frac12q^2$ be the energy. The motion is $\ddot q=-q-k\dot q$.",
        r"A mass moves by \[ m\ddot x=-kx. \] The kinetic energy is $E=\frac12m\dot x^2$.",
        r"A mass moves by \[ m\ddot x=-kx+f. \] The energy of the spring is $E=\frac12m\dot x^2+\frac12kx^2$.",
    ],
)
def test_what_has_more_is_not_compared(text):
    assert not ends(text)


def test_of_a_letter_that_no_words_call_so_nothing_is_red():
    [first, _] = ends(LAGRANGIAN.replace("The Lagrangian is", "Here is") % "-c(u-v)")
    assert first.verdict is Verdict.UNDECIDED


BEAD = r"A bead moves with the Lagrangian \[L=\frac12m\dot x^2-\frac12kx^2.\] "
PLANE = r"The Lagrangian is \[L=\frac12m(\dot r^2+r^2\dot\varphi^2)-U(r).\] "
WELL = (
    r"A particle moves by \[\ddot x=-\frac{\partial U}{\partial x},\qquad"
    r" \ddot y=-\frac{\partial U}{\partial y},\qquad U=\frac12(x^2+4y^2).\] "
)


@pytest.mark.parametrize(
    ("text", "right", "wrong"),
    [
        (
            BEAD + r"The momentum is $p=m\dot x$, and the Hamiltonian is \[H=%skx^2.\]",
            r"\frac{p^2}{2m}+\frac12",
            [r"\frac{p^2}{2m}-\frac12", r"\frac{p^2}{m}+"],
        ),
        (
            PLANE + r"The momenta are $p_r=m\dot r$, $p_\varphi=mr^2\dot\varphi$. The Hamiltonian"
            r" reads \[H=\frac{1}{2m}\left(p_r^2+%s\right)+U(r).\]",
            r"\frac{p_\varphi^2}{r^2}",
            [r"\frac{p_\varphi^2}{r}"],
        ),
        (
            WELL + r"With $p_x=\dot x$, $p_y=\dot y$ the Hamiltonian is"
            r" $H=\frac12(p_x^2+p_y^2)+\frac12x^2+%sy^2$.",
            "2",
            ["", "-2"],
        ),
    ],
)
def test_a_hamiltonian_in_momenta_is_the_one_of_its_law(text, right, wrong):
    *_, last = ends(text % right)
    assert last.verdict.green
    for other in wrong:
        *_, last = ends(text % other)
        assert not last.verdict.green


@pytest.mark.parametrize(("sign", "green"), [("+", True), ("-", False)])
@pytest.mark.parametrize(
    "change",
    [
        r"In the polar coordinates $x=r\cos\varphi,\quad y=r\sin\varphi$ they become"
        r"\[ \ddot r-r\dot\varphi^2=-kr+2nr\dot\varphi,\qquad r\ddot\varphi+2\dot r\dot\varphi=-2n\dot r . \]",
        r"Put \[ x=u+v,\qquad y=u-v . \] Then \[ \ddot u=-ku-2n\dot v . \]",
    ],
)
def test_a_lagrangian_is_one_of_equations_of_which_the_variables_are_changed(change, sign, green):
    text = r"The motion obeys \begin{align} \ddot x&=-kx+2n\dot y,\\ \ddot y&=-ky-2n\dot x . \end{align} "
    text += r"These are the Lagrange equations of \[ L=\frac12(\dot x^2+\dot y^2)"
    text += rf"{sign}n(x\dot y-y\dot x)-\frac12k(x^2+y^2) . \] "
    outcomes = ReadingSession(reading(text + change), timeout=20).outcomes
    found = [one.verdict for id, one in outcomes.items() if id.startswith("energy")]
    assert [one.green for one in found] == [green, green]


LEGENDRE = r"""The motion is described by the Lagrangian
\[L=\frac{m}{2}(\dot r^2+r^2\dot\varphi^2)+\frac{\alpha}{r} .\] The generalized momenta are $p_r=m\dot r$ and
$p_\varphi=mr^2\dot\varphi$; the Hamiltonian is therefore \[H=\frac{p_r^2}{2m}+\frac{p_\varphi^2}{2mr^2}-\frac\alpha r .\]
The canonical equations are \[\dot r=\frac{p_r}{m},\quad\dot\varphi=\frac{p_\varphi}{mr^2},\quad
\dot p_r=\frac{p_\varphi^2}{mr^3}-\frac{\alpha}{r^2},\quad\dot p_\varphi=0 .\]"""


@pytest.mark.parametrize(
    ("right", "wrong", "false"),
    [
        ("", "", 0),
        (r"{mr^3}", r"{mr^2}", 1),
        (r"p_\varphi=mr^2\dot", r"p_\varphi=mr\dot", 4),
        (r"\dot r=\frac{p_r}{m}", r"\dot r=\frac{p_r}{2m}", 1),
    ],
)
def test_canonical_equations_behind_a_lagrangian_and_its_momenta_follow(right, wrong, false):
    found = [one.green for one in verdicts(LEGENDRE.replace(right, wrong, 1)).values()]
    assert len(found) == 6
    assert found.count(False) == false


@pytest.mark.parametrize("wrong", ["", r"\dot\theta=p_\theta/mr", r"\dot p_\theta=r"])
def test_equations_that_a_hamiltonian_gives_one_by_one_are_claims(wrong):
    text = r"""The Hamiltonian is \[H=\frac{p_r^2}{2m}+\frac{p_\theta^2}{2mr^2}+V(r) .\]
    Hamilton's equations give $\dot r=p_r/m$, $\dot\theta=p_\theta/mr^2$, $\dot p_\theta=0$ and
    \[\dot p_r=\frac{p_\theta^2}{mr^3}-V'(r) .\]"""
    text = text.replace(
        f"{wrong}^2" if wrong.endswith("mr") else r"\dot p_\theta=0", wrong or r"\dot p_\theta=0"
    )
    found = [one.green for one in verdicts(text).values()]
    assert len(found) == 4
    assert found.count(False) == bool(wrong)
