"""Rates of coordinates of which no equation says how they move: they are right for any motion."""

import pytest

from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import reading, roles, verdicts

POLAR = r"The point has the coordinates \[ X=\rho\cos\chi,\qquad Y=\rho\sin\chi . \] Then "


@pytest.mark.parametrize(
    ("rate", "green"),
    [(r"\dot\rho\cos\chi-\rho\dot\chi\sin\chi", True),
     (r"\dot\rho\cos\chi+\rho\dot\chi\sin\chi", False),
     (r"\dot\rho\cos\chi-\rho\dot\chi\cos\chi", False),
     (r"\dot\rho\cos\chi-\rho^2\dot\chi\sin\chi", False)],
)  # fmt: skip
def test_rates_of_what_coordinates_give_follow_from_theirs(rate, green):
    assert verdicts(POLAR + rf"\[ \dot X={rate} . \]")[rf"\dot X={rate}"].green is green


def test_a_kinetic_energy_is_the_same_in_both_coordinates():
    text = POLAR + r"\[ W=\tfrac12M(\dot X^2+\dot Y^2)=\tfrac12M(\dot\rho^2+%s\dot\chi^2) . \]"
    (true,) = verdicts(text % r"\rho^2").values()
    (false,) = verdicts(text % r"\rho").values()
    assert true.green
    assert not false.green


def test_what_a_rate_gives_is_derived_once_more():
    text = r"Let \[ v=\dot s+b s . \] Then \[ \dot v=\ddot s+b\dot s,\quad \dot v=\ddot s+bs . \]"
    found = verdicts(text)
    assert found[r"\dot v=\ddot s+b\dot s"].green
    assert not found[r"\dot v=\ddot s+bs"].green


@pytest.mark.parametrize(
    "row",
    [r"\ddot\chi=-w^2\sin\chi", r"\ddot X=-w^2X", r"\dot\rho=0", r"\dot\chi=\dot\rho", r"\dot\chi^2=w"],
)  # fmt: skip
def test_what_may_be_a_law_of_motion_is_not_judged(row):
    found = reading(
        POLAR + rf"we find by the theorem \[ f(\chi)+\dot\rho^2+\dot\chi^2, \] \[ {row} . \]"
    )
    claims = [
        f for f in found.formulas if f.claim is not None and f.item.printed.tex.startswith(row)
    ]
    assert not claims


def test_nothing_is_constant_for_any_motion():
    found = verdicts(
        POLAR + r"\[ \dot X=\dot\rho\cos\chi-\rho\dot\chi\sin\chi . \] $\dot\rho$ is constant."
    )
    assert list(found) == [r"\dot X=\dot\rho\cos\chi-\rho\dot\chi\sin\chi"]


def test_with_a_law_nothing_else_moves():
    text = r"The motion is $\ddot u=-u$. Put $P=u\dot w$. Then \[ \dot P=\dot u\dot w+u\ddot w . \]"
    assert not any(verdict.green for verdict in verdicts(text).values())


def test_a_vector_may_move_in_any_way():
    text = r"Put $s=\sqrt{1+\mathbf V^2/C^2}$. Then \[ \dot s=\frac{\mathbf V\cdot\dot{\mathbf V}}{%s} . \]"
    (true,) = verdicts(text % "C^2s").values()
    (false,) = verdicts(text % "C^2").values()
    assert true.green
    assert not false.green
    assert false is not Verdict.ERROR


def test_the_reason_is_told():
    text = POLAR + r"\[ \dot X=\dot\rho\cos\chi-\rho\dot\chi\sin\chi . \]"
    assert list(roles(text).values()).count("convention") == 2
