"""Which printed formulas make claims false, as far as an audit has found them."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping
from typing import Protocol

from kowalevski_cas.notation import Edit, Formula
from kowalevski_cas.paper.texts import Display, Printed, edited_formulas
from kowalevski_cas.verify.decider import Decider
from kowalevski_cas.verify.outcome import Correction, Outcome


class Causes:
    """The places that make claims false, and the edits by which claims become true."""

    def __init__(self, of: Causes | None = None) -> None:
        self.places: dict[str, tuple[Printed, ...]] = {} if of is None else {**of.places}
        """The places that make refuted claims false, by claim."""
        self.corrections: dict[str, Correction] = {} if of is None else {**of.corrections}
        """How other formulas should read by which claims become true, as it was proved."""
        self.misprints: dict[Printed, Edit] = {} if of is None else {**of.misprints}
        """Edits of formulas about which nothing is claimed, by which claims become true."""

    def blame(self, claim: str, correction: Correction | None) -> bool:
        """Whether a correction is one of another formula, which then is the cause."""
        if correction is None or not correction.blamed:
            return False
        if correction.printed is None or correction.edit is None:
            return False
        self.places[claim] = (correction.printed,)
        self.corrections[claim] = correction
        self.misprints[correction.printed] = correction.edit
        return True

    def mended(self, places: Collection[Printed] | None = None) -> dict[Printed, Formula]:
        """What the misprints, or those at these places, should read."""
        found: dict[Printed, Formula] = {}
        for place, edit in self.misprints.items():
            if places is None or place in places:
                found |= edited_formulas(place, edit)
        return found

    def repairs(
        self, display: Display, outcomes: Iterable[Outcome]
    ) -> Iterator[tuple[Printed, Edit]]:
        """The edits that make statements of a display true, those of corrections among them."""
        found = {**self.misprints}
        for outcome in outcomes:
            proposed = outcome.correction
            if proposed is not None and proposed.printed is not None and proposed.edit is not None:
                found[proposed.printed] = proposed.edit
        yield from ((place, edit) for place, edit in found.items() if place.display == display)


class AuditBase(Protocol):
    """A derivation of which every claim was decided, and what makes claims false was sought."""

    causes: Causes

    @property
    def decider(self) -> Decider:
        """What decides the claims."""

    @property
    def outcomes(self) -> Mapping[str, Outcome]:
        """What is said about each claim."""

    def stands(self, id: str) -> bool:
        """Whether the correction of a claim that its derivation accepts is proved."""
