"""What is published is found, given the field and a bound only; nothing else; all with certificates."""

import pytest

from kowalevski_cas.paper.derivation import Derivation
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.problem import checker
from kowalevski_cas.questions import question
from kowalevski_cas.verify.finding import with_findings
from kowalevski_cas.verify.run import Session
from study.published import PUBLISHED
from tests.sample import sampled


def answered(published):
    """The claims that a question finds, their certificates checked, by their kinds."""
    system = published.system()
    scene = system.scene
    derivation = Derivation("published", published.name, "", "", (system.section,))
    on = Elaborations(derivation.texts(None, scene))
    findings = [*question(published.question).search(on, scene, degree=published.degree)]
    claims = with_findings(derivation, findings)
    session = Session(claims, ["flint"])
    for claim in claims.claims:
        text = session.outcome(claim).certificate
        assert checker.check(text).sign == "holds", claim.words
    return on(scene), [(finding.kind.__name__, finding.tex) for finding in findings]


@pytest.mark.parametrize(
    "published", sampled(PUBLISHED, 1, id=lambda one: f"{one.question}: {one.name}")
)
def test_what_is_published_is_found(published):
    space, found = answered(published)
    at = space.finder
    known = [at.scalar(space.formula(tex)) for tex in published.known]
    if published.question == "integrals":
        # the certificate says that each integral is a polynomial in those found
        assert found[-1][0] == "AllIntegrals"
        assert all(at.derivative(one).is_zero for one in known)
        assert bool(known) == (len(found) > 1)
        return
    elements = [at.scalar(space.formula(tex)) for kind, tex in found if kind != "Identity"]
    assert all(any(_is_multiple(at, a, b) for b in elements) for a in known)
    assert bool(known) == bool(found)


def _is_multiple(at, left, right):
    """Whether two polynomials differ by a constant factor."""
    ratio = left / right
    return all(at.partial(ratio, name).is_zero for name in at.setting.variables)
