r"""Straight-line programs: elements that are never expanded.

A program says how a value is computed from those of the generators: by sums,
products, inverses, roots, and derivatives along a field. It has no normal form,
so whether it vanishes is asked at points (:mod:`kowalevski_cas.algebra.valuation`):
modulo primes, in balls, or in floating point. What a formula means is
written once; a stage of programs evaluates it like any other stage.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping
from enum import Enum, auto
from fractions import Fraction

from kowalevski_cas.algebra.derivation import Field, along
from kowalevski_cas.algebra.tower import Element


class Op(Enum):
    """What a program does last."""

    NUMBER = auto()
    GENERATOR = auto()
    ROOT = auto()
    SUM = auto()
    PRODUCT = auto()
    POWER = auto()
    INVERSE = auto()
    ALONG = auto()


class Program(Element):
    """One step of a computation, with the steps whose results it uses.

    ``data`` is the number of a number, the name of a generator or root, the
    exponent of a power, and the field of a derivative. The argument of a root is
    its radicand.
    """

    __slots__ = ("args", "data", "op")

    ring: Programs  # type: ignore[assignment] # a program lives in a ring of programs only

    def __init__(self, ring: Programs, op: Op, args: tuple[Program, ...], data: object) -> None:
        self.ring = ring
        self.op = op
        self.args = args
        self.data = data

    @property
    def number(self) -> Fraction | None:
        """The value of a program that is a number as it stands."""
        return self.data if isinstance(self.data, Fraction) else None

    @property
    def is_zero(self) -> bool:
        """Whether the program vanishes, as far as its ring can tell."""
        if self.number is not None:
            return self.number == 0
        return self.ring.vanishes(self)

    def __add__(self, other: Element) -> Program:
        ring, right = self.ring, _program(other)
        a, b = self.number, right.number
        if a is not None and b is not None:
            return ring.number(a + b)
        if a == 0:
            return right
        return self if b == 0 else ring.step(Op.SUM, (self, right))

    def __neg__(self) -> Program:
        return self * self.ring.number(-1)

    def __sub__(self, other: Element) -> Program:
        return self + (-_program(other))

    def __mul__(self, other: Element) -> Program:
        ring, right = self.ring, _program(other)
        a, b = self.number, right.number
        if a is not None and b is not None:
            return ring.number(a * b)
        if a == 0 or b == 0:
            return ring.zero
        if a == 1:
            return right
        if b == 1:
            return self
        return ring.step(Op.PRODUCT, (self, right))

    def __pow__(self, exponent: int) -> Program:
        if exponent < 0:
            return self.inverse() ** -exponent
        if self.number is not None:
            return self.ring.number(self.number**exponent)
        if exponent < 2:
            return self if exponent else self.ring.one
        return self.ring.step(Op.POWER, (self,), exponent)

    def inverse(self) -> Program:
        """One over the program; raises ``ZeroDivisionError`` only for the number zero."""
        if self.number is not None:
            return self.ring.number(1 / self.number)
        return self.ring.step(Op.INVERSE, (self,))

    def __truediv__(self, other: Element) -> Program:
        return self * _program(other).inverse()


def _program(element: Element) -> Program:
    assert isinstance(element, Program)
    return element


class Programs:
    """The programs in named generators and square roots; their numbers are shared."""

    def __init__(self, generators: Iterable[str]) -> None:
        self.depths: dict[int, dict[Program, int]] = {}
        """How deep derivatives are nested, by the identity of the field."""
        self.roots: list[str] = []
        self.radicands: list[Program] = []
        self._numbers: dict[Fraction, Program] = {}
        self._named = {name: self.step(Op.GENERATOR, (), name) for name in generators}
        self.generators = tuple(self._named)
        self.zero = self.number(0)
        self.one = self.number(1)

    def vanishes(self, program: Program) -> bool:
        """Whether a program vanishes; raises ``TypeError`` in a ring that only writes them."""
        raise TypeError("programs are only written here")

    def step(self, op: Op, args: tuple[Program, ...], data: object = None) -> Program:
        """A program whose last step is this one."""
        return Program(self, op, args, data)

    def number(self, value: int | Fraction) -> Program:
        """A rational number."""
        exact = Fraction(value)
        if exact not in self._numbers:
            self._numbers[exact] = self.step(Op.NUMBER, (), exact)
        return self._numbers[exact]

    def generator(self, name: str) -> Program:
        """The generator or root with this name; raises ``KeyError`` if there is none."""
        return self._named[name]

    def adjoin(self, name: str, radicand: Program) -> Program:
        """Add a square root of ``radicand`` and return it."""
        self.roots.append(name)
        self.radicands.append(radicand)
        self._named[name] = self.step(Op.ROOT, (radicand,), name)
        return self._named[name]


@along.register
def _(element: Program, field: Field) -> Program:
    if element.number is not None:
        return element.ring.zero
    return element.ring.step(Op.ALONG, (element,), field)


def field_of(program: Program) -> Mapping[str, Program]:
    """The field along which a program of derivation differentiates."""
    assert isinstance(program.data, Mapping)
    return program.data


def steps(programs: Iterable[Program]) -> list[Program]:
    """All steps of some programs, each after those that it uses; fields included."""
    order: dict[Program, None] = {}
    # no recursion: a sum is as deep as it has terms
    waiting = [(program, False) for program in programs]
    while waiting:
        program, ready = waiting.pop()
        if program in order:
            continue
        if ready:
            order[program] = None
            continue
        waiting.append((program, True))
        waiting += ((arg, False) for arg in program.args)
        if program.op is Op.ALONG:
            waiting += ((value, False) for value in field_of(program).values())
    return list(order)


def behind(programs: Iterable[Program], sources: Collection[Program]) -> list[Program]:
    """The steps of some programs that use the sources, each after those that it uses itself."""
    using, found = {*sources}, list[Program]()
    for step in steps(programs):
        before = (*step.args, *(field_of(step).values() if step.op is Op.ALONG else ()))
        if step not in sources and not using.isdisjoint(before):
            using.add(step)
            found.append(step)
    return found


def replaced(using: Iterable[Program], values: Mapping[Program, Program]) -> dict[Program, Program]:
    """What the steps become that use some programs, where these have other values.

    They are those of :func:`behind`.
    """
    found = {**values}
    fields: dict[int, Mapping[str, Program]] = {}
    for step in using:
        data = step.data
        if step.op is Op.ALONG:
            field = field_of(step)
            if not found.keys().isdisjoint(field.values()):
                changed = {name: found.get(rate, rate) for name, rate in field.items()}
                data = fields.setdefault(id(field), changed)
        args = tuple(found.get(arg, arg) for arg in step.args)
        found[step] = step.ring.step(step.op, args, data)
    return found
