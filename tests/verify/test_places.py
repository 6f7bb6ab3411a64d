"""What a claim rests on: the places whose formulas enter its statement."""

import pytest

from kowalevski_cas.verify.run import Session, run_together
from kowalevski_cas.verify.statement import Statement


@pytest.fixture(scope="module")
def session(derivation):
    return Session(derivation, ["flint"])


def places(session, id):
    claim = next(c for c in session.derivation.claims if c.id == id)
    return {printed.place for printed in Statement(claim, session.on(claim)).stands_on}


@pytest.mark.parametrize(
    ("id", "some", "none"),
    [
        ("eq4.1", {"eq4.1", "eq3.1", "eq3.2"}, {"eq2.1", "eq9.i.1"}),
        (
            "eq5.1",
            {"eq5.1", "eq2.1", "inertia.1", "kowalevski-case.1", "kowalevski-case.2", "A3.1"},
            {"eq9.i.1"},
        ),
        ("eq12", {"eq12.1", "F1.1", "eq9.1", "eq9.i.1", "tau.1"}, {"eq14.1", "eq17.1"}),
        ("area", {"area.1", "beta.1"}, {"eq9.1"}),
        (
            "critical-set",
            {"combined-integral.1", "eq18.1", "eq19.1", "norm.1", "area.1", "eq17.1"},
            {"eq9.1"},
        ),
    ],
)
def test_foundations(session, id, some, none):
    found = places(session, id)
    assert some <= found
    assert not none & found


def test_only_decides_and_reports_the_claim_alone(derivation, certificates):
    seen = []
    alone = Session(derivation, ["flint"], certificates=certificates)
    (run,) = run_together([alone], ["eq10.5"], lambda *told: seen.append(told))
    assert [o.claim for o in run.outcomes] == ["eq10.5"]
    assert seen == [("eq10.5", 0, 1), ("eq9.i", 1, 2)]  # on which it rests
