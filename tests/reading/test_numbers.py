"""Formulas are cited by the numbers that TeX prints."""

import pytest

from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import reading, verdicts
from tests.sample import sampled

LAW = r"The motion is \begin{equation}\dot x=xy,\quad \dot y=x^2-y^2.\end{equation} "
SET = r"Consider also \begin{equation}x=0\end{equation} and \begin{equation*}y>0.\end{equation*} "


def numbers(text):
    found = reading(text).paper.labels
    return {number: items[0].printed.tex.strip(" ,.") for number, items in found.items() if items}


def test_displays_are_counted_as_tex_does():
    rows = r"\begin{eqnarray}a&=&1,\nonumber\\ b&=&2,\\ c&=&3\nonumber\end{eqnarray}\begin{align}d&=4,\\ e_1&=5\end{align}"
    found = numbers(r"\section{A} \[z=0\] " + LAW + rows)
    assert found == {"1": r"\dot x=xy", "2": "a&=&1", "3": "d&=4", "4": "e_1&=5"}


@pytest.mark.parametrize(
    "preamble",
    [
        r"\numberwithin{equation}{section}",
        r"\renewcommand{\theequation}{\thesection.\arabic{equation}}",
    ],
)
def test_numbers_may_begin_anew_in_each_section(preamble):
    reset = "" if "within" in preamble else r"\setcounter{equation}{0}"
    text = preamble + r"\section{A} " + LAW + SET + rf"\section{{B}}{reset}" + SET
    assert [*numbers(text)] == ["1.1", "1.2", "2.1"]


def test_numbers_of_the_author_go_before():
    assert numbers(LAW + r"$$z=0 \eqno(7)$$") == {"7": "z=0"}
    assert [*numbers(LAW + r"\begin{equation}z=0 \tag{A}\end{equation}" + SET)] == ["A", "1", "2"]


@pytest.mark.slow
def test_what_is_cited_by_a_number_can_be_supposed():
    text = r"\section{A} " + LAW + SET + r"\section{B} By (2) we have "
    claimed = r"\begin{equation}\dot y=-y^2.\end{equation}"
    assert (
        verdicts(text + claimed)[r"\dot y=-y^2"] is Verdict.CONDITIONAL
        or verdicts(text + claimed)[r"\dot y=-y^2"].green
    )
    other = text.replace("By (2)", "By (1)") + claimed
    assert not verdicts(other)[r"\dot y=-y^2"].green


@pytest.mark.parametrize("listed", sampled(["(2)", "We show: (2)", "We show a thing; (2)"], 1))
def test_what_counts_a_list_cites_nothing(listed):
    text = r"\section{A} " + LAW + SET + rf"\section{{B}} {listed} it is true that "
    assert not verdicts(text + r"\begin{equation}\dot y=-y^2.\end{equation}")[r"\dot y=-y^2"].green


def test_a_law_may_stand_in_a_line_of_text():
    text = r"\section{A} A pendulum obeys the equation $\ddot\theta=-k\sin\theta$. "
    found = verdicts(text + r"The energy $$h=\dot\theta^2-2k\cos\theta$$ is an integral.")
    assert {*found.values()} == {Verdict.PROVED}


def test_what_rests_on_an_unreadable_definition_is_not_judged():
    text = r"\section{A} " + LAW + r"Put \[F=x\oint y+1.\] Then \[\dot x=xF-x^2.\]"
    assert verdicts(text) == {}
