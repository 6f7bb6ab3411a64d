"""Names that integrals give: in a list of what is spoken of before, or the letter of another one."""

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


TOP = r"The equations are \[\dot u=vw,\qquad \dot v=wu,\qquad \dot w=uv .\] "
LISTED = r" \begin{align}F&=u^2-v^2,\\ G&=v^2SIGNw^2 .\end{align}"


@pytest.mark.parametrize(
    "words",
    [
        "There are two integrals. They are",
        "Hence two quantities are conserved. Explicitly,",
        "The system has two integrals. In detail,",
        "Имеются два интеграла. В явном виде",
    ],
)
@pytest.mark.parametrize("sign", "-+")
def test_what_is_printed_in_full_is_what_the_sentence_before_calls_integrals(words, sign):
    found = verdicts(TOP + words + LISTED.replace("SIGN", sign))
    assert [one.green for one in found.values()] == [True, sign == "-"]


@pytest.mark.parametrize(
    "words",
    [
        "Two quantities are not conserved. They are",
        "If the body is symmetric two quantities are conserved. Explicitly,",
        "There are two integrals. We use the letters",
    ],
)
def test_what_is_denied_or_supposed_there_is_not_claimed_here(words):
    assert not verdicts(TOP + words + LISTED.replace("SIGN", "+"))
