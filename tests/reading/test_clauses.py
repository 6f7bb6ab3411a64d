"""Which conditions of a sentence are those of which claims."""

import pytest

from kowalevski_cas.audit.reading import ReadingSession
from tests.sample import sampled

from .test_reading import reading

LAW = r"""
\section{A point} It moves by
\begin{equation}\dot x=y+ax,\quad\dot y=-x+by,\quad\dot z=cz.\end{equation}
"""

CIRCLE = "$x^2+y^2$"


def verdicts(sentences):
    """The verdict of each claim, with the assumptions on which it rests."""
    found = reading(LAW + sentences)
    outcomes = ReadingSession(found, timeout=20).outcomes
    return [
        (str(outcomes[one.claim.id].verdict), [on.printed.tex for on in one.on])
        for one in found.formulas
        if one.claim is not None
    ]


@pytest.mark.parametrize(
    ("sentences", "expected"),
    sampled(
        [
            ("The function $z$ is an integral if $c=0$.", [("proved", ["c=0"])]),
            ("The function $z$ is an integral when $c=1$.", [("refuted", ["c=1"])]),
            (
                r"Here $\dot z=0$ provided that $c=0$. Here $\dot z=0$ for $c=2$.",
                [("proved", ["c=0"]), ("refuted", ["c=2"])],
            ),
            (
                "$z$ is conserved if $c=0$, and the function $zx^2$ is conserved if $a=0$.",
                [("proved", ["c=0"]), ("undecided", ["a=0"])],
            ),
            (
                "If $c=0$, then $z$ is conserved, and if $a=0$ the function $z^2$ is conserved.",
                [("proved", ["c=0"]), ("undecided", ["a=0"])],
            ),
            (
                rf"The functions {CIRCLE} and $z^2$ are integrals when $a=0$, $b=0$ and $c=0$.",
                [("proved", ["a=0", "b=0", "c=0"])] * 2,
            ),
            ("Функция $z^2$ постоянна при $c=0$.", [("proved", ["c=0"])]),
            (
                "The function $z$ is an integral, and for $c=0$ it is the height.",
                [("undecided", [])],
            ),
        ],
        1,
    ),
)
def test_a_condition_is_one_of_the_claims_of_its_clause(sentences, expected):
    assert [(verdict, sorted(on)) for verdict, on in verdicts(sentences)] == expected


@pytest.mark.parametrize(
    "sentence",
    [
        rf"Except for $a=0$ the function {CIRCLE} is conserved.",
        rf"The function {CIRCLE} is conserved unless $a=0$.",
        rf"The function {CIRCLE} is conserved if and only if $a=0$.",
        rf"The function {CIRCLE} is conserved only for $a=0$.",
        rf"Neither $z$ nor {CIRCLE} is an integral.",
        rf"Кроме случая $a=0$, функция {CIRCLE} сохраняется.",
    ],
)
def test_what_is_said_with_exceptions_is_neither_green_nor_red(sentence):
    assert not [v for v, _ in verdicts(sentence) if v != "undecided"]


@pytest.mark.parametrize(
    ("sentence", "expected"),
    sampled(
        [
            ("Note that $2xy\\le x^2+y^2$.", ["proved"]),
            ("Note that $xy\\le-x^2-y^2$.", ["undecided"]),
            ("If $c>0$, the function $x^2+cz^2\\ge0$.", ["proved"]),
            ("Let $x>0$.", []),
        ],
        1,
    ),
)
def test_an_inequality_of_what_moves_is_claimed_unless_words_suppose_it(sentence, expected):
    assert [v for v, _ in verdicts(sentence)] == expected


@pytest.mark.parametrize(
    ("sentences", "expected"),
    [
        (
            "The function $z$ is an integral for $c=0$ and decreases for $c<0$.",
            [("proved", ["c=0"])],
        ),
        ("The function $z$ is constant if $c=0$, and grows if $c>0$.", [("proved", ["c=0"])]),
        ("$z$ is an integral for $c=0$ and for $c=2$.", []),  # each is a case
        ("$z$ is an integral for $c=2$ and for $c=0$.", []),
        ("$z$ is constant for $c=2$ and is constant for $c=0$.", []),
        ("$z$ is an integral for $c=2$ and remains one for $c=0$.", []),
        ("$z$ is an integral when $c=0$ but not when $c=1$.", []),
        ("When $c=1$, and not when $c=0$, the function $z$ is an integral.", []),
    ],
)
def test_a_condition_of_what_else_is_said_is_not_one_of_the_claim(sentences, expected):
    assert verdicts(sentences) == expected


@pytest.mark.parametrize("words", ["is arbitrary", "is now arbitrary", "is again arbitrary"])
def test_a_value_is_no_more_supposed_of_what_is_arbitrary(words):
    text = "Suppose $c=0$ for a moment. In what follows $c$ WORDS. The function $z$ is an integral."
    [(found, on)] = verdicts(text.replace("WORDS", words))
    assert found != "proved" and not on
    assert verdicts(text.replace("In what follows $c$ WORDS. ", "")) == [("proved", ["c=0"])]


RATES = r"Put $F=x^2+y^2$ and $G=z^2$. "


@pytest.mark.parametrize(
    ("sentence", "greens"),
    [
        (r"Then $\dot F=2(ax^2+by^2)$ and, if $c=0$, \[\dot G=0 .\]", ["proved", "proved"]),
        (r"Then $\dot F=2ax^2$ and, if $b=0$, \[\dot F=2ax^2 .\]", ["undecided", "proved"]),
        (
            r"If $c=0$, then $z$ is constant; otherwise $z$ is constant too.",
            ["proved", "undecided"],
        ),
        (r"Если $c=0$, то $z$ постоянно, иначе $z$ --- первый интеграл.", ["proved", "undecided"]),
        (r"If $c=0$, then $z$ is constant; otherwise $\dot z=cz$.", ["proved", "proved"]),
    ],
)
def test_a_condition_is_of_what_is_right_behind_it_and_of_nothing_otherwise(sentence, greens):
    assert [verdict for verdict, _ in verdicts(RATES + sentence)] == greens


@pytest.mark.parametrize(
    ("behind", "judged"),
    [
        ("; \\] they are distinct if and only if $c^2+12a>0$.", True),
        ("; \\] the points of rest are real if and only if $c^2+12a>0$.", True),
        ("; \\] this holds if and only if $a>0$.", False),
        (" \\] if and only if $a>0$.", False),
    ],
)
@pytest.mark.parametrize(("factor", "green"), [("3", True), ("2", False)])
def test_a_condition_behind_a_semicolon_is_of_its_own_clause(behind, judged, factor, green):
    text = r"The equation is \[ \ddot f=cf-3f^2+a . \] It follows that \[ \frac{d}{dt}(\dot f^2)="
    found = verdicts(rf"{text}2(cf-{factor}f^2+a)\dot f{behind}")
    assert [verdict in ("proved", "conditional") for verdict, _ in found] == [green] * judged
