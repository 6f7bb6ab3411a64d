"""The divergence of a field, and the measures that its flow preserves."""

import pytest

from kowalevski_cas.paper.claims import Divergence, PreservedMeasure
from tests.paper.small import Motion

PLANE = Motion(r"\dot x=-y+xy,\quad \dot y=x+Dx^2+Fy^2", "x", "y", constants=("D", "F"))
PENDULUM = Motion(r"\ddot\theta=-\sin\theta-k\dot\theta", r"\theta", constants=("k",))
BATH = Motion(r"\dot x=y,\quad \dot y=-x-zy,\quad \dot z=y^2-1", "x", "y", "z")
TURNING = Motion(
    r"\dot\theta=\sin\theta+\varphi,\quad \dot\varphi=\theta\varphi", r"\theta", r"\varphi"
)


@pytest.mark.parametrize(
    ("motion", "printed", "true"),
    [
        (PLANE, "y+2Fy", True),
        (PLANE, "y+Fy", False),
        (PENDULUM, "-k", True),
        (PENDULUM, "k", False),
        (TURNING, r"\cos\theta+\theta", True),
        (TURNING, r"\cos\theta-\theta", False),
    ],
)
def test_the_divergence_is_taken_by_all_that_moves(motion, printed, true):
    assert motion.verdict(Divergence, printed) == ("proved" if true else "refuted")


@pytest.mark.parametrize(
    ("motion", "density", "green"),
    [
        (PLANE, "(1-x)^{-1-2F}", True),
        (PLANE, "(1-x)^{1-2F}", False),
        (BATH, r"e^{-\frac12(x^2+y^2+z^2)}", True),
        (BATH, r"e^{\frac12(x^2+y^2+z^2)}", False),
        (BATH, "x-x", False),
    ],
)
def test_the_flow_preserves_a_measure(motion, density, green):
    assert motion.outcome(PreservedMeasure, density).verdict.green is green


@pytest.mark.parametrize(("density", "green"), [(r"\frac1{x^2}", True), ("1", False)])
def test_a_density_is_one_in_its_coordinates(density, green):
    circle = Motion(r"\dot x=y,\quad \dot y=-x", "x", "y")
    scene = circle.scene.defining(circle("u=x^3"))
    found = circle.outcome(PreservedMeasure, density, on=scene, coordinates=("u", "y"))
    assert found.verdict.green is green
