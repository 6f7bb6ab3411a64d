"""Steps with functions of which nothing is known, and with what a Lagrangian says of momenta."""

import pytest

from tests.reading.test_following import found

TWO_BEADS = r"""
The Lagrangian of two beads is
\[ L = \frac12\mu_1\dot x_1^2 + \frac12\mu_2\dot x_2^2 - \frac12\kappa(x_1 - x_2)^2 . \]
The Hamiltonian is
\[ H = \sum_{i=1}^2 p_i\dot x_i - L
     = \frac{p_1^2}{2\mu_1} + \frac{p_2^2}{2\mu_%s} + \frac12\kappa(x_1 - x_2)^2 . \]
"""
POLAR = r"""
The Lagrangian is
\[ \mathcal{L} = \frac{\mu}{2}(\dot\rho^2 + \rho^2\dot\varphi^2) - U(\rho) . \]
We have
\[ H = p_\rho\dot\rho + p_\varphi\dot\varphi - \mathcal{L}
     = \frac{1}{2\mu}\left(p_\rho^2 + \frac{p_\varphi^2}{%s}\right) + U(\rho) . \]
"""
CONE = r"""
The Lagrangian of a bead on a cone is
\[ L = \frac12\mu\left(\frac{\dot s^2}{\beta^2} + s^2\dot\alpha^2\right) - U(s) . \]
The equations of motion are
\[ \frac{d}{dt}\left(\mu s^2\dot\alpha%s\right) = 0 ,
   \qquad \frac{\mu}{\beta^2}\ddot s = \mu s\dot\alpha^2 - U'(s) . \]
"""
RADIUS = r"""
The Lagrangian of a bead on a cone is
\[ L = \frac12\mu\left(\frac{\dot s^2}{\beta^2} + s^2\dot\alpha^2\right) - U(s) . \]
Lagrange's equations are
\[ \frac{\mu}{\beta^2}\ddot s %s \mu s\dot\alpha^2 + U'(s) = 0 . \]
"""
MOMENTUM = r"""
Let $H = \frac{p^2}{2\mu} + U(q)$. Hamilton's equations are
\[ \dot q = \frac{p}{\mu} , \qquad \dot p = %sU'(q) . \]
"""
ENERGY = r"""
The energy is
\[ E = \frac12\mu\dot s^2 + U(s) . \]
Its rate is
\[ \frac{dE}{dt} = \mu\dot s\ddot s + U'(s)%s . \]
"""
EFFECTIVE = r"""
The motion obeys
\[ \mu\ddot s = \frac{k^2}{\mu s^3} - U'(s) . \]
With $W(s) = U(s) + \frac{k^2}{2\mu s^2}$ we have
\[ W'(s) = U'(s) - \frac{k^2}{\mu s^%s} . \]
"""
WORK = r"""
The force has the potential $U(x)$, and the body moves by
\[ \mu\ddot x = -U'(x) . \]
Therefore
\[ \frac{d}{dt}\left(\frac12\mu\dot x^2\right) = %sU'(x)\dot x = -\frac{dU}{dt} . \]
"""
DOUBLE_ANGLE = r"""
The deviation is $u = a\cos\nu t + b\sin\nu t$. With the double angle we find
\[ u^2 = (a\cos\nu t + b\sin\nu t)^2
       = \frac{a^2+b^2}{2} + \frac{a^2-b^2}{2}\cos2\nu t + %sab\sin2\nu t . \]
"""
LENGTH = r"""
A point moves as
\[ x = a\cos\nu t , \qquad y = b\sin\nu t , \]
and has the force $\mathbf{S} = -\kappa\mathbf{r}$. Therefore
\[ r^2 = x^2 + y^2 = a^2\cos^2\nu t + b^2\%s^2\nu t . \]
"""
ON_THE_SPHERE = r"""
The path obeys
\[ \frac{d\varphi}{d\theta} = \frac{\kappa}{\sin^2\theta} . \]
It is therefore
\[ \varphi = \beta %s \kappa\cot\theta . \]
"""
NEAR_THE_GROUND = r"""
The potential is $W(s) = -\frac{\kappa}{s}$. At a small height $y$, where $s = S + y$,
\[ W(s) = W(S + y) = -\frac{\kappa}{%s + y} = -\frac{\kappa}{S}\left(1 - \frac{y}{S} + \cdots\right)
       \approx \text{const.} + \frac{\kappa}{S^2}y . \]
"""


@pytest.mark.parametrize(
    ("body", "right", "wrong"),
    [
        (TWO_BEADS, "2", "1"),
        (POLAR, r"\rho^2", r"\rho"),
        (CONE, "", "^2"),
        (RADIUS, "-", "+"),
        (MOMENTUM, "-", ""),
        (ENERGY, r"\dot s", ""),
        (EFFECTIVE, "3", "2"),
        (WORK, "-", ""),
        (DOUBLE_ANGLE, "", "2"),
        (LENGTH, "sin", "cos"),
        (ON_THE_SPHERE, "-", "+"),
        (NEAR_THE_GROUND, "S", "s"),
    ],
)
def test_a_step_is_doubted_that_follows_with_one_change_only(body, right, wrong):
    assert found(body % right) == []
    (one,) = found(body % wrong)
    assert one.repairs
