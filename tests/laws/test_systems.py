"""What no way of writing a derivation down may change."""

import json
import random
import re
from dataclasses import replace

import pytest

from kowalevski_cas.algebra import EXACT
from kowalevski_cas.problem import checker
from kowalevski_cas.verify.run import Session
from tests.laws.systems import NAME, SYSTEMS, System
from tests.sample import sampled

pytestmark = pytest.mark.usefixtures("uncorrected", "here")

GREEN = ("proved", "conditional")


@pytest.fixture(params=sampled(SYSTEMS, 2, seed=4, id=lambda system: system.name))
def system(request) -> System:
    return request.param


def verdicts(system: System, arithmetics=("flint",), only=()) -> dict[str, str]:
    """The verdicts by claim, the same in each arithmetic."""
    run = Session(system.derivation(), arithmetics).run(only)
    for outcome in run.outcomes:
        assert {str(v) for v in outcome.verdicts.values()} == {str(outcome.verdict)}
    return {outcome.claim: str(outcome.verdict) for outcome in run.outcomes}


def wanted(system: System) -> dict[str, str]:
    return {f"s{k}": stated.verdict for k, stated in enumerate(system.statements)}


@pytest.mark.parametrize("system", sampled(SYSTEMS, 1, seed=4, id=lambda system: system.name))
def test_each_statement_has_its_verdict_in_every_arithmetic(system):
    assert verdicts(system, EXACT) == wanted(system)


def test_each_verdict_has_a_certificate(system):
    session = Session(system.derivation(), ("flint",))
    for claim in session.derivation.claims:
        text = session.outcome(claim).certificate
        found = checker.check(text)
        assert found.claim == claim.id
        assert (found.sign == "holds") == (wanted(system)[claim.id] in GREEN)


def test_a_claim_alone_has_the_verdict_that_it_has_among_all(system):
    for claim, verdict in wanted(system).items():
        assert verdicts(system, only=(claim,)) == {claim: verdict}


def test_the_order_of_statements_does_not_matter(system):
    count = len(system.statements)
    order = random.Random(7).sample(range(count), count)
    shuffled = replace(system, statements=tuple(system.statements[k] for k in order))
    assert verdicts(shuffled) == {
        f"s{k}": system.statements[j].verdict for k, j in enumerate(order)
    }


@pytest.mark.slow
def test_without_one_statement_the_others_keep_their_verdicts(system):
    for gone in range(len(system.statements)):
        rest = system.statements[:gone] + system.statements[gone + 1 :]
        fewer = replace(system, statements=rest)
        assert verdicts(fewer) == wanted(fewer)


def test_names_do_not_matter(system):
    names = [*system.variables, *system.constants, *([system.root[0]] if system.root else [])]
    other = {name: f"k_{number}" for number, name in enumerate(reversed(names), 1)}
    assert verdicts(system.with_names(other)) == wanted(system)


def test_the_order_of_variables_does_not_matter(system):
    turned = replace(system, variables=system.variables[::-1], motion=system.motion[::-1])
    assert verdicts(turned) == wanted(system)


def swapped(tex: str) -> str:
    """An equation with its sides exchanged; anything else as it is."""
    sides = tex.split("=")
    return f"{sides[1]}={sides[0]}" if len(sides) == 2 else tex


def multiplied(tex: str) -> str:
    """Three times both sides of an equation; anything else as it is."""
    sides = tex.split("=")
    return "=".join(f"3({side})" for side in sides) if len(sides) == 2 else tex


DEFINING = ("independence",)
"""These statements define a name, which has to stand alone on its side."""


@pytest.mark.parametrize("change", sampled([swapped, multiplied], 1))
def test_an_equation_written_otherwise_says_the_same(system, change):
    statements = tuple(
        s
        if s.about in DEFINING
        else replace(s, tex=tuple(map(change, s.tex)), given=tuple(map(change, s.given)))
        for s in system.statements
    )
    written = replace(system, statements=statements)
    assert verdicts(written) == wanted(system)


SIGNS = {"+": "-", "-": "+", "2": "3", "3": "2"}
TOKEN = re.compile(rf"[-+23]|{NAME.pattern}")


def changes(system: System):
    """The system with one token of its equations of motion changed, in each way."""
    for row, tex in enumerate(system.motion):
        for found in TOKEN.finditer(tex, tex.index("=")):
            others = [SIGNS[found[0]]] if found[0] in SIGNS else system.variables
            for other in others:
                if other != found[0] and not found[0].startswith((r"\dot", r"\frac")):
                    new = tex[: found.start()] + other + tex[found.end() :]
                    yield (
                        new,
                        replace(
                            system, motion=(*system.motion[:row], new, *system.motion[row + 1 :])
                        ),
                    )


@pytest.mark.parametrize("many", [1, pytest.param(4, marks=pytest.mark.slow)])
def test_another_motion_changes_a_verdict_or_is_certified_as_it_is(system, many):
    found = list(changes(system))
    own = Session(system.derivation(), ("flint",))
    printed = {claim.id: claim for claim in own.derivation.claims}
    for new, other in random.Random(2).sample(found, min(many, len(found))):
        session = Session(other.derivation(), ("flint",))
        for claim in session.derivation.claims:
            outcome = session.decide(claim)
            if str(outcome.verdict) not in GREEN:
                continue
            text = session.outcome(claim).certificate
            certified = checker.check(text)
            assert certified.sign == "holds"
            assert json.loads(text)["digest"] == outcome.digest
            if '"field"' in text:  # it speaks of the motion: of the changed one
                before = own.outcome(printed[claim.id]).certificate
                assert json.loads(before)["spaces"] != json.loads(text)["spaces"], new
