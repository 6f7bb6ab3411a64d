"""Who hears how far a reading has come, and who decides claims while it goes on."""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol

from kowalevski_cas.paper.claims import Claim
from kowalevski_cas.reading.statements import SourceStatement
from kowalevski_cas.verify.interpretation import Interpretation
from kowalevski_cas.verify.outcome import Outcome

Heard = Callable[[str, int, int], None]
"""Hears what is being read, how much is done, and of how much."""


class Referee(Protocol):
    """Who decides each claim as soon as it is read: a long paper has its first findings soon."""

    def begin(self, interpretation: Interpretation) -> Callable[[Claim], Outcome]:
        """What decides a claim under an interpretation, in a process of its own."""

    def receive(self, item: SourceStatement, outcome: Outcome) -> Outcome:
        """The outcome for the claim of a statement, as it comes from that process."""
