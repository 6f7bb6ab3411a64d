"""What is printed in a display beside something that cannot be read is read, and judged."""

import pytest

from tests.reading.test_reading import verdicts

LAW = r"Consider \[\dot x=y,\qquad\dot y=-x.\] Then "


@pytest.mark.parametrize("unread", [r"\oint x\,dy=J", r"\lim_{t\to\infty}x=1"])
@pytest.mark.parametrize("rows", ["{},\\qquad {}", "{},\\quad 2x=x+x,\\quad {}"])
@pytest.mark.parametrize(("number", "green"), [("", True), ("2", False)])
def test_it_has_its_verdict(unread, rows, number, green):
    claim = rf"\frac{{d}}{{dt}}(x^2+{number}y^2)=0"
    for both in ([unread, claim], [claim, unread]):
        found = verdicts(rf"{LAW}\[{rows.format(*both)}.\]")
        assert found[claim].green is green


def test_what_cannot_be_read_itself_has_none():
    found = verdicts(LAW + r"\[x^2+y^2=h,\qquad \oint x\,dy=J.\] Hence $x^2=h-y^2$, $x^2=h+y^2$.")
    assert [one.green for one in found.values()] == [True, True, False]
