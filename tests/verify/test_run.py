"""The run: verdicts, disagreements, limits of time, errors that are outcomes."""

import signal
import time
from dataclasses import dataclass, field

import pytest

from kowalevski_cas.paper.claims import Claim, Finding, Identity
from kowalevski_cas.claims.claim import green
from kowalevski_cas.verify.limits import time_limit
from kowalevski_cas.verify.outcome import Verdict
from tests.paper.small import Oscillator, decide, verdicts

ALL = ("flint", "symengine", "sympy")


@dataclass(frozen=True, eq=False)
class Fickle(Claim):
    """A claim whose finding depends on the arithmetic."""

    findings: dict

    def decide(self, bench):
        return Finding(Verdict(self.findings[bench.arithmetic]))


@dataclass(frozen=True, eq=False)
class Slow(Claim):
    slow_in: tuple = ALL
    woken: list = field(default_factory=list)

    def decide(self, bench):
        if bench.arithmetic in self.slow_in:
            time.sleep(5)
            self.woken.append(bench.arithmetic)
        return green(())


@pytest.fixture
def small():
    return Oscillator()


def test_arithmetics_that_disagree_are_an_error(small):
    claim = Fickle(
        "t", small.scene, None, "", dict(zip(ALL, ("proved", "refuted", "proved"), strict=True))
    )
    (outcome,) = decide(small.section, claim, arithmetics=ALL)
    assert outcome.verdict == "error"
    assert (
        outcome.message
        == "the arithmetics disagree (flint: proved, symengine: refuted, sympy: proved)"
    )


def test_a_claim_that_takes_too_long_is_a_timeout(small):
    claim = Slow("t", small.scene, None, "")
    (outcome,) = decide(small.section, claim, timeout=0.05)
    assert outcome.verdict == "timeout" and not claim.woken
    assert outcome.message == "not decided within 0.05 s by flint"


def test_a_limit_of_time_is_taken_away_again():
    with time_limit(60):
        assert signal.getitimer(signal.ITIMER_REAL)[0] > 0
    assert signal.getitimer(signal.ITIMER_REAL) == (0, 0)
    with pytest.raises(TimeoutError), time_limit(0.02):
        time.sleep(5)
    with time_limit(None):
        pass


def test_a_timeout_in_one_arithmetic_is_a_timeout(small):
    claim = Slow("t", small.scene, None, "", slow_in=("sympy",))
    (outcome,) = decide(small.section, claim, arithmetics=ALL, timeout=0.1)
    assert outcome.verdict == "timeout"


def test_a_formula_that_cannot_be_read_is_an_error_of_its_claim_only(small):
    bad = Identity("bad", small.scene, small("x = ("), "")
    good = Identity("good", small.scene, small(r"\dot x = v"), "")
    bad, good = decide(small.section, bad, good)
    assert (bad.verdict, good.verdict) == ("error", "proved")
    assert "x = (" in bad.message and bad.digest == "" and bad.rests_on == ()


def test_a_statement_that_is_not_there_is_an_error(small):
    (outcome,) = decide(small.section, Identity("t", small.scene, small("x=x", 3), ""))
    assert outcome.verdict == "error"
    assert "statement 3 is asked for, there are 1" in outcome.message


def test_a_name_without_meaning_on_the_scene_is_an_error(small):
    (outcome,) = decide(
        small.section,
        Identity("t", small.old, small("x=k"), ""),
        Identity("u", small.scene, small("k=k"), ""),
    )[:1]
    assert outcome.verdict == "error"
    assert "k has no meaning on the scene “oscillator with the unit”" in outcome.message


def test_an_undeclared_name_is_an_error_with_a_caret(small):
    (outcome,) = decide(small.section, Identity("t", small.scene, small("y = x"), ""))
    lines = outcome.message.splitlines()
    assert lines[-2].strip() == "y = x" and lines[-1].strip() == "^"


def test_a_corrected_formula_is_the_one_on_which_later_claims_stand(small):
    later = Identity("later", small.scene, small("2E=x^2+v^2"), "")
    wrong = small(r"v=-\dot x")
    found = decide(small.section, Identity("wrong", small.scene, wrong, ""), later)
    assert [str(o.verdict) for o in found] == ["refuted", "proved"]
    assert found[0].correction.verdict == "proved"


def test_sources_are_read_instead_of_what_is_printed(small):
    tex = small("x=v")
    assert verdicts(
        small.section, Identity("t", small.scene, tex, ""), sources={tex.display.id: "x=x"}
    ) == ["proved"]


def test_costs_are_the_same_from_run_to_run(run, derivation):
    assert all(outcome.products >= 0 for outcome in run.outcomes)
    assert set(run.outcomes[0].seconds) == set(ALL)


def test_an_id_is_given_once(small):
    claims = [
        Identity("t", small.scene, small("x=x"), ""),
        Identity("t", small.scene, small("x=v"), ""),
    ]
    with pytest.raises(ValueError):
        decide(small.section, *claims)
