"""A scene in an arithmetic: names get values, formulas are evaluated, D differentiates."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import cache, cached_property

from kowalevski_cas.arithmetic.derivation import Field, along
from kowalevski_cas.arithmetic.polynomials import Polynomials, Terms
from kowalevski_cas.arithmetic.tower import Element, Ring
from kowalevski_cas.notation import (
    Application,
    Constant,
    Formula,
    Name,
    Number,
    Power,
    Relation,
    Root,
    substitute,
    to_latex,
)
from kowalevski_cas.paper.scene import Change, Scene, head
from kowalevski_cas.stage.change import Carrier
from kowalevski_cas.stage.evaluate import StageError, Triple, Value, evaluate, scalar, vector
from kowalevski_cas.stage.field import printed_field, time_scale
from kowalevski_cas.stage.poisson import Structure, printed_structure
from kowalevski_cas.paper.texts import Printed, Texts


class Stage:
    """One scene in one arithmetic, under given texts.

    With ``ring`` and ``image`` the stage is the image of its scene in another
    ring: the variables take the values in ``image``. So formulas are carried
    through a change of variables, specialised, and evaluated at exact points.
    """

    memory: dict[tuple[int, bool], tuple[Formula, Value]] | None = None
    """Values of subformulas by identity, where they are worth remembering."""

    def __init__(
        self,
        scene: Scene,
        arithmetic: type[Polynomials],
        texts: Texts,
        ring: Ring | None = None,
        image: Mapping[str, Element] | None = None,
    ) -> None:
        self.scene = scene
        self.arithmetic = arithmetic
        self.texts = texts
        squared = [n for n in scene.roots if not n.startswith(r"\sqrt")]
        self.powers = {(b, e): f"{b}^{{{e}}}" for b, e in scene.powers}
        names = (*scene.variables, *scene.constants, *scene.undefined, *self.powers.values())
        self.generators = tuple(name for name in names if name not in squared)
        self.ring: Ring = ring or Ring(arithmetic(self.generators))
        self.half = self.ring.number(Fraction(1, 2))
        self._values: dict[tuple[str, bool], Value] = {}
        self._roots: list[tuple[Element, Element]] = []
        self._open: set[tuple[str, bool]] = set()  # definitions that are being evaluated
        self._field: list[Field] = []  # what is computed once is shared with views
        self._old: list[dict[str, Element]] = []
        self._time_sign: list[int] = []
        self._conjugates = dict(scene.conjugates) | {b: a for a, b in scene.conjugates}
        self._place_generators(image)

    def under(self, texts: Texts) -> Stage:
        """The same stage, to evaluate formulas of texts that do not differ on its scene."""
        if texts is self.texts:
            return self
        view = object.__new__(type(self))
        view.__dict__ = {**self.__dict__, "texts": texts}
        return view

    # -- names ---------------------------------------------------------------

    def _place_generators(self, image: Mapping[str, Element] | None) -> None:
        own = {*self.scene.variables, *self.scene.constants, *self.scene.undefined}
        own |= {*self.scene.roots, "i"}
        given = {name: value for name, value in (image or {}).items() if name in own}
        if image is None:
            given = {name: self.ring.generator(name) for name in self.generators}
        for name in self._zero_names():
            given[name] = self.ring.zero
        for name, value in given.items():
            self._values[name, False] = value
            partner = given.get(self._conjugates.get(name, name))
            if partner is not None:
                self._values[name, True] = -partner if name == "i" else partner
        if image is None:
            self._adjoin_roots()
        else:
            for name in self.scene.roots:
                root = self.formula(name)
                if name in image and isinstance(root, Root):
                    self._roots.append((scalar(root.argument, self), image[name]))

    def _adjoin_roots(self) -> None:
        if self.scene.unit is not None:
            unit = self.ring.adjoin("i", self.square("i", self.scene.unit))
            self._values["i", False], self._values["i", True] = unit, -unit
        for name, printed in self.scene.roots.items():
            root = self.formula(name)
            if isinstance(root, Root):
                radicand = scalar(root.argument, self)
                if printed is not None:
                    self._roots.append((radicand, self._printed_root(name, printed, radicand)))
                    continue
            elif printed is None:
                raise StageError(f"{name} is not printed as a square root")
            else:
                radicand = self.square(name, printed)
            value = self.ring.zero if radicand.is_zero else self.ring.adjoin(name, radicand)
            self._roots.append((radicand, value))
            self._values[name, False] = value
            if (self._conjugate(radicand) - radicand).is_zero:
                self._values[name, True] = value  # the root of something real is taken as real
            partner = self._conjugates.get(name, name)
            if partner != name and (partner, False) in self._values:
                self._values[name, True] = self._values[partner, False]
                self._values[partner, True] = value

    def _printed_root(self, name: str, printed: Printed, radicand: Element) -> Element:
        """The value that a place prints for a root; its square has to be the radicand."""
        value = scalar(self.definition(name), self)
        if not (value * value - radicand).is_zero:
            raise StageError(f"the value at {printed.place} is not {name}")
        return value

    def _conjugate(self, element: Element) -> Element:
        """The conjugate of an element, by the conjugates of the generators."""

        def barred(name: str) -> Element:
            own = name in self.generators
            return scalar(Name(name) if own else self.formula(name), self, True)

        return self._image(element, barred)

    def _zero_names(self) -> Iterator[str]:
        for printed in self.scene.zero:
            members = self.relation(printed).members
            if Number(0) not in members:
                raise StageError(f"the equation at {printed.place} sets nothing to zero")
            for member in members:
                if isinstance(member, Name):
                    yield from self.scene.vectors.get(member.name, (member.name,))

    def knows(self, name: str) -> bool:
        """Whether a name has a meaning on the scene."""
        try:
            self.value(name)
        except StageError:
            return False
        return True

    def value(self, name: str, conjugated: bool = False) -> Value:
        """The value of a name; raises :class:`StageError` if it has none on the scene."""
        key = (name, conjugated)
        if key not in self._values:
            if not conjugated and (old := self._old_value(name)) is not None:
                self._values[key] = old
            elif name in self.scene.definitions:
                if key in self._open:
                    raise StageError(f"{name} is defined by itself", name)
                self._open.add(key)
                try:
                    self._values[key] = evaluate(self.definition(name), self, conjugated)
                finally:
                    self._open.discard(key)
            elif name in self.scene.vectors:
                components = self.scene.vectors[name]
                self._values[key] = Triple(
                    scalar(Name(component), self, conjugated) for component in components
                )
            elif (place := self.scene.component(name)) is not None:
                self._values[key] = vector(Name(place[0]), self, conjugated)[place[1]]
            else:
                raise StageError(f"{name} has no meaning on the scene “{self.scene.name}”", name)
        return self._values[key]

    def _old_value(self, name: str) -> Element | None:
        """A variable of the scene from which this one is a change, where the unit is at hand."""
        change = self.scene.field
        if not isinstance(change, Change) or self.scene.unit is None:
            return None
        if name not in change.source.variables or name in self.scene.variables:
            return None
        if not self._old:
            self._old.append(Carrier(change, self).old_variables())
        return self._old[0][name]

    def relation(self, printed: Printed) -> Relation:
        """The chain of equalities at a place."""
        formula = self.texts.formula(printed)
        if not isinstance(formula, Relation):
            raise StageError(f"an equation is expected at {printed.place}")
        return formula

    def definition(self, name: str) -> Formula:
        """The expression for which a name stands.

        It is the first member of the printed chain that is not a bare name, or
        else another name; a formula that is no equation is the expression itself.
        """
        printed = self.scene.definitions.get(name) or self.scene.roots.get(name)
        if printed is None:
            raise StageError(f"nothing defines {name}", name)
        formula = self.texts.formula(printed)
        members = formula.members if isinstance(formula, Relation) else (formula,)
        own = self.formula(name)
        others = [m for m in members if m != own and not isinstance(m, Constant)]
        if not others:
            raise StageError(f"no expression stands for {name} in its definition", name)
        return next((m for m in others if not isinstance(m, Name)), others[0])

    def applied(self, formula: Application) -> Formula:
        """The expression for which a function with these arguments stands."""
        for name in self.scene.definitions:
            function, arguments = head(name)
            if arguments and function == formula.function:
                if len(arguments) != len(formula.arguments):
                    raise StageError(f"{name} is used with {len(formula.arguments)} arguments")
                values = dict(zip(arguments, formula.arguments, strict=True))
                body = self.definition(name)
                if _applies(body, function):
                    raise StageError(f"{name} is defined by itself", function)
                return substitute(body, values)
        raise StageError(f"the function {formula.function} has no meaning here", formula.function)

    def square(self, name: str, printed: Printed) -> Element:
        r"""What the square of a root equals, by a printed equation in which it stands.

        The equation is solved for the square: ``a^2`` in :math:`(\alpha,\alpha)=a^2`,
        ``z_1^2`` in :math:`z_1^2+x_1y_2=c_1`. Members with names that the scene does
        not have are passed over.
        """
        members = self.relation(printed).members
        own = Power(Name(name), Number(2))
        if len(members) == 2 and own in members:
            try:
                return scalar(members[members[0] == own], self)
            except StageError:
                pass  # it stands on the other side as well
        at = [self._difference(printed, name, self.ring.number(k)) for k in (0, 1, -1, 2)]
        factor = at[1] - at[0]
        even = (at[2] - at[1]).is_zero
        quadratic = (at[3] - at[0] - factor * self.ring.number(4)).is_zero
        if factor.is_zero or not even or not quadratic:
            raise StageError(f"the equation at {printed.place} does not give {name}^2", name)
        return -at[0] / factor

    def _difference(self, printed: Printed, name: str, value: Element) -> Element:
        """The first member of an equation less the last one, with a value for one name."""
        own = {n: v for (n, barred), v in self._values.items() if not barred}
        image = {n: v for n, v in own.items() if isinstance(v, Element)}
        stage = Stage(self.scene, self.arithmetic, self.texts, self.ring, {**image, name: value})
        if name not in self.scene.variables:
            stage._old = self._old
        sides = []
        for member in self.relation(printed).members:
            try:
                sides.append(scalar(member, stage))
            except StageError:
                continue
        if len(sides) < 2:
            raise StageError(f"the equation at {printed.place} does not give {name}^2", name)
        return sides[0] - sides[-1]

    def formula(self, tex: str) -> Formula:
        """A formula in the names of the scene."""
        return self.texts.expression(tex)

    def granted(self) -> Iterator[Formula]:
        """What the scene takes for granted not to vanish."""
        return (self.formula(tex) for tex in self.scene.nonzero)

    def landmarks(self) -> Iterator[Formula]:
        """Expressions by which a condition is called where it is one of them."""
        yield from (self.formula(locus.condition) for locus in self.scene.loci)

    def equations(self, printed: tuple[str, ...]) -> list[Element]:
        """The left sides minus the right sides of equations given as LaTeX."""
        relations = [self.formula(tex) for tex in printed]
        return [
            scalar(relation.members[0], self) - scalar(relation.members[1], self)
            for relation in relations
            if isinstance(relation, Relation)
        ]

    def root(self, radicand: Formula, conjugated: bool = False) -> Element:
        """The declared square root of an expression."""
        value = scalar(radicand, self, conjugated)
        for square, root in self._roots:
            if (square - value).is_zero:
                return root
        raise StageError(f"the scene “{self.scene.name}” declares no root of {to_latex(radicand)}")

    def declared_roots(self) -> list[tuple[Element, Element]]:
        """The roots that may be printed as such: pairs of a radicand and its root."""
        return self._roots

    def symbolic_power(self, base: Formula, exponent: str) -> Element:
        """A declared power with a symbolic exponent."""
        for (name, symbol), generator in self.powers.items():
            if base == Name(name) and symbol == exponent:
                return self.ring.generator(generator)
        raise StageError(f"the power {to_latex(base)}^{exponent} is not declared", exponent)

    def carry(self, element: Element) -> Element:
        """An element of another scene's ring, its generators taken for the names of this one."""
        return self._image(element, lambda name: scalar(self.formula(name), self))

    def _image(self, element: Element, value_of: Callable[[str], Element]) -> Element:
        """The image of an element under values for the generators and roots of its ring."""
        ring, value_of = element.ring, cache(value_of)
        names = ring.polynomials.generators
        total = self.ring.zero
        for mask, terms in element.terms().items():
            value = self._substituted(terms, names, value_of)
            for bit, root in enumerate(ring.roots):
                if mask >> bit & 1:
                    value = value * value_of(root)
            total = total + value
        for index, exponent in element.denominator.items():
            terms = ring.polynomials.terms(ring.divisors[index])
            total = total * self._substituted(terms, names, value_of) ** -exponent
        return total

    def _substituted(
        self, terms: Terms, names: Sequence[str], value_of: Callable[[str], Element]
    ) -> Element:
        total = self.ring.zero
        for exponents, coefficient in terms.items():
            product = self.ring.number(coefficient)
            for name, exponent in zip(names, exponents, strict=True):
                if exponent:
                    product = product * value_of(name) ** exponent
            total = total + product
        return total

    # -- derivatives ---------------------------------------------------------

    @property
    def field(self) -> Field:
        """The vector field: the derivative of each variable by the scene's time."""
        if not self._field:
            field = self.scene.field
            if isinstance(field, Change):
                found = Carrier(field, self).field()
            else:
                found = printed_field(field, self)
            still = [name for name in self.scene.variables if name not in found]
            if still:
                raise StageError(f"no equation of motion for {still[0]}", still[0])
            for name in self.scene.roots.keys() & found.keys():
                found[name] = self._rate_of_generator(name, found)
            for (base, exponent), power in self.powers.items():
                value = scalar(self.formula(base), self)
                rate = along(value, found) * value.inverse()
                rate = rate * self.ring.generator(exponent) * self.ring.generator(power)
                found = {**found, power: rate}
            self._field.append(found)
        return self._field[0]

    def _rate_of_generator(self, name: str, rates: Field) -> Element:
        """The derivative of the generator that gives a moving root, perhaps over a divisor."""
        value = self.value(name)
        assert isinstance(value, Element)
        below = self.ring.divisor_product(value.denominator)
        if below is None:
            return rates[name]
        (part,) = value.parts.values()
        factor = self.ring.element({0: below}, {}) / self.ring.element({0: part}, {})
        return rates[name] * factor + value * along(factor, rates)

    def derivative(self, element: Element) -> Element:
        """The derivative along the field, by the scene's time."""
        return along(element, self.field)

    @cached_property
    def structure(self) -> Structure:
        """The Poisson brackets of the variables."""
        return printed_structure(self)

    def bracket(self, left: Element, right: Element) -> Element:
        """The Poisson bracket of two functions, by the brackets of the variables."""
        names = sorted({name for pair in self.structure for name in pair})
        first, second = (
            {name: along(element, {name: self.ring.one}) for name in names}
            for element in (left, right)
        )
        total = self.ring.zero
        for (x, y), value in self.structure.items():
            total = total + value * (first[x] * second[y] - first[y] * second[x])
        return total

    def time_factor(self, mark: str, conjugated: bool) -> Element:
        """By what a derivative with this mark differs from the one by the scene's time."""
        scene = self.scene
        if mark == ("dot" if scene.time == "t" else "prime") or mark == scene.time:
            if conjugated and isinstance(scene.field, Change):
                if not self._time_sign:
                    self._time_sign.append(Carrier(scene.field, self).time_sign())
                return self.ring.number(self._time_sign[0])
            return self.ring.one
        if scene.clock is None:
            raise StageError(f"no derivative is printed as “{mark}” on “{scene.name}”")
        scale = time_scale(scene.clock, self, conjugated)
        return scale.inverse() if scene.time == "t" else scale


def _applies(formula: Formula, function: str) -> bool:
    """Whether a function is applied somewhere in a formula."""
    if isinstance(formula, Application) and formula.function == function:
        return True
    return any(_applies(child, function) for child in formula.children())
