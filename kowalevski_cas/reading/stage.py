"""The smallest scene on which a statement of a paper can stand."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace

from kowalevski_cas.notation import Formula, Name, PoissonBracket, Root, to_latex
from kowalevski_cas.notation.formula import Power
from kowalevski_cas.paper.names import BRACKET, head
from kowalevski_cas.paper.plain import half_power
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.paper.texts import Display, Printed
from kowalevski_cas.reading.known import Known
from kowalevski_cas.reading.laws import Law
from kowalevski_cas.reading.statements import Item

UNIT = Display("unit", "i^2=-1", "", source="the usual convention")
"""The imaginary unit of papers that print none."""


class Unclear(ValueError):
    """Why a statement has no scene; the message says what to print, or to comment."""


@dataclass(frozen=True)
class Supposed:
    """A scene, with the statements that it takes for granted and the names it takes for constants."""

    scene: Scene
    assumptions: tuple[Item, ...]
    constants: tuple[str, ...]


@dataclass(eq=False)
class Stage:
    """The scenes of a paper, each made once."""

    known: Known
    scenes: dict[object, Supposed] = field(default_factory=dict)

    def scene(self, items: Sequence[Item], assumptions: Sequence[Item] = ()) -> Supposed:
        """The smallest scene of some statements, with what is supposed of its constants."""
        at = max(items, key=lambda item: item.order)
        names = {name for item in items for name in self._mentioned(item)}
        law = self.law(at, names)
        closure, definitions = self._closure(names, law, at)
        of_closure = [a for a in assumptions if {*self.known.roles[a].names} & closure]
        for one in of_closure:
            closure |= one.names
        roots = [n for item in items for n in _roots(item.formula)]
        key = (law, frozenset(closure), tuple(definitions.items()), tuple(of_closure), *roots)
        if key not in self.scenes:
            self.scenes[key] = self._made(law, closure, definitions, of_closure, items)
        return self.scenes[key]

    def _mentioned(self, item: Item) -> set[str]:
        """The names that a statement needs, with those of brackets if it has some."""
        found = set(item.names)
        if item.formula is not None and any(
            isinstance(node, PoissonBracket) for node in item.formula.nodes()
        ):
            found |= {name for name in self.known.definitions if name.startswith(BRACKET)}
        for node in item.formula.nodes() if item.formula is not None else ():
            function = getattr(node, "function", "")
            if function:
                found.add(function)
        return found

    def law(self, item: Item, names: Iterable[str]) -> Law | None:
        """The law of a statement: the one that is cited, or the latest that moves its names."""
        wanted = {*names}
        laws = [law for law in self.known.laws if law.first.order <= item.order] or self.known.laws
        cited = {*self.known.cited(item)}
        closure = {n for name in wanted for n in self.known.below(name)}
        moved = {*self.known.names.scalars(closure)}
        fitting = [law for law in laws if moved & {*law.variables}]
        best = [law for law in fitting if cited & {*law.items}]
        least = min((len(moved - {*law.variables}) for law in fitting), default=0)
        near = [law for law in fitting if len(moved - {*law.variables}) == least]
        smallest = [law for law in near if not any(o is law.base for o in near)] or near
        return (best or smallest or [None])[-1]

    def _closure(
        self, names: Iterable[str], law: Law | None, at: Item
    ) -> tuple[set[str], dict[str, Item]]:
        """All names that some names need, and the statements that define them."""
        moving = {*law.variables} if law else set()
        waiting = [*names]
        if law is not None:
            waiting += [name for row in law.rows for name in row.names]
        closure: set[str] = set()
        definitions: dict[str, Item] = {}
        while waiting:
            name = waiting.pop()
            if name in closure:
                continue
            closure.add(name)
            parts = self.known.names.vectors.get(name, ())
            if name in moving or {*parts} & moving:
                continue
            whole = self.known.names.whole(name)
            by = self.known.definition(name, at)
            if by is None and whole != name:
                closure.add(whole)
                name, by = whole, self.known.definition(whole, at)
            if by is not None:
                definitions[name] = by
                waiting += by.names
        return closure, definitions

    def _made(
        self,
        law: Law | None,
        closure: set[str],
        definitions: dict[str, Item],
        assumptions: Sequence[Item],
        items: Sequence[Item],
    ) -> Supposed:
        known = self.known
        vectors = {
            name: parts
            for name, parts in known.names.vectors.items()
            if name in closure or {*parts} & closure or (law and {*parts} & {*law.variables})
        }
        variables = law.variables if law else ()
        places: dict[str, Printed] = {}
        squares: list[Printed] = []
        for name, item in definitions.items():
            role = known.roles[item]
            if role.kind == "square" or name in item.printed.heads.squares:
                squares.append(item.printed)
                continue
            written = [h for h in item.printed.heads.names if head(h)[0] == name or h == name]
            places[written[0] if written else name] = item.printed
        taken = {head(name)[0] for name in places}
        taken |= {name for p in squares for name in p.heads.squares}
        for name in [*taken]:
            taken |= {*vectors.get(name, ())}
        bound = {argument for name in places for argument in head(name)[1]}
        scalars = known.names.scalars(sorted(closure))
        constants = tuple(
            name
            for name in scalars
            if name not in variables
            and name not in taken
            and name not in known.paper.words.matrices
            and name not in known.paper.words.times
            and name not in known.paper.words.functions - known.paper.words.scalars
            and not (name == "i" and self._has_unit(items, definitions, law))
            and not (name in bound and name not in variables)
        )
        title = law.title if law else "the constants"
        rows = tuple(row.printed for row in law.rows) if law else ()
        scene = Scene(title, vectors, variables, constants, rows, self._time(law, closure), definitions=places)
        for place in squares:
            scene = scene.adjoining(place)
        scene = self._with_unit(scene, closure)
        used = []
        for one in sorted(assumptions, key=lambda one: one.order):
            narrower = with_assumption(scene, one, known)
            if narrower is not scene:
                used.append(one)
            scene = narrower
        for formula in (f for i in (*items, *definitions.values()) if (f := i.formula) is not None):
            for root in _roots(formula):
                if root not in scene.roots and root not in scene.definitions:
                    scene = scene.adjoining(root)
        if used:
            scene = scene.called(f"{title} where {', '.join(o.printed.tex for o in used)}")
        return Supposed(scene, tuple(used), tuple(n for n in constants if n not in self._introduced()))

    def _has_unit(self, items: Sequence[Item], definitions: dict[str, Item], law: Law | None) -> bool:
        return "i" in self.known.paper.words.scalars and not self.known.moves("i")

    def _with_unit(self, scene: Scene, closure: set[str]) -> Scene:
        clocks = [item.printed for item in self.known.clocks]
        if "i" not in closure and not clocks:
            return scene
        units = [item.printed for item in self.known.units]
        return scene.with_unit(units[0] if units else UNIT[1], clocks[0] if clocks else None)

    def _time(self, law: Law | None, closure: set[str]) -> str:
        return "t"

    def _introduced(self) -> set[str]:
        """The names of constants that the law has, or that words introduce."""
        found = {name for law in self.known.laws for name in law.mentions}
        for item in self.known.paper.items:
            if isinstance(item.formula, Name):
                found.add(item.formula.name)
            if self.known.roles.get(item) and self.known.roles[item].name == "assumption":
                found |= item.names
        return found


def with_assumption(scene: Scene, item: Item, known: Known) -> Scene:
    """A scene with what is supposed of its constants; itself, if that says nothing of them."""
    role, place = known.roles[item], item.printed
    if role.kind == "inequality":
        signs = getattr(item.formula, "signs", ())
        if set(signs) <= {r"\ne", r"\neq"} and len(signs) == 1:
            left, right = item.formula.members  # type: ignore[union-attr]
            tex = to_latex(left) if to_latex(right) == "0" else f"{to_latex(left)}-({to_latex(right)})"
            return scene.having(nonzero=(tex,)) if item.names <= {*scene.names()} else scene
        return scene
    names = [name for name in item.bare if name in scene.constants]
    whole = [name for name in item.bare if name in scene.vectors and not known.moves(name)]
    bold = [name for name in item.bare if name in known.paper.words.matrices]
    if whole or bold:
        gone = {part for name in whole for part in scene.vectors[name]}
        kept = tuple(name for name in scene.constants if name not in gone)
        places = {name: place for name in (*whole, *bold)}
        return replace(scene, constants=kept, definitions={**scene.definitions, **places})
    others = {n for m in item.members if not (isinstance(m, Name) and m.name in names) for n in m.names()}
    names = [name for name in names if name not in others]
    if len(names) == len(item.members):
        names = names[:-1]
    if not names:
        return scene
    kept = tuple(name for name in scene.constants if name not in names)
    return replace(
        scene, constants=kept, definitions={**scene.definitions, **dict.fromkeys(names, place)}
    )


def _roots(formula: Formula | None) -> Iterable[str]:
    """The square roots that are printed in a formula."""
    for node in formula.nodes() if formula is not None else ():
        if isinstance(node, Root):
            yield to_latex(node)
        elif isinstance(node, Power) and half_power(node.exponent) is not None:
            yield to_latex(Root(node.base))
