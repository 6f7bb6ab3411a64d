"""Elaboration: what a scene says under given texts, as a setting in plain formulas.

Every name gets its meaning when it is first asked for, once. What a paper prints beyond the
operations of a space is written out: real and imaginary parts, derivatives by another time,
applied functions, powers with symbols, Poisson brackets. What has to be solved for (the square
of a root in a printed equation, the inverse of a change) is found with FLINT; whoever evaluates
the setting checks it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import cached_property
from itertools import pairwise, takewhile

from kowalevski_cas.algebra import load
from kowalevski_cas.algebra.polynomials import Polynomial
from kowalevski_cas.algebra.present import formula_in
from kowalevski_cas.algebra.tower import Element, Parts, Ring
from kowalevski_cas.notation import (
    Constant,
    Derivative,
    Formula,
    Name,
    Negative,
    Number,
    Product,
    Quotient,
    Relation,
    Root,
    Vector,
)
from kowalevski_cas.paper.components import component
from kowalevski_cas.paper.denominators import Divisors
from kowalevski_cas.paper.inlined import InlinedDefinitions
from kowalevski_cas.paper.motion import Moving
from kowalevski_cas.paper.names import head, is_bold
from kowalevski_cas.paper.plain import Plain
from kowalevski_cas.paper.roots import root_of_number, solve_for_root
from kowalevski_cas.paper.scene import Change as ChangeOfScene
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.paper.signs import Comparison, comparisons, root_of
from kowalevski_cas.paper.texts import Printed, Texts
from kowalevski_cas.paper.validation import validate
from kowalevski_cas.problem import finder
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.mentions import mentions
from kowalevski_cas.problem.prune import Reach
from kowalevski_cas.problem.space import (
    Adjoined,
    Equation,
    Let,
    Meaningless,
    Raised,
    Setting,
    Step,
    generators,
)


class Elaboration(Moving):
    """The setting that a scene means.

    ``of`` gives the elaboration of another scene under the same texts. ``places`` tells, for
    each name that has been given its meaning, the places of the paper that say so.
    """

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
        self.zero = frozenset(self._zero_names())
        # a coordinate may be given by an equation for its square: then it is adjoined, and no free
        # generator
        named = {name for name in scene.roots if not name.startswith(r"\sqrt")}
        functions = self.transcendental
        self._powers = {f"{b}^{{{e}}}": (b, e) for b, e in scene.powers}
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
        self.powers = tuple(self._powers)
        self.turning: dict[str, Formula] | None = None
        self._steps: dict[str, Step | None] = {}
        self._open: list[str] = []
        self.places: dict[str, tuple[Printed, ...]] = {}
        self.inverses: dict[object, dict[str, Formula]] = {}
        self.supposed = tuple(self._supposed())
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
        yield from (
            root_of(comparison.difference)
            for comparison in self.supposed
            if comparison.sign != r"\ne"
        )
        if self.supposed:  # a printed root is not negative, nor is the root of it imaginary
            printed_roots = [name for name in names if name.startswith(r"\sqrt")]
            signs = {rf"\sqrt{{{name}}}": name for name in printed_roots}
            yield from (sign for sign, name in signs.items() if name not in signs)

    def _supposed(self) -> Iterator[Comparison]:
        """What the inequalities of the scene say; not what numbers say of each other."""
        for printed in self.scene.signs:
            for comparison in comparisons(self.texts.comparison(printed)):
                if comparison.sign == "=" or comparison.number is False:
                    raise Meaningless(f"{printed.tex} is no inequality that can be supposed")
                if comparison.number is None:
                    yield comparison

    @cached_property
    def unprinted(self) -> frozenset[str]:
        """The roots that say what is not negative, and that no scene declares."""
        supposed = {
            root_of(comparison.difference)
            for comparison in self.supposed
            if comparison.sign != r"\ne"
        }
        signs = {rf"\sqrt{{{name}}}" for name in self.roots}
        return frozenset((supposed - {*self.scene.roots}) | signs)

    @cached_property
    def together(self) -> tuple[tuple[str, ...], ...]:
        """Names that say something about each other: in an inequality, and of a root its sign."""
        known = {*self.roots}
        signs = ((name, rf"\sqrt{{{name}}}") for name in self.roots)
        groups: list[tuple[str, ...]] = [two for two in signs if two[1] in known]
        for comparison in self.supposed:
            reach = Reach(self)
            reach.formula(self.formula(comparison.difference))
            if comparison.sign != r"\ne":
                reach.name(root_of(comparison.difference))
            groups.append(tuple(sorted(reach.names)))
        return (*super().together, *groups)

    def _is_power(self, root: str) -> bool:
        """Whether a printed root is that of a name with a root in its place."""
        radicand = self.texts.expression(root).children()[0]
        return isinstance(radicand, Name) and radicand.name in self.radicals

    @cached_property
    def loci(self) -> tuple[tuple[tuple[Equation, ...], Formula], ...]:  # type: ignore[override] # computed here, an attribute above
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
    def nonzero(self) -> tuple[Formula, ...]:  # type: ignore[override] # computed here, an attribute above
        """What the scene takes for granted not to vanish."""
        roots = (Name(self.radicals.root(name)) for name in self.radicals.orders)
        granted = (Name(n) if n in self.roots else self.formula(n) for n in self.scene.nonzero)
        strict = (
            self.formula(comparison.difference)
            for comparison in self.supposed
            if comparison.sign != r"\le"
        )
        said = (one for one in (*granted, *strict) if not self._is_given_by_number(one))
        return (*said, *self.transcendental.nonzero, *roots)

    def _is_given_by_number(self, formula: Formula) -> bool:
        r"""Whether it is a number: :math:`bc\ne0` says nothing beside :math:`b=1, c=2b`."""
        match formula:
            case Number(value):
                return value != 0
            case Name(name) if name in self.scene.definitions:
                step = self.step(name)
                return isinstance(step, Let) and self._is_given_by_number(step.formula)
            case Negative() | Product() | Quotient():
                return all(map(self._is_given_by_number, formula.children()))
        return False

    @cached_property
    def conjugates(self) -> tuple[tuple[str, str], ...]:  # type: ignore[override] # computed here, an attribute above
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
        opened, self._open = self._open, []  # what is being defined may stand under a root
        try:
            evaluation.adjoin_roots()
            validate(self)
        except Meaningless:
            del self.__dict__["finder"]  # whoever asks again is refused again
            raise
        finally:
            self._open = opened
        return evaluation

    # -- names -------------------------------------------------------------------

    def step(self, name: str) -> Step | None:
        """What defines a name; raises :class:`Meaningless` if nothing does."""
        if name in self.roots and "finder" not in self.__dict__:
            _ = self.finder  # it solves for all roots, in their order
        if name not in self._steps:
            if name in self._open:
                raise Meaningless(f"{name} is defined by itself", name)
            self._open.append(name)
            try:
                self._steps[name] = self._define(name)
            finally:
                self._open.pop()
        return self._steps[name]

    def _define(self, name: str) -> Step | None:
        scene = self.scene
        if name in self.variables or name in self.constants:
            return None
        if name == "i" and "i" in self.roots:
            return self._unit()
        if name in self.roots:
            return self._root(name)
        if name in self._powers:
            base, exponent = self._powers[name]
            if exponent not in self.constants:
                raise Meaningless(f"{exponent} is an exponent here, and has a value", exponent)
            return Raised(name, Name(base), exponent)
        if name in self.zero:
            return self._let(name, Number(0), *scene.zero)
        if name in self.radicals:
            return self._let(name, self.radicals.value(name))
        return self._definition_of(name)

    def _definition_of(self, name: str) -> Let:
        """What a name stands for."""
        scene = self.scene
        if name in self.transcendental.derived:
            return self._let(name, self.transcendental.derived[name].formula)
        if (whole := self._head(name)) is not None:
            return self._let(name, self.definition(whole), scene.definitions[whole])
        if name in scene.vectors:
            return self._let(name, Vector(tuple(Name(c) for c in scene.vectors[name])))
        if (place := scene.component(name)) is not None:
            vector, index = place
            formula = component(Name(vector), index, self)
            return self._let(name, formula, scene.definitions[vector])
        if self.source is not None and name in self.inverse:
            assert isinstance(scene.field, ChangeOfScene)
            return self._let(name, self.inverse[name], *scene.field.formulas)
        raise self._without_meaning(name)

    def _without_meaning(self, name: str) -> Meaningless:
        what = f"{name} has no meaning on the scene “{self.scene.name}”"
        if name in self.transcendental:
            what = f"{name} stands under functions: by itself it is not known here"
        return Meaningless(what, name)

    def _head(self, name: str) -> str | None:
        """The head in which a name has variables for arguments, as H has in H(q,p)."""
        heads = (definition for definition in self.scene.definitions if head(definition)[0] == name)
        return next(filter(self.scene.of_variables, heads), None)

    def raised(self, name: str) -> Raised:
        """The step of a power."""
        step = self.step(name)
        assert isinstance(step, Raised)
        return step

    def _let(self, name: str, formula: Formula, *places: Printed) -> Let:
        self.places[name] = places
        let = Let(name, self.plain(formula))
        for other in mentions(let.formula):  # vectors stay as they are, and may run in a circle
            if (
                isinstance(other, Name)
                and (is_bold(other.name) or other.name in self.scene.vectors)
                and other.name in self.scene.definitions
            ):
                self.step(other.name)
        return let

    def _unit(self) -> Step | None:
        printed = self.scene.unit
        if printed is None:
            assert self.source is not None
            step = self.source.step("i")
            self.places["i"] = self.source.places.get("i", ())
            return step
        return solve_for_root(self, "i", printed)

    def _root(self, name: str) -> Step:
        if name in self.transcendental.roots:
            self.places[name] = ()
            return Adjoined(name, self.plain(self.transcendental.roots[name].square))
        printed = self.scene.roots.get(name)
        if printed is not None:
            return solve_for_root(self, name, printed)
        root = self.texts.expression(name)
        if not isinstance(root, Root):
            raise Meaningless(f"{name} is not printed as a square root", name)
        self.places[name] = ()
        return Adjoined(name, self._without_rates(self.plain(root.argument)))

    def _without_rates(self, radicand: Formula) -> Formula:
        """What stands under a root by what moves: roots are adjoined before anything has a rate."""
        if not any(isinstance(one, Derivative) for one in mentions(radicand)):
            return radicand
        return formula_in(self.finder.scalar(radicand))

    def _zero_names(self) -> Iterator[str]:
        for printed in self.scene.zero:
            members = self.texts.relation(printed).members
            names = [member.name for member in members if isinstance(member, Name)]
            if members.count(Number(0)) != 1 or len(names) != len(members) - 1:
                raise Meaningless(f"the equation at {printed.place} does not set names to zero")
            for name in names:
                yield from self.scene.vectors.get(name, (name,))

    def definition(self, name: str) -> Formula:
        """The expression for which a name stands.

        It is the first member of the printed chain that is not a bare name, or
        else another name, that stands for nothing; a formula that is no equation is the expression
        itself.
        """
        printed = self.scene.definitions.get(name) or self.scene.roots.get(name)
        if printed is None:
            raise Meaningless(f"nothing defines {name}", name)
        formula = self.texts.formula(printed)
        members = formula.members if isinstance(formula, Relation) else (formula,)
        own = self.texts.expression(name)
        others = [m for m in members if m != own and not isinstance(m, Constant)]
        for one in others:
            match one:
                case Product((Number() as factor, multiple)) if multiple == own:
                    rest = next(other for other in others if other != one)
                    return Quotient(rest, factor)
        if not others or (name in printed.heads.names and own not in members):
            raise Meaningless(f"no expression stands for {name} in its definition", name)
        given = (m for m in others if getattr(m, "name", "") not in self.scene.definitions)
        return next((m for m in others if not isinstance(m, Name)), next(given, others[0]))

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
