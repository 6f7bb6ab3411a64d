r"""Another time, as differentials give it: rates by it are those by t, times dt by d\tau."""

from random import Random

import pytest

from tests.laws.falsehoods import Maker
from tests.laws.test_readings import law_of, outcomes_of
from tests.reading.test_reading import reading, verdicts
from tests.sample import sampled

pytestmark = pytest.mark.usefixtures("uncorrected", "here")

CLOCKS = (
    (r"dt=({})\,d\tau", "({})({})"),
    (r"d\tau=\frac{{dt}}{{{}}}", "({})({})"),
    (r"d\tau=({})\,dt", r"\frac{{{1}}}{{{0}}}"),
    (r"\frac{{dt}}{{d\tau}}={}", "({})({})"),
)
"""How the other time is printed by a function, and a rate by it, by that and the rate by t."""


@pytest.mark.parametrize("seed", sampled(range(24), 4))
def test_rates_by_another_time_are_those_by_this_one_times_a_function(seed):
    random, make = Random(seed), Maker(seed)
    motion, factor = make.motion(), make.zero_at(make.point())
    printed, rated = CLOCKS[seed % len(CLOCKS)]
    left = random.choice([r"\frac{dx}{d\tau}", "x'"])
    rate = rated.format(factor.tex, motion[0].tex)
    text = (
        law_of(motion) + rf"Introduce another time $\tau$ by \[ {printed.format(factor.tex)} . \] "
    )
    (_, true), (_, false) = outcomes_of(
        rf"{text} Then \[ {left}={rate},\qquad {left}={rate}+7 . \]"
    )
    assert true.verdict.green and str(true.verdict) == "conditional", text
    assert not false.verdict.green, text


LAW = r"The equations are \[ \dot x=y,\qquad \dot y=-x . \] "


def test_a_second_rate_by_another_time_derives_its_function_too():
    found = verdicts(LAW + r"Let $dt=x\,d\tau$. Then \[ x''=xy^2-x^3,\qquad x''=-x^3 . \]")
    assert [one.green for one in found.values()] == [True, False]


def test_of_two_changes_of_the_time_the_last_holds():
    text = LAW + r"Let $dt=x\,d\tau$. Then \[ x'=xy . \] Let $dt=y\,d\tau$. Then \[ x'=y^2 . \]"
    assert [one.green for one in verdicts(text).values()] == [True, True]


def test_a_derivative_by_what_is_no_other_time_is_not_judged():
    found = reading(LAW + r"Let $dt=x\,d\tau$. Then \[ \frac{dx}{ds}=xy . \]")
    assert found.formulas[-1].claim is None
