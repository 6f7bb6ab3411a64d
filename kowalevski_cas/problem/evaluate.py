"""A space in a ring: what its names, its roots and its motion are there."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from copy import copy
from functools import cache, cached_property
from typing import Any

from kowalevski_cas.algebra.derivation import Field, along
from kowalevski_cas.algebra.numbers import substitute
from kowalevski_cas.algebra.polynomials import Polynomials, Terms
from kowalevski_cas.algebra.present import formula_in
from kowalevski_cas.algebra.tower import Element, Ring, indices_below
from kowalevski_cas.notation import Formula, Name, Negative, Number, to_latex
from kowalevski_cas.problem.fold import Fold, Value
from kowalevski_cas.problem.space import (
    Adjoined,
    Equation,
    EquationOfMotion,
    Let,
    Meaningless,
    Raised,
    Setting,
    Space,
    Step,
    generators,
)


class Evaluation(Fold):
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
        fresh = ring is None
        self.ring: Ring = Ring(polynomials(self.names)) if ring is None else ring
        self._others = others
        self._values: dict[tuple[str, bool], Value] = {}
        self._pairs: dict[Equation, list[tuple[Element, Element]]] = {}
        self._open: set[tuple[str, bool]] = set()
        self._rates: Field | None = None
        self._directions: dict[str, Field] = {}
        self._below: dict[int, Formula] = {}
        self._moving = False
        self.bound: frozenset[str] = frozenset()
        """The names that have a value here and no meaning in the space."""
        self.places: dict[Hashable, Any] = {}
        """What is known of points, by their values."""
        self.roots: dict[str, Element] = {}
        """Radicands, by the names of their roots."""
        given = {n: self.ring.generator(n) for n in self.names} if fresh else dict(values or {})
        self.letters = {name: place for place, name in enumerate(self.names)} if fresh else {}
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
        bound._pairs, bound._open = {}, set()
        bound.bound = self.bound | values.keys()
        bound.letters = {} if self.letters.keys() & values.keys() else self.letters
        return bound

    def pairs(self, equations: Sequence[Equation]) -> list[tuple[Element, Element]]:
        """The values of both sides, component by component; those of an equation are kept."""
        for equation in equations:
            if equation not in self._pairs:
                self._pairs[equation] = super().pairs([equation])
        return [pair for equation in equations for pair in self._pairs[equation]]

    # -- names -------------------------------------------------------------------

    def value(self, name: str, conjugated: bool = False) -> Value:
        """The value of a name; raises :class:`Meaningless` if it has none."""
        key = (name, conjugated)
        if key not in self._values:
            if key in self._open:
                raise Meaningless(f"{name} is defined by itself", name)
            self._open.add(key)
            try:
                self._values[key] = self._define(name, conjugated)
            finally:
                self._open.discard(key)
        return self._values[key]

    def _define(self, name: str, conjugated: bool) -> Value:
        step = self.setting.step(name)
        if isinstance(step, Let):
            return self(step.formula, conjugated)
        return self._given(name, step, conjugated)

    def _given(self, name: str, step: Step | None, conjugated: bool) -> Value:
        """The value of a name that stands for itself."""
        if conjugated:
            return self._conjugate(name)
        if isinstance(step, Adjoined):
            return self._adjoin(name, self.scalar(step.square))
        raise Meaningless(f"{name} has no value here", name)

    def _adjoin(self, name: str, radicand: Element) -> Element:
        value = radicand if radicand.is_zero else self.ring.adjoin(name, radicand)
        if self.letters and not value.denominator and not value.is_zero:
            self.letters[name] = self.ring.names.index(name)
        self.roots[name] = radicand
        return value

    def _conjugate(self, name: str) -> Element:
        """The conjugate of a generator or a root: its partner, or itself if it is real."""
        for pair in self.setting.conjugates:
            if name in pair:
                return self.scalar(Name(pair[pair[0] == name]))
        value = self.scalar(Name(name))
        step = self.setting.step(name)
        if isinstance(step, Adjoined):
            if step.square == Negative(Number(1)):
                return -value
            if not (self.scalar(step.square, True) - self.scalar(step.square)).is_zero:
                raise Meaningless(f"nothing says what the conjugate of {name} is", name)
        return value

    def knows(self, formula: Formula) -> bool:
        """Whether a formula has a value."""
        try:
            self(formula)
        except Meaningless:
            return False
        return True

    def root(self, argument: Formula, conjugated: bool = False) -> Element:
        """The declared square root of an expression, which remembers what that is divided by.

        Its conjugate is that of the root by its name: of two roots of the conjugate of the
        expression it is one, and nothing but a declared pair says which.
        """
        value = self.scalar(argument)
        root = self.scalar(Name(self._roots_of(value, argument)[0]), conjugated)
        return root + (self.scalar(argument, conjugated) if conjugated else value) * self.ring.zero

    def root_name(self, argument: Formula) -> str:
        """The name of the declared square root of an expression, the first one of several."""
        return self.root_names(argument)[0]

    def root_names(self, argument: Formula) -> list[str]:
        """The names of all declared square roots of an expression; a printed root comes first."""
        return self._roots_of(self.scalar(argument), argument)

    def _roots_of(self, value: Element, argument: Formula) -> list[str]:
        # A printed root is not negative; a name with the same square may be.
        names = sorted(self.roots, key=lambda name: not name.startswith(r"\sqrt"))
        squares = ((name, self.roots[name]) for name in names)
        if found := [name for name, of in squares if of is value or (of - value).is_zero]:
            return found
        raise Meaningless(f"no root of {to_latex(argument)} is declared here")

    # -- derivatives -------------------------------------------------------------

    def moving(self, rates: Field, rows: Sequence[EquationOfMotion]) -> Evaluation:
        """The same evaluation, in which these are the rates, with those that rows give."""
        bound = copy(self)
        bound._values, bound._pairs = dict(self._values), {}
        bound._rates = dict(rates)
        for row in rows:
            bound._rates.update(bound._row(row.names, row.factor, row.force))
        return bound

    @property
    def rates(self) -> Field:
        """The vector field: the derivative of each variable by the time of the space."""
        if self._rates is None:
            if self._moving:
                raise Meaningless("a derivative stands in the equations of motion themselves")
            self._moving = True
            try:
                self._rates = self._solve_for_rates()
                _ = self.time_sign
            except Meaningless:
                self._rates = None  # whoever asks again is refused again
                raise
            finally:
                self._moving = False
        return self._rates

    def _solve_for_rates(self) -> Field:
        setting = self.setting
        found = dict(self._carry()) if setting.change is not None else {}
        for row in setting.field:
            found.update(self._row(row.names, row.factor, row.force))
        variables = {*setting.variables, *setting.roots}
        still = [name for name in setting.variables if name not in found]
        if still:
            raise Meaningless(f"no equation of motion for {still[0]}", still[0])
        for name in [name for name in found if name not in variables]:
            if not (along(self.scalar(Name(name)), found) - found[name]).is_zero:
                raise Meaningless(f"{name} does not move as its equation of motion says", name)
            del found[name]
        moving = [name for name in found if name in setting.roots]
        for name in moving:
            found[name] = self._rate_of_generator(name, found)
        for name in moving:
            self._check_root(name, found)
        return self._with_powers(found)

    def _with_powers(self, rates: Field) -> Field:
        """A field with the rates of powers of what moves by it."""
        field = {**rates}
        for name in self.setting.powers:
            step = self.setting.step(name)
            assert isinstance(step, Raised)
            base = self.scalar(step.base)
            if not (change := along(base, field)).is_zero:
                rate = change * base.inverse()
                field[name] = rate * self.scalar(Name(step.exponent)) * self.ring.generator(name)
        return field

    @cached_property
    def time_sign(self) -> int:
        """1 if the time is real, −1 if it is imaginary, by what the motion makes of conjugates.

        Raises :class:`Meaningless` for a motion that does not keep the conjugation.
        """
        if not self.setting.conjugates and "i" not in self.setting.roots:
            return 1
        names = [(name, self.scalar(Name(name), True)) for name in self.setting.variables]
        for sign in (1, -1):
            rates = {name: rate * self.ring.number(sign) for name, rate in self.rates.items()}
            if all(
                (
                    self.image(rates[n], lambda name: self.scalar(Name(name), True))
                    - along(b, self.rates)
                ).is_zero
                for n, b in names
            ):
                return sign
        raise Meaningless(
            "the equations of motion do not agree with the conjugation: mend the pairs, or the time"
        )

    def _check_root(self, name: str, rates: Field) -> None:
        """Refuse an equation of motion of a root that is not that of its square."""
        step, root = self.setting.step(name), self.scalar(Name(name))
        assert isinstance(step, Adjoined)
        twice = root * self.ring.number(2)
        if not (along(self.scalar(step.square), rates) - twice * along(root, rates)).is_zero:
            raise Meaningless(f"{name} does not move as its square does", name)

    def _row(
        self, names: tuple[str, ...], factor: Formula, force: Formula
    ) -> Iterator[tuple[str, Element]]:
        below, above = self.components(factor), self.components(force)
        if not len(names) == len(above) == len(below):
            raise Meaningless(f"vectors and scalars are mixed up in the motion of {names[0]}")
        for name, numerator, divisor in zip(names, above, below, strict=True):
            yield name, numerator / divisor

    def _carry(self) -> Iterator[tuple[str, Element]]:
        """The rates of new variables by the chain rule."""
        change = self.setting.change
        assert change is not None
        old = self.other(change.old)
        time = self.image(old.scalar(change.time))
        for name, formula in change.formulas:
            yield name, self.image(old.derivative(old.scalar(formula))) * time

    @cached_property
    def law(self) -> list[Element]:
        """The rates of all names that move, with what stands before them, and one over that.

        So the motion is defined where all of them are. After a change these are the images of
        what they were, the new rates, and one over the factor of the time.
        """
        if (change := self.setting.change) is not None:
            old = self.other(change.old)
            before = [*map(self.image, old.law), self.image(old.scalar(change.time)).inverse()]
            return [*before, *self.rates.values()]
        factors = (self.components(row.factor) for row in self.setting.field)
        masses = [factor for row in factors for mass in row for factor in (mass, mass.inverse())]
        return [*masses, *self.rates.values()]

    def other(self, setting: Setting) -> Evaluation:
        """The evaluation of a space on which this one is built."""
        if self._others is None:
            return Evaluation(setting, self.polynomials).adjoin_roots()
        return self._others(setting)

    @cached_property
    def granted(self) -> list[Element]:
        """What does not vanish here; nor where a change comes from, as far as it is known here."""
        setting = self.setting
        found = [*map(self.scalar, setting.nonzero)]
        change = setting.change
        for element in () if change is None else self.other(change.old).granted:
            with suppress(Meaningless):
                found.append(self.image(element))
        return found

    @cached_property
    def hypotheses(self) -> list[Element]:
        """What a space supposes beside its goals: what roots are taken of, and what is granted."""
        if not isinstance(self.setting, Space):
            return []
        return [*self.roots.values(), *map(self.scalar, self.setting.nonzero)]

    @cached_property
    def defined(self) -> list[Element]:
        """What is defined at each point of a space, whatever its goals are about."""
        steps = self.setting.steps if isinstance(self.setting, Space) else ()
        lets = [Name(step.name) for step in steps if isinstance(step, Let)]
        return [*(element for name in lets for element in self.components(name)), *self.hypotheses]

    @property
    def norms(self) -> list[Element]:
        """The norms of what is granted with roots: by these it is divided, if it ever is."""
        with_roots = (element for element in self.granted if element.parts.keys() - {0})
        return self.ring.divisors_of([element.inverse() for element in with_roots])

    def divisor_formulas(self, elements: Iterable[Element]) -> list[Formula]:
        """What elements of the ring are divided by; the formula of a divisor is made once."""
        indices = indices_below(elements)
        for index in indices:
            if index not in self._below:
                self._below[index] = formula_in(self.ring.divisor_at(index))
        return [self._below[index] for index in indices]

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
        # One field for each name: what is known of a motion along it is known by its identity.
        if name not in self._directions:
            self._directions[name] = self._with_powers({name: self.ring.one})
        return along(element, self._directions[name])

    # -- maps --------------------------------------------------------------------

    def image(self, element: Element, value_of: Callable[[str], Element] | None = None) -> Element:
        """The image of an element of another ring, whose generators are names of this space.

        ``value_of`` gives the images of its generators and roots instead.
        """
        ring = element.ring
        value_of = cache(value_of or (lambda name: self.scalar(Name(name))))
        names = ring.polynomials.generators

        def polynomial(terms: Terms) -> Element:
            return substitute(terms, lambda place: value_of(names[place]), self.ring)

        total = self.ring.zero
        for mask, terms in element.terms().items():
            value = polynomial(terms)
            for bit, root in enumerate(ring.roots):
                if mask >> bit & 1:
                    value = value * value_of(root)
                    if (below := ring.below[bit]) is not None:
                        value = value * self.image(below, value_of)
            total = total + value
        for index, exponent in element.denominator.items():
            below = polynomial(ring.polynomials.terms(ring.divisors[index]))
            total = total * below**-exponent + below * self.ring.zero
        return total
