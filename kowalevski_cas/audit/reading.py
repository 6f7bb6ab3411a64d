"""A run over what was read from a source: what fails is refuted only where the reading is sure."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property

from kowalevski_cas.audit.session import AuditSession
from kowalevski_cas.paper.claims import Claim
from kowalevski_cas.reading import Formula, Reading
from kowalevski_cas.verify.outcome import Outcome, Verdict

FALSE_AS_READ = "false as it was read"


class ReadingSession(AuditSession):
    """A run over a reading.

    A claim is refuted if it has a repair or an ancestor is to blame, or if it is a printed rate or
    integral of a closed, printed law; whatever else fails is undecided, since it may have been read
    otherwise than it was meant.
    """

    def __init__(self, reading: Reading, timeout: float | None = None) -> None:
        super().__init__(reading.derivation, ("flint",), timeout=timeout)
        self.reading = reading
        self.formulas = {f.claim.id: f for f in reading.formulas if f.claim is not None}

    @cached_property
    def outcomes(self) -> dict[str, Outcome]:
        found: Mapping[str, Outcome] = super().outcomes
        return {id: self.as_read(outcome) for id, outcome in found.items()}

    def as_read(self, outcome: Outcome) -> Outcome:
        """An outcome, undecided if what is refuted may have been meant otherwise."""
        if outcome.verdict is not Verdict.REFUTED:
            return outcome
        formula = self.formulas[outcome.claim]
        if outcome.correction is not None or outcome.claim in self.causes or certain(formula):
            return outcome
        return outcome._replace(verdict=Verdict.UNDECIDED, message=FALSE_AS_READ)


def certain(formula: Formula) -> bool:
    """Whether a claim is a printed rate or integral of a law, and nothing was taken for granted."""
    rate = formula.role.kind == "integral" or formula.item.derives
    return rate and not formula.constants


def decide(reading: Reading, timeout: float | None = None) -> ReadingSession:
    """The run over a reading."""
    return ReadingSession(reading, timeout)


__all__ = ["Claim", "ReadingSession", "certain", "decide"]
