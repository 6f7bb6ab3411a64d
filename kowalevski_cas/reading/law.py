"""A law of a paper: its equations of motion that belong together."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property

from kowalevski_cas.notation import Derivative, Formula, Name, Number, Power
from kowalevski_cas.reading.names import Names
from kowalevski_cas.reading.statements import SourceStatement


@dataclass(eq=False)
class Law:
    """A closed set of equations of motion, for these variables."""

    items: tuple[SourceStatement, ...]
    names: Names
    is_averaged: bool = False
    """Whether words call it the average of a law: what it says is close to what that says."""
    base: Law | None = None
    """The law of the names on its right sides, if it is another one."""
    is_apart: bool = False
    """Whether nothing that the base moves stands in its equations."""
    restates: Law | None = None
    """The law of which it is printed anew, for special constants."""
    again: tuple[Law, ...] = ()
    """The laws that it prints once more, in more variables."""
    begins: int | None = None
    """Where the text begins that is about it alone, if it is another system than before."""
    ends: int | None = None
    """Where this text ends, and what was spoken of before goes on, if that is known."""
    change: tuple[SourceStatement, ...] = ()
    """What gives variables of the base by new names, if it is the same law in these."""
    new: tuple[str, ...] = ()
    """These names."""
    levels: frozenset[str] = frozenset()
    """The names for values of integrals by which a solution is given: constants of it."""
    radius: SourceStatement | None = None
    """What says that one of these is a radius, which is a root of squares of what is given."""
    together: tuple[SourceStatement, ...] = ()
    """The equations that give new names together, of which its own are the derivatives."""
    images: tuple[tuple[str, str], ...] = ()
    """The variables of a map with their images; none of a motion."""
    solved: tuple[SourceStatement, ...] = ()
    """What gives images that no equation gives alone."""
    momenta: Mapping[SourceStatement, str] = field(default_factory=dict)
    """What gives vectors of which the rates are printed, each with the vector that moves."""

    @property
    def given(self) -> dict[str, SourceStatement]:
        """The variables of the base with what gives them by new names; or images, or momenta."""
        if self.images:
            rows = {one.bare[0]: one for one in (*self.items, *self.solved) if _gives(one)}
            return {name: one for name, one in rows.items() if name not in self._cyclic(rows)}
        found = {name: one for one in self.change for name in self.names.scalars(_head(one))}
        return {**(self.base.given if self.base else {}), **found, **self._momenta}

    @cached_property
    def _momenta(self) -> dict[str, SourceStatement]:
        """The vectors of which the rates are printed and that others give, with what gives them."""
        return {one.bare[0]: one for one in self.momenta}

    @property
    def unsolved(self) -> list[str]:
        """The images that nothing gives."""
        variables = {x for x, _ in self.images}
        return [new for _, new in self.images if new not in variables | {*self.given}]

    def _cyclic(self, rows: Mapping[str, SourceStatement]) -> set[str]:
        """The images that are given by themselves, or by others that are."""
        found = set[str]()
        for name in rows:
            reached, waiting = set[str](), [name]
            while waiting:
                inner = rows[waiting.pop()].members[1].names() & rows.keys() - reached
                reached |= inner
                waiting += inner
            found |= {name} & reached
        return found

    @property
    def orders(self) -> dict[str, int]:
        """The highest order of a derivative of each of the names that move by its rows."""
        members = [member for row in self.rows for member in row.members]
        return {x: max(_order(one, x) for one in members) for row in self.rows for x in row.rates}

    @property
    def variables(self) -> tuple[str, ...]:
        """What moves, by components, or what is mapped."""
        return tuple(x for x, _ in self.images) or self._moving

    @cached_property
    def _moving(self) -> tuple[str, ...]:
        if self.base is not None and self.change:
            return (*(name for name in self.base.variables if name not in self.given), *self.new)
        if self.base is not None and self.together:
            return (*self.base.variables, *self.new)
        moving = {one.bare[0]: name for one, name in self.momenta.items()}
        rated = (name for item in self.items for name in item.rates)
        own = self.names.scalars(moving.get(self.names.whole(name), name) for name in rated)
        return tuple(dict.fromkeys((*(self.base.variables if self.base else ()), *own)))

    @cached_property
    def printed(self) -> frozenset[SourceStatement]:
        """Its equations as they are printed, but for those that another law has before it."""
        return frozenset(item.implied_by or item for item in self._own)

    @cached_property
    def rows(self) -> tuple[SourceStatement, ...]:
        """All its equations, with those that it is added to."""
        return (*(self.base.rows if self.base else ()), *self.items)

    @cached_property
    def own(self) -> Law:
        """The law of what it moves itself, where that is a system apart."""
        return Law(self.items, self.names, momenta=self.momenta) if self.is_apart else self

    @cached_property
    def order(self) -> int:
        """The place from which on it holds."""
        return max(item.order for item in (*self.items, *self.change, *self.momenta))

    @cached_property
    def first(self) -> SourceStatement:
        """The first of its equations, but for those that another law has before it."""
        return min((*self._own, *self.change), key=lambda item: item.order)

    @property
    def _own(self) -> list[SourceStatement]:
        """Its equations where the text is about it: others are kept from a law before it."""
        here = [one for one in self.items if (self.begins or 0) <= one.typed.start]
        return here or [*self.items]

    @cached_property
    def mentions(self) -> frozenset[str]:
        """All names that stand in it."""
        return frozenset().union(*(item.names for item in self.rows))

    @property
    def kind(self) -> str:
        """What its equations are."""
        return "the map" if self.images else "the equations of motion"

    @property
    def labels(self) -> str:
        """The labels of its equations."""
        return ", ".join(filter(None, dict.fromkeys(i.printed.display.label for i in self.rows)))

    @property
    def title(self) -> str:
        """What it is called: the labels of its equations, or what moves."""
        title = self.labels or self.kind
        return f"{title} in ${', '.join(self.new)}$" if self.new else title


def _gives(item: SourceStatement) -> bool:
    """Whether a statement has a name alone on its left."""
    return bool(item.bare) and item.members[0] == Name(item.bare[0])


def _head(item: SourceStatement) -> tuple[str, ...]:
    """The name that a statement gives, itself or its square."""
    match item.members:
        case (Power(Name(name), Number(2)), *_):
            return (name,)
    return item.bare[:1]


def _order(formula: Formula, name: str) -> int:
    """The highest order of a derivative of what has a name in it."""
    below = max((_order(child, name) for child in formula.children()), default=0)
    return below + (isinstance(formula, Derivative) and name in formula.names())
