"""The smallest scene on which a statement of a paper can stand."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

from kowalevski_cas.notation import (
    Application,
    Formula,
    Modulus,
    Name,
    Number,
    PoissonBracket,
    Power,
    Relation,
    Root,
    rank,
    to_latex,
)
from kowalevski_cas.notation.vocabulary import VECTOR
from kowalevski_cas.paper.claims.forms import minus
from kowalevski_cas.paper.names import BRACKET, head
from kowalevski_cas.paper.plain import half_power
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.paper.texts import Display, Printed
from kowalevski_cas.reading.known import ASSUMPTION, Known
from kowalevski_cas.reading.laws import Law
from kowalevski_cas.reading.statements import Item

UNIT = Display("unit", "i^2=-1", "", source="the usual convention")
"""The imaginary unit of papers that print none."""


@dataclass(frozen=True)
class Supposed:
    """A scene, the statements that it takes for granted, and the names it takes for constants."""

    scene: Scene
    assumptions: tuple[Item, ...]
    constants: tuple[str, ...]


@dataclass(frozen=True)
class _Closure:
    """All names that some statements need, the law that moves them, and what defines them."""

    law: Law | None
    names: frozenset[str]
    definitions: Mapping[str, Item]

    @property
    def variables(self) -> tuple[str, ...]:
        return self.law.variables if self.law else ()


@dataclass(eq=False)
class Stage:
    """The scenes of a paper, each made once."""

    known: Known
    scenes: dict[object, Supposed] = field(default_factory=dict)

    def scene(self, items: Sequence[Item], assumptions: Sequence[Item] = ()) -> Supposed:
        """The smallest scene of some statements, with what is supposed of its constants."""
        closure = self._closure(items)
        about = [one for one in assumptions if {*self.known.roles[one].names} & closure.names]
        roots = tuple(
            dict.fromkeys(
                root
                for item in (*items, *closure.definitions.values())
                for root in self._roots(item.formula)
            )
        )
        key = (closure.law, closure.names, (*closure.definitions.items(),), (*about,), roots)
        if key not in self.scenes:
            self.scenes[key] = self._made(closure, about, roots)
        return self.scenes[key]

    # -- names -----------------------------------------------------------------------

    def _closure(self, items: Sequence[Item]) -> _Closure:
        """What some statements need, through the definitions before the last of them."""
        known = self.known
        at = max(items, key=lambda item: item.order)
        law = self.law(at, items)
        moving = {*law.variables} if law else set()
        waiting = [name for item in items for name in self._mentioned(item)]
        waiting += [name for row in (law.rows if law else ()) for name in self._mentioned(row)]
        names: set[str] = set()
        definitions: dict[str, Item] = {}
        while waiting:
            name = waiting.pop()
            if name in names:
                continue
            names.add(name)
            if name in moving or {*known.names.vectors.get(name, ())} & moving:
                continue
            by = known.definition(name, at)
            if by is None and (whole := known.names.whole(name)) != name:
                waiting.append(whole)
            elif by is not None:
                definitions[name] = by
                waiting += self._mentioned(by)
        return _Closure(law, frozenset(names), definitions)

    def _mentioned(self, item: Item) -> set[str]:
        """The names that a statement needs, functions and brackets among them."""
        found = set(item.names)
        for node in item.formula.nodes() if item.formula is not None else ():
            if isinstance(node, Application):
                found.add(node.function)
            elif isinstance(node, PoissonBracket):
                found |= {name for name in self.known.definitions if name.startswith(BRACKET)}
        return found

    def law(self, at: Item, items: Sequence[Item]) -> Law | None:
        """The law of some statements: one that is cited, or the latest that moves their names."""
        known = self.known
        below = {n for item in items for name in self._mentioned(item) for n in known.below(name)}
        moved = {*known.names.scalars(below)}
        moved = {name for name in moved if any(name in law.variables for law in known.laws)}
        before = [law for law in known.laws if law.first.order <= at.order] or known.laws
        fitting = [law for law in before if moved & {*law.variables}]
        least = min((len(moved - {*law.variables}) for law in fitting), default=0)
        near = [law for law in fitting if len(moved - {*law.variables}) == least]
        smallest = [law for law in near if law.base not in near] or near
        cited = {*known.cited(at)}
        named = [law for law in smallest if cited & {*law.rows}]
        return next(iter((named or smallest)[::-1]), None)

    # -- scenes ------------------------------------------------------------------------

    def _made(self, closure: _Closure, about: Sequence[Item], roots: Iterable[str]) -> Supposed:
        places, squares = self._places(closure)
        names = self.known.names
        vectors = {
            name: parts
            for name, parts in names.vectors.items()
            if name in closure.names or {*parts} & {*closure.names, *closure.variables}
        }
        constants = tuple(self._constants(closure, places, squares, vectors))
        title = closure.law.title if closure.law else "the constants"
        rows = tuple(row.printed for row in closure.law.rows) if closure.law else ()
        scene = Scene(title, vectors, closure.variables, constants, rows, definitions=places)
        scene = self._with_unit(scene.adjoining(*squares), closure.names)
        used: list[Item] = []
        for one in sorted(about, key=lambda one: one.order):
            narrower = with_assumption(scene, one, self.known)
            used += [one] if narrower is not scene else []
            scene = narrower
        for root in roots:
            if root not in scene.roots and root not in scene.definitions:
                scene = scene.adjoining(root)
        if used:
            scene = scene.called(f"{title} where {', '.join(one.printed.tex for one in used)}")
        unsaid = tuple(name for name in constants if name not in self.introduced)
        return Supposed(scene, tuple(used), unsaid)

    def _places(self, closure: _Closure) -> tuple[dict[str, Printed], list[Printed]]:
        """The definitions by their heads, and the statements that give squares."""
        places: dict[str, Printed] = {}
        squares: dict[Printed, None] = {}
        for name, item in closure.definitions.items():
            heads = item.printed.heads
            if name in heads.squares and name not in heads.names:
                squares[item.printed] = None
                continue
            own = next((one for one in heads.names if name in (one, head(one)[0])), name)
            places[own] = item.printed
        return places, [*squares]

    def _constants(
        self,
        closure: _Closure,
        places: Mapping[str, Printed],
        squares: Sequence[Printed],
        vectors: Mapping[str, tuple[str, ...]],
    ) -> Iterator[str]:
        """The names that nothing moves or defines."""
        words = self.known.paper.words
        taken = {head(name)[0] for name in places} | {n for p in squares for n in p.heads.squares}
        taken |= {part for name in taken for part in vectors.get(name, ())}
        taken |= {argument for name in places for argument in head(name)[1]}
        taken |= {*closure.variables} | words.matrices | words.times
        taken |= words.functions - words.scalars
        taken |= set() if self.known.moves("i") else {"i"}
        for name in self.known.names.scalars(sorted(closure.names)):
            if name not in taken and not name.startswith(BRACKET):
                yield name

    def _with_unit(self, scene: Scene, names: frozenset[str]) -> Scene:
        clocks = [item.printed for item in self.known.clocks]
        if self.known.moves("i") or ("i" not in names and not clocks):
            return scene
        units = [item.printed for item in self.known.units]
        return scene.with_unit((units or [UNIT[1]])[0], clocks[0] if clocks else None)

    @cached_property
    def introduced(self) -> frozenset[str]:
        """The names of constants that the laws have, or that words introduce or suppose."""
        found = {name for law in self.known.laws for name in law.mentions}
        for item in self.known.paper.items:
            supposed = item in self.known.roles and self.known.roles[item].name == ASSUMPTION
            if isinstance(item.formula, Name) or supposed:
                found |= item.names
        return frozenset(found)

    def _roots(self, formula: Formula | None) -> Iterator[str]:
        """The square roots that are printed in a formula, or that lengths of vectors are."""
        for node in formula.nodes() if formula is not None else ():
            match node:
                case Root():
                    yield to_latex(node)
                case Power(base, exponent) if half_power(exponent) is not None:
                    yield to_latex(Root(base))
                case Modulus(argument) if rank(argument, self.known.paper.words) == VECTOR:
                    yield to_latex(Root(Power(argument, Number(2))))


def with_assumption(scene: Scene, item: Item, known: Known) -> Scene:
    """A scene with what is supposed of its constants; itself, if that says nothing of them."""
    match item.formula:
        case Relation((left, right), (r"\ne" | r"\neq",)):
            named = item.names <= {*scene.names()}
            return scene.having(nonzero=(to_latex(minus((left, right))),)) if named else scene
    if not item.members:
        return scene
    place = item.printed
    vectors = [one for one in item.bare if one in scene.vectors and not known.moves(one)]
    matrices = [one for one in item.bare if one in known.paper.words.matrices]
    parts = {part for name in vectors for part in scene.vectors[name]}
    names = [name for name in item.bare if name in scene.constants]
    rest = (m for m in item.members if not (isinstance(m, Name) and m.name in names))
    others = {name for member in rest for name in member.names()}
    names = [name for name in names if name not in others]
    names = names[:-1] if len(names) == len(item.members) else names
    given = dict.fromkeys((*vectors, *matrices, *names), place)
    if not given:
        return scene
    kept = tuple(name for name in scene.constants if name not in {*names, *parts})
    return replace(scene, constants=kept, definitions={**scene.definitions, **given})
