"""How far it reaches what is supposed of constants: a claim elsewhere does not rest on it."""

import pytest

from kowalevski_cas.audit.reading import ReadingSession, audit_reading
from kowalevski_cas.reading import ASSUMPTION, CLAIM
from kowalevski_cas.reading.known import NOTATION, OTHER
from kowalevski_cas.verify.outcome import Verdict
from tests.sample import sampled

from .test_reading import TOP, reading, roles, verdicts

OSCILLATOR = r"""
\section{A point} It moves by
\begin{equation} \dot x=y,\quad\dot y=-\omega^2x. \end{equation}
"""

SUPPOSED = [
    (TOP, "a+b=0", "p^2+q^2", "2p^2+2q^2"),
    (TOP, "b+c=0", "q^2+r^2", "-q^2-r^2"),
    (TOP, "a+b+c=0", "p^2+q^2+r^2", "3p^2+3q^2+3r^2"),
    (TOP, "a=2b", "p^2-2q^2", "2q^2-p^2"),
    (OSCILLATOR, r"\omega=1", "x^2+y^2", "-x^2-y^2"),
    (OSCILLATOR, r"\omega^2=4", "4x^2+y^2", "8x^2+2y^2"),
]
"""A law, what is supposed of its constants, and two functions that are constant then only."""

BRIEF = ["For ${0}$ the function ${1}$ is an integral. ", "If ${0}$, then ${1}$ is an integral. "]
LASTING = [
    "Let ${0}$. Then ${1}$ is an integral.",
    "Suppose that ${0}$. Then ${1}$ is an integral.",
]


@pytest.mark.slow
@pytest.mark.parametrize(("law", "supposed", "function", "other"), SUPPOSED)
@pytest.mark.parametrize("words", BRIEF)
def test_what_a_sentence_supposes_for_itself_proves_nothing_in_the_next(
    law, supposed, function, other, words
):
    text = law + words.format(supposed, function) + f" The function ${other}$ is an integral."
    found = verdicts(text)
    assert found[function] is Verdict.PROVED
    assert found[other] is Verdict.UNDECIDED


@pytest.mark.parametrize(("law", "supposed", "function", "other"), SUPPOSED)
@pytest.mark.parametrize("words", LASTING)
def test_what_is_supposed_for_all_that_follows_holds_in_its_section(
    law, supposed, function, other, words
):
    text = law + words.format(supposed, function) + f" The function ${other}$ is an integral."
    assert verdicts(text) == {function: Verdict.PROVED, other: Verdict.PROVED}


@pytest.mark.slow
def test_a_claim_that_holds_by_what_is_supposed_elsewhere_names_it():
    text = OSCILLATOR + BRIEF[0].format(r"\omega=1", "x^2+y^2") + "The sum $x^2+y^2$ is constant."
    audit = audit_reading(ReadingSession(reading(text), timeout=20))
    *_, last = audit.formulas
    assert r"it holds with $\omega=1$" in last.message


def test_a_claim_that_fails_by_what_its_own_sentence_supposes_is_false():
    text = TOP + BRIEF[1].format("a+b=0", "p^2+q^2") + BRIEF[1].format("a=b", "2p^2+2q^2")
    assert verdicts(text)["2p^2+2q^2"] is Verdict.REFUTED


@pytest.mark.slow
def test_a_claim_that_no_supposition_makes_true_is_false():
    text = TOP + BRIEF[1].format("a+b=0", "p^2+q^2") + "The function $p^2+r$ is an integral."
    assert verdicts(text)["p^2+r"] is Verdict.REFUTED


MOVES = r"""The motion is given by
\begin{equation} \dot x=y,\quad\dot y=cx-hx^2. \end{equation}
"""


@pytest.mark.parametrize(
    "words",
    sampled(
        [
            r"Real motions exist for \[ 27c\le h^3 , \] and the equality stands for the rest.",
            r"Both roots are real if \[ 27c\le h^3 , \] which is well known.",
            r"Вещественные движения существуют при \[ 27c\le h^3 . \]",
        ],
        1,
    ),
)
def test_the_condition_of_what_words_state_is_supposed_of_nothing_else(words):
    found = reading(MOVES + words + r" We have \[ \frac{d}{dt}(x^2)=2xy . \]")
    (one,) = [f for f in found.formulas if r"\le" in f.item.printed.tex]
    assert one.role.name == CLAIM and one.claim is None
    assert not any(f.on for f in found.formulas)


@pytest.mark.parametrize(
    "words",
    [
        r"For \[ 27c\le h^3 \] motions are real.",
        r"The root is defined for \[ 27c\le h^3 . \]",
        r"We consider the case when the roots are real, i.e.\ suppose that \[ 27c\le h^3 . \]",
        r"Here $h$ is a constant with \[ 27c\le h^3 . \]",
    ],
)
def test_a_condition_that_words_suppose_is_an_assumption(words):
    found = reading(MOVES + words)
    (one,) = [f for f in found.formulas if r"\le" in f.item.printed.tex]
    assert one.role.name == ASSUMPTION


CASE = r"""The point moves by \[ \dot u=v,\qquad \dot v=-ku . \]
Let $k=4$. Then $E=v^2+4u^2$ is an integral.
"""


@pytest.mark.parametrize(
    ("between", "claim", "green"),
    sampled(
        [
            ("\n\nFor $k=9$ we put $w=3u$.\n\nAlways", r"\ddot u=-ku", True),
            ("\n\nFor $k=9$ we put $w=3u$.\n\nAlways", r"\ddot u=-4u", False),
            ("For $k=9$ it is no integral. Always", r"\ddot u=-4u", True),
            ("\n\nPut $w=3u$.\n\nAlways", r"\ddot u=-4u", True),
        ],
        2,
    ),
)
def test_a_case_is_over_where_a_later_paragraph_has_another_one(between, claim, green):
    found = verdicts(CASE + between + rf" \[ {claim} . \]")[claim]
    assert found.green is green and (green or found is Verdict.UNDECIDED)


DAMPED = r"The equations are $$\dot x=hy-ax+yz,\quad\dot y=hx-by-xz,\quad\dot z=-cz+xy.$$ "


@pytest.mark.parametrize(
    ("words", "green"),
    [
        (r"\section{The case of equal damping} If $a=b=c=\nu$, then the waves are alike. Let $f=x^2-y^2-2z^2$. We find $$\dot f=-2\nu f.$$", True),
        (r"\section{On the waves} If $a=b=c=\nu$, then the waves are alike. Let $f=x^2-y^2-2z^2$. We find $$\dot f=-2\nu f.$$", False),
        (r"$1^\circ$. If $a=b=c=\nu$, then $f=x^2-y^2-2z^2$ satisfies $$\dot f=-2\nu f.$$", True),
        (r"\section{The case of equal damping} If $a=b=c=\nu$, then the waves are alike. Let $f=x^2-y^2-2z^2$. We find $$\dot f=-3\nu f.$$", False),
        (r"\section{Cases} If $a=b=c$, there is symmetry; otherwise not. In general $f=x^2-y^2-2z^2$ satisfies $$\dot f=-2af.$$", False),
        (r"\section{A case} If $a=b=c$, then all is simple. In general $f=x^2-y^2-2z^2$ satisfies $$\dot f=-2af.$$", False),
        (r"Let $a=b=c$. Then $f=x^2-y^2-2z^2$ satisfies $$\dot f=-2af.$$", True),
        (r"Let $a=b=c$. Then all is simple. In the general case $f=x^2-y^2-2z^2$ satisfies $$\dot f=-2af.$$", False),
    ],
)  # fmt: skip
def test_a_case_that_a_heading_names_is_supposed_in_its_section(words, green):
    assert [one.green for one in verdicts(DAMPED + words).values()] == [green]


SWING = r"One obtains $$\ddot x=-k^2\sin x"


@pytest.mark.parametrize(
    ("words", "green"),
    [
        (rf"A pendulum has the length $l$. We measure $x$ from the vertical, and $k^2=g/l$. {SWING}.$$", True),
        (rf"{SWING},$$ $k^2=g/l$.", True),
        (rf"{SWING}.$$ Let $g=2l$. Hence $k^2=g/l$.", False),
    ],
)  # fmt: skip
def test_the_square_of_a_constant_is_given_by_what_is_new(words, green):
    claim = r" The energy $h=\frac12\dot x^2-\frac gl\cos x$ is an integral."
    assert [*verdicts(words + claim).values()][-1].green is green


def test_constants_behind_a_formula_have_the_sign_that_is_printed():
    found = roles(
        r"If the body is symmetric, then the energy is $$H=\frac12\sum_{i=1}^2a_ix_i^2,\qquad a_i>0.$$"
        r"The equations are $$\dot x_1=a_2x_2,\qquad\dot x_2=-a_1x_1.$$"
    )
    assert found["a_i>0"] == ASSUMPTION


PAIR = r"Consider $$a_1'=a_1(b_2-b_1),\quad a_2'=a_2(b_1-b_2),\quad b_1'=2(a_1^2-a_2^2),\quad b_2'=2(a_2^2-a_1^2).$$ "


@pytest.mark.parametrize(
    ("words", "green"),
    [
        (r"In the motions with $b_2=-b_1$, $a_2=0$ we have $b_1^2+a_1^2=c^2$ with a constant $c>0$.", True),
        (r"In the motions with $b_2=-b_1$, $a_2=0$ we have $b_1^2-a_1^2=c^2$ with a constant $c>0$.", False),
        (r"In the motions with $b_2=-b_1$ we have $b_1^2+a_1^2=c^2$ with a constant $c$.", False),
        (r"If $a_1=a_2$, then $b_1'=0$.", True),
        (r"If $a_1=-a_2$, then $b_1'=a_1$.", False),
    ],
)  # fmt: skip
def test_equations_between_variables_are_supposed_and_a_constant_is_called_so_behind(words, green):
    assert [one.green for one in verdicts(PAIR + words).values()] == [green]


def test_what_commutes_with_the_energy_is_claimed():
    brackets = r"Let $\{q,p\}=1$, $H=\frac12p^2+\frac12q^2$. "
    law = r"The equations are $$\dot q=p,\qquad\dot p=-q.$$ "
    for given, green in (("H^2", True), ("qp", False)):
        text = rf"{law}{brackets}The function $I={given}$ is in involution with the energy: $\{{H,I\}}=0$."
        assert [one.green for one in verdicts(text).values()] == [green]


def test_the_last_of_several_integrals_may_stand_among_words():
    law = r"Consider $$\dot x=y z,\quad\dot y=-2x z,\quad\dot z=xy.$$ The integrals are $$2x^2+y^2=h,$$ and ${}$."
    for printed, green in ((r"x^2-z^2=1", True), (r"x^2+z^2=1", False)):
        assert [one.green for one in verdicts(law.replace("{}", printed)).values()] == [True, green]


def test_an_inequality_is_supposed_in_the_general_case_as_well():
    law = r"Let $a\ne0$. The equations are $$a\dot x=y,\qquad a\dot y=-x.$$ "
    words = r"All is simple. In the general case $x^2+y^2$ is an integral."
    assert [str(one) for one in verdicts(law + words).values()] == ["proved"]
    bare = law.replace(r"Let $a\ne0$. ", "")
    assert [str(one) for one in verdicts(bare + words).values()] == ["conditional"]


@pytest.mark.parametrize(
    ("words", "role"),
    [
        ("The particles $q<p$ move by ROWS", ASSUMPTION),
        ("They are ordered, $q<p$, and move by ROWS", ASSUMPTION),
        ("They move by ROWS Hence $q<p$.", CLAIM),
    ],
)
def test_an_order_of_names_is_supposed_unless_it_is_deduced(words, role):
    found = reading(words.replace("ROWS", r"\[\dot q=p,\quad\dot p=-q.\]"))
    (order,) = (f for f in found.formulas if not f.item.members and f.item.formula is not None)
    assert order.role.name == role


@pytest.mark.parametrize("at", ["at", "when", "where", "for"])
def test_a_value_at_one_place_is_supposed_nowhere_else(at):
    """Else what is printed behind would be true because both sides vanish."""
    text = rf"The motion is $\ddot q=-q$. This is integrated with $x=0$ {at} $y=0$: \[ x=2a(y-\sin y) . \]"
    assert not any(verdict.green for verdict in verdicts(text).values())


DUFFING = r"""The equations are $\dot x=y$, $\dot y=ax-x^3-by$. Let $H=\frac12y^2-\frac a2x^2+\frac14x^4$. """


@pytest.mark.parametrize(
    ("before", "green"),
    [
        ("There is an equilibrium at the origin, with $y=0$. For $a=1$ we have ", False),
        ("There is an equilibrium at the origin, with $y=0$. Then ", False),
        ("There are motions with $b=0$ which are periodic. For any $a>0$ we have ", False),
        ("Существуют движения с $b=0$. При $a>0$ имеем ", False),
        ("Consider the system with $b=0$. For any $a>0$ we have ", True),
        ("Suppose that $b=0$. Then ", True),
        ("We now consider the points with $y=0$. Then ", True),
    ],
)
def test_what_is_said_beside_of_some_points_or_motions_is_supposed_of_no_others(before, green):
    (found,) = verdicts(rf"{DUFFING}{before}$\dot H=0$.").values()
    assert found.green == green
    assert green or found != Verdict.REFUTED


_EQUAL = r"The function $x^2+y^2$ is a first integral of $\dot x=ay$, $\dot y=-bx$"


@pytest.mark.parametrize(
    ("before", "after"),
    [
        (rf"\begin{{theorem}} Let $a=b$. {_EQUAL}. \end{{theorem}}", rf"\begin{{theorem}} {_EQUAL}. \end{{theorem}}"),
        (rf"\begin{{example}} Let $a=b$. {_EQUAL}. \end{{example}}", r"The function $x^2+y^2$ is an integral for any $a$ and $b$."),
        (rf"\section{{Symmetric case}} In this section $a=b$. {_EQUAL}.", r"\section{General case} The function $x^2+y^2$ is an integral."),
    ],
)  # fmt: skip
def test_what_makes_constants_equal_before_the_law_is_supposed_there_only(before, after):
    def greens(text):
        found = reading(text)
        outcomes = ReadingSession(found, timeout=20).outcomes
        return [
            outcomes[f.claim.id].verdict.green for f in found.formulas if f.role.kind == "integral"
        ]

    assert greens(before) == [True]
    assert greens(before + after) == [True, False]


@pytest.mark.parametrize("definition", [r"k=mw^2", r"w^2=k/m"])
def test_what_gives_a_constant_of_the_law_by_others_defines_it(definition):
    text = rf"Let ${definition}$. The equation $m\ddot x=-kx$ has the integral $\dot x^2+w^2x^2$."
    assert [one.green for one in verdicts(text).values()] == [True]


@pytest.mark.parametrize(
    ("words", "sign", "green"),
    [
        ("where $k$ is a positive constant", r"\le", True),
        ("where the constant $k$ is positive", r"\le", True),
        ("with a positive constant $k$", r"\le", True),
        ("with positive constants $j$ and $k$", r"\le", True),
        ("of the system with positive constants $j$, $k$", r"\le", True),
        ("где $k$ положительна", r"\le", True),
        ("where $k$ is a positive constant", r"\ge", False),
        ("where $k$ is a constant", r"\le", False),
        ("where $k$ is not positive", r"\le", False),
        ("where $k$ is positive for soft springs", r"\le", False),
        ("where $k$ is assumed positive", r"\le", True),
        ("where usually $k$ is positive", r"\le", False),
        ("where the sum of $j$ and $k$ is positive", r"\le", False),
        ("where either $j$ or $k$ is positive", r"\le", False),
        ("unlike [2], where $k$ is positive,", r"\le", False),
        ("where $k$ is positive only near the equilibrium", r"\le", False),
    ],
)
def test_words_call_constants_positive(words, sign, green):
    law = r"\dot x=y,\qquad\dot y=-x-ky,"
    text = rf"Let \[ {law} \] {words}. For $E=\frac12(x^2+y^2)$ we have $\dot E=-ky^2{sign}0$."
    assert [one.green for one in verdicts(text).values()] == [green]


SPRINGS = r"Two points obey \[ \ddot x=-a_1x+b(y-x),\qquad\ddot y=-a_2y+b(x-y) . \] "
ALIKE = [
    (r"Let $a_1=a_2=a$. Then \[ \ddot x+\ddot y=VALUE(x+y) . \]", "-a", "-2a"),
    (r"Let $a=a_1=a_2$. Then \[ \ddot x+\ddot y=VALUE(x+y) . \]", "-a", "-2a"),
    (r"Let $\omega^2=a_1=a_2$. Then \[ \ddot x+\ddot y=VALUE(x+y) . \]", r"-\omega^2", r"\omega^2"),
    (r"For equal stiffnesses $a=a_1=a_2$ we have \[ \ddot x+\ddot y=VALUE(x+y) . \]", "-a", "-2a"),
    (r"Пусть теперь $a_1=a_2=b=k$. Тогда \[ \ddot x=k(y+VALUE) . \]", "-2x", "-3x"),
    (r"If $a_1=a_2=2b$, then \[ \ddot x=b(y+VALUE) . \]", "-3x", "-2x"),
]


@pytest.mark.parametrize("words, true, false", ALIKE)
def test_constants_in_a_chain_are_all_the_same(words, true, false):
    (printed,), (wrong,) = (
        verdicts(SPRINGS + words.replace("VALUE", one)).values() for one in (true, false)
    )
    assert printed.green and not wrong.green


@pytest.mark.parametrize(("sign", "green"), [("-", True), ("", False)])
def test_so_they_are_where_the_law_is_printed_anew(sign, green):
    text = r"""\section{A} Let $m=au+bv$. The system is \[ I_1\dot u=-mv,\qquad I_2\dot v=mu . \]
    \section{B} Let now $a=0$ and $I_1=I_2=I$. Then
    \[ \dot u=-\frac bIv^2,\qquad\dot v=\frac bIuv . \] With $k=b/I$ there is the solution
    \[ u=SIGNw\tanh(kwt),\qquad v=\frac w{\cosh(kwt)} . \]""".replace("SIGN", sign)
    found = verdicts(text)
    assert all(one.green is green for tex, one in found.items() if "kwt" in tex)
    assert any("kwt" in tex for tex in found)


GROWTH = r"It moves by \begin{equation} \dot u=uv,\quad\dot v=-uv. \end{equation} "
LOOKED_AT = [
    "We are interested only in positive solutions: $u>0$, $v>0$. ",
    "We confine ourselves to solutions with $u>0$, $v>0$. ",
    "Мы рассматриваем лишь положительные решения $u>0$, $v>0$. ",
]


@pytest.mark.parametrize("words", LOOKED_AT)
@pytest.mark.parametrize(("sign", "verdict"), [("<", Verdict.PROVED), (">", Verdict.REFUTED)])
def test_what_alone_is_looked_at_is_supposed(words, sign, verdict):
    claimed = rf"\dot v{sign}0"
    assert verdicts(f"{GROWTH}{words}Then \\[ {claimed}. \\]") == {claimed: verdict}


NOT_CLAIMED = [
    "The branch on the right, $u>0$, is unstable.",
    "The branch on the right ($u>0$) is unstable.",
    "The sum $u+v$ is an integral at every point of the octant $u>0$.",
    "Сумма $u+v$ постоянна во всех точках $u>0$.",
]
CLAIMED = [
    "We do not study only solutions $u>0$.",
    "We study the motion: $u>0$ always.",
    "Studying it we see that $u^2>v$.",
    "The square is positive, $u^2>0$.",
]


@pytest.mark.parametrize("sentence", NOT_CLAIMED)
def test_an_inequality_in_apposition_is_neither_claimed_nor_supposed(sentence):
    (role,) = (r for f, r in roles(GROWTH + sentence).items() if f.startswith("u>"))
    assert role not in (CLAIM, ASSUMPTION)


@pytest.mark.parametrize("sentence", CLAIMED)
def test_an_inequality_that_a_clause_states_is_claimed(sentence):
    (role,) = (r for f, r in roles(GROWTH + sentence).items() if ">" in f)
    assert role == CLAIM


LISTED = [
    "The exponents are $s=0$ and $s=a$. ",
    "The exponents are $s=0$, $s=\\pm a$. ",
    r"The roots are \[ s=\pm\sqrt a. \] ",
    "Корни суть $s=0$, $s=1$ и $s=a$. ",
]


@pytest.mark.parametrize("words", LISTED)
def test_several_values_of_a_letter_suppose_none_of_them(words):
    found = reading(f"{OSCILLATOR}{words} Then $x^2+y^2+sx$ and $s^2+x$ are integrals.")
    given = (f for f in found.formulas if "s=" in f.item.printed.tex)
    assert {f.role.name for f in given} <= {OTHER, NOTATION}


CASES = [
    r"For $\omega=1$ and $\omega=2$ the sum ${}$ is an integral.",
    r"The sum ${}$ is an integral for $\omega=2$, $\omega=1$.",
    r"If $\omega=2$ or if $\omega=1$, then ${}$ is an integral.",
]


@pytest.mark.parametrize("words", CASES)
@pytest.mark.parametrize("function", ["x^2+y^2", "4x^2+y^2"])
def test_what_is_said_for_several_values_is_not_judged_by_one_of_them(words, function):
    assert function not in verdicts(OSCILLATOR + words.format(function))


def test_two_equations_for_a_letter_are_no_list_of_values():
    text = OSCILLATOR + r"Let $k=\omega^2$, $k=2\pi/T$. Then $kx^2+y^2$ is an integral."
    assert verdicts(text)["kx^2+y^2"] is Verdict.PROVED


def test_values_of_a_constant_of_the_law_are_supposed_nowhere_else():
    text = (
        OSCILLATOR + r"The frequencies are $\omega=1$ and $\omega=2$. The sum ${}$ is an integral."
    )
    for function in ("x^2+y^2", "4x^2+y^2"):
        assert verdicts(text.replace("{}", function))[function] is Verdict.UNDECIDED
    signs = OSCILLATOR + r"The frequencies are $\omega=\pm2$. The sum $4x^2+y^2$ is an integral."
    assert verdicts(signs)["4x^2+y^2"] is Verdict.PROVED


@pytest.mark.parametrize(("claim", "green"), [("ge", True), ("le", False)])
def test_an_apposition_supposes_what_it_says_of_constants(claim, green):
    words = r"Hence a stiff spring, $\omega>1$, is stable. Then \[ \omega^2x^2\%s x^2. \]"
    assert verdicts(OSCILLATOR + words % claim)[rf"\omega^2x^2\{claim} x^2"].green is green


PLANE = r"Let $H=\frac12(p_x^2+p_y^2)+\frac12(x^2+y^2)$ and $K=xp_y-yp_x$. "
WELL = r"Consider $\dot x=y$, $\dot y=x-x^3$. "


@pytest.mark.parametrize(
    "text",
    [
        rf"{PLANE}The function $K^2$ is an integral, and $\{{K,H\}}\ne0$.",
        rf"{WELL}The function $F=xy$ has $\dot F\neq0$.",
        rf"{WELL}We have $\frac d{{dt}}(y^2-x^2+\frac12x^4)\ne0$.",
    ],
)
def test_a_rate_that_is_said_not_to_vanish_is_claimed(text):
    found = [f for f in reading(text).formulas if r"\ne" in f.item.printed.tex]
    assert [f.role.name for f in found] == [CLAIM]
    verdict = [v for tex, v in verdicts(text).items() if r"\ne" in tex]
    assert verdict == [Verdict.UNDECIDED]


@pytest.mark.parametrize("word", ["If", "Suppose that", "Where"])
def test_a_rate_that_does_not_vanish_may_be_supposed(word):
    text = rf"{WELL}{word} $\dot x\ne0$, the function "
    assert [*verdicts(rf"{text}$y^2-x^2+\frac12x^4$ is an integral.").values()][-1].green
    assert not [*verdicts(rf"{text}$y^2-x^2-\frac12x^4$ is an integral.").values()][-1].green


@pytest.mark.parametrize(
    ("words", "green"),
    [
        ("The oscillations with $x^2<1$ are stable, and the others are not.", False),
        ("Stability takes place for $x^2<1$.", False),
        ("При $x^2<1$ колебания устойчивы.", False),
        ("Let $x^2<1$, where the motion is stable.", True),
    ],
)
def test_what_a_sentence_on_stability_compares_is_so_in_it_only(words, green):
    law = r"The body obeys \[ \dot x=y,\qquad \dot y=-x+ax^3 . \] "
    found = verdicts(rf"{law} {words} Moreover \[ x^4<1 . \]")
    assert [one.green for one in found.values()] == [green]


@pytest.mark.parametrize("value", ["0", r"\frac12", "2"])
@pytest.mark.parametrize("words", ["Then {}, and", "Hence we have {}, and"])
def test_another_value_of_what_is_given_is_not_supposed_silently(words, value):
    """It would say what the constants are of which it was given."""
    text = r"Consider \[\dot x=y,\qquad\dot y=-x.\] \section{A} Here $D=1-a$. \section{B} "
    said = words.format(f"$D={value}$")
    found = verdicts(rf"{text}{said} \[x^2+ay^2=\mathrm{{const}}.\]")
    assert [*found.values()] == [Verdict.UNDECIDED] * 2
    found = verdicts(rf"{text}Let $a=1-{value}$. {said} \[x^2+ay^2=\mathrm{{const}}.\]")
    assert found[f"D={value}"].green
    found = verdicts(rf"{text}If $D={value}$, then \[x^2+(1-{value})y^2=\mathrm{{const}}.\]")
    assert [one.green for one in found.values()] == [value == "0"]


FIELDS = r"""\subsection{{Gyration}} A charge moves by $$m\dot{{\mathbf v}}=q(\mathbf E+\mathbf v\times\mathbf B).$$
Let $\mathbf E=0$ and $\mathbf B=B\mathbf e_z$. \subsection{{Crossed fields}} Let now $\mathbf E=E\mathbf e_x$. With
$$\mathbf w={}/B^2$$ we have $$\mathbf E+\mathbf w\times\mathbf B=0.$$"""


def test_the_letter_of_a_vector_along_an_axis_is_known_in_later_sections():
    assert [v.green for v in verdicts(FIELDS.format(r"\mathbf E\times\mathbf B")).values()] == [
        True
    ]
    other = FIELDS.format(r"\mathbf B\times\mathbf E")
    assert [v.green for v in verdicts(other).values()] == [False]


@pytest.mark.parametrize(
    "words",
    [
        r"Let a constant field $\mathbf E$ be applied, $\mathbf E\cdot\mathbf B=0$.",
        r"Suppose the field $\mathbf E$ is orthogonal to the first, $\mathbf E\cdot\mathbf B=0$.",
        r"Пусть поле $\mathbf E$ постоянно, причём $\mathbf E\cdot\mathbf B=0$.",
    ],
)
def test_a_condition_behind_what_is_let_be_is_supposed(words):
    law = r"A charge moves by $$m\dot{\mathbf v}=q(\mathbf E+\mathbf v\times\mathbf B).$$ "
    drift = r" With $\mathbf w=\mathbf E\times\mathbf B/B^2$ we have $$\mathbf E+\mathbf w\times\mathbf B=0.$$"
    assert [v.green for v in verdicts(law + words + drift).values()] == [True]
    assert not any(v.green for v in verdicts(law + drift).values())


TOP_OF_GORYACHEV = r"""The top moves by $$4\dot p=3qr,\quad 4\dot q=-3rp-a\gamma'',\quad \dot r=a\gamma',\quad
\dot\gamma=r\gamma'-q\gamma'',\quad\dot\gamma'=p\gamma''-r\gamma,\quad\dot\gamma''=q\gamma-p\gamma'.$$
It has the integral $$4(p\gamma+q\gamma')+r\gamma''=c.$$ \section{Variables} """


@pytest.mark.parametrize(
    "words", ["In what follows", "From now on", "В дальнейшем", "Henceforth we suppose"]
)
def test_what_is_so_in_all_that_follows_is_supposed(words):
    """The value of an integral, or a constant, and in the paragraphs behind it, too."""
    law = TOP_OF_GORYACHEV + rf"{words} $c=0$. The top is fast." + "\n\n"
    assert verdicts(law + r"We have $$r\gamma''=-4(p\gamma+q\gamma').$$")[
        r"r\gamma''=-4(p\gamma+q\gamma')"
    ].green
    assert not verdicts(law + r"We have $$r\gamma''=4(p\gamma+q\gamma').$$")[
        r"r\gamma''=4(p\gamma+q\gamma')"
    ].green
    pushed = r"A point moves by $$\dot x=y,\quad\dot y=-x+b.$$ "
    behind = "\n\n" + r"The function $x^2+y^2$ is an integral."
    assert verdicts(pushed + rf"{words} $b=0$." + behind)["x^2+y^2"].green
    assert not verdicts(pushed + behind)["x^2+y^2"].green
