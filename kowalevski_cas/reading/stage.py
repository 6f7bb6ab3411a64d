"""The smallest scene on which a statement of a paper can stand."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from functools import cached_property

from kowalevski_cas.notation import (
    Application,
    Formula,
    Modulus,
    Name,
    Negative,
    Number,
    PoissonBracket,
    Power,
    Product,
    Relation,
    Root,
    rank,
    read,
    to_latex,
)
from kowalevski_cas.notation.functions import FAMILY_OF, FUNCTIONS, SIGN
from kowalevski_cas.notation.open import OpenParser
from kowalevski_cas.notation.symbol import symbol
from kowalevski_cas.notation.vocabulary import VECTOR
from kowalevski_cas.paper.amplitudes import conjugate_name, with_conjugates
from kowalevski_cas.paper.claims.forms import minus
from kowalevski_cas.paper.exponents import half_power
from kowalevski_cas.paper.functions import without_extremes
from kowalevski_cas.paper.jets import Unknown
from kowalevski_cas.paper.logarithms import roots as real_roots
from kowalevski_cas.paper.names import BRACKET, DELTA, head, primitive, summation_indices
from kowalevski_cas.paper.relations import solve_for_constant
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.paper.signs import is_inequality
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.reading.forces import refuse_unsaid_forces
from kowalevski_cas.reading.free_functions import TIME, names_of, with_free_functions
from kowalevski_cas.reading.jets import derivatives_of
from kowalevski_cas.reading.kinematics import has_bracket, is_free, refuse_dynamics
from kowalevski_cas.reading.known import ASSUMPTION, DEFINITION, FUNCTION, Known
from kowalevski_cas.reading.law import Law
from kowalevski_cas.reading.other_numbers import other_number
from kowalevski_cas.reading.statements import SourceStatement, derived_names


@dataclass(frozen=True)
class Supposed:
    """A scene, the statements that it takes for granted, and the names it takes for constants."""

    scene: Scene
    assumptions: tuple[SourceStatement, ...]
    constants: tuple[str, ...]
    images: tuple[tuple[str, str], ...] = ()
    """The variables of a map with their images."""


@dataclass(frozen=True)
class _Closure:
    """All names that some statements need, the law that moves them, and what defines them."""

    law: Law | None
    names: frozenset[str]
    definitions: Mapping[str, SourceStatement]
    stated: frozenset[str]
    """The names that stand in the statements themselves: an argument may be one of them."""

    @property
    def variables(self) -> tuple[str, ...]:
        return self.law.variables if self.law else ()


@dataclass(eq=False)
class Stage:
    """The scenes of a paper, each made once."""

    known: Known
    scenes: dict[object, Supposed] = field(default_factory=dict)

    def scene(
        self,
        items: Sequence[SourceStatement],
        assumptions: Sequence[SourceStatement] = (),
        law: Law | None = None,
    ) -> Supposed:
        """The smallest scene of some statements, with what is supposed of its constants.

        The law is that of their names, if no other one is given.
        """
        clock = self._clock(items)
        closure = self._closure([*items, *([clock] if clock is not None else [])], law)
        law = closure.law
        if law is not None and (own := self._own_clock(law)) is not None:
            clock, closure = own, self._closure([*items, own], law)
        derived = any(one.derives for one in (*items, *closure.definitions.values()))
        if law is None and derived and TIME not in closure.names:
            raise ValueError("no equation says how what is derived moves")
        special = self.known.special(law) if law is not None and law.restates else []
        given = dict.fromkeys((*assumptions, *special))
        about = self._about(given, closure.names)
        closure = self._with_functions(self._with_definitions(closure, about), about)
        closure = self._without_idle(closure, items)
        roots = self._in_order(
            root
            for item in (*items, *about, *closure.definitions.values(), *(law.rows if law else ()))
            for root in self._roots(item.formula)
        )
        powers = tuple(
            dict.fromkeys(power for item in items for power in self._powers(item.formula))
        )
        defined = (*closure.definitions.items(),)
        key = (closure.law, closure.names, defined, (*about,), roots, powers, clock)
        if key not in self.scenes:
            self.scenes[key] = self._made(closure, about, roots, powers, clock)
        self._refuse_unknown(self.scenes[key].scene, [*items, *closure.definitions.values()], law)
        return self.scenes[key]

    def understood(self, assumptions: Iterable[SourceStatement]) -> list[SourceStatement]:
        """Those of some assumptions of which all names have a meaning."""
        return [one for one in assumptions if not self._is_lost(one)]

    def lost(self, item: SourceStatement) -> list[SourceStatement]:
        """What is supposed at a statement of its names, or theirs, and has no meaning.

        What fails without it may hold with it.
        """
        supposed = [one for one in self.known.supposed(item) if self._is_lost(one)]
        below = {inner for name in item.names for inner in self.known.below(name)}
        moving = {name for law in self.known.laws for name in law.mentions if item.derives}
        return [one for one in supposed if {*self.known.roles[one].names} & (below | moving)]

    def _is_lost(self, assumption: SourceStatement) -> bool:
        if any(one.trouble for one in self.known.items if one.typed is assumption.typed):
            return True  # its display cannot be read as a whole
        try:
            self._closure([assumption], None)
        except ValueError:
            return True
        return False

    def _about(
        self, assumptions: Iterable[SourceStatement], names: frozenset[str]
    ) -> list[SourceStatement]:
        """The assumptions about some names, and the inequalities that hang together with these."""
        of = {one: {*self.known.roles[one].names} for one in assumptions}
        for one in of:
            stands_for = (name for name in of[one] if self.known.is_defined(name))
            below = of[one] if self.known.roles[one].kind == "inequality" else stands_for
            of[one] |= {inner for name in [*below] for inner in self.known.below(name)}
        found, reached = dict[SourceStatement, None](), {*names}
        while new := [one for one in of if one not in found and of[one] & reached]:
            found |= dict.fromkeys(new)
            reached = {
                n for one in new if self.known.roles[one].kind == "inequality" for n in of[one]
            }
        return [*found]

    def _refuse_unknown(
        self, scene: Scene, items: Sequence[SourceStatement], law: Law | None
    ) -> None:
        """Take nothing for a constant that is derived, or moves by the law of another part."""
        rows = law.rows if law is not None else ()
        derived = {name for item in (*items, *rows) for name in derived_names(item)}
        if lost := derived & {*scene.constants}:
            raise ValueError(f"nothing says what {min(lost)} is, of which derivatives are printed")
        if matrix := {*scene.constants, *scene.variables} & self.known.unread_matrices:
            raise ValueError(f"{min(matrix)} is a matrix, of which no elements are printed")
        rated = self.known.names.scalars(name for item in items for name in item.rates)
        if still := {*rated} & {*scene.constants}:
            raise ValueError(f"no equation says how ${min(still)}$ moves")
        images = {name for row in rows if law and law.images for name in row.names}
        if law and (beside := shifted({*scene.constants} - images, law.variables)):
            raise ValueError(f"{beside} is one of those that move, and no equation says how")
        given = {name for one in self.known.assumptions for name in self.known.roles[one].names}
        mentioned = self.known.names.scalars(law.mentions) if law is not None else ()
        if moving := {*scene.constants} & self.known.elsewhere - given - {*mentioned}:
            raise ValueError(f"{min(moving)} moves by the equations of another part")

    # -- names -----------------------------------------------------------------------

    def _closure(self, items: Sequence[SourceStatement], law: Law | None) -> _Closure:
        """What some statements need, through the definitions before the last of them."""
        known = self.known
        at = max(items, key=lambda item: item.order)
        law = law or self.law(at, items)
        moving = {*law.variables} if law else set()
        waiting = [name for item in items for name in self._mentioned(item)]
        waiting += [name for row in (law.rows if law else ()) for name in self._mentioned(row)]
        names: set[str] = set()
        definitions: dict[str, SourceStatement] = {}
        while waiting:
            name = waiting.pop()
            if name in names:
                continue
            names.add(name)
            waiting += self._beside(name, moving)
            parts = {*known.names.vectors.get(name, ())}
            if name in moving or parts & moving:
                waiting += parts - moving
                continue
            if law and name in law.levels:
                continue
            by = law.given.get(name) if law else None
            by = by or known.definition(name, at)
            waiting += parts & known.definitions.keys() if by is None else ()
            if by is None and (whole := known.names.whole(name)) != name:
                waiting.append(whole)
            elif by is not None:
                definitions[name] = by
                waiting += self._mentioned(by)
            elif name in known.lost:
                raise ValueError(known.lost[name])
            elif name in known.unreadable:
                raise ValueError(f"{name} is defined by what cannot be read")
        stated = frozenset(name for item in items for name in item.names)
        return _Closure(law, frozenset(names), definitions, stated)

    def _beside(self, name: str, moving: Collection[str]) -> Iterator[str]:
        """What a value of a free function needs: the function, arguments, defined derivatives."""
        every = self.known.functions.get(name, [])
        for one in [one for one in every if {*one.by} <= {*moving, TIME}] or every:
            known = (other for other in names_of((one,)) if self.known.is_defined(other))
            yield from (one.name, *one.by, *known)

    def _with_definitions(
        self, closure: _Closure, assumptions: Sequence[SourceStatement]
    ) -> _Closure:
        """What some statements need, with what assumptions about their names stand for."""
        new = [
            one
            for one in assumptions
            if any(self.known.definition(name, one) for name in one.names - closure.names)
        ]
        if not new:
            return closure
        more = self._closure(new, closure.law)
        definitions = {**more.definitions, **closure.definitions}
        return _Closure(closure.law, closure.names | more.names, definitions, closure.stated)

    def _with_functions(self, closure: _Closure, about: Sequence[SourceStatement]) -> _Closure:
        """What some statements need where functions that may be any are supposed to be special."""
        special = [one for one in about if self.known.roles[one].kind.startswith(FUNCTION)]
        if not special:
            return closure
        more = self._closure(special, closure.law)
        given = {name: one for one in special for name in self.known.roles[one].names}
        for one in special:
            given |= derivatives_of(one, closure.names, self.known)
        definitions = {**more.definitions, **closure.definitions, **given}
        return _Closure(closure.law, closure.names | more.names, definitions, closure.stated)

    def _without_idle(self, closure: _Closure, items: Sequence[SourceStatement]) -> _Closure:
        r"""What some statements need, without what gives a constant by letters of its own.

        By the sine of one, as in :math:`\omega=\Omega\sin\lambda`, it may have any value.
        """
        rows = closure.law.rows if closure.law else ()
        statements = {*items, *rows, *closure.definitions.values()}
        supposed = {n for one in self.known.assumptions for n in self.known.roles[one].names}
        own: dict[str, frozenset[str]] = {}
        for name, by in closure.definitions.items():
            others = {n for one in statements - {by} for n in one.names}
            letters = by.names - {name}
            free = letters.isdisjoint(others | supposed | self.known.times)
            if free and not self.known.varying(by.names) and _is_by_sine(by, name):
                own[name] = letters
        if not own:
            return closure
        kept = {name: by for name, by in closure.definitions.items() if name not in own}
        names = closure.names.difference(*own.values())
        return _Closure(closure.law, names, kept, closure.stated)

    def _mentioned(self, item: SourceStatement) -> list[str]:
        """The names that a statement needs, functions and brackets among them."""
        found = set(item.names)
        for node in item.formula.nodes() if item.formula is not None else ():
            if isinstance(node, Application):
                function, _ = primitive(node.function)
                own = function not in FAMILY_OF or function in self.known.definitions
                found |= {function} if own else set()
            elif isinstance(node, PoissonBracket):
                found |= self._brackets_at(item)
        return sorted(found)

    def _brackets_at(self, item: SourceStatement) -> set[str]:
        """The brackets that are given where a statement stands: not those of later sections."""
        given = {n: of for n, of in self.known.definitions.items() if n.startswith(BRACKET)}
        here = {
            name
            for name, of in given.items()
            if any(one.order <= item.order or one.section in item.sections for one in of)
        }
        return here or {*given}

    def law(self, at: SourceStatement, items: Sequence[SourceStatement]) -> Law | None:
        """The law of some statements: one that is cited, or the latest that moves their names."""
        known = self.known
        below = {n for item in items for name in self._mentioned(item) for n in known.below(name)}
        moved = {*known.names.scalars(below)}
        moved |= {x for law in known.laws for x, new in law.images if new in moved}
        moved = {name for name in moved if any(name in law.variables for law in known.laws)}
        before = [law for law in known.laws if law.first.typed.start <= at.typed.start]
        before = before or known.laws
        fitting = [law for law in before if moved & {*law.variables}]
        said = {law: other_number(law.first, known) for law in fitting}
        if fitting and all(said.values()):
            raise ValueError(f"the equations of motion are {said[fitting[-1]]}")
        fitting = [law for law in fitting if not said[law]]
        lacking = {law: len(moved - {*law.variables, *law.given}) for law in fitting}
        near = [law for law in fitting if lacking[law] == min(lacking.values())]
        smallest = [law for law in near if law.base not in near] or near
        cited = {*known.cited(at)}
        named = [law for law in smallest if cited & {*law.rows, *law.printed}]
        law = next(iter((named or smallest)[::-1]), None)
        if law is not None and law.base is not None and moved.isdisjoint(law.base.variables):
            law = law.own
        for name in known.names.scalars(name for item in items for name in item.rates):
            given = known.is_defined(name) or name in known.functions
            if given and (law is not None or "t" in known.below(name)):
                continue
            if law is None or name not in law.variables:
                raise ValueError(f"no equation says how ${name}$ moves")
        if law is None:
            timed = "t" in below or any("t" in item.names for item in items)
            if not timed and any(item.derives and not item.begins for item in items):
                raise ValueError("no equation says how what is derived moves")
            return None
        if is_free(law):
            if not any(has_bracket(one.formula) for one in items if one is not at):
                refuse_dynamics(law, at, known)  # of brackets it is so whatever moves
            return law
        refuse_unsaid_forces(law, at, known)
        return self._restated(law, at)

    def _restated(self, law: Law, at: SourceStatement) -> Law:
        """A law as it is printed anew before, where the assumptions for that are not in force."""
        known = self.known
        cited, supposed = {*known.cited(at)}, {*known.supposed(at)}
        for one in reversed(known.restated):
            new = {*one.items} - {*law.rows}
            if one.restates is law and cited & (law.printed - one.printed):
                return law  # a row is cited that was printed anew
            if one.restates is law and max(item.order for item in new) < at.order:
                special = {*known.special(one)}
                of = {name for other in special - supposed for name in known.roles[other].names}
                if any(of & {*known.roles[other].names} for other in supposed):
                    return law  # other values are supposed here
                if special and (not special <= supposed or new & cited):
                    return one
        return law

    # -- scenes ------------------------------------------------------------------------

    def _clock(self, items: Sequence[SourceStatement]) -> SourceStatement | None:
        """What gives the other time by which derivatives are printed: the last before them.

        Raises ``ValueError`` where dots derive by it, and the equations of motion have primes.
        """
        law = {mark for one in self.known.laws for row in one.rows for mark in row.marks}
        marks = frozenset().union(*(item.marks for item in items))
        told = self.known.clocks or _OF_DOTS.search(self.known.paper.prose.text)
        if told and law == {"prime"} and marks & {"dot", "t"}:
            raise ValueError("a dot derives by another time than the primes of the law: print both")
        marks -= {"dot", "t"}
        marks -= {"prime"} & law
        last = max(item.order for item in items)
        before = [one for one in self.known.clocks if one.order < last]
        fitting = [one for one in before if "prime" in marks or one.other_time in marks]
        return fitting[-1] if fitting else None

    def _own_clock(self, law: Law) -> SourceStatement | None:
        """What gives the time by which the equations of motion are printed, if it is another."""
        marks = {mark for row in law.rows for mark in row.marks}
        return next((one for one in self.known.clocks if marks == {one.other_time}), None)

    def _made(
        self,
        closure: _Closure,
        about: Sequence[SourceStatement],
        roots: Iterable[str],
        powers: tuple[tuple[str, str], ...],
        clock: SourceStatement | None,
    ) -> Supposed:
        places, squares = self._places(closure)
        names = self.known.names
        vectors = {
            name: parts
            for name, parts in names.vectors.items()
            if name in closure.names or {*parts} & {*closure.names, *closure.variables}
        }
        new = {name for one in about for name in one.names if not self.known.is_defined(name)}
        named = replace(closure, names=closure.names | {n for n in new if not self.known.varies(n)})
        constants = tuple(self._constants(named, places, squares, vectors))
        functions = [*self._functions(closure)]
        values = names_of(functions)
        constants = tuple(name for name in constants if name not in values)
        title = closure.law.title if closure.law else "the constants"
        law = closure.law
        rows = tuple(row.printed for row in law.rows) if law and not law.images else ()
        own = self._own_clock(law) if law is not None else None
        scene = Scene(
            title, vectors, closure.variables, constants, rows, definitions=places, powers=powers,
            matrices=tuple(name for name in places if name in self.known.paper.words.matrices),
            time=own.other_time if own is not None else TIME,
            primes=self.known.paper.primed_by_time,
        )  # fmt: skip
        scene = with_free_functions(scene, functions) if functions else scene
        squared = {name for place in squares for name in place.heads.squares}
        first = [root for root in roots if squared.isdisjoint(self._below(root))]
        if law and law.radius and roots:
            scene = scene.solving(to_latex(law.radius.members[0]), law.radius.printed)
        first = [root for root in first if root not in {*scene.definitions, *scene.roots}]
        scene = scene.adjoining(*first)
        scene = self._with_unit(scene.adjoining(*squares), closure, clock)
        used: list[SourceStatement] = []
        used += [one for one in about if self.known.roles[one].kind.startswith(FUNCTION)]
        for one in sorted(about, key=lambda one: one.order):
            if one in used:
                continue
            narrower = with_assumption(scene, one, self.known)
            used += [one] if narrower is not scene else []
            scene = narrower
        for root in roots:
            if root not in scene.roots and root not in scene.definitions:
                scene = scene.adjoining(root)
        if used:
            scene = scene.called(f"{title} where {', '.join(one.printed.tex for one in used)}")
        unsaid = tuple(name for name in constants if name not in self.introduced)
        return Supposed(scene, tuple(used), unsaid, law.images if law else ())

    def _functions(self, closure: _Closure) -> Iterator[Unknown]:
        """The functions of which values or derivatives are needed, and nothing defines the values.

        Where a letter is a function of several things, it is one of what moves there.
        """
        at = {*closure.variables, *closure.definitions, TIME}
        for name in sorted(closure.names):
            every = self.known.functions.get(name, [])
            own = [one for one in every if {*one.by} <= at] or every
            yield from (one for one in own if one.name == name and name not in closure.definitions)

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
        for name in places:
            arguments = head(name)[1]
            taken |= {*arguments, *summation_indices(arguments), DELTA} - closure.stated
        clocks = {name for item in self.known.clocks for name in (item.other_time, "d")}
        taken |= {*closure.variables, "t"} | words.matrices | clocks
        taken |= (words.functions | FUNCTIONS) - words.scalars
        taken |= {"i"} if self.known.units else set()
        for name in self.known.names.scalars(sorted(closure.names)):
            if name not in taken and not name.startswith(BRACKET):
                yield name

    def _with_unit(self, scene: Scene, closure: _Closure, clock: SourceStatement | None) -> Scene:
        moving, units = {*closure.variables}, self.known.units
        unit = units[0].printed if units and "i" in closure.names else scene.unit
        scene = replace(scene, unit=unit, clock=clock.printed if clock else None)
        if unit is None or moving.isdisjoint(map(conjugate_name, moving)):
            return scene
        items = [*(closure.law.rows if closure.law else ()), *closure.definitions.values()]
        return with_conjugates(scene, [one.formula for one in items if one.formula is not None])

    @cached_property
    def introduced(self) -> frozenset[str]:
        """The names of constants that the laws have, or that words introduce or suppose."""
        names = (name for law in self.known.laws for name in law.mentions)
        found = {*self.known.names.scalars(names)}
        for item in self.known.paper.items:
            role = self.known.roles[item].name
            fixed = role == DEFINITION and not self.known.varying(item.names)
            if isinstance(item.formula, Name) or role == ASSUMPTION or fixed:
                found |= item.names
        return frozenset(found)

    def _powers(self, formula: Formula | None) -> Iterator[tuple[str, str]]:
        """The names with the constants that stand in their exponents."""
        for node in formula.nodes() if formula is not None else ():
            if isinstance(node, Power) and isinstance(node.base, Name):
                fixed = (name for name in node.exponent.names() if not self.known.varies(name))
                yield from ((node.base.name, name) for name in fixed)

    def _roots(self, formula: Formula | None) -> Iterator[str]:
        """The square roots that are printed in a formula, or that lengths of vectors are.

        Where logarithms and arcs are real, others are.
        """
        yield from map(to_latex, real_roots(formula) if formula is not None else ())
        for node in without_extremes(formula).nodes() if formula is not None else ():
            match node:
                case Root():
                    yield to_latex(node)
                case Power(base, exponent) if half_power(exponent) is not None:
                    yield to_latex(Root(base))
                case Modulus(argument) if self._is_real(argument):
                    yield to_latex(Root(Power(argument, Number(2))))
                case Application(function, (argument,)) if function == SIGN:
                    yield to_latex(Root(Power(argument, Number(2))))

    def _in_order(self, roots: Iterable[str]) -> tuple[str, ...]:
        """The roots, each behind those in the names of which its own names are given."""
        below = {root: self._below(root) for root in roots}
        return tuple(
            sorted(below, key=lambda root: sum(one < below[root] for one in below.values()))
        )

    def _below(self, root: str) -> set[str]:
        """The names in a root, and all that they stand for: squares may, that come first then."""
        names = read(root, self.known.paper.words, OpenParser).names()
        return {inner for name in names for inner in self.known.below(name)}

    def _is_real(self, formula: Formula) -> bool:
        """Whether an absolute value is a root of a square: of a vector, or where all is real."""
        return rank(formula, self.known.paper.words) == VECTOR or not self.known.units


def _is_by_sine(item: SourceStatement, name: str) -> bool:
    """Whether a name is given by a product of letters, and sines or cosines of others."""
    match item.members:
        case (Name(given), Product(factors)) if given == name:
            functions = [one for one in factors if isinstance(one, Application)]
            plain = all(isinstance(one, Name) or one in functions for one in factors)
            sines = all(one.function in (r"\sin", r"\cos") for one in functions)
            return plain and sines and bool(functions) and len(item.names) == len(factors) + 1
    return False


def shifted(names: Collection[str], moving: Iterable[str]) -> str:
    r"""A name that is what moves with another index: :math:`c_{k+1}` beside :math:`c_k`.

    >>> shifted({"c_{k+1}", "a"}, ("c_k",))
    'c_{k+1}'
    """
    own = {(symbol(x).head, symbol(x).index) for x in moving if symbol(x).index.isalpha()}
    found = (name for name in sorted(names) for head, index in own if _is_beside(name, head, index))
    return next(found, "")


def _is_beside(name: str, head: str, index: str) -> bool:
    """Whether a name has a letter, and an index with something added to another one."""
    parts = symbol(name)
    return parts.head == head and bool(re.fullmatch(rf"{index}[+-]\w+", parts.index))


_OF_DOTS = re.compile(
    r"\b(?:over)?dots?\b[^.;]{0,40}?\b(?:derivatives?|differentiat\w+)\b|\bточк\w+\b[^.;]{0,40}?(?:производн|дифференц)\w+",
    re.IGNORECASE,
)
"""Words that say by what dots derive."""


def with_assumption(scene: Scene, item: SourceStatement, known: Known) -> Scene:
    """A scene with what is supposed of its constants; itself, if that says nothing of them."""
    match item.formula:
        case Relation((left, right), (r"\ne" | r"\neq",)):
            named = item.names <= {*scene.names()}
            return scene.having(nonzero=(to_latex(minus((left, right))),)) if named else scene
    if item.formula is not None and is_inequality(item.formula):
        new = tuple(sorted(item.names - {*scene.names()}))
        if known.varying(new):
            return scene
        return scene.having(constants=new).assuming(item.printed)
    if not item.members:
        return scene
    place = item.printed
    vectors = [one for one in item.bare if one in scene.vectors and not known.moves(one)]
    matrices = [one for one in item.bare if one in known.paper.words.matrices]
    parts = {part for name in vectors for part in scene.vectors[name]}
    names = [name for name in item.bare if name in scene.constants]
    rest = (m for m in item.members if not (isinstance(m, Name) and m.name in names))
    others = {name for member in rest for name in member.names()}
    # what is its own opposite is zero, as in a_{11}=-a_{11}
    zero = [name for name in names if {*item.members} == {Name(name), Negative(Name(name))}]
    names = zero or [name for name in names if name not in others]
    names = names[:-1] if len(names) == len(item.members) else names
    given = dict.fromkeys((*vectors, *matrices, *names), place)
    if not given:
        return _with_relation(scene, item, known)
    kept = tuple(name for name in scene.constants if name not in {*names, *parts})
    return replace(scene, constants=kept, definitions={**scene.definitions, **given})


def _with_relation(scene: Scene, item: SourceStatement, known: Known) -> Scene:
    r"""A scene with an equation of its constants, solved for one of them; itself, if it is none.

    What is defined by constants may stand in it, as in :math:`\mu=3` behind :math:`\mu=M/m`.
    """
    undefined = known.names.scalars(item.names - scene.definitions.keys())
    if len(item.members) != 2 or not {*undefined} <= {*scene.constants, *scene.definitions}:
        return scene
    display = item.printed.display
    with suppress(ValueError):
        solved, below = solve_for_constant(item.printed.tex, scene)
        if solved:
            (place,) = replace(display, id=f"{display.id}-solved-{item.printed.number}", tex=solved)
            left = solved.partition("=")[0]
            name = left.removesuffix("^2")
            kept = tuple(constant for constant in scene.constants if constant != name)
            rest = replace(scene.having(nonzero=below), constants=kept)
            return rest.naming(name, place) if name == left else rest.adjoining(place)
    return scene
