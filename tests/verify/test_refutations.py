"""A refutation has a certificate; ``tests/paper/test_mutants.py`` has those of each kind of claim."""

import json

import pytest

from kowalevski_cas.paper import claims as kinds
from kowalevski_cas.problem import checker
from kowalevski_cas.verify.run import Session
from tests.paper.small import MOMENTUM, Top, derivation


def is_refuted(text):
    found = checker.check(text)
    assert found.sign == "denied"
    (theorem,) = found.theorems
    data = json.loads(text)
    said_to_fail = data["goals"][data["evidence"][0]["goal"]]["goal"] == "fails"
    assert theorem.words.startswith("it is false that ") != said_to_fail
    at_points = any(line.startswith("point: ") for line in theorem.about)
    assert at_points or "minors" in text or said_to_fail


@pytest.mark.parametrize(
    ("kind", "attributes"),
    [
        (kinds.FirstIntegral, {"tex": r"\omega_1^2-\omega_2^2"}),
        (kinds.FirstIntegral, {"tex": MOMENTUM, "given": r"\omega_1=0"}),
        (kinds.InvariantRelations, {"relations": r"\omega_1=0"}),
        (kinds.Implication, {"tex": r"\omega_2=0", "given": r"\omega_1=0"}),
    ],
    ids=["no integral", "an integral everywhere", "no invariant set", "no consequence"],
)  # fmt: skip
def test_integrals_and_invariant_relations_of_a_top(kind, attributes):
    top = Top()
    own = {key: (top(attributes[key]),) for key in ("given", "relations") if key in attributes}
    place = top(attributes["tex"]) if "tex" in attributes else None
    claim = kind("t", top.scene, "", printed=place, **own)
    top.section.claim(claim)
    session = Session(derivation(top.section), ["flint"])
    assert session.decide(claim).verdict == "refuted"
    is_refuted(session.outcome(claim).certificates["t"])
