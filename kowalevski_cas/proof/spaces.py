"""Scenes as spaces of a certificate: only what the statements need, in the order of use."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product
from typing import Any

from kowalevski_cas.arithmetic.derivation import along
from kowalevski_cas.arithmetic.present import polynomial_formula
from kowalevski_cas.arithmetic.tower import Element
from kowalevski_cas.claims.points import AtPoint
from kowalevski_cas.notation import (
    Application,
    Conjugate,
    Derivative,
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
    Root,
    Sum,
    Vector,
    read,
    replace,
)
from kowalevski_cas.proof.trees import CertificateError, Tree, decode, encode, names_of, uses
from kowalevski_cas.proof.values import number_tree
from kowalevski_cas.paper.scene import Change
from kowalevski_cas.stage import Stage, StageError, scalar
from kowalevski_cas.stage.evaluate import Triple, evaluate, linear_exponent
from kowalevski_cas.paper.texts import Printed


class SpaceWriter:
    """The space of a stage: it grows with the formulas that are written in it.

    ``source`` is the writer of the space from which this one is a change.
    """

    def __init__(self, stage: Stage, index: int, source: SpaceWriter | None) -> None:
        self.stage, self.scene = stage, stage.scene
        self.index, self.source = index, source
        self.mark = "dot" if self.scene.time == "t" else "prime"
        self.steps: list[list[Tree]] = []
        self.relations: list[list[Tree]] = []
        self.meanings: dict[str, Tree] = {}
        self.nonzero: list[Tree] = []
        self.known: set[str] = set()
        self.powers: list[tuple[str, str, str]] = []
        self.moving = self.whole = False

    # -- formulas --------------------------------------------------------------

    def tree(self, formula: Formula) -> Tree:
        """The tree of a formula; it has to read back as the formula."""
        if isinstance(formula, PoissonBracket):
            return self.bracket(formula)
        plain = self._plain(formula)
        tree = encode(plain)
        if decode(tree, self.mark) != plain:
            raise CertificateError("a formula does not read back as what is printed")
        if plain != formula and not self._same(plain, formula):
            raise CertificateError("a formula reads back as another one")
        self.take(tree)
        return tree

    def bracket(self, formula: PoissonBracket) -> Tree:
        """A Poisson bracket by partial derivatives, component by component."""
        sides = []
        for side in (formula.left, formula.right):
            names = self.scene.vectors.get(side.name, ()) if isinstance(side, Name) else ()
            sides.append([self.tree(Name(n)) for n in names] or [self.tree(side)])
        rows = [self._bracket(left, right) for left, right in product(*sides)]
        return rows[0] if len(rows) == 1 else ["vector", *rows]

    def _bracket(self, left: Tree, right: Tree) -> Tree:
        terms: list[Tree] = []
        for (x, y), value in self.stage.structure.items():
            first = ["*", ["d", x, left], ["d", y, right]]
            second = ["*", ["d", y, left], ["d", x, right]]
            terms.append(["*", self.element(value), ["+", first, ["-", second]]])
        tree = ["+", *terms]
        self.take(tree)
        return tree

    def tex(self, text: str) -> Tree:
        """The tree of a formula given in LaTeX."""
        return self.tree(self.stage.formula(text))

    def sides(self, printed: Printed) -> list[Tree]:
        """Both sides of a printed equation."""
        return [self.tree(member) for member in self.stage.relation(printed).members[:2]]

    def element(self, element: Element) -> Tree:
        """The tree of an element of the stage; it has to read back as the element."""
        ring, words = element.ring, self.stage.texts.vocabulary
        plain: list[Formula] = [Name(n) for n in ring.polynomials.generators]
        names = [*plain, *(self._generator(read(n, words), plain) for n in ring.roots)]
        terms = {
            (*exponents, *(mask >> bit & 1 for bit in range(len(ring.roots)))): value
            for mask, part in element.terms().items()
            for exponents, value in part.items()
        }
        below = [
            encode(self._plain(polynomial_formula(ring.polynomials.terms(ring.divisors[k]), plain)))
            for k, exponent in element.denominator.items()
            for _ in range(exponent)
        ]
        above = encode(self._plain(polynomial_formula(terms, names)))
        tree = ["/", above, *below] if below and above != 0 else above
        if not (scalar(decode(tree, self.mark), self.stage) - element).is_zero:
            raise CertificateError("an element does not read back as what was found")
        self.take(tree)
        return tree

    def _generator(self, root: Formula, plain: list[Formula]) -> Formula:
        """The generator of the ring by which a root is given, perhaps over a divisor."""
        value = scalar(root, self.stage)
        ring = value.ring
        below = ring.divisor_product(value.denominator)
        if below is None:
            return root
        (part,) = value.terms().values()
        ((_, factor),) = part.items()
        terms = {e: c / factor for e, c in ring.polynomials.terms(below).items()}
        return Product((polynomial_formula(terms, plain), root))

    def _plain(self, formula: Formula) -> Formula:
        """The formula in the operations of a certificate, which has one time and no Re or Im."""
        match formula:
            case RealPart(argument):
                inner = self._plain(argument)
                return Quotient(Sum((inner, Conjugate(inner))), Number(2))
            case ImaginaryPart(argument):
                inner = self._plain(argument)
                below = Product((Number(2), Name("i")))
                return Quotient(Sum((inner, Negative(Conjugate(inner)))), below)
            case Derivative(argument, mark):
                rate = Derivative(self._plain(argument), self.mark)
                if (self.stage.time_factor(mark, False) - self.stage.ring.one).is_zero:
                    return rate
                if self.scene.time == "t":
                    return Quotient(rate, self._per_time())
                return Product((self._per_time(), rate))
            case Application():
                return self._plain(self.stage.applied(formula))
            case Root() if (value := self._printed_value(formula)) is not None:
                return value
            case Power(Name(base), exponent) if not isinstance(exponent, Number):
                return self._symbolic(base, exponent)
            case Name(name) if name in self.stage.powers.values():
                return formula
        for place, child in enumerate(formula.children()):
            if (plain := self._plain(child)) != child:
                formula = replace(formula, (place,), plain)
        return formula

    def _printed_value(self, root: Formula) -> Formula | None:
        """What a place prints for a root that is no generator; its square is the radicand."""
        scene = self.scene
        printed = (n for n, place in scene.roots.items() if place and n.startswith(r"\sqrt"))
        name = next((n for n in printed if self._same(self.stage.formula(n), root)), None)
        if name is None or not isinstance(root, Root):
            return None
        value = self._plain(self.stage.definition(name))
        square = self.tree(Power(value, Number(2)))
        sides = [square, self.tree(root.argument)]
        if sides not in self.relations:
            self.relations.append(sides)
        return value

    def _same(self, left: Formula, right: Formula) -> bool:
        """Whether two formulas have the same value."""
        a, b = (evaluate(formula, self.stage) for formula in (left, right))
        pairs = zip(*(v if isinstance(v, Triple) else (v,) for v in (a, b)), strict=True)
        return all((x - y).is_zero for x, y in pairs)

    def _per_time(self) -> Formula:
        """The factor of the clock of the scene."""
        if self.scene.clock is None:
            raise CertificateError("a derivative is taken by a time that is not declared")
        right = self.stage.relation(self.scene.clock).members[1]
        if not isinstance(right, Product):
            raise CertificateError("the clock is no multiple of the time")
        rest = right.factors[:-1]
        return rest[0] if len(rest) == 1 else Product(rest)

    def _symbolic(self, base: str, exponent: Formula) -> Formula:
        """A power with a symbolic exponent, through the declared powers as names."""
        above: list[Formula] = []
        below: list[Formula] = []
        for symbol, multiple in linear_exponent(exponent).items():
            factor: Formula = Name(base)
            if symbol:
                factor = Name(self.stage.powers[base, symbol])
            (above if multiple > 0 else below).extend([factor] * abs(multiple))
        top = Number(1) if not above else above[0] if len(above) == 1 else Product(tuple(above))
        for factor in below:
            top = Quotient(top, factor)
        return top

    def value(self, tree: Tree) -> tuple[Element, ...]:
        """The components of the value of a tree; partial derivatives are the stage's own."""
        if isinstance(tree, str) and tree in self.meanings:
            return self.value(self.meanings[tree])
        if isinstance(tree, list) and tree[0] == "d":
            values = (along(v, {tree[1]: self.stage.ring.one}) for v in self.value(tree[2]))
            return tuple(values)
        if isinstance(tree, list) and uses(tree, "d"):
            op, first, *rest = tree[0], *(self.value(part)[0] for part in tree[1:])
            for other in rest:
                first = first + other if op == "+" else first * other
            if op not in ("+", "*", "-"):
                raise CertificateError(f"a partial derivative stands under {op}")
            return (-first if op == "-" else first,)
        value = evaluate(decode(tree, self.mark), self.stage)
        return tuple(value) if isinstance(value, Triple) else (value,)

    def difference(self, sides: list[Tree]) -> list[Element]:
        """The components of left minus right side."""
        left, right = map(self.value, sides)
        return [a - b for a, b in zip(left, right, strict=True)]

    # -- names -----------------------------------------------------------------

    def take(self, tree: Tree) -> None:
        """Declare what a tree uses."""
        for name in sorted(names_of(tree)):
            self.need(name)
        for argument in _radicands(tree):
            self._declare_root(argument)
        self.moving |= uses(tree, "D")

    def need(self, name: str) -> None:
        """Give a name its meaning, unless it has it already."""
        if name in self.known:
            return
        self.known.add(name)
        scene, stage = self.scene, self.stage
        if name == "i" and scene.unit is None:
            self.steps.append(["root", "i", ["-", 1]])
        elif name == "i" and scene.unit is not None:
            self._printed_root(name, scene.unit)
        elif (printed := scene.roots.get(name)) is not None:
            self._printed_root(name, printed)
        elif name in stage.powers.values():
            self._power(name)
        elif name in self._zero():
            self.steps.append(["let", name, 0])
        elif name in scene.definitions:
            self.let(name, self.tree(stage.definition(name)))
        elif name in scene.vectors:
            self.let(name, ["vector", *scene.vectors[name]])
        elif scene.component(name):
            self.let(name, self.element(scalar(Name(name), stage)))
        elif name not in (*scene.variables, *scene.constants, *scene.undefined):
            self._old(name)

    def let(self, name: str, tree: Tree) -> None:
        """Define a name."""
        self.take(tree)
        self.known.add(name)
        self.steps.append(["let", name, tree])

    def abbreviate(self, name: str, tree: Tree) -> None:
        """Define a name that the scene does not have."""
        if name not in self.known:
            self.let(name, tree)
            self.meanings[name] = tree

    def _old(self, name: str) -> None:
        """A variable of the scene from which this one is a change, by the inverse."""
        if self.source is None or name not in self.source.scene.variables:
            raise CertificateError(f"{name} has no meaning on the scene “{self.scene.name}”")
        self.let(name, self.source.inverse(self.stage)[name])

    def inverse(self, new: Stage) -> dict[str, Tree]:
        """The old variables through those of a change, as trees."""
        from kowalevski_cas.stage.change import Carrier

        change = new.scene.field
        if not isinstance(change, Change):
            raise CertificateError("there is no change of variables")
        carrier = Carrier(change, new)
        found = {}
        for name, element in carrier.inverse().items():
            generators = [Name(g) for g in carrier.bridge.polynomials.generators]
            unit: list[Formula] = [Name("i")] if carrier.bridge.roots else []
            terms = {
                (*exponents, *([mask] if unit else [])): value
                for mask, part in element.terms().items()
                for exponents, value in part.items()
            }
            found[name] = encode(polynomial_formula(terms, [*generators, *unit]))
        return found

    def _zero(self) -> set[str]:
        found: set[str] = set()
        for printed in self.scene.zero:
            for member in self.stage.relation(printed).members:
                if isinstance(member, Name):
                    found.update(self.scene.vectors.get(member.name, (member.name,)))
        return found

    def _printed_root(self, name: str, printed: Printed) -> None:
        """A root with the printed equation from which its square was found."""
        self.steps.append(["root", name, self.element(self.stage.square(name, printed))])
        sides = []
        for member in self.stage.relation(printed).members:
            try:
                scalar(member, self.stage)
            except StageError:
                continue
            sides.append(self.tree(member))
        self.relations.append([sides[0], sides[-1]])

    def _declare_root(self, argument: Tree) -> None:
        """The step for the root of an expression, which the scene declares."""
        value = scalar(decode(argument, self.mark), self.stage)
        for name, printed in self.scene.roots.items():
            root = self.stage.formula(name)
            if printed is not None or not isinstance(root, Root):
                continue
            if (scalar(root.argument, self.stage) - value).is_zero:
                if name not in self.known:
                    tree = self.tree(root.argument)
                    self.known.add(name)
                    self.steps.append(["root", name, tree])
                return
        raise CertificateError("a root is not declared")

    def _power(self, name: str) -> None:
        base, symbol = next(key for key, power in self.stage.powers.items() if power == name)
        self.need(base)
        self.need(symbol)
        self.powers.append((name, base, symbol))

    # -- the space -------------------------------------------------------------

    def close(self) -> None:
        """Declare what the field and the change need, and all conjugates."""
        for pair in self._conjugates():
            if self.known & {*pair}:
                for name in pair:
                    self.need(name)
        if not (self.moving or self.whole):
            return
        for name in self.scene.variables:
            self.need(name)
        for name, *_ in self.powers:
            self.need(name)
        if not self.moving:
            return
        if self.source is None:
            self.equations = list(self.equations_of_motion())
            return
        self.source.moving = True
        for name in self.source.scene.variables:
            self.need(name)
        change = self.scene.field
        if not isinstance(change, Change):
            raise CertificateError("there is no change of variables")
        source = self.source
        formulas = [source.sides(printed) for printed in change.formulas]
        kept = [n for n in self.scene.variables if n in source.scene.variables]
        right = source.stage.relation(change.time).members[1]
        if not isinstance(right, Product):
            raise CertificateError("the change of time is no multiple of t")
        rest = right.factors[:-1]
        self.change = {
            "old": source.index,
            "formulas": [*formulas, *([name, name] for name in kept)],
            "time": ["/", 1, source.tree(rest[0] if len(rest) == 1 else Product(rest))],
        }
        if "i" in source.known:
            self.need("i")

    def _conjugates(self) -> tuple[tuple[str, str], ...]:
        """The pairs of conjugate names; none if the unit is printed with another square."""
        unit, stage = self.scene.unit, self.stage
        odd = unit is not None and not (stage.square("i", unit) + stage.ring.one).is_zero
        return () if odd else self.scene.conjugates

    def equations_of_motion(self) -> Iterator[list[Tree]]:
        """The printed equations of motion: names, what multiplies the derivatives, right side."""
        printed_field = self.scene.field
        for printed in printed_field if isinstance(printed_field, tuple) else ():
            left, right = self.stage.relation(printed).members[:2]
            factors = left.factors if isinstance(left, Product) else (left,)
            rest = [f for f in factors if not isinstance(f, Derivative)]
            (name,) = (
                f.argument.name
                for f in factors
                if isinstance(f, Derivative) and isinstance(f.argument, Name)
            )
            names = self.scene.vectors.get(name, (name,))
            ones: Formula = Number(1) if names == (name,) else Vector((Number(1),) * len(names))
            factor = Product((*rest, ones)) if rest else ones
            for component in names:
                self.need(component)
            yield [list(names), self.tree(factor), self.tree(right)]

    def data(self) -> dict[str, Any]:
        """The space, as it stands in the certificate."""
        scene, roots = self.scene, {step[1] for step in self.steps if step[0] == "root"}
        plain = self.known - roots - {step[1] for step in self.steps if step[0] == "let"}
        variables = [n for n in scene.variables if n in plain]
        constants = [n for n in (*scene.constants, *scene.undefined) if n in plain]
        data: dict[str, Any] = {"variables": [*variables, *(n for n, *_ in self.powers)]}
        if constants:
            data["constants"] = constants
        if self.nonzero:
            data["nonzero"] = self.nonzero
        if self.steps:
            data["steps"] = self.steps
        if self.moving and self.source is not None:
            data["change"] = self.change
        elif self.moving:
            data["field"] = self.equations
        if self.moving and self.powers:
            data["field"] = data.get("field", []) + [
                [[name], base, ["*", symbol, name, ["D", base]]]
                for name, base, symbol in self.powers
            ]
        there = plain | roots
        if pairs := [list(pair) for pair in self._conjugates() if {*pair} <= there]:
            data["conjugates"] = pairs
        return data

    def point(self, at: AtPoint) -> dict[str, Any]:
        """The values of the names at an exact point."""
        squares: set[int] = set()
        values = []
        names = self.known - {step[1] for step in self.steps if step[0] == "let"}
        for name in sorted(names):
            if name == "i" and self.scene.unit is None:
                values.append([name, name])
                continue
            own = name in self.stage.generators
            value = scalar(Name(name) if own else self.stage.formula(name), self.stage)
            values.append([name, number_tree(at(value), squares)])
        return {"roots": sorted(squares), "values": values}


def _radicands(tree: Tree) -> Iterator[Tree]:
    if isinstance(tree, list):
        for part in tree[1:]:
            yield from _radicands(part)
        if tree[0] == "sqrt":
            yield tree[1]
