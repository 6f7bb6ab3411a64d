"""Inequalities that are found, not supposed, and cases that one sentence tells apart."""

import pytest

from kowalevski_cas.reading import ASSUMPTION, CLAIM
from tests.reading.test_restated import reading, verdicts

ROD = r"The equation of motion is \[ \ddot q=-cq. \] Let $p=c^2+g^2$ and $s=c+g$."


def role(text, tex):
    found = reading(ROD + text).formulas
    return next(one.role.name for one in found if one.item.printed.tex.strip() == tex)


@pytest.mark.parametrize(
    "words",
    [
        "Therefore",
        "Therefore all roots are real,",
        "We see that",
        "It follows that",
        "It is clear that",
        "Отсюда видно, что",
        "Следовательно,",
    ],
)
def test_what_is_found_is_claimed(words):
    assert role(f" {words} $p\\ge0$.", r"p\ge0") == CLAIM


@pytest.mark.parametrize(
    "words",
    [
        "Suppose that",
        "Let us assume that",
        "Therefore, for",
        "Hence we suppose that",
        "provided that",
        "Пусть",
        "Предположим, что",
    ],
)
def test_what_is_supposed_is_not(words):
    assert role(f" {words} $p\\ge0$.", r"p\ge0") == ASSUMPTION


def test_what_is_found_is_judged_and_no_hypothesis_of_what_follows():
    found = verdicts(ROD + r" We see that $s>0$. Then $p+\sqrt{s^2}=p+s$.")
    assert found["s>0"] == "UNDECIDED"
    assert found[r"p+\sqrt{s^2}=p+s"] == "UNDECIDED"


CASES = r" For $c>0$ it is a centre, while for $c<0$ it is a saddle. Then \[ FORMULA \]"


def test_cases_that_a_sentence_tells_apart_are_over_with_it():
    found = verdicts(ROD + CASES.replace("FORMULA", r"\sqrt{c^2}=-c"))
    assert found[r"\sqrt{c^2}=-c"] == "UNDECIDED"
    found = verdicts(ROD + CASES.replace("FORMULA", r"p-s^2=-2cg"))
    assert found["p-s^2=-2cg"] == "PROVED"


def test_each_case_is_in_force_in_its_own_clause():
    text = r" For $c>0$ we have $\sqrt{c^2}=c$, while for $c<0$ we have $\sqrt{c^2}=-c$."
    assert {*verdicts(ROD + text).values()} == {"PROVED"}
    wrong = r" For $c>0$ we have $\sqrt{c^2}=-c$, while for $c<0$ we have $\sqrt{c^2}=c$."
    assert not {"PROVED", "CONDITIONAL"} & {*verdicts(ROD + wrong).values()}


def test_one_case_goes_on_to_the_end_of_its_section():
    found = verdicts(ROD + r" Let $c>0$. Then $\sqrt{c^2}=c$.")
    assert found[r"\sqrt{c^2}=c"] == "PROVED"


@pytest.mark.parametrize("total, verdict", [("2c", "PROVED"), ("c", "UNDECIDED")])
def test_a_constant_is_not_given_by_what_it_defines(total, verdict):
    text = rf" Put $a_1=c+g$ and $a_2=c-g$. Obviously \[ a_1+a_2={total},\qquad a_1a_2=c^2-g^2. \]"
    found = verdicts(ROD + text)
    assert found[f"a_1+a_2={total}"] == verdict
    assert found["a_1a_2=c^2-g^2"] == "PROVED"


def test_a_supposition_that_a_number_fulfils_says_nothing():
    found = verdicts(ROD + r" Let $\sigma=c+g$, $\sigma>0$. Put $c=g=1$. Then \[ p+s=4. \]")
    assert found["p+s=4"] == "PROVED"


def test_what_is_found_may_hold_where_nothing_degenerates():
    text = r""" Let $c>0$. Put $k=\frac{A^2}{2(c+A^2)}$. We see that $0<k<\frac12$, and $2k(c+A^2)=A^2$."""
    found = verdicts(ROD + text, timeout=60)
    assert found[r"0<k<\frac12"] == "UNDECIDED"
