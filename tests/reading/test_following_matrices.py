"""Steps with matrices by their entries, with the chain rule, and with what is not to be negative."""

import pytest

from tests.reading.test_following import found

REFLECTED = r"""
A turn by the angle $\beta$ is
\[ D = \begin{pmatrix} \cos\beta & \sin\beta \\ -\sin\beta & \cos\beta \end{pmatrix} , \]
and a reflection
\[ S = \begin{pmatrix} 1 & 0 \\ 0 & -1 \end{pmatrix} . \]
Therefore
\[ DS = \begin{pmatrix} \cos\beta & %s\sin\beta \\ -\sin\beta & -\cos\beta \end{pmatrix} . \]
"""
AXES = r"""
The momentum is
\[ \mathbf{M} = J\mathbf{w} ,
   \qquad J = \begin{pmatrix} a & 0 & 0 \\ 0 & b & 0 \\ 0 & 0 & c \end{pmatrix} . \]
The energy is
\[ T = \frac12\mathbf{w}\cdot\mathbf{M} = \frac12\left(aw_x^2 + bw_y^2 + cw_z^%s\right) . \]
"""
SQUARED = r"""
The linear system has the matrix
\[ A = \begin{pmatrix} 0 & 1 \\ -\kappa & -b \end{pmatrix} . \]
Therefore
\[ A^2 = \begin{pmatrix} -\kappa & -b \\ b\kappa & %sb^2 - \kappa \end{pmatrix} . \]
"""
NEW_VARIABLES = r"""
The new variables $X,Y$ are functions of $x,y$. For a function $F$ we have
\[ \frac{\partial F}{\partial x} = \frac{\partial F}{\partial X}\frac{\partial X}{\partial x}
   %s \frac{\partial F}{\partial Y}\frac{\partial Y}{\partial x} , \]
and likewise
\[ \frac{\partial F}{\partial y} = \frac{\partial F}{\partial X}\frac{\partial X}{\partial y}
   + \frac{\partial F}{\partial Y}\frac{\partial Y}{\partial y} . \]
"""
IN_POLAR_COORDINATES = r"""
In polar coordinates
\[ \frac{\partial r}{\partial x} = \cos\theta ,
   \qquad \frac{\partial\theta}{\partial x} = -\frac{\sin\theta}{r} . \]
Therefore
\[ \frac{\partial F}{\partial x} = \frac{\partial F}{\partial r}\frac{\partial r}{\partial x}
   + \frac{\partial F}{\partial\theta}\frac{\partial\theta}{\partial x}
   = \frac{\partial F}{\partial r}\cos\theta
   %s \frac{\partial F}{\partial\theta}\frac{\sin\theta}{r} . \]
"""
DAMPED = r"""
The pendulum moves by
\[ \mu\ddot\alpha + \kappa\sin\alpha = -b\dot\alpha . \]
Consider
\[ V = %s\mu\dot\alpha^2 + \kappa(1 - \cos\alpha) . \]
With $b > 0$
\[ \frac{dV}{dt} = -b\dot\alpha^2 \le 0 . \]
"""
INVERTED = r"""
We set
\[ \sigma = %s\ln\frac{a}{b} . \]
Conversely,
\[ a = be^\sigma . \]
"""


@pytest.mark.parametrize(
    ("body", "right", "wrong"),
    [
        (REFLECTED, "-", ""),
        (AXES, "2", "3"),
        (SQUARED, "", "-"),
        (NEW_VARIABLES, "+", "-"),
        (IN_POLAR_COORDINATES, "-", "+"),
        (DAMPED, r"\frac12", ""),
        (INVERTED, "", r"\frac12"),
    ],
)
def test_a_step_is_doubted_that_follows_with_one_change_only(body, right, wrong):
    assert found(body % right) == []
    (one,) = found(body % wrong)
    assert one.repairs


ASKED = r"""
We ask when $Q,P$ obey
\[ \dot Q = \frac{\partial H}{\partial P} . \]
Let $H$ be a function of them. Then
\[ \dot p = -\frac{\partial H}{\partial q}
          = -\frac{\partial H}{\partial Q}\frac{\partial Q}{\partial q}
            - \frac{\partial H}{\partial P}\frac{\partial P}{\partial q} , \]
and therefore
\[ \dot Q = \frac{\partial Q}{\partial q}\dot q + \frac{\partial Q}{\partial p}\dot p . \]
"""


def test_nothing_rests_on_what_is_asked():
    assert found(ASKED) == []
