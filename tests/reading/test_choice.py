"""What was not decided in time leaves a doubt, unless it fails where its hypotheses hold."""

import pytest

from kowalevski_cas.paper.derivation import Doubt
from kowalevski_cas.reading import choice, read
from kowalevski_cas.source.files import decode

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


@pytest.mark.parametrize(
    "text",
    [
        r"\[\dot r=p,\qquad\dot p=r.\] Let $r>0$. Then $p^2-r^2$ is an integral.",
        r"\[\dot x=y+\beta(x),\qquad\dot y=0.\] Then $y$ is an integral and $y=\dot x-\beta(x)$.",
        r"\[\dot x=y,\qquad\dot y=-x.\] We set $T=\frac{4\mathsf K(k)}{p}$. Then $x^2+y^2$ is "
        r"an integral, and $T=2$.",
    ],
)
def test_earlier_choices_are_known_again_whatever_else_is_printed(text):
    """So an audit that is done again redoes only what changed: also beside what cannot be read."""
    source = decode("paper.tex", (r"\begin{document}" + text + r"\end{document}").encode())
    choices: choice.Choices = {}
    first = read(source, choices=choices)
    known = {**choices}
    again = read(source, choices=choices)
    assert choices == known
    claims = [[f.claim and f.claim.id for f in found.formulas] for found in (first, again)]
    assert claims[0] == claims[1] == [f.claim and f.claim.id for f in read(source).formulas]
