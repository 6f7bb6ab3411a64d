"""Several systems in one paper: each part of it has a law, and letters of its own."""

import pytest

from kowalevski_cas.reading import CLAIM, DEFINITION, LAW
from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import reading, roles, verdicts
from tests.sample import sampled

SPRING = r"\section{A spring} The motion is $$\ddot x=-k^2x.$$ "
LORENZ = r"\section{A flow} Three amplitudes obey $$\dot x=s(y-x),\quad \dot y=-y-xz,\quad \dot z=xy-2sz.$$ "


def test_each_section_has_letters_of_its_own():
    """What is defined in one section is no constant, and no definition, in the next."""
    first = SPRING + r"Put $s=\dot x^2$ and $z=x^2$. Then \[\dot s=-2k^2x\dot x.\]"
    found = verdicts(first + LORENZ + r"Put $F=x^2-2sz$. Then \[\dot F=-2sF.\]")
    assert found == {r"\dot s=-2k^2x\dot x": Verdict.PROVED, r"\dot F=-2sF": Verdict.PROVED}


def test_a_name_may_stand_for_something_else_in_the_next_section():
    first = SPRING + r"The energy $$h=\dot x^2+k^2x^2$$ is an integral. "
    second = r"\section{A fall} The motion is $$\ddot x=-g.$$ The energy $$h=\dot x^2+2gx$$ is an integral."
    found = reading(first + second)
    assert [f.role.name for f in found.formulas].count(CLAIM) == 2
    assert {*verdicts(first + second).values()} == {Verdict.PROVED}


def test_what_one_part_takes_from_another_is_cited():
    first = r"\section{One} The motion is $$\dot x=y,\quad \dot y=-x.$$ Put \begin{equation}\label{F}F=x^2+y^2.\end{equation} "
    second = r"\section{Two} The motion is $$\dot x=xy^2,\quad \dot y=-x^2y.$$ "
    cited = r"For the function (\ref{F}) we have $$\dot F=0.$$"
    assert verdicts(first + second + cited) == {r"\dot F=0": Verdict.PROVED}
    false = second.replace("-x^2y", "x^2y") + r"We have $$\dot F=0.$$"
    assert Verdict.REFUTED not in verdicts(first + false).values()


@pytest.mark.slow
def test_a_claim_may_cite_the_law_of_another_part():
    first = r"\section{One} The motion is \begin{equation}\label{one}\dot x=y,\quad \dot y=-x.\end{equation}"
    second = r"\section{Two} The motion is $$\dot x=y,\quad \dot y=x.$$ "
    both = r"But $x^2+y^2$ is an integral of (\ref{one}), and $x^2-y^2$ is constant."
    found = verdicts(first + second + both)
    assert found["x^2+y^2"] is Verdict.PROVED


@pytest.mark.parametrize(
    "words", ["Hence we have", "Substituting, we find", "Отсюда имеем", "In view of this"]
)
def test_rates_that_follow_set_up_no_system(words):
    """A misprint in what is derived from the law is refuted, and sets up no law where it holds."""
    first = r"\section{One} The motion is \begin{equation}\label{1}\dot x=y,\quad \dot y=-x.\end{equation}"
    cited = r" by (\ref{1})" if words.startswith("In view") else ""
    found = reading(first + rf"\section{{Two}} {words}{cited} $$\dot x=y,\quad \dot y=2x.$$")
    assert [formula.role.name for formula in found.formulas] == [LAW, LAW, CLAIM, CLAIM]


def test_another_system_may_stand_in_the_same_section():
    first = (
        r"\section{One} The motion is $$\dot x=y,\quad \dot y=-x.$$ Then $x^2+y^2$ is constant. "
    )
    second = (
        r"Now consider another system, $$\dot x=y,\quad \dot y=x.$$ Then $x^2-y^2$ is constant."
    )
    found = verdicts(first + second)
    assert found == {"x^2+y^2": Verdict.PROVED, "x^2-y^2": Verdict.PROVED}


def test_rates_of_what_is_defined_are_claimed_in_another_section_too():
    first = r"\section{One} The motion is $$\dot x=xy,\quad \dot y=-x^2.$$ Put $u=x^2$, $v=2y$. "
    second = r"\section{Two} The system in these is $$\dot u=uv,\quad \dot v=-2u.$$"
    assert {*verdicts(first + second).values()} == {Verdict.PROVED}
    false = verdicts(first + second.replace("2u", "3u"))
    assert not false[r"\dot v=-3u"].green


def test_rates_that_are_names_of_expressions_are_no_law():
    text = r"\section{A} We have $$\ddot r=r\dot\varphi^2-\frac1{r^3},\quad \ddot\varphi=-\frac{2\dot r\dot\varphi}r.$$ "
    found = roles(text + r"The area integral is $$c=r^2\dot\varphi.$$")
    assert [*found.values()] == [LAW, LAW, CLAIM]
    hamilton = r"\section{A} The equations are $$p=m\dot q,\quad \dot p=-kq.$$"
    assert [*roles(hamilton).values()] == [LAW, LAW]


@pytest.mark.parametrize("word", ["mapping", "map", "отображение"])
def test_primes_of_a_map_are_images_and_no_rates(word):
    first = r"\section{A} The motion is $$\dot x=y,\quad \dot y=-x.$$ "
    second = rf"\section{{B}} A {word} of the plane is given by $$x'=y,\quad y'=-x.$$"
    assert [*roles(first + second).values()] == [LAW] * 4
    assert Verdict.REFUTED not in verdicts(first + second).values()


def test_a_letter_is_the_time_only_where_something_is_derived_by_it():
    first = r"\section{A} The motion is $$\dot x=-x.$$ With the new time $s=2t$ we have $$\frac{dx}{ds}=-\frac12x.$$ "
    second = (
        r"\section{B} The motion is $$\dot q=p,\quad \dot p=-q.$$ Put $s=q-p$. Then $$\dot s=p+q.$$"
    )
    assert roles(first + second)["s=q-p"] == DEFINITION
    assert verdicts(first + second)[r"\dot s=p+q"] is Verdict.PROVED


@pytest.mark.slow
def test_e_is_a_number_where_it_is_only_raised():
    text = r"\section{A} The motion is $$\ddot q=-e^q.$$ The energy $$H=\dot q^2+2e^q$$ is an integral."
    assert verdicts(text) == {r"H=\dot q^2+2e^q": Verdict.PROVED}
    charge = r"\section{A} The motion is $$\ddot q=-eEq.$$ The energy $$H=\dot q^2+eEq^2$$ is an integral."
    assert {*verdicts(charge).values()} == {Verdict.PROVED}


def test_a_name_in_a_law_may_be_defined_in_its_sentence():
    law = r"\section{A} The equations are $$\ddot x=-\frac{x}{\rho^3},\quad \ddot y=-\frac{y}{\rho^3},\quad \rho^2=x^2+y^2.$$ "
    found = verdicts(law + r"The integral is $$h=\dot x^2+\dot y^2-\frac2\rho.$$")
    assert {*found.values()} <= {Verdict.PROVED, Verdict.CONDITIONAL} and found


@pytest.mark.parametrize(
    "words",
    sampled(
        [
            r"On the plane $x=y$ one finds",
            r"Near the origin",
            r"In the second case we have",
            r"В этом случае имеем",
        ],
        1,
    ),
)
def test_what_is_said_of_a_place_or_a_case_is_not_red(words):
    first = r"\section{A} The motion is $$\dot x=y^2,\quad \dot y=yx.$$ "
    assert Verdict.REFUTED not in verdicts(first + words + r" $\dot x=x^2$.").values()
    assert Verdict.REFUTED in verdicts(first + r"Hence $\dot x=x^2$.").values()


@pytest.mark.slow
def test_what_is_given_by_no_definition_that_was_read_is_no_constant():
    """Two equations give u and v together; nobody solves them for one."""
    first = r"\section{A} The motion is $$\dot x=y,\quad \dot y=-x.$$ "
    pair = r"We introduce $$x=u+v,\quad y^2=uv.$$ Then $$\frac{d(uv)}{dt}=-2xy.$$"
    assert Verdict.REFUTED not in verdicts(first + pair).values()


@pytest.mark.slow
def test_a_case_that_a_definition_names_is_not_left_aside_for_a_red():
    first = r"\newtheorem{defn}{Definition}\section{Case of Li} The motion is $$\dot x=ay,\quad \dot y=-bx.$$ "
    case = r"\begin{defn}The case of Li is that in which \[a=b.\]\end{defn} "
    claimed = r"\begin{theorem}In the case of Li $x^2+y^2$ is constant.\end{theorem}"
    assert Verdict.REFUTED not in verdicts(first + case + claimed).values()
    assert Verdict.REFUTED in verdicts(first + claimed.replace("In the case of Li", "")).values()


@pytest.mark.slow
def test_an_integral_is_refuted_under_what_its_theorem_supposes():
    text = r"\section{A} The motion is $$\dot x=ay+c,\quad \dot y=-bx.$$ "
    case = text + r"\begin{theorem}Let $a=b$ and $c=0$. Then $x^2+2y^2$ is constant.\end{theorem}"
    assert {*verdicts(case).values()} == {Verdict.REFUTED}
    assert {*verdicts(case.replace("2y^2", "y^2")).values()} == {Verdict.PROVED}


def test_what_moves_beside_a_law_is_claimed_with_it():
    text = (
        r"The motion is $$\ddot x+k^2x=\frac{a}{x^3}.$$ It is solved by means of $$\ddot y+k^2y=0.$$ "
        r"Put $W=x\dot y-y\dot x$. Then \[\dot W=-\frac{ay}{x^3}.\]"
    )
    assert roles(text)[r"\ddot y+k^2y=0"] == LAW
    assert all(verdict.green for verdict in verdicts(text).values())


@pytest.mark.parametrize(
    ("rate", "green"), [(r"k(N-S-I)", True), (r"-k(N-S-I)", False), ("0", False)]
)
@pytest.mark.parametrize("words", ["With births and deaths we have", "The equations become"])
def test_rates_with_new_constants_are_another_law(words, rate, green):
    text = rf"""\section{{Closed}} The model is \[ \dot S=-bSI,\qquad\dot I=bSI. \] Thus $S+I=N$ is
    constant. \section{{Open}} {words} \[ \dot S=kN-bSI-kS,\qquad\dot I=bSI-kI. \]
    The sum satisfies \[ \frac{{d}}{{dt}}(S+I)={rate}. \]"""
    found = verdicts(text)
    assert [one.green for tex, one in found.items() if "dt" in tex] == [green]
    assert not any("dot" in tex for tex in found)


@pytest.mark.parametrize(("rate", "green"), [("-ky^2", True), ("ky^2", False), ("0", False)])
def test_what_an_earlier_part_defines_is_that_where_friction_is_added(rate, green):
    text = rf"""\section{{Free}} Consider \[ \dot x=y,\qquad\dot y=-x. \] Put $E=\frac12(x^2+y^2)$.
    \section{{Damped}} With friction the equations are \[ \dot x=y,\qquad\dot y=-x-ky. \]
    Hence \[ \dot E={rate}. \]"""
    assert [one.green for tex, one in verdicts(text).items() if "E" in tex] == [green]


@pytest.mark.parametrize("energy", [r"\frac12\dot u^2-\cos u", r"\frac12\dot u^2+\frac12u^2"])
@pytest.mark.parametrize(
    "whose", ["Its energy", "The energy of the linear equation", "This equation has the energy"]
)
def test_what_is_said_of_an_approximate_equation_is_not_judged_by_the_exact_one(whose, energy):
    text = rf"""\section{{Pendulum}} The pendulum moves by \[ \ddot u=-\sin u. \]
    \section{{Small}} Replacing $\sin u$ by $u$ we obtain the linear equation $\ddot u=-u$.
    {whose} ${energy}$ is constant."""
    assert not any(one.green for tex, one in verdicts(text).items() if "frac" in tex)


POLE = r"""With $\bm r=(x,y,z)$, $r=|\bm r|$ and $\bm v=\dot{\bm r}$ let \[\ddot{\bm r}=\frac k{r^3}\,\bm v\times\bm r .\]
The speed $|\bm v|$ is constant. We add a Coulomb force:
\begin{equation}\label{two} \ddot{\bm r}=\frac k{r^3}\,\bm v\times\bm r-\frac{a\bm r}{r^3} .\end{equation} """


@pytest.mark.parametrize(("power", "green"), [("r", True), ("r^2", False)])
def test_what_moves_keeps_its_other_names_where_a_force_is_added(power, green):
    claim = rf"For \eqref{{two}} the energy $E=\frac12\bm v^2-\frac a{{{power}}}$ is conserved."
    *_, last = verdicts(POLE + claim).values()
    assert last.green is green


def test_a_law_among_words_is_followed_by_one_with_another_force():
    text = r"""A body moves by $\ddot x=-x$. The energy $E=\frac12\dot x^2+\frac12x^2$ is conserved. Now add a cubic
    force: \[ \ddot x=-x-x^3 .\] For it the function $W=\frac12\dot x^2+\frac12x^2+\frac14x^4$ is conserved."""
    assert [one.green for one in verdicts(text).values()] == [True, True]
    first, second = verdicts(
        text.replace("+\\frac14x^4", "+\\frac12x^4").replace("E=\\frac12", "E=")
    ).values()
    assert not first.green and not second.green


OSCILLATOR = r"""\begin{example} Let $H=\frac12p^2+\frac k2q^2$. Then \[ \dot q=p,\qquad\dot p=-kq . \]
\end{example} """
EXAMPLES = [
    (r"In polar coordinates \[ H=\frac12\left(p_r^2+\frac{p_\varphi^2}{r^2}\right)-\frac\mu r . \] "
     r"Then \[ \dot p_r=\frac{p_\varphi^2}{VALUE}-\frac\mu{r^2} . \]", "r^3", "r^2"),
    (r"Now let \[ H=\frac12p^2+\frac k4q^4 . \] Then \[ \dot p=-VALUE . \]", "kq^3", "kq"),
    (r"Here \[ H=\frac12(p_1^2+p_2^2)+q_1q_2 , \] and the function $p_1p_2+VALUE$ is an integral.",
     r"\frac12(q_1^2+q_2^2)", "q_1q_2"),
    (r"Пусть теперь \[ H=\frac12p^2-\cos q . \] Тогда \[ \ddot q=VALUE . \]", r"-\sin q", r"\cos q"),
]  # fmt: skip


@pytest.mark.parametrize("words, true, false", EXAMPLES)
def test_an_example_with_a_hamiltonian_of_its_own_is_another_system(words, true, false):
    for value, green in ((true, True), (false, False)):
        text = rf"{OSCILLATOR}\begin{{example}} {words.replace('VALUE', value)} \end{{example}}"
        text += r" In the first example $p^2+kq^2$ is an integral."
        *own, last = verdicts(text).values()
        assert [one.green for one in own] == [green]
        assert last.green


@pytest.mark.parametrize(
    "text",
    [
        r"""Let $H=\frac12p^2+\frac k2q^2$. Then \[ \dot q=p,\qquad\dot p=-kq . \] \begin{example} For
        $k=4$ \[ H=\frac12p^2+2q^2 . \] Then $\dot p=-4q$. \end{example}""",
        OSCILLATOR
        + r"\begin{example} With friction \[ H=\frac12p^2+q^4,\quad\dot p=-4q^3-p . \] \end{example}",
    ],
)
def test_it_is_none_where_the_letters_go_on_or_more_acts(text):
    assert len(reading(text).parts.known) == 1


@pytest.mark.parametrize(("rate", "green"), [("-P^2", True), ("-Q^2", False)])
def test_its_own_equations_are_the_law_where_they_are_printed(rate, green):
    text = rf"""{OSCILLATOR}\begin{{example}} Let \[ H=\frac12P^2+\frac14Q^4 . \] Then
    \[ \dot Q=P,\qquad\dot P=-Q^3-P . \] We have $\dot H={rate}$. \end{{example}}"""
    assert [one.green for one in verdicts(text).values()] == [green]


@pytest.mark.parametrize(("sign", "true"), [("-", True), ("+", False)])
def test_what_is_named_anew_in_another_part_is_known_there(sign, true):
    named = r"With $\zeta=x+iy$ we have "
    first = (
        r"\section{Gyration} The motion is $$\ddot x=\omega\dot y,\quad\ddot y=-\omega\dot x.$$ "
    )
    second = r"\section{A trap} The motion is $$\ddot x=\omega\dot y+k^2x,\quad\ddot y=-\omega\dot x+k^2y,\quad\ddot z=-2k^2z.$$ "
    found = verdicts(
        first + named + r"$$\ddot\zeta+i\omega\dot\zeta=0.$$" + second + named
        + rf"$$\ddot\zeta+i\omega\dot\zeta{sign}k^2\zeta=0.$$"
    )  # fmt: skip
    assert [one.green for one in found.values()] == [True, true]
