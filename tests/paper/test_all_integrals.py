"""That all polynomial integrals are known, with one left out, one too many, another degree."""

import pytest

from kowalevski_cas.algebra import EXACT
from kowalevski_cas.paper.claims import AllDarboux, AllIntegrals
from kowalevski_cas.problem import checker
from kowalevski_cas.verify.finding import Finding, with_findings
from kowalevski_cas.verify.run import Session
from tests.laws.systems import EULER, LORENZ, SPECIAL_LORENZ, TODA, VOLTERRA
from tests.sample import sampled

pytestmark = pytest.mark.usefixtures("uncorrected")


def claimed(system, degree, *integrals, weights=()):
    derivation = system.derivation()
    attributes = {"integrals": integrals, "degree": degree, "weights": weights}
    finding = Finding(AllIntegrals, derivation.scenes()[0], "these are all", "", attributes)
    return with_findings(derivation, [finding])


CASES = [
    (LORENZ, 6, (), "proved"),
    (SPECIAL_LORENZ, 4, (), "proved"),
    (VOLTERRA, 6, ("x+y+z", "xyz"), "proved"),
    (VOLTERRA, 6, ("x+y+z",), "refuted"),
    (VOLTERRA, 2, ("x+y+z",), "proved"),
    (VOLTERRA, 3, ("x+y+z", "xyz+1"), "proved"),
    (VOLTERRA, 3, ("x+y+z", "x^2y"), "refuted"),
    (EULER, 2, ("Ap^2+Bq^2+Cr^2", "A^2p^2+B^2q^2+C^2r^2"), "proved"),
    (EULER, 2, ("Ap^2+Bq^2+Cr^2",), "refuted"),
    (TODA, 3, ("b_1+b_2+b_3", "b_1^2+b_2^2+b_3^2+2a_1^2+2a_2^2"), "refuted"),
]  # fmt: skip


@pytest.mark.parametrize(("system", "degree", "integrals", "verdict"), sampled(CASES, 4))
def test_the_verdict_in_every_arithmetic_and_its_certificate(system, degree, integrals, verdict):
    derivation = claimed(system, degree, *integrals)
    (outcome,) = Session(derivation, EXACT).run().outcomes
    assert {str(one) for one in outcome.verdicts.values()} == {verdict} == {str(outcome.verdict)}
    (claim,) = derivation.claims
    text = Session(derivation, ["flint"]).outcome(claim).certificate
    assert checker.check(text).sign == ("holds" if verdict == "proved" else "denied")


DARBOUX = [
    (SPECIAL_LORENZ, r"-2\sigma", 4, (r"x^2-2\sigma z",), (), "proved"),
    (SPECIAL_LORENZ, r"-2\sigma", 4, (), (), "refuted"),
    (SPECIAL_LORENZ, r"-2\sigma", 1, (), (), "proved"),
    (SPECIAL_LORENZ, r"-\sigma", 4, (), (), "proved"),
    (SPECIAL_LORENZ, r"-2\sigma", 2, (r"x^2+2\sigma z",), (), "refuted"),
    (VOLTERRA, "y-z", 4, ("x",), ("x+y+z", "xyz"), "proved"),
    (VOLTERRA, "y-z", 4, ("x",), ("x+y+z",), "refuted"),
    (VOLTERRA, "y-z", 2, ("x",), ("x+y+z",), "proved"),
    (VOLTERRA, "x+y", 3, (), (), "proved"),
]  # fmt: skip


@pytest.mark.parametrize(
    ("system", "cofactor", "degree", "found", "integrals", "verdict"), sampled(DARBOUX, 5)
)
def test_all_darboux_polynomials_with_a_cofactor(
    system, cofactor, degree, found, integrals, verdict
):
    given = system.derivation()
    attributes = {
        "cofactor": cofactor, "solutions": found, "integrals": integrals, "degree": degree,
    }  # fmt: skip
    finding = Finding(AllDarboux, given.scenes()[0], "these are all", "", attributes)
    derivation = with_findings(given, [finding])
    (outcome,) = Session(derivation, EXACT).run().outcomes
    assert {str(one) for one in outcome.verdicts.values()} == {verdict} == {str(outcome.verdict)}
    text = Session(derivation, ["flint"]).outcome(derivation.claims[0]).certificate
    certificate = checker.check(text)
    assert certificate.sign == ("holds" if verdict == "proved" else "denied")


def test_weights_of_the_variables():
    integrals = ("b_1+b_2+b_3", "b_1^2+b_2^2+b_3^2+2a_1^2+2a_2^2")
    for weights, verdict in (((1, 1, 1, 1, 1), "refuted"), ((2, 2, 1, 1, 1), "proved")):
        derivation = claimed(TODA, 3, *integrals, weights=weights)
        assert str(Session(derivation, ["flint"]).run().outcomes[0].verdict) == verdict


@pytest.mark.parametrize("weights", [(0, 1, 1), (1, -1, 1), (1, 1), (1, 1, 1, 1)])
def test_weights_that_are_none(weights):
    (outcome,) = Session(claimed(LORENZ, 2, weights=weights), ["flint"]).run().outcomes
    assert str(outcome.verdict) == "error" and "a positive weight" in outcome.message
