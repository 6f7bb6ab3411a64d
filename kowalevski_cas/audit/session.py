"""A run in which causes are named.

A claim that is refuted, although it would be true if another formula read otherwise, is not
corrected to fit that formula: the place of the formula is the cause, if an edit of it makes the
claim true and nothing is claimed about it.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress
from functools import cached_property
from math import inf

from kowalevski_cas.limits import tell, time_limit
from kowalevski_cas.notation import Edit, Formula, NotationError
from kowalevski_cas.paper.claims import Claim
from kowalevski_cas.paper.texts import Display, Printed, Texts
from kowalevski_cas.verify.blame import Blame, Repairs
from kowalevski_cas.verify.outcome import Correction, Outcome, Verdict
from kowalevski_cas.verify.run import PROVING, Session
from kowalevski_cas.verify.statement import Statement

PATIENCE = 4.0
"""Seconds that a correction, or a misprint in a definition, is sought for."""

AS_BEFORE = "as the derivation has it"
"""The words for a correction that restores what the author has changed."""


class AuditSession(Session):
    """A run over the texts of a derivation, in which each outcome is found once."""

    patience = PATIENCE

    @cached_property
    def causes(self) -> dict[str, tuple[Printed, ...]]:
        """The places that make refuted claims false, by claim."""
        return {}

    @cached_property
    def misprints(self) -> dict[Printed, Edit]:
        """Edits of formulas about which nothing is claimed, by which claims become true."""
        return {}

    @cached_property
    def outcomes(self) -> dict[str, Outcome]:
        """What is said about each claim."""
        claims = self.derivation.claims
        found: dict[str, Outcome] = {}
        for done, claim in enumerate(claims):
            tell(claim.id, done, len(claims))
            found[claim.id] = self.outcome(claim)
        explained = [c.id for c in claims if not self._unexplained(c, found[c.id])]
        verdicts = {id: outcome.verdict for id, outcome in found.items()}
        blame = Blame(self, verdicts, explained, self.patience or inf)
        for id, corrections in self._repairs(blame).items():
            found[id] = self._told(found[id], corrections)
        return found

    def _repairs(self, blame: Blame) -> Repairs:
        """The corrections that are found in time."""
        found: Repairs = {}
        failing = blame.open()
        limit = PROVING * (self.patience or inf)
        with suppress(TimeoutError, RecursionError), time_limit(limit):
            found = blame.shared() if failing else {}
        for claim in failing:
            if claim.id not in found:
                with suppress(TimeoutError, RecursionError), time_limit(limit):
                    found[claim.id] = blame.alone(claim)
        return found

    def _told(self, outcome: Outcome, corrections: Sequence[Correction]) -> Outcome:
        """An outcome with its corrections; one of another formula makes that the cause."""
        for one in corrections[:1]:
            if one.blamed and one.printed is not None and one.edit is not None:
                self.causes[outcome.claim] = (one.printed,)
                self.misprints[one.printed] = one.edit
                return outcome
        return outcome.corrected_by(corrections)

    def _unexplained(self, claim: Claim, outcome: Outcome) -> bool:
        """Whether nothing is known that would make a refuted claim true."""
        refuted = outcome.verdict is Verdict.REFUTED
        return refuted and outcome.correction is None and claim.id not in self.causes

    def repairs(self, display: Display) -> Iterator[tuple[Printed, Edit]]:
        """The edits that make statements of a display true."""
        found = {**self.misprints}
        for outcome in self.outcomes.values():
            proposed = outcome.correction
            if proposed is not None and proposed.printed is not None and proposed.edit is not None:
                found[proposed.printed] = proposed.edit
        yield from ((place, edit) for place, edit in found.items() if place.display == display)

    def _true(self, claim: Claim, texts: Texts) -> bool:
        """Whether a claim holds under other texts."""
        try:
            return Statement(claim, self.on(claim, texts)).holds()
        except TimeoutError:
            raise
        except Exception:  # what an author types must not end the audit of the rest
            return False


def formulas(texts: Texts, display: Display) -> tuple[Formula, ...]:
    """The statements of a display as they are read; none if it cannot be read."""
    try:
        return tuple(statement.formula for statement in texts.statements(display))
    except NotationError:
        return ()
