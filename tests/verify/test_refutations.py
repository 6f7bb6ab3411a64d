"""Every refutation has a certificate, whatever the kind of the claim."""

import json
from itertools import islice

import pytest

from kowalevski_cas import System
from kowalevski_cas.library import available, find, load
from kowalevski_cas.notation import NotationError
from kowalevski_cas.paper import claims as kinds
from kowalevski_cas.problem import checker
from kowalevski_cas.problem.accept import Judge
from kowalevski_cas.problem.evidence import Denial
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.verify.certificate import certificate
from kowalevski_cas.verify.record import load_record
from kowalevski_cas.verify.run import Session
from kowalevski_cas.verify.statement import Statement, finder_of
from tests.paper.small import MOMENTUM, Top, derivation

KINDS = sorted(set(kinds.__all__) - {"Claim", "Neighbour", "Union"})
"""False unions are denied in ``tests/paper/test_section4.py``: no search finds their points."""

HARD = {"s.1", "s.2", "phi", "any-c.1", "any-c.2"}
"""Definitions whose edits are not refuted within seconds; there are others."""

SLOW = ("ConstantRoot", "Equilibria", "Independence", "Limit", "SolvedExponents")


def printed(kind):
    """The certificates of claims of a kind whose print is refuted."""
    for name in available():
        record = load_record(find(name))
        for claim in load(name).claims:
            if type(claim).__name__ == kind and record[claim.id]["verdict"] == "refuted":
                yield (find(name) / "certificates" / f"{claim.id}.json").read_text(encoding="utf-8")


def free_body():
    """Claims of the kinds that no paper has."""
    body = System(r"\dot x=yz,\quad \dot y=-2zx,\quad \dot z=xy")
    body.define(r"\{x,y\}=z,\quad \{y,z\}=x,\quad \{z,x\}=y")
    H, K = body.define(r"H=\frac{1}{2}(x^2-z^2)"), body.define("K=x^2+y^2+z^2")
    body.jacobi(), body.casimir(K), body.involution(K, H), body.integrable(H, casimirs=[K])
    body.darboux("x-z", "-y")
    body.states(kinds.LocalDimension, "dimension", "", equations=("x=0",), dimension=2)
    body.states(kinds.AllIntegrals, "all", "", integrals=("x^2-z^2", "x^2+y^2+z^2"), degree=2)
    own = {"cofactor": "-y", "solutions": ("x-z",), "integrals": (), "degree": 1}
    body.states(kinds.AllDarboux, "all-darboux", "", **own)
    return derivation(body.section)


def changed(kind):
    """The certificates of refuted edits of claims of a kind."""
    for one in (*map(load, available()), free_body()):
        session = Session(one, ["flint"])
        for claim in session.derivation.claims:
            if type(claim).__name__ != kind or claim.id in HARD:
                continue
            on = session.on(claim)
            for near in islice(claim.neighbours(on.texts), 40):
                try:
                    statement = Statement(near.claim, on.under(near.texts))
                    denial = statement.search()
                except (Meaningless, NotationError, ZeroDivisionError):
                    continue
                if isinstance(denial, Denial):
                    judge = Judge(finder_of, statement.names)
                    judge.denies(statement.goals[denial.goal], denial.evidence)
                    yield certificate(statement, denial, judge.accepted)


def is_refuted(text):
    found = checker.check(text)
    assert found.sign == json.loads(text)["sign"] == "denied"
    (theorem,) = found.theorems
    said_to_fail = (
        json.loads(text)["goals"][json.loads(text)["evidence"][0]["goal"]]["goal"] == "fails"
    )
    assert theorem.words.startswith("it is false that ") != said_to_fail
    assert (
        any(line.startswith("point: ") for line in theorem.about)
        or "minors" in text
        or said_to_fail
    )


@pytest.mark.parametrize(
    "kind", [pytest.param(kind, marks=pytest.mark.slow if kind in SLOW else []) for kind in KINDS]
)
def test_a_false_claim_of_each_kind_has_a_certificate(kind):
    text = next(printed(kind), None) or next(changed(kind))
    is_refuted(text)


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
    claim = kind("t", top.scene, place, "", **own)
    top.section.claim(claim)
    session = Session(derivation(top.section), ["flint"])
    assert session.decide(claim).verdict == "refuted"
    is_refuted(dict(session.certificates(claim))["t"])
