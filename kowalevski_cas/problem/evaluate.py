"""The meaning of formulas on a space, in a ring: a fold over the tree."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from copy import copy
from fractions import Fraction
from functools import cache, cached_property
from typing import Any

from kowalevski_cas.algebra.derivation import Field, along
from kowalevski_cas.algebra.polynomials import Polynomials, Terms
from kowalevski_cas.algebra.tower import Element, Ring
from kowalevski_cas.notation import (
    Conjugate,
    CrossProduct,
    Derivative,
    Diagonal,
    Formula,
    Name,
    Negative,
    Number,
    Partial,
    Power,
    Product,
    Quotient,
    Root,
    ScalarProduct,
    Sum,
    Vector,
    to_latex,
)
from kowalevski_cas.problem.space import (
    Adjoined,
    Equation,
    Let,
    Meaningless,
    Raised,
    Setting,
    generators,
)


class Triple(tuple[Element, ...]):
    """The components of a vector, or the diagonal of a matrix."""

    __slots__ = ()


Value = Element | Triple


class Evaluation:
    """A space in a ring: names have values there, formulas are evaluated, D differentiates.

    With ``ring`` and ``values`` it is the image of the space in another ring, in which
    some of its generators and roots take these values.
    """

    def __init__(
        self,
        setting: Setting,
        polynomials: type[Polynomials],
        ring: Ring | None = None,
        values: Mapping[str, Element] | None = None,
        others: Callable[[Setting], Evaluation] | None = None,
    ) -> None:
        self.setting = setting
        self.polynomials = polynomials
        self.names = generators(setting)
        own = ring is None
        self.ring: Ring = Ring(polynomials(self.names)) if ring is None else ring
        self._others = others
        self._values: dict[tuple[str, bool], Value] = {}
        self._open: set[tuple[str, bool]] = set()
        self._rates: Field | None = None
        self._moving = False
        self.roots: list[tuple[Element, Element]] = []
        """Radicands, and their roots."""
        given = {n: self.ring.generator(n) for n in self.names} if own else dict(values or {})
        for name, value in given.items():
            self._values[name, False] = value

    def adjoin_roots(self) -> Evaluation:
        """Give every root of the space its place in the ring, in the order of the space."""
        for name in self.setting.roots:
            self.scalar(Name(name))
        return self

    def binding(self, values: Mapping[str, Element]) -> Evaluation:
        """The same evaluation, in which some more names have values."""
        bound = copy(self)
        bound._values = {**self._values, **{(n, False): v for n, v in values.items()}}
        bound._open = set()
        return bound

    # -- names -------------------------------------------------------------------

    def value(self, name: str, conjugated: bool = False) -> Value:
        """The value of a name; raises :class:`Meaningless` if it has none."""
        key = (name, conjugated)
        if key not in self._values:
            if key in self._open:
                raise Meaningless(f"{name} is defined by itself", name)
            self._open.add(key)
            try:
                self._values[key] = self._defined(name, conjugated)
            finally:
                self._open.discard(key)
        return self._values[key]

    def _defined(self, name: str, conjugated: bool) -> Value:
        step = self.setting.step(name)
        if isinstance(step, Let):
            return self(step.formula, conjugated)
        if conjugated:
            return self._conjugate(name)
        if isinstance(step, Adjoined):
            return self._adjoin(name, self.scalar(step.square))
        raise Meaningless(f"{name} has no value here", name)

    def _adjoin(self, name: str, radicand: Element) -> Element:
        value = self.ring.zero if radicand.is_zero else self.ring.adjoin(name, radicand)
        self.roots.append((radicand, value))
        return value

    def _conjugate(self, name: str) -> Element:
        """The conjugate of a generator or a root: its partner, or itself if it is real."""
        for pair in self.setting.conjugates:
            if name in pair:
                return self.scalar(Name(pair[pair[0] == name]))
        own = self.scalar(Name(name))
        step = self.setting.step(name)
        if isinstance(step, Adjoined):
            if step.square == Negative(Number(1)):
                return -own
            if not (self.scalar(step.square, True) - self.scalar(step.square)).is_zero:
                raise Meaningless(f"nothing says what the conjugate of {name} is", name)
        return own

    def knows(self, formula: Formula) -> bool:
        """Whether a formula has a value."""
        try:
            self(formula)
        except Meaningless:
            return False
        return True

    # -- formulas ----------------------------------------------------------------

    def __call__(self, formula: Formula, conjugated: bool = False) -> Value:
        """The value of a formula, or of its complex conjugate.

        Raises :class:`Meaningless` if a name has no meaning, if vectors and scalars are
        mixed up, or if a denominator vanishes identically.
        """
        rule = _RULES.get(type(formula))
        if rule is None:
            raise Meaningless(f"{to_latex(formula)} has no value of its own")
        return rule(formula, self, conjugated)

    def scalar(self, formula: Formula, conjugated: bool = False) -> Element:
        """The value of a formula that has to be a scalar."""
        value = self(formula, conjugated)
        if isinstance(value, Triple):
            raise Meaningless(f"{to_latex(formula)} is a vector where a scalar is expected")
        return value

    def vector(self, formula: Formula, conjugated: bool = False) -> Triple:
        """The value of a formula that has to be a vector."""
        value = self(formula, conjugated)
        if not isinstance(value, Triple):
            raise Meaningless(f"{to_latex(formula)} is a scalar where a vector is expected")
        return value

    def components(self, formula: Formula) -> tuple[Element, ...]:
        """The value of a formula as a tuple of scalars."""
        value = self(formula)
        return tuple(value) if isinstance(value, Triple) else (value,)

    def pairs(self, equations: Sequence[Equation]) -> list[tuple[Element, Element]]:
        """The values of both sides, component by component."""
        found = []
        for left, right in equations:
            a, b = self.components(left), self.components(right)
            if len(a) != len(b):
                raise Meaningless("the sides of an equation are a vector and a scalar")
            found += list(zip(a, b, strict=True))
        return found

    def differences(self, equations: Sequence[Equation]) -> list[Element]:
        """The left sides minus the right sides, component by component."""
        return [left - right for left, right in self.pairs(equations)]

    def root(self, argument: Formula, conjugated: bool = False) -> Element:
        """The declared square root of an expression."""
        value = self.scalar(argument, conjugated)
        for square, root in self.roots:
            if (square - value).is_zero:
                return root
        raise Meaningless(f"no root of {to_latex(argument)} is declared here")

    def polynomial(self, formula: Sum) -> Element | None:
        """The value of a sum of monomials in generators, which is what searches find."""
        places = self._places
        terms: Terms = {}
        for term in formula.terms:
            monomial = _monomial(term, places)
            if monomial is None:
                return None
            exponents, value = monomial
            terms[exponents] = terms.get(exponents, Fraction(0)) + value
        return self.ring.from_terms({0: terms})

    @cached_property
    def _places(self) -> dict[str, int]:
        """Where generators that stand for themselves stand among those of the ring."""
        names = self.ring.polynomials.generators
        return {name: k for k, name in enumerate(names)} if names == self.names else {}

    # -- derivatives -------------------------------------------------------------

    @property
    def rates(self) -> Field:
        """The vector field: the derivative of each variable by the time of the space."""
        if self._rates is None:
            if self._moving:
                raise Meaningless("a derivative stands in the equations of motion themselves")
            self._moving = True
            try:
                self._rates = self._found_rates()
            finally:
                self._moving = False
        return self._rates

    def _found_rates(self) -> Field:
        setting = self.setting
        found = dict(self._carried()) if setting.change is not None else {}
        for row in setting.field:
            found.update(self._row(row.names, row.factor, row.force))
        variables = {*setting.variables, *self._moving_roots(found)}
        still = [name for name in setting.variables if name not in found]
        if still:
            raise Meaningless(f"no equation of motion for {still[0]}", still[0])
        for name in [name for name in found if name not in variables]:
            if not (along(self.scalar(Name(name)), found) - found[name]).is_zero:
                raise Meaningless(f"{name} does not move as its equation of motion says", name)
            del found[name]
        for name in [name for name in found if name in setting.roots]:
            found[name] = self._rate_of_generator(name, found)
        for name in setting.powers:
            step = setting.step(name)
            assert isinstance(step, Raised)
            base = self.scalar(step.base)
            rate = along(base, found) * base.inverse()
            found[name] = rate * self.scalar(Name(step.exponent)) * self.ring.generator(name)
        return found

    def _moving_roots(self, rates: Mapping[str, Element]) -> Iterator[str]:
        return (name for name in rates if name in self.setting.roots)

    def _row(
        self, names: tuple[str, ...], factor: Formula, force: Formula
    ) -> Iterator[tuple[str, Element]]:
        below, above = self.components(factor), self.components(force)
        if not len(names) == len(above) == len(below):
            raise Meaningless(f"vectors and scalars are mixed up in the motion of {names[0]}")
        for name, numerator, divisor in zip(names, above, below, strict=True):
            yield name, numerator / divisor

    def _carried(self) -> Iterator[tuple[str, Element]]:
        """The rates of new variables by the chain rule."""
        change = self.setting.change
        assert change is not None
        old = self.other(change.old)
        time = self.image(old.scalar(change.time))
        for name, formula in change.formulas:
            yield name, self.image(old.derivative(old.scalar(formula))) * time

    def other(self, setting: Setting) -> Evaluation:
        """The evaluation of a space on which this one is built."""
        if self._others is None:
            return Evaluation(setting, self.polynomials).adjoin_roots()
        return self._others(setting)

    @cached_property
    def granted(self) -> list[Element]:
        """What does not vanish here; nor where a change comes from, as far as it is known here."""
        found = [self.scalar(formula) for formula in self.setting.nonzero]
        change = self.setting.change
        for element in () if change is None else self.other(change.old).granted:
            with suppress(Meaningless):
                found.append(self.image(element))
        return found

    @cached_property
    def time_sign(self) -> int:
        """1 if the time of the space is real, −1 if a change has made it imaginary."""
        change = self.setting.change
        if change is None:
            return 1
        old = self.other(change.old)
        time, bar = old.scalar(change.time), old.scalar(change.time, True)
        for sign in (1, -1):
            if (bar - time * old.ring.number(sign)).is_zero:
                return sign
        raise Meaningless("the time of a change is neither real nor imaginary")

    def _rate_of_generator(self, name: str, rates: Field) -> Element:
        """The derivative of the generator that gives a moving root, perhaps over a divisor."""
        value = self.scalar(Name(name))
        below = self.ring.divisor_product(value.denominator)
        if below is None:
            return rates[name]
        (part,) = value.parts.values()
        factor = self.ring.element({0: below}, {}) / self.ring.element({0: part}, {})
        return rates[name] * factor + value * along(factor, rates)

    def derivative(self, element: Element) -> Element:
        """The derivative along the field."""
        return along(element, self.rates)

    def partial(self, element: Element, name: str) -> Element:
        """The partial derivative by a generator."""
        if name not in self.names and name not in self.ring.roots:
            raise Meaningless(f"{name} is no variable here", name)
        return along(element, {name: self.ring.one})

    # -- maps --------------------------------------------------------------------

    def image(self, element: Element, value_of: Callable[[str], Element] | None = None) -> Element:
        """The image of an element of another ring, whose generators are names of this space.

        ``value_of`` gives the images of its generators and roots instead.
        """
        ring = element.ring
        value_of = cache(value_of or (lambda name: self.scalar(Name(name))))
        names = ring.polynomials.generators
        total = self.ring.zero
        for mask, terms in element.terms().items():
            value = self._substituted(terms, names, value_of)
            for bit, root in enumerate(ring.roots):
                if mask >> bit & 1:
                    value = value * value_of(root)
                    if (below := ring.below[bit]) is not None:
                        value = value * self.image(below, value_of)
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


def _monomial(
    formula: Formula, places: Mapping[str, int]
) -> tuple[tuple[int, ...], Fraction] | None:
    """The exponents and the coefficient of a product of numbers and powers of generators."""
    value = Fraction(1)
    if isinstance(formula, Negative):
        value, formula = -value, formula.argument
    exponents = [0] * len(places)
    for factor in formula.factors if isinstance(formula, Product) else (formula,):
        power = 1
        if isinstance(factor, Power) and isinstance(factor.exponent, Number):
            power, factor = factor.exponent.value, factor.base
        if isinstance(factor, Number):
            value *= factor.value**power
        elif isinstance(factor, Name) and factor.name in places:
            exponents[places[factor.name]] += power
        else:
            return None
    return tuple(exponents), value


# -- rules -----------------------------------------------------------------------


def multiply(left: Value, right: Value) -> Value:
    """The product of scalars, of a scalar and a vector, or of a diagonal matrix and a vector."""
    if isinstance(left, Triple) and isinstance(right, Triple):
        return Triple(a * b for a, b in zip(left, right, strict=True))
    if isinstance(left, Triple):
        assert isinstance(right, Element)
        return Triple(a * right for a in left)
    if isinstance(right, Triple):
        return Triple(left * b for b in right)
    return left * right


def _add(left: Value, right: Value) -> Value:
    if isinstance(left, Triple) and isinstance(right, Triple):
        return Triple(a + b for a, b in zip(left, right, strict=True))
    if isinstance(left, Triple) or isinstance(right, Triple):
        raise Meaningless("a vector is added to a scalar")
    return left + right


def _each(value: Value, function: Callable[[Element], Element]) -> Value:
    return Triple(map(function, value)) if isinstance(value, Triple) else function(value)


def _sum(formula: Sum, at: Evaluation, bar: bool) -> Value:
    if not bar and (polynomial := at.polynomial(formula)) is not None:
        return polynomial
    first, *rest = (at(term, bar) for term in formula.terms)
    for value in rest:
        first = _add(first, value)
    return first


def _product(formula: Product, at: Evaluation, bar: bool) -> Value:
    first, *rest = (at(factor, bar) for factor in formula.factors)
    for value in rest:
        first = multiply(first, value)
    return first


def _inverse(element: Element, formula: Formula) -> Element:
    try:
        return element.inverse()
    except ZeroDivisionError:
        shown = to_latex(formula)
        raise Meaningless(f"division by {shown}, which vanishes identically") from None


def _quotient(formula: Quotient, at: Evaluation, bar: bool) -> Value:
    value = at(formula.numerator, bar)
    for divisor, exponent in divisors_of(formula.denominator):
        below = at(divisor, bar)
        if isinstance(below, Triple):
            inverse: Value = Triple(_inverse(entry, divisor) for entry in below)
        else:
            inverse = _inverse(below, divisor) ** exponent
        value = multiply(value, inverse)
    return value


def divisors_of(formula: Formula) -> Iterator[tuple[Formula, int]]:
    """The factors of a denominator as it is printed, with exponents."""
    match formula:
        case Product(factors):
            for factor in factors:
                yield from divisors_of(factor)
        case Power(base, Number(exponent)):
            yield base, exponent
        case _:
            yield formula, 1


def _power(formula: Power, at: Evaluation, bar: bool) -> Value:
    base = at.scalar(formula.base, bar)
    match formula.exponent:
        case Number(exponent):
            return base**exponent
        case Negative(Number(exponent)):
            return _inverse(base, formula.base) ** exponent
    raise Meaningless(f"{to_latex(formula.exponent)} is no exponent that can be used here")


def _scalar_product(formula: ScalarProduct, at: Evaluation, bar: bool) -> Value:
    left, right = (at.vector(f, bar) for f in (formula.left, formula.right))
    total = at.ring.zero
    for a, b in zip(left, right, strict=True):
        total = total + a * b
    return total


def _cross_product(formula: CrossProduct, at: Evaluation, bar: bool) -> Value:
    (a1, a2, a3), (b1, b2, b3) = (at.vector(f, bar) for f in (formula.left, formula.right))
    return Triple((a2 * b3 - a3 * b2, a3 * b1 - a1 * b3, a1 * b2 - a2 * b1))


def _derivative(formula: Derivative, at: Evaluation, bar: bool) -> Value:
    rate = _each(at(formula.argument, bar), at.derivative)
    if bar and at.time_sign < 0:
        return _each(rate, lambda element: -element)
    return rate


_RULES: dict[type[Formula], Callable[[Any, Evaluation, bool], Value]] = {
    Number: lambda f, at, _: at.ring.number(f.value),
    Name: lambda f, at, bar: at.value(f.name, bar),
    Sum: _sum,
    Negative: lambda f, at, bar: _each(at(f.argument, bar), lambda element: -element),
    Product: _product,
    Quotient: _quotient,
    Power: _power,
    Root: lambda f, at, bar: at.root(f.argument, bar),
    Derivative: _derivative,
    Partial: lambda f, at, bar: _each(
        at(f.argument, bar), lambda element: at.partial(element, f.by)
    ),
    Conjugate: lambda f, at, bar: at(f.argument, not bar),
    Vector: lambda f, at, bar: Triple(at.scalar(entry, bar) for entry in f.components),
    Diagonal: lambda f, at, bar: Triple(at.scalar(entry, bar) for entry in f.entries),
    ScalarProduct: _scalar_product,
    CrossProduct: _cross_product,
}


def rational_terms(element: Element) -> Fraction | None:
    """The value of an element that is a rational number; ``None`` if it is none."""
    parts = element.terms()
    if not parts:
        return Fraction(0)
    if element.denominator or parts.keys() != {0} or any(map(any, parts[0])):
        return None
    (value,) = parts[0].values()
    return value
