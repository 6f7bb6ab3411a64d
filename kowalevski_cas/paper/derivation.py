"""A derivation: displays and claims in the order of the paper, loaded from a folder."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field

from kowalevski_cas.paper.claims.claim import Claim
from kowalevski_cas.paper.closed_form import ClosedForm
from kowalevski_cas.paper.scene import Change, Locus, Scene, vocabulary
from kowalevski_cas.paper.texts import Display, Printed, Texts


@dataclass(eq=False)
class Section:
    """A section of a paper: it collects displays and claims in the order of the paper."""

    number: str
    title: str
    displays: list[Display] = field(default_factory=list)
    claims: list[Claim] = field(default_factory=list)
    accepted: dict[Printed, str] = field(default_factory=dict)

    def display(self, id: str, tex: str) -> Display:
        """A displayed formula, as printed."""
        return self._add(Display(id, tex, self.number))

    def inline(self, id: str, tex: str) -> Display:
        """A formula in running text, as printed."""
        return self._add(Display(id, tex, self.number, inline=True))

    def lemma(self, id: str, tex: str, source: str) -> Display:
        """A formula that the paper uses and does not print, with its source."""
        return self._add(Display(id, tex, self.number, source=source))

    def claim(self, *claims: Claim) -> None:
        """Statements that the paper makes here; raises ``TypeError`` for anything else."""
        for claim in claims:
            if not isinstance(claim, Claim):
                raise TypeError(f"a claim is expected, not {claim!r}")
            self.claims.append(claim)

    def accept(self, printed: Printed, tex: str) -> None:
        """Read this in place of what is printed, in all that follows from it.

        The program proposes corrections, and takes none by itself: every verdict that rests on
        an accepted one says so.
        """
        self.accepted[printed] = tex

    def _add(self, display: Display) -> Display:
        self.displays.append(display)
        return display


@dataclass(eq=False)
class Derivation:
    """A paper as a sequence of sections.

    ``closed_form`` gives what motions are computed with, if the paper solves its problem.
    """

    name: str
    title: str
    author: str
    source: str
    sections: tuple[Section, ...]
    closed_form: Callable[[], ClosedForm] | None = None

    def __post_init__(self) -> None:
        """Refuse ids that are given twice, for everything goes by them."""
        for kind, ids in (
            ("claims", [claim.id for claim in self.claims]),
            ("displays", [display.id for display in self.displays()]),
        ):
            twice = sorted({id for id in ids if ids.count(id) > 1})
            if twice:
                raise ValueError(f"two {kind} are called {twice[0]}")

    @property
    def claims(self) -> tuple[Claim, ...]:
        """All claims in the order of the paper."""
        return tuple(claim for section in self.sections for claim in section.claims)

    def scenes(self) -> tuple[Scene, ...]:
        """The scenes on which the claims stand, and those from which they are changes."""
        found: dict[Scene, None] = {}
        for claim in self.claims:
            for scene in claim.scenes():
                found[scene] = None
                if isinstance(scene.field, Change):
                    found[scene.field.source] = None
        return tuple(found)

    def texts(self, sources: Mapping[str, str] | None = None) -> Texts:
        """The texts of the derivation, to be read in the words of its scenes.

        ``sources`` holds displays, by id, whose source is another one.
        """
        return Texts(vocabulary(self.scenes()), sources)

    @property
    def accepted(self) -> dict[Printed, str]:
        """What is read in place of what is printed, by places."""
        return {place: tex for section in self.sections for place, tex in section.accepted.items()}

    def section_of(self, claim: Claim) -> Section:
        """The section in which a claim stands."""
        return next(section for section in self.sections if claim in section.claims)

    def displays(self) -> Iterator[Display]:
        """All displays in the order of the paper."""
        for section in self.sections:
            yield from section.displays


__all__ = ["Change", "Derivation", "Locus", "Scene", "Section"]
