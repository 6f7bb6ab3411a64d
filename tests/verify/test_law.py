"""The law of verdicts is asked of what tests decide, and told where it is broken."""

import pytest

from kowalevski_cas.paper.claims import FirstIntegral
from kowalevski_cas.verify.outcome import Verdict
from kowalevski_cas.verify.run import Session
from tests import law
from tests.paper.small import Oscillator, derivation


def decided():
    small = Oscillator()
    small.section.claim(FirstIntegral("t", small.scene, "", printed=small("x^2+v^2")))
    session = Session(derivation(small.section), ["flint"])
    (claim,) = session.derivation.claims
    return session.decider, claim, session.outcome(claim)


def test_what_is_decided_here_obeys_it():
    law.uphold(*decided())


@pytest.mark.parametrize(
    "broken",
    [
        {"certificate": ""},
        {"verdict": Verdict.REFUTED},
        {"verdict": Verdict.CONDITIONAL},
        {"verdict": Verdict.UNDECIDED},
        {"digest": "0" * 16},
        {"message": "the arithmetics disagree"},
    ],
    ids=str,
)
def test_what_breaks_it_is_told(broken):
    decider, claim, outcome = decided()
    with pytest.raises(AssertionError):
        law.uphold(decider, claim, outcome._replace(**broken))


def test_what_breaks_the_law_fails_wherever_it_is_decided(monkeypatch):
    monkeypatch.setattr(law, "ONE_IN", 1)
    monkeypatch.setattr(law, "_upheld", set())
    monkeypatch.setattr("kowalevski_cas.verify.outcome_writer.disagreement", lambda _: True)
    with pytest.raises(AssertionError, match="disagree"):
        decided()
