"""Where words say that nothing moves, velocities that are not printed are zero."""

import pytest

from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import verdicts

WELL = r"The motion is \[ \dot x=y,\qquad\dot y=x-x^3. \] "
SPHERE = r"""A point moves on the sphere \[ x_1^2+x_2^2+x_3^2=1 \] by
\[ \dot x_i=y_i,\qquad \dot y_i=-a_ix_i+\lambda x_i,\qquad i=1,2,3, \] where
\[ \lambda=a_1x_1^2+a_2x_2^2+a_3x_3^2-y_1^2-y_2^2-y_3^2. \]
Besides, \[ x_1y_1+x_2y_2+x_3y_3=0. \] """


@pytest.mark.parametrize(
    ("words", "equation", "verdict"),
    [
        ("The point $x=1$ is an equilibrium.", "x=1", Verdict.PROVED),
        ("The point $x=2$ is an equilibrium.", "x=2", Verdict.REFUTED),
        ("There are three equilibria, $x=1$, $x=0$ and $x=-1$.", "x=0", Verdict.PROVED),
        ("Положение $x=1$ есть положение равновесия.", "x=1", Verdict.PROVED),
        ("The line $x=1$ consists of equilibria.", "x=1", None),
        ("All points of $x=1$ are equilibria.", "x=1", None),
        ("Whatever the velocity, $x=1$ is an equilibrium.", "x=1", None),
        ("The place $x=1$ is an equilibrium for each $y$.", "x=1", None),
        ("The point $x=1$, $y=2$ is an equilibrium.", "x=1", None),
        ("Каждая точка прямой $x=1$ есть положение равновесия.", "x=1", None),
    ],
)
def test_velocities_vanish_where_nothing_moves(words, equation, verdict):
    found = verdicts(WELL + words)[equation]
    assert found is verdict if verdict else not found.green


def test_a_coordinate_that_nothing_gives_may_be_any():
    law = r"The motion is \[ \dot x=y,\qquad\dot y=x-z,\qquad\dot z=-y. \] "
    assert not verdicts(law + "The point $x=0$ is an equilibrium.")["x=0"].green


def test_each_of_a_canonical_pair_may_be_the_place():
    law = r"The motion is \[ \dot q=p/m,\qquad\dot p=-kq. \] "
    assert verdicts(law + "The point $q=0$ is an equilibrium.")["q=0"].green
    assert not verdicts(law + "The point $q=1$ is an equilibrium.")["q=1"].green


def test_other_coordinates_are_what_a_constraint_makes_them():
    found = verdicts(SPHERE + r"The points $x_1=\pm1$ are equilibria.")
    assert found[r"x_1=\pm1"].green
    assert not verdicts(SPHERE + r"The points $x_1=\pm\frac12$ are equilibria.")[
        r"x_1=\pm\frac12"
    ].green
