"""What was not decided in time leaves a doubt, unless it fails where its hypotheses hold."""

import pytest

from kowalevski_cas.paper.derivation import Doubt
from kowalevski_cas.reading import choice

from .test_reading import reading

TEXT = r"""The motion is given by \[ \dot x=y,\qquad \dot y=-x . \] On the set
\begin{equation}\label{set} x=1 \end{equation}
it is easy to see. From (\ref{set}) it follows that \[ xy=RIGHT . \]"""


@pytest.mark.parametrize(("right", "left_open"), [("y", True), ("2y", False)])
def test_what_fails_at_points_is_not_left_open(monkeypatch, right, left_open):
    def overdue(_):
        raise TimeoutError

    monkeypatch.setattr(choice.Statement, "holds", overdue)
    found = reading(TEXT.replace("RIGHT", right)).formulas[-1]
    assert (found.message == choice.OVERDUE) is left_open
    assert found.doubt is Doubt.ALWAYS or not left_open
