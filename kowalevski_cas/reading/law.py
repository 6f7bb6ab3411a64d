"""A law of a paper: its equations of motion that belong together."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from kowalevski_cas.reading.names import Names
from kowalevski_cas.reading.statements import SourceStatement


@dataclass(eq=False)
class Law:
    """A closed set of equations of motion, for these variables."""

    items: tuple[SourceStatement, ...]
    names: Names
    base: Law | None = None
    """The law of the names on its right sides, if it is another one."""
    restates: Law | None = None
    """The law of which it is printed anew, for special constants."""
    begins: int | None = None
    """Where the text begins that is about it alone, if it is another system than before."""
    change: tuple[SourceStatement, ...] = ()
    """What gives variables of the base by new names, if it is the same law in these."""
    new: tuple[str, ...] = ()
    """These names."""

    @cached_property
    def given(self) -> dict[str, SourceStatement]:
        """The variables of the base with what gives them by new names."""
        return {name: one for one in self.change for name in self.names.scalars(one.bare[:1])}

    @cached_property
    def variables(self) -> tuple[str, ...]:
        """What moves, by components."""
        if self.base is not None and self.change:
            return (*(name for name in self.base.variables if name not in self.given), *self.new)
        own = self.names.scalars(name for item in self.items for name in item.rates)
        return tuple(dict.fromkeys((*(self.base.variables if self.base else ()), *own)))

    @cached_property
    def printed(self) -> frozenset[SourceStatement]:
        """Its equations as they are printed."""
        return frozenset(item.implied_by or item for item in self.items)

    @cached_property
    def rows(self) -> tuple[SourceStatement, ...]:
        """All its equations, with those that it is added to."""
        return (*(self.base.rows if self.base else ()), *self.items)

    @cached_property
    def order(self) -> int:
        """The place from which on it holds."""
        return max(item.order for item in (*self.items, *self.change))

    @cached_property
    def first(self) -> SourceStatement:
        """The first of its equations."""
        return min((*self.items, *self.change), key=lambda item: item.order)

    @cached_property
    def mentions(self) -> frozenset[str]:
        """All names that stand in it."""
        return frozenset().union(*(item.names for item in self.rows))

    @property
    def title(self) -> str:
        """What it is called: the labels of its equations, or what moves."""
        labels = dict.fromkeys(i.printed.display.label for i in self.rows)
        title = ", ".join(filter(None, labels)) or "the equations of motion"
        return f"{title} in ${', '.join(self.new)}$" if self.new else title
