"""A run over an author's texts: what does not change is decided once.

Where the author differs from the derivation, the cause of what is refuted is the formula in which
what the derivation has would have to be restored.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import suppress
from functools import cached_property
from itertools import zip_longest

from kowalevski_cas.audit.causes import AuditBase, Causes
from kowalevski_cas.audit.restoration import Restoration, with_sources
from kowalevski_cas.audit.session import repaired, unexplained
from kowalevski_cas.limits import tell, time_limit
from kowalevski_cas.notation import Formula
from kowalevski_cas.notation.errors import NotationError
from kowalevski_cas.paper.claims import Claim
from kowalevski_cas.paper.texts import Display, Printed, Texts
from kowalevski_cas.verify.interpretation import Interpretation
from kowalevski_cas.verify.outcome import Outcome, Verdict


class AuthorSession:
    """A run over ``sources``, the displays that an author has typed otherwise than the derivation.

    What rests on displays that are ``refused``, and claims in ``other`` words than the derivation
    quotes, gets no verdict, but the reason. Nothing of it is kept in ``base``, the run over the
    derivation's own texts.
    """

    def __init__(
        self,
        base: AuditBase,
        sources: Mapping[Display, str],
        refused: Mapping[Display, str],
        other: Mapping[str, str],
    ) -> None:
        self.base = base
        self._refused, self._other = refused, other
        before = base.decider.interpretation
        self.interpretation: Interpretation = before.under(with_sources(before.texts, sources))
        self.decider = base.decider.under(self.interpretation)
        self.changed = frozenset(
            printed for display in sources for printed in self._changes(display)
        )
        """The statements that are not those of the derivation."""
        self._known = base.outcomes
        self.causes = Causes(base.causes)
        self._restoration = Restoration(base, self.decider, self.changed, self.causes)

    def _changes(self, display: Display) -> Iterator[Printed]:
        before = self.base.decider.interpretation.texts
        new, old = formulas(self.interpretation.texts, display), formulas(before, display)
        for number, (one, other) in enumerate(zip_longest(new, old), 1):
            if one != other:
                yield display[number]

    @cached_property
    def outcomes(self) -> dict[str, Outcome]:
        """What is said about each claim."""
        claims = self.interpretation.derivation.claims
        found: dict[str, Outcome] = {}
        for done, claim in enumerate(claims):
            tell(claim.id, done, len(claims))
            outcome = self._decide(claim)
            found[claim.id] = self.decider.writer.resting(claim, outcome, self.base.stands)
        new = [outcome for id, outcome in found.items() if outcome is not self._known[id]]
        return repaired(found, unexplained(new, self.causes), self.decider, self.causes)

    def _decide(self, claim: Claim) -> Outcome:
        """The outcome for a claim: that of the derivation, if its problem is the same."""
        if why := self._other.get(claim.id) or self._refusal(claim):
            on = self.interpretation.on(claim)
            return self.decider.writer.without_evidence(claim, on, Verdict.UNDECIDED, why)
        known = self._known[claim.id]
        if not claim.reads() & self.changed or self._is_same(claim, known):
            return known
        self.causes.places.pop(claim.id, None)
        outcome = self.decider.decide(claim, self._restoration)
        unclear = outcome.verdict in (Verdict.ERROR, Verdict.UNDECIDED, Verdict.TIMEOUT)
        with suppress(TimeoutError), time_limit(self.decider.timeout):
            if unclear and not self._restoration.blames_changes(claim):
                restored = self._restoration.restored(claim, self.interpretation.on(claim))
                outcome = outcome._replace(correction=restored)
        return outcome

    def _refusal(self, claim: Claim) -> str:
        """Why nothing is said about a claim that rests on a display which is refused."""
        ids = {
            p.display.id: self._refused[p.display]
            for p in claim.reads()
            if p.display in self._refused
        }
        return "; ".join(f"{id}: {ids[id]}" for id in sorted(ids))

    def _is_same(self, claim: Claim, known: Outcome) -> bool:
        """Whether a claim that is true in the derivation is typed as the same problem."""
        try:
            with time_limit(self.decider.timeout):
                said = claim.formulas(self.interpretation.on(claim).texts)
                if said != known.formulas or not known.verdict.green:
                    return False
                return self.interpretation.statement(claim).digest == known.digest
        except Exception:  # then deciding it says why
            return False


def formulas(texts: Texts, display: Display) -> tuple[Formula, ...]:
    """The statements of a display as they are read; none if it cannot be read."""
    try:
        return tuple(statement.formula for statement in texts.statements(display))
    except NotationError:
        return ()
