"""The equations with rates that a paper prints, and how closed sets of them are grown."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Sequence

from kowalevski_cas.notation import Derivative, Name, Number, PoissonBracket, Sum, Vector
from kowalevski_cas.notation.symbol import symbol
from kowalevski_cas.paper.amplitudes import UNIT
from kowalevski_cas.reading.areas import completes_law, is_of_areas
from kowalevski_cas.reading.comments import Said
from kowalevski_cas.reading.cues import cue
from kowalevski_cas.reading.law import Law
from kowalevski_cas.reading.momenta import find_momenta
from kowalevski_cas.reading.named_solutions import rows_of_solutions
from kowalevski_cas.reading.named_values import named_values
from kowalevski_cas.reading.names import Names
from kowalevski_cas.reading.permuted import permuted_rows
from kowalevski_cas.reading.polar import length_given
from kowalevski_cas.reading.reactions import (
    constrains,
    have_multiplier,
    is_bound,
    is_reacting,
    reactions,
)
from kowalevski_cas.reading.rows import (
    binds_velocities,
    highest_order,
    is_by_own_bracket,
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
    is_dependence,
    is_numerical,
)


def _names_integral(row: SourceStatement, rows: Sequence[SourceStatement]) -> bool:
    r"""Whether a row names what has a rate of zero, as J in :math:`J=r^2\dot\varphi, \dot J=0`.

    Other rows say how what is derived there moves.
    """
    if not isinstance(row.members[0], Name):
        return False
    own = [one for one in rows if row.bare[0] in one.rates]
    others = {name for one in rows if one is not row and one not in own for name in one.rates}
    return all(Number(0) in one.members for one in own) and {*row.rates} <= others


_CIRCLE = re.compile(r"\bcircles?\b|\bdescribed\s+with\b|\bокружност", re.IGNORECASE)
"""Words for a path on which nothing else than its rate is left to tell."""


def _is_of_one_motion(row: SourceStatement, rows: Sequence[SourceStatement]) -> bool:
    """Whether words say of one motion only that a rate has a constant value."""
    others = {name for one in rows for name in one.rates}
    constant = len(row.rates) == 1 and not {*row.members[-1].names()} & others
    alone = all(one.sentence != row.sentence for one in rows if one is not row)
    said = cue("special motion", row.before) or _CIRCLE.search(row.before)
    return row.typed.inline and constant and alone and bool(said)


def _is_where_it_is(item: SourceStatement) -> bool:
    r"""Whether a statement gives a letter by itself with an index, as :math:`x=x_0`."""
    match item.members:
        case (Name(name), Name(value)):
            return name != value and symbol(name).letter == symbol(value).letter
    return False


_MOVES = re.compile(
    r"\b(?:falls?|moves?|obeys?|equations?\s+of\s+motion|пада[ею]т|движ[еу]тся|уравнени\w+\s+движения)\b",
    re.IGNORECASE,
)
"""Words for how a body moves."""


def is_averaged(item: SourceStatement) -> bool:
    """Whether the words before an equation say that it is the average of others."""
    return bool(cue("averaged", item.before)) and not cue("denied", item.before)


class PrintedRates:
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
        fields = {name for row in rows for name in row.bare[:1] if _is_rate_by(name, row)}
        given |= {name for name in fields if _is_given_by(name, rated, items)}
        rows = [
            row
            for row in rows
            if not {*row.bare[:1]} - given
            or self._told(row)
            or _is_driven(row)
            or _is_pushed(row, rows)
            or _is_wanted(row, rows, items)
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

    def _told(self, item: SourceStatement) -> bool:
        return self.said.verb(item) == "law"

    def _may_be_row(self, item: SourceStatement) -> bool:
        printed = item.implied_by or item
        if verb := self.said.verb(printed):
            return verb == "law" and bool(item.rates)
        paper = self.paper
        free = paper.functions_by_name.keys() & item.rates.keys()
        left = paper.maps | paper.unfinished
        left |= frozenset() if is_averaged(printed) else paper.approximate
        along = item.typed.start in paper.orbits
        return is_row(item) and not (free or along) and printed not in left

    def _defines(self, item: SourceStatement) -> bool:
        """Whether a statement gives a name an expression, and is neither a row nor of one."""
        if item in self.rows or item in self.momenta:
            return False
        value = len(item.members) < 3 and any(map(is_numerical, item.members))
        if value or is_dependence(item):  # but f≡Ap+Cr=0 names f
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
        if timed or self._explains(item, rated):
            return not timed
        return not any(row.section in item.sections for row in rated)

    def _explains(self, item: SourceStatement, rated: Sequence[SourceStatement]) -> bool:
        r"""Whether a statement says what it is of which rates stand right before it.

        So it is in :math:`\dot E=-2ky^2` for :math:`E=x^2+y^2`, where it is known how x and y move.
        """
        if not rated or not all(_is_right_before(row, item) for row in rated):
            return False
        if any(row.rates[item.bare[0]] > 1 for row in rated):
            return False  # it may be a constraint
        inside = {id(row.typed) for row in rated}
        before = (row for row in self.rows if row.order < rated[0].order)
        known = {n for row in before if id(row.typed) not in inside for n in self.scalars(row)}
        moving = self.rated & {*self.names.scalars(item.members[1].names())}
        return bool(moving) and moving <= known - {*self.scalars(rated[0])}

    def relates(self, one: SourceStatement, row: SourceStatement, moving: Collection[str]) -> bool:
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
            if not constrains(one, row, self.rows)
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
            if rates_given(own, self.names) >= len(self._unmoved(rated, apart)):
                # else one stands on a right side only
                wanted -= rated - {*self.names.scalars(only_squared(own))}
            more = self.following(own, wanted, apart, rows)
            if not more:
                break
            own += more
        rated_names = {name for row in own for name in self.scalars(row)}
        new = self._unmoved(rated_names, apart)
        squared = {*self.names.scalars(only_squared(own))}
        if rates_given(own, self.names) < len(new) or squared - {*apart}:
            return None
        if rated_names & {*apart} and rates_given(own, self.names) > len(rated_names - {*apart}):
            return None  # what moves already would move in two ways
        own += self.naming_rates(first, rated_names, apart, rows)
        momenta = self.momenta_of(rated_names)
        own += rows_of_conjugates(self.paper, own)
        return Law(tuple(sorted(own, key=lambda row: row.order)), self.names, momenta=momenta)

    def _unmoved(self, rated: set[str], apart: Collection[str]) -> set[str]:
        """Some names of rates without those that move already, where nothing gives the others."""
        given = {
            one.bare[0]
            for one in self.paper.items
            if one.bare and one.members[0] == Name(one.bare[0])
            and not (one.derives or "t" in one.names or any(map(is_numerical, one.members)))
        }  # fmt: skip
        new = rated - {*apart}
        return new if new.isdisjoint(given) else rated

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

        So are those of its sentence that have the same reaction, or multiplier.
        """
        last = first
        for row in rows:
            if row.typed is first.typed:
                yield row
            elif row.sentence == first.sentence and (
                (row.order > first.order and _is_joined(last, row))
                or reactions([first, row], self.paper.items)
                or have_multiplier(first, row)
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
    if len(row.rates) != 1 or (highest := max(row.rates.values())) < 2:
        return False
    if cue("integral", row.before) or (cue("integral", row.after) and not _HAS.match(row.after)):
        return False
    terms = row.members[0].terms if isinstance(row.members[0], Sum) else ()
    driven = [term for term in terms if highest_order(term) == highest]
    outside = (
        node for term in driven for node in (term, *term.children()) if not highest_order(node)
    )
    return bool(driven) and not any(node.names() & {*row.rates} for node in outside)


_HAS = re.compile(
    r"[^.;]*?\b(?:has|have|admits?|possess(?:es)?|имее?ю?т|допуска[ею]т|hat|besitzt|poss[èe]de)\b",
    re.IGNORECASE,
)
"""Words behind an equation that say that it has an integral, and is none."""


def _is_pushed(row: SourceStatement, rows: Sequence[SourceStatement]) -> bool:
    r"""Whether an acceleration alone is that by a force, as in :math:`m\ddot x=F`, and no name.

    The force acts back on another body beside it, or turns this one, or words say that the body
    falls, or moves so, and nothing else says how.
    """
    if len(row.rates) != 1 or len(row.members) != 2 or not highest_order(row.members[0]):
        return False
    others = [one for one in rows if one is not row]
    if any(is_reacting(one, row) for one in others):
        return True
    if highest_order(row.members[0]) != 2:
        return False
    alone = all(one.rates.keys().isdisjoint(row.rates) for one in others)
    return alone and bool(_MOVES.search(row.lead)) and not cue("integral", row.words)


def _is_wanted(
    row: SourceStatement, rows: Sequence[SourceStatement], items: Sequence[SourceStatement]
) -> bool:
    r"""Whether a rate is a letter beside a row that needs it, as in :math:`\dot q=p, \dot p=a`.

    No other row has that rate, and nothing else gives the letter.
    """
    match row.members:
        case (Derivative(Name(name)), Name(value)) if not row.typed.inline:
            beside = [one for one in rows if one is not row and one.sentence == row.sentence]
            alone = all(name not in one.rates for one in rows if one is not row)
            given = any(one.bare[:1] == (value,) and not one.derives for one in items)
            return alone and not given and any(name in one.names for one in beside)
    return False


def _is_rate_by(name: str, row: SourceStatement) -> bool:
    """Whether a row is a rate alone that is a name."""
    match row.members:
        case (Derivative(), Name(other)):
            return name == other
    return False


def _is_given_by(name: str, moving: set[str], items: Sequence[SourceStatement]) -> bool:
    """Whether a statement gives a name by what moves: it is a field then, as f in f=x-x^3."""
    giving = (one for one in items if one.members[:1] == (Name(name),) and len(one.members) == 2)
    return any(not one.rates and one.names & moving and "t" not in one.names for one in giving)


_HERE = re.compile(r"\s*(?:here|where|with|здесь|где)\b[\s,~]*$", re.IGNORECASE)


def _is_right_before(row: SourceStatement, item: SourceStatement) -> bool:
    """Whether a row stands in the sentence of a statement, or the one before, as words say."""
    near = row.sentence == item.sentence
    return near or (row.order + 1 == item.order and _HERE.match(item.lead) is not None)


def _is_joined(one: SourceStatement, other: SourceStatement) -> bool:
    """Whether two statements are rows of one display, or of one list, side by side."""
    alike = one.typed.inline == other.typed.inline and one.typed.kind == other.typed.kind
    words = other.lead.strip(" ,;~")
    if one.typed.inline and (other.order != one.order + 1 or words not in ("", "and", "и")):
        return False
    return alike and (one.typed.inline or not words)
