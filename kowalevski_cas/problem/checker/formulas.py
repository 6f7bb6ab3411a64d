"""What formulas mean: values, derivatives, conjugates."""

from __future__ import annotations

import copy
from fractions import Fraction
from typing import Self

from .division import Divisors
from .polynomials import Element, Ring
from .reading import Json, Rejected, exponent, label, need, operation, pairs

Value = tuple[Element, ...]  # a number, or the components of a vector
Rates = dict[str, Element]


class Map:
    """What elements of a ring become among formulas where its generators have values."""

    def __init__(self, ring: Ring, images: dict[str, Element], space: Formulas) -> None:
        self.ring, self.images, self.space = ring, images, space
        self.monomials: dict[int, Element] = {}
        for name in (n for n in ring.roots if n in images):
            square = ring.roots[name]
            rest = images[name] * images[name] - self(square)
            need(rest.vanishes(), f"{name} does not keep its square")
        for name in (n for n in ring.powers if n in images):
            base, power = ring.powers[name]
            same = space.is_power(images[name], self(base), self(power))
            need(same, f"{name} may be no power of its base")

    def __call__(self, element: Element) -> Element:
        parts = [(c, self.monomial(m)) for m, c in element.terms.items()]
        whole = self.space.ring.combination(parts, element.below)
        return whole * self.monomial(element.under) if element.under else whole

    def monomial(self, monomial: int) -> Element:
        """What a product of generators becomes."""
        if monomial not in self.monomials:
            powers = self.ring.exponents(monomial)
            images = [image for name, e in powers for image in [self.image(name)] * e]
            whole = images[0] if len(images) == 1 else self.space.ring.product(images)
            self.monomials[monomial] = whole
        return self.monomials[monomial]

    def image(self, name: str) -> Element:
        if name not in self.images:
            need(name in self.ring.divisors, f"{name} has no value")
            self.images[name] = self.space.inverse(self(self.ring.divisors[name]))
        return self.images[name]


class Formulas(Divisors):
    """Names with values, among them roots and powers.

    ``env`` has the values of names, ``bar`` the conjugates of generators, ``rates`` the vector
    field.
    """

    def __init__(self, ring: Ring, variables: list[str], constants: list[str]) -> None:
        super().__init__(ring)
        self.variables, self.constants = variables, constants
        self.env: dict[str, Value] = {}
        self.bar: dict[str, Element] = {}
        self.mirror: Map | None = None
        self.rates: Rates | None = None
        self.waiting: set[str] = set()  # variables that have no rate yet

    def local(self) -> Self:
        """A copy for one goal: what the goal brings in is forgotten with it."""
        other = copy.copy(self)
        self.ring.spend(1 + (len(self.env) >> 2))
        other.env, other.known, other.norms = dict(self.env), dict(self.known), {*self.norms}
        other.entered = [*self.entered]
        other.implied, other.used = {*self.implied}, {*self.used}
        other.rates = None if self.rates is None else dict(self.rates)
        return other

    def exact(self) -> Self:
        """A copy that divides by no norm: it may hold the whole of what is looked at."""
        other = self.local()
        other.known = {name: words for name, words in self.known.items() if name not in self.norms}
        return other

    def carried(self, ring: Ring, images: dict[str, Element]) -> Map:
        """What elements of a ring become here, where its generators have values."""
        return Map(ring, images, self)

    def bind(self, name: Json) -> tuple[str, Element]:
        """A new generator for a name that is bound in a goal."""
        bound = f":{label(name)}"
        need(name not in self.env, "a bound name has another meaning")
        if bound not in self.ring.at:
            self.ring.adjoin(bound)
        self.env[name] = (self.ring.generator(bound),)
        return bound, self.ring.generator(bound)

    # values

    def scalar(self, tree: Json) -> Element:
        """The value of a formula that is no vector."""
        value = self.value(tree)
        need(len(value) == 1, "a number is expected, no vector")
        return value[0]

    def value(self, tree: Json) -> Value:
        """The value of a formula."""
        if type(tree) is int:
            return (self.ring.number(tree),)
        if type(tree) is str:
            if tree in self.env:
                return self.env[tree]
            raise Rejected(f"{tree:.80} is not defined")
        op, parts = operation(tree)
        self.ring.spend(len(tree))
        if op == "^":
            return (self.scalar(parts[0]) ** exponent(parts[1]),)
        if op == "d":
            return (self.partial(*parts),)
        values = [*map(self.value, parts[:1] if op == "/" else parts)]
        values += map(self.over, parts[1:] if op == "/" else ())
        sizes = {*map(len, values)}
        if op in ("vector", "diag"):
            need(sizes == {1}, "a number is expected, no vector")
            return tuple(value for (value,) in values)
        if len(values) == 1:
            return tuple([self.unary(op, e) for e in values[0]])
        if op == "+":
            need(len(sizes) == 1, "a number is added to a vector")
            return tuple(map(self.ring.total, zip(*values, strict=True)))
        return self.multiplied(op, values, max(sizes))

    def over(self, tree: Json) -> Value:
        """One over the value of a formula; of a power it is a power."""
        if type(tree) is list and tree[:1] == ["^"]:
            base, n = operation(tree)[1]
            if exponent(n):
                return (self.inverse(self.scalar(base)) ** exponent(n),)
        return tuple(map(self.inverse, self.value(tree)))

    def unary(self, op: str, element: Element) -> Element:
        """An operation on a component."""
        if op == "-":
            return -element
        if op == "D":
            return self.derivative(element)
        if op == "conj":
            return self.conj(element)
        for name in sorted(self.ring.roots, key=lambda name: not name.startswith("\\sqrt")):
            if (self.ring.roots[name] - element).vanishes():
                return self.scalar(name)
        raise Rejected("a root is taken that is not declared")

    def multiplied(self, op: str, values: list[Value], size: int) -> Value:
        """A product, by components, or one of vectors."""
        rows = [v * size if len(v) == 1 else v for v in values]
        need({*map(len, rows)} == {size}, "vectors have different lengths")
        if op == "cross":
            need({*map(len, values)} == {3}, "a vector product is one of vectors in space")
            a, b = values
            return tuple(a[j] * b[k] - a[k] * b[j] for j, k in ((1, 2), (2, 0), (0, 1)))
        products = tuple(map(self.ring.product, zip(*rows, strict=True)))
        if op == "dot":
            need({*map(len, values)} == {size} != {1}, "a scalar product is one of two vectors")
            return (self.ring.total(products),)
        return products

    def differences(self, equations: Json) -> list[Element]:
        """Left minus right sides, by components."""
        both = [(self.value(left), self.value(right)) for left, right in pairs(equations)]
        need(all(len(a) == len(b) for a, b in both), "a number is equal to a vector")
        return [x - y for a, b in both for x, y in zip(a, b, strict=True)]

    # derivatives

    def along(self, element: Element, rates: Rates) -> Element:
        """The derivative; what has no rate is constant, or follows from its relation."""
        found = list[Element]()
        for name in element.written():
            if name not in rates:
                rates[name] = self._rate(name, rates)
            if rates[name].terms:
                found.append(element.partial(name) * rates[name])
        return self.ring.total(found)

    def _rate(self, name: str, rates: Rates) -> Element:
        """The derivative of a generator without a rate of its own."""
        ring = self.ring
        need(name not in ring.unknown, f"{name} is unknown, and so is its derivative")
        need(name not in self.waiting, f"the derivative of {name} is not known yet")
        if not (name in ring.divisors or name in ring.powers or name in ring.roots):
            return ring.number(0)
        generator = ring.generator(name)
        if name in ring.divisors:
            return -generator * generator * self.along(ring.divisors[name], rates)
        if name in ring.powers:
            base, power = ring.powers[name]
            return power * generator * self.along(base, rates) * self.inverse(base)
        change = self.along(ring.roots[name], rates)
        if not change.terms:
            return change
        half = change.partial(name) * ring.number(Fraction(1, 2))
        if (change - generator * (half + half)).vanishes():
            return half
        return change * generator * self.inverse(generator * generator + generator * generator)

    def derivative(self, element: Element) -> Element:
        """The derivative along the vector field; where there are no variables, all is constant."""
        need(self.rates is not None or not self.variables, "there is no vector field")
        return self.along(element, self.rates or {})

    def partial(self, name: Json, tree: Json) -> Element:
        """A partial derivative; other variables and constants stay."""
        need(type(name) is str and name in self.bar, "it is no variable")
        related = {*self.ring.roots, *self.ring.powers}
        related |= {n for _, power in self.ring.powers.values() for n in power.generators()}
        need(name not in related, f"{name} is no variable")
        fixed = dict.fromkeys((*self.variables, *self.constants), self.ring.number(0))
        return self.along(self.scalar(tree), fixed | {name: self.ring.number(1)})

    # conjugates and powers

    def conj(self, element: Element) -> Element:
        """The complex conjugate; that of a divisor does not vanish either."""
        if element.value() is not None:
            return element
        conjugate = self.reflection()(element)
        for name in conjugate.generators():
            known = name in self.env or name in self.ring.divisors
            need(known, "a conjugate is not defined yet")
        return conjugate

    def reflection(self) -> Map:
        """The conjugation: an involution, under which roots and powers keep what they are."""
        if self.mirror is None:
            space = self.local()
            space.stating = True
            self.mirror = space.carried(self.ring, dict(self.bar))
        return self.mirror

    def is_real(self, element: Element) -> bool:
        """Whether an element is its own conjugate."""
        return (self.conj(element) - element).vanishes()

    def all_real(self) -> bool:
        """Whether all names are."""
        return all(e.is_generator(name) for name, e in self.bar.items())

    def is_power(self, value: Element, base: Element, power: Element) -> bool:
        """Whether a value is known to be a power: this very generator, or a power of 1."""
        for name, (own, to) in self.ring.powers.items():
            if value.is_generator(name):
                return (own - base).vanishes() and (to - power).vanishes()
        return value.value() == base.value() == 1


def rational(formulas: Formulas, tree: Json) -> Fraction:
    """The value of a formula of integers."""
    formulas.ring.spend(20)
    number = Formulas(Ring(formulas.ring.budget), [], []).scalar(tree).value()
    if number is None:
        raise Rejected("a rational number is expected")
    return number
