"""Casimir functions of printed brackets, where no equation says how anything moves."""

import pytest

from kowalevski_cas.audit.reading import ReadingSession
from kowalevski_cas.paper.claims import Casimir
from tests.reading.test_reading import reading, verdicts

BRACKETS = r"We define \[ \{x,y\}=z,\quad\{y,z\}=x,\quad\{z,x\}=y. \] "


def of_casimirs(text):
    found = reading(text)
    outcomes = ReadingSession(found, timeout=5).outcomes
    claims = [one.claim for one in found.statements if isinstance(one.claim, Casimir)]
    return [outcomes[claim.id].verdict.green for claim in claims]


@pytest.mark.parametrize(
    "words",
    [
        "The function $§$ is a Casimir function.",
        "The Casimir function of the bracket is $§$.",
        "Let $C=§$. Then $C$ is a Casimir.",
        "Функции Казимира: $§$.",
    ],
)
def test_a_casimir_function_needs_no_motion(words):
    assert of_casimirs(BRACKETS + words.replace("§", "x^2+y^2+z^2")) == [True]
    assert of_casimirs(BRACKETS + words.replace("§", "x^2+y^2-z^2")) == [False]


TWO = (
    r"\section{Body} "
    + BRACKETS
    + r"""Let \[ H=\frac12(ax^2+by^2+cz^2). \] The equations \[ \dot x=\{x,H\},\quad
    \dot y=\{y,H\},\quad\dot z=\{z,H\} \] give \[ \dot x=§yz. \]
    \section{Vector} We add \[ \{x,u\}=0,\quad\{y,u\}=-w,\quad\{z,u\}=v,\quad\{u,v\}=0. \]"""
)


@pytest.mark.parametrize(("factor", "green"), [("(b-c)", True), ("(c-b)", False)])
def test_brackets_of_a_later_section_are_none_of_an_earlier_one(factor, green):
    text = TWO.replace("§", factor)
    assert verdicts(text)[rf"\dot x={factor}yz"].green == green
