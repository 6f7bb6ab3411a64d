"""The same operations on polynomials without anything around them, in python-flint and elsewhere.

The growing work is done once with polynomials that keep a list of what is done to
them. The list is then gone through by nothing but python-flint, or written out as a
program for Singular or PARI/GP, and timed.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from operator import add, mul, neg, sub
from time import perf_counter
from typing import Any

from kowalevski_cas.algebra.flint import Arithmetic as Flint
from kowalevski_cas.algebra.polynomials import Polynomials, Terms
from study.growing import growth


def _derivative(value: Any, index: int) -> Any:
    return value.derivative(index)


FUNCTIONS: dict[str, Callable[..., Any]] = {
    "+": add,
    "-": sub,
    "*": mul,
    "d": _derivative,
    "negative": neg,
}


FORGET = "forget"


@dataclass(frozen=True)
class Operation:
    """What makes the polynomial ``result`` of others, by number; ``d`` by a generator.

    The operation ``forget`` says that nobody needs the polynomial any more.
    """

    result: int
    name: str
    arguments: tuple[int, ...]
    generator: int | None = None


@dataclass
class Trace:
    """What is computed: polynomials that come from outside, operations, and what is zero."""

    given: dict[int, Any] = field(default_factory=dict)
    operations: list[Operation] = field(default_factory=list)
    zeros: list[int] = field(default_factory=list)
    number: int = 0

    def enter(self, value: Any) -> Recorded:
        """A polynomial that comes from outside."""
        self.number += 1
        self.given[self.number] = value
        return Recorded(self, self.number, value)

    def record(self, name: str, *arguments: Recorded, generator: int | None = None) -> Recorded:
        """A polynomial that is computed, here and now."""
        self.number += 1
        numbers = tuple(argument.number for argument in arguments)
        self.operations.append(Operation(self.number, name, numbers, generator))
        values = [argument.value for argument in arguments]
        more = [] if generator is None else [generator]
        return Recorded(self, self.number, FUNCTIONS[name](*values, *more))


class Recorded:
    """A polynomial of python-flint that tells its trace what is done to it."""

    __slots__ = ("number", "trace", "value")

    def __init__(self, trace: Trace, number: int, value: Any) -> None:
        self.trace, self.number, self.value = trace, number, value

    def __del__(self) -> None:
        self.trace.operations.append(Operation(self.number, FORGET, ()))

    def __add__(self, other: Recorded) -> Recorded:
        return self.trace.record("+", self, other)

    def __sub__(self, other: Recorded) -> Recorded:
        return self.trace.record("-", self, other)

    def __mul__(self, other: Recorded) -> Recorded:
        return self.trace.record("*", self, other)

    def __neg__(self) -> Recorded:
        return self.trace.record("negative", self)


class Recording(Polynomials):
    """The arithmetic of FLINT, with a trace of all that is computed."""

    name = "recording"

    def __init__(self, generators: tuple[str, ...]) -> None:
        super().__init__(generators)
        self.plain, self.trace = Flint(generators), Trace()
        self.zero = self.trace.enter(self.plain.zero)
        self.one = self.trace.enter(self.plain.one)

    def generator(self, index: int) -> Recorded:
        return self.trace.enter(self.plain.generator(index))

    def constant(self, value: Fraction) -> Recorded:
        return self.trace.enter(self.plain.constant(value))

    def derivative(self, polynomial: Recorded, index: int) -> Recorded:
        return self.trace.record("d", polynomial, generator=index)

    def is_zero(self, polynomial: Recorded) -> bool:
        found = self.plain.is_zero(polynomial.value)
        if found:
            self.trace.zeros.append(polynomial.number)
        return found

    def terms(self, polynomial: Recorded) -> Terms:
        return self.plain.terms(polynomial.value)

    def from_terms(self, terms: Mapping[tuple[int, ...], Fraction]) -> Recorded:
        return self.trace.enter(self.plain.from_terms(terms))


def traces(claim: str, most: int) -> Iterator[tuple[Recording, Trace]]:
    """What is computed in each step of the growing work; the first one has what came before."""
    work = growth(claim, Recording)
    arithmetic = work.at.ring.polynomials
    assert isinstance(arithmetic, Recording)
    for _ in range(most):
        if not work.step():
            return
        trace = arithmetic.trace
        yield arithmetic, Trace(trace.given, trace.operations, trace.zeros, trace.number)
        trace.given, trace.operations, trace.zeros = {}, [], []


def recorded(claim: str, most: int, seconds: float) -> list[tuple[Recording, Trace]]:
    """The steps that can be recorded in so many seconds, the first one in any case."""
    start, found = perf_counter(), []
    for step in traces(claim, most):
        found.append(step)
        if perf_counter() - start > seconds:
            break
    return found


def direct(claim: str, most: int) -> Iterator[float]:
    """The seconds from the start to each step, in python-flint alone."""
    values: dict[int, Any] = {}
    seconds = 0.0
    for _, trace in traces(claim, most):
        values |= trace.given
        steps = [(o.name, o.arguments, o.generator, o.result) for o in trace.operations]
        start = perf_counter()
        for name, numbers, generator, result in steps:
            if len(numbers) == 2:
                function = FUNCTIONS[name]
                values[result] = function(values[numbers[0]], values[numbers[1]])
            elif generator is not None:
                values[result] = values[numbers[0]].derivative(generator)
            elif name == FORGET:
                del values[result]
            else:
                values[result] = -values[numbers[0]]
        seconds += perf_counter() - start
        yield seconds
