"""Laws of motion as papers print them: what follows of them is proved, and what does not is refuted."""

import random

import pytest
from sympy import latex

from tests.laws.test_constraints import CURVES, SURFACES, XYZ
from tests.laws.test_prints import FEW
from tests.reading.test_reading import roles, verdicts
from tests.sample import sampled

pytestmark = pytest.mark.usefixtures("uncorrected")

SAID = ("with the constraint", "subject to the constraint", "The point stays on the surface")


@pytest.mark.slow
@FEW
def test_energy_is_constant_on_a_constraint(seed):
    chance = random.Random(seed)
    several = chance.random() < 0.5
    names = XYZ if several else XYZ[:2]
    f, printed = chance.choice(SURFACES if several else CURVES)
    if "=xy" in printed or printed.startswith("y="):
        printed = "y-x^2=0"
    U = chance.choice([2 * names[-1], x_squared(names), names[0] * names[1]])

    def paper(f):
        rows = ",".join(
            rf"m\ddot {n}={latex(-U.diff(n))}+\lambda\cdot({latex(f.diff(n))})" for n in names
        )
        squares = "+".join(rf"\dot {n}^2" for n in names)
        return (
            rf"The equations of motion are $${rows}$$ {chance.choice(SAID)} $${printed}.$$ "
            rf"Then $\frac m2({squares})+({latex(U)})$ and $\frac m2({squares})+({latex(U)})+x$ "
            r"are first integrals."
        )

    true, false = (v for tex, v in verdicts(paper(f)).items() if tex.startswith(r"\frac m2"))
    assert true.green and false == "refuted", paper(f)
    rough = verdicts(paper(f + 3 * names[0] * names[-1] + names[0]))
    assert not any(v.green for tex, v in rough.items() if tex.startswith(r"\frac m2")), paper(f)


HELD = (
    "A point moves at distance $l$ from the origin.", "A bead hangs on a rod of length $l$.",
    "A point moves so that $x^2+y^2=l^2$.", "A point moves.", "Let $l$ be the length.",
)  # fmt: skip


@pytest.mark.slow
@FEW
def test_what_may_be_a_multiplier_refutes_nothing(seed):
    """A body whose constraint is said in words that are not read."""
    chance = random.Random(seed)
    name = chance.choice([r"\lambda", r"\lambda_1"])
    if chance.random() < 0.5:
        rows = rf"\ddot x={name} x,\quad m\ddot y={name} y-mg"
        rows, energy = rows.replace(r"\ddot x", r"m\ddot x"), r"\frac m2(\dot x^2+\dot y^2)+mgy"
        spin = r"x\dot y+y\dot x"
    else:
        a = chance.choice(["a", "2"])
        rows = rf"A\dot p=(B-C)qr+{a}{name},\quad B\dot q=(C-A)rp+b{name},\quad C\dot r=(A-B)pq"
        energy, spin = "Ap^2+Bq^2+Cr^2", "p^2+q^2"
    law = rf"{chance.choice(HELD)} The equations of motion are $${rows}%s.$$ "
    claims = f"The functions ${energy}$ and ${spin}$ are first integrals."
    free = verdicts(law % "" + claims)
    assert free[energy] == free[spin] == "undecided", (rows, free)
    told = chance.choice(
        [
            f" where ${name}$ is a constant. ",
            f" with the parameter ${name}$. ",
            f" Let ${name}>0$. ",
        ]
    )
    known = verdicts(law % "" + told + claims)
    assert known[energy] == known[spin] == "refuted", (told, rows, known)


@pytest.mark.slow
def test_constraints_are_those_of_the_motion_in_other_coordinates():
    text = (
        r"The equations of motion are $$\ddot x=\lambda x,\quad \ddot y=\lambda y,\quad "
        r"\ddot z=-g-\lambda p$$ with the constraint $$x^2+y^2=2pz.$$ Let us put "
        r"$x=r\cos\varphi,\ y=r\sin\varphi$. Then $$r\ddot\varphi+2\dot r\dot\varphi=0,$$ and "
        r"$$\frac{p^2+r^2}{p^2}\ddot r%s\frac{r\dot r^2}{p^2}-r\dot\varphi^2+\frac gp r=0.$$ "
    )
    true, false = verdicts(text % "+"), verdicts(text % "-")
    assert len(true) == len(false) == 2 and all(v.green for v in true.values()), true
    assert [v.green for v in false.values()] == [True, False], false


def x_squared(names):
    return names[0] ** 2 - 3 * names[1] ** 2


def test_a_multiplier_without_a_constraint_is_no_constant():
    text = (
        r"The equations of motion are $$\ddot x=\lambda x,\quad \ddot y=\lambda y,$$ where "
        r"$\lambda$ is a multiplier. The energy integral is $$\dot x^2+\dot y^2=h .$$"
    )
    assert not verdicts(text)
    # Without these words it is a constant, and the equations are those of two oscillators.
    text = text.replace("a multiplier", "a constant")
    assert verdicts(text)[r"\dot x^2+\dot y^2=h"] == "refuted"


TODA = r"""The equations of motion are \begin{equation}\label{lax} %s \end{equation} where
$$L=\begin{pmatrix}b&a\\a&-b\end{pmatrix},\qquad B=\begin{pmatrix}0&a\\-a&0\end{pmatrix}.$$
Then $\operatorname{tr}L^2$ and $%s$ are first integrals."""


@pytest.mark.parametrize(
    "law", sampled([r"\dot L=[B,L]", r"\frac{dL}{dt}=BL-LB", r"\dot L=-[L,B]"], 1)
)
def test_the_entries_of_a_matrix_equation_move(law):
    true, false = verdicts(TODA % (law, "a^2+b^2")), verdicts(TODA % (law, "a^2-b^2"))
    assert [*true.values()] == ["proved", "proved"] and list(false.values())[1] == "refuted"
    assert roles(TODA % (law, "a^2+b^2"))[law] == "law"


def test_a_matrix_equation_that_no_rates_obey_is_not_read():
    text = TODA % (r"\dot L=[B,L]+B", "a^2+b^2")
    assert roles(text)[r"\dot L=[B,L]+B"] == "unread" and not verdicts(text)


def test_a_matrix_equation_for_what_moves_already_is_claimed():
    rates = r"The equations of motion are $$\dot a=-2ab,\qquad \dot b=%s .$$ They imply "
    text = TODA.replace("The equations of motion are", "") % (r"\dot L=[B,L],", "a^2+b^2")
    assert verdicts(rates % "2a^2" + text)[r"\dot L=[B,L]"] == "proved"
    assert verdicts(rates % "3a^2" + text)[r"\dot L=[B,L]"] == "refuted"


def test_a_spectral_parameter_stands_in_the_matrices_of_a_paper():
    lax = TODA.replace("&a", r"&a+\lambda").replace(r"\\a", r"\\a-\lambda").replace("L=", "L(s)=")
    lax = lax.replace("(s)", r"(\lambda)").replace("L^2", r"L(\lambda)^2")
    second = r"B=\begin{pmatrix}0&1\\-1&0\end{pmatrix}"
    text = lax.split("B=")[0] + second + lax.split(r"\end{pmatrix}")[-1]
    found = verdicts(text % (r"\dot L(\lambda)=[B,L(\lambda)]", "a^2+b^2"))
    assert [*found.values()] == ["proved", "proved"]
    found = verdicts(text % (r"\dot L(\lambda)=[B,L(\lambda)]", "a^2-b^2"))
    assert [*found.values()] == ["proved", "refuted"]


CANONICAL = r"""The Hamiltonian is $$H=\frac12(p_1^2+p_2^2)+%s,$$ where $V=%s$. The equations of motion are
$$\dot q_i=\partial_{p_i}H,\qquad \dot p_i=-\partial_{q_i}H .$$ The function $q_1p_2-q_2p_1$ is a first integral."""


@pytest.mark.parametrize("V", sampled(["V", "V(q_1,q_2)", r"V\left(q_1,q_2\right)"], 1))
def test_a_potential_has_its_arguments_beside_it(V):
    (true,) = verdicts(CANONICAL % (V, "(q_1^2+q_2^2)^2")).values()
    (false,) = verdicts(CANONICAL % (V, "(q_1^2+2q_2^2)^2")).values()
    assert true == "proved" and false == "refuted"


def test_a_potential_at_other_arguments_is_not_read():
    text = CANONICAL % ("V(q_1,q_2)+V(q_2,q_1)", "q_1^2+q_2")
    assert not verdicts(text)


CLOSED = r"""The variables have the Poisson bracket $$\{u_i,u_{i+1}\}=u_iu_{i+1},\quad u_{i+%d}=u_i,\quad i=1,\dots,%d,$$
and the Hamiltonian is $$H=\sum_{i=1}^{%d}u_i.$$ Then $\prod_{i=1}^{%d}u_i$ and $%s$ are first integrals."""


@pytest.mark.parametrize("size", [3, 5])
def test_a_chain_is_closed_in_its_brackets(size):
    true, false = verdicts(CLOSED % (*[size] * 4, "u_1u_2")).values()
    assert true == "proved" and false == "refuted"


BODY = r"""The equations of motion are
$$A{p}=(B-C)qr+z\gamma',\quad B{q}=(C-A)rp-z\gamma,\quad C{r}=(A-B)pq,$$
$$%s=r\gamma'-q\gamma'',\quad %s=p\gamma''-r\gamma,\quad %s=q\gamma-p\gamma'.$$
Then $\gamma^2+\gamma'^2+\gamma''^2$ and $Ap\gamma+Bq\gamma'%sCr\gamma''$ are first integrals."""


@pytest.mark.parametrize("rate", sampled([r"\dot{%s}", r"\frac{d%s}{dt}"], 1))
def test_primes_make_names_where_their_rates_are_printed(rate):
    body = BODY
    for letter in "pqr":
        body = body.replace(f"{{{letter}}}", rate % letter)
    for sign, verdict in (("+", "conditional"), ("-", "refuted")):
        rates = (rate % rf"\gamma{primes}" for primes in ("", "'", "''"))
        length, area = verdicts(body % (*rates, sign)).values()
        assert length.green and area == verdict


@pytest.mark.parametrize("behind", sampled(["", "=dt"], 1))
def test_differentials_in_proportion_are_equations_of_motion(behind):
    text = (
        rf"The system $$\frac{{dx}}{{y}}=\frac{{dy}}{{-x}}=\frac{{dz}}{{1}}{behind}$$ "
        r"has the first integrals $x^2+y^2$ and $x^2-y^2$."
    )
    found = verdicts(text)
    assert [*found.values()] == ["proved", "refuted"]
    assert "law" in roles(text).values()


def test_what_an_index_derives_moves_by_it():
    text = r"Travelling waves obey the equation of motion $$u_{xxx}+6uu_x-cu_x=0.$$ Then $%s$ is constant."
    assert [*verdicts(text % "u_{xx}+3u^2-cu").values()] == ["proved"]
    assert [*verdicts(text % "u_{xx}+2u^2-cu").values()] == ["refuted"]


def test_a_bracket_of_three_letters_and_a_hamiltonian_are_a_law():
    text = (
        r"The Poisson brackets are $$\{M_1,M_2\}=M_3,\quad \{M_2,M_3\}=M_1,\quad \{M_3,M_1\}=M_2,$$ "
        r"and the Hamiltonian is $$H=\frac12(aM_1^2+bM_2^2+cM_3^2).$$ "
        r"Then $M_1^2+M_2^2+M_3^2$ and $M_1^2+M_2^2$ are first integrals."
    )
    true, false = verdicts(text).values()
    assert true == "proved" and not false.green


@pytest.mark.slow
def test_of_which_function_the_rate_vanishes_may_be_said_behind():
    law = r"The equations of motion are $$\dot x=y,\qquad \dot y=-ax .$$ "
    text = law + r"Then $\dot F=0$ for $F=ax^2+%sy^2$."
    assert verdicts(text % "")[r"\dot F=0"] == "proved"
    assert verdicts(text % "2")[r"\dot F=0"] == "refuted"
    # A constant of the law is none of these.
    special = law + r"Then $\frac{d}{dt}(x^2+y^2)=0$ for $a=1$."
    assert [*verdicts(special).values()] == ["proved"]
    assert roles(special)["a=1"] == "assumption"
    # What is supposed for another claim of the sentence proves nothing of this one.
    other = law + r"Then $\frac{d}{dt}(x^2+y^2)=0$ holds, and for $a=1$ we have $\dot y=-x$."
    assert [*verdicts(other).values()] == ["undecided", "proved"]
