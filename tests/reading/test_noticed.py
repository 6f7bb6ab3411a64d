"""What a reading must not miss: misprints in formulas that words, and nothing else, call claims."""

import pytest

from kowalevski_cas.audit.reading import ReadingSession
from kowalevski_cas.reading import ASSUMPTION, CLAIM, DEFINITION, LAW
from kowalevski_cas.verify.blame import Blame
from kowalevski_cas.verify.outcome import Verdict
from tests.sample import sampled

from .test_reading import reading, roles, verdicts

CENTRAL = r"""
\section{Plane} The equations of motion are
\begin{equation}\label{law}
\ddot r=r\dot\varphi^2-\frac{k}{r^2},\qquad \ddot\varphi=-\frac{2\dot r\dot\varphi}{r}\qquad(r>0).
\end{equation}
"""


def test_a_condition_in_brackets_behind_a_law_is_an_assumption():
    found = roles(CENTRAL)
    assert [*found.values()] == [LAW, LAW, ASSUMPTION]


@pytest.mark.parametrize(("right", "verdict"), sampled([("c", "green"), ("2c", "refuted")], 1))
def test_what_a_rate_of_coordinates_defines_is_known_along_the_motion(right, verdict):
    text = (
        CENTRAL
        + rf"""Let $x=r\cos\varphi$, $y=r\sin\varphi$ and $c=x\dot y-y\dot x$. We find
    \[ r^2\dot\varphi={right} . \]"""
    )
    found = verdicts(text)[rf"r^2\dot\varphi={right}"]
    assert (found.green and verdict == "green") or found == verdict


@pytest.mark.parametrize(
    "words",
    [
        "remains an integral if $k$ is a given function of the time.",
        "is also an integral when $k$ depends on time.",
    ],
)
def test_what_is_said_of_a_law_that_is_not_printed_is_not_judged(words):
    found = reading(CENTRAL + rf"Put $F=r^2\dot\varphi$. The function $F$ {words}")
    last = [f for f in found.formulas if f.item.printed.tex.strip() == "F"][-1]
    assert last.role.name == CLAIM and last.claim is None


def test_the_same_words_without_a_condition_are_judged():
    found = verdicts(CENTRAL + r"Put $F=r^2\dot\varphi$. The function $F$ is an integral.")
    assert found["F"] in (Verdict.PROVED, Verdict.CONDITIONAL)


VOLTERRA = r"""
Four populations feed on each other,
\[ \dot u_1=u_1u_2,\quad \dot u_2=u_2(u_3-u_1),\quad \dot u_3=u_3(u_4-u_2),\quad \dot u_4=-u_4u_3 . \]
"""
WRONG = r"I=u_1u_3+u_2u_3+u_2u_4"


@pytest.mark.parametrize(
    "words",
    sampled(
        [
            rf"The sum $S=u_1+u_2+u_3+u_4$ is an integral, and there is one more: \[ {WRONG} . \]",
            rf"There has to be an integral besides the sum. It is of the second degree: \[ {WRONG} . \]",
            rf"One integral is the sum. A second one is known as well. It reads \[ {WRONG} . \]",
            rf"The motion separates with the constant \[ {WRONG} . \]",
            rf"Сумма есть интеграл. Имеется ещё один. Он имеет вид \[ {WRONG} . \]",
        ],
        1,
    ),
)
def test_an_integral_is_claimed_by_the_words_that_announce_it(words):
    assert verdicts(VOLTERRA + words)[WRONG] in (Verdict.REFUTED, Verdict.UNDECIDED)


@pytest.mark.parametrize(
    "words",
    [
        rf"The sum is an integral. It is easy to see what is measured by \[ {WRONG} . \]",
        rf"No function of the second degree is an integral. It reads \[ {WRONG} . \]",
        rf"The sum is an integral. We put \[ {WRONG} . \]",
        rf"With $c=1$, and with the constant \[ {WRONG} , \] we go on.",
    ],
)
def test_other_words_announce_no_integral(words):
    assert roles(VOLTERRA + words)[WRONG] == DEFINITION


def test_a_tensor_and_a_moment_may_both_be_bold_capitals():
    text = r"""The body turns by
    \[ \mathbf J\dot{\boldsymbol\omega}=\mathbf J\boldsymbol\omega\times\boldsymbol\omega,\qquad
    \mathbf J=\mathop{\rm diag}(A,B,C) . \]
    Let $\boldsymbol K=\mathbf J\boldsymbol\omega$. Then
    $\dot{\boldsymbol K}=\boldsymbol K\times\boldsymbol\omega$."""
    assert {f.role.name for f in reading(text).formulas} == {LAW, DEFINITION, CLAIM}


@pytest.mark.parametrize(("sign", "green"), [("+", True), ("-", False)])
def test_the_rates_of_a_potential_with_logarithms_are_known(sign, green):
    text = rf"""The motion in the plane is given by
    \[ \ddot x_i=-\frac{{\partial U}}{{\partial x_i}},\qquad U=k\ln(x_1^2+x_2^2) , \]
    $i=1,2$. Therefore \[ \ddot x_1{sign}\frac{{2kx_1}}{{x_1^2+x_2^2}}=0 . \]"""
    found = verdicts(text)[rf"\ddot x_1{sign}\frac{{2kx_1}}{{x_1^2+x_2^2}}=0"]
    assert found.green is green


def test_a_range_of_an_index_that_the_text_gives_holds_from_its_sentence_on():
    text = r"""The points with the coordinates $x_i$, $i=1,2$, move by
    \[ \dot x_i=v_i,\qquad \dot v_i=-kx_i . \] The functions $v_i^2+kx_i^2$ are integrals."""
    found = reading(text).formulas
    assert [f.role.name for f in found].count(LAW) == 4
    assert [f.role.name for f in found].count(CLAIM) == 2


def test_a_polynomial_is_a_function_where_nothing_is_derived_by_its_argument():
    text = r"""\[ \dot u=v,\qquad \dot v=u . \] Let \[ R(x)=x^2+h, \] where $R$ is a polynomial, and
    $h=v^2-u^2$. Then \[ \dot u^2=R(u) . \]"""
    assert verdicts(text)[r"\dot u^2=R(u)"] is Verdict.PROVED


@pytest.mark.parametrize(
    "words",
    [
        r"In a report it was written that $\dot u_1=0$ ``holds''; \textbf{this is wrong}.",
        r"Somebody takes $\dot u_1=0$ for granted, which is false.",
        r"Было написано, что $\dot u_1=0$.",
        r"One might hope that $\dot u_1=0$.",
        r"The first is said to have $\dot u_1=0$, but it does not.",
        r"Можно было бы ожидать, что $\dot u_1=0$.",
        r"Here $\dot u_1=0$ along no motion.",
    ],
)
def test_what_was_written_by_others_or_is_wrong_is_not_claimed(words):
    assert roles(VOLTERRA + words)[r"\dot u_1=0"] == "other"


@pytest.mark.parametrize(
    ("words", "green"),
    [
        (r"Then $F=u_1+u_2+u_3+u_4$ is conserved.", True),
        (r"Hence $F=u_1+u_2$ is a first integral.", False),
        (r"The sum $F=u_1+u_2+u_3+u_4$ is constant, but it is not positive.", True),
    ],
)
def test_what_follows_is_claimed_though_it_gives_a_name(words, green):
    assert [one.green for one in verdicts(VOLTERRA + words).values()] == [green]


@pytest.mark.parametrize("words", ["The potential energy is", "The kinetic energy has the form"])
def test_a_part_of_the_energy_is_not_called_an_integral(words):
    text = rf"The motion is given by \[ \ddot x=-x . \] {words} \[ T=\tfrac12\dot x^2 . \]"
    assert roles(text)[r"T=\tfrac12\dot x^2"] == "definition"
    whole = text.replace(words.split(" energy")[0], "The").replace("x^2 .", "x^2+\\tfrac12x^2 .")
    assert roles(whole)[r"T=\tfrac12\dot x^2+\tfrac12x^2"] == "claim"


@pytest.mark.parametrize(
    ("b", "green"), sampled([("1", True), (r"\frac32", False), ("-2", False)], 1)
)
def test_a_constant_that_is_not_zero_may_be_given_by_a_number(b, green):
    text = rf"""\[ \dot x=-sx+y,\qquad \dot y=-by . \] Let $b\ne0$ and $s\ne0$. If $b={b}$, the function
    $F=y^2$ has the rate $\dot F=-2F$."""
    found = verdicts(text)[r"\dot F=-2F"]
    assert found in (Verdict.PROVED,) if green else found in (Verdict.REFUTED, Verdict.UNDECIDED)


@pytest.mark.slow
def test_the_energy_that_a_law_derives_is_no_constant_before_it_is_given():
    """Else nothing would move, and everything were constant."""
    law = r"""The equations are \[ \dot q=\frac{\partial H}{\partial p},\qquad
    \dot p=-\frac{\partial H}{\partial q} \] with the energy $H$. """
    never = law + r"Then $q+p$ is a first integral."
    assert not verdicts(never)
    given = law + r"Let \[ H=\tfrac12p^2+\tfrac12q^2 . \] Then $q+p$ is a first integral."
    assert verdicts(given)["q+p"] in (Verdict.REFUTED, Verdict.UNDECIDED)


TWO = r"""
\section{Space} The motion is given by
\[ \dot x=y,\qquad \dot y=-kx . \]
\section{More} We put $G=x^2+y^2$. It has the rate $\dot G=0$. Another angle moves by
\[ \ddot\vartheta=-n\sin\vartheta . \]
"""


@pytest.mark.slow
def test_what_stands_before_another_law_in_its_section_is_said_of_the_law_before():
    assert verdicts(TWO)[r"\dot G=0"] in (Verdict.REFUTED, Verdict.UNDECIDED)


@pytest.mark.slow
def test_what_is_said_on_a_set_is_not_refuted_without_it():
    text = r"""The equations are \[ \dot x=y,\qquad \dot y=-x+\lambda x,\qquad \lambda=x^2-1 . \] The
    function $H=x^2+y^2$ is an integral of the system restricted to the sphere ${\cal M}$."""
    assert verdicts(text)["H=x^2+y^2"] is Verdict.UNDECIDED


def test_a_model_may_be_approximate():
    text = r"""In the first approximation, \[ \dot x=y,\qquad \dot y=-x . \] Then $\dot x^2+x^2$ is
    an integral. Neglecting small terms we find $\ddot x=-2x$."""
    found = {f.item.printed.tex: f.role for f in reading(text).formulas}
    assert found[r"\dot x^2+x^2"].kind == "integral"
    assert found[r"\ddot x=-2x"].kind == "approximate"


@pytest.mark.parametrize(("power", "green"), sampled([("2", True), ("3", False)], 1))
def test_brackets_and_rates_of_a_function_with_logarithms_are_known(power, green):
    text = rf"""\[ \{{x,y\}}=xy,\qquad \dot x=xy,\qquad \dot y=-xy . \] Put
    \[ K=\ln x+{power}\ln y . \] Then $\dot K=y-{power}x$, and $\{{K,xy^2\}}=0$."""
    found = verdicts(text)
    assert found[rf"\dot K=y-{power}x"].green
    assert found[r"\{K,xy^2\}=0"].green is green


@pytest.mark.parametrize(
    "claim",
    [
        r"Seen from another frame, $\dot x'=\dot x-v$ holds.",
        r"Let $y=2x$, as is usual. Then $\dot x=y$.",
    ],
)
def test_what_may_be_another_frame_or_is_supposed_is_not_refuted(claim):
    text = r"The equations are \[ \dot x=y,\qquad \dot y=-x,\qquad \dot v=x' . \] "
    assert Verdict.REFUTED not in verdicts(text + claim).values()


@pytest.mark.parametrize(("right", "green"), sampled([("k", True), ("2k", False)], 1))
def test_a_name_is_defined_in_the_display_that_uses_it_before(right, green):
    text = (
        CENTRAL
        + r"""Let $c=r^2\dot\varphi$. Then
    \[ \ddot r=\frac{c^2-er}{r^3},\qquad e=RIGHT . \]"""
    )
    found = verdicts(text.replace("RIGHT", right))
    assert found[r"\ddot r=\frac{c^2-er}{r^3}"].green is green


def test_a_length_may_stand_in_a_vector_of_which_the_length_is_used():
    text = r"""A particle moves by
    \[ \dot{\mathbf r}=\mathbf p,\quad \dot{\mathbf p}=-\frac{\mathbf r}{r^3} . \]
    Let \[ \mathbf A=\mathbf p+\frac{\mathbf r}{r} . \] Then \[ r+A^2=r+\mathbf A^2 . \]"""
    assert verdicts(text)[r"r+A^2=r+\mathbf A^2"].green


@pytest.mark.parametrize(
    "law", [r"x\dot x=y\dot y,\qquad x\dot x=2y\dot y", r"\dot x\sin\theta=\pm\dot y\cos\theta"]
)
def test_by_equations_by_which_nothing_moves_nothing_is_true(law):
    found = verdicts(rf"The equations are \[{law}.\] Then $\dot x\dot y=x^2\dot x+y\dot y$.")
    assert not any(verdict.green for verdict in found.values())


def test_what_stands_still_by_what_is_printed_may_be_claimed():
    found = verdicts(r"The equations are \[\dot x=0,\qquad\dot y=0.\] Then $x\dot x=y\dot y$.")
    assert found[r"x\dot x=y\dot y"] == Verdict.PROVED


def test_a_lost_name_explains_itself_and_nothing_else_is_blamed(monkeypatch):
    monkeypatch.setattr(Blame, "_search", lambda *_, **__: pytest.fail("something else is blamed"))
    text = r"""\[ \dot x=y,\qquad \dot y=-x . \] Put $u=x^2$ and $z=y^2$. Then
    \[ \dot u=2xw,\qquad \dot z=-2xw . \]"""
    outcomes = ReadingSession(reading(text)).outcomes.values()
    assert [o.verdict for o in outcomes] == [Verdict.REFUTED] * 2
    assert all("w" not in o.correction.formulas[0].names() for o in outcomes)


def test_what_no_other_name_mends_is_not_explained_by_a_lost_one():
    text = r"""\[ \dot x=y,\qquad \dot y=x . \] Put $u=x+y$ and $v=x-y$. Then
    \[ \dot u=kv,\qquad \dot v=-ku . \]"""
    session = ReadingSession(reading(text))
    assert not any(o.verdict.green for o in session.outcomes.values())


def test_where_a_square_is_not_defined_nothing_is_false_by_it():
    found = verdicts(r"""The equations of motion are
    \[ \dot x=yz-x(y+z)+\tau^2,\quad \dot y=zx-y(z+x)+\tau^2,\quad \dot z=xy-z(x+y)+\tau^2, \]
    \[ \tau^2=(x-y)(z-x)+(y-z)(x-y). \]
    The point $x=y=z=0$ is an equilibrium.""")
    assert found.get("x=y=z=0", "undecided") == "undecided"


ANSATZ = r"""
The equation of motion is \[ \dot w=-\alpha w+e^{-\beta t} . \]
We try a particular solution $w_1=Ge^{-\beta t}$. It yields
\begin{align} \alpha G-\beta G&=1, \\ G&=%s . \end{align}
"""


@pytest.mark.parametrize(
    ("constant", "green"),
    sampled(
        [
            (r"\frac{1}{\alpha-\beta}", True),
            (r"\frac{1}{\alpha+\beta}", False),
            (r"\frac{1}{\beta-\alpha}", False),
            (r"\frac{2}{\alpha-\beta}", False),
            (r"\frac{\beta}{\alpha-\beta}", False),
        ],
        2,
    ),
)
def test_what_the_constant_of_an_ansatz_has_to_be_is_said_by_a_display(constant, green):
    found = reading(ANSATZ % constant)
    assert [f.role.name for f in found.formulas if f.item.bare[:1] == ("G",)] == [DEFINITION]
    verdict = verdicts(ANSATZ % constant)[r"\alpha G-\beta G&=1"]
    assert verdict.green == green


def test_a_rate_that_a_control_gives_as_well_refutes_nothing():
    text = r"""\section{Control} The mass obeys $\ddot z=f$, and the cost is \[ c=z^2+\dot z^2+f^2 . \] The best control is
    \[ f=\phi(z,\dot z)=-z-\sqrt3\dot z . \]
    Then \[ S=\sqrt3z^2+2z\dot z+\sqrt3\dot z^2,\qquad \frac{dS}{dt}=-c . \]"""
    assert Verdict.REFUTED not in verdicts(text).values()
