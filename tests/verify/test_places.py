"""What a claim rests on: the places whose formulas enter its decision."""

import pytest

from kowalevski_cas.proof.dependencies import Dependencies
from kowalevski_cas.verify.run import Session


def places(derivation, id):
    claim = next(c for c in derivation.claims if c.id == id)
    return {printed.place for printed in Dependencies(derivation.texts()).foundations(claim)}


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
def test_foundations(derivation, id, some, none):
    found = places(derivation, id)
    assert some <= found
    assert not none & found


def test_only_decides_what_a_claim_rests_on_and_reports_the_claim(derivation):
    session = Session(derivation, ["flint"], False, {})
    seen = []
    run = session.run(["eq10.5"], lambda claim, done, total: seen.append((claim, done, total)))
    assert [o.claim for o in run.outcomes] == ["eq10.5"]
    assert seen[-1] == ("eq10.5", len(seen) - 1, len(seen))
    ids = [claim for claim, _, _ in seen]
    assert "eq9.i" in ids and "eq14" not in ids


def test_a_corrected_formula_stands_corrected_for_what_comes_after(derivation):
    session = Session(derivation, ["flint"], False, {})
    session.run(["eq10.5"])
    unit = next(c for c in derivation.claims if c.id == "eq9.i")
    assert session.texts.statement(unit.printed).source.replace(" ", "") == "i^2=-1"
