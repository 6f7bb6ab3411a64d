r"""Values of formulas at a sample: each name, and each of its derivatives, has a number of its own.

What is printed of :math:`\ddot r` and :math:`\frac{d^2u}{d\theta^2}` can be compared so without any
law: where a name is given by others its derivatives are those of what gives it, and else they are
free. Vectors and matrices have one component: what fails there is false.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from contextlib import AbstractContextManager
from math import prod

from flint import acb, ctx

from kowalevski_cas.algebra.keys import (
    PARTIAL,
    Key,
    is_initial,
    key_of,
    rate_of,
    rated,
    variable_of,
)
from kowalevski_cas.algebra.quadrature import ANY_NODES, INFINITE, INTEGRAL, nodes
from kowalevski_cas.notation import (
    Application,
    Derivative,
    Formula,
    Modulus,
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
)
from kowalevski_cas.notation.functions import FUNCTIONS
from kowalevski_cas.notation.symbol import name_of_rate

BITS = 300
"""The precision of values."""
DEGREE = 4
"""So many derivatives has a function of which nothing is known."""
DIGITS = 30
"""So many digits say at which value an unknown function is taken."""
_STEP = 2.0**-70
"""By how much something is moved to find a derivative."""
_SMALL = 2.0**-40
"""What is nearer to zero than this, of values of about one, is zero."""
_ROUGHLY = 2.0**-16
"""The sums over every second value of an integrand are as near, unless it has a pole."""
_NOTHING = 2.0**-150
"""By what is nearer to zero than this nothing is divided."""

_FUNCTIONS: Mapping[str, Callable[[acb], acb]] = {
    r"\sin": acb.sin,
    r"\cos": acb.cos,
    r"\tan": acb.tan,
    r"\exp": acb.exp,
    r"\ln": acb.log,
    r"\log": acb.log,
    r"\sinh": acb.sinh,
    r"\cosh": acb.cosh,
    r"\tanh": acb.tanh,
    r"\arcsin": acb.asin,
    r"\arccos": acb.acos,
    r"\arctan": acb.atan,
    r"\cot": acb.cot,
    r"\sec": acb.sec,
    r"\csc": acb.csc,
    r"\coth": acb.coth,
    r"\mathrm{sech}": acb.sech,
    r"\mathrm{csch}": acb.csch,
    r"\mathrm{arsinh}": acb.asinh,
    r"\mathrm{arcosh}": acb.acosh,
    r"\mathrm{artanh}": acb.atanh,
}


class Valueless(Exception):
    """What has no value at a sample, as a vector product, or a quotient by zero."""


class Sample:
    """Numbers for names and their derivatives.

    ``given`` are formulas for some of them, ``rated`` the names that are derived, each with a
    variable, ``fields`` the names by which unknown functions are derived, and ``primed`` is the
    variable by which a prime derives.
    """

    def __init__(
        self,
        seed: int,
        given: Mapping[Key, Formula],
        rated: Iterable[tuple[str, str]],
        fields: Mapping[str, frozenset[str]],
        primed: str,
    ) -> None:
        self.seed, self.given, self.rated, self.fields = seed, given, frozenset(rated), fields
        self.primed = primed
        self.slopes: frozenset[Key] = frozenset()
        """The keys of which partial derivatives are printed, each with a variable."""
        self.bound: set[str] = set()
        """The unknown functions of which a value is given: nothing is known of others beside it."""
        self.arguments: Mapping[str, str] = {}
        """The names of functions of one argument, each with it: primes derive by it."""
        self.values: dict[Key, acb] = {}
        self.touched: set[Key] = set()
        self._busy: set[Key] = set()
        self._moved = False
        self.scaled: tuple[Key, float] | None = None
        """What is small, or large, and by which factor."""
        self._integrals: dict[Formula, tuple[acb, dict[Key, acb]]] = {}

    def copy(self, fields: Mapping[str, frozenset[str]]) -> Sample:
        """The same numbers, with functions that are derived by some names."""
        found = Sample(self.seed, self.given, self.rated, fields, self.primed)
        found.values, found._integrals = dict(self.values), dict(self._integrals)
        found.scaled, found.slopes, found.bound = self.scaled, self.slopes, self.bound
        found.arguments = self.arguments
        return found

    def _moving(self) -> Sample:
        """The same numbers, of which some will be changed."""
        found = self.copy(self.fields)
        return found

    def key(self, node: Formula) -> Key | None:
        """The key of a name, of a derivative of one, or of what is printed like one; or none."""
        found = key_of(node, self.primed)
        primes = len(found) - 1 if found and isinstance(node, Derivative) else 0
        argument = self.arguments.get(found[0], "") if found and primes else ""
        if found and argument and _derives_by(node, ("prime", argument)):
            return (found[0] + "'" * primes,)
        return found

    def value(self, node: Formula) -> acb:
        """The value of a formula.

        Raises:
            Valueless: it has none.
        """
        match node:
            case Number(number):
                return acb(number)
            case Sum(terms):
                return sum(map(self.value, terms), acb(0))
            case Product() | ScalarProduct():
                return prod(map(self.value, node.children()), start=acb(1))
            case Quotient(above, below):
                return self.value(above) / _divisor(self.value(below))
            case Power():
                return self._power(node)
            case Derivative(inner, mark):
                return self._derivative(node, inner, variable_of(mark, self.primed))
            case Partial():
                return self._partial(node)
            case Application():
                return self._applied(node)
        return self._simple(node)

    def _simple(self, node: Formula) -> acb:
        """The value of a name, or of what has one argument."""
        match node:
            case Name("i"):
                return acb(0, 1)
            case Name(r"\pi"):
                return acb.pi()
            case Negative(inner):
                return -self.value(inner)
            case Root(inner):
                return self.value(inner).sqrt()
            case Modulus(inner):
                return acb(abs(self.value(inner)))
        return self._named(node)

    def holds(self, left: Formula, right: Formula) -> bool:
        """Whether two formulas have one value.

        Raises:
            Valueless: one of them has none.
        """
        one, other = self.value(left), self.value(right)
        return is_zero((one - other) / (1 + abs(complex(one)) + abs(complex(other))))

    def atom(self, key: Key) -> acb:
        """The value of a key: that of what gives it, or any number."""
        if key not in self.values and (slope := self.slope_of_given(key)):
            return self.value(slope)
        if key not in self.values:
            if key in self.given:
                if key in self._busy:
                    raise Valueless(key[0])
                self._busy.add(key)
                try:
                    return self.value(self.given[key])
                finally:
                    self._busy.discard(key)
            number = random.Random(f"{self.seed} {key}").randrange(500, 1500)
            scale = self.scaled[1] if self.scaled and self.scaled[0] == key else 1
            self.values[key] = acb(number) / 1000 * scale
        self.touched.add(key)
        return self.values[key]

    def slope_of_given(self, key: Key) -> Formula | None:
        """The derivative that a name with primes is, of what its argument gives; or none."""
        below, primes = key[0], 0
        while len(key) == 1 and below.endswith("'") and (below,) not in self.given:
            below, primes = below[:-1], primes + 1
        argument = self._argument((below,))
        given = self.given.get((below,))
        if not primes or given is None or argument not in given.names():
            return None
        found: Formula = Name(below)
        for _ in range(primes):
            found = Partial(found, argument)
        return found

    def _named(self, node: Formula) -> acb:
        key = self.key(node)
        if key is None:
            raise Valueless(type(node).__name__)
        return self.atom(key)

    def _power(self, node: Power) -> acb:
        if self.key(node) is not None:
            return self._named(node)
        base = self.value(node.base)
        if isinstance(node.exponent, Number):
            return base**node.exponent.value
        exponent = self.value(node.exponent)
        return acb((exponent * _divisor(base).log()).exp())

    def _applied(self, node: Application) -> acb:
        function = node.function
        match node.arguments:
            case (first, last, Name(by), body) if function == INTEGRAL:
                found, at = self._integrals.get(node, (None, {}))
                if found is None or any(self.atom(key) is not value for key, value in at.items()):
                    before, self.touched = self.touched, set()
                    found, touched = self._integral(self._ends(first, last), by, body)
                    at = {key: self.atom(key) for key in touched | self.touched}
                    self.touched |= before
                    self._integrals[node] = found, at
                return found
        arguments = [self.value(one) for one in node.arguments]
        if function in _FUNCTIONS and len(arguments) == 1:
            value = _FUNCTIONS[function](arguments[0])
            if not value.is_finite():
                raise Valueless(function)
            return value
        key = (function, "(", *(one.str(DIGITS, radius=False) for one in arguments))
        if key not in self.values:
            if self._moved and (function in self.bound or function in FUNCTIONS):
                raise Valueless(function)
            self.values[key] = self._unknown(function, arguments)
        return self.atom(key)

    def _unknown(self, function: str, arguments: Sequence[acb]) -> acb:
        """The value of a function of which nothing is known: of any one with derivatives."""
        numbers = random.Random(f"{self.seed} {function}")
        total = acb(0)
        for _ in range(1 + len(arguments)):
            along = sum((one * numbers.randrange(500, 1500) / 1000 for one in arguments), acb(0))
            for power in range(DEGREE + 1):
                total += along**power * numbers.randrange(500, 1500) / 1000
        return total

    # -- integrals ------------------------------------------------------------------------

    def _ends(self, first: Formula, last: Formula) -> tuple[acb, acb | None]:
        """The ends of an integral, of which the last one may be infinite."""
        return self.value(first), None if last == Name(INFINITE) else self.value(last)

    def _integral(
        self, ends: tuple[acb, acb | None], by: str, body: Formula
    ) -> tuple[acb, frozenset[Key]]:
        """An integral by the rule of tanh and sinh, and of what the integrand is made.

        There is none if a pole is on the way. To infinity it is any sum over values of the
        integrand: what is equal by its linearity alone is equal then.
        """
        first, last = ends
        inner = self._moving()
        constant = inner.value(body)
        own = frozenset(inner.touched - {(by,)})
        if (by,) not in inner.touched and last is not None:
            return (last - first) * constant, own
        sums = [acb(0), acb(0)]
        for k, (place, weight) in enumerate(nodes() if last is not None else ANY_NODES):
            inner = self._moving()
            inner.values[by,] = first + (place if last is None else (last - first) * place)
            sums[k % 2] += weight * inner.value(body)
        if last is None:
            return sum(sums, acb(0)), own
        if not abs(complex(sums[0] - sums[1])) <= _ROUGHLY * abs(complex(sums[0])):
            raise Valueless("an integral by a pole")
        return (sums[0] + sums[1]) * (last - first), own

    # -- derivatives -----------------------------------------------------------------------

    def _derivative(self, node: Formula, inner: Formula, by: str) -> acb:
        key = self.key(node)
        if key == (by, by):
            return acb(1)
        if key is not None and (key in self.values or key in self.given):
            return self.atom(key)
        below = self.key(inner)
        if below is not None and below[0] in self.fields and below[:1] not in self.given:
            return self._along_all(below[0], by)
        directions = self._directions(inner, by)
        known = below in self.values and below not in directions
        if key is not None and (known or not directions):
            return self.atom(key)
        return self._slope(inner, directions)

    def _along_all(self, function: str, by: str) -> acb:
        """The rate of an unknown function, by those of what it is derived by."""
        found = acb(0)
        if not self.fields.keys().isdisjoint(map(name_of_rate, self.fields[function])):
            raise Valueless(function)
        for name in sorted(self.fields[function]):
            rate = acb(1) if name == by else self.value(rate_of(name, by))
            found += self.atom((PARTIAL, function, name)) * rate
        return found

    def _partial(self, node: Partial) -> acb:
        inner, by = node.argument, node.by
        key = self.key(node)
        if isinstance(inner, Name) and self._argument((inner.name,)) == by:
            if (inner.name,) not in self.given:
                return self.atom((f"{inner.name}'",))
        below = () if key is None else (key[1:2], *(key[:n] for n in range(3, len(key))))
        if key is not None and (key in self.given or self.given.keys().isdisjoint(below)):
            return self.atom(key)
        at = self.key(rated(by))
        if at is None:
            raise Valueless(by)
        before, self.touched = self.touched, set()
        self.value(inner)
        own, self.touched = self.touched, before | self.touched
        self.atom(at)
        slopes = {
            key: self.atom((*([] if key[0] == PARTIAL else [PARTIAL]), *key, by))
            for key in sorted(own)
            if (*key, by) in self.slopes
        }
        for key in sorted(own):
            argument = self._argument(key)
            if argument == by or (argument,) in self.given:
                slope = self.value(Partial(Name(argument), by)) if argument != by else acb(1)
                slopes[key] = self.atom((f"{key[0]}'",)) * slope
        return self._slope(inner, {**slopes, at: acb(1)})

    def _argument(self, key: Key) -> str:
        """The argument of an unknown function, or of a derivative with primes; or none."""
        return self.arguments.get(key[0].rstrip("'"), "") if len(key) == 1 else ""

    def _directions(self, node: Formula, by: str) -> dict[Key, acb]:
        """How all that moves by a variable moves, of which a formula is made."""
        before, self.touched = self.touched, set()
        self.value(node)
        own, self.touched = self.touched, before | self.touched
        found: dict[Key, acb] = {}
        for key in sorted(own):
            argument = self._argument(key)
            if (
                argument != by
                and (argument, by) not in self.rated
                and (argument,) not in self.given
            ):
                argument = ""  # it does not move
            if key == (by,):
                found[key] = acb(1)
            elif argument:
                rate = acb(1) if argument == by else self.value(rate_of(argument, by))
                found[key] = self.atom((f"{key[0]}'",)) * rate
            elif (key[0], by) in self.rated and key[1:2] != ("(",) and not is_initial(key[0]):
                along = len(key) == 1 and bool(self.fields.get(key[0], frozenset()) - {by})
                along = along and (*key, by) not in self.given
                found[key] = self._along_all(key[0], by) if along else self.atom((*key, by))
        return found

    def _slope(self, node: Formula, directions: Mapping[Key, acb]) -> acb:
        """The derivative of a formula where some keys move."""
        ends = []
        for sign in (1, -1):
            moved = self._moving()
            moved._moved = True
            for key, direction in directions.items():
                moved.values[key] = self.atom(key) + direction * sign * _STEP
            ends.append(moved.value(node))
        return (ends[0] - ends[1]) / (2 * _STEP)


def _derives_by(node: Formula, marks: Collection[str]) -> bool:
    """Whether a derivative of a name is made by some marks alone."""
    while isinstance(node, Derivative) and node.mark in marks:
        node = node.argument
    return isinstance(node, Name)


def _divisor(value: acb) -> acb:
    if abs(complex(value)) < _NOTHING:
        raise Valueless("a quotient by zero")
    return value


def is_zero(value: acb) -> bool:
    """Whether a value of about one is zero."""
    return bool(abs(complex(value)) < _SMALL)


def precisely() -> AbstractContextManager[object]:
    """The precision in which values are found, as a context."""
    found: AbstractContextManager[object] = ctx.workprec(BITS)
    return found
