"""Elaboration: what a scene says under given texts, as a setting in plain formulas.

Every name gets its meaning when it is first asked for, once. What a paper prints beyond the
operations of a space is written out: real and imaginary parts, derivatives by another time,
applied functions, powers with symbols, Poisson brackets. What has to be solved for (the square
of a root in a printed equation, the inverse of a change) is found with FLINT; whoever evaluates
the setting checks it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from functools import cached_property
from itertools import pairwise, takewhile

from kowalevski_cas.algebra import load
from kowalevski_cas.algebra.polynomials import Polynomial
from kowalevski_cas.algebra.present import formula_in
from kowalevski_cas.algebra.tower import Element, Parts, Ring
from kowalevski_cas.notation import (
    Formula,
    Name,
    Negative,
    NotationError,
    Number,
    Relation,
    to_latex,
)
from kowalevski_cas.paper.definitions import Definitions, zero_names
from kowalevski_cas.paper.denominators import Divisors
from kowalevski_cas.paper.generators import functions_of
from kowalevski_cas.paper.inlined import InlinedDefinitions
from kowalevski_cas.paper.meaning import Meaning
from kowalevski_cas.paper.motion import LawOfMotion
from kowalevski_cas.paper.numbers import number_of
from kowalevski_cas.paper.partials import Partials
from kowalevski_cas.paper.plain import Plain
from kowalevski_cas.paper.radicals import Radicals
from kowalevski_cas.paper.rates import orders, velocities
from kowalevski_cas.paper.roots import root_of_number
from kowalevski_cas.paper.scene import Change as ChangeOfScene
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.paper.signs import root_of
from kowalevski_cas.paper.suppositions import Suppositions
from kowalevski_cas.paper.texts import Printed, Texts
from kowalevski_cas.paper.transcendental import Transcendental
from kowalevski_cas.paper.validation import validate
from kowalevski_cas.problem import finder
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.prune import Reach
from kowalevski_cas.problem.space import (
    Adjoined,
    ChangeOfVariables,
    Equation,
    EquationOfMotion,
    Let,
    Meaningless,
    Raised,
    Setting,
    Step,
    generators,
)


class Elaboration(Meaning):
    """The setting that a scene means.

    ``of`` gives the elaboration of another scene under the same texts. ``places`` tells, for
    each name that has been given its meaning, the places of the paper that say so.
    """

    roots: tuple[str, ...] = ()  # until all is known on which they stand
    powers: tuple[str, ...] = ()

    def __init__(
        self,
        scene: Scene,
        texts: Texts,
        of: Callable[[Scene], Elaboration],
        met: tuple[Formula, ...] = (),
    ) -> None:
        self.scene, self.texts, self._of, self.met = scene, texts, of, met
        change = scene.field
        self.source = of(change.source) if isinstance(change, ChangeOfScene) else None
        self.partials = Partials(self)
        before = self.source.motion if self.source is not None else None
        self.motion: LawOfMotion = LawOfMotion(self, self.partials, self.source, before)
        self._definitions = Definitions(self, self.motion)
        self.places: dict[str, tuple[Printed, ...]] = {}
        self.turning: dict[str, Formula] | None = None
        self.zero = frozenset(zero_names(scene, texts))
        # a coordinate may be given by an equation for its square: then it is adjoined, and no free
        # generator
        named = {name for name in scene.roots if not name.startswith(r"\sqrt")}
        functions = self.transcendental
        moving = [
            *(n for variable in scene.variables for n in functions.instead(variable)),
            *self.velocities.values(),
            *functions.products(moving=True),
            *(functions.instead(scene.time) if functions.depends_on_time else ()),
        ]
        still = [
            n
            for constant in (*scene.constants, *scene.undefined)
            for n in functions.instead(constant)
        ]
        still += functions.products(moving=False)
        root = self.radicals.root
        self.variables = tuple(root(n) for n in moving if n not in named | self.zero)
        self.constants = tuple(root(n) for n in still if n not in named)
        self.powers = tuple(f"{base}^{{{exponent}}}" for base, exponent in scene.powers)
        self.supposed = Suppositions(scene, texts)
        self.roots = tuple(dict.fromkeys(self._root_names()))

    def _root_names(self) -> Iterator[str]:
        if self.scene.unit is not None or (self.source is not None and "i" in self.source.roots):
            yield "i"
        primes, names = dict.fromkeys(self.transcendental.numbers), list[str]()
        for name, printed in self.scene.roots.items():
            if not name.startswith(r"\sqrt"):
                names.append(name)
            elif printed is None and not self._is_power(name):
                number = root_of_number(self.texts.expression(name).children()[0])
                primes |= dict.fromkeys(rf"\sqrt{{{p}}}" for p in number[1]) if number else {}
                names += [] if number else [name]
        # in the order of adjunction: numbers first, for any radicand may have their roots in it
        yield from (*primes, *names, *self.transcendental.roots)
        yield from self.supposed.roots
        if (
            self.supposed.comparisons
        ):  # a printed root is not negative, nor is the root of it imaginary
            printed_roots = [name for name in names if name.startswith(r"\sqrt")]
            signs = {rf"\sqrt{{{name}}}": name for name in printed_roots}
            yield from (sign for sign, name in signs.items() if name not in signs)

    @cached_property
    def unprinted(self) -> frozenset[str]:
        """The roots that say what is not negative, and that no scene declares."""
        signs = {rf"\sqrt{{{name}}}" for name in self.roots}
        return frozenset((self.supposed.roots.keys() - self.scene.roots.keys()) | signs)

    @cached_property
    def together(self) -> tuple[tuple[str, ...], ...]:
        """Names that say something about each other: in an inequality, and of a root its sign."""
        known = {*self.roots}
        signs = ((name, rf"\sqrt{{{name}}}") for name in self.roots)
        groups: list[tuple[str, ...]] = [two for two in signs if two[1] in known]
        for comparison in self.supposed.comparisons:
            reach = Reach(self)
            reach.formula(self.formula(comparison.difference))
            if comparison.sign != r"\ne":
                reach.name(root_of(comparison.difference))
            groups.append(tuple(sorted(reach.names)))
        return (*self.transcendental.together, *groups)

    def _is_power(self, root: str) -> bool:
        """Whether a printed root is that of a name with a root in its place."""
        radicand = self.texts.expression(root).children()[0]
        return isinstance(radicand, Name) and radicand.name in self.radicals

    @cached_property
    def loci(self) -> tuple[tuple[tuple[Equation, ...], Formula], ...]:
        """The loci of the scene, in variables, constants and roots."""
        at, found = self.finder, []
        for locus in self.scene.loci:
            sides = at.differences(self.equations(locus.equations))
            equations = tuple((formula_in(side), Number(0)) for side in sides)
            found.append((equations, self.numerator(self.formula(locus.condition))))
        return tuple(found)

    def numerator(self, formula: Formula) -> Formula:
        element = self.finder.scalar(formula)
        parts, ring = element.parts, element.ring
        for index in element.denominator:
            while (quotients := _divide(parts, ring.divisors[index])) is not None:
                parts = quotients
        return formula_in(Element(ring, parts, {}))

    @property
    def coordinates(self) -> tuple[str, ...]:
        """The roots that are variables of the scene."""
        return tuple(name for name in self.roots if name in self.scene.variables)

    @cached_property
    def nonzero(self) -> tuple[Formula, ...]:
        """What the scene takes for granted not to vanish."""
        roots = (Name(self.radicals.root(name)) for name in self.radicals.orders)
        granted = (Name(n) if n in self.roots else self.formula(n) for n in self.scene.nonzero)
        strict = map(self.formula, self.supposed.strict())
        said = (one for one in (*granted, *strict) if not number_of(one, self._definition))
        return (*said, *self.transcendental.nonzero, *roots)

    def _definition(self, name: str) -> Formula | None:
        """What a name is defined to be, if it is."""
        step = self.step(name) if name in self.scene.definitions else None
        return step.formula if isinstance(step, Let) else None

    @cached_property
    def conjugates(self) -> tuple[tuple[str, str], ...]:
        """The pairs of conjugate names; none if the unit is printed with another square."""
        if "i" in self.roots:
            step = self.step("i")
            assert isinstance(step, Adjoined)
            # where i has another square, as in a mutant, conjugates are none of complex numbers
            if step.square != Negative(Number(1)):
                return ()
        pairs = [*self.scene.conjugates]
        for a, b in pairs:  # the velocities of conjugates are conjugate too, and stand behind
            if a in self.velocities and b in self.velocities:
                pairs.append((self.velocities[a], self.velocities[b]))
        return tuple(pairs)

    @cached_property
    def finder(self) -> Evaluation:
        """The setting in FLINT, where what has to be solved for is solved."""
        evaluation = Evaluation(self, load("flint"), others=finder_of)
        # whoever is asked while roots are adjoined asks for the finder: it is known before it is
        # complete
        self.__dict__["finder"] = evaluation
        try:
            with self._definitions.anew():
                evaluation.adjoin_roots()
                validate(self)
                self.supposed.check(evaluation, self.plain)
        except BaseException:  # an interruption, too: it is not complete
            del self.__dict__["finder"]  # whoever asks again is refused again
            raise
        return evaluation

    # -- the motion ------------------------------------------------------------------

    @cached_property
    def printed_field(self) -> list[Formula]:
        """The equations of motion, as far as they can be read; who needs them is told the rest."""
        rows = self.scene.field
        found: list[Formula] = []
        for place in () if isinstance(rows, ChangeOfScene) else rows:
            with suppress(NotationError):
                found.append(self.texts.relation(place))
        return found

    @cached_property
    def transcendental(self) -> Transcendental:
        """The functions at the arguments that stand in what the scene and the claim print."""
        return functions_of(self)

    @cached_property
    def radicals(self) -> Radicals:
        """The fractional powers in what the scene and the claim print."""
        if isinstance(self.scene.field, ChangeOfScene):
            return Radicals((), ())
        places = [place for place in self.scene.places if place not in self.scene.field]
        printed = [*self.printed_field, *self.met]
        for place in places:
            with suppress(NotationError):
                printed.append(self.texts.formula(place))
        for name in self.scene.roots:
            if name.startswith(r"\sqrt"):
                printed.append(self.texts.expression(name))
        names = {*self.scene.variables, *self.scene.constants}
        functions = self.transcendental
        under = {name for group in functions.groups for name in functions.names_under(group)}
        return Radicals(printed, names, under)

    @property
    def own_variables(self) -> tuple[str, ...]:
        if self.transcendental.groups:
            what = f"{to_latex(self.transcendental.groups[0].argument)} stands under a function"
            raise Meaningless(f"{what}: degrees, volumes and numbers of solutions are not known")
        return self.variables

    @cached_property
    def velocities(self) -> dict[str, str]:
        """The variables of which higher derivatives are printed, and those derivatives' names."""
        scene = self.scene
        given = {name: self.definition(name) for name in self._derived_twice()}
        return velocities(self.printed_field, scene.variables, scene.vectors, given)

    def _derived_twice(self) -> list[str]:
        """The names with a definition that the equations of motion derive more than once."""
        derived = {name for one in self.printed_field for name, order in orders(one) if order > 1}
        return [name for name in self.scene.definitions if name in derived]

    @property
    def field(self) -> tuple[EquationOfMotion, ...]:
        """The printed equations of motion, solved for the rates where they are not."""
        return self.motion.field

    @property
    def change(self) -> ChangeOfVariables | None:
        """The change of variables that gives the field."""
        return self.motion.change

    # -- names -------------------------------------------------------------------

    def step(self, name: str) -> Step | None:
        """What defines a name; raises :class:`Meaningless` if nothing does."""
        if name in self.roots and "finder" not in self.__dict__:
            _ = self.finder  # it solves for all roots, in their order
        return self._definitions.step(name)

    def raised(self, name: str) -> Raised:
        """The step of a power."""
        step = self.step(name)
        assert isinstance(step, Raised)
        return step

    def definition(self, name: str) -> Formula:
        return self._definitions.definition(name)

    def partial(self, formula: Formula, name: str) -> Formula:
        return self.partials(formula, name)

    def free(self, names: Sequence[str]) -> Evaluation:
        """The setting in FLINT with more variables, bound by nothing; a root may be one."""
        ring = Ring(self.finder.polynomials((*generators(self), *names)))
        values = {generator: ring.generator(generator) for generator in ring.polynomials.generators}
        at = Evaluation(self, self.finder.polynomials, ring, values, finder_of)
        # roots behind the one that is made free may have it in their radicands, and are not known
        # yet
        for root in takewhile(lambda root: root not in names, self.roots):
            at.scalar(Name(root))
        return at

    # -- formulas ----------------------------------------------------------------

    @cached_property
    def plain(self) -> Plain:
        """Formulas of the paper, written out in the operations of a space."""
        return Plain(self)

    @cached_property
    def inlined_places(self) -> InlinedDefinitions:
        """What a place prints that leaves no name in the space."""
        return InlinedDefinitions(self.plain)

    @cached_property
    def divisors(self) -> Divisors:
        """What elements of the setting are divided by."""
        return Divisors(self)

    def formula(self, formula: str | Formula) -> Formula:
        """A formula, or LaTeX in the names of the scene, in the operations of a space."""
        return self.plain(self.texts.expression(formula) if isinstance(formula, str) else formula)

    def equations(self, printed: tuple[str, ...]) -> tuple[Equation, ...]:
        """The sides of equations that are given as LaTeX."""
        equations: list[Equation] = []
        for tex in printed:
            relation = self.texts.expression(tex)
            if not isinstance(relation, Relation) or not relation.is_equality:
                raise Meaningless(f"{tex} is no equation on “{self.scene.name}”")
            equations += pairwise(map(self.plain, relation.members))
        return tuple(equations)


def _divide(parts: Parts, divisor: Polynomial) -> Parts | None:
    """A numerator over a polynomial, if the division leaves nothing."""
    both = {mask: divmod(part, divisor) for mask, part in parts.items()}
    if not both or any(rest for _, rest in both.values()):
        return None
    return {mask: quotient for mask, (quotient, _) in both.items()}


def finder_of(setting: Setting) -> Evaluation:
    """The evaluation of a setting with FLINT."""
    return setting.finder if isinstance(setting, Elaboration) else finder.finder_of(setting)
