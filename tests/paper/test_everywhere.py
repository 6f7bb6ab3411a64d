"""Independence at every point: of all differentials, and not on a dense part only."""

import pytest

from kowalevski_cas.paper.claims import EverywhereIndependent
from tests.paper.small import Motion

pytestmark = pytest.mark.usefixtures("uncorrected", "here")

FLOW = r"\dot x=y, \dot y=-x, \dot z=0"


@pytest.mark.parametrize(
    ("functions", "origin", "verdict"),
    [
        (("F=x+y^3", "G=z"), False, "proved"),
        (("F=x^2+y^2", "G=z"), False, "refuted"),  # on the axis
        (("F=x^2+y^2+z^2",), True, "proved"),
        (("F=x^2+y^2+z^2",), False, "refuted"),
        (("F=x^2+y^2+z^2", "G=x^2+2y^2+3z^2"), True, "refuted"),  # on each axis
        (("F=x", "G=y", "H=x+y"), False, "refuted"),
        (("F=x", "G=x^2"), False, "refuted"),
    ],
)
def test_one_point_where_differentials_depend_refutes_it(functions, origin, verdict):
    motion = Motion(FLOW, "x", "y", "z")
    printed = tuple(map(motion, functions))
    scene = motion.scene.defining(*printed)
    found = motion.outcome(EverywhereIndependent, on=scene, functions=printed, origin=origin)
    assert found.verdict == verdict
