"""A source becomes a derivation: roles, claims on their scenes, and what is assumed."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from typing import NamedTuple

from kowalevski_cas.limits import ProcessDied, tell, time_limit
from kowalevski_cas.notation import NotationError
from kowalevski_cas.paper.claims import Claim
from kowalevski_cas.paper.derivation import Derivation, Doubt, Section
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.names import BRACKET, head
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.problem.trees import FormatError
from kowalevski_cas.processes import each
from kowalevski_cas.reading.comments import read_comments
from kowalevski_cas.reading.constraints import enter_constraints
from kowalevski_cas.reading.conventions import enter_conventions
from kowalevski_cas.reading.cyclic import enter_cyclic_names
from kowalevski_cas.reading.doubts import doubt_of
from kowalevski_cas.reading.grammar import wrong
from kowalevski_cas.reading.in_words import claims_in_words
from kowalevski_cas.reading.known import ASSUMPTION, CLAIM, StatementRole
from kowalevski_cas.reading.ladder import Rung
from kowalevski_cas.reading.names import Names, vectors_of
from kowalevski_cas.reading.obey import SAID, about, claim_id, said_rung, said_rungs
from kowalevski_cas.reading.parts import Parts
from kowalevski_cas.reading.roles import role_of
from kowalevski_cas.reading.stage import Stage
from kowalevski_cas.reading.statements import SourcePaper, SourceStatement, read_statements
from kowalevski_cas.source.text import Source
from kowalevski_cas.verify.interpretation import Interpretation
from kowalevski_cas.verify.statement import Statement

SECONDS = 2.0
"""For each claim that a statement may make."""


@dataclass(eq=False)
class JudgedStatement:
    """A statement of the source with its role, the reason, and on what its claim rests."""

    item: SourceStatement
    role: StatementRole
    claim: Claim | None = None
    on: tuple[SourceStatement, ...] = ()
    constants: tuple[str, ...] = ()
    doubt: Doubt | None = None
    """How its claim may have been meant otherwise, if it may."""
    message: str = ""
    """Why a claim is not judged, if it is not."""
    span: tuple[int, int] | None = None
    """Where in the text the words stand that make the claim, if no formula makes it."""


@dataclass(eq=False)
class Reading:
    """A source as a derivation, every statement with its role."""

    paper: SourcePaper
    derivation: Derivation
    formulas: tuple[JudgedStatement, ...]
    parts: Parts = field(repr=False)
    statements: tuple[JudgedStatement, ...] = ()
    """The claims that comments state and that are no formula's."""


IDLE = "nothing moves on the set on which it seems to be claimed: it would say nothing"

Heard = Callable[[str, int, int], None]
"""Hears what is being read, how much is done, and of how much."""


def read(source: Source, heard: Heard = lambda *_: None) -> Reading:
    """The derivation that a source is, by the rules of reading."""
    paper = read_statements(source)
    parts = Parts(paper, Names(vectors_of(paper)), read_comments(paper))
    enter_cyclic_names(parts)
    for item in _in_order(paper):
        parts.cite(item)
        parts.suppose(item)
        parts.enter(item, role_of(item, parts.of(item)))
    enter_conventions(parts)
    enter_constraints(parts)
    return _DerivationReader(parts).reading(heard)


def _in_order(paper: SourcePaper) -> list[SourceStatement]:
    """The statements as they are read: an abstract claims before anything is defined."""
    last = [item for item in paper.items if any(s.title == "abstract" for s in item.sections)]
    return [item for item in paper.items if item not in last] + last


class _DerivationReader:
    def __init__(self, parts: Parts) -> None:
        self.paper, self.parts = parts.paper, parts
        self.stages = {known: Stage(known) for known in parts.known}
        self.candidates: dict[SourceStatement, list[Rung]] = {}
        self.troubles: dict[SourceStatement, str] = {}

    def reading(self, heard: Heard) -> Reading:
        """The reading, in which each statement makes the first of its claims that holds."""
        for item, role in self.parts.roles.items():
            if role.name == CLAIM:
                found: list[Rung] = []
                with self._noting(item):
                    stage = self.stages[self.parts.of(item)]
                    found.extend(said_rungs(item, self._id(item), stage, self.parts.said))
                self.candidates[item] = found
        chosen = self._chosen(heard)
        formulas = tuple(
            self._formula(item, role, chosen.get(item))
            for item, role in sorted(self.parts.roles.items(), key=lambda pair: pair[0].order)
        )
        statements = (*self._statements(), *self._in_words())
        claims = (f.claim for f in (*formulas, *statements) if f.claim is not None)
        judged = (*formulas, *statements)
        doubts = {one.claim.id: one.doubt for one in judged if one.claim and one.doubt}
        derivation = replace(self._derivation(claims), doubts=doubts)
        return Reading(self.paper, derivation, formulas, self.parts, statements)

    def _statements(self) -> Iterator[JudgedStatement]:
        """The claims that comments state and that are no formula's."""
        ids: Counter[str] = Counter()
        for found in self.parts.said.claims:
            known = self.parts.about(found)
            first = about(found, known)[0]
            name = claim_id(found, first)
            ids[name] += 1
            id = name if ids[name] == 1 else f"{name}_{ids[name]}"
            role = StatementRole(CLAIM, f"line {found.comment.line} says so", SAID)
            try:
                rung = said_rung(found, id, self.stages[known])
            except (ValueError, Meaningless) as error:
                raise wrong(found.comment, str(error)) from None
            yield JudgedStatement(first, role, rung.claim, rung.on, rung.constants)

    def _in_words(self) -> Iterator[JudgedStatement]:
        """The claims that sentences make; one that has no meaning is told with its reason."""
        for number, found in enumerate(claims_in_words(self.parts), 1):
            first = found.about[0]
            known = self.parts.of(first)
            role = StatementRole(CLAIM, "these words claim it", found.name)
            id = f"{found.name}-in-words-{number}"
            try:
                at = found.at or first
                beside = [at] if self.parts.roles[at].name == ASSUMPTION else []
                on = self.stages[known].scene(found.about, [*beside, *known.supposed(at)])
                claim = found.kind(id, on.scene, words=found.says, **found.values)  # type: ignore[arg-type]
            except (ValueError, Meaningless) as error:
                yield JudgedStatement(first, role, message=str(error), span=found.span)
                continue
            doubt = None if found.name == "independence" else Doubt.UNLESS_MENDED
            yield JudgedStatement(
                first, role, claim, on.assumptions, on.constants, doubt, span=found.span
            )

    @contextmanager
    def _noting(self, item: SourceStatement) -> Iterator[None]:
        """Note what a statement cannot be claimed for."""
        try:
            yield
        except (ValueError, Meaningless) as error:
            self.troubles[item] = str(error)

    def _chosen(self, heard: Heard) -> dict[SourceStatement, Choice]:
        """The claim of each statement, by its place in the ladder; processes share the work."""
        waiting = [item for item, found in self.candidates.items() if found]
        first = self._derivation(self.candidates[item][0].claim for item in waiting)
        scenes = (rung.claim.scene for item in waiting for rung in self.candidates[item])
        on = Interpretation(first, first.texts(None, *scenes)).on

        def choice(place: int) -> Choice:
            tell(waiting[place].printed.place, place, len(waiting))
            rungs = self.candidates[waiting[place]]
            return chosen(rungs, on(rungs[0].claim))

        found = each(choice, range(len(waiting)), heard=lambda *words: heard(*words[:3]))
        return dict(zip(waiting, found, strict=True))

    def _formula(
        self, item: SourceStatement, role: StatementRole, choice: Choice | None
    ) -> JudgedStatement:
        if choice is None or choice.place is None:
            message = self.troubles.get(item, "") if choice is None else choice.message
            return JudgedStatement(item, role, message=message)
        rung = self.candidates[item][choice.place]
        doubt, message = doubt_of(item, rung, self.candidates[item], self.parts), choice.message
        if choice.elsewhere is not None:
            doubt, message = Doubt.ALWAYS, self._supposed_elsewhere(item, choice.elsewhere)
        return JudgedStatement(item, role, rung.claim, rung.on, rung.constants, doubt, message)

    def _supposed_elsewhere(self, item: SourceStatement, place: int) -> str:
        """The words for what is supposed in another place, and makes a claim true."""
        lines = self.paper.lines
        own = self.parts.of(item).supposed(item)
        said = [
            f"${one.printed.tex}$ (line {lines.get(one.printed.display.id, 0)})"
            for one in self.candidates[item][place].on
            if one not in own
        ]
        return f"it holds with {' and '.join(said)}, which is not said to hold here"

    def _id(self, item: SourceStatement) -> str:
        beside = [one for one in self.paper.items if one.typed is item.typed]
        display = item.printed.display.id
        return display if len(beside) == 1 else item.printed.place

    def _derivation(self, claims: Iterable[Claim]) -> Derivation:
        """The displays and some claims, section by section."""
        path = self.paper.source.path
        parts = self.paper.prose.sections
        sections = {str(k): Section(str(k), part.title) for k, part in enumerate(parts)}
        printed = [display for display, _ in self.paper.displays]
        beside = dict.fromkeys(i.printed.display for i in self.parts.roles).keys() - {*printed}
        for display in (*sorted(beside, key=lambda one: one.id), *printed):
            sections[display.section].displays.append(display)
        for item in self.parts.roles:
            for said in self.parts.said.formulas(item, "accept"):
                sections[item.printed.display.section].accept(item.printed, said.tex)
        own = [one for one in sections.values() if one.displays] or [*sections.values()][:1]
        own[0].scenes["names"] = self._names()
        for claim in claims:
            places = sorted(claim.reads(), key=lambda one: one.place)
            place = claim.printed or next(iter((*claim.places(), *places)))
            section = sections[place.display.section]
            section.claim(claim)
            section.lines[claim.id] = (path, self.paper.lines.get(place.display.id, 0))
        return Derivation(re.sub(r".*/|\.tex$", "", path), path, "", path, tuple(own))

    def _names(self) -> Scene:
        """All names of the paper, so that each statement can be read."""
        words = self.paper.words
        vectors = self.parts.known[0].names.vectors
        components = {part for own in vectors.values() for part in own}
        clocks = [one.other_time for known in self.parts.known for one in known.clocks]
        read = frozenset().union(*(item.names for item in self.paper.items))
        scalars = sorted(
            (words.scalars | components | read - words.functions)
            - {"t", "d", *clocks, *vectors, *words.matrices}
        )
        functions: dict[str, str] = {}
        places: dict[str, Printed] = {}
        for item, role in self.parts.roles.items():
            for name in role.names:
                letter, arguments = head(name)
                is_matrix = letter in words.matrices and item.printed.heads.matrix
                if letter != BRACKET and letter not in functions and (arguments or is_matrix):
                    functions[letter] = name
                    places[name] = item.printed
        scalars = sorted({*scalars} - functions.keys())
        scene = Scene("all names", vectors, (), tuple(scalars), definitions=places)
        return replace(scene, time=(*clocks, "t")[0])


class Choice(NamedTuple):
    """Which rung of a ladder is taken, if one is, and why none is."""

    place: int | None
    message: str = ""
    elsewhere: int | None = None
    """Which rung holds by what is supposed in other places, if no other one holds."""


def chosen(found: list[Rung], on: Elaborations) -> Choice:
    """The first claim that holds, or the one with what is in force, where none does."""
    first: int | None = None
    message = ""
    only = found[0].idle is None and not found[0].is_stronger
    alone = len(found) == 1 and only  # there is nothing to choose from
    for place, rung in enumerate(found):
        if rung.elsewhere and first is None:
            break
        true, trouble = _trial(rung, on, alone)
        if true:
            return Choice(first, "", place) if rung.elsewhere else Choice(place)
        message = message or trouble
        if trouble or rung.elsewhere or rung.is_stronger:
            continue
        if first is None or (rung.in_force and not found[first].in_force):
            first = place
        elif not rung.given and not found[first].given and {*rung.on} > {*found[first].on}:
            first = place  # what is supposed there is not left aside where the claim fails
    return Choice(first, "" if first is not None else message)


def _trial(rung: Rung, on: Elaborations, alone: bool) -> tuple[bool, str]:
    """Whether a claim holds, or is the only one and has a meaning; else perhaps why it has none."""
    try:
        with time_limit(SECONDS):
            statement = Statement(rung.claim, on)
            if (alone and statement.goals) or statement.holds():
                idle = rung.idle is not None and Statement(rung.idle, on).holds()
                return not idle, IDLE if idle else ""
    except (NotationError, Meaningless, FormatError, ArithmeticError, RecursionError) as error:
        said = str(getattr(error, "message", error))
        for printed in rung.claim.places():
            said = said.removeprefix(f"{printed.display.id}: ")
        return False, said
    except (TimeoutError, ProcessDied):
        pass
    return False, ""


__all__ = ["JudgedStatement", "Reading", "read"]
