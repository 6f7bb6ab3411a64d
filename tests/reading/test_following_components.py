"""Steps with vectors, the components of which are printed beside them."""

import pytest

from tests.reading.test_following import found

SPINNING = r"""
The components of the angular momentum obey
\begin{align*}
\dot M_x &= M_yw_z - M_zw_y, \\
\dot M_y &= M_zw_x - M_%sw_z, \\
\dot M_z &= M_xw_y - M_yw_x.
\end{align*}
In vector form this is
\[ \dot{\mathbf{M}} = \mathbf{M}\times\mathbf{w} . \]
"""
ARM = r"""
The place and the momentum of a body are
\[ \mathbf{r} = a\mathbf{e}_x + b\mathbf{e}_y , \qquad \mathbf{p} = \mu v\mathbf{e}_x . \]
Therefore its moment is
\[ \mathbf{N} = \mathbf{r}\times\mathbf{p} = %s\mu bv\mathbf{e}_z . \]
"""
HATS = r"""
On the helix
\[ \mathbf{u} = a\cos\beta\,\hat{\mathbf{x}} + a\sin\beta\,\hat{\mathbf{y}} + b\,\hat{\mathbf{z}} . \]
Therefore
\[ \mathbf{u}\cdot\mathbf{u} = a^2 + b^%s . \]
"""
TIMES = r"""
A body moves by
\[ \mathbf{r}(t) = (a + ut)\mathbf{e}_x + b\mathbf{e}_y , \qquad \mathbf{p} = \mu u\mathbf{e}_x . \]
Therefore
\[ \mathbf{N} = \left(x(t)p_y(t) - y(t)p_x(t)\right)\mathbf{e}_z = -b\mu u%s\mathbf{e}_z . \]
"""


@pytest.mark.parametrize(
    ("body", "right", "wrong"),
    [(SPINNING, "x", "y"), (ARM, "-", ""), (HATS, "2", "3"), (TIMES, "", "t")],
)
def test_a_step_is_doubted_that_follows_with_one_change_only(body, right, wrong):
    assert found(body % right) == []
    (one,) = found(body % wrong)
    assert one.repairs


TURNING = r"""
The axes turn with the body. The place is
\[ \mathbf{r} = a\mathbf{e}_x + b\mathbf{e}_y . \]
Therefore
\[ \dot{\mathbf{r}} = a\dot{\mathbf{e}}_x + b\dot{\mathbf{e}}_y . \]
"""


def test_axes_that_turn_have_no_components():
    assert found(TURNING) == []
