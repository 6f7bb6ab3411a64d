"""Steps with gradients, curls and divergences, which are names there, and derivatives at values."""

import pytest

from tests.reading.test_following import found

WAVES = r"""
A layer moves by
\[ \frac{\partial\mathbf{v}}{\partial t} = -\kappa\nabla\sigma ,
   \qquad \frac{\partial\sigma}{\partial t} = -b\nabla\cdot\mathbf{v} . \]
The divergence of the first is
\[ \frac{\partial}{\partial t}(\nabla\cdot\mathbf{v}) = -\kappa\nabla^2\sigma . \]
With the second this becomes
\[ \frac{\partial^2\sigma}{\partial t^2} = %sb\kappa\nabla^2\sigma . \]
"""
VORTICITY = r"""
The vorticity is $\boldsymbol{\omega} = \nabla\times\mathbf{v}$. It obeys
\[ \frac{\partial\boldsymbol{\omega}}{\partial t} = \nu\nabla^2\boldsymbol{\omega} + \mathbf{s} , \]
where $\mathbf{s} = 2\nabla\psi$. Therefore
\[ \frac{\partial\boldsymbol{\omega}}{\partial t} = \nu\nabla^2\boldsymbol{\omega} %s 2\nabla\psi . \]
"""
PRESSURE = r"""
The density obeys
\[ \frac{\partial\rho}{\partial t} + \rho\nabla\cdot\mathbf{u} = 0 , \]
and the pressure
\[ \frac{\partial p}{\partial t} = -\gamma p\nabla\cdot\mathbf{u} . \]
Eliminating the divergence we have
\[ \frac{\partial p}{\partial t} = %s\frac{\gamma p}{\rho}\frac{\partial\rho}{\partial t} . \]
"""
CIRCLE = r"""
A circle of radius $s_0$ is a solution if
\[ U'(s_0) = \frac{k^2}{\mu s_0^3} . \]
Then
\[ \nu^2 = \frac{3k^2}{\mu^2s_0^4} + \frac{U''(s_0)}{\mu}
         = \frac{%sU'(s_0)}{\mu s_0} + \frac{U''(s_0)}{\mu} . \]
"""
FRAMES = r"""
A point $P$ is fixed in a body $B$ that moves in a frame $N$. Its place is
\[ \mathbf{s}_{P/N} = \mathbf{s}_{B/N} + \mathbf{s}_{P/B} , \]
and the rates are
\[ \dot{\mathbf{s}}_{P/B} = \boldsymbol{\omega}_{B/N}\times\mathbf{s}_{P/B} . \]
Therefore
\[ \dot{\mathbf{s}}_{P/N} = \dot{\mathbf{s}}_{B/N} %s \boldsymbol{\omega}_{B/N}\times\mathbf{s}_{P/B} . \]
"""


@pytest.mark.parametrize(
    ("body", "right", "wrong"),
    [
        (WAVES, "", "-"),
        (VORTICITY, "+", "-"),
        (PRESSURE, "", "-"),
        (CIRCLE, "3", "2"),
        (FRAMES, "+", "-"),
    ],
)
def test_a_step_is_doubted_that_follows_with_one_change_only(body, right, wrong):
    assert found(body % right) == []
    (one,) = found(body % wrong)
    assert one.repairs
