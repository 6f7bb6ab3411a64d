r"""Variations :math:`\delta x` are names, and their equations of motion follow from the law."""

import pytest

from tests.reading.test_reading import reading, verdicts

WELL = r"The equations of motion are \[\dot q=p,\qquad \dot p=-aq-bq^3 .\] "
SWING = r"The equation of motion is \[\ddot\chi=-n\sin\chi .\] "
OF_WELL = r"The equations of the variations are \[\dot{\delta q}=\delta p,\quad \dot{\delta p}=-(a+3bq^2)\delta q .\] "


@pytest.mark.parametrize(
    ("rows", "true"),
    [
        (r"\dot{\delta q}=\delta p,\quad \dot{\delta p}=-(a+3bq^2)\delta q", True),
        (r"\dot{\delta q}=\delta p,\quad \dot{\delta p}=-(a+bq^2)\delta q", False),
        (r"\dot{\delta q}=\delta p,\quad \dot{\delta p}=-(a+3bq)\delta q", False),
        (r"\frac{d\,\delta q}{dt}=\delta p,\quad \frac{d\,\delta p}{dt}=-(a+3bq^2)\,\delta q", True),
        (r"\frac{d}{dt}\delta q=\delta p,\quad \frac{d\,\delta p}{dt}=(a+3bq^2)\,\delta q", False),
        (r"\dot{\Delta q}=\Delta p,\quad \dot{\Delta p}=-(a+3bq^2)\Delta q", True),
        (r"\delta\dot q=\delta p,\quad \dot{\delta p}=-(a+3bq^2)\delta q", True),
    ],
)  # fmt: skip
def test_the_equations_of_variations_are_claims(rows, true):
    found = verdicts(WELL + rf"The equations of the variations are \[{rows} .\]")
    assert len(found) == 2
    assert all(one.green for one in found.values()) is true


@pytest.mark.parametrize(
    ("row", "true"),
    [
        (r"\ddot{\delta\chi}=-n\cos\chi\,\delta\chi", True),
        (r"\ddot{\delta\chi}=-n\sin\chi\,\delta\chi", False),
        (r"\ddot{\delta\chi}=-n\,\delta\chi", False),
    ],
)
def test_of_the_second_order(row, true):
    assert [one.green for one in verdicts(SWING + rf"We have \[{row} .\]").values()] == [true]


@pytest.mark.parametrize(("factor", "true"), [("a q+b q^3", True), ("a q+3b q^2", False)])
def test_what_is_claimed_of_variations_is_proved_by_these(factor, true):
    found = verdicts(
        WELL + OF_WELL + rf"Then \[ p\,\delta p+({factor})\delta q=\mathrm{{const}} .\]"
    )
    assert [*found.values()][-1].green is true


def test_what_is_varied_near_one_motion_is_not_red():
    text = r"For motions near $q=0$ we have \[\dot{\delta q}=\delta p,\quad \dot{\delta p}=-a\delta q .\]"
    assert not any(one.value == "refuted" for one in verdicts(WELL + text).values())


@pytest.mark.parametrize(
    "text",
    [
        r"The equation is \[\ddot u=-u-\delta\dot u .\] With $\dot{\delta u}$ we have $\dot E=0$.",
        r"The equation is \[\ddot u=-u-\delta u^3 .\] Let $\delta>0$. The rate of $\dot{\delta u}$ is large.",
        r"The equation is \[\ddot u=-u-\delta u^3 .\]",
    ],
)
def test_a_number_varies_nothing(text):
    (law,) = reading(text).parts.laws
    assert law.variables == ("u",)
    assert r"\delta" in law.mentions


BOOST = r"""Two events lie apart by $\Delta\xi$ and $\Delta\tau$. For another observer
\[\Delta\xi'=\kappa(\Delta\xi-w\Delta\tau),\quad \Delta\tau'=\kappa(\Delta\tau-w\Delta\xi),\quad
\kappa=\frac1{\sqrt{1-w^2}} .\] """


@pytest.mark.parametrize(
    ("claimed", "true"),
    [
        (r"\Delta\tau'^2-\Delta\xi'^2=\Delta\tau^2-\Delta\xi^2", True),
        (r"\Delta\tau'^2-\Delta\xi'^2=\kappa^2(1-w^2)(\Delta\tau^2-\Delta\xi^2)", True),
        (r"\Delta\tau'^2+\Delta\xi'^2=\Delta\tau^2-\Delta\xi^2", False),
        (r"\Delta\tau'^2-\Delta\xi'^2=\Delta\tau^2-\Delta\xi", False),
        (r"\Delta\tau'^2-\Delta\xi'^2=\kappa(\Delta\tau^2-\Delta\xi^2)", False),
    ],
)
def test_a_difference_is_one_name_and_its_power_that_of_all(claimed, true):
    found = verdicts(BOOST + rf"Indeed \[{claimed} .\]")
    assert [one.green for one in found.values()] == [true]


@pytest.mark.parametrize("letters", [r"$\xi$ and $\tau$", r"$\xi$, $\tau$ and $\Delta$"])
def test_a_power_that_may_be_of_a_difference_is_not_red(letters):
    text = BOOST + rf"The letters are {letters}. Indeed "
    found = verdicts(text + r"\[\Delta\tau'^2-\Delta\xi'^2=\Delta\tau^2-\Delta\xi^2 .\]")
    assert not any(one.value == "refuted" for one in found.values())


@pytest.mark.parametrize(("factor", "true"), [("", True), ("2", False)])
def test_a_number_before_letters_that_stand_alone_is_a_number(factor, true):
    law = r"The equation is \[\ddot u=-u-\Delta u^3 .\] "
    text = law + rf"The energy $E=\dot u^2+u^2+\frac{{{factor or 1}}}2\Delta u^4$ is conserved."
    assert [one.green for one in verdicts(text).values()] == [true]
