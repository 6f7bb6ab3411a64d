"""Coordinates that equations give together, as a heading and the next sentence say."""

import pytest

from tests.reading.test_reading import roles, verdicts

PLANE = r"The point obeys \[\ddot u=-au,\qquad\ddot v=-av.\] "
GIVEN = r"\[u-v=s\sin\psi,\qquad u+v=s\cos\psi.\]"
TITLES = [
    (r"\section{New coordinates} Introduce " + GIVEN, "In these coordinates"),
    (r"\section{Change of variables} We introduce " + GIVEN, r"\begin{lemma} In these variables"),
    (r"\section{Новые переменные} Введём " + GIVEN, "В этих переменных"),
]


@pytest.mark.slow
@pytest.mark.parametrize(("given", "then"), TITLES)
@pytest.mark.parametrize(
    ("claim", "green"),
    [
        (r"u^2+v^2=\frac12s^2", True),
        (r"\dot u^2+\dot v^2=\frac12(\dot s^2+s^2\dot\psi^2)", True),
        (r"u^2+v^2=s^2", False),
        (r"\ddot\psi=0", False),
    ],
)
def test_what_they_give_is_claimed_of_the_motion(given, then, claim, green):
    assert verdicts(PLANE + given + rf"{then} \[{claim}.\]")[claim].green is green


@pytest.mark.parametrize(
    "text",
    [
        r"\section{Levels} Introduce " + GIVEN + " In these variables ",
        r"\section{New coordinates} Suppose " + GIVEN + " In these coordinates ",
        r"\section{New coordinates} Introduce " + GIVEN + " In all of them ",
    ],
)
def test_where_nothing_calls_them_coordinates_they_are_none(text):
    assert not any(
        one.green for one in verdicts(PLANE + text + r"\[u^2+v^2=\frac12s^2.\]").values()
    )


@pytest.mark.parametrize(
    ("words", "role"),
    [
        ("is the energy, then", "definition"),
        ("denotes the energy, then", "definition"),
        ("is constant, then", "assumption"),
        ("is the same, then", "assumption"),
    ],
)
def test_what_is_only_called_by_a_word_is_no_condition(words, role):
    found = roles(PLANE + rf"If $E=\dot u^2+\dot v^2$ {words} \[\dot E=-2a(u\dot u+v\dot v).\]")
    assert found[r"E=\dot u^2+\dot v^2"] == role
