"""Points of hypotheses: what fails at one is false; i is a unit only where its square is -1."""

import pytest

from kowalevski_cas.paper.claims import Implication
from kowalevski_cas.paper.derivation import Scene
from kowalevski_cas.paper.elaborate import finder_of
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.search.on_hypotheses import POINTS, HypothesisPoints
from tests.paper.small import Paper, derivation
from tests.sample import sampled


class Circle(Paper):
    """The circle, and the difference of the squares there."""

    scene = Scene(variables=("x", "y", "z"))
    hypotheses = r"x^2+y^2=1, \quad z=x^2-y^2"

    def goal(self, tex):
        claim = Implication("t", self.scene, "", printed=self(tex), given=self.all(self.hypotheses))
        (found,) = claim.goals(Elaborations(derivation(self.section).texts(None, self.scene)))
        return found


@pytest.mark.parametrize(
    ("tex", "refuted"), [("x^4-y^4=z", False), ("x^4-y^4=x^2+z", True), ("x=y", True)]
)
def test_what_fails_at_a_point_of_the_hypotheses_is_refuted(tex, refuted):
    goal = Circle().goal(tex)
    points = HypothesisPoints(goal, finder_of)
    assert len(points.found) == POINTS
    assert points.refute(goal, finder_of(goal.space)) == refuted


def test_a_correction_under_hypotheses_is_found():
    paper = Circle()
    outcome = paper.outcome(Implication, "x^4+y^4=z", given=paper.all(paper.hypotheses))
    assert str(outcome.verdict) == "refuted" and outcome.correction is not None


@pytest.mark.parametrize(("square", "verdict"), sampled([("-1", "proved"), ("1", "refuted")], 1))
def test_i_is_the_imaginary_unit_only_where_its_square_is_so(square, verdict):
    paper = Circle()
    scene = paper.scene.with_unit(paper(f"i^2={square}"))
    given = paper.all(r"x^2+y^2=1, \quad z=(x+iy)(x-iy)")
    assert paper.verdict(Implication, "z=1", scene, given=given) == verdict
