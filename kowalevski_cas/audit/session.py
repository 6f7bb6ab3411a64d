"""A run in which causes are named.

A claim that is refuted, although it would be true if another formula read otherwise, is not
corrected to fit that formula: the place of the formula is the cause, if an edit of it makes the
claim true and nothing is claimed about it.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from contextlib import suppress
from functools import cached_property
from math import inf

from kowalevski_cas.audit.causes import Causes
from kowalevski_cas.limits import tell, time_limit
from kowalevski_cas.paper.derivation import Derivation
from kowalevski_cas.verify.blame import Blame
from kowalevski_cas.verify.certificate import Stored
from kowalevski_cas.verify.decider import PROVING, Decider
from kowalevski_cas.verify.interpretation import Interpretation
from kowalevski_cas.verify.outcome import Outcome, Verdict
from kowalevski_cas.verify.run import Session
from kowalevski_cas.verify.suspects import Repairs

PATIENCE = 4.0
"""Seconds that a correction, or a misprint in a definition, is sought for."""


class AuditSession:
    """A run over the texts of a derivation, in which each outcome is found once.

    The arguments are those of a run; ``patience`` are the seconds that a correction is sought for.
    """

    def __init__(
        self,
        derivation: Derivation,
        arithmetics: Sequence[str],
        explain: bool = False,
        certificates: Mapping[str, Stored] | None = None,
        timeout: float | None = None,
        record: Mapping[str, Mapping[str, object]] | None = None,
        patience: float = PATIENCE,
    ) -> None:
        self._session = Session(
            derivation, arithmetics, explain, certificates, timeout, record=record,
            patience=patience,
        )  # fmt: skip
        self.causes = Causes()

    @property
    def decider(self) -> Decider:
        """What decides the claims."""
        return self._session.decider

    @property
    def interpretation(self) -> Interpretation:
        """What the claims say."""
        return self.decider.interpretation

    @cached_property
    def outcomes(self) -> dict[str, Outcome]:
        """What is said about each claim."""
        claims = self.interpretation.derivation.claims
        found: dict[str, Outcome] = {}
        for done, claim in enumerate(claims):
            tell(claim.id, done, len(claims))
            found[claim.id] = self._session.outcome(claim)
        return repaired(found, unexplained(found.values(), self.causes), self.decider, self.causes)

    def stands(self, id: str) -> bool:
        """Whether the correction of a claim that its derivation accepts is proved."""
        return self._session.stands(id)


def unexplained(outcomes: Collection[Outcome], causes: Causes) -> set[str]:
    """The refuted claims of which nothing is known that would make them true."""
    refuted = (o for o in outcomes if o.verdict is Verdict.REFUTED and o.correction is None)
    return {outcome.claim for outcome in refuted} - causes.places.keys()


def repaired(
    outcomes: dict[str, Outcome], failing: Collection[str], decider: Decider, causes: Causes
) -> dict[str, Outcome]:
    """The outcomes with corrections of claims that fail; one of another formula is the cause."""
    found = {**outcomes}
    verdicts = {id: outcome.verdict for id, outcome in outcomes.items()}
    explained = [id for id in outcomes if id not in failing]
    blame = Blame(decider.corrector, verdicts, explained, decider.patience or inf)
    for id, corrections in _repairs(blame, PROVING * (decider.patience or inf)).items():
        if not causes.blame(id, corrections[0] if corrections else None):
            found[id] = found[id].corrected_by(corrections)
    return found


def _repairs(blame: Blame, limit: float) -> Repairs:
    """The corrections that are found in time."""
    found: Repairs = {}
    for cluster in blame.clusters():
        with suppress(TimeoutError, RecursionError), time_limit(limit):
            found |= blame.shared(cluster)
    for claim in blame.open():
        if claim.id not in found:
            with suppress(TimeoutError, RecursionError), time_limit(limit):
                found[claim.id] = blame.alone(claim)
    return found
