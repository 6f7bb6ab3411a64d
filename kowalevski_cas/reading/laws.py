"""The equations of motion of a paper: closed sets of rates."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Sequence

from kowalevski_cas.notation import Name, Number, PoissonBracket, Sum, Vector
from kowalevski_cas.notation.symbol import symbol
from kowalevski_cas.paper.amplitudes import UNIT
from kowalevski_cas.reading.areas import completes_law, is_of_areas
from kowalevski_cas.reading.changes import find_changes
from kowalevski_cas.reading.comments import Said
from kowalevski_cas.reading.cues import cue
from kowalevski_cas.reading.free_brackets import free_brackets
from kowalevski_cas.reading.kinematics import free_motion
from kowalevski_cas.reading.law import Law
from kowalevski_cas.reading.momenta import find_momenta
from kowalevski_cas.reading.named_solutions import rows_of_solutions
from kowalevski_cas.reading.named_values import named_values
from kowalevski_cas.reading.names import Names
from kowalevski_cas.reading.permuted import permuted_rows
from kowalevski_cas.reading.polar import coordinates_in_words, length_given, radius_of
from kowalevski_cas.reading.reactions import is_bound, reactions
from kowalevski_cas.reading.restated import replaced_law, times_of
from kowalevski_cas.reading.rows import (
    binds_velocities,
    highest_order,
    is_by_own_bracket,
    is_of_motion,
    is_row,
    only_squared,
    rates_given,
)
from kowalevski_cas.reading.said_rows import (
    row_of_value,
    rows_of_columns,
    rows_of_conjugates,
    rows_of_differentials,
    rows_of_matrices,
)
from kowalevski_cas.reading.statements import (
    SourcePaper,
    SourceStatement,
    derived_names,
    is_dependence,
    is_numerical,
)
from kowalevski_cas.reading.together import find_together
from kowalevski_cas.reading.unprinted import implied_rows


def find_laws(paper: SourcePaper, names: Names, said: Said, maps: Sequence[Law] = ()) -> list[Law]:
    """The closed sets of equations of motion, in the order of the paper.

    The first display with rates of names that nothing defines is grown until the rates of all that
    moves in it are there. Another set has new variables, or is set up as another system. Where none
    is printed, or not all of it, there may be that of a Hamiltonian, or one among the words, but
    beside ``maps``. Where there is none, what is printed may hold for any motion.
    """
    found = [*_LawFinder(paper, names, said).laws()]
    if maps:
        return found
    whole = bool(found) and not any(one.rates for one in paper.unfinished)
    own = [law for law in found if not law.change]
    second = len(own) == 1 and is_of_second_order(own[0])
    rows = tuple(implied_rows(paper)) if second or len(found) < 2 or not whole else ()
    if rows and second and whole and _needs_momenta(rows, own[0], paper):
        return _with_changes(Law(rows, names, again=(own[0],)), paper, said)
    rows = rows if len(found) < 2 or not whole else ()
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


def _names_integral(row: SourceStatement, rows: Sequence[SourceStatement]) -> bool:
    r"""Whether a row names what has a rate of zero, as J in :math:`J=r^2\dot\varphi, \dot J=0`.

    Other rows say how what is derived there moves.
    """
    if not isinstance(row.members[0], Name):
        return False
    own = [one for one in rows if row.bare[0] in one.rates]
    others = {name for one in rows if one is not row and one not in own for name in one.rates}
    return all(Number(0) in one.members for one in own) and {*row.rates} <= others


_ONE_MOTION = re.compile(
    r"\b(?:circles?|circular|steady|stationary|equilibri\w+|permanent|uniform\w*|special|particular"
    r"|at\s+the\s+(?:lowest|highest|top|bottom|turning|point)|described\s+with)\b"
    r"|\b(?:окружност\w*|кругов\w+|стационарн\w+|равномерн\w+|равновеси\w+|перманентн\w+|частн\w+)\b",
    re.IGNORECASE,
)
"""Words for motions that are not all."""


def _is_of_one_motion(row: SourceStatement, rows: Sequence[SourceStatement]) -> bool:
    """Whether words say of one motion only that a rate has a constant value."""
    others = {name for one in rows for name in one.rates}
    constant = len(row.rates) == 1 and not {*row.members[-1].names()} & others
    alone = all(one.sentence != row.sentence for one in rows if one is not row)
    return row.typed.inline and constant and alone and bool(_ONE_MOTION.search(row.before))


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

    It has momenta that are constant, or names that the other coordinates give: so what is printed
    follows from all equations.
    """
    moving = {name: order for row in rows for name, order in row.rates.items()}
    alike = {order for row in law.rows for order in row.rates.values()} == {*moving.values()}
    left = {*moving} - {*law.variables}
    given = {one.bare[0] for one in paper.items if one.bare and left & one.names}
    return alike and {*law.variables} < {*moving} and bool(law.mentions & (left | given))


def _is_changed(law: Law, implied: Sequence[Law]) -> bool:
    """Whether what a law moves are new variables of one that is implied: it follows."""
    return any({*law.variables} <= {*one.new} for one in implied)


def _is_where_it_is(item: SourceStatement) -> bool:
    r"""Whether a statement gives a letter by itself with an index, as :math:`x=x_0`."""
    match item.members:
        case (Name(name), Name(value)):
            return name != value and symbol(name).letter == symbol(value).letter
    return False


def _in_order(items: Sequence[SourceStatement]) -> list[SourceStatement]:
    return sorted(items, key=lambda one: one.order)


_MOVES = re.compile(
    r"\b(?:falls?|moves?|obeys?|equations?\s+of\s+motion|пада[ею]т|движ[еу]тся|уравнени\w+\s+движения)\b",
    re.IGNORECASE,
)
"""Words for how a body moves."""


_FOLLOWS = re.compile(
    r"\b(?:substitut\w+|eliminat\w+|differentiat\w+|see|follows?|hence|therefore|thus|consequently"
    r"|подстав\w+|исключ\w+|дифференцир\w+|видим|следует|отсюда|поэтому|следовательно)\b",
    re.IGNORECASE,
)
"""Words that derive equations from those before."""


class _LawFinder:
    """The equations with rates of a paper, and which of them belong together."""

    def __init__(
        self,
        paper: SourcePaper,
        names: Names,
        said: Said,
        inline: bool = False,
        integrals: bool = False,
    ) -> None:
        self.paper, self.names, self.said = paper, names, said
        self.inline = inline
        """Whether any words may have a law among them."""
        items = sorted((*paper.items, *said.rows), key=lambda item: item.order)
        items = [one for item in items for one in rows_of_columns(paper, item)]
        with_values = dict(self._completing(items)) if integrals else {}
        completing = [*with_values.values()]
        items = [with_values.get(item, item) for item in items]
        rows = [item for item in items if self._may_be_row(item)]
        others = {name for row in rows if not is_by_own_bracket(row) for name in row.names}
        rows = [
            row
            for row in rows
            if not others or not is_by_own_bracket(row) or others & row.rates.keys()
        ]
        rated = {name for row in rows for name in row.rates}
        given = rated | paper.functions_by_name.keys()
        rows = [
            row
            for row in rows
            if not {*row.bare[:1]} - given
            or self._told(row)
            or _is_driven(row)
            or _is_pushed(row, rows)
            or is_of_areas(row, rows, paper)
            or row in completing
        ]
        rows = [
            row
            for row in rows
            if row in completing
            or not (
                _names_integral(row, rows)
                or binds_velocities(row, rows)
                or _is_of_one_motion(row, rows)
                or is_bound(row, rows, paper.items)
            )
        ]
        entries = rows_of_matrices(paper, rows)
        rows = [one for row in rows for one in entries.get(row, [row])]
        self.solutions = [*rows_of_solutions(paper, rows)]
        rows = sorted([*rows, *self.solutions], key=lambda row: row.order)
        rows = [*rows, *rows_of_differentials(paper)]
        self.rows = sorted([*rows, *permuted_rows(rows, paper)], key=lambda row: row.order)
        self.rated = {name for row in self.rows for name in self.scalars(row)}
        self.multiples = [row for row in self.rows if isinstance(row.members[0], Name)]
        self.momenta = find_momenta(paper.items, self.rows, names)
        self.found: list[Law] = []
        self.defining: dict[str, list[SourceStatement]] = {}
        for item in (*paper.items, *named_values(paper)):
            name = length_given(item) or next(iter(item.bare), "")
            if name and self._defines(item):
                self.defining.setdefault(name, []).append(item)

    def _completing(
        self, items: Sequence[SourceStatement]
    ) -> Iterator[tuple[SourceStatement, SourceStatement]]:
        """The integrals that say how something moves, each with the row that it is then."""
        rows = [item for item in items if self._may_be_row(item)]
        for item in items:
            row = row_of_value(self.paper, item)
            if self._may_be_row(row) and completes_law(row, rows, self.paper):
                yield item, row

    def _may_set_up(self, item: SourceStatement) -> bool:
        """Whether a law may begin with a row: with a display, or as the words right before say."""
        aside = any(section.title == "abstract" for section in item.sections)
        said = self.inline or cue("system", item.lead)
        return not item.typed.inline or bool(said and not aside)

    def _told(self, item: SourceStatement) -> bool:
        return self.said.verb(item) == "law"

    def _may_be_row(self, item: SourceStatement) -> bool:
        printed = item.implied_by or item
        if verb := self.said.verb(printed):
            return verb == "law" and bool(item.rates)
        paper = self.paper
        free = paper.functions_by_name.keys() & item.rates.keys()
        left = paper.approximate | paper.maps | paper.unfinished
        along = item.typed.start in paper.orbits
        return is_row(item) and not (free or along) and printed not in left

    def _defines(self, item: SourceStatement) -> bool:
        """Whether a statement gives a name an expression, and is neither a row nor of one."""
        if item in self.rows or item in self.momenta:
            return False
        if any(map(is_numerical, item.members)) or is_dependence(item):
            return False
        if self.names.are_components(item.members) or _is_where_it_is(item):
            return False
        if any(isinstance(member, PoissonBracket) for member in item.members):
            return False  # it gives the bracket
        if UNIT in item.names and not self.rated & (item.names - {*item.bare}):
            return False  # it names real parts, of which no rates are printed
        name = length_given(item) or item.bare[0]
        rated = [row for row in self.rows if row.order < item.order and name in row.rates]
        timed = bool(rated) and "t" in item.names  # it is a solution
        return not timed and not any(row.section in item.sections for row in rated)

    def laws(self) -> Iterator[Law]:
        found = self.found
        for item in self.rows:
            if any(item in law.items for law in found):
                continue
            last = max((k for k, law in enumerate(found) if law.begins is not None), default=0)
            part = found[last:]
            if any({*self.scalars(item)} <= {*one.new} for one in self.changes(part, item)):
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
            for change in find_changes(law, _in_order([*self.polar(law, end), *items]))
            if before.isdisjoint(change.new)
        ]
        for change in changed:
            change.radius = radius_of(change, items, self.paper)
        together = [more for law in part for more in find_together(law, items, self.paper)]
        return [*changed, *together]

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
        if not (self._may_set_up(item) or beside):
            return None
        if not beside and item not in (*self.said.rows, *self.solutions):
            if law := replaced_law(item, part, self.paper) or self.other_system(item, part):
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
            if rated & {*self.names.scalars(law.mentions)} - moving - {*law.variables}:
                return None  # it rests on what follows
        return law

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

    def other_system(self, item: SourceStatement, part: Sequence[Law]) -> Law | None:
        """A set that is closed by itself, with words for it, or in another section.

        In another section it follows from nothing, and is for names that are not defined by those
        of the law before, nor rest on them.
        """
        before = part[0].first
        titled = before.section is not item.section and cue("another system", item.section.title)
        said = cue("another system", item.before) or titled
        apart = [one for one in item.sections if one not in before.sections]
        new = bool(apart) and before.section not in item.sections
        if (item.refs and not cue("another system", item.before)) or not (new or said):
            return None
        begins = self._begins(item, apart[0].start) if apart else item.sentence[0]
        end = apart[0].end if apart else item.section.end
        printed_rows = (row for row in self.undefined(begins) if row not in self.said.rows)
        rows = [row for row in printed_rows if begins <= row.typed.start < end]
        beside = {row for row in self.rows if row.typed is item.typed}
        law = self.grown(item, (), rows) if beside <= {*rows} else None
        if law is None:
            return None
        if all(self.is_defined(row, item.section.start) for row in beside):
            return None  # it is deduced for names that stand for what moves
        old = {name for one in part for name in one.variables}
        rated, named = {*law.variables}, {*self.names.scalars(law.mentions)}
        met = {name for one in self.paper.items if one.typed.start < begins for name in one.names}
        anew = bool(said or (named - met and cue("system", item.before)))
        if not _FOLLOWS.search(item.before):
            anew = anew or self._is_of_new_constants(law, part, named - met)
        deduced = cue("deduced", item.before) and not anew
        printed = {row.formula for one in part for row in one.rows}
        if named & old - rated or (deduced and rated <= old):
            return None
        heading = apart[0].start if apart else begins
        since = (
            one
            for one in self._since(heading, item)
            if one not in law.momenta and not len(one.bare) == len(one.members) == 2
        )  # a new letter for what moved before is that of the new system
        if not said and any(self._relates(one, item, old) for one in since):
            return None
        if not said and len(law.items) == 1 and rated < old:  # what follows for one of several
            return None
        if all(row.formula in printed for row in law.items):
            return None
        if not said and all(self.is_defined(row, self.paper.prose.start) for row in law.items):
            return None
        between = [one for one in self.paper.items if begins <= one.typed.start < item.typed.start]
        speaks = any({*self.names.scalars(one.names)} & old - rated for one in between)
        law.begins = item.sentence[0] if speaks else begins
        return law

    def _is_of_new_constants(self, law: Law, part: Sequence[Law], new: Collection[str]) -> bool:
        """Whether the rates of all that moved are given with new letters, which nothing gives.

        They do not follow from the law before, which has nothing of them.
        """
        orders, before = (
            {name: order for one in laws for row in one.rows for name, order in row.rates.items()}
            for laws in ([law], part)
        )
        given = {name for one in self.paper.items for name in one.printed.heads.names}
        return orders == before and bool({*new} - given)

    def _begins(self, row: SourceStatement, heading: int) -> int:
        """Where another system begins: at its heading, unless rates stand between, as of this."""
        between = any(one.rates for one in self._since(heading, row) if one.typed is not row.typed)
        return row.sentence[0] if between else heading

    def _since(self, begins: int, row: SourceStatement) -> list[SourceStatement]:
        """The statements from an offset on, before a row."""
        return [
            one for one in self.paper.items if begins <= one.typed.start and one.order < row.order
        ]

    def _follows(self, row: SourceStatement, moving: Collection[str]) -> bool:
        """Whether what a row derives was given before by what moves already.

        Where its sentence cites something, it may be given by what stands for that.
        """
        moved = self._standing_for(moving) if row.refs else moving
        return any(self._relates(one, row, moved) for one in self.paper.items)

    def _standing_for(self, moving: Collection[str]) -> set[str]:
        """What moves, with the names, or their squares, that are given by it."""
        giving = [one for one in self.paper.items if one.members and one not in self.rows]
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

    def _relates(self, one: SourceStatement, row: SourceStatement, moving: Collection[str]) -> bool:
        """Whether an equation before a row gives what the row derives by what moves already."""
        if one.order >= row.order or not one.members:
            return False
        if one in self.rows and not (one.bare and {*self.scalars(one)} <= {*moving}):
            return False  # but p=m\dot q gives p where q moves already
        return bool({*row.rates} & one.names - {*moving}) and bool(
            {*self.names.scalars(one.names)} & {*moving}
        )

    def is_defined(self, row: SourceStatement, since: int) -> bool:
        r"""Whether a name that a row derives is defined before, from an offset on, or beside it.

        A multiple of a rate defines it, as :math:`C=r^2\dot\theta`, where that moves already.
        """
        for one in self.multiples:
            if one.order < row.order and one.bare[0] in row.rates:
                moving = {name for law in self.found for name in law.variables}
                if {*self.scalars(one)} <= moving:
                    return True
        return any(
            since <= one.typed.start < row.typed.start or one.sentence == row.sentence
            for name in {*row.rates, *map(self.names.whole, row.rates)}
            for one in self.defining.get(name, ())
            if name in row.rates or not isinstance(one.members[1], Vector)
        )

    def undefined(self, since: int) -> list[SourceStatement]:
        """The rows for names that nothing defines before them, from an offset on."""
        return [row for row in self.rows if self._told(row) or not self.is_defined(row, since)]

    def scalars(self, item: SourceStatement) -> tuple[str, ...]:
        return self.names.scalars(item.rates)

    def _turning(self, row: SourceStatement) -> tuple[str, ...]:
        """The constant by which a row says how an angle turns: who names it wants the row."""
        return row.bare[:1] if is_of_areas(row, self.rows, self.paper) else ()

    def grown(
        self, first: SourceStatement, apart: Collection[str], rows: Sequence[SourceStatement]
    ) -> Law | None:
        """A set of rows from a first one on, grown until it is closed; ``None`` if it cannot be."""
        own = [*self.beside(first, rows)]
        while True:
            rated = {name for row in own for name in self.scalars(row)}
            wanted = {name for row in own for name in self.names.scalars(row.names)}
            wanted -= {*self.names.scalars(self.momenta_of(rated).values())}
            if rates_given(own, self.names) >= len(rated):  # else one stands on a right side only
                wanted -= rated - {*self.names.scalars(only_squared(own))}
            more = self.following(own, wanted, apart, rows)
            if not more:
                break
            own += more
        rated_names = {name for row in own for name in self.scalars(row)}
        if rates_given(own, self.names) < len(rated_names) or only_squared(own):
            return None
        own += self.naming_rates(first, rated_names, apart, rows)
        momenta = self.momenta_of(rated_names)
        own += rows_of_conjugates(self.paper, own)
        return Law(tuple(sorted(own, key=lambda row: row.order)), self.names, momenta=momenta)

    def naming_rates(
        self,
        first: SourceStatement,
        moving: Collection[str],
        apart: Collection[str],
        rows: Sequence[SourceStatement],
    ) -> list[SourceStatement]:
        r"""The rows before a law by which what moves in it names a rate, as :math:`H=\dot a/a`.

        Nothing else says how it moves of which this is the rate.
        """
        naming = [row for row in rows if row.order < first.order and {*row.bare[:1]} & {*moving}]
        given = [{*self.scalars(row)} for row in rows]
        return [
            row
            for row in naming
            if row.members[0] == Name(row.bare[0])
            and not {*self.scalars(row)} & {*moving, *apart}
            and sum(bool(one & {*self.scalars(row)}) for one in given) == 1
        ]

    def momenta_of(self, rated: Collection[str]) -> dict[SourceStatement, str]:
        """What gives vectors by others, if the rates of the former are there."""
        return {
            one: moving
            for one, moving in self.momenta.items()
            if {*rated}.issuperset(self.names.scalars(one.bare[:1]))
        }

    def beside(
        self, first: SourceStatement, rows: Sequence[SourceStatement]
    ) -> Iterator[SourceStatement]:
        """A row and those that follow it in its display, without a word between.

        So are those of its sentence that have the same reaction.
        """
        last = first
        for row in rows:
            if row.typed is first.typed:
                yield row
            elif row.sentence == first.sentence and (
                (row.order > first.order and _is_joined(last, row))
                or reactions([first, row], self.paper.items)
            ):
                last = row
                yield row

    def following(
        self,
        own: Sequence[SourceStatement],
        wanted: Collection[str],
        apart: Collection[str],
        rows: Sequence[SourceStatement],
    ) -> list[SourceStatement]:
        """The rows that tell how what is wanted moves: of its sentence, a display, or else inline.

        In another section they are about what moves here.
        """
        at = own[0]
        rated = {name for row in own for name in self.scalars(row)}
        others = [row for row in rows if row not in own]
        found = [
            row for row in others
            if {*self.scalars(row), *self._turning(row)} & {*wanted}
            and not {*self.scalars(row)} & {*apart}
            and (row.sections[:2] == at.sections[:2] or {*self.names.scalars(row.names)} & rated)
        ]  # fmt: skip
        order = at.order
        found.sort(
            key=lambda row: (
                row.sentence != at.sentence,
                row.typed.inline,
                row.order < order,
                abs(row.order - order),
            )
        )
        if not found:
            return []
        whole = [row for row in others if row.typed is found[0].typed]
        return [row for row in whole if not {*self.scalars(row)} <= rated] or whole


def _is_driven(row: SourceStatement) -> bool:
    r"""Whether one acceleration stands among other terms, as in :math:`\ddot x+ax=f`.

    What is alone on the other side is a force then, and no name for what stands there; but words
    may call that an integral, and where what moves multiplies the acceleration it is some function.
    """
    if cue("integral", f"{row.words} {row.after}") or len(row.rates) != 1:
        return False
    terms = row.members[0].terms if isinstance(row.members[0], Sum) else ()
    driven = [term for term in terms if highest_order(term) > 1]
    outside = (
        node for term in driven for node in (term, *term.children()) if not highest_order(node)
    )
    return bool(driven) and not any(node.names() & {*row.rates} for node in outside)


def _is_pushed(row: SourceStatement, rows: Sequence[SourceStatement]) -> bool:
    r"""Whether an acceleration alone is that by a force, as in :math:`m\ddot x=F`, and no name.

    The force acts back on another body beside it, or words say that the body falls, or moves so,
    and nothing else says how.
    """
    if len(row.rates) != 1 or len(row.members) != 2 or highest_order(row.members[0]) != 2:
        return False
    others = [one for one in rows if one is not row]
    reacting = (one for one in others if one.typed is row.typed and {*row.bare} & one.names)
    if any(one.rates.keys().isdisjoint(row.rates) for one in reacting):
        return True
    alone = all(one.rates.keys().isdisjoint(row.rates) for one in others)
    return alone and bool(_MOVES.search(row.lead)) and not cue("integral", row.words)


def _is_joined(one: SourceStatement, other: SourceStatement) -> bool:
    """Whether two statements are rows of one display, the second right behind the first."""
    return (
        not one.typed.inline and one.typed.kind == other.typed.kind and not other.lead.strip(" ,;")
    )
