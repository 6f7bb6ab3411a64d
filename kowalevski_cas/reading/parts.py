"""The parts of a paper with laws of their own: where another system begins, letters are new."""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Iterator, Sequence
from functools import cached_property

from kowalevski_cas.notation import Name
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.reading.all_roots import roots_at
from kowalevski_cas.reading.comments import Said
from kowalevski_cas.reading.grammar import Directive
from kowalevski_cas.reading.known import (
    ASSUMPTION,
    DEFINITION,
    LAW,
    NAMING,
    OTHER,
    TOGETHER,
    Known,
    StatementRole,
)
from kowalevski_cas.reading.law import Law
from kowalevski_cas.reading.laws import find_laws
from kowalevski_cas.reading.names import Names
from kowalevski_cas.reading.phrases import integral_words
from kowalevski_cas.reading.restated import find_restated
from kowalevski_cas.reading.solved import SOLVED, solutions_for
from kowalevski_cas.reading.statements import SourcePaper, SourceStatement
from kowalevski_cas.reading.suppositions import POSITIVE
from kowalevski_cas.reading.text import references
from kowalevski_cas.reading.unprinted import is_printed, unprinted
from kowalevski_cas.reading.varied_laws import with_varied
from kowalevski_cas.reading.vieta import relations
from kowalevski_cas.reading.which_system import nearest_labels, part_in_words

_RETURN = re.compile(
    r"\W*(?:(?:let\s+us|we|now|finally|again|then|next)[\s,]+)*"
    r"(?:return(?:ing)?|(?:come|go|turn|turning)\s+back)\s+to\s+(?:the|our|equations?|systems?|\(|\\)"
    r"|\W*(?:теперь\s+|снова\s+)?(?:верн[её]мся|возвратимся|возвращаясь)\s+к\b",
    re.IGNORECASE,
)
"""How a sentence begins that comes back to what was spoken of before another system."""


_DEDUCED = re.compile(
    r"\b(?:then|hence|thus|therefore|consequently|so|becomes?|satisf(?:y|ies)|obeys?|described|gives?|gets?|obtains?|finds?|follows?"
    r"|(?:variational|lineari[sz]ed|reduced|resulting|corresponding)\s+(?:\w+\s+)?(?:equations?|systems?)"
    r"|in\s+(?:the\s+)?\w+\s+(?:axes|frame|coordinates|variables)|reduces?|leads?|transforms?|takes?\s+the\s+form"
    r"|тогда|отсюда|поэтому|следовательно|значит|удовлетвор\w+|получ\w+|принима\w+\s+вид|переход\w+|сводится|описыва\w+)\b",
    re.IGNORECASE,
)
"""Words that deduce equations from what stands before."""
_SUPPOSED = re.compile(r"\b(?:let|consider|suppose|assume|пусть|рассмотрим)\b", re.IGNORECASE)
"""Words by which they are others, that need not follow."""


class Parts:
    """What is known in each part of a paper, and the roles of all its statements.

    A part begins where a system is set up that is another one than before.
    """

    def __init__(
        self, paper: SourcePaper, names: Names, said: Said, maps: Sequence[Law] = ()
    ) -> None:
        self.paper, self.said = paper, said
        found = [*with_varied(find_laws(paper, names, said, [*maps]), paper)]
        self.laws = _in_order(found, maps)
        self.roles: dict[SourceStatement, StatementRole] = {}
        units: list[SourceStatement] = []
        own: list[list[Law]] = [[]]
        for law in self.laws:
            if law.begins is not None:
                own.append([])
            at = law.first.typed.start
            over = {k for k, laws in enumerate(own) if laws and (laws[0].ends or at + 1) <= at}
            own[max({*range(len(own))} - over)].append(law)
        begins = [paper.prose.start, *(laws[0].begins or 0 for laws in own[1:])]
        self.begins = [*zip(begins, range(len(own)), strict=True)]
        ends = [(laws[0].ends, k) for k, laws in enumerate(own) if laws and laws[0].ends]
        self.begins += [(end, self.part_at((own[k][0].begins or 0) - 1)) for end, k in ends]
        self.begins = sorted([*self.begins, *self._returns(own)])
        for stop in paper.prose.stops if len(own) > 1 else ():
            if (place := self._returned(stop)) is not None:
                self.begins = sorted([*self.begins, (stop, place)])
        placed: list[list[SourceStatement]] = [[] for _ in own]
        self.places = {item: self._place(item) for item in paper.items}
        self.places |= dict(self._of_what_is_defined())
        self.places |= dict(self._of_what_is_averaged(own))
        for item in paper.items:
            if (named := part_in_words(item, own, paper.prose)) is not None:
                self.places[item] = named
        for item, place in self.places.items():
            placed[place].append(item)
        self.known = [
            Known(
                paper,
                names,
                laws,
                items,
                find_restated([one for one in items if one not in paper.approximate], laws),
                self.roles,
                units=units,
                said=said,
            )
            for laws, items in zip(own, placed, strict=True)
        ]
        for known in self.known:
            others = (law for law in self.laws if law not in known.laws)
            known.elsewhere = frozenset(name for law in others for name in law.variables)

    def _place(self, item: SourceStatement) -> int:
        """The part of a statement: where it stands, or that of the only law that is cited by it.

        Behind equations of motion in its sentence it is about these.
        """
        here = self.part_at(item.typed.start)
        before = {row for law in self.laws for row in law.printed if row.order < item.order}
        if any(row.sentence == item.sentence for row in before):
            return here
        cited = {one for label in nearest_labels(item) for one in self.paper.labels.get(label, ())}
        found = {self.part_at(law.first.typed.start) for law in self.laws if cited & law.printed}
        is_row = any(item in law.printed for law in self.laws)
        return found.pop() if len(found) == 1 and not is_row else here

    def _of_what_is_defined(self) -> Iterator[tuple[SourceStatement, int]]:
        """The statements that derive what a formula gives for another part, which it cites.

        It stands last before them in their paragraph, as in “let z be x², where x obeys (1)”.
        """
        given: dict[tuple[int, str], int] = {}
        for item, place in self.places.items():
            elsewhere = place != self.part_at(item.typed.start)
            for name in item.bare[:1] if len(item.members) == 2 and not item.derives else ():
                given[item.paragraph, name] = place if elsewhere and item.refs else -1
            found = {given.get((item.paragraph, name), -1) for name in item.rates}
            if item.derives and not item.refs and len(found) == 1 and {*found} != {-1}:
                yield item, found.pop()

    def _of_what_is_averaged(
        self, own: Sequence[Sequence[Law]]
    ) -> Iterator[tuple[SourceStatement, int]]:
        """The statements behind averaged equations that are of the part before, which it has.

        Their sentences derive what moves there, and have nothing that the averaged equations move.
        """
        moving = [{name for law in laws for name in law.variables} for laws in own]
        by_sentence: dict[tuple[int, int], list[SourceStatement]] = {}
        for item, place in self.places.items():
            if own[place] and own[place][0].is_averaged:
                by_sentence.setdefault(item.sentence, []).append(item)
        for items in by_sentence.values():
            place = self.places[items[0]]
            named = {name for item in items for name in item.names}
            derived = {name for item in items for name in item.rates}
            if derived & moving[place - 1] and not named & moving[place]:
                yield from ((item, place - 1) for item in items)

    def is_averaged(self, item: SourceStatement) -> bool:
        """Whether a statement stands where averaged equations are spoken of, and cites nothing."""
        here = self.known[self.part_at(item.typed.start)]
        places = [self.of(item)] if item.refs else [self.of(item), here]
        return any(law.is_averaged for known in places for law in known.laws)

    def part_at(self, offset: int) -> int:
        """The number of the part in which a place of the text is."""
        after = bisect_right(self.begins, offset, key=lambda begin: begin[0])
        return self.begins[max(0, after - 1)][1]

    def _returns(self, own: Sequence[Sequence[Law]]) -> Iterator[tuple[int, int]]:
        """The sections that come back to an earlier part, with its number.

        Something is derived in them that moves by the laws of that part, and nothing that moves by
        those of another; or it is the image of what a map has there.
        """
        moving = [{name for law in laws for name in law.variables} for laws in own]
        images = [{new for law in laws for _, new in law.images} for laws in own]
        mapped = set[str]().union(*images)
        for section in dict.fromkeys(item.section for item in self.paper.items):
            within = (item for item in self.paper.items if item.section is section)
            derived = {name for item in within for name in (*item.rates, *(item.names & mapped))}
            met = [k for k, names in enumerate(moving) if (names | images[k]) & derived]
            if len(met) == 1 and met[0] < self.part_at(section.start):
                yield section.start, met[0]

    def _returned(self, stop: int) -> int | None:
        """The part to which a sentence comes back: that before, or that of what it cites."""
        words = self.paper.prose.between(*self.paper.prose.sentence(stop))
        if not _RETURN.match(words):
            return None
        labels = self.paper.labels
        cited = [one for label in references(words) for one in labels.get(label, ())]
        here = self.part_at(stop)
        place = self.part_at(cited[0].typed.start) if cited else here - 1
        return place if 0 <= place < here else None

    def deduced(self) -> Iterator[SourceStatement]:
        """The first equations of laws for new letters that words deduce from a law before.

        Nothing that is read says what these letters stand for.
        """
        for law in self.laws[1:]:
            row = law.first
            tied = (law.change, law.together, law.restates, law.images, law.momenta, law.again)
            old = law.base.variables if law.base is not None else ()
            beside = any(not one.names.isdisjoint(old) for one in law.items)
            if any(tied) or beside or law.begins is not None or not is_printed(row):
                continue
            if _DEDUCED.search(row.before) and not _SUPPOSED.search(row.before):
                yield row

    def of(self, item: SourceStatement) -> Known:
        """What is known in the part of a statement."""
        return self.known[self.places[item]]

    def enter(self, item: SourceStatement, role: StatementRole) -> None:
        """Keep what a statement says."""
        known = self.of(item)
        roots = roots_at(item, known)
        known.enter(item, role)
        if role.kind == POSITIVE:
            name, why = role.names[0], "the words call it positive"
            found = unprinted(self.paper, f"{name}-positive", f"{name}>0", item, why)
            self.places[found] = self.places[item]
            known.enter(found, StatementRole(ASSUMPTION, why, "inequality", role.names))
        if role.kind == SOLVED:
            for found in solutions_for(item, known):
                self.places[found] = self.places[item]
                known.enter(found, StatementRole(DEFINITION, role.reason, "", found.bare[:1]))
        if roots is not None:
            own = relations(roots, self.paper)
            known.rooted.append((frozenset(roots.names), own))
            for found in own:
                self.places[found] = self.places[item]
                why = f"{', '.join(roots.names)} are roots of a polynomial"
                known.enter(found, StatementRole(DEFINITION, why, TOGETHER))

    def suppose(self, item: SourceStatement) -> None:
        """Keep what comments suppose from a statement on, which the paper does not print."""
        for found in self.said.supposed.get(item, ()):
            reason, known = f"{found.printed.display.source} says so", self.of(item)
            names = found.bare or tuple(sorted(found.names))
            self.places[found] = self.places[item]
            if known.law_of(found) is not None:
                self.enter(found, StatementRole(LAW, reason))
            elif found.other_time:
                self.enter(found, StatementRole(DEFINITION, reason, "clock"))
            else:
                kind = _supposed_kind(found, known)
                self.enter(found, StatementRole(ASSUMPTION, reason, kind, names))

    def enter_unprinted(self) -> None:
        """Keep what stands in comments only: it says nothing by itself."""
        for item in self.said.unprinted:
            self.places[item] = self._place(item)
            self.enter(item, StatementRole(OTHER, f"{item.printed.display.source} gives it"))

    def cite(self, item: SourceStatement) -> None:
        """Let names have their meaning in the part of a statement that another part gives them.

        They are cited there, or stand in the part where it is printed, or the same variables move
        in both, as where a force is added, and the statement does not define them anew.
        """
        known, here = self.of(item), self.known[self.part_at(item.typed.start)]
        for name in item.names if here is not known else ():
            if not (known.is_defined(name) or known.moves(name)):
                for one in here.definitions.get(name, ()):
                    known.borrow(one, self.roles[one])
        for one in self._inherited(item, known):
            known.borrow(one, self.roles[one])
        for one in known.cited(item):
            role = self.roles.get(one)
            if role is not None and role.name in NAMING and self.of(one) is not known:
                known.borrow(one, role)

    def _inherited(self, item: SourceStatement, known: Known) -> Iterator[SourceStatement]:
        """What defines names of a statement in the last part of which the law goes on here."""
        own = item.members if integral_words(item) else item.members[:1]
        named = (name for name in item.names if Name(name) not in own)
        fresh = [name for name in named if not (name in known.definitions or known.moves(name))]
        if not fresh:
            return
        place = self.places[item]
        before = [self.known[k] for k in reversed(range(place)) if self._goes_on(k, place)]
        if not before:
            return
        mentioned = {name for law in known.laws for name in law.mentions}
        mentioned -= {
            name for part in before for name in part.varying(mentioned) if _is_given(name, part)
        }
        met = mentioned | known.definitions.keys()
        waiting = [name for name in fresh if name not in met]
        while waiting:
            name = waiting.pop()
            if name in met or known.moves(name):
                continue
            met.add(name)
            giving = next((part for part in before if name in part.definitions), before[0])
            for one in giving.definitions.get(name, ()):
                if self.roles[one].name in NAMING:
                    yield one
                    waiting += one.names

    def _goes_on(self, earlier: int, place: int) -> bool:
        """Whether a part has the law of an earlier one with something added, as a force.

        The same variables move, and all constants of the old law are in the new one.
        """
        before = self.known[earlier]
        printed = [[one for one in self.known[k].laws if not one.new] for k in (earlier, place)]
        moving, now = ({name for law in laws for name in law.variables} for laws in printed)
        if moving != now:
            return False
        constants = []
        for laws in printed:
            mentioned = {n for law in laws for name in law.mentions for n in before.below(name)}
            constants.append({n for n in mentioned if not before.is_defined(n)} - moving)
        return bool(constants[1]) and constants[0] <= constants[1]

    @cached_property
    def named_apart(self) -> list[frozenset[str]]:
        """For each part, the names that are defined in another one only."""
        every = [frozenset(known.definitions) for known in self.known]
        return [frozenset().union(*every) - own for own in every]

    def about(self, found: Directive) -> Known:
        """The part of the first formula that a comment names, or else the first of all."""
        return self.of(found.items[0]) if found.items else self.known[0]

    def is_sure(self, item: SourceStatement, scene: Scene) -> bool:
        """Whether a statement speaks of the law of its part, in names that have no other meaning.

        It stands below the heading below which this law is set up, if there are several parts.
        """
        if len(self.known) == 1:
            return True
        place = self.places[item]
        law = self.known[place].laws[0]
        here = law.first.section in item.sections
        return here and not self.named_apart[place] & {*scene.constants}


def _is_given(name: str, known: Known) -> bool:
    """Whether a name stands for what moves: it is no value of an integral."""
    roles = [(one, known.roles[one]) for one in known.definitions.get(name, ())]
    return any(one.members[:1] == (Name(name),) and role.kind != "integral" for one, role in roles)


def _in_order(laws: Sequence[Law], maps: Sequence[Law]) -> list[Law]:
    """Laws of motion with maps among them; one in a section of its own has letters of its own."""
    found = [*laws]
    for one in maps:
        beside = [law for law in found if law.first.section is one.first.section]
        if laws and not beside:
            one.begins = one.first.section.start
        later = (k for k, law in enumerate(found) if (law.begins or 0) > one.first.typed.start)
        found.insert(next(later, len(found)), one)
    return found


def _supposed_kind(found: SourceStatement, known: Known) -> str:
    """How far what a comment supposes reaches: an equation between what moves is one of a set."""
    if not found.members:
        return "inequality"
    moves = not (found.bare or found.derives) and known.varying(found.names)
    return "set in force" if moves else ""
