"""A derivation: displays and claims in the order of the paper, loaded from a folder."""

from __future__ import annotations

import re
import sys
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from enum import Enum
from typing import Any, TypeVar

from kowalevski_cas.paper.claims import Claim, Identity
from kowalevski_cas.paper.scene import Change, Locus, Scene
from kowalevski_cas.paper.texts import Display, Printed, Texts, statements
from kowalevski_cas.paper.vocabulary import vocabulary

Says = str | Sequence[str]
Shown = TypeVar("Shown", Display, Printed)


@dataclass(eq=False)
class Section:
    """A section of a paper: it collects displays and claims in the order of the paper.

    ``copied`` says whether its displays are what the edition prints, sign by sign, or restate it;
    it is ``None`` if no edition has them, since they are derived here.
    ``lines`` has the file and the line in which a claim is stated, by its id, and ``expected`` the
    verdict that its author expects, where he says so. ``scenes`` are those of which something may
    be asked, by their names, even if nothing is claimed there.
    """

    number: str
    title: str
    copied: bool | None = True
    displays: list[Display] = field(default_factory=list)
    claims: list[Claim] = field(default_factory=list)
    accepted: dict[Printed, str] = field(default_factory=dict)
    lines: dict[str, tuple[str, int]] = field(default_factory=dict)
    expected: dict[str, str] = field(default_factory=dict)
    scenes: dict[str, Scene] = field(default_factory=dict)

    def display(
        self, id: str, tex: str, label: str = "", *, cites: tuple[str, ...] = ()
    ) -> Display:
        """A displayed formula; ``eq3`` is labelled (3) if nothing else is said.

        It ``cites`` the displays of these ids, in the words that lead to it.
        """
        return self._add(id, tex, label=label or _label(id), cites=cites)

    def inline(self, id: str, tex: str, label: str = "") -> Display:
        """A formula in running text."""
        return self._add(id, tex, inline=True, label=label)

    def lemma(self, id: str, tex: str, source: str) -> Display:
        """A formula that the paper uses and does not print, with its source."""
        return self._add(id, tex, source=source)

    def identity(
        self,
        id: str,
        tex: str,
        *,
        on: Scene,
        says: Says,
        ids: Sequence[str] = (),
        cites: tuple[str, ...] = (),
    ) -> Display:
        """A displayed formula, and the claim that it is an identity; see :meth:`states`."""
        shown = self.display(id, tex, cites=cites)
        return self.states(Identity, shown, on=on, says=says, ids=ids)

    def states(
        self,
        kind: type[Claim],
        printed: Shown,
        *,
        on: Scene,
        says: Says,
        ids: Sequence[str] = (),
        **attributes: Any,
    ) -> Shown:
        """A claim of this kind for each statement that is printed; returns what is printed.

        Args:
            kind: the kind of claim.
            printed: a display that stands in some section, or one statement of it.
            on: the scene.
            says: what is claimed, in words; one for each statement, if it is not the same for all.
            ids: the ids of the claims, if they are others than that of the display, which is
                followed by a number where the display has several statements.
            attributes: what the kind of claim asks for besides; of a display, each claim is about
                the statement with the number of its own.

        Raises:
            ValueError: if there are not as many words or ids as statements.
        """
        places = tuple(statements(printed))
        display = places[0].display
        alone = len(tuple(display)) == 1
        ids = ids or [display.id if alone else place.place for place in places]
        words = [says] * len(places) if isinstance(says, str) else says
        if not len(places) == len(ids) == len(words):
            raise ValueError(
                f"{display.id}: {len(places)} statements, {len(ids)} ids, {len(words)} words"
            )
        for id, place, word in zip(ids, places, words, strict=True):
            kept: dict[str, Any] = {
                name: value[place.number] if isinstance(value, Display) else value
                for name, value in attributes.items()
            }
            self.claim(kind(id, on, word, printed=place, **kept))
        return printed

    def claim(self, *claims: Claim) -> None:
        """Statements that the paper makes here; raises ``TypeError`` for anything else.

        Raises ``ValueError`` for an id that cannot be the name of a certificate.
        """
        for claim in claims:
            if not isinstance(claim, Claim):
                raise TypeError(f"a claim is expected, not {claim!r}")
            if re.fullmatch(r"[\w.-]+", claim.id, re.ASCII) is None:
                allowed = "letters, digits, “_”, “-” and “.” are allowed"
                raise ValueError(f"the claim {claim.id!r}: in its id {allowed}")
            self.claims.append(claim)
            self.lines[claim.id] = _line()

    def deny(self, *claims: Claim) -> None:
        """Statements that the paper calls false, as those of another paper that it corrects."""
        self.claim(*claims)
        self.expected |= dict.fromkeys((claim.id for claim in claims), "refuted")

    def accept(self, printed: Printed, tex: str) -> None:
        """Read this in place of what is printed, in all that follows from it.

        The program proposes corrections, and takes none by itself: every verdict that rests on
        an accepted one says so. Derivations that rest on this one read it so everywhere.
        """
        self.accepted[printed] = tex

    def _add(self, id: str, tex: str, **attributes: Any) -> Display:
        display = Display(id, tex, self.number, **attributes)
        self.displays.append(display)
        return display


def _line() -> tuple[str, int]:
    """The file and the line, outside of this package, that is being executed."""
    frame = sys._getframe()
    while frame.f_back and frame.f_globals.get("__name__", "").startswith("kowalevski_cas."):
        frame = frame.f_back
    return frame.f_code.co_filename, frame.f_lineno


def _label(id: str) -> str:
    """The number of an equation by its id; none if it has none."""
    number = id.removeprefix("eq")
    return f"({number})" if number != id and number.isdecimal() else ""


class Doubt(Enum):
    """How a claim that was inferred from words may have been meant otherwise."""

    UNLESS_MENDED = "one that a small change makes true is what was meant"
    ALWAYS = "it may say where something happens, and nothing that always holds"


@dataclass(eq=False)
class Derivation:
    """A paper as a sequence of sections.

    Args:
        name: the name of its folder.
        title: the title of the paper.
        author: its author or authors.
        source: where the paper was published.
        sections: the sections, in their order.
        rests_on: the derivations whose displays and scenes it uses, as they are corrected.
        doubts: the claims that may have been meant otherwise, where they were inferred.
        offers: what motions are computed with, by its type (:mod:`.closed_form`); each is made
            when it is asked for.
        edition: which text was read, if it is not what was published, and its digest.
        main: the ids of the claims that are the main results.

    Raises:
        ValueError: if an id is given twice, here or in what it rests on, or if no claim has that
            of a main result.
    """

    name: str
    title: str
    author: str
    source: str
    sections: tuple[Section, ...]
    rests_on: tuple[Derivation, ...] = ()
    offers: Mapping[type, Callable[[], object]] = field(default_factory=dict)
    doubts: Mapping[str, Doubt] = field(default_factory=dict)
    edition: str = ""
    main: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        """Refuse ids that are given twice, for everything goes by them, or are nobody's."""
        for kind, ids in (
            ("sections or systems", [section.number for section in self.sections]),
            ("claims", [claim.id for claim in self.claims]),
            ("displays", [display.id for display in self._known_displays()]),
        ):
            twice = sorted(id for id, many in Counter(ids).items() if many > 1)
            if twice:
                how = ', System(r"…", "name")' if kind == "sections or systems" else ""
                raise ValueError(f"two {kind} are called {twice[0]}: give one another name{how}")
        if lost := {*self.main} - {claim.id for claim in self.claims}:
            raise ValueError(f"no claim is called {min(lost)}, which is named as a main result")

    @property
    def claims(self) -> tuple[Claim, ...]:
        """All claims in the order of the paper."""
        return tuple(claim for section in self.sections for claim in section.claims)

    @property
    def lines(self) -> dict[str, tuple[str, int]]:
        """The file and the line in which each claim is stated."""
        return {id: line for section in self.sections for id, line in section.lines.items()}

    @property
    def expected(self) -> dict[str, str]:
        """The verdicts that the author expects, by claims."""
        return {
            id: verdict for section in self.sections for id, verdict in section.expected.items()
        }

    def scenes(self) -> tuple[Scene, ...]:
        """The scenes of the sections and of the claims, and those from which they are changes."""
        found = {scene: None for section in self.sections for scene in section.scenes.values()}
        for claim in self.claims:
            for scene in claim.scenes():
                found[scene] = None
                if isinstance(scene.field, Change):
                    found[scene.field.source] = None
        return tuple(found)

    def texts(self, sources: Mapping[str, str] | None = None, *more: Scene) -> Texts:
        """The texts of the derivation, to be read in the words of its scenes, and of more.

        ``sources`` holds displays, by id, whose source is another one. What it rests on is read
        with the corrections that are accepted there.
        """
        corrected = {id: tex for base in self.rests_on for id, tex in base.corrected().items()}
        return Texts(vocabulary((*self.scenes(), *more)), {**corrected, **(sources or {})})

    def corrected(self) -> dict[str, str]:
        """The displays that are read otherwise than they are printed, with what it rests on."""
        found = {id: tex for base in self.rests_on for id, tex in base.corrected().items()}
        rows: dict[Display, dict[int, str]] = {}
        for place, tex in self.accepted.items():
            rows.setdefault(place.display, {})[place.number] = tex
        return found | {display.id: display.reading(row) for display, row in rows.items()}

    @property
    def accepted(self) -> dict[Printed, str]:
        """What is read in place of what is printed, by places."""
        return {place: tex for section in self.sections for place, tex in section.accepted.items()}

    def bases(self) -> Iterator[Derivation]:
        """The derivations that it rests on, and those that these rest on; one may come twice."""
        for base in self.rests_on:
            yield from base.bases()
            yield base

    @property
    def established(self) -> dict[Printed, str]:
        """The first claim that is about each place."""
        found: dict[Printed, str] = {}
        for claim in self.claims:
            for printed in claim.establishes():
                found.setdefault(printed, claim.id)
        return found

    def displays(self) -> Iterator[Display]:
        """All displays in the order of the paper."""
        for section in self.sections:
            yield from section.displays

    def _known_displays(self) -> Iterator[Display]:
        """The displays that it may use."""
        known = (display for base in self.rests_on for display in base._known_displays())
        yield from dict.fromkeys(known)
        yield from self.displays()


__all__ = ["Change", "Derivation", "Doubt", "Locus", "Scene", "Section"]
