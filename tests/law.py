"""The law of every verdict: what a run prints green or red is what a record has.

It is asked of each statement that any test of a run decides; in a quick run of one in many, which
the digest chooses.
"""

import json
from pathlib import Path

from kowalevski_cas.algebra import EXACT
from kowalevski_cas.problem import checker
from kowalevski_cas.verify import record
from kowalevski_cas.verify.archive import Archive
from kowalevski_cas.verify.arithmetics import Arithmetics
from kowalevski_cas.verify.certificate import Stored
from kowalevski_cas.verify.decider import Decider
from kowalevski_cas.verify.outcome import CORRECTED, Verdict
from tests.problem.second_ring import compared

ONE_IN = 32

_upheld = set()


class KnownAs:
    """The corrections of a claim that is decided again: those that it has."""

    def __init__(self, outcome):
        self.outcome = outcome

    def known(self, _):
        return [*filter(None, (self.outcome.correction, *self.outcome.alternatives))]

    def accept(self, _, outcome):
        return outcome


def is_asked(outcome, all_of_them):
    """Whether the law is asked of an outcome: once, and seldom if not of ``all_of_them``."""
    place = int(outcome.digest or "1", 16)
    new = outcome.digest not in _upheld
    _upheld.add(outcome.digest)
    return not outcome.digest or (new and (all_of_them or place % ONE_IN == 0))


def uphold(decider, claim, outcome):
    """Raise an ``AssertionError`` unless what was printed is recorded, and certified alone."""
    assert "disagree" not in outcome.message, f"{outcome.claim}: {outcome.message}"
    assert bool(outcome.certificate) == outcome.needs_certificate, outcome
    if not outcome.needs_certificate:
        return
    for name, text in outcome.certificates.items():
        with compared():
            found = checker.check(text)
        corrected = name.startswith(CORRECTED)
        digest = outcome.correction.digest if corrected else outcome.digest
        refuted = outcome.verdict is Verdict.REFUTED and not corrected
        assert found.digest == digest and (found.sign == "denied") == refuted, name
    again = recorded(decider, claim, outcome)
    if again.verdict is not Verdict.TIMEOUT:
        assert record.describe(again) == record.describe(outcome)
        assert (again.note, again.certificates) == ("", outcome.certificates)


def recorded(decider, claim, outcome):
    """What `record` says of a claim with the certificate of its outcome, read back."""
    stored = {n: Stored(Path(n), json.loads(t)) for n, t in outcome.certificates.items()}
    three = Decider(
        decider.interpretation, Arithmetics(EXACT), Archive(stored), timeout=decider.timeout
    )
    return three.decide.__wrapped__(three, claim, KnownAs(outcome))
