"""Solutions that words name: each moves by the equation that they cite."""

import pytest

from tests.reading.test_reading import verdicts

HILL = r"Consider \begin{equation}\label{h}\ddot q+\omega^2(t)\,q=0,\end{equation} where $\omega(t)$ is a given function. "
DAMPED = r"Consider \begin{equation}\label{h}\ddot q+k\dot q+aq=0.\end{equation} "
CUBIC = r"Consider \begin{equation}\label{h}\ddot q+aq+bq^3=0.\end{equation} "
PAIR = r"Consider \begin{equation}\label{h}\dot q=p,\qquad\dot p=-q.\end{equation} "
LET = r"Let $u$ and $v$ be two independent solutions of \eqref{h}. "
CONSTANT = r"Then \[W=u\dot v-v\dot u\] is constant."


@pytest.mark.parametrize(
    "words",
    [
        LET,
        r"Let $u,v$ be any solutions of this equation. ",
        r"Пусть $u$ и $v$ --- два решения уравнения \eqref{h}. ",
    ],
)
def test_they_move_by_their_equation(words):
    assert all(one.green for one in verdicts(HILL + words + CONSTANT).values())
    for law in (DAMPED, CUBIC):
        assert not any(one.green for one in verdicts(law + words + CONSTANT).values())
    rate = r"Put $W=u\dot v-v\dot u$. Then \[\dot W=-kW.\]"
    assert verdicts(DAMPED + words + rate)[r"\dot W=-kW"].green


@pytest.mark.parametrize(
    "step",
    [
        r"Moreover, $u\dot u+v\dot v=\frac12\frac{d}{dt}(u^2+v^2)$.",
        r"Since $u\ddot v=v\ddot u$, this is plain.",
        r"Let $s=u^2+v^2$. Then $s\dot s=2s(u\dot u+v\dot v)$.",
    ],
)
def test_they_move_so_where_steps_with_their_rates_stand_behind(step):
    found = verdicts(HILL + LET + CONSTANT + step)
    assert found[r"W=u\dot v-v\dot u"].green
    wrong = CONSTANT.replace("-v", "+v")
    assert not any(
        one.green for key, one in verdicts(HILL + LET + wrong + step).items() if "W" in key
    )


@pytest.mark.parametrize(
    "text",
    [
        HILL + r"Let $u$ and $v$ be solutions of another equation. " + CONSTANT,
        HILL + r"Let $u$ and $v$ be no solutions of \eqref{h}. " + CONSTANT,
        HILL + r"Let $u$ and $v$ be approximate solutions of \eqref{h}. " + CONSTANT,
        HILL + r"Let $u$ and $v$ be solutions of the equation adjoint to \eqref{h}. " + CONSTANT,
        HILL + r"Put $u=q^2$. Let $u$ and $v$ be solutions of \eqref{h}. " + CONSTANT,
        HILL + LET + r"Then \[W=u\dot v+v\dot u\] is constant.",
        HILL + LET + r"Then \[\dot u^2+\omega^2u^2\] is constant.",
        PAIR + LET + CONSTANT,
    ],
)
def test_what_are_no_solutions_or_of_something_else_do_not(text):
    assert not any(one.green for one in verdicts(text).values())
