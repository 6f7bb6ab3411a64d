"""Names that are given once more: one more integral may have the letter of another one."""

import pytest

from tests.reading.test_reading import verdicts

SOLID = r"""The equations are \[\dot x=ayz,\qquad \dot y=bzx,\qquad \dot z=cxy,\qquad \dot w=(a-b)w .\]
\section{A special case} If $a=b$, the function $F=w$ is an integral.
\section{The general case} WORDS \[F=bx^2-ay^2 .\]"""


@pytest.mark.parametrize(
    "words",
    [
        "There is the integral",
        "The equations have the additional integral",
        "We look for a further integral:",
        "Имеется ещё один интеграл",
    ],
)
def test_one_more_integral_may_have_the_letter_of_another_one(words):
    text = SOLID.replace("WORDS", words)
    assert [one.green for one in verdicts(text).values()] == [True, True]
    wrong = text.replace("bx^2-ay^2", "bx^2+ay^2")
    assert [one.green for one in verdicts(wrong).values()] == [True, False]


@pytest.mark.parametrize(
    "words", ["In other letters the integral is", "This integral takes the form"]
)
def test_the_same_integral_is_given_no_other_value(words):
    text = SOLID.replace("$F=w$", "$F=bx^2-ay^2$").replace("[F=bx^2", "[F=2bx^2")
    assert not [*verdicts(text.replace("WORDS", words)).values()][-1].green
