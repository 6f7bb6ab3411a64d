"""A step of a derivation, and whether it follows from what stands before it, at samples."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress
from functools import cached_property

from kowalevski_cas.algebra.quadrature import INFINITE
from kowalevski_cas.algebra.samples import Sample, is_zero
from kowalevski_cas.notation import Derivative, Formula, Name, Number, Partial, Power
from kowalevski_cas.paper.transcendental import PI
from kowalevski_cas.reading.premises import NO_VALUE, Pair, SolvedSample, pairs_of, written_out

SAMPLES = 3
"""At how many samples a step holds that is said to follow."""

MANY = 60
"""How many equations before a step are looked at."""

_VARIABLES = (("t", r"\tau", "x"), ("s", r"\xi", r"\theta"))
"""By what a prime may derive, the likelier ones first."""


class PrintedBefore:
    """What stands before a step, solved once at each sample."""

    def __init__(
        self, formula: Formula, before: Sequence[Formula], terms: Sequence[Formula]
    ) -> None:
        self.formulas, self.terms = frozenset(before), terms
        self.premises = [
            pair for one in before for each in written_out(one) for pair in pairs_of(each)
        ][-MANY:]
        own = (side for one in written_out(formula) for pair in pairs_of(one) for side in pair)
        sides = [*(side for pair in self.premises for side in pair), *own]
        self.nodes = [node for side in sides for node in side.nodes()]
        self.names = {node.name for node in self.nodes if isinstance(node, Name)}
        given = (side for pair in self.premises for side in pair)
        self.known = frozenset[str]().union(*(side.names() for side in given))
        self.rates = {node for node in self.nodes if isinstance(node, Derivative)}
        self._solved: dict[int, SolvedSample] = {}

    def solved(self, seed: int) -> SolvedSample:
        """A sample at which the premises hold."""
        if seed not in self._solved:
            self._solved[seed] = SolvedSample(self.sample(seed), self.premises, self.squared)
        return self._solved[seed]

    @cached_property
    def squared(self) -> frozenset[str]:
        """The names that stand in even powers only: nothing rests on their signs."""
        powers = (node for node in self.nodes if isinstance(node, Power))
        even = [
            node.base.name
            for node in powers
            if isinstance(node.base, Name)
            and isinstance(node.exponent, Number)
            and node.exponent.value % 2 == 0
        ]
        alone = [node.name for node in self.nodes if isinstance(node, Name)]
        return frozenset(name for name in even if even.count(name) == alone.count(name))

    def is_unit(self, name: str) -> bool:
        """Whether a name stands for 0, 1 or -1: nobody sees whether it is a factor."""
        with suppress(*NO_VALUE):
            value = self.solved(0).sample.value(Name(name))
            return is_zero(value * (value * value - 1))
        return False

    def sample(self, seed: int) -> Sample:
        """A sample at which all is free."""
        sample = Sample(seed, {}, (), {}, self._primed)
        keys = [sample.key(rate) for rate in self.rates]
        return Sample(seed, {}, {(key[0], key[-1]) for key in keys if key}, {}, self._primed)

    @cached_property
    def _primed(self) -> str:
        """The variable by which a prime derives, if only one stands there."""
        rated = {rate.argument for rate in self.rates}
        dotted = any(rate.mark == "dot" for rate in self.rates)
        for likely in _VARIABLES:
            free = [name for name in likely if name in self.names and Name(name) not in rated]
            if free := [name for name in free if not (name == "t" and dotted)]:
                return free[0] if len(free) == 1 else "prime"
        return "prime"


class DerivationStep:
    """A step behind what stands before it."""

    def __init__(self, formula: Formula, before: PrintedBefore) -> None:
        self.formula, self.before = formula, before
        self.pairs = [pair for one in written_out(formula) for pair in pairs_of(one)]

    def fails(self) -> bool:
        """Whether it says something of what is known, and that is false."""
        return self._at(0) is False

    def follows(self) -> bool:
        """Whether it says something of what is known, and that is true."""
        return all(self._at(seed) is True for seed in range(SAMPLES))

    def _at(self, seed: int) -> bool | None:
        """Whether the step holds at a sample; ``None`` if it says nothing there."""
        with suppress(*NO_VALUE):
            if (name := self._solving) is not None:
                return self._solves(name, seed)
            return self.before.solved(seed).holds(
                self._integral or [*self._telling()], self._fields
            )
        return None

    def _telling(self) -> Iterator[Pair]:
        """The equations that say more than what a new name on the right is."""
        known, fields = {*self.before.known, PI, INFINITE}, {*map(Name, self._fields)}
        for left, right in self.pairs:
            known |= left.names()
            total = isinstance(left, Derivative) and left.argument in fields
            if total or right.names() <= known:
                yield left, right

    @cached_property
    def _solving(self) -> str | None:
        """The name of which only equations for its derivatives stand before what gives it."""
        match self.pairs:
            case [(Name(name), right)] if name not in right.names():
                others = [pair for pair in self.before.premises if Name(name) in pair]
                if not others and any(_derives(name, pair) for pair in self.before.premises):
                    return name
        return None

    def _solves(self, name: str, seed: int) -> bool | None:
        """Whether what gives a name solves the last equation of its derivatives."""
        equations = [pair for pair in self.before.premises if _derives(name, pair)]
        rest = [pair for pair in self.before.premises if pair not in equations]
        found = SolvedSample(self.before.sample(seed), [*rest, *self.pairs])
        return found.holds(equations[-1:], {})

    @cached_property
    def _integral(self) -> list[Pair]:
        """That the derivative of a function vanishes which is set equal to a constant."""
        match self.pairs:
            case [(left, Name(name))] if not isinstance(left, Name):
                sides = (side for pair in self.before.premises for side in pair)
                marks = {rate.mark for rate in self.before.rates}
                by = marks.pop() if len(marks) == 1 else "dot"
                if by not in ("dot", "t") and not any(name in side.names() for side in sides):
                    return [(Derivative(left, by), Number(0))]
        return []

    @cached_property
    def _fields(self) -> dict[str, frozenset[str]]:
        """The unknown functions that it derives, with what it derives them by."""
        found: dict[str, frozenset[str]] = {}
        for node in (node for pair in self.pairs for side in pair for node in side.nodes()):
            if isinstance(node, Partial) and isinstance(node.argument, Name):
                name = node.argument.name
                found[name] = found.get(name, frozenset()) | {node.by}
        return found


def _derives(name: str, pair: Pair) -> bool:
    """Whether a name is derived in an equation."""
    for node in (node for side in pair for node in side.nodes()):
        if isinstance(node, Derivative | Partial) and node.argument == Name(name):
            return True
    return False
