"""Numbers for formulas: at a random point every name is a random function of a few times.

A value is a Taylor polynomial in these times, one for each way in which a derivative is printed:
so a dot, a prime and a d/dt are derivatives, and differ. Vectors are triples of values.
"""

from __future__ import annotations

import cmath
from functools import cache
from itertools import combinations_with_replacement, product
from random import Random

ORDER = 3
"""Derivatives of a higher order are zero."""


class Value:
    """A Taylor polynomial: its coefficients, by sorted tuples of the times."""

    def __init__(self, terms):
        self.terms = {key: term for key, term in terms.items() if term}

    def __add__(self, other):
        return Value({k: self[k] + other[k] for k in self.terms | other.terms})

    def __neg__(self):
        return Value({k: -v for k, v in self.terms.items()})

    def __mul__(self, other):
        found = {}
        for (a, x), (b, y) in product(self.terms.items(), other.terms.items()):
            if len(a) + len(b) <= ORDER:
                key = tuple(sorted(a + b))
                found[key] = found.get(key, 0) + x * y
        return Value(found)

    def __getitem__(self, key):
        return self.terms.get(key, 0)

    def composed(self, derivatives):
        """A function of the value, by its derivatives at the constant term."""
        rest = Value({k: v for k, v in self.terms.items() if k})
        found, power, factorial = number(0), number(1), 1
        for order, derivative in enumerate(derivatives[: ORDER + 1]):
            factorial *= order or 1
            found = found + power * number(derivative / factorial)
            power = power * rest
        return found

    def to(self, exponent):
        """A power; of a number with a whole exponent it is exact, else by the logarithm."""
        if not any(exponent.terms.keys()) and exponent[()] == round(exponent[()].real):
            whole = round(exponent[()].real)
            base = self if whole >= 0 else self.inverse()
            found = number(1)
            for _ in range(min(abs(whole), 50)):
                found = found * base
            return found
        c = self[()]
        logarithm = self.composed([cmath.log(c), 1 / c, -1 / c**2, 2 / c**3])
        return (logarithm * exponent).exponential()

    def exponential(self):
        return self.composed([cmath.exp(self[()])] * (ORDER + 1))

    def inverse(self):
        c = self[()]
        return self.composed([1 / c, -1 / c**2, 2 / c**3, -6 / c**4])

    def root(self):
        c, s = self[()], cmath.sqrt(self[()])
        return self.composed([s, 1 / (2 * s), -1 / (4 * s * c), 3 / (8 * s * c**2)])

    def conjugate(self):
        return Value({k: complex(v).conjugate() for k, v in self.terms.items()})

    def derivative(self, time):
        """The derivative by one of the times."""
        found = {}
        for key, term in self.terms.items():
            if count := key.count(time):
                rest = list(key)
                rest.remove(time)
                found[tuple(rest)] = count * term
        return Value(found)


def number(value):
    """A number that does not move."""
    return Value({(): complex(value)})


class Point:
    """Random values of names, always the same for the same seed."""

    def __init__(self, seed, times):
        self.seed = seed
        self.keys = [
            key for n in range(ORDER + 1) for key in combinations_with_replacement(sorted(times), n)
        ]

    @cache  # noqa: B019
    def scalar(self, name):
        """The value of a name. By its own name a partial derivative of it is one."""
        chance = Random(f"{self.seed} {name}")
        keys = [key for key in self.keys if not any(time[0] == "∂" for time in key)]
        terms = {k: complex(chance.uniform(-1, 1), chance.uniform(-1, 1)) for k in keys}
        own = ("∂" + name,)
        return Value(terms | ({own: 1} if own in self.keys else {}))

    def vector(self, name):
        return tuple(self.scalar(f"{name} {k}") for k in range(3))

    def matrix(self, name):
        return tuple(self.vector(f"{name} {k}") for k in range(3))

    def applied(self, function, arguments):
        """A function: the sine of a combination of all components of its arguments."""
        total = self.scalar(function)
        for k, part in enumerate(p for a in arguments for p in parts(a)):
            total = total + number(k + 1) * part
        c = total[()]
        return total.composed([cmath.sin(c), cmath.cos(c), -cmath.sin(c), -cmath.cos(c)])


def parts(value):
    """The numbers of which a value consists."""
    return [part for row in value for part in parts(row)] if isinstance(value, tuple) else [value]


def rank(value):
    """0 for a number, 1 for a vector, 2 for a matrix."""
    return 1 + rank(value[0]) if isinstance(value, tuple) else 0


def each(function, *values):
    """A function of numbers, of the components of vectors; a number goes with all of them."""
    if not any(isinstance(value, tuple) for value in values):
        return function(*values)
    rows = (value if isinstance(value, tuple) else (value,) * 3 for value in values)
    return tuple(each(function, *row) for row in zip(*rows, strict=True))


def padded(rows):
    """A list as a vector, or a list of rows as a matrix."""
    zero = each(lambda _: number(0), rows[0])
    return tuple([*rows, zero, zero][:3])


def dot(left, right):
    return left[0] * right[0] + left[1] * right[1] + left[2] * right[2]


def length(value):
    """The length of a vector, or of a number."""
    return (value * value if rank(value) == 0 else dot(value, value)).root()


def commutator(left, right):
    return plus(times(left, right), each(Value.__neg__, times(right, left)))


def cross(left, right):
    def minor(i, j):
        return left[i] * right[j] + -(left[j] * right[i])

    return (minor(1, 2), minor(2, 0), minor(0, 1))


def times(left, right):
    """A product of what stands side by side."""
    ranks = rank(left), rank(right)
    if ranks == (2, 1):
        return tuple(dot(row, right) for row in left)
    if ranks == (2, 2):
        columns = list(zip(*right, strict=True))
        return tuple(tuple(dot(row, column) for column in columns) for row in left)
    if ranks == (1, 2):
        return tuple(dot(left, column) for column in zip(*right, strict=True))
    assert 0 in ranks, "two vectors side by side"
    return each(Value.__mul__, left, right)


def plus(left, right):
    """A sum; nothing is added to a vector by a zero that is printed as a number."""
    if rank(left) != rank(right) and 0 in (rank(left), rank(right)):
        left, right = (v if rank(v) == 2 else diagonal(v) for v in (left, right))
    return each(Value.__add__, left, right)


def diagonal(value):
    """A number as a matrix, or a vector on the diagonal."""
    entries = value if isinstance(value, tuple) else (value,) * 3
    return tuple(tuple(entries[i] if i == j else number(0) for j in range(3)) for i in range(3))


def over(above, below):
    """A quotient by a number."""
    return each(lambda part: part * below.inverse(), above)


def part(value, real):
    """The real or the imaginary part."""

    def of(one):
        bar = one.conjugate()
        return (one + bar) * number(0.5) if real else (one + -bar) * number(-0.5j)

    return each(of, value)


def to(base, exponent):
    """A power of a number, or of a matrix, for which any function will do."""
    if rank(base) == 0:
        return base.to(exponent)
    if rank(base) == 1:
        assert exponent.terms == {(): 2}, "of a vector there is only the square"
        return dot(base, base)
    return each(lambda part: part * exponent, times(base, base))


def bracket(left, right):
    """A bracket that is bilinear and antisymmetric, as Poisson's is."""

    def of(f, g):
        d = Value.derivative
        return d(f, "dot") * d(g, "prime") + -(d(f, "prime") * d(g, "dot"))

    return each(of, left, right)


def same(left, right):
    """Whether two values are the same, as far as numbers in floating point can say.

    Raises ``OverflowError`` if they are not finite.
    """
    if rank(left) != rank(right):
        return False
    for one, other in zip(parts(left), parts(right), strict=True):
        for key in one.terms.keys() | other.terms.keys():
            a, b = one[key], other[key]
            if not (cmath.isfinite(a) and cmath.isfinite(b)):
                raise OverflowError
            if abs(a - b) > 1e-6 * (abs(a) + abs(b)) + 1e-9:
                return False
    return True
