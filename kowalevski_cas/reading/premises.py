"""What stands before a step of a derivation, solved at a sample as far as it is linear."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from itertools import pairwise

from flint import acb

from kowalevski_cas.algebra.keys import Key
from kowalevski_cas.algebra.quadrature import INTEGRAL
from kowalevski_cas.algebra.samples import Sample, Valueless, is_zero
from kowalevski_cas.notation import (
    Application,
    Constant,
    Derivative,
    Formula,
    Name,
    Number,
    Partial,
    Power,
    Relation,
    Unwritten,
)
from kowalevski_cas.notation.formula import EQUALITIES, once
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.reading.free_formulas import instances

NO_VALUE = (Valueless, Meaningless, ValueError, ArithmeticError, RecursionError)
"""What is raised where a formula has no value at a sample."""

Pair = tuple[Formula, Formula]
"""The sides of an equation."""


Change = Callable[[acb], acb]


def _same(value: acb) -> acb:
    return value


_ITSELF: tuple[Change, Change] = (_same, _same)
_INVERSE: tuple[Change, Change] = (acb(1).__truediv__, acb(1).__truediv__)
_SQUARE: tuple[Change, Change] = (lambda value: value * value, acb.sqrt)


class SolvedSample:
    """A sample at which what stands before a step holds, as far as it can be solved."""

    def __init__(
        self, sample: Sample, premises: Sequence[Pair], squared: frozenset[str] = frozenset()
    ) -> None:
        self.sample, self.fixed, self.squared = sample, set[Key](), squared
        self.given: dict[Key, Formula] = {}
        self.fields = sample.fields
        sample.given = self.given
        kept: dict[int, Key | None] = {}
        for place in reversed(range(len(premises))):
            kept[place] = self._given_by(*premises[place])
        for place, key in kept.items():
            if key and not self._stays(key):
                del self.given[key]
                kept[place] = None
        rest = [premises[place] for place, key in kept.items() if key is None]
        self.determined = {*self.given}
        sample.values.clear()
        for pair in reversed(rest):
            with suppress(*NO_VALUE):
                self._solve(pair)
        sample.fields = self.fields

    def agrees(self, premises: Sequence[Pair]) -> bool:
        """Whether all that stands before a step holds together, as far as it has values."""
        for left, right in premises:
            with suppress(*NO_VALUE):
                if not self.sample.holds(left, right):
                    return False
        return True

    def holds(
        self, pairs: Sequence[Pair], fields: Mapping[str, frozenset[str]], of_chain: bool = False
    ) -> bool | None:
        """Whether some equations hold; ``None`` if they say nothing of what is determined.

        Those ``of_chain`` say something by themselves where they transform a formula.
        """
        sample = self.sample.copy({**self.fields, **fields})
        used, true, said = set[Key](), True, False
        for left, right in pairs:
            key = sample.key(_rooted(left))
            sample.touched = set()
            sample.value(right)  # what it rests on is not given by it
            bound = self.determined | self.fixed | sample.touched
            holds = sample.holds(left, right)
            fresh = key is not None and key not in bound and not self._derived(key, fields)
            if fresh:
                continue
            said, true = True, true and holds
            used |= sample.touched | self._given_in(left) | self._given_in(right)
        alone = any(has_integral(side) for pair in pairs for side in pair)
        alone |= any(_is_total(left, fields) for left, _ in pairs)
        alone |= of_chain and any(map(_is_transformed, pairs))
        return true if said and (alone or used & self.determined) else None

    def _derived(self, key: Key, fields: Mapping[str, frozenset[str]]) -> bool:
        """Whether a key is the derivative of what is given."""
        if self.sample.slope_of_given(key) is not None:
            return True
        return any(key[:length] in self.sample.given for length in range(1, len(key))) or (
            key[0] in fields or key[1:2] in self.sample.given
        )

    def _given_in(self, side: Formula) -> set[Key]:
        keys = {self.sample.key(node) for node in side.nodes()}
        return {key for key in keys if key is not None and key in self.sample.given}

    def _stays(self, key: Key) -> bool:
        """Whether what is given rests on nothing that was given later, and on itself.

        The rate of what is given is that of what gives it.
        """
        if any(key[:length] in self.given for length in range(1, len(key))):
            return False
        self.sample.values.clear()  # what is given now may have been free before
        try:
            self.sample.atom(key)
        except NO_VALUE:
            return False
        return True

    def _given_by(self, left: Formula, right: Formula) -> Key | None:
        """What an equation gives, on either side."""
        if self._gives(left, right):
            return self.sample.key(left)
        return self.sample.key(right) if self._gives(right, left) else None

    def _gives(self, name: Formula, by: Formula) -> bool:
        """Whether a name can be given by a formula that does not rest on it."""
        given, key = self.given, self.sample.key(name)
        if key is None or key in given:
            return False
        given[key] = by
        stays = self._stays(key)
        if not stays:
            del given[key]
        return stays

    def _solve(self, pair: Pair) -> None:
        """Give what stands linearly in an equation the value by which it holds.

        Of what is ``squared`` wherever it stands the square is given, and any root of it.
        """
        sample, (left, right) = self.sample, pair
        sample.touched, sample.fields = set(), {**self.fields, **fields_of([pair])}
        start = sample.value(left) - sample.value(right)
        touched = {*sample.touched}
        if is_zero(start):  # else nothing was given by then: it holds whatever its letters are
            self.fixed |= touched if touched & self.fixed else set()
            return
        zero: tuple[Key, acb] | None = None
        for key in sorted(touched - self.fixed, key=_solved_first):
            if (value := self._root(key, pair, start)) is None:
                continue
            if is_zero(value):  # of an equation in which it is a factor something else is meant
                zero = zero or (key, value)
                continue
            sample.values[key] = value
            break
        else:
            again = any(sample.key(side) in self.given for side in pair)
            if zero is None or again:  # of what is given once more the earlier value is of a case
                return
            key, value = zero
            sample.values[key] = value
        if key[1:2] == ("(",):
            sample.bound.add(key[0])
        self.determined.add(key)
        self.fixed |= touched

    def _root(self, key: Key, pair: Pair, start: acb) -> acb | None:
        """The value of what stands linearly in an equation, whose sides differ by ``start``.

        So may its inverse, or its square.
        """
        even = len(key) == 1 and key[0] in self.squared
        for there, back in (_SQUARE,) if even else (_ITSELF, _INVERSE):
            with suppress(ZeroDivisionError):
                if (value := self._linear(key, pair, start, there, back)) is not None:
                    return value
        return self._quadratic(key, pair, start)

    def _quadratic(self, key: Key, pair: Pair, start: acb) -> acb | None:
        """The root next to its value of an equation in which something has the second power."""
        sample, (left, right) = self.sample, pair
        value, ends = sample.values[key], [start]
        with suppress(*NO_VALUE):
            for step in (1, 2, 3):
                sample.values[key] = value + step
                ends.append(sample.value(left) - sample.value(right))
        sample.values[key] = value
        if len(ends) < 4 or not is_zero(ends[3] - 3 * ends[2] + 3 * ends[1] - ends[0]):
            return None
        square = (ends[2] - 2 * ends[1] + ends[0]) / 2
        slope = ends[1] - ends[0] - square
        if is_zero(square):
            return None
        root = (slope * slope - 4 * square * start).sqrt()
        steps = ((sign * root - slope) / (2 * square) for sign in (1, -1))
        return value + min(steps, key=lambda step: abs(complex(step)))

    def _linear(self, key: Key, pair: Pair, start: acb, there: Change, back: Change) -> acb | None:
        """The value at which an equation holds in which a change of it stands linearly."""
        sample, (left, right) = self.sample, pair
        value, ends = sample.values[key], []
        for step in (1, 2):
            sample.values[key] = back(there(value) + step)
            with suppress(Valueless):
                ends.append(sample.value(left) - sample.value(right))
        sample.values[key] = value
        if len(ends) < 2 or not is_zero(ends[1] - 2 * ends[0] + start):
            return None
        slope = ends[0] - start
        if is_zero(slope):
            return None
        found = there(value) - start / slope
        return back(found) if there is _ITSELF[0] or not is_zero(found) else None


def _solved_first(key: Key) -> tuple[object, ...]:
    """The order in which something is solved for: derivatives, functions, names."""
    return key[1:2] != ("(",) and len(key) == 1, -len(key), key


def _rooted(formula: Formula) -> Formula:
    """What is squared, if a formula is a square: it is given by it."""
    squares = isinstance(formula, Power) and formula.exponent == Number(2)
    return formula.children()[0] if squares else formula


def fields_of(pairs: Sequence[Pair]) -> dict[str, frozenset[str]]:
    """The unknown functions that some equations derive, with what they derive them by."""
    found: dict[str, frozenset[str]] = {}
    for node in (node for pair in pairs for side in pair for node in side.nodes()):
        if isinstance(node, Partial) and isinstance(node.argument, Name):
            name = node.argument.name
            found[name] = found.get(name, frozenset()) | {node.by}
    return found


def pairs_of(formula: Formula) -> list[Pair]:
    """The equations of a chain, but for members that leave something out."""
    if not isinstance(formula, Relation):
        return []
    signs = ("", *formula.signs)
    kept = [
        (one, sign in EQUALITIES)
        for one, sign in zip(formula.members, signs, strict=True)
        if not leaves_out(one)
    ]
    return [(one, other) for (one, _), (other, equal) in pairwise(kept) if equal]


def _is_total(left: Formula, fields: Mapping[str, frozenset[str]]) -> bool:
    """Whether it is the derivative of an unknown function by all that it is a function of."""
    if not isinstance(left, Derivative) or not isinstance(left.argument, Name):
        return False
    return len(fields.get(left.argument.name, ())) > 1


def _is_transformed(pair: Pair) -> bool:
    """Whether an equation of a chain transforms a formula, and gives no name."""
    return not any(isinstance(side, Name | Derivative | Number) for side in pair)


def has_integral(side: Formula) -> bool:
    """Whether a definite integral stands there: it need not rest on anything else."""
    nodes = side.nodes()
    return any(isinstance(node, Application) and node.function == INTEGRAL for node in nodes)


def leaves_out(member: Formula) -> bool:
    """Whether dots, or the word for a constant, stand in a formula."""
    return any(isinstance(node, Unwritten | Constant) for node in member.nodes())


@once
def written_out(formula: Formula) -> list[Formula]:
    """The formulas that one is, with its sums written out; none where that cannot be done."""
    with suppress(*NO_VALUE):
        return [*instances(formula)]
    return []
