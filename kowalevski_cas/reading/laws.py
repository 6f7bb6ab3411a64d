"""The equations of motion of a paper: closed sets of rates."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

from kowalevski_cas.notation import Derivative, Formula, Name, Number, Power, Product, Relation
from kowalevski_cas.reading.comments import Said
from kowalevski_cas.reading.cues import cue
from kowalevski_cas.reading.names import Names
from kowalevski_cas.reading.statements import SourcePaper, SourceStatement


@dataclass(eq=False)
class Law:
    """A closed set of equations of motion, for these variables."""

    items: tuple[SourceStatement, ...]
    names: Names
    base: Law | None = None
    """The law of the names on its right sides, if it is another one."""
    restates: Law | None = None
    """The law of which it is printed anew, for special constants."""

    @cached_property
    def variables(self) -> tuple[str, ...]:
        """What moves, by components."""
        own = self.names.scalars(name for item in self.items for name in item.rates)
        return tuple(dict.fromkeys((*(self.base.variables if self.base else ()), *own)))

    @cached_property
    def rows(self) -> tuple[SourceStatement, ...]:
        """All its equations, with those that it is added to."""
        return (*(self.base.rows if self.base else ()), *self.items)

    @cached_property
    def order(self) -> int:
        """The place from which on it holds."""
        return max(item.order for item in self.items)

    @cached_property
    def first(self) -> SourceStatement:
        """The first of its equations."""
        return min(self.items, key=lambda item: item.order)

    @cached_property
    def mentions(self) -> frozenset[str]:
        """All names that stand in it."""
        return frozenset().union(*(item.names for item in self.rows))

    @property
    def title(self) -> str:
        """What it is called: the labels of its equations, or what moves."""
        labels = dict.fromkeys(i.printed.display.label for i in self.items)
        return ", ".join(filter(None, labels)) or "the equations of motion"


def find_laws(paper: SourcePaper, names: Names, said: Said) -> list[Law]:
    """The closed sets of equations of motion, in the order of the paper.

    The first display with rates of names that nothing defines is grown until the rates of all that
    moves in it are there. Another set has new variables, or is set up as another system.
    """
    return [*_LawFinder(paper, names, said).laws()]


def find_restated(paper: SourcePaper, laws: Sequence[Law]) -> list[Law]:
    """The laws that displays print anew, row for row, with what rows of the law are left."""
    found: list[Law] = []
    for items in {
        id(i.typed): [o for o in paper.items if o.typed is i.typed] for i in paper.items
    }.values():
        rows = [item for item in items if is_row(item) and item not in paper.approximate]
        if not rows or rows[0].typed.inline or any(rows[0] in law.items for law in laws):
            continue
        for law in laws:
            rated = {name for row in rows for name in law.names.scalars(row.rates)}
            own = [row for row in law.rows if rated & {*law.names.scalars(row.rates)}]
            old = {name for row in own for name in law.names.scalars(row.rates)}
            if law.order < rows[0].order and rated == old:
                kept = tuple(row for row in law.rows if row not in own)
                found.append(Law((*kept, *rows), law.names, restates=law))
                break
    return found


class _LawFinder:
    """The equations with rates of a paper, and which of them belong together."""

    def __init__(self, paper: SourcePaper, names: Names, said: Said) -> None:
        self.paper, self.names = paper, names
        defined: dict[str, int] = {}
        for item in paper.items:
            if (
                item.bare
                and not item.derives
                and not any(isinstance(m, Number) for m in item.members)
            ):
                defined.setdefault(item.bare[0], item.order)
        self.rows = [
            item
            for item in paper.items
            if (
                verb == "law" and item.rates
                if (verb := said.verb(item))
                else is_row(item)
                and item not in paper.approximate
                and not any(defined.get(n, item.order) < item.order for n in item.rates)
            )
        ]

    def laws(self) -> Iterator[Law]:
        known: list[Law] = []
        for item in self.rows:
            if item.typed.inline or any(item in law.items for law in known):
                continue
            moving = {name for law in known for name in law.variables}
            new = {*self.scalars(item)} - moving
            if known and not new and not self._another(item, known):
                continue
            law = self.grown(item, moving if new else set())
            if law is not None:
                if new and known:
                    law.base = known[-1]
                known.append(law)
                yield law

    def _another(self, item: SourceStatement, known: Sequence[Law]) -> bool:
        """Whether the words, or another section, set up another system in the same variables."""
        if self._own_system(item, known[-1]):
            return True
        said = cue("another system", item.before) or cue("another system", item.section.title)
        return bool(said) and item.section not in known[-1].first.sections[-1:]

    def _own_system(self, item: SourceStatement, before: Law) -> bool:
        """Whether a display of another section is closed by itself, and follows from nothing.

        What it says of the variables of an earlier law would contradict that law, or repeat it.
        """
        if item.sections[:2] == before.first.sections[:2] or len(item.sections) < 2:
            return False
        if cue("follows", item.before) or cue("derived", item.before) or item.refs:
            return False
        rows = [row for row in self.rows if row.typed is item.typed]
        rated = {name for row in rows for name in self.scalars(row)}
        named = {name for row in rows for name in self.names.scalars(row.names)}
        printed = {row.formula for row in before.rows}
        new = any(row.formula not in printed for row in rows)
        return new and self.given(rows) >= len(rated) and not named & {*before.variables} - rated

    def scalars(self, item: SourceStatement) -> tuple[str, ...]:
        return self.names.scalars(item.rates)

    def grown(self, first: SourceStatement, apart: Collection[str]) -> Law | None:
        """A set of rows from a first one on, grown until it is closed; ``None`` if it cannot be."""
        own = [row for row in self.rows if row.typed is first.typed]
        while True:
            rated = {name for row in own for name in self.scalars(row)}
            wanted = {name for row in own for name in self.names.scalars(row.names)}
            if self.given(own) >= len(rated):  # else a rate stands on a right side only
                wanted -= rated
            more = self.following(own, wanted, apart)
            if not more:
                break
            own += more
        rated_names = {name for row in own for name in self.scalars(row)}
        if self.given(own) < len(rated_names):
            return None
        return Law(tuple(sorted(own, key=lambda row: row.order)), self.names)

    def given(self, rows: Sequence[SourceStatement]) -> int:
        """How many rates some rows give, each one or those of a vector."""
        return sum(len(self.names.vectors.get(_left(row), "1")) for row in rows)

    def following(
        self, own: Sequence[SourceStatement], wanted: Collection[str], apart: Collection[str]
    ) -> list[SourceStatement]:
        """The rows that tell how what is wanted moves: of a display, or else inline."""
        at = own[0].order
        rated = {name for row in own for name in self.scalars(row)}
        others = [row for row in self.rows if row not in own]
        found = [
            row for row in others
            if {*self.scalars(row)} & {*wanted} and not {*self.scalars(row)} & {*apart}
        ]  # fmt: skip
        found.sort(key=lambda row: (row.typed.inline, row.order < at, abs(row.order - at)))
        if not found:
            return []
        whole = [row for row in others if row.typed is found[0].typed]
        return [row for row in whole if not {*self.scalars(row)} <= rated] or whole


def is_row(item: SourceStatement) -> bool:
    r"""Whether a statement may be an equation of motion: an equality, linear in rates.

    What is a name on the left is a definition, unless it gives a multiple of one rate, as
    :math:`p=m\dot q`.
    """
    if len(item.members) != 2 or not item.rates:
        return False
    nodes = [node for member in item.members for node in member.nodes()]
    if any(isinstance(node, Power) and _has_rate(node.base) for node in nodes):
        return False
    return not isinstance(item.members[0], Name) or _is_multiple(item.members[1])


def _is_multiple(formula: Formula) -> bool:
    """Whether a formula is a rate with a factor."""
    factors = formula.factors if isinstance(formula, Product) else (formula,)
    return sum(isinstance(factor, Derivative) for factor in factors) == 1


def _has_rate(formula: Formula) -> bool:
    return any(isinstance(node, Derivative) for node in formula.nodes())


def _left(row: SourceStatement) -> str:
    """The name of which a row gives the rate, or the one that it begins with."""
    formula = row.formula
    assert isinstance(formula, Relation)
    for member in formula.members:
        for node in member.nodes():
            if isinstance(node, Derivative):
                return next(iter(node.argument.names()), "")
    return ""
