"""Scenes: the smallest setting on which a claim can stand, and changes between them.

A scene only says what there is, in the words of the paper; an elaboration gives it meaning
(:mod:`kowalevski_cas.paper.elaborate`). Scenes derive from each other by a few verbs, each of
which gives a new scene: ``kowalevski.defining(eq9).with_unit(unit[1])``.
"""

from __future__ import annotations

from collections.abc import Container, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from dataclasses import field as default
from functools import cached_property

from kowalevski_cas.notation.symbol import rate_name
from kowalevski_cas.paper.names import (
    BRACKET,
    DELTA,
    EPSILON,
    check_names,
    head,
    is_bold,
    is_indexed,
)
from kowalevski_cas.paper.texts import Display, Printed, check_attributes, statements


@dataclass(frozen=True, eq=False)
class Change:
    r"""A change of variables from the scene ``source``, by printed formulas.

    ``formulas`` gives new variables through old ones (equation 9 of the paper);
    variables with the same name in both scenes are kept. ``time`` is the
    printed relation between the independent variables, as :math:`\tau=it`. The
    vector field is carried over by the chain rule.
    """

    source: Scene
    formulas: tuple[Printed, ...]
    time: Printed

    def __post_init__(self) -> None:
        """Refuse displays where statements are expected."""
        check_attributes(self, "a change of variables")


@dataclass(frozen=True, eq=False)
class Locus:
    """A place where a denominator vanishes or the fields degenerate, by equations."""

    words: str
    equations: tuple[str, ...]
    condition: str
    """The expression that is non-zero away from the locus."""

    def __post_init__(self) -> None:
        """Refuse an equation where a tuple of them is expected."""
        check_attributes(self, f"the locus “{self.words}”")


@dataclass(frozen=True, eq=False)
class Scene:
    r"""Variables, constants, relations among them, a conjugation and a vector field.

    ``vectors``
        names of vectors with the names of their components.
    ``variables``, ``constants``
        what moves and what does not.
    ``field``
        printed equations with a derivative on the left, or a :class:`Change`.
    ``time``
        the independent variable, ``"t"`` or ``"\tau"``.
    ``primes``
        whether primes derive by the time, as dots do.
    ``clock``
        the printed relation of another independent variable to ``time``.
    ``unit``
        the printed relation that the imaginary unit obeys; the letter is ``i``.
    ``definitions``
        names that stand for an expression, with the place that prints it; a function
        comes with its arguments, as ``\varphi(s)``, and the Poisson bracket with a pair of
        variables, or of coordinates and their indices, as ``\{M_i,\alpha_j\}``, summed over k.
    ``roots``
        square roots, as generators: either printed as a root of an expression,
        ``\sqrt{x_1x_2}``, or a name with the place that prints its square. A printed
        root with a place is no generator: its value is printed there.
    ``powers``
        pairs of a name and a symbolic exponent, as ``(\theta, m)``.
    ``undefined``
        names that the paper prints and defines nowhere: they may be anything.
    ``zero``
        printed equations that set variables to zero.
    ``conjugates``
        pairs of variables that are each other's conjugates; the rest are real.
    ``nonzero``
        what the scene takes for granted not to vanish. ``x+r`` with a root ``r`` says nothing
        of ``x-r``, and only the norm of both excludes a denominator with one of them.
    ``signs``
        printed inequalities that are supposed, as :math:`0<k<1`. What is not negative has a real
        square root, which is a root of the scene.
    ``values``
        printed equations that give all generators of a family at a constant, as those of Jacobi
        at the quarter period.
    ``loci``
        the places at which every statement about sets is tried once more.
    ``matrices``
        defined names in plain type that stand for matrices, though no rows are printed of them.
    ``jets``
        variables that are values of functions which nothing gives, as ``V`` and ``V'``: each with
        its derivative, and the variable, or the time, by which it is derived.
    """

    name: str = ""
    vectors: Mapping[str, tuple[str, ...]] = default(default_factory=dict)
    variables: tuple[str, ...] = ()
    constants: tuple[str, ...] = ()
    field: tuple[Printed, ...] | Change = ()
    time: str = "t"
    clock: Printed | None = None
    unit: Printed | None = None
    definitions: Mapping[str, Printed] = default(default_factory=dict)
    roots: Mapping[str, Printed | None] = default(default_factory=dict)
    powers: tuple[tuple[str, str], ...] = ()
    undefined: tuple[str, ...] = ()
    zero: tuple[Printed, ...] = ()
    conjugates: tuple[tuple[str, str], ...] = ()
    nonzero: tuple[str, ...] = ()
    signs: tuple[Printed, ...] = ()
    values: tuple[Printed, ...] = ()
    loci: tuple[Locus, ...] = ()
    jets: tuple[tuple[str, str, str], ...] = ()
    matrices: tuple[str, ...] = ()
    primes: bool = False

    def __post_init__(self) -> None:
        """Refuse names that are given twice; raises ``ValueError`` or ``TypeError``."""
        owner = f"the scene “{self.name}”"
        check_attributes(self, owner)
        check_names(owner, self._meanings())
        if "i" in self.roots:
            raise ValueError(f"{owner}: i is the imaginary unit, and no other root: rename it")

    def _meanings(self) -> Iterator[tuple[str, str]]:
        """Every name with what the scene says that it is."""
        yield from (("a variable", name) for name in self.variables)
        yield from (("a constant", name) for name in (*self.constants, *self.undefined))
        if self.unit is not None:
            yield "the imaginary unit", "i"
        yield from (("a root", name) for name in self.roots)
        yield from (("a power", f"{base}^{exponent}") for base, exponent in self.powers)
        for name in self.definitions:
            function, arguments = head(name)
            if function != BRACKET and not is_bold(name) and name not in self.vectors:
                yield "a function" if arguments else "defined", function
        for components in self.vectors.values():
            yield from (("a component", name) for name in components)

    # -- verbs -------------------------------------------------------------------

    def called(self, name: str) -> Scene:
        """The scene under a name of its own."""
        return replace(self, name=name)

    def having(
        self,
        *,
        vectors: Mapping[str, tuple[str, ...]] | None = None,
        variables: tuple[str, ...] = (),
        constants: tuple[str, ...] = (),
        powers: tuple[tuple[str, str], ...] = (),
        undefined: tuple[str, ...] = (),
        conjugates: tuple[tuple[str, str], ...] = (),
        nonzero: tuple[str, ...] = (),
        loci: tuple[Locus, ...] = (),
    ) -> Scene:
        """The scene with more of all these, which is itself if there are none.

        Raises ``ValueError`` for names that it has, and ``TypeError`` for what is no tuple.
        """
        more = (variables, constants, powers, undefined, conjugates, nonzero, loci)
        if wrong := [one for one in more if not isinstance(one, tuple)]:
            raise TypeError(f"a tuple is expected, and not {wrong[0]!r}: add a comma")
        if not vectors and not any(more):
            return self
        for name in (*variables, *constants, *undefined):
            self._is_new(name, self.variables, self.constants, self.definitions, self.undefined)
        return replace(
            self,
            vectors={**self.vectors, **(vectors or {})},
            variables=(*self.variables, *variables),
            constants=(*self.constants, *constants),
            powers=(*self.powers, *powers),
            undefined=(*self.undefined, *undefined),
            conjugates=(*self.conjugates, *conjugates),
            nonzero=(*self.nonzero, *nonzero),
            loci=(*self.loci, *loci),
        )

    def moving(self, *by: Display | Printed) -> Scene:
        """The scene with these equations of motion, and no others."""
        return replace(self, field=tuple(statements(*by)))

    def with_unit(self, unit: Printed, clock: Printed | None = None) -> Scene:
        """The scene with the imaginary unit, and perhaps with another independent variable."""
        return replace(self, unit=unit, clock=clock)

    def defining(self, *by: Display | Printed) -> Scene:
        """The scene where printed statements define all names that are new in them.

        These are the bare names, heads of functions and brackets among their members that are
        no variables, constants or roots, or else what stands in a whole multiple, as T in
        :math:`2T=v^2`. Raises ``ValueError`` if a name is defined already, or if
        a statement defines none.
        """
        return self._defining(by, again=False)

    def redefining(self, *by: Display | Printed) -> Scene:
        """The scene where printed statements define names in place of what did so before."""
        return self._defining(by, again=True)

    def naming(self, name: str, by: Printed) -> Scene:
        """The scene with a name for what is printed; raises ``ValueError`` if it has it."""
        self._is_new(name, self.definitions, self.variables, self.constants)
        return replace(self, definitions={**self.definitions, name: by})

    def adjoining(self, *roots: str | Display | Printed) -> Scene:
        r"""The scene with square roots: printed ones, as ``\sqrt{x_1x_2}``, and printed squares.

        A printed statement gives the root whose square is one of its members, as a in
        :math:`(\alpha,\alpha)=a^2`. Raises ``ValueError`` if there is none, or if it is known.
        """
        scene = self
        for root in roots:
            if isinstance(root, str):
                scene = scene.solving(root, None)
                continue
            for place in statements(root):
                if len(place.heads.squares) != 1:
                    raise ValueError(f"{place.place} does not give the square of one name")
                scene = scene.solving(place.heads.squares[0], place)
        return scene

    def solving(self, root: str, by: Printed | None) -> Scene:
        """The scene with a square root, by an equation in which its square stands somewhere.

        A root that is printed as such needs none. Raises ``ValueError`` if it is known.
        """
        self._is_new(root, self.roots, self.definitions)
        return replace(self, roots={**self.roots, root: by})

    def fixing(self, levels: Sequence[Printed]) -> Scene:
        """The scene in which the names that these statements give are constants."""
        given = [*self.definitions.items(), *self.roots.items()]
        names = tuple(name for name, place in given if place in levels)
        kept = {name: by for name, by in self.definitions.items() if name not in names}
        roots = {name: by for name, by in self.roots.items() if name not in names}
        return replace(self, definitions=kept, roots=roots, constants=(*self.constants, *names))

    def assuming(self, *by: Display | Printed) -> Scene:
        r"""The scene where printed inequalities are supposed, as :math:`I_1\le I_2<I_3`."""
        return replace(self, signs=(*self.signs, *statements(*by)))

    def taking(self, *by: Display | Printed) -> Scene:
        """The scene where printed statements give the values of functions at constants."""
        return replace(self, values=(*self.values, *statements(*by)))

    def restricted(self, *by: Display | Printed) -> Scene:
        """The scene where printed equations set variables to zero."""
        zero = tuple(statements(*by))
        names = {name for place in zero for name in place.heads.names}
        names.update(part for name in names & {*self.vectors} for part in self.vectors[name])
        kept = tuple(name for name in self.variables if name not in names)
        return replace(self, variables=kept, zero=(*self.zero, *zero))

    def solved(self, *by: Display | Printed) -> Scene:
        """The scene where printed statements give some of its variables by the others.

        All other names may be any complex numbers there: nothing is conjugated. Raises
        ``ValueError`` for a statement that does not give one variable.
        """
        definitions = dict(self.definitions)
        for place in statements(*by):
            found = [name for name in place.heads.names if name in self.variables]
            if len(found) != 1 or found[0] in definitions:
                raise ValueError(f"{place.place} does not give one variable of “{self.name}”")
            definitions[found[0]] = place
        return replace(
            self,
            variables=tuple(name for name in self.variables if name not in definitions),
            definitions=definitions,
            conjugates=(),
        )

    def changed(self, by: Display, time: Printed, keeping: tuple[str, ...] = ()) -> Scene:
        """The scene in the variables that a display gives, with those that are kept.

        Args:
            by: the change of variables, a statement each.
            time: the relation of the new independent variable to the old one.
            keeping: old variables that are variables again.
        """
        formulas, (clock,) = tuple(statements(by)), statements(time)
        return Scene(
            self.name,
            variables=(*(name for place in formulas for name in place.heads.names), *keeping),
            field=Change(self, formulas, clock),
            time=clock.heads.names[0],
        )

    def _defining(self, by: tuple[Display | Printed, ...], again: bool) -> Scene:
        known = {*self.variables, *self.constants, *self.roots}
        known |= {name for name, parts in self.vectors.items() if {*parts} <= known}
        definitions = dict(self.definitions)
        for place in statements(*by):
            heads = place.heads
            names = [name for name in heads.names if name not in known]
            names = names or [name for name in heads.multiples if name not in known]
            if not names:
                raise ValueError(f"{place.tex} defines no new name on the scene “{self.name}”")
            for name in names:
                if not again:
                    self._is_new(name, definitions)
                definitions[name] = place
        return replace(self, definitions=definitions)

    def _is_new(self, name: str, *known: Container[str]) -> None:
        if any(name in names for names in known):
            raise ValueError(f"{name} has a meaning already on the scene “{self.name}”")

    # -- what there is ------------------------------------------------------------

    @cached_property
    def places(self) -> dict[Printed, None]:
        """Every place of the paper on which the scene rests, once."""
        before = self.field.source.places if isinstance(self.field, Change) else {}
        return dict.fromkeys(place for _, place in self.roles()) | before

    def roles(self) -> Iterator[tuple[str, Printed]]:
        """Its own places, without those of a scene from which it is changed; what each is for."""
        change = self.field if isinstance(self.field, Change) else None
        by = (*change.formulas, change.time) if change else ()
        found = {
            "unit": (self.unit,),
            "definition": (self.clock, *self.definitions.values(), *by),
            "condition": (*self.roots.values(), *self.zero, *self.signs, *self.values),
            "vector field": () if isinstance(self.field, Change) else self.field,
        }
        yield from ((role, place) for role, places in found.items() for place in places if place)

    def names(self) -> Iterator[str]:
        """Every scalar name that has a meaning on the scene."""
        yield from self.variables
        yield from self.constants
        yield from self.undefined
        for name in self.definitions:
            function, arguments = head(name)
            if function == BRACKET:
                indexed = [argument for argument in arguments if is_indexed(argument)]
                yield from [EPSILON, DELTA] if indexed else []
                yield from (f"{argument[:-1]}{k}" for argument in indexed for k in "ijk")
            elif is_bold(name) or name in self.vectors or self.is_matrix(name):
                yield from self.vectors.get(name, ())
            else:
                yield from (a for a in arguments if a[:4] != r"\dot" and a not in self.vectors)
                if self.of_variables(name):
                    yield function
        yield from (name for name in self.roots if not name.startswith(r"\sqrt"))
        if self.unit is not None:
            yield "i"

    def is_matrix(self, name: str) -> bool:
        """Whether a defined name in plain type stands for a matrix."""
        return name in self.matrices or self.definitions[name].heads.matrix

    def of_variables(self, name: str) -> bool:
        r"""Whether a head is a bare name, or has variables for all arguments, as :math:`H(q,p)`.

        Then the name stands for the value at these; velocities and the time may be among them.
        """
        moving = (*self.variables, *self.vectors)
        arguments = head(name)[1]
        return not arguments or {*moving, *map(rate_name, moving), self.time}.issuperset(arguments)

    def branches(self) -> Iterator[Printed]:
        """The places that print a value for a root: they choose one of two values."""
        for name, place in self.roots.items():
            if place is not None and name.startswith(r"\sqrt"):
                yield place

    def component(self, name: str) -> tuple[str, int] | None:
        """The vector with a definition of which a name is a component, and which one."""
        for vector, components in self.vectors.items():
            if vector in self.definitions and name in components:
                return vector, components.index(name)
        return None
