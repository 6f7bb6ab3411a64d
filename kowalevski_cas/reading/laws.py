"""The equations of motion of a paper: closed sets of rates."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace

from kowalevski_cas.notation import Derivative, Name
from kowalevski_cas.reading.all_roots import find_moving_roots
from kowalevski_cas.reading.changes import conjugates_given, find_changes
from kowalevski_cas.reading.comments import Said
from kowalevski_cas.reading.cues import cue
from kowalevski_cas.reading.free_brackets import free_brackets
from kowalevski_cas.reading.kinematics import free_motion
from kowalevski_cas.reading.law import Law
from kowalevski_cas.reading.names import Names
from kowalevski_cas.reading.other_systems import averaged_system, other_system, stands_beside
from kowalevski_cas.reading.polar import coordinates_in_words, radius_of
from kowalevski_cas.reading.printed_rates import PrintedRates, is_averaged
from kowalevski_cas.reading.restated import replaced_law, times_of
from kowalevski_cas.reading.rows import is_of_motion
from kowalevski_cas.reading.solved import new_factors
from kowalevski_cas.reading.statements import SourcePaper, SourceStatement, derived_names
from kowalevski_cas.reading.together import find_together
from kowalevski_cas.reading.unprinted import hamiltonians_anew, implied_rows


def find_laws(paper: SourcePaper, names: Names, said: Said, maps: Sequence[Law] = ()) -> list[Law]:
    """The laws of motion of a paper, in its order, with those of Hamiltonians of examples.

    Comments that say of each formula what is inferred without them change nothing.
    """
    found = _laws(paper, names, replace(said, of={}), maps)
    rows = frozenset[SourceStatement]().union(*(law.printed for law in (*found, *maps)))
    told = {item for item in said.of if said.verb(item) == "law"}
    others = {item for item in said.of if said.verb(item)} - told
    agrees = told <= rows | paper.unfinished and rows.isdisjoint(others)
    return found if agrees else _laws(paper, names, said, maps)


def _laws(paper: SourcePaper, names: Names, said: Said, maps: Sequence[Law] = ()) -> list[Law]:
    """The laws of motion of a paper, as far as comments let them be some."""
    found = _closed_sets(paper, names, said, maps)
    for (begins, end), rows in hamiltonians_anew(paper) if found and not maps else ():
        within = [law for law in found if begins <= law.first.typed.start < end]
        before = [law for law in found if law.first.typed.start < begins]
        printed = [row for law in within for row in law.items]
        own, moving = Law((*rows,), names), {name for row in printed for name in row.rates}
        if before and moving <= {*own.variables}:
            own = Law((*printed,), names) if moving == {*own.variables} else own
            own.begins, own.ends = begins, end
            found = [*before, own, *(law for law in found if law not in (*before, *within))]
    return found


def _closed_sets(
    paper: SourcePaper, names: Names, said: Said, maps: Sequence[Law] = ()
) -> list[Law]:
    """The closed sets of equations of motion, in the order of the paper.

    The first display with rates of names that nothing defines is grown until the rates of all that
    moves in it are there. Another set has new variables, or is set up as another system. Where none
    is printed, or not all of it, there may be that of a Hamiltonian, or one among the words, but
    beside ``maps``. Where there is none, what is printed may hold for any motion.
    """
    finder = _LawFinder(paper, names, said)
    found = [*finder.laws()]
    if maps:
        return found
    if found and any(map(_sets_up, finder.before(found[0]))):
        found = [*_LawFinder(paper, names, said, inline=True).laws()] or found
    whole = bool(found) and not any(one.rates for one in paper.unfinished)
    alone = [law for law in found if not law.together]
    own = [law for law in alone if not law.change]
    second = len(own) == 1 and is_of_second_order(own[0])
    rows = tuple(implied_rows(paper))
    if rows and second and whole and _needs_momenta(rows, own[0], paper):
        return _with_changes(Law(rows, names, again=(own[0],)), paper, said)
    partial = bool(own) and all(_leaves_out(rows, law, paper) for law in own)
    rows = rows if len(alone) < 2 or not whole or partial else ()
    if rows and not found:
        among_words = [*_LawFinder(paper, names, said, inline=True).laws()]
        if among_words and among_words[0].items[-1].order < rows[0].order:
            if not _leaves_out(rows, among_words[0], paper):
                return among_words  # the energy is printed behind it
    implied = _with_changes(Law(rows, names), paper, said) if rows else []
    if rows and not whole:
        return implied
    if rows and (_leaves_out(rows, found[0], paper) or _is_changed(found[0], implied)):
        return implied
    found = found or [*_LawFinder(paper, names, said, integrals=True).laws()]
    found = found or [*_LawFinder(paper, names, said, inline=True).laws()]
    return found or free_motion(paper, names) or free_brackets(paper, names)


def _with_changes(law: Law, paper: SourcePaper, said: Said) -> list[Law]:
    """A law that is implied, and the same in the new variables that the paper gives."""
    finder = _LawFinder(paper, law.names, said)
    finder.found = [law]
    return [law, *finder.changes([law], None)]


def is_of_second_order(law: Law) -> bool:
    """Whether a law has the second derivatives of all that moves, and no higher ones."""
    orders = {x: order for row in law.rows for x, order in row.rates.items()}
    return {*orders} == {*law.variables} and {*orders.values()} == {2}


def _needs_momenta(rows: Sequence[SourceStatement], law: Law, paper: SourcePaper) -> bool:
    """Whether a paper speaks of the momenta of a Hamiltonian, and prints equations without them.

    Words call these equations of motion, or deduce them; nothing else gives the momenta.
    """
    rated = {name for row in rows for name in row.rates}
    momenta = rated - {*law.variables}
    energies = {name for row in rows for name in derived_names(row)}
    given = {one.bare[0] for one in paper.items if one.bare and one.members[0] == Name(one.bare[0])}
    used = (one for one in paper.items if not {*one.bare[:1]} & energies)
    return (
        {*law.variables} < rated
        and len(momenta) == len(law.variables)
        and not momenta & given
        and any(momenta & one.names for one in used if not isinstance(one.formula, Name))
        and all(map(is_of_motion, law.rows))
    )


def _leaves_out(rows: Sequence[SourceStatement], law: Law, paper: SourcePaper) -> bool:
    """Whether a law beside a Lagrangian, or a Hamiltonian, moves some of its coordinates only.

    It has momenta that are constant, or names that the other coordinates give, or rates of these
    are printed as well: so what is printed follows from all equations. So do equations of which
    some have a coordinate to a lower order.
    """
    moving = {name: order for row in rows for name, order in row.rates.items()}
    lower = {order < moving.get(name, 0) for name, order in law.orders.items()}
    if law.orders.keys() <= moving.keys() and len(lower) > 1:
        return True
    if _has_momenta_by_velocities(law, moving, paper):
        return True
    alike = {order for row in law.rows for order in row.rates.values()} == {*moving.values()}
    alike = alike or is_of_second_order(law)
    left = {*moving} - {*law.variables}
    given = {one.bare[0] for one in paper.items if one.bare and left & one.names}
    rates = [m for one in paper.items for m in one.members if isinstance(m, Derivative)]
    printed = any(one.argument == Name(name) for one in rates for name in left)
    named = printed or bool(law.mentions & (left | given))
    return alike and {*law.variables} < {*moving} and named


def _has_momenta_by_velocities(law: Law, moving: Collection[str], paper: SourcePaper) -> bool:
    """Whether a law moves some momenta that velocities give, and others of these stand in it."""
    own = {*law.variables} - {*moving}
    given = {
        one.bare[0]
        for one in paper.items
        if one.rates and one.bare and one.members[0] == Name(one.bare[0])
        if {*one.rates} <= {*moving} and one.order < law.first.order
    }
    return bool(own) and own <= given and bool(law.mentions & given - own)


def _is_changed(law: Law, implied: Sequence[Law]) -> bool:
    """Whether what a law moves are new variables of one that is implied: it follows."""
    return any({*law.variables} <= {*one.new} for one in implied)


def _in_order(items: Sequence[SourceStatement]) -> list[SourceStatement]:
    return sorted(items, key=lambda one: one.order)


_SETS_UP = re.compile(
    r"\W*(?:(?:now|here|we|теперь|the|equation)\s+)*(?:let|consider|suppose|study|given|пусть|рассмотрим)(?:\s+the\s+(?:\w+\s+)?(?:equation|oscillator|system|problem))?[\s:~]*",
    re.IGNORECASE,
)
"""Words of a sentence that begins with equations of motion."""


def _sets_up(row: SourceStatement) -> bool:
    """Whether a sentence begins with a row among its words, as “Consider” says."""
    return row.typed.inline and _SETS_UP.fullmatch(row.lead) is not None


_SUBSTITUTES = re.compile(
    r"\b(?:substitution|change|transformation|подстановк\w+|замен\w+)\b[^§]*$", re.IGNORECASE
)
"""Words for what is put in the place of something."""


class _LawFinder(PrintedRates):
    """The laws of a paper: the closed sets of its rates, one after the other."""

    def _may_set_up(self, item: SourceStatement) -> bool:
        """Whether a law may begin with a row: with a display, or as the words right before say."""
        aside = any(section.title == "abstract" for section in item.sections)
        said = self.inline or cue("system", item.lead)
        return not item.typed.inline or bool(said and not aside)

    def before(self, law: Law) -> list[SourceStatement]:
        """The rows before a law."""
        return [row for row in self.rows if row.order < law.first.order]

    def laws(self) -> Iterator[Law]:
        found = self.found
        for item in self.rows:
            if any(item in law.items for law in found):
                continue
            last = max((k for k, law in enumerate(found) if law.begins is not None), default=0)
            part = found[last:]
            changed = any({*self.scalars(item)} <= {*one.new} for one in self.changes(part, item))
            if changed and not is_averaged(item):
                continue
            law = self.other(item, part) if found else self.first(item)
            if law is None:
                continue
            if law.begins is not None:
                yield from self.changes(part, law.first)
            found.append(law)
            yield law
        last = max((k for k, law in enumerate(found) if law.begins is not None), default=0)
        yield from self.changes(found[last:], None)

    def changes(self, part: Sequence[Law], end: SourceStatement | None) -> list[Law]:
        """The laws of a part in new names, as far as they are given before a statement."""
        begins = next((law.begins for law in part), None) or self.paper.prose.start
        items = [
            one
            for one in self.paper.items
            if begins <= one.typed.start and (end is None or one.order < end.order)
        ]
        before = {n for law in self.found for n in law.variables if law not in part}
        changed = [
            change
            for law in part
            for change in find_changes(law, self._giving(law, items, end))
            if before.isdisjoint(change.new)
        ]
        for change in changed:
            change.radius = radius_of(change, items, self.paper)
        together = [more for law in part for more in find_together(law, items, self.paper)]
        roots = [more for law in part for more in find_moving_roots(law, items, self.paper)]
        return [*changed, *together, *roots]

    def _giving(
        self, law: Law, items: Sequence[SourceStatement], end: SourceStatement | None
    ) -> list[SourceStatement]:
        """What may give the variables of a law: what is printed, what words say, conjugates."""
        every = [*items, *conjugates_given(law, items, self.paper)]
        return _in_order([*self.polar(law, end), *every])

    def polar(self, law: Law, end: SourceStatement | None) -> list[SourceStatement]:
        """What gives the coordinates of a law by polar ones of words, up to a statement."""
        found = coordinates_in_words(law, self.paper)
        return found if end is None or all(one.order <= end.order for one in found) else []

    def first(self, item: SourceStatement) -> Law | None:
        """The law of a paper that has none before a row."""
        if not self._may_set_up(item) or self.is_defined(item, self.paper.prose.start):
            return None
        if cue("deduced", item.before) and self._has_before(item):
            return None
        since = self.paper.prose.start
        return self.grown(item, (), self.undefined(since))

    def _has_before(self, item: SourceStatement) -> bool:
        """Whether rows before a row give all rates that it has."""
        before = [row for row in self.rows if row.order < item.order]
        return all(
            any(row.rates.get(name, 0) >= order for row in before)
            for name, order in item.rates.items()
        )

    def other(self, item: SourceStatement, part: Sequence[Law]) -> Law | None:
        """Another law beside some: of another system, or of further variables."""
        beside = any(row.sentence == item.sentence for law in part for row in law.items)
        said = beside or self._is_rate_of_new(item, part) or self._is_ground(item)
        if not (self._may_set_up(item) or said) or self._is_of_new_factor(item, part):
            return None
        beside = beside and not stands_beside(self, item, part)
        if not beside and item not in (*self.said.rows, *self.solutions):
            law = replaced_law(item, part, self.paper) or averaged_system(self, item)
            if law := law or other_system(self, item, part):
                return law
        since = part[0].begins or self.paper.prose.start
        moving = {name for law in part for name in law.variables}
        if law := self.fuller(item, moving):
            law.again = (*part,)
            return law
        if not {*self.scalars(item)} - moving or self.is_defined(item, self.paper.prose.start):
            return None
        if times_of((part[0].first,)).isdisjoint(times_of((item,))):
            return None
        rows = self.undefined(since)
        supposed = self.said.rows
        following = [row for row in rows if row not in supposed and self._follows(row, moving)]
        if item in following:
            return None
        law = self.grown(item, moving, [row for row in rows if row not in following])
        rated = {name for row in following for name in self.scalars(row)}
        if law is not None:
            law.base = part[-1]
            mentioned = {*self.names.scalars(n for one in law.items for n in one.names)}
            end = max(one.sentence[1] for one in law.items)
            law.is_apart = mentioned.isdisjoint(self._standing_for(moving, end))
            if rated & {*self.names.scalars(law.mentions)} - moving - {*law.variables}:
                return None  # it rests on what follows
        return law

    def _is_rate_of_new(self, item: SourceStatement, part: Sequence[Law]) -> bool:
        r"""Whether what moves is the multiple of a rate of something new: :math:`v=\dot r`."""
        moving = {name for law in part for name in law.variables}
        given = {*self.names.scalars(item.bare[:1])}
        new = {*self.scalars(item)} - moving
        velocities = all(order == 1 for order in item.rates.values())
        deduced = cue("deduced", item.lead) and not _SUBSTITUTES.search(item.lead)
        if deduced or not (given and given <= moving and new and velocities):
            return False
        before = (one for one in self.paper.items if one.order < item.order and one.members)
        return all(new.isdisjoint(self.names.scalars(one.names)) for one in before)

    def _is_of_new_factor(self, item: SourceStatement, part: Sequence[Law]) -> bool:
        r"""Whether what a row derives is a factor of what is defined by what moves already.

        So is w in :math:`\zeta=e^{-i\omega t}w`, where :math:`\zeta=x+iy`.
        """
        moving = {name for law in part for name in law.variables}
        defined = self._standing_for(moving, item.typed.start) - moving
        return any(
            one.order < item.order
            and {*one.bare[:1]} <= defined
            and {*item.rates} <= {*new_factors(one)}
            for one in self.paper.items
            if one.bare
        )

    def _is_ground(self, item: SourceStatement) -> bool:
        """Whether a higher derivative of what a row derives is deduced from it in its sentence."""
        return any(
            row.order > item.order
            and row.sentence == item.sentence
            and bool(cue("deduced", row.lead))
            and any(order > item.rates.get(name, order) for name, order in row.rates.items())
            for row in self.rows
        )

    def fuller(self, item: SourceStatement, moving: set[str]) -> Law | None:
        r"""A closed display that words call a system, for all that moved and more: the law then.

        So :math:`\ddot q=-q` is printed once more as :math:`\dot q=p, \dot p=-q`.
        """
        if item.typed.inline or not cue("system", item.lead):
            return None
        rows = [*self.beside(item, self.rows)]
        rated = {name for row in rows for name in self.scalars(row)}
        if not moving < rated or any(self.is_defined(row, self.paper.prose.start) for row in rows):
            return None
        return self.grown(item, (), rows)

    def _follows(self, row: SourceStatement, moving: Collection[str]) -> bool:
        """Whether what a row derives was given before by what moves already.

        Where its sentence cites something, it may be given by what stands for that.
        """
        moved = self._standing_for(moving, row.sentence[1]) if row.refs else moving
        return any(self.relates(one, row, moved) for one in self.paper.items)

    def _standing_for(self, moving: Collection[str], end: int) -> set[str]:
        """What moves, with the names, or their squares, that are given by it, up to an offset."""
        giving = [
            one
            for one in self.paper.items
            if one.members and one not in self.rows and one.typed.start < end
        ]
        found = {*moving}
        while new := {
            name
            for one in giving
            if found & {*self.names.scalars(one.names)}
            for name in (*one.printed.heads.names, *one.printed.heads.squares)
            if name not in found
        }:
            found |= new
        return found
