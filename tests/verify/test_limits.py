"""Limits of time change no verdict: of some claims they leave it open, and say so."""

from random import Random

import pytest

from kowalevski_cas.verify.run import Session
from tests.sample import sampled


@pytest.mark.parametrize("seed", sampled(range(12), 1, seed=4))
def test_a_run_with_limits_says_what_one_without_says_or_nothing(
    derivation, certificates, record, outcomes, seed
):
    rng = Random(seed)
    limit = 10 ** rng.uniform(-2.5, 0)
    only = [claim.id for claim in rng.sample(derivation.claims, 15)]
    limited = Session(
        derivation, ["flint"], certificates=certificates, timeout=limit, record=record
    ).run(only)
    assert sorted(outcome.claim for outcome in limited.outcomes) == sorted(only)
    for outcome in limited.outcomes:
        known = outcomes[outcome.claim]
        match outcome.verdict:
            case "timeout":
                assert outcome.message.startswith(("not decided within", "no correction"))
            case "undecided":
                late = outcome.message.removeprefix("rests on ").split(", ")
                assert {*late} <= {*known.corrected}
            case _:
                assert (outcome.verdict, outcome.digest) == (known.verdict, known.digest)
                assert outcome.conditions == known.conditions
                assert outcome.counterexample == known.counterexample


def test_nothing_that_rests_on_a_claim_without_a_verdict_has_one(
    derivation, certificates, record, outcomes, copies, monkeypatch
):
    """The unit of (9) is misprinted: no verdict that reads i² = −1 is there without its proof."""
    (unit,) = (claim for claim in derivation.claims if claim.id == "eq9.i")
    monkeypatch.setattr(type(unit), "goals", late)
    only = [*_resting(outcomes, "eq9.i")[::8], "eq6"]
    limited = Session(
        derivation, ["flint"], certificates=certificates, timeout=60, record=record
    ).run(only)
    said = {outcome.claim: (outcome.verdict, outcome.message) for outcome in limited.outcomes}
    assert said.pop("eq6") == ("proved", "")
    assert said and set(said.values()) == {("undecided", "rests on eq9.i")}


def late(*_):
    """What a claim meets when its time is over."""
    raise TimeoutError


def _resting(outcomes, id):
    return [name for name, outcome in outcomes.items() if id in outcome.corrected]
