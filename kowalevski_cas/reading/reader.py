"""A source becomes a derivation: roles, claims on their scenes, and what is assumed."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import chain

from kowalevski_cas.limits import tell
from kowalevski_cas.notation import Application, to_latex
from kowalevski_cas.notation.functions import FUNCTIONS
from kowalevski_cas.paper.claims import Claim, Identity
from kowalevski_cas.paper.derivation import Derivation, Doubt, Section
from kowalevski_cas.paper.differentials import differentials
from kowalevski_cas.paper.names import BRACKET, head, primitive
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.processes import each
from kowalevski_cas.reading.all_rest import claims_of_all_rest
from kowalevski_cas.reading.choice import OVERDUE, Choice, Choices, choose_once
from kowalevski_cas.reading.comments import read_comments
from kowalevski_cas.reading.constraints import (
    UNBOUND,
    claims_of_constraints,
    enter_constraints,
    unbound_multiplier,
)
from kowalevski_cas.reading.conventions import enter_conventions
from kowalevski_cas.reading.counted import shown_numbers
from kowalevski_cas.reading.cyclic import enter_cyclic_names
from kowalevski_cas.reading.dimensions import Misscaled, misscaled
from kowalevski_cas.reading.doubts import doubt_of
from kowalevski_cas.reading.energies import OF_ENERGY, claims_of_energies
from kowalevski_cas.reading.grammar import wrong
from kowalevski_cas.reading.ignorable import claims_of_ignorable
from kowalevski_cas.reading.in_words import claims_in_words
from kowalevski_cas.reading.known import ASSUMPTION, CLAIM, UNIT_MATRIX, StatementRole
from kowalevski_cas.reading.law import Law
from kowalevski_cas.reading.maps import enter_maps, find_maps, primed_images
from kowalevski_cas.reading.maps_in_words import claims_of_maps
from kowalevski_cas.reading.names import Names, vectors_of
from kowalevski_cas.reading.obey import SAID, about, claim_id, said_rung, said_rungs
from kowalevski_cas.reading.origins import claims_of_origins
from kowalevski_cas.reading.other_cases import OtherCases
from kowalevski_cas.reading.parts import Parts
from kowalevski_cas.reading.referee import Heard, Referee
from kowalevski_cas.reading.roles import role_of
from kowalevski_cas.reading.rung import Rung, claim_of_kind
from kowalevski_cas.reading.stage import Stage
from kowalevski_cas.reading.statements import SourcePaper, SourceStatement, read_statements
from kowalevski_cas.reading.volumes_in_words import claims_of_volumes
from kowalevski_cas.source.text import Source
from kowalevski_cas.verify.confirm import received
from kowalevski_cas.verify.interpretation import Interpretation
from kowalevski_cas.verify.outcome import Outcome

LOST = "${}$ is supposed here, in which not all names have a meaning"


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
    outcomes: dict[str, Outcome] = field(default_factory=dict, repr=False)
    """What is said about claims that were decided as soon as they were read, by their ids."""

    @cached_property
    def misscaled(self) -> list[Misscaled]:
        """The statements that scale as nothing else in their part does."""
        return [one for known in self.parts.known for one in misscaled(known)]


_SLASH = re.compile(r"(?<![A-Za-z\\])d\s*\\?\w+\s*/\s*d")
"""A derivative with a slash, in which d is no name."""


def read(
    source: Source,
    heard: Heard = lambda *_: None,
    referee: Referee | None = None,
    choices: Choices | None = None,
) -> Reading:
    """The derivation that a source is, by the rules of reading.

    ``choices`` are those of earlier readings, which are made no more; new ones are entered there.
    """
    paper = read_statements(source)
    said = read_comments(paper)
    if images := primed_images(paper, said):
        paper = read_statements(source, images)
        said = read_comments(paper)
    names = Names(vectors_of(paper))
    parts = Parts(paper, names, said, find_maps(paper, names, said))
    enter_cyclic_names(parts)
    for item in _in_order(paper):
        parts.cite(item)
        parts.suppose(item)
        parts.enter(item, role_of(item, parts.of(item)))
    parts.enter_unprinted()
    enter_conventions(parts)
    enter_constraints(parts)
    enter_maps(parts)
    return _DerivationReader(parts, choices).reading(heard, referee)


def _in_order(paper: SourcePaper) -> list[SourceStatement]:
    """The statements as they are read: an abstract claims before anything is defined."""
    last = [item for item in paper.items if any(s.title == "abstract" for s in item.sections)]
    return [item for item in paper.items if item not in last] + last


class _DerivationReader:
    def __init__(self, parts: Parts, choices: Choices | None) -> None:
        self.paper, self.parts, self.choices = parts.paper, parts, choices
        self.stages = {known: Stage(known) for known in parts.known}
        self.candidates: dict[SourceStatement, list[Rung]] = {}
        self.troubles: dict[SourceStatement, str] = {}
        self.statements = Counter(item.printed.display.id for item in self.paper.items)

    def reading(self, heard: Heard, referee: Referee | None) -> Reading:
        """The reading, in which each statement makes the first of its claims that holds."""
        for item, role in self.parts.roles.items():
            if role.name == CLAIM:
                found: list[Rung] = []
                with self._noting(item):
                    stage = self.stages[self.parts.of(item)]
                    found.extend(said_rungs(item, self._id(item), stage, self.parts.said))
                self.candidates[item] = found
        statements = (*self._statements(), *self._in_words())
        outcomes: dict[str, Outcome] = {}
        chosen = dict(self._chosen(heard, statements, referee, outcomes))
        formulas = tuple(
            self._formula(item, role, chosen.get(item))
            for item, role in sorted(self.parts.roles.items(), key=lambda pair: pair[0].order)
        )
        statements = tuple(map(self._of_this_law, statements))
        claims = (f.claim for f in (*formulas, *statements) if f.claim is not None)
        judged = (*formulas, *statements)
        doubts = {one.claim.id: one.doubt for one in judged if one.claim and one.doubt}
        derivation = replace(self._derivation(claims), doubts=doubts)
        return Reading(self.paper, derivation, formulas, self.parts, statements, outcomes)

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
            span = self.parts.said.span(found, self.paper)
            yield JudgedStatement(first, role, rung.claim, rung.on, rung.constants, span=span)

    def _in_words(self) -> Iterator[JudgedStatement]:
        """The claims that sentences make; one that has no meaning is told with its reason."""
        parts = self.parts
        listed = [*claims_of_all_rest(parts)]  # which says more than how many there are
        spans = [range(*one.span) for one in listed]
        others = [
            one for one in claims_in_words(parts) if not any(one.span[0] in span for span in spans)
        ]
        claimed = (
            *others,
            *claims_of_maps(parts),
            *claims_of_energies(parts),
            *claims_of_ignorable(parts),
            *claims_of_origins(parts),
            *claims_of_constraints(parts),
            *claims_of_volumes(parts),
            *listed,
        )
        for number, found in enumerate(claimed, 1):
            first = found.about[0]
            known = self.parts.of(first)
            role = StatementRole(CLAIM, "these words claim it", found.name)
            id = f"{found.name}-in-words-{number}"
            try:
                at = found.at or first
                beside = [at] if self.parts.roles[at].name == ASSUMPTION else []
                supposed = [*beside, *known.supposed(at)]
                on = self.stages[known].scene(found.about, supposed, found.law)
                claim = claim_of_kind(found.kind, id, on.scene, found.says, found.values)
            except (ValueError, Meaningless) as error:
                yield JudgedStatement(first, role, message=str(error), span=found.span)
                continue
            doubt = None if found.name == "independence" else found.doubt
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

    def _chosen(
        self,
        heard: Heard,
        statements: Sequence[JudgedStatement],
        referee: Referee | None,
        outcomes: dict[str, Outcome],
    ) -> Iterator[tuple[SourceStatement, Choice]]:
        """The claim of each statement, by its place in the ladder; processes share the work.

        A referee decides each of them at once.
        """
        waiting = [item for item, found in self.candidates.items() if found]
        claims = [self.candidates[item][0].claim for item in waiting]
        first = self._derivation((*claims, *(one.claim for one in statements if one.claim)))
        again = dict(self._again())
        rungs = [rung for item in waiting for rung in self.candidates[item]]
        scenes = (one.claim.scene for one in chain(rungs, *again.values()))
        interpretation = Interpretation(first, first.texts(None, *scenes))
        self.cases = OtherCases(self.parts, self.candidates, again, interpretation)
        otherwise = {
            item: self.cases.otherwise(item, item.typed.start, self.candidates[item][0].claim)
            for item in waiting
        }
        self.troubles |= {item: why for item, why in otherwise.items() if why}
        waiting = [item for item in waiting if not otherwise[item]]
        decide = referee.begin(interpretation) if referee is not None else None

        def choice(place: int) -> tuple[Choice, str, Outcome | None]:
            tell(waiting[place].printed.place, place, len(waiting))
            rungs = self.candidates[waiting[place]]
            choice, resting_on = choose_once(rungs, interpretation.on(rungs[0].claim), self.choices)
            if decide is None or choice.place is None:
                return choice, resting_on, None
            return choice, resting_on, decide(rungs[choice.place].claim)

        def late(_: int) -> tuple[Choice, str, Outcome | None]:
            return Choice(0, OVERDUE), "", None

        found = each(
            received(choice), range(len(waiting)), heard=lambda *words: heard(*words[:3]), late=late
        )
        for item, (choice_of, resting_on, outcome) in zip(waiting, found, strict=True):
            if self.choices is not None and resting_on and choice_of.place is not None:
                self.choices[resting_on] = choice_of
            if referee is not None and outcome is not None:
                outcomes[outcome.claim] = referee.receive(item, outcome)
            yield item, choice_of

    def _again(self) -> Iterator[tuple[SourceStatement, list[Rung]]]:
        """The laws that are printed once more, each with the claims that those before follow.

        There are none where their names have no meaning together.
        """
        for known, stage in self.stages.items():
            for law in known.laws:
                rows = [row for one in law.again for row in one.items]
                rungs: list[Rung] = []
                with suppress(ValueError, Meaningless):
                    rungs = [self._follows(row, law, stage) for row in rows]
                if rows:
                    yield law.first, rungs

    def _follows(self, row: SourceStatement, law: Law, stage: Stage) -> Rung:
        """The claim that a row of a law before holds by another law."""
        on = stage.scene([row], (), law)
        says = "the law before follows"
        claim = Identity(f"{self._id(row)}-again", on.scene, says, printed=row.printed)
        return Rung(claim, (), on.constants)

    def _formula(
        self, item: SourceStatement, role: StatementRole, choice: Choice | None
    ) -> JudgedStatement:
        if choice is None or choice.place is None:
            message = self.troubles.get(item, "") if choice is None else choice.message
            return JudgedStatement(item, role, message=message)
        rung = self.candidates[item][choice.place]
        doubt, message = doubt_of(item, rung, self.candidates[item], self.parts), choice.message
        if name := unbound_multiplier(self.parts.of(item), rung.claim.scene.constants):
            doubt, message = Doubt.ALWAYS, UNBOUND.format(name)
        if message == OVERDUE or item in self.cases.rows:
            doubt = Doubt.ALWAYS
        if lost := self.stages[self.parts.of(item)].lost(item):
            doubt, message = Doubt.ALWAYS, LOST.format(lost[0].printed.tex.strip())
        if choice.elsewhere is not None:
            doubt, message = Doubt.ALWAYS, self._supposed_elsewhere(item, choice.elsewhere)
        return JudgedStatement(item, role, rung.claim, rung.on, rung.constants, doubt, message)

    def _of_this_law(self, said: JudgedStatement) -> JudgedStatement:
        """What words claim, unless that may be meant of another law."""
        if said.claim is None or said.span is None or said.role.kind in (SAID, OF_ENERGY):
            return said
        why = self.cases.otherwise(said.item, said.span[0], said.claim)
        return replace(said, claim=None, message=why) if why else said

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
        alone = self.statements[item.printed.display.id] == 1
        return item.printed.display.id if alone else item.printed.place

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
            for tex in self.parts.said.accepted(item):
                sections[item.printed.display.section].accept(item.printed, tex)
        own = [one for one in sections.values() if one.displays] or [*sections.values()][:1]
        own[0].scenes |= self._names()
        for claim in claims:
            places = sorted(claim.reads(), key=lambda one: one.place)
            place = claim.printed or next(iter((*claim.places(), *places)))
            section = sections[place.display.section]
            section.claim(claim)
            section.lines[claim.id] = (path, self.paper.lines.get(place.display.id, 0))
        numbers = shown_numbers(self.paper.numbers)
        return Derivation(
            re.sub(r".*/|\.tex$", "", path), path, "", path, tuple(own),
            edition=f"{path}, for ${numbers}$" if numbers else "",
        )  # fmt: skip

    def _names(self) -> dict[str, Scene]:
        """All names of the paper, so that each statement can be read, by each of its times."""
        words = self.paper.words
        vectors = self.parts.known[0].names.vectors
        components = {part for own in vectors.values() for part in own}
        clocks = [one.other_time for known in self.parts.known for one in known.clocks]
        read = frozenset().union(*(item.names for item in self.paper.items))
        items = [item for item in self.paper.items if item.formula is not None]
        slashes = any(_SLASH.search(item.printed.tex) for item in items)
        named = {"d" for item in items if "d" in item.names and not slashes}
        named |= {"d" for item in items if item.formula and differentials(item.formula)}
        scalars = sorted(
            (words.scalars | components | read - words.functions)
            - {"t", *({"d"} - named), *clocks, *vectors, *words.matrices}
        )
        functions: dict[str, str] = {}
        places: dict[str, Printed] = {}
        for item, role in self.parts.roles.items():
            for name in role.names:
                letter, arguments = head(name)
                is_matrix = letter in words.matrices or role.kind == UNIT_MATRIX
                if letter != BRACKET and letter not in functions and (arguments or is_matrix):
                    functions[letter] = name
                    places[name] = item.printed
        moving = {name for law in self.parts.laws for name in law.variables} & {*scalars}
        places |= self._unknown_functions(functions.keys() | moving)
        scalars = sorted({*scalars} - {head(name)[0] for name in places} - moving)
        scene = Scene(
            "all names", vectors, (*sorted(moving),), tuple(scalars), definitions=places,
            matrices=tuple(name for name in places if name in words.matrices),
        )  # fmt: skip
        times = dict.fromkeys(clocks or ["t"])
        return {f"names-{time}": replace(scene, time=time) for time in times}

    def _unknown_functions(self, known: set[str]) -> dict[str, Printed]:
        """The functions that are applied, and that nothing gives, with the first such place."""
        found: dict[str, tuple[str, Printed]] = {}
        for item in self.parts.roles:
            for node in item.formula.nodes() if item.formula is not None else ():
                if isinstance(node, Application):
                    function, _ = primitive(node.function)
                    if function not in FUNCTIONS and function not in known:
                        arguments = ",".join(map(to_latex, node.arguments))
                        found.setdefault(function, (f"{function}({arguments})", item.printed))
        return dict(found.values())


__all__ = ["JudgedStatement", "Reading", "read"]
