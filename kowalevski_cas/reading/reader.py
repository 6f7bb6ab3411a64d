"""A source becomes a derivation: roles, claims on their scenes, and what is assumed."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field

from kowalevski_cas.limits import time_limit
from kowalevski_cas.notation import NotationError
from kowalevski_cas.paper.claims import Claim
from kowalevski_cas.paper.derivation import Derivation, Section
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.problem.evidence import Denial
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.problem.trees import FormatError
from kowalevski_cas.reading.comments import read_comments
from kowalevski_cas.reading.known import CLAIM, Known, Role
from kowalevski_cas.reading.ladder import Rung
from kowalevski_cas.reading.laws import find_laws
from kowalevski_cas.reading.names import Names, vectors_of
from kowalevski_cas.reading.obey import SAID, claim_id, said_rung, said_rungs
from kowalevski_cas.reading.roles import role_of
from kowalevski_cas.reading.stage import Stage
from kowalevski_cas.reading.statements import Item, Paper, read_statements
from kowalevski_cas.source.text import Source
from kowalevski_cas.verify.statement import Statement

SECONDS = 5.0
"""For each claim that a statement may make."""


@dataclass(eq=False)
class Formula:
    """A statement of the source with its role, the reason, and on what its claim rests."""

    item: Item
    role: Role
    claim: Claim | None = None
    on: tuple[Item, ...] = ()
    constants: tuple[str, ...] = ()
    message: str = ""
    """Why a claim is not judged, if it is not."""


@dataclass(eq=False)
class Reading:
    """A source as a derivation, every statement with its role."""

    paper: Paper
    derivation: Derivation
    formulas: tuple[Formula, ...]
    known: Known = field(repr=False)
    statements: tuple[Formula, ...] = ()
    """The claims that comments state and that are no formula's."""


def read(source: Source) -> Reading:
    """The derivation that a source is, by the rules of reading."""
    paper = read_statements(source)
    names = Names(vectors_of(paper))
    said = read_comments(paper)
    known = Known(paper, names, find_laws(paper, names, said), said=said)
    for item in _in_order(paper):
        known.enter(item, role_of(item, known))
    return _Reader(paper, known).reading()


def _in_order(paper: Paper) -> list[Item]:
    """The statements as they are read: an abstract claims before anything is defined."""
    last = [item for item in paper.items if any(s.title == "abstract" for s in item.sections)]
    return [item for item in paper.items if item not in last] + last


class _Reader:
    def __init__(self, paper: Paper, known: Known) -> None:
        self.paper, self.known = paper, known
        self.stage = Stage(known)
        self.candidates: dict[Item, list[Rung]] = {}
        self.troubles: dict[Item, str] = {}

    def reading(self) -> Reading:
        for item, role in self.known.roles.items():
            if role.name == CLAIM:
                found: list[Rung] = []
                try:
                    id, said = self._id(item), self.known.said
                    found.extend(said_rungs(item, id, self.stage, said))
                except (ValueError, Meaningless) as error:
                    self.troubles[item] = str(error)
                self.candidates[item] = found
        every = self._derivation(r.claim for found in self.candidates.values() for r in found[:1])
        texts = every.texts(None, *(r.claim.scene for f in self.candidates.values() for r in f))
        on = Elaborations(texts)
        formulas = tuple(
            self._formula(item, role, on)
            for item, role in sorted(self.known.roles.items(), key=lambda pair: pair[0].order)
        )
        statements = tuple(self._statements())
        claiming = (f for f in (*formulas, *statements) if f.claim is not None)
        derivation = self._derivation(f.claim for f in claiming if f.claim is not None)
        return Reading(self.paper, derivation, formulas, self.known, statements)

    def _statements(self) -> Iterator[Formula]:
        """The claims that comments state and that are no formula's."""
        ids: Counter[str] = Counter()
        for found in self.known.said.claims:
            ids[claim_id(found)] += 1
            number = ids[claim_id(found)]
            id = claim_id(found) if number == 1 else f"{claim_id(found)}_{number}"
            rung = said_rung(found, id, self.stage)
            role = Role(CLAIM, f"line {found.comment.line} says so", SAID)
            yield Formula(found.items[0], role, rung.claim, rung.on, rung.constants)

    def _formula(self, item: Item, role: Role, on: Elaborations) -> Formula:
        found = self.candidates.get(item, [])
        if not found:
            return Formula(item, role, message=self.troubles.get(item, ""))
        chosen, message = _chosen(found, on)
        if chosen is None:
            return Formula(item, role, message=message)
        return Formula(item, role, chosen.claim, chosen.on, chosen.constants, message)

    def _id(self, item: Item) -> str:
        beside = [one for one in self.paper.items if one.typed is item.typed]
        display = item.printed.display.id
        return display if len(beside) == 1 else item.printed.place

    def _derivation(self, claims: Iterable[Claim]) -> Derivation:
        """The displays and some claims, section by section."""
        path = self.paper.source.path
        parts = self.paper.prose.sections
        sections = {str(k): Section(str(k), part.title) for k, part in enumerate(parts)}
        for display, _ in self.paper.displays:
            sections[display.section].displays.append(display)
        own = [one for one in sections.values() if one.displays] or [*sections.values()][:1]
        own[0].scenes["names"] = self._names()
        for claim in claims:
            place = claim.printed or next(claim.places())
            section = sections[place.display.section]
            section.claim(claim)
            section.lines[claim.id] = (path, self.paper.lines.get(place.display.id, 0))
        return Derivation(re.sub(r".*/|\.tex$", "", path), path, "", path, tuple(own))

    def _names(self) -> Scene:
        """All names of the paper, so that each statement can be read."""
        words = self.paper.words
        parts = {p for own in self.known.names.vectors.values() for p in own}
        scalars = sorted((words.scalars | parts) - words.times - {"i"})
        return Scene("all names", self.known.names.vectors, (), tuple(scalars))


def _chosen(found: list[Rung], on: Elaborations) -> tuple[Rung | None, str]:
    """The first claim that holds, or the first that is read; and why none is."""
    first: Rung | None = None
    message = ""
    for rung in found:
        try:
            with time_limit(SECONDS):
                evidence = Statement(rung.claim, on).search()
        except (NotationError, Meaningless, FormatError, ArithmeticError) as error:
            message = message or str(error)
            continue
        except TimeoutError:
            first = first or rung
            continue
        if evidence is not None and not isinstance(evidence, Denial):
            return rung, ""
        first = first or rung
    return first, "" if first else message


__all__ = ["Formula", "Reading", "read"]
