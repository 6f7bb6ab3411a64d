"""A run in which causes are named.

A claim that is refuted, although it would be true if another formula read otherwise, is not
corrected to fit that formula: the place of the formula is the cause, if an edit of it makes the
claim true and nothing is claimed about it.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import suppress
from functools import cached_property

from kowalevski_cas.limits import tell, time_limit
from kowalevski_cas.notation import Edit, Formula, NotationError, edits
from kowalevski_cas.paper.claims import Claim, Neighbour
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.texts import Display, Printed, Texts
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.verify.corrections import true_ones
from kowalevski_cas.verify.outcome import Outcome, Verdict
from kowalevski_cas.verify.run import Session
from kowalevski_cas.verify.statement import Statement

PATIENCE = 2.0
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
        for claim in claims:
            if self._unexplained(claim, found[claim.id]):
                for id in self._misprint(claim, found):
                    found[id] = found[id]._replace(correction=None)
        return found

    def _unexplained(self, claim: Claim, outcome: Outcome) -> bool:
        """Whether nothing is known that would make a refuted claim true."""
        refuted = outcome.verdict is Verdict.REFUTED
        return refuted and outcome.correction is None and claim.id not in self.causes

    def _misprint(self, claim: Claim, outcomes: Mapping[str, Outcome]) -> list[str]:
        """The refuted claims that one edit elsewhere makes true, this one among them.

        Of the edits that leave true what is true, the one is taken that makes most claims true.
        """
        best: tuple[Neighbour, list[str]] | None = None
        claims = self.derivation.claims
        on = self.on(claim)
        with (
            suppress(TimeoutError, NotationError, Meaningless, RecursionError),
            time_limit(self.patience),
        ):
            for found in true_ones(self._elsewhere(claim, on), on.apart(on.texts)):
                assert found.printed is not None and found.edit is not None
                texts = self.texts.edited(found.printed, found.edit)
                about = [c for c in claims if found.printed in c.reads()]
                green = (c for c in about if outcomes[c.id].verdict.green)
                if not all(self._true(c, texts) for c in green):
                    continue
                refuted = [c for c in about if outcomes[c.id].verdict is Verdict.REFUTED]
                mended = [c.id for c in refuted if self._true(c, texts)]
                if best is None or len(mended) > len(best[1]):
                    best = found, mended
                if len(mended) == len(refuted):
                    break
        if best is None or best[0].printed is None or best[0].edit is None:
            return []
        self.misprints[best[0].printed] = best[0].edit
        self.causes.update((id, (best[0].printed,)) for id in best[1])
        return best[1]

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

    def _elsewhere(self, claim: Claim, on: Elaborations) -> Iterator[Neighbour]:
        """A claim with one edit of a formula on which it stands, and which no claim is about."""
        names = frozenset(claim.scene.names()) - {*claim.scene.undefined}
        for printed in Statement(claim, on).stands_on:
            if printed not in self.established and printed not in self.accepted:
                for edit in edits(on.texts.statement(printed), on.texts.vocabulary, names):
                    yield Neighbour(edit.words, claim, on.texts, printed, edit)


def formulas(texts: Texts, display: Display) -> tuple[Formula, ...]:
    """The statements of a display as they are read; none if it cannot be read."""
    try:
        return tuple(statement.formula for statement in texts.statements(display))
    except NotationError:
        return ()
