"""What is said to be so, too, and what words say more of a claim than is judged of it."""

import pytest

from tests.audit.test_doubted import audited
from tests.reading.test_reading import reading
from tests.sample import sampled

EULER = r"Consider the equations $\dot p=(b-c)qr$, $\dot q=(c-a)rp$, $\dot r=(a-b)pq$. "
SQUARES, MOMENTUM, OTHER = "$p^2+q^2+r^2$", "$ap^2+bq^2+cr^2$", "$p^2+q^2-r^2$"


def verdicts(words):
    return [one.verdict for one in audited(EULER + words).formulas if one.role == "claim"]


AGAIN = [
    "The function SQUARES is an integral, and so is AGAIN.",
    "The function SQUARES is an integral, likewise AGAIN.",
    "The function SQUARES is an integral, and AGAIN is one as well.",
    "The function SQUARES is constant, and thus also AGAIN.",
    "The functions SQUARES is an integral, AGAIN too.",
    "SQUARES does not change, nor does AGAIN.",
    r"The function SQUARES is an integral.\footnote{And so is AGAIN.}",
    "The function SQUARES does not change. Neither does AGAIN.",
    "Функция SQUARES постоянна, AGAIN тоже.",
]


@pytest.mark.parametrize("words", sampled(AGAIN, 3))
def test_what_is_an_integral_too_is_claimed(words):
    said = words.replace("SQUARES", SQUARES)
    assert verdicts(said.replace("AGAIN", MOMENTUM)) == ["proved"] * 2
    first, second = verdicts(said.replace("AGAIN", OTHER))
    assert first == "proved" and second in ("refuted", "undecided")


def test_a_name_is_one_as_well():
    said = "The function SQUARES is an integral, and if $a=b$, $r$ is one as well."
    assert verdicts(said.replace("SQUARES", SQUARES)) == ["proved"] * 2
    said = said.replace("a=b", "a=c").replace("SQUARES", SQUARES)
    assert verdicts(said)[1] != "proved"


@pytest.mark.parametrize(
    "words",
    [
        f"If {SQUARES} is constant, so is {OTHER}.",
        f"The function {OTHER} is not an integral, {SQUARES} neither.",
        f"The function {OTHER} is not constant. So is {SQUARES}.",
    ],
)
def test_what_is_denied_or_supposed_is_not_so_again(words):
    assert "proved" not in verdicts(words) and "refuted" not in verdicts(words)


MORE = [
    f"Only if $a=b=c$ the function {MOMENTUM} is an integral.",
    f"Precisely for $a=b$ the function {SQUARES} is an integral.",
    f"The function {SQUARES} is an integral exactly when $a=b$.",
    f"The function {SQUARES} is an integral just in the case $a=b$.",
    f"The function {SQUARES} is an integral if, and only if, $a=b$.",
    f"The function {SQUARES} is an integral, provided that $a=b$, and otherwise not.",
    f"The function {SQUARES} is an integral on the level $p+q+r=0$ and nowhere else.",
    f"The function {SQUARES} is an integral for generic $a$ but not for all.",
    f"For almost no $a$ the function {SQUARES} is an integral.",
    f"Exactly one of the functions {SQUARES}, {MOMENTUM} is an integral.",
    f"Either {SQUARES} or {MOMENTUM} is an integral, but not both.",
    f"None of {SQUARES} and {MOMENTUM} is an integral.",
    f"The function {SQUARES} is merely an approximate integral.",
    f"The function {SQUARES} is conserved, but only on average.",
    f"The function {SQUARES} is an adiabatic invariant.",
    f"For $a<0$ the integral {SQUARES} becomes invalid.",
    f"{SQUARES} is constant for small $p$ only.",
    f"Лишь при $a=b$ функция {SQUARES} сохраняется.",
    f"Ровно одна из функций {SQUARES}, {MOMENTUM} является интегралом.",
]


@pytest.mark.parametrize("words", sampled(MORE, 4))
def test_what_says_more_than_is_judged_has_no_verdict(words):
    assert not {*verdicts(words)} & {"proved", "refuted", "conditional"}
    assert audited(EULER + words).uncovered


@pytest.mark.parametrize(
    "words",
    [
        f"Just for completeness we note that {SQUARES} is an integral.",
        f"The functions {SQUARES} and {MOMENTUM} are integrals; only the first one is needed.",
        f"The function {SQUARES} is an integral, and {MOMENTUM} is an integral only if $a=b$.",
        f"The function {SQUARES} is an integral and its levels are nice if and only if $a=b$.",
    ],
)
def test_what_is_said_of_something_else_says_no_more_of_it(words):
    assert verdicts(words)[0] == "proved"


@pytest.mark.parametrize(
    "words",
    [
        f"The function {SQUARES} is an integral, in contrast to {MOMENTUM}.",
        "If $a=b$, then $r$ is an integral, and conversely, if $r$ is one, then $b=c$.",
        "If $a=b$, then $r$ is an integral. This remains true for $a\\ne b$.",
        f"The function {SQUARES} is an integral, which is no longer true for $a\\ne b$.",
        f"В отличие от {SQUARES}, функция {MOMENTUM} является интегралом.",
    ],
)
def test_what_is_said_of_other_cases_is_listed_beside_the_claim(words):
    found = audited(EULER + words)
    assert found.uncovered and not any(one.verdict == "refuted" for one in found.formulas)


DAMPED = r"Let $\ddot x=-x-\varepsilon\dot x$. "
NEGLECTED = [
    r"If we ignore friction, $\dot x^2+x^2$ is conserved.",
    r"To zeroth order $\dot x^2+x^2$ is conserved.",
    r"We neglect $\varepsilon$. Then $\dot x^2+x^2$ is an integral.",
    r"We omit the damping. Then $\dot x^2+x^2$ is constant.",
    r"Пренебрежём трением. Тогда $\dot x^2+x^2$ сохраняется.",
]


@pytest.mark.parametrize("words", sampled(NEGLECTED, 2))
def test_what_holds_where_something_is_neglected_is_not_refuted(words):
    found = audited(DAMPED + words)
    assert [one.verdict for one in found.formulas if one.role == "claim"] == ["undecided"]


def test_what_cannot_be_neglected_is_there():
    for words in ("Friction cannot be neglected.", r"It holds.\footnote{We neglect friction.}"):
        found = audited(DAMPED + words + r" But $\dot x^2+x^2$ is constant.")
        assert any(one.verdict == "refuted" for one in found.formulas)


@pytest.mark.parametrize(
    "text",
    [
        r"Either $p^2+q^2+r^2$ or $p^2+q^2$ is an integral.",
        r"Hence either $p=0$, or $p^2+q^2=1$.",
        r"Поэтому либо $\dot p=q^2$, либо $\dot q=0$.",
    ],
)
def test_what_words_leave_open_is_not_judged(text):
    euler = r"Consider $\dot p=(b-c)qr$, $\dot q=(c-a)rp$, $\dot r=(a-b)pq$. "
    found = reading(euler + text)
    assert not [one for one in found.formulas if one.claim is not None]
