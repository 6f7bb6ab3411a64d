"""What is the factor of something that moves: by the other factors it moves, too."""

import pytest

from tests.reading.test_reading import verdicts

PLANE = r"""The motion obeys \begin{align} \ddot x&=-kx+2n\dot y,\\ \ddot y&=-ky-2n\dot x . \end{align}
With $\zeta=x+iy$ we have \[ \ddot\zeta+2in\dot\zeta+k\zeta=0 . \] """


@pytest.mark.parametrize(("sign", "green"), [("+", True), ("-", False)])
def test_a_new_factor_of_what_is_defined_follows_the_law(sign, green):
    text = PLANE + r"By means of \[ \zeta=e^{-int}w \] the first derivative is removed, "
    found = verdicts(text + rf"\[ \ddot w+(k{sign}n^2)w=0 . \]")
    assert [one.green for one in found.values()] == [True, green]


@pytest.mark.parametrize(("force", "green"), [("2n r", True), ("n r", False)])
def test_what_follows_in_later_sections_is_of_the_first_law(force, green):
    text = r"\section{Equations}" + PLANE + r"\section{Solution} Put \[ \zeta=e^{-int}w . \] Then "
    text += r"\[ \ddot w+(k+n^2)w=0 . \] \section{Radial motion} In the polar coordinates "
    text += r"$x=r\cos\varphi$, $y=r\sin\varphi$ this becomes \[ \ddot r-r\dot\varphi^2=-kr"
    found = verdicts(text + rf"+{force}\dot\varphi . \]")
    assert [one.green for one in found.values()] == [True, True, green]


@pytest.mark.parametrize(("factor", "green"), [("3", True), ("2", False)])
def test_a_quotient_is_one_of_what_moves(factor, green):
    text = r"The body obeys \[ \dot x=x,\qquad \dot y=3y . \] Let $s=x+x^2$. We write \[ s=xq . \] "
    found = verdicts(text + rf"Then \[ \dot q=q-1,\qquad \frac{{d}}{{dt}}y={factor}y . \]")
    assert [one.green for one in found.values()] == [True, green]
