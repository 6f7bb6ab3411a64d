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
    ],
)
def test_a_name_is_called_an_integral(words, name, green):
    assert verdicts(FREE + words)[name].green is green


def test_the_value_of_an_invariant_is_no_invariant_set():
    text = r"""Consider the map \[x'=y,\qquad y'=-x.\] The function $I=x^2+y^2$ is an invariant of the map.
    The value of the invariant is \[I=c-1\] there."""
    assert not any(one.green for tex, one in verdicts(text).items() if tex == "I=c-1")
