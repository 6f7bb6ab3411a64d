"""Equations by cases, and signs: each case is a claim, and together they cover everything."""

import random

import pytest

from kowalevski_cas import System
from tests.laws.test_prints import FEW
from tests.reading.test_reading import verdicts

pytestmark = pytest.mark.usefixtures("uncorrected")


def oscillator():
    return System(r"\dot x=y,\ \dot y=-x")


def by_cases(left, *rows):
    body = r"\\".join(f"{value},&{condition}" for value, condition in rows)
    return rf"{left}=\begin{{cases}}{body}\end{{cases}}"


@FEW
def test_each_case_holds_and_they_cover_everything(seed):
    chance = random.Random(seed)
    k, c = chance.randint(1, 3), chance.randint(-2, 2)
    f = rf"{k}x{c:+}" if chance.random() < 0.5 else rf"{k}x{c:+}y"
    above, below = chance.choice([(r"\ge", "<"), (">", r"\le"), (r"\geq", r"\leqslant")])
    ends = chance.choice([f"{f}{below} 0", r"\text{otherwise}", rf"\text{{if }}0{above}{f}"])
    system, first = oscillator(), (f, rf"{f}{above} 0")
    if "0" + above in ends and above == ">":
        ends = r"\text{else}"  # else nobody says what is where f vanishes
    assert system.identity(by_cases(f"|{f}|", first, (f"-({f})", ends))).verdict == "proved"
    wrong = by_cases(f"|{f}|", first, (f"-({f})+1", ends))
    assert system.identity(wrong).verdict == "refuted"
    assert (
        system.identity(by_cases(f"|{f}|", (f"-({f})", first[1]), (f, ends))).verdict == "refuted"
    )


@pytest.mark.parametrize("condition", ["x<0", r"x<-1", r"x\le-1"])
def test_cases_that_leave_something_out_are_no_equation(condition):
    claim = oscillator().identity(by_cases("|x|", ("x", "x>0"), ("-x", condition)))
    assert claim.verdict == "refuted"  # at zero, or between


def test_cases_on_a_set_cover_the_set():
    system = oscillator()
    cases = by_cases("y", ("2x", r"x\ge0"), ("-2x", "x<0"))
    assert system.implication(cases, given="y=2|x|").verdict == "proved"
    assert system.implication(cases, given="y=3|x|").verdict == "refuted"
    gap = system.identity(by_cases("|x|", ("x", "0<x<1"), ("-x", "x<0")))
    assert gap.verdict == "refuted"


@pytest.mark.parametrize("sign", [r"\operatorname{sign}", r"\mathrm{sgn}\,", r"\operatorname{sgn}"])
def test_a_sign_is_that_of_what_does_not_vanish(sign):
    system = oscillator()
    for true in (rf"|x|=x{sign}(x)", rf"({sign} x)^2=1", rf"{sign}(xy)={sign}(x){sign}(y)"):
        assert system.identity(true).verdict == "conditional", true
    for false in (rf"|x|=y{sign}(x)", rf"{sign} x=1", rf"{sign}(xy)=-{sign}(x){sign}(y)"):
        assert system.identity(false).verdict == "refuted", false
    assert system.identity(rf"\frac{{d}}{{dt}}|x|=y{sign}(x)").verdict == "conditional"


def test_absolute_values_and_signs_are_read_in_papers():
    text = (
        r"The equations of motion are $$\dot x=y,\qquad \dot y=-\operatorname{sgn}(x).$$ "
        r"The energy integral is $$\frac12y^2+%s|x|=h.$$"
    )
    (true,), (false,) = (verdicts(text % k).values() for k in ("", "2"))
    assert true == "conditional" and false == "refuted"


CHAINED = r"|k|=\begin{cases}k,&%s\\k,&%s\end{cases}"


@pytest.mark.parametrize("order", [("k>1", r"0<k\le1"), (r"0<k\le1", "k>1")])
def test_a_case_may_lie_between_two_ends_and_all_cover_what_is_supposed(order):
    positive = System(r"\dot x=-kx").where("k>0")
    assert positive.identity(CHAINED % order).verdict.green
    left_out = tuple(one.replace(r"\le1", "<1") for one in order)
    assert positive.identity(CHAINED % left_out).verdict == "refuted"
    assert not System(r"\dot x=-kx").identity(CHAINED % order).verdict.green


@FEW
def test_a_law_by_cases_is_a_law_in_each(seed):
    """A force −F on one side of a line and +F on the other has the power −F|f|."""
    chance = random.Random(seed)
    k = chance.randint(1, 3)
    f, at = chance.choice([("v", "v"), (f"{k}v-x", f"{k}v-x")])
    rows = [("-F", f"{at}>0"), ("+F", chance.choice([f"{at}<0", rf"\text{{if }}0>{at}"]))]
    chance.shuffle(rows)
    force = by_cases("", *rows).removeprefix("=")
    law = System(rf"\dot x=v,\quad\dot v=-{k}x+{force}")
    energy = rf"\frac{{d}}{{dt}}\left(\frac{{v^2+{k}x^2}}2\right)"
    sign = rf"\operatorname{{sign}}({f})"
    assert law.identity(rf"{energy}=-Fv{sign}").verdict.green
    assert law.identity(rf"{energy}=Fv{sign}").verdict == "refuted"
    assert law.identity(rf"{energy}=-Fv").verdict == "refuted"  # in one of the cases
    assert law.integral(rf"v^2+{k}x^2").verdict == "refuted"


def test_what_is_left_by_the_cases_of_a_law_is_a_case():
    law = System(r"\dot x=\begin{cases}1,&0<x<1\\-1,&\text{otherwise}\end{cases},\quad \dot y=1")
    assert len(law.parts) == 3
    assert law.identity(r"\dot x^2=1").verdict == "proved"
    assert law.identity(r"\dot x=1").verdict == "refuted"
    assert law.identity(r"\dot x=-1").verdict == "refuted"
    with pytest.raises(ValueError, match="by cases"):
        law.invariant("x=0")  # a motion that leaves a case is another one


@pytest.mark.parametrize("rows", [r"\dot x&=y\\ \dot y&=-x", r"\dot x=y,\\ \dot y=-x"])
def test_a_brace_before_equations_is_no_case(rows):
    law = System(rf"\begin{{cases}}{rows}\end{{cases}}")
    assert not law.parts
    assert law.integral("x^2+y^2").verdict == "proved"
