"""What the claims of a derivation say: under which texts, and on which corrections they rest."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Sequence
from functools import cached_property
from typing import Final

from kowalevski_cas.notation import Formula
from kowalevski_cas.paper.claims import Claim
from kowalevski_cas.paper.derivation import Derivation
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.texts import Printed, Texts
from kowalevski_cas.verify.statement import Statement

_CITED: Final = re.compile(r"\\(?:eq)?ref\{([^{}]*)\}")


class Interpretation:
    """The reading of a derivation, with the corrections that it accepts.

    Args:
        derivation: whose claims are read.
        texts: are read instead of what the derivation prints, or are what it prints.
        elaborations: of its scenes under these texts, as far as they were made.
    """

    def __init__(
        self,
        derivation: Derivation,
        texts: Texts | None = None,
        elaborations: Elaborations | None = None,
    ) -> None:
        self.derivation = derivation
        self.texts = texts or derivation.texts()
        self.elaborations = elaborations or Elaborations(self.texts)
        self.accepted: dict[Printed, Formula] = {
            place: self.texts.expression(tex) for place, tex in derivation.accepted.items()
        }
        """What the derivation accepts in place of what is printed."""
        self.bases = {base.name: base for base in derivation.bases()}
        self._order = {claim.id: k for k, claim in enumerate(derivation.claims)}
        self._sections = {
            claim.id: section.number for section in derivation.sections for claim in section.claims
        }
        self._established = derivation.established
        self._establishing = defaultdict[str, list[tuple[int, str]]](list)
        """The claims that establish something at a display, by its id, with their order."""
        for k, (place, id) in enumerate(self._established.items()):
            self._establishing[place.display.id].append((k, id))
        self._read_elsewhere: dict[Printed, str] = {}
        """What is read as another derivation accepts it, by the claims there."""
        for name, base in self.bases.items():
            known = base.established
            for place in base.accepted:
                self._read_elsewhere[place] = f"{name}/{known.get(place, place.place)}"

    def under(self, texts: Texts) -> Interpretation:
        """The same derivation under other texts, of which the elaborations here do not hear."""
        return Interpretation(self.derivation, texts, self.elaborations.apart(texts))

    def on(self, claim: Claim, texts: Texts | None = None) -> Elaborations:
        """The texts for a claim, these or others: with the accepted corrections.

        Those that it is about itself are left out.
        """
        about = set(claim.about())
        read = {place: f for place, f in self.accepted.items() if place not in about}
        texts = texts or self.texts
        return self.elaborations.under(texts.reading(read) if read else texts)

    def readers(self, place: Printed) -> Sequence[Claim]:
        """The claims of which a verdict can depend on a place."""
        return self._readers.get(place, ())

    @cached_property
    def _readers(self) -> dict[Printed, list[Claim]]:
        found = defaultdict[Printed, list[Claim]](list)
        for claim in self.derivation.claims:
            for place in claim.reads():
                found[place].append(claim)
        return dict(found)

    def section_of(self, claim: Claim) -> str:
        """The number of the section in which a claim stands."""
        return self._sections[claim.id]

    def statement(self, claim: Claim, texts: Texts | None = None) -> Statement:
        """What a claim says, under these texts or others."""
        return Statement(claim, self.on(claim, texts))

    def holds(self, claim: Claim, texts: Texts) -> bool:
        """Whether a claim is proved under other texts, whatever they are."""
        try:
            return self.statement(claim, texts).holds()
        except TimeoutError:
            raise
        except Exception:  # what an author types must not end the rest
            return False

    def corrections_used(self, statement: Statement) -> tuple[str, ...]:
        """The claims whose accepted corrections a statement rests on.

        Those of another derivation come first, after its name and a slash.
        """
        about, used = set(statement.claim.about()), {*statement.stands_on}
        ids = [id for place, id in self._read_elsewhere.items() if place in used]
        ids += [
            self._established.get(place, place.place)
            for place in self.accepted
            if place in used and place not in about
        ]
        return tuple(dict.fromkeys(ids))

    def rests_on(self, statement: Statement) -> tuple[str, ...]:
        """The claims before this one that establish the places on which it stands."""
        ids = dict.fromkeys(self._established.get(place) for place in statement.stands_on)
        before = self._order[statement.claim.id]
        return tuple(i for i in ids if i is not None and self._order[i] < before)

    def cites(self, claim: Claim) -> tuple[str, ...]:
        """The claims before this one about the displays that the paper cites for it."""
        shown = {*_CITED.findall(claim.sentence)}
        shown |= {id for place in claim.establishes() for id in place.display.cites}
        found = sorted(pair for id in shown for pair in self._establishing.get(id, ()))
        before = self._order[claim.id]
        return tuple(dict.fromkeys(id for _, id in found if self._order[id] < before))
