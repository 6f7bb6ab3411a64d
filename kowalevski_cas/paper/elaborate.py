"""Elaboration: what a scene says under given texts, as a setting in plain formulas.

Every name gets its meaning when it is first asked for, once. What a paper prints beyond the
operations of a space is written out: real and imaginary parts, derivatives by another time,
applied functions, powers with symbols, Poisson brackets. What has to be solved for (the square
of a root in a printed equation, the inverse of a change) is found with FLINT; whoever evaluates
the setting checks it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import cached_property

from kowalevski_cas.algebra import load
from kowalevski_cas.algebra.present import formula_in
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.notation import (
    Application,
    Conjugate,
    Constant,
    CrossProduct,
    Derivative,
    Diagonal,
    Formula,
    ImaginaryPart,
    Name,
    Negative,
    Number,
    PoissonBracket,
    Power,
    Product,
    Quotient,
    RealPart,
    Relation,
    Root,
    Sum,
    Vector,
    rank,
    substitute,
    to_latex,
)
from kowalevski_cas.paper.brackets import Brackets
from kowalevski_cas.paper.inverse import inverse
from kowalevski_cas.paper.scene import Change as ChangeOfScene
from kowalevski_cas.paper.scene import Scene, head
from kowalevski_cas.paper.texts import Printed, Texts
from kowalevski_cas.problem.evaluate import Evaluation, Meaningless
from kowalevski_cas.problem.space import (
    Adjoined,
    Change,
    Equation,
    Let,
    Motion,
    Raised,
    Setting,
    Step,
)

MARK = "dot"
"""How a derivative along the field of a space is marked, whatever the time is called."""


class Elaboration(Setting):
    """The setting that a scene means.

    ``of`` gives the elaboration of another scene under the same texts. ``places`` tells, for
    each name that has been given its meaning, the places of the paper that say so.
    """

    def __init__(self, scene: Scene, texts: Texts, of: Callable[[Scene], Elaboration]) -> None:
        self.scene, self.texts, self._of = scene, texts, of
        change = scene.field
        self.source = of(change.source) if isinstance(change, ChangeOfScene) else None
        self.zero = frozenset(self._zero_names())
        named = {name for name in scene.roots if not name.startswith(r"\sqrt")}
        plain = (*scene.variables, *scene.constants, *scene.undefined)
        self._powers = {f"{b}^{{{e}}}": (b, e) for b, e in scene.powers}
        self.variables = tuple(n for n in scene.variables if n not in named | self.zero)
        self.constants = tuple(n for n in plain[len(scene.variables) :] if n not in named)
        self.powers = tuple(self._powers)
        self._steps: dict[str, Step | None] = {}
        self._open: list[str] = []
        self.places: dict[str, tuple[Printed, ...]] = {}
        self._inverses: dict[object, dict[str, Formula]] = {}
        self.applied: set[str] = set()
        """Functions and brackets, which are written out where they are applied."""
        self.roots = tuple(self._root_names())

    def _root_names(self) -> Iterator[str]:
        if self.scene.unit is not None or self.source is not None:
            yield "i"
        for name, printed in self.scene.roots.items():
            if printed is None or not name.startswith(r"\sqrt"):
                yield name

    @cached_property
    def loci(self) -> tuple[tuple[tuple[Equation, ...], Formula], ...]:
        """The loci of the scene."""
        return tuple(
            (self.equations(locus.equations), self.formula(locus.condition))
            for locus in self.scene.loci
        )

    @property
    def coordinates(self) -> tuple[str, ...]:
        """The roots that are variables of the scene."""
        return tuple(name for name in self.roots if name in self.scene.variables)

    @cached_property
    def nonzero(self) -> tuple[Formula, ...]:  # type: ignore[override]
        """What the scene takes for granted not to vanish."""
        return tuple(self.formula(tex) for tex in self.scene.nonzero)

    @cached_property
    def conjugates(self) -> tuple[tuple[str, str], ...]:  # type: ignore[override]
        """The pairs of conjugate names; none if the unit is printed with another square."""
        if "i" in self.roots:
            step = self.step("i")
            assert isinstance(step, Adjoined)
            if step.square != Negative(Number(1)):
                return ()
        return self.scene.conjugates

    @cached_property
    def finder(self) -> Evaluation:
        """The setting in FLINT, where what has to be solved for is solved."""
        evaluation = Evaluation(self, load("flint"), others=self._finder_of)
        self.__dict__["finder"] = evaluation
        return evaluation.adjoin_roots()

    @staticmethod
    def _finder_of(setting: Setting) -> Evaluation:
        assert isinstance(setting, Elaboration)
        return setting.finder

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
                self._steps[name] = self._defined(name)
            finally:
                self._open.pop()
        return self._steps[name]

    def _defined(self, name: str) -> Step | None:
        scene = self.scene
        if name in self.variables or name in self.constants:
            return None
        if name == "i" and "i" in self.roots:
            return self._unit()
        if name in self.roots:
            return self._root(name)
        if name in self._powers:
            base, exponent = self._powers[name]
            return Raised(name, Name(base), exponent)
        if name in self.zero:
            return self._let(name, Number(0), *scene.zero)
        if name in scene.definitions:
            return self._let(name, self.definition(name), scene.definitions[name])
        if name in scene.vectors:
            return self._let(name, Vector(tuple(Name(c) for c in scene.vectors[name])))
        if (place := scene.component(name)) is not None:
            vector, index = place
            component = _component(Name(vector), index, self)
            return self._let(name, component, scene.definitions[vector])
        if self.source is not None and name in self.inverse:
            assert isinstance(scene.field, ChangeOfScene)
            return self._let(name, self.inverse[name], *scene.field.formulas)
        raise Meaningless(f"{name} has no meaning on the scene “{scene.name}”", name)

    def raised(self, name: str) -> Raised:
        """The step of a power."""
        step = self.step(name)
        assert isinstance(step, Raised)
        return step

    def components(self, row: Motion) -> Iterator[tuple[str, Formula, Formula]]:
        """An equation of motion by components: name, factor of its rate, right side."""
        if len(row.names) == 1:
            yield row.names[0], row.factor, row.force
            return
        for index, name in enumerate(row.names):
            yield name, _component(row.factor, index, self), _component(row.force, index, self)

    def is_vector(self, formula: Formula) -> bool:
        """Whether a formula stands for a vector or a matrix."""
        return rank(formula, self.texts.vocabulary) > 0

    def _let(self, name: str, formula: Formula, *places: Printed) -> Let:
        self.places[name] = places
        return Let(name, self.plain(formula))

    def _unit(self) -> Step:
        printed = self.scene.unit
        if printed is None:
            assert self.source is not None
            step = self.source.step("i") if "i" in self.source.roots else None
            self.places["i"] = self.source.places.get("i", ())
            return Adjoined("i", step.square if isinstance(step, Adjoined) else Negative(Number(1)))
        return self._solved("i", printed)

    def _root(self, name: str) -> Step:
        printed = self.scene.roots[name]
        if printed is not None:
            return self._solved(name, printed)
        root = self.texts.expression(name)
        if not isinstance(root, Root):
            raise Meaningless(f"{name} is not printed as a square root", name)
        self.places[name] = ()
        return Adjoined(name, self.plain(root.argument))

    @cached_property
    def inverse(self) -> dict[str, Formula]:
        """The old variables of a change through the new ones; solved for once a change."""
        assert self.source is not None
        known = self.source._inverses
        if self.scene.field not in known:
            change = self.change
            assert change is not None
            known[self.scene.field] = inverse(self.source, change.formulas)
        return known[self.scene.field]

    def _zero_names(self) -> Iterator[str]:
        for printed in self.scene.zero:
            members = self.texts.relation(printed).members
            if Number(0) not in members:
                raise Meaningless(f"the equation at {printed.place} sets nothing to zero")
            for member in members:
                if isinstance(member, Name):
                    yield from self.scene.vectors.get(member.name, (member.name,))

    def definition(self, name: str) -> Formula:
        """The expression for which a name stands.

        It is the first member of the printed chain that is not a bare name, or
        else another name; a formula that is no equation is the expression itself.
        """
        printed = self.scene.definitions.get(name) or self.scene.roots.get(name)
        if printed is None:
            raise Meaningless(f"nothing defines {name}", name)
        formula = self.texts.formula(printed)
        members = formula.members if isinstance(formula, Relation) else (formula,)
        own = self.texts.expression(name)
        others = [m for m in members if m != own and not isinstance(m, Constant)]
        if not others:
            raise Meaningless(f"no expression stands for {name} in its definition", name)
        return next((m for m in others if not isinstance(m, Name)), others[0])

    def _solved(self, name: str, printed: Printed) -> Adjoined:
        r"""A root by a printed equation in which its square stands.

        The equation is solved for the square: ``a^2`` in :math:`(\alpha,\alpha)=a^2`,
        ``z_1^2`` in :math:`z_1^2+x_1y_2=c_1`. Members with names that the scene does
        not have are passed over.
        """
        self.places[name] = (printed,)
        members = [m for m in self.texts.relation(printed).members if not isinstance(m, Constant)]
        own = Power(Name(name), Number(2))
        if len(members) == 2 and own in members:
            other = members[members[0] == own]
            if not _mentions(other, name):
                return Adjoined(name, self.plain(other))
        sides = [plain for m in members if (plain := self._known(m, name)) is not None]
        if len(sides) < 2:
            raise Meaningless(f"the equation at {printed.place} does not give {name}^2", name)
        left, right = sides[0], sides[-1]
        at = [self._at(name, k, left) - self._at(name, k, right) for k in (0, 1, -1, 2)]
        factor = at[1] - at[0]
        even = (at[2] - at[1]).is_zero
        quadratic = (at[3] - at[0] - factor * factor.ring.number(4)).is_zero
        if factor.is_zero or not even or not quadratic:
            raise Meaningless(f"the equation at {printed.place} does not give {name}^2", name)
        square = formula_in(-at[0] / factor)
        return Adjoined(name, square, (left, right))

    def _known(self, member: Formula, root: str) -> Formula | None:
        """A member written out; ``None`` if the scene does not know what it is."""
        try:
            plain = self.plain(member)
            self._at(root, 0, plain)
        except Meaningless:
            return None
        return plain

    def _at(self, name: str, value: int, formula: Formula) -> Element:
        """The value of a formula where a root has this value."""
        finder = self.finder
        own = {n: v for (n, bar), v in finder._values.items() if not bar and isinstance(v, Element)}
        lets = (n for n in own if isinstance(self._steps.get(n), Let))
        for n in [*lets]:
            del own[n]
        values = {**own, name: finder.ring.number(value)}
        at = Evaluation(self, finder.polynomials, finder.ring, values, self._finder_of)
        at.roots = list(finder.roots)
        return at.scalar(formula)

    # -- motion ------------------------------------------------------------------

    @cached_property
    def field(self) -> tuple[Motion, ...]:
        """The printed equations of motion."""
        rows = self.scene.field
        return () if isinstance(rows, ChangeOfScene) else tuple(map(self._motion, rows))

    def _motion(self, printed: Printed) -> Motion:
        left, right = self.texts.relation(printed).members[:2]
        factors = left.factors if isinstance(left, Product) else (left,)
        moving = [f.argument for f in factors if isinstance(f, Derivative)]
        if len(moving) != 1 or not isinstance(moving[0], Name):
            place = printed.place
            raise Meaningless(f"the equation at {place} has no derivative of a name on its left")
        name = moving[0].name
        names = self.scene.vectors.get(name, (name,))
        ones: Formula = Number(1) if names == (name,) else Vector((Number(1),) * len(names))
        rest = tuple(ones if isinstance(f, Derivative) else f for f in factors)
        factor = Product(rest) if len(rest) > 1 else rest[0]
        return Motion(names, self.plain(factor), self.plain(right))

    @cached_property
    def change(self) -> Change | None:
        """The change of variables that gives the field."""
        change = self.scene.field
        if not isinstance(change, ChangeOfScene):
            return None
        assert self.source is not None
        new: dict[str, Formula] = {}
        for printed in change.formulas:
            left, right = self.texts.relation(printed).members[:2]
            if not isinstance(left, Name):
                raise Meaningless(f"the formula at {printed.place} gives no variable")
            new[left.name] = self.source.plain(right)
        kept = [n for n in self.scene.variables if n in self.source.variables]
        formulas = [
            *((n, f) for n, f in new.items() if n in self.scene.variables),
            *((n, Name(n)) for n in kept if n not in new),
        ]
        time = Quotient(Number(1), self.source.plain(self.texts.time_scale(change.time)))
        return Change(self.source, tuple(formulas), time)

    def motion_places(self) -> Iterator[Printed]:
        """The places on which every derivative rests."""
        field = self.scene.field
        if isinstance(field, ChangeOfScene):
            assert self.source is not None
            yield from (*field.formulas, field.time)
            yield from self.source.motion_places()
        else:
            yield from field
        yield from self.scene.zero

    # -- formulas ----------------------------------------------------------------

    def formula(self, formula: str | Formula) -> Formula:
        """A formula, or LaTeX in the names of the scene, in the operations of a space."""
        return self.plain(self.texts.expression(formula) if isinstance(formula, str) else formula)

    def equations(self, printed: tuple[str, ...]) -> tuple[Equation, ...]:
        """The sides of equations that are given as LaTeX."""
        relations = (self.texts.expression(tex) for tex in printed)
        return tuple(
            (self.plain(r.members[0]), self.plain(r.members[1]))
            for r in relations
            if isinstance(r, Relation)
        )

    def plain(self, formula: Formula) -> Formula:
        """The formula in the operations of a space."""
        match formula:
            case RealPart(argument):
                inner = self.plain(argument)
                return Quotient(Sum((inner, Conjugate(inner))), Number(2))
            case ImaginaryPart(argument):
                inner = self.plain(argument)
                below = Product((Number(2), Name("i")))
                return Quotient(Sum((inner, Negative(Conjugate(inner)))), below)
            case Derivative(argument, mark):
                return self._derivative(self.plain(argument), mark)
            case Application():
                return self.plain(self._applied(formula))
            case Root() if (value := self._printed_value(formula)) is not None:
                return value
            case Power(Name(base), exponent) if not _is_whole(exponent):
                return self._symbolic(base, exponent)
            case PoissonBracket(left, right):
                return self.brackets(self._components(left), self._components(right))
        return formula.mapped(self.plain)

    def _derivative(self, argument: Formula, mark: str) -> Formula:
        """The rate by the time of the scene, or by the other one that its clock declares."""
        scene = self.scene
        rate = Derivative(argument, MARK)
        if mark == ("dot" if scene.time == "t" else "prime") or mark == scene.time:
            return rate
        if scene.clock is None:
            raise Meaningless(f"no derivative is printed as “{mark}” on “{scene.name}”")
        scale = self.plain(self.texts.time_scale(scene.clock))
        return Quotient(rate, scale) if scene.time == "t" else Product((scale, rate))

    def _applied(self, formula: Application) -> Formula:
        """The expression for which a function with these arguments stands."""
        for name in self.scene.definitions:
            function, arguments = head(name)
            if arguments and function == formula.function:
                if len(arguments) != len(formula.arguments):
                    raise Meaningless(f"{name} is used with {len(formula.arguments)} arguments")
                self.places[name] = (self.scene.definitions[name],)
                self.applied.add(name)
                values = dict(zip(arguments, formula.arguments, strict=True))
                body = self.definition(name)
                if _applies(body, function):
                    raise Meaningless(f"{name} is defined by itself", function)
                return substitute(body, values)
        raise Meaningless(f"the function {formula.function} has no meaning here", formula.function)

    def _printed_value(self, root: Root) -> Formula | None:
        """What a place prints for a root that is no generator; its square is the radicand."""
        for name, printed in self.scene.roots.items():
            if printed is None or not name.startswith(r"\sqrt"):
                continue
            own = self.texts.expression(name)
            assert isinstance(own, Root)
            radicand = self.finder.scalar(self.plain(own.argument))
            if (radicand - self.finder.scalar(self.plain(root.argument))).is_zero:
                self.places[name] = (printed,)
                value = self.plain(self.definition(name))
                square = self.finder.scalar(value)
                if not (square * square - radicand).is_zero:
                    raise Meaningless(f"the value at {printed.place} is not {name}")
                return value
        return None

    def _symbolic(self, base: str, exponent: Formula) -> Formula:
        """A power with a symbolic exponent, through the declared powers as names."""
        above: list[Formula] = []
        below: list[Formula] = []
        for symbol, multiple in linear_exponent(exponent).items():
            name = f"{base}^{{{symbol}}}"
            if symbol and name not in self._powers:
                raise Meaningless(f"the power {base}^{symbol} is not declared", symbol)
            factor: Formula = Name(name if symbol else base)
            (above if multiple > 0 else below).extend([factor] * abs(multiple))
        top: Formula = Product(tuple(above)) if len(above) > 1 else next(iter(above), Number(1))
        for factor in below:
            top = Quotient(top, factor)
        return top

    @cached_property
    def brackets(self) -> Brackets:
        """The Poisson bracket of the scene."""
        return Brackets(self)

    def _components(self, formula: Formula) -> tuple[bool, tuple[Formula, ...]]:
        """Whether a formula is a vector, and its components."""
        if isinstance(formula, Name) and formula.name in self.scene.vectors:
            names = self.scene.vectors[formula.name]
            return True, tuple(self.plain(Name(n)) for n in names)
        return False, (self.plain(formula),)


def linear_exponent(formula: Formula) -> dict[str, int]:
    """A symbolic exponent as integer multiples of names; the key ``""`` is the constant."""
    match formula:
        case Number(value):
            return {"": value}
        case Name(name):
            return {name: 1}
        case Negative(argument):
            return {k: -v for k, v in linear_exponent(argument).items()}
        case Sum(terms):
            total: dict[str, int] = {}
            for term in terms:
                for key, value in linear_exponent(term).items():
                    total[key] = total.get(key, 0) + value
            return total
    raise Meaningless(f"{to_latex(formula)} is no exponent that can be used here")


def _is_whole(exponent: Formula) -> bool:
    return isinstance(exponent.argument if isinstance(exponent, Negative) else exponent, Number)


def _mentions(formula: Formula, name: str) -> bool:
    return formula == Name(name) or any(_mentions(child, name) for child in formula.children())


def _applies(formula: Formula, function: str) -> bool:
    """Whether a function is applied somewhere in a formula."""
    if isinstance(formula, Application) and formula.function == function:
        return True
    return any(_applies(child, function) for child in formula.children())


def _component(vector: Formula, index: int, setting: Elaboration) -> Formula:
    """One component of a vector that is printed by its components or as a product."""

    def of(part: Formula, k: int) -> Formula:
        return _component(part, k, setting)

    match vector:
        case Vector(components):
            return components[index]
        case Name(name) if name in setting.scene.definitions:
            step = setting.step(name)
            assert isinstance(step, Let)
            return of(step.formula, index)
        case Name(name) if name in setting.scene.vectors:
            return Name(setting.scene.vectors[name][index])
        case Negative(argument):
            return Negative(of(argument, index))
        case Sum(terms):
            return Sum(tuple(of(term, index) for term in terms))
        case Diagonal(entries):
            return entries[index]
        case Product(factors):
            vectors = (f if not setting.is_vector(f) else of(f, index) for f in factors)
            return Product(tuple(vectors))
        case CrossProduct(left, right):
            j, k = (index + 1) % 3, (index + 2) % 3
            first = Product((of(left, j), of(right, k)))
            return Sum((first, Negative(Product((of(left, k), of(right, j))))))
    raise Meaningless(f"{to_latex(vector)} has no components")
