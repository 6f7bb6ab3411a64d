"""Solutions that are tried as exponentials: equations for exponents, their roots, and amplitudes."""

import pytest

from tests.reading.test_reading import verdicts
from tests.sample import sampled

DAMPED = r"""The equation of the damped oscillator is \[ m\ddot x+b\dot x+kx=0 .\]
We look for solutions of the form $x=Ae^{\lambda t}$ and find """
COUPLED = r"""The masses move by
\[ m\ddot x_1=-kx_1+k(x_2-x_1),\qquad m\ddot x_2=-k(x_2-x_1)-kx_2 .\]
We seek a solution $x_1=Ae^{i\omega t}$, $x_2=Be^{i\omega t}$. Substituting it, we get """
SPIRAL = r"""The motion is \[ \dot x=-ax+by,\qquad\dot y=-bx-ay .\]
Putting $x=Xe^{st}$, $y=Ye^{st}$ we obtain """
RUSSIAN = r"""Уравнение движения \[ \ddot x+2h\dot x+\omega_0^2x=0 .\]
Ищем решение в виде $x=e^{pt}$. Получаем """

CASES = [
    (DAMPED, r"m\lambda^2+b\lambda+k=0", r"m\lambda^2-b\lambda+k=0"),
    (DAMPED, r"\lambda^2+\frac bm\lambda+\frac km=0", r"\lambda^2+\frac bm\lambda+k=0"),
    (DAMPED + r"\[ m\lambda^2+b\lambda+k=0 ,\] so that",
     r"\lambda=\frac{-b\pm\sqrt{b^2-4mk}}{2m}", r"\lambda=\frac{-b\pm\sqrt{b^2-2mk}}{2m}"),
    (COUPLED, r"(2k-m\omega^2)^2-k^2=0", r"(k-m\omega^2)^2-k^2=0"),
    (COUPLED + r"\[ (2k-m\omega^2)^2=k^2 .\] Hence", r"\omega^2=\frac{3k}m", r"\omega^2=\frac{2k}m"),
    (SPIRAL, r"s^2+2as+a^2+b^2=0", r"s^2+2as+a^2-b^2=0"),
    (SPIRAL + r"\[ s^2+2as+a^2+b^2=0 \] and", r"s=-a\pm ib", r"s=-a\pm b"),
    (RUSSIAN, r"p^2+2hp+\omega_0^2=0", r"p^2+hp+\omega_0^2=0"),
    (RUSSIAN + r"\[ p^2+2hp+\omega_0^2=0 ,\] откуда",
     r"p=-h\pm\sqrt{h^2-\omega_0^2}", r"p=-h\pm\sqrt{h^2+\omega_0^2}"),
]  # fmt: skip


@pytest.mark.parametrize("words, true, false", sampled(CASES, 4))
def test_exponents_and_their_equations(words, true, false):
    right, wrong = ([*verdicts(rf"{words} \[ {one} .\]").values()] for one in (true, false))
    assert all(one.green for one in right)
    assert not wrong[-1].green


AMPLITUDES = [
    (COUPLED, r"(2k-m\omega^2)A=kB,\qquad(2k-m\omega^2)B=kA",
     r"(2k-m\omega^2)A=-kB,\qquad(2k+m\omega^2)B=kA", r"(2k-m\omega^2)^2-k^2=0"),
    (COUPLED, r"-m\omega^2A=-2kA+kB,\qquad-m\omega^2B=kA-2kB",
     r"-m\omega^2A=-2kA-kB,\qquad-m\omega B=kA-2kB", r"(2k-m\omega^2)^2-k^2=0"),
    (SPIRAL, r"(s+a)X=bY,\qquad(s+a)Y=-bX", r"(s-a)X=bY,\qquad(s+a)Y=bX", r"s^2+2as+a^2+b^2=0"),
]  # fmt: skip


@pytest.mark.parametrize("words, true, false, equation", sampled(AMPLITUDES, 1))
def test_what_is_left_of_the_law_between_amplitudes(words, true, false, equation):
    right, wrong = (
        [*verdicts(rf"{words} \[ {one} ,\] so that \[ {equation} .\]").values()]
        for one in (true, false)
    )
    assert len(right) == 3 and all(one.green for one in right)
    assert [one.green for one in wrong] == [False, False, True]


def test_what_is_tried_is_claimed_of_no_exponent():
    found = verdicts(DAMPED + r"\[ m\lambda^2+b\lambda+k=0 .\] Therefore \[ A=1 .\]")
    assert [one.green for one in found.values()].count(True) == 1
