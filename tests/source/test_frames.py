import pytest

from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import verdicts
from tests.source.test_macros import written

LAW = r"\[ \dot x=y,\qquad \dot y=-x . \] Then "


@pytest.mark.parametrize(
    ("text", "result"),
    [
        (r"$\boxed{x=1}$", "$x=1$"),
        (r"$2\boxed{a+b}$", "$2{a+b}$"),
        (r"\[ \fbox{$x=1$ on $y=2$} \]", r"\[ x=1\text{ on }y=2 \]"),
        (r"\framebox[3cm][c]{see \(x=1\)}", r"see \(x=1\)"),
        (r"\[ \fcolorbox{red}{white}{$x=1$} \]", r"\[ x=1 \]"),
        (r"\newcommand{\boxed}[1]{#1+1} $\boxed{x}$", "$x+1$"),
    ],
)
def test_a_frame_is_left_out(text, result):
    assert written(text) == result


@pytest.mark.parametrize(
    "frame",
    [
        r"\[ \boxed{\;%s\;} \]",
        r"\begin{equation} \fbox{$\displaystyle %s$} \end{equation}",
        r"\[ \framebox[4cm][c]{$%s$}. \]",
        r"$\colorbox{yellow}{$%s$}$.",
    ],
)
@pytest.mark.parametrize(
    ("claim", "verdict"), [(r"\ddot x+x=0", Verdict.PROVED), (r"\ddot x+4x=0", Verdict.REFUTED)]
)
def test_a_formula_in_a_frame_is_judged(frame, claim, verdict):
    assert [*verdicts(LAW + frame % claim).values()] == [verdict]
