"""What a reading makes of short papers: laws, roles with their reasons, hypotheses, doubts."""

import pytest

from kowalevski_cas.audit.assumed import assumptions_of, unchecked
from kowalevski_cas.audit.audited import OPEN
from kowalevski_cas.audit.reading import ReadingSession, audit_reading
from kowalevski_cas.notation import Derivative
from kowalevski_cas.reading import ASSUMPTION, CLAIM, DEFINITION, LAW, read
from kowalevski_cas.source.files import decode
from kowalevski_cas.verify.outcome import Verdict
from tests.sample import sampled

TOP = r"""
\section{A body} The equations of motion are
\begin{equation}\label{euler}
\dot p=a\,qr,\qquad \dot q=b\,rp,\qquad \dot r=c\,pq .
\end{equation}
"""


def reading(text):
    return read(decode("paper.tex", (r"\begin{document}" + text + r"\end{document}").encode()))


def roles(text):
    return {f.item.printed.tex.strip(): f.role.name for f in reading(text).formulas}


def verdicts(text):
    found = reading(text)
    outcomes = ReadingSession(found, timeout=20).outcomes
    return {
        f.item.printed.tex.strip(" .,"): outcomes[f.claim.id].verdict
        for f in found.formulas
        if f.claim is not None
    }


def test_a_law_is_a_closed_set_of_rates_and_what_comes_later_is_claimed():
    found = roles(TOP + r"Put $F=bp^2-aq^2$. Then $\dot F=0$ and $\dot p\dot q=ab\,pqr^2$.")
    assert list(found.values()).count(LAW) == 3
    assert found["F=bp^2-aq^2"] == DEFINITION
    assert found[r"\dot F=0"] == found[r"\dot p\dot q=ab\,pqr^2"] == CLAIM


@pytest.mark.slow
def test_rates_are_proved_and_a_false_one_of_a_closed_law_is_refuted():
    true = TOP + r"Put $F=bp^2-aq^2$. Then $\dot F=0$."
    false = TOP + r"Put $F=bp^2-aq^2+r$. Then $\dot F=0$."
    assert verdicts(true)[r"\dot F=0"] is Verdict.PROVED
    assert verdicts(false)[r"\dot F=0"] is Verdict.REFUTED


def test_a_definition_that_is_not_fresh_is_a_claim():
    found = roles(TOP + r"Put $F=p+q$. From this it follows that $F=q+p$.")
    assert found["F=q+p"] == CLAIM


@pytest.mark.parametrize(
    "words",
    [
        r"It is not true that $\dot p=0$.",
        r"Some write by mistake $\dot p=0$.",
        r"Is it possible that $\dot p=0$?",
        r"Неверно, что $\dot p=0$.",
    ],
)
def test_what_is_denied_or_asked_is_not_claimed_as_printed(words):
    assert roles(TOP + words)[r"\dot p=0"] != CLAIM


@pytest.mark.parametrize("words", sampled(["Suppose that", "Let", "Пусть"], 1))
def test_what_is_supposed_holds_to_the_end_of_its_section(words):
    text = rf"{TOP}{words} $a=-b$. Then $p^2+q^2$ is constant."
    assert roles(text)["a=-b"] == ASSUMPTION
    assert verdicts(text)["p^2+q^2"] is Verdict.PROVED
    later = rf"{TOP}{words} $a=-b$. \section{{Again}} Then $p^2+q^2$ is constant."
    assert not verdicts(later)["p^2+q^2"].green


@pytest.mark.slow
def test_what_nobody_cites_is_no_hypothesis():
    text = TOP + r"Consider the set $p=0$. \section{Else} We have the identity \[q\dot q=pr .\]"
    assert not any(verdict.green for verdict in verdicts(text).values())


def test_what_fails_and_may_have_been_meant_otherwise_is_undecided():
    found = verdicts(TOP + r"At some moment $p+q=5$.")
    assert Verdict.REFUTED not in found.values()


def test_every_statement_has_a_role_with_its_reason_and_the_counts_add_up():
    found = reading(TOP + r"Let $F=p$, $x$, $2p+$, and $p>0$ for \[G=\ldots\] of $a$.")
    assert all(formula.role.name and formula.role.reason for formula in found.formulas)
    audit = audit_reading(ReadingSession(found, timeout=20))
    assert sum(audit.counts.values()) == len(audit.formulas)


def test_names_that_nothing_explains_stand_among_what_is_assumed():
    text = TOP + r"The integral is \[bp^2-aq^2+\mu=h .\]"
    found = audit_reading(ReadingSession(reading(text), timeout=20))
    assert any("mu" in one.words and one.claims for one in assumptions_of(found))


def test_definitions_on_which_no_verdict_rests_are_told():
    text = TOP + r"Put $F=bp^2-aq^2$ and $G=2q$. Then $\dot F=0$."
    found = audit_reading(ReadingSession(reading(text), timeout=20))
    assert [formula.tex for formula in unchecked(found)] == ["G=2q"]


def test_what_holds_to_first_order_is_not_judged():
    found = audit_reading(
        ReadingSession(
            reading(TOP + r"To first order in small $q$ we have \[\dot r=0 .\]"), timeout=20
        )
    )
    assert OPEN in found.counts and Verdict.REFUTED not in found.counts


def test_an_abstract_is_read_last():
    text = r"\begin{abstract}The function $F$ with $\dot F=0$ is an integral.\end{abstract}"
    found = verdicts(f"{text}{TOP}" + r"Put \[F=bp^2-aq^2 .\]")
    assert found[r"\dot F=0"] is Verdict.PROVED


def test_a_bibliography_holds_no_formulas():
    text = TOP + r"\begin{thebibliography}{9}\bibitem{a} On $H=5$.\end{thebibliography}"
    assert "H=5" not in roles(text)


CHARGE = r"""
\section{A charge} It moves by
\begin{align}
m\ddot x &= b\dot y-kx,\label{first}\\
m\ddot y &= -b\dot x-ky.\label{second}
\end{align}
"""


def test_a_law_may_have_rates_of_others_on_its_right_sides():
    found = roles(CHARGE + r"Then $m(\dot x^2+\dot y^2)+k(x^2+y^2)$ is constant.")
    assert list(found.values()) == [LAW, LAW, CLAIM]


def test_by_what_an_equation_is_multiplied_is_no_integral():
    words = r"Multiplying the first by $\dot x$, the second by $\dot y$ and adding we obtain the energy integral"
    found = roles(CHARGE + words + r" \[m(\dot x^2+\dot y^2)+k(x^2+y^2)=h.\]")
    assert [*found.values()].count(CLAIM) == 1


@pytest.mark.parametrize("between", sampled([", ", " and ", ",~"], 1))
def test_equations_side_by_side_are_one_set(between):
    text = TOP + rf"The set $p=0${between}$q=0$ is invariant."
    assert verdicts(text) == {"p=0": Verdict.PROVED}
    assert verdicts(TOP + r"The set $p=0$ is invariant.")["p=0"] is not Verdict.PROVED


@pytest.mark.parametrize("name", ["x", "s", "u"])
def test_any_letter_that_is_no_time_can_be_defined(name):
    text = TOP + rf"Put ${name}=p/r$; then $\dot {name}=q(a-c\,{name}^2)$."
    found = verdicts(text)
    assert found == {rf"\dot {name}=q(a-c\,{name}^2)": Verdict.CONDITIONAL}


@pytest.mark.parametrize("later", sampled(["p>0", r"p\ne0", "p=1"], 1))
def test_a_later_supposition_about_the_same_name_takes_the_place_of_the_first(later):
    """Under two that contradict each other anything would hold."""
    false = r"(p+q)^2=p^2+q^2"
    suppose = TOP + r"Suppose that $p=0$. Then $pq=0$. "
    assert verdicts(rf"{suppose} Now let ${later}$. Then ${false}$.")[false] not in (
        Verdict.PROVED, Verdict.CONDITIONAL
    )  # fmt: skip


@pytest.mark.parametrize("kind", sampled(["enumerate", "itemize"], 1))
def test_what_an_item_supposes_reaches_no_other_item(kind):
    """Each item of a list has hypotheses of its own; those before the list reach into all."""
    items = rf"\begin{{{kind}}}\item Let $a=-b$. Then $p^2+q^2$ is constant."
    items += rf"\item Then $q^2+p^2$ is constant.\end{{{kind}}}"
    found = verdicts(TOP + r"\begin{theorem}" + items + r"\end{theorem}")
    assert found["p^2+q^2"] is Verdict.PROVED and not found["q^2+p^2"].green
    before = verdicts(TOP + r"\begin{theorem} Let $a=-b$. " + items + r"\end{theorem}")
    assert before["q^2+p^2"] is Verdict.PROVED


def test_each_section_may_have_a_system_of_its_own_in_the_same_letters():
    first = r"\section{One} The motion is $$\dot x=y,\quad \dot y=-x.$$ Then $x^2+y^2$ is constant."
    second = r"\section{Two} The motion is $$\dot x=y,\quad \dot y=x.$$ Then $x^2-y^2$ is constant."
    text = first + second + r" But $xy+x^2$ is constant."
    found = verdicts(text)
    assert found["x^2+y^2"] is found["x^2-y^2"] is Verdict.PROVED
    assert not found["xy+x^2"].green
    assert reading(text).parts.laws[1:]


def test_what_follows_in_another_section_is_claimed_by_the_law():
    first = r"\section{One} The motion is $$\dot x=y,\quad \dot y=-x.$$"
    second = r"\section{Two} Therefore we have $$\dot x=y,\quad \dot y=x.$$"
    assert len(reading(first + second).parts.laws) == 1


@pytest.mark.slow
def test_what_stands_below_no_law_is_not_red_where_there_are_two():
    """It may be meant by either law: yellow, unless one edit mends it."""
    first = r"\section{One} The motion is $$\dot x=y,\quad \dot y=-x.$$ "
    second = r"\section{Two} The motion is $$\dot x=y,\quad \dot y=x^3+x.$$ "
    claimed = r"Then $x^2y^2+x+7y^3$ is constant."
    (alone,) = verdicts(first + claimed).values()
    (below,) = verdicts(first + second + claimed).values()
    assert alone is below is Verdict.REFUTED
    assert Verdict.REFUTED not in verdicts(first + second + r"\section{Again} " + claimed).values()


@pytest.mark.slow
def test_no_repair_derives_a_constant():
    text = r"The equations are $$\dot u=v,\quad \dot v=uw-nu,\quad \dot w=-uv.$$ "
    found = reading(text + r"Then $$\dot v=uw.$$ With $F=v+nu$ we have $$\dot F=uw+nv.$$")
    for outcome in ReadingSession(found, timeout=20).outcomes.values():
        for one in (outcome.correction, *outcome.alternatives):
            nodes = [node for f in (one.formulas if one else ()) for node in f.nodes()]
            assert not any(isinstance(n, Derivative) and "n" in n.names() for n in nodes)


@pytest.mark.parametrize(
    "words",
    [
        r"Each function \[x=\sqrt{Bu^2+Cv^2}\] is a solution if $B=C$.",
        r"A particular solution is $x=u+v$.",
        r"Then $x=u+v$ is also a solution.",
    ],
)
def test_a_solution_defines_nothing_of_what_stands_before(words):
    """Where the law cannot be read, its variable is not what a solution says later."""
    first = r"The equation is \[\ddot x+n^2x=\frac k{x^3}\ldots\] Then we have $\dot x^2+x=1$. "
    found = roles(first + words)
    assert DEFINITION not in [role for tex, role in found.items() if tex.startswith("x=")]


def test_a_constant_of_the_law_is_not_redefined_behind_it():
    law = r"The equations are $$\dot x=ky,\quad \dot y=-x.$$ Then $$x\dot x+ky\dot y=0.$$ "
    found = reading(
        law + r"One may think of a moment, " + "\n\n" + r"where $k=m^2$ and $m$ is known."
    )
    (last,) = (f for f in found.formulas if f.item.printed.tex == "k=m^2")
    assert last.role.name == ASSUMPTION
    assert not any(last.item in f.on for f in found.formulas)


HAMILTONIAN = r"""
\section{A chain} The motion is described by the Hamiltonian
\[ H=\frac12(p_1^2+p_2^2)+U,\qquad U=\frac k2(q_1-q_2)^2 . \]
"""
CANONICAL = r"\[ \dot q_i=\frac{\partial H}{\partial p_i},\quad \dot p_i=-\frac{\partial H}{\partial q_i}\quad(i=1,2) \]"  # fmt: skip


@pytest.mark.parametrize("printed", sampled(["", CANONICAL], 1))
def test_a_hamiltonian_is_a_law_with_the_canonical_bracket(printed):
    claims = r"Then $\ddot q_1=-k(q_1-q_2)$, $\{p_1+p_2,H\}=0$, $\{q_1,H\}=p_1$, $\{q_1-q_2,H\}=0$."
    found = verdicts(HAMILTONIAN + printed + claims)
    assert [*found.values()] == [Verdict.PROVED] * 3 + [Verdict.UNDECIDED]
    false = claims.replace(r"-k(q_1-q_2)", r"-k(q_1+q_2)")
    assert Verdict.PROVED not in [*verdicts(HAMILTONIAN + printed + false).values()][:1]


def test_of_the_sign_of_a_bracket_that_is_not_printed_nothing_is_refuted():
    (verdict,) = verdicts(HAMILTONIAN + CANONICAL + r"Then $\{H,q_1\}=p_1$.").values()
    assert verdict is Verdict.UNDECIDED


@pytest.mark.slow
def test_a_lagrangian_is_a_law():
    text = r"""\section{A particle} The Lagrangian is $$ L=\frac12(\dot r^2+r^2\dot\varphi^2)+\frac{m}{r} $$
    We have $\ddot r=r\dot\varphi^2-\frac{m}{r^2}$ and $\ddot\varphi=%s\frac{\dot r\dot\varphi}{r}$."""
    assert [*verdicts(text % "-2").values()] == [Verdict.CONDITIONAL] * 2
    assert [*verdicts(text % "-").values()] == [Verdict.CONDITIONAL, Verdict.REFUTED]


def test_a_lone_function_h_is_no_hamiltonian():
    assert not reading(HAMILTONIAN.replace("Hamiltonian", "function")).parts.laws


@pytest.mark.parametrize("words", ["To the first order in $x$", "For small oscillations"])
def test_what_holds_approximately_is_no_law_of_what_follows(words):
    law = r"The equations are $$\dot x=ay,\quad \dot y=-bx+xy^2,\quad \dot z=0.$$ Suppose that $b>0$. "
    first = rf"\paragraph{{Small}} {words} we have $$\ddot x=-abx.$$ "
    then = r"\paragraph{Exact} Suppose that $b=2$. Then $$\dot x=ay,\quad \ddot x=-2ax+axy^2.$$"
    found = verdicts(law + first + then)
    assert found[r"\dot x=ay"].green and found[r"\ddot x=-2ax+axy^2"].green


@pytest.mark.parametrize("said", ["is constant", "does not change", "is an integral"])
def test_what_is_said_of_one_formula_is_not_said_of_the_next(said):
    law = r"The equations are $$\dot x=y,\quad \dot y=-x.$$ "
    found = reading(law + rf"Then $x^2+y^2$ {said} and $\ddot x+x=0$.")
    assert [f.role.kind for f in found.formulas][-2:] == ["integral", "identity"]
    denied = reading(law + r"Then $x$ is not an integral, and $x\dot x+y\dot y=0$.")
    assert denied.formulas[-1].role.name == CLAIM


@pytest.mark.parametrize("words", ["It has no integral", "There is no further integral"])
def test_what_there_is_not_is_not_claimed(words):
    found = roles(TOP + words + " $p+q$.")
    assert found["p+q"] != CLAIM


@pytest.mark.slow
def test_a_list_of_integrals_is_claimed_function_by_function():
    text = TOP.replace(r"c\,pq", "0") + r"It has the integrals \[ bp^2-aq^2,\qquad r. \] "
    found = verdicts(text + r"It admits the integral $p^2+q^2$.")
    assert found["bp^2-aq^2"] is found["r"] is Verdict.PROVED
    assert found["p^2+q^2"] is Verdict.REFUTED


@pytest.mark.slow
def test_what_is_true_of_a_misprint_only_is_not_green():
    """The law has a wrong sign; by it a plane is invariant, and four true claims fail."""
    law = r"The equations are $$\dot x=yz+ky,\qquad \dot y=xz+kx,\qquad \dot z=-xy.$$ "
    true = r"The functions $x^2+y^2+2z^2$ and $x^2-y^2+4kz$ are integrals, "
    true += r"and so is $(x^2+y^2+2z^2)(x^2-y^2+4kz)$. "
    found = verdicts(law + true + r"The plane $x=y$ is invariant.")
    assert found["x^2+y^2+2z^2"] is found["x^2-y^2+4kz"] is Verdict.REFUTED
    assert found["x=y"] is Verdict.UNDECIDED
    assert verdicts(law.replace("xz+kx", "xz-kx") + true)["x^2-y^2+4kz"] is Verdict.PROVED


@pytest.mark.parametrize("function", sampled(["the momentum $G=b^2p^2-abq^2$", "$bp^2-aq^2$"], 1))
def test_so_is_says_the_same_of_what_follows(function):
    text = TOP + rf"The function $F=cp^2-ar^2$ is an integral, and so is {function}."
    found = reading(text)
    assert [f.role.kind for f in found.formulas][-2:] == ["integral", "integral"]
    assert {*verdicts(text).values()} == {Verdict.PROVED}
    assert Verdict.REFUTED in verdicts(text.replace("b^2p^2", "p^2").replace("$bp", "$p")).values()


@pytest.mark.slow
def test_a_clock_in_the_sentence_is_no_condition_of_a_rate():
    """“With respect to” supposes nothing, and a constant in a rate is no unknown of an equation."""
    law = r"The equations are $$\dot x=\omega_3y,\quad \dot y=-\omega_3x,\quad \dot\omega_3=0.$$ "
    found = verdicts(
        law
        + r"Introduce $x+iy$, where $i^2=-1$. Denoting the derivative with respect to $\tau=it$ "
        r"by the prime, we obtain $$ix'=w_3y,\quad iy'=-w_3x.$$"
    )
    assert {*found.values()} == {Verdict.REFUTED}


@pytest.mark.slow
def test_an_abstract_is_not_red_where_not_all_that_follows_is_read():
    abstract = r"\begin{abstract}It is shown that $(xv-yu)^2+3x^2$ is an integral.\end{abstract}"
    law = r"The equations are $$\dot x=u,\quad \dot u=-x,\quad \dot y=v,\quad \dot v=-y.$$ "
    (alone,) = verdicts(abstract + law).values()
    (beside,) = verdicts(abstract + law + r"Further $$2x+$$ is known.").values()
    assert not alone.green and beside is Verdict.UNDECIDED


@pytest.mark.parametrize(
    ("words", "is_said"),
    sampled(
        [
            ("where the sign of the root depends on the quadrant", True),
            ("with either sign of the square root", True),
            ("the root has the sign of the left side", True),
            ("где знак корня определяется четвертью", True),
            ("as is known", False),
        ],
        1,
    ),
)
def test_a_root_has_either_sign_where_the_sentence_speaks_of_it(words, is_said):
    """Elsewhere it is not negative; and another root has neither sign."""
    law = r"The equation of motion is $$\ddot\theta=-\omega^2\sin\theta.$$ "
    half = r"\sin\frac\theta2=\sqrt{\frac{1-\cos\theta}{2}}"
    for printed, green in ((half, is_said), (half.replace("-", "+"), False)):
        (found,) = verdicts(law + rf"For half the angle $${printed},$$ {words}.").values()
        assert found.green == green


LAWS = r"""\documentclass{article}\begin{document}
The equations of motion are
\begin{equation}\label{law}
\dot x=yz+by,\qquad \dot y=xz+bx,\qquad \dot z=-xy.
\end{equation}
The functions
\begin{equation}\label{integrals}
A=x^2+y^2+2z^2,\qquad B=x^2-y^2+4bz
\end{equation}
are integrals. Points of the lines
\begin{equation}\label{lines}
y=0,\ z=b\qquad\text{and}\qquad x=0,\ z=-b
\end{equation}
are in equilibrium. The plane $x=y$ is invariant.
\end{document}
"""


@pytest.mark.slow
def test_what_may_have_been_meant_otherwise_speaks_for_a_repair_all_the_same():
    run = ReadingSession(read(decode("disks.tex", LAWS.encode())), timeout=20)
    found = {id: outcome.verdict for id, outcome in run.outcomes.items()}
    assert [place.place for place in run.causes.misprints] == ["law.2"]
    assert found["integrals.1"] is found["integrals.2"] is Verdict.REFUTED
    assert found["x-y"] is Verdict.UNDECIDED


@pytest.mark.parametrize(
    "said", sampled(["It has the integral $x^2+y^2=1$.", "Here $x^2+y^2=1$."], 1)
)
def test_a_rate_may_be_meant_where_what_moves_has_a_value_that_is_said_before(said):
    system = r"The equations of motion are $$\dot x=y,\quad \dot y=-x.$$ "
    rate = r"$\dot x^2=1-x^2$"
    assert verdicts(f"{system}{said} Then {rate}.")[rate[1:-1]] is Verdict.UNDECIDED
    assert verdicts(f"{system}Then {rate}. {said}")[rate[1:-1]] is Verdict.REFUTED


def test_a_function_that_everybody_knows_is_no_constant_of_the_paper():
    system = r"The equations of motion are $$\dot x=-x+y,\quad \dot y=-y.$$ "
    session = ReadingSession(reading(system + "The function $F=ye^{t}$ is constant."), timeout=20)
    assert next(iter(session.outcomes.values())).verdict is Verdict.PROVED
    assert not [*assumptions_of(audit_reading(session))]


PENDULUM = r"\section{The pendulum} The pendulum moves by $\ddot\theta=-\sin\theta$. "


@pytest.mark.parametrize(
    "words",
    sampled(
        [
            r"The pendulum is ${}$.",
            r"Consider ${}$.",
            r"We study the motion ${}$ of a point.",
            r"Let ${}$ be the equation of an oscillator.",
        ],
        1,
    ),
)
@pytest.mark.parametrize(
    ("law", "true", "false"),
    [
        (r"\ddot x=-\sin x", r"\dot x^2-2\cos x", r"\dot x^2+2\cos x"),
        (r"\dot x=yz,\ \dot y=-xz,\ \dot z=0", "x^2+y^2", "x^2-y^2"),
        (r"\ddot{\mathbf r}=-\mathbf r,\ \mathbf r=(x,y)", r"x\dot y-y\dot x", "xy"),
    ],
)
def test_the_only_law_of_a_paper_may_stand_among_its_words(words, law, true, false):
    text = words.replace("{}", law) + f" The function ${true}$ is constant. So is not ${false}$."
    assert verdicts(text)[true] is Verdict.PROVED
    text = words.replace("{}", law) + f" The function ${false}$ is constant."
    assert verdicts(text)[false] is Verdict.REFUTED


@pytest.mark.parametrize(("factor", "verdict"), [("4", "proved"), ("2", "undecided")])
def test_an_equation_for_the_constant_of_a_motion_holds_along_it_and_is_not_called_false(
    factor, verdict
):
    claim = rf"\dot\theta^2={factor}(k^2-\sin^2\frac\theta2)"
    text = PENDULUM + rf"With $k=\sin(\theta_0/2)$ we have ${claim}$."
    assert verdicts(text)[claim] == verdict


@pytest.mark.parametrize("by", ["q", "x"])
def test_a_function_that_is_defined_at_its_argument_is_derived_by_it(by):
    said = rf"The equations are \[ \dot {by}=p,\qquad \dot p=-2{by}. \] The potential is "
    said += rf"$V({by})={by}^2$. Its derivative is $V'({by})=2{by}"
    true = verdicts(f"{said}$.")
    false = verdicts(f"{said}+1$.")
    assert true[f"V'({by})=2{by}"] is Verdict.PROVED
    assert not any(verdict.green for verdict in false.values())


def test_what_is_named_and_conserved_is_claimed_whatever_stands_before_the_comma():
    law = r"The Lagrangian is \[ L=\tfrac12(\dot r^2+r^2\dot\varphi^2)-U r^2. \] "
    said = r"Since $\varphi$ is cyclic, $p=r^2\dot\varphi"
    assert verdicts(rf"{law}{said}$ is conserved.")[r"p=r^2\dot\varphi"].green
    assert not verdicts(rf"{law}{said}\,r$ is conserved.")[r"p=r^2\dot\varphi\,r"].green


@pytest.mark.parametrize(
    ("words", "green"),
    [
        (r"The points $p=a$, $q=0$ are equilibria.", True),
        (r"The point $p=a$, $q=0$ is an equilibrium.", True),
        pytest.param(r"The points $p=a$, $q=1$ are equilibria.", False, marks=pytest.mark.slow),
        pytest.param(r"The lines $p=a$, $q=0$ are invariant.", False, marks=pytest.mark.slow),
        pytest.param(r"The points $q=0$, $q=1$ are equilibria.", False, marks=pytest.mark.slow),
    ],
)
def test_a_point_is_given_by_its_coordinates_together(words, green):
    law = r"The equations are \[ \dot p=q,\qquad \dot q=a-p+q. \] "
    found = verdicts(law + words)
    assert found and all(verdict.green is green for verdict in found.values())


@pytest.mark.parametrize("value", ["3c^2", "2c^2"])
@pytest.mark.parametrize("body", ["cq^2", "kq^2", r"c\,q^2+q", r"q^2\ln c"])
def test_a_derivative_at_a_letter_of_the_definition_is_not_judged(body, value):
    law = r"The equations are \[ \dot q=p,\qquad \dot p=-cq,\qquad \dot r=r. \] "
    given = rf"Put $k=c$. The potential is $V(q)={body}$. Its derivative is $V'(c)={value}$."
    assert not any(verdict.green for verdict in verdicts(law + given).values())


@pytest.mark.parametrize(
    ("words", "kind"),
    [("the measure with the density", "measure"), ("мера с плотностью", "measure"),
     ("the volume", "form")],
)  # fmt: skip
def test_a_measure_that_is_preserved_is_no_constant_function(words, kind):
    """The function is no integral, and the measure with this density is preserved all the same."""
    text = r"The motion is \[\dot x=xy,\qquad \dot y=-y^2.\] "
    preserved = {
        f.role.kind for f in reading(text + rf"Hence {words} $xy^2$ is preserved.").formulas
    }
    assert kind in preserved and "integral" not in preserved
    constant = {
        f.role.kind for f in reading(text + r"Hence the function $xy$ is preserved.").formulas
    }
    assert "integral" in constant


def test_a_formula_with_nothing_in_it_is_no_ellipsis():
    found = reading(TOP + r"Nothing stands in $\quad$.")
    assert [f.role.name for f in found.formulas].count(LAW) == 3


RING = r"The system is \[ \dot x=x(y-z),\quad \dot y=y(z-x),\quad \dot z=z(x-y) . \] "


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        (r"It has the integrals $J=x+y+z$ and $K=xyz$.", [Verdict.PROVED, Verdict.PROVED]),
        (r"It has the integrals $J=x+y+z$ and $K=xy$.", [Verdict.PROVED, Verdict.REFUTED]),
        (r"Besides the integrals $J=x+y+z$, $K=xyz$ we use $L=xy$.", [Verdict.PROVED] * 2),
        (r"With the integral $J=x+y+z$ and $L=xy$ we go on.", [Verdict.PROVED]),
    ],
)
def test_integrals_are_listed_among_words(words, expected):
    assert [*verdicts(RING + words).values()] == expected


def test_what_stands_under_a_square_in_a_law_is_no_constraint():
    law = r"The motion obeys \[ \dot x=-\frac y{s^2}+x,\qquad \dot y=\frac x{s^2}, \] "
    found = verdicts(law + r"where $s^2=x^2+y^2$. Then $x^2+y^2$ is constant, and so is $s$.")
    assert Verdict.PROVED not in found.values() and Verdict.CONDITIONAL not in found.values()


PLANET = r"""The planet moves by \[ \ddot x=-\frac{\mu x}{(x^2+y^2)^{3/2}},\qquad
\ddot y=-\frac{\mu y}{(x^2+y^2)^{3/2}} .\] """


@pytest.mark.parametrize(
    ("claim", "wrong"),
    [
        (r"x\dot y-y\dot x=\mathrm{const}", r"x\dot y+y\dot x=\mathrm{const}"),
        (r"c=x\dot y-y\dot x=\mathrm{const}", r"c=x\dot y+y\dot x=\mathrm{const}"),
    ],
)
def test_roots_in_the_law_and_const_behind_a_new_name(claim, wrong):
    assert verdicts(PLANET + rf"Hence \[ {claim} .\]")[claim].green
    assert verdicts(PLANET + rf"Hence \[ {wrong} .\]")[wrong].value == "refuted"
    assert not verdicts(PLANET + rf"It is not true that \[ {claim} .\]")
