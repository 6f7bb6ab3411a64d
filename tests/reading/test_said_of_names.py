"""Names of which the words before them, or behind, say that they are integrals."""

import pytest

from tests.reading.test_reading import verdicts

FREE = r"The equations of motion are \begin{equation}\label{f} \dot x=u,\quad \dot y=v,\quad \dot u=0,\quad \dot v=-y . \end{equation} "


@pytest.mark.parametrize(
    ("words", "name", "green"),
    [
        (
            r"The function $xv-yu$ is no matter, but $u^2$ is an integral, and so is the momentum $u$.",
            "u",
            True,
        ),
        (r"The function $u^2$ is an integral, and so is the momentum $v$.", "v", False),
        (r"Первым интегралом является импульс $u$.", "u", True),
        (r"Первым интегралом является импульс $v$.", "v", False),
        (r"Тогда $u$ есть интеграл уравнений \eqref{f}.", "u", True),
        (r"Тогда $v$ есть интеграл уравнений \eqref{f}.", "v", False),
        (r"The function $u^2$ is conserved. So is $u$.", "u", True),
        (r"The function $u^2$ is conserved. So is $v$.", "v", False),
    ],
)
def test_a_name_is_called_an_integral(words, name, green):
    assert verdicts(FREE + words)[name].green is green


@pytest.mark.parametrize(
    "words",
    [
        "The function $v^2$ is not conserved. So is $u$.",
        "No function of $v$ is an integral. So is $u$.",
        "The function $u^2$ is positive. So is $u$.",
        "On the line $y=0$ the function $u^2$ is conserved. So is $u$.",
        "If $y=0$ initially, the function $u^2$ is conserved. So is $u$.",
    ],
)
def test_what_was_said_of_nothing_is_not_said_again(words):
    assert "u" not in verdicts(FREE + words)


@pytest.mark.parametrize(
    ("words", "green"),
    [
        (r"Hence we have the second constant \[K=v^2+y^2.\]", True),
        (r"Hence we have the second constant \[K=v^2-y^2.\]", False),
    ],
)
def test_a_further_constant_is_an_integral(words, green):
    assert (
        verdicts(FREE + words)[r"K=v^2\{}y^2".replace(r"\{}", "+" if green else "-")].green is green
    )


@pytest.mark.parametrize(
    ("words", "green"),
    [
        (r"The momentum $M=xv-yu$ is not conserved, for by \eqref{f} \[\dot M=-xy.\]", True),
        (r"Put $M=xv-yu$, $N=yv$. Neither is conserved, since \[\dot N=v^2-y^2.\]", True),
        (r"Импульс $M=xv-yu$ не сохраняется, так как $$\dot M=-xy.$$", True),
        (r"The momentum $M=xv-yu$ is not conserved, for by \eqref{f} \[\dot M=xy.\]", False),
        (r"Импульс $M=xv-yu$ не сохраняется, поскольку $$\dot M=x.$$", False),
    ],
)
def test_a_rate_is_why_something_is_not_conserved(words, green):
    (found,) = (
        one for tex, one in verdicts(FREE + words).items() if "dot" in tex and "M=xv" not in tex
    )
    assert found.green is green


@pytest.mark.parametrize(
    "words",
    [
        r"The momentum $M=xv-yu$ is not conserved, since \[\dot M=-xy\] is impossible.",
        r"The momentum $M=xv-yu$ is not conserved, as it is not true that \[\dot M=-xy.\]",
        r"Импульс $M=xv-yu$ не сохраняется. Величина $xv-yu$ не постоянна.",
    ],
)
def test_a_rate_that_is_denied_itself_is_no_reason(words):
    assert not verdicts(FREE + words)


def test_the_value_of_an_invariant_is_no_invariant_set():
    text = r"""Consider the map \[x'=y,\qquad y'=-x.\] The function $I=x^2+y^2$ is an invariant of the map.
    The value of the invariant is \[I=c-1\] there."""
    assert not any(one.green for tex, one in verdicts(text).items() if tex == "I=c-1")
