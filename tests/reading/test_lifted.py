"""Where what was supposed is over: words leave the case, or speak of other values."""

import pytest

from kowalevski_cas.audit.reading import ReadingSession
from tests.reading.test_reading import reading, verdicts
from tests.sample import sampled

DAMPED = r"""The equations are $\dot x=y$, $\dot y=ax-x^3-by$.
Let $H=\frac12y^2-\frac a2x^2+\frac14x^4$. """
RATE = r"$\dot H=0$"

LASTING = [
    rf"Let $b=0$. Then the motion is periodic. The function $H$ satisfies {RATE}.",
    rf"In the case $b=0$ the system is conservative. Then {RATE}.",
    rf"Let $b=0$. The mass may have any value. We have {RATE}.",
    rf"In what follows $b=0$ and $a>0$. The constant $b$ will not be mentioned. Then {RATE}.",
    rf"Let $b=0$. Obviously $b\ge0$ and $b<1$. Then {RATE}.",
    rf"Пусть $b=0$. Тогда движение периодично. Имеем {RATE}.",
    rf"Let $b=0$. Then there is no friction. We get {RATE}.",
    rf"Let $b=0$. As $b$ vanishes, {RATE}.",
    rf"Let $b=0$. Without friction {RATE}.",
    rf"Let $b=0$. For the undamped system {RATE}.",
    rf"Let $b=0$. If we differentiate $H$, we find {RATE}.",
    rf"Suppose that $b=0$. Under this assumption {RATE}.",
    rf"Suppose that $b=0$. For any initial conditions {RATE}.",
]
LIFTED = [
    rf"Suppose first that $b=0$. For any $b$ we have {RATE}.",
    rf"The case $b=0$ was studied by Duffing. For all other values of $b$ we have {RATE}.",
    rf"Taking $b=0$ would simplify matters. Whatever $b$ may be, we have {RATE}.",
    rf"Assume for the moment that $b=0$. In what follows $b>0$. Then {RATE}.",
    rf"Systems with $b=0$ are called conservative. In what follows $b\ne0$. Then {RATE}.",
    rf"\begin{{figure}}\caption{{The portrait. Here $b=0$.}}\end{{figure}} We have {RATE}.",
    rf"The portrait is simple\footnote{{Here we put $b=0$.}}. We have {RATE}.",
    rf"We do not assume that $b=0$. Then {RATE}.",
    rf"In Table 1 the values are $a=1$, $b=0$. We have {RATE}.",
    rf"In [3] it was assumed that $b=0$. We have {RATE}.",
    rf"The hypersurface $b=0$ of the parameters is remarkable. We have {RATE}.",
    "\n\nExercise. Put $b=0$ and draw the portrait.\n\n" + rf"We have {RATE}.",
    rf"\begin{{proof}} Let $b=0$. Then it is clear. \end{{proof}} We have {RATE}.",
    rf"На рис.~1 принято $b=0$. Имеем {RATE}.",
    rf"We exclude the case $b=0$. Then {RATE}.",
    rf"If not $b=0$, then {RATE}.",
    rf"We may not put $b=0$. Hence {RATE}.",
    rf"At the resonance $b=0$. Away from it {RATE}.",
    rf"Suppose $y=0$ at some moment. Then {RATE} for all later times.",
    rf"Мы не предполагаем, что $b=0$. Тогда {RATE}.",
    rf"Let $b=0$. Then it is periodic. We now drop this assumption. Then {RATE}.",
    rf"Let $b=0$. Then it is periodic. The reader will check that {RATE} holds without this restriction.",
    rf"Let $b=0$. Then it is periodic. Returning to the general problem, we have {RATE}.",
    rf"Let $b=0$. Then it is periodic. For positive $b$ one has {RATE}.",
    rf"Let $b=0$. Then it is periodic. On the contrary, for $b=-1$ we get {RATE}.",
    rf"Let $b=0$. Then it is periodic. \subsection{{Arbitrary $b$}} We have {RATE}.",
    rf"To zeroth order $b=0$. The exact equations give {RATE}.",
    rf"Let $y=0$. Then it is at rest. In general {RATE}.",
    rf"Пусть $b=0$. Тогда движение периодично. При любом $b$ имеем {RATE}.",
    rf"Es sei $b=0$. Im allgemeinen gilt {RATE}.",
    rf"Soit $b=0$. Dans le cas g\'en\'eral on a {RATE}.",
    rf"Let $b=0$. Then it is periodic. Suppose now that this is not so. Then {RATE}.",
    rf"Let $b=0$. Then it is periodic. In the opposite case {RATE}.",
    rf"Let $b=0$. Then it is periodic. Else {RATE}.",
    rf"Let $b=0$. Then it is periodic. If not, then {RATE}.",
    rf"Let $b=0$. Then it is periodic. If friction is present, then {RATE}.",
    rf"Let $b=0$. Then it is periodic. We now allow friction. Then {RATE}.",
    rf"Let $b=0$. Then it is periodic. In the presence of friction {RATE}.",
    rf"Let $b=0$. Then it is periodic. With friction one has {RATE}.",
    rf"Let $b=0$. Then it is periodic. We pass to the damped oscillator. Here {RATE}.",
    rf"Let $b=0$. Then it is periodic. When the coefficient of friction is different from zero, {RATE}.",
    rf"Let $b=0$. Then it is periodic. When $b$ does not vanish, {RATE}.",
    rf"Let $b=0$. Then it is periodic. Let us now restore $b$. Then {RATE}.",
    rf"Let $b=0$. Then it is periodic. If $b$ is kept, then {RATE}.",
    rf"Let $b=0$. Then it is periodic. The assumption is superfluous. Indeed, {RATE}.",
    rf"Let $b=0$. Then it is periodic. Even without it {RATE}.",
    rf"Let $b=0$. Then it is periodic. Actually this holds always: {RATE}.",
    rf"Let $b=0$. Then it is periodic. The restriction to $b=0$ is immaterial, {RATE}.",
    rf"Let $b=0$. Then it is periodic. If the wind is strong, {RATE}.",
    rf"Let $b=0$. Then it is periodic. В противном случае {RATE}.",
    rf"Let $b=0$. Then it is periodic. При наличии трения {RATE}.",
    rf"Let $b=0$. Then it is periodic. Nun sei Reibung vorhanden. Dann ist {RATE}.",
    rf"Let $b=0$. Then it is periodic. Andernfalls ist {RATE}.",
    rf"Let $b=0$. Then it is periodic. Avec frottement, on a {RATE}.",
    rf"Let $b=0$. Then it is periodic. Sinon, {RATE}.",
]  # fmt: skip


@pytest.mark.parametrize(
    ("words", "lasts"), sampled([*((w, True) for w in LASTING), *((w, False) for w in LIFTED)], 8)
)
def test_what_was_supposed_proves_nothing_where_it_is_over(words, lasts):
    assert verdicts(DAMPED + words)[r"\dot H=0"].green == lasts


@pytest.mark.parametrize(
    ("rate", "green"), [(r"\dot H=-by^2", True), (r"\dot H=-2by^2", False), (r"\dot H=by^2", False)]
)
def test_a_formula_with_a_letter_is_not_said_where_that_is_zero(rate, green):
    assert (
        verdicts(rf"{DAMPED} Let $b=0$. Then ${RATE[1:-1]}$. We have ${rate}$.")[rate].green
        == green
    )


BODY = r"Euler's equations are $A\dot p=(B-C)qr$, $B\dot q=(C-A)rp$, $C\dot r=(A-B)pq$. "
APART = [
    "Let $A=B$; then $r$ is constant. Let now $A$, $B$, $C$ be different from each other. Then $r$ is a first integral.",
    "Suppose $A=B$; then $r$ is constant. Suppose now that $A$ and $B$ are unequal. Then $r$ is a first integral.",
    "Let $A=B$; then $r$ is constant. Let $A$ and $B$ be distinct. Then $r$ is a first integral.",
    "Пусть $A=B$; тогда $r$ постоянно. Пусть теперь $A$, $B$, $C$ различны. Тогда $r$ --- первый интеграл.",
    "Пусть $A=B$; тогда $r$ постоянно. Откажемся от этого условия. Тогда $r$ --- первый интеграл.",
]


@pytest.mark.parametrize("text", APART)
def test_letters_that_differ_are_equal_no_more(text):
    found = reading(BODY + text)
    outcomes = ReadingSession(found, timeout=20).outcomes
    assert [outcomes[f.claim.id].verdict.green for f in found.formulas if f.claim] == [True, False]


@pytest.mark.parametrize("pair", ["$B$ and $C$", "$A$ and $C$"])
def test_other_letters_that_differ_lift_nothing(pair):
    text = rf"Let $A=B$. Then the body is symmetric. Let {pair} be distinct. Then $r$ is a first integral."
    assert [one.green for one in verdicts(BODY + text).values()] == [True]


PARTED = r"""\section{First} The equations are \[\dot x=y+bx,\qquad\dot y=-x .\] WORDS Then $x^2+y^2$ is constant.
\section{Second} We have \[\ddot x=-x .\] """


@pytest.mark.parametrize(
    "words",
    [
        "In the rest of the paper let $b=0$.", "From now on let $b=0$.", "Throughout let $b=0$.",
        "We assume that $b=0$ from now on.", "Let $b=0$ throughout the paper.",
        "In what follows, $b=0$.", "В дальнейшем пусть $b=0$.", "Henceforth we put $b=0$.",
    ],
)  # fmt: skip
def test_what_is_supposed_of_all_that_follows_holds_in_later_sections(words):
    text = PARTED.replace("WORDS", words)
    assert [one.green for one in verdicts(text).values()] == [True, True]
    wrong = text.replace(r"\ddot x=-x", r"\ddot x=x")
    assert [one.green for one in verdicts(wrong).values()] == [True, False]
    other = text + r"\section{Third} Let $b=1$. The function $x^2+y^2+bx$ is an integral."
    assert not verdicts(other)["x^2+y^2+bx"].green


@pytest.mark.parametrize(
    "words",
    [
        "In the rest of this section let $b=0$.", "Now let $b=0$.", "Throughout this section $b=0$.",
        "Let $b=0$ throughout the proof.",
    ],
)  # fmt: skip
def test_what_is_supposed_in_a_section_ends_there(words):
    found = [*verdicts(PARTED.replace("WORDS", words)).values()]
    assert not found[-1].green
