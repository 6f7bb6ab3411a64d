r"""The value of a program at a point, derivatives included, in any kind of numbers.

A derivative along a field is taken where the point moves: its coordinates
become truncated power series in the time, and the derivative of a value is the
derivative of its series. So nothing is differentiated but series, and the k-th
derivative costs as much as a product of series of length k. A derivative inside
another one, along another field, is a series whose coefficients are series.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from typing import Any

from kowalevski_cas.algebra.programs import Op, Program, Programs, field_of, steps
from kowalevski_cas.algebra.series import Series, inverse, level_of, power

Number = Any
"""A number of some arithmetic: it supports ``+``, ``*``, ``1 /`` and products with integers."""

Convert = Callable[[Fraction], Number]
"""A rational number as a number of the arithmetic."""

CHAINS = (Op.SUM, Op.PRODUCT)
"""The operations of which a program may have more than Python can call within each other."""

Choose = Callable[[str, Number], Number]
"""A square root of a value, by the name of the root."""


class Valuation:
    """The values of programs at one point.

    ``values`` gives the generators; ``choose`` takes the name of a root and the value
    of its radicand, and says which of the two roots it is, once for each root that is
    needed; ``number`` converts rational numbers. Raises ``ZeroDivisionError`` on a
    point where something is divided by zero.
    """

    def __init__(self, number: Convert, values: Mapping[str, Any], choose: Choose) -> None:
        self.number = number
        self.values = values
        self.choose = choose
        self.level = -1
        self.field: Mapping[str, Program] | None = None
        self.origin: Valuation | None = None
        """Where a moving point starts."""
        self._known: dict[Program, Any] = {}
        self._flows: dict[int, tuple[int, Valuation]] = {}

    def __call__(self, program: Program) -> Any:
        """The value of a program."""
        known, waiting = self._known, [program]
        while waiting:  # no recursion: a sum has as many steps as terms
            step = waiting[-1]
            if step in known:
                waiting.pop()
            elif step.op in CHAINS and (before := [arg for arg in step.args if arg not in known]):
                waiting += before
            else:
                known[step] = self._value(step)
        return known[program]

    def _value(self, program: Program) -> Any:
        op, args = program.op, program.args
        if op is Op.SUM:
            return self._known[args[0]] + self._known[args[1]]
        if op is Op.PRODUCT:
            return self._known[args[0]] * self._known[args[1]]
        if op is Op.NUMBER:
            assert program.number is not None
            return self.number(program.number)
        if op is Op.POWER:
            return power(self(args[0]), int(str(program.data)))
        if op is Op.INVERSE:
            return inverse(self(args[0]))
        if op is Op.ALONG:
            return self._along(program)
        return self._generator_value(program)

    def _generator_value(self, program: Program) -> Any:
        name = str(program.data)
        if name in self.values:
            return self.values[name]
        if program.op is Op.GENERATOR:
            raise KeyError(f"{name} has no value at the point")
        square = self(program.args[0])
        if self.origin is None:
            return self.choose(name, square)
        root = self.origin(program)
        return square.root(root) if level_of(square) == self.level else root

    def coordinates(self, ring: Programs) -> dict[str, Any]:
        """The values of the generators, and of the roots that were needed."""
        roots = map(ring.generator, ring.roots)
        used = {str(root.data): self._known[root] for root in roots if root in self._known}
        return {name: self.values[name] for name in ring.generators} | used

    def _along(self, program: Program) -> Any:
        (inner,), field = program.args, field_of(program)
        if field is self.field:
            value = self(inner)
            # What is of a lower level does not move.
            return value.derivative() if level_of(value) == self.level else self.number(ZERO)
        flow = self.along_field(field, depth(program, field))
        value = flow(inner)
        return value.coefficients[1] if level_of(value) == flow.level else self.number(ZERO)

    def along_field(self, field: Mapping[str, Program], order: int) -> Valuation:
        """The valuation where the point moves along a field, as a series up to this order."""
        known, flow = self._flows.get(id(field), (-1, self))
        if known < order:
            flow = self._flow(field, order)
            self._flows[id(field)] = order, flow
        return flow

    def _flow(self, field: Mapping[str, Program], order: int) -> Valuation:
        """The motion by its Taylor series, one coefficient after the other."""
        rates = {name: rate for name, rate in field.items() if rate.number != 0}
        paths = {name: [self(rate.ring.generator(name))] for name, rate in rates.items()}
        for k in range(order):
            point = self._point_along_field(field, paths)
            factor = self.number(Fraction(1, k + 1))
            for name, rate in rates.items():
                value = point(rate)
                if level_of(value) == point.level:
                    value = value.coefficients[k]
                elif k:
                    value = self.number(ZERO)
                paths[name].append(value * factor)
        return self._point_along_field(field, paths)

    def _point_along_field(
        self, field: Mapping[str, Program], paths: Mapping[str, list[Any]]
    ) -> Valuation:
        """The valuation with series for the generators that move; roots follow their radicands."""
        level = self.level + 1
        moving = {name: Series(level, list(path)) for name, path in paths.items()}
        point = Valuation(self.number, {**self.values, **moving}, self.choose)
        point.level, point.field, point.origin = level, field, self
        return point


ZERO = Fraction(0)


def depth(program: Program, field: Mapping[str, Program]) -> int:
    """How many derivatives along a field are taken of each other at most."""
    known = program.ring.depths.setdefault(id(field), {})
    for step in steps([program]) if program not in known else ():
        if step not in known:
            inner = max((known[arg] for arg in step.args), default=0)
            known[step] = inner + (step.op is Op.ALONG and step.data is field)
    return known[program]
