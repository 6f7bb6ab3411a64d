r"""Complex variables for which real letters are put: their conjugates are given by these, too."""

import pytest

from tests.reading.test_reading import verdicts

STARRED = r"The amplitude obeys \[\dot a=i\omega a+i\beta a^2a^* .\] "
MODULUS = r"The amplitude obeys \[\dot a=i\omega a+i\beta|a|^2a .\] "
LANDAU = r"The amplitude obeys \[\dot a=(\mu+i\omega)a-(1+i\beta)|a|^2a .\] "


@pytest.mark.parametrize(
    ("change", "rates"),
    [
        (r"Put $a=re^{i\varphi}$. Then", r"\dot r=0,\qquad\dot\varphi=\omega+\beta r^2"),
        (r"Put $a=\sqrt{I}\,e^{i\varphi}$. Then", r"\dot I=0,\qquad\dot\varphi=\omega+\beta I"),
        (
            r"With $a=x+iy$ we get",
            r"\dot x=-\omega y-\beta(x^2+y^2)y,\qquad\dot y=\omega x+\beta(x^2+y^2)x",
        ),
    ],
)
@pytest.mark.parametrize("law", [STARRED, MODULUS])
def test_equations_for_a_complex_variable_are_those_for_its_real_letters(law, change, rates):
    text = rf"{law}{change} \[{rates} .\]"
    assert [one.green for one in verdicts(text).values()] == [True, True]
    wrong = verdicts(text.replace(r"\beta r", r"2\beta r").replace(r"\beta I", r"2\beta I")
                     .replace("y^2)x", "x^2)x"))  # fmt: skip
    assert [one.green for one in wrong.values()] == [True, False]


def test_a_modulus_that_falls_is_no_constant():
    text = (
        LANDAU
        + r"In polar form $a=re^{i\theta}$, \[\dot r=\mu r-r^3,\qquad\dot\theta=\omega-\beta r^2 .\]"
    )
    assert [one.green for one in verdicts(text).values()] == [True, True]
    assert [one.green for one in verdicts(text.replace("-r^3", "+r^3")).values()] == [False, True]


def test_a_conjugate_that_is_printed_is_the_one_that_is_meant():
    text = (
        STARRED
        + r"Put $a=re^{i\varphi}$, $a^*=re^{-i\varphi}$. Then \[\dot\varphi=\omega+\beta r^2 .\]"
    )
    assert [one.green for one in verdicts(text).values()] == [True]
