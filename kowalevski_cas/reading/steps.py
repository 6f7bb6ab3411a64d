"""A step of a derivation, and whether it follows from what stands before it, at samples."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from functools import cached_property
from itertools import product

from flint import acb

from kowalevski_cas.algebra.keys import Key, variable_of
from kowalevski_cas.algebra.quadrature import INFINITE
from kowalevski_cas.algebra.samples import Sample, Valueless, is_zero
from kowalevski_cas.notation import (
    Application,
    Derivative,
    Formula,
    Name,
    Number,
    Partial,
    Power,
    Relation,
    Vocabulary,
)
from kowalevski_cas.paper.transcendental import PI
from kowalevski_cas.reading.components import Components, chain_rules, dimension
from kowalevski_cas.reading.expansions import SMALL, Expansion, by_likelihood, expansions_of, holds
from kowalevski_cas.reading.premises import (
    NO_VALUE,
    Pair,
    SolvedSample,
    fields_of,
    has_integral,
    pairs_of,
    written_out,
)
from kowalevski_cas.reading.printed_brackets import printed_bracket, with_bracket

SAMPLES = 3
"""At how many samples a step holds that is said to follow."""

POLES = 9
"""At how many more samples one is looked at with an integral, which may have a pole on its way."""

MANY = 60
"""How many equations before a step are looked at."""

Samples = list[Sample]

_VARIABLES = (("t", r"\tau", "x"), ("s", r"\xi", r"\theta"))
"""By what a prime may derive, the likelier ones first."""


class PrintedBefore:
    """What stands before a step, solved once at each sample."""

    def __init__(
        self,
        formula: Formula,
        before: Sequence[Formula],
        terms: Sequence[Formula],
        words: Vocabulary,
        arguments: Mapping[str, str],
    ) -> None:
        self.formulas, self.terms = frozenset(before), terms
        self._arguments = arguments
        printed = [*before, formula]
        size = dimension(printed)
        self.in_space = size > 1
        letters = {node.name for one in printed for node in one.nodes() if isinstance(node, Name)}
        self._components = Components(words, letters, size)
        self._bracket = printed_bracket(before)
        self.printed = {node for one in printed for node in one.nodes()}
        supposed = [*before, *chain_rules(printed)]
        self.premises = [pair for one in supposed for pair in self.pairs(one)][-MANY:]
        own = (side for pair in self.pairs(formula) for side in pair)
        sides = [*(side for pair in self.premises for side in pair), *own]
        self.nodes = [node for side in sides for node in side.nodes()]
        self.names = {node.name for node in self.nodes if isinstance(node, Name)}
        given = (side for pair in self.premises for side in pair)
        known = set[str]().union(*(side.names() for side in given))
        slopes = {name for name in self.names if "'" in name and name.rstrip("'") in arguments}
        self.known = frozenset(known | {name for name in slopes if name.rstrip("'") in known})
        self.rates = {node for node in self.nodes if isinstance(node, Derivative)}
        self._solved: dict[tuple[int, tuple[Key, float] | None], SolvedSample] = {}
        self._expanded: dict[tuple[Formula, int], list[tuple[Samples, list[acb]]]] = {}

    def pairs(self, formula: Formula) -> list[Pair]:
        """The equations that a formula is, by components where vectors are multiplied."""
        formula = formula if self._bracket is None else with_bracket(formula, self._bracket)
        found = [pair for one in written_out(formula) for pair in pairs_of(one)]
        if not self.in_space:
            return found
        with suppress(Valueless, ValueError):
            return [
                own
                for pair in found
                for one in self._components.of(Relation(pair, ("=",)))
                for own in pairs_of(one)
            ]
        return []

    @property
    def factors(self) -> set[Formula]:
        """The functions of one argument that are printed: each may be a factor."""
        return {node for node in self.printed if _is_of_one(node)}

    def solved(self, seed: int, scaled: tuple[Key, float] | None = None) -> SolvedSample:
        """A sample at which the premises hold, and something is small, or large."""
        if (seed, scaled) not in self._solved:
            sample = self.sample(seed)
            sample.scaled = scaled
            self._solved[seed, scaled] = SolvedSample(sample, self.premises, self.squared)
        return self._solved[seed, scaled]

    def expanded(self, expansion: Expansion, seed: int) -> list[tuple[Samples, list[acb]]]:
        """What is expanded, at samples where some letter is small, or large, for each of them."""
        whole = expansion.whole
        if (whole, seed) not in self._expanded:
            found = self._expanded[whole, seed] = []
            for name, factors in product(by_likelihood(self.names, expansion.terms), SMALL):
                with suppress(*NO_VALUE):
                    samples = [self.solved(seed, ((name,), factor)) for factor in factors]
                    if not any((name,) in one.determined for one in samples):
                        values = [one.sample.value(whole) for one in samples]
                        found.append(([one.sample for one in samples], values))
        return self._expanded[whole, seed]

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

    def has_vectors_of(self, formula: Formula) -> bool:
        """Whether the vectors in a step that multiplies them stand before it, but for new ones."""
        pairs = self.pairs(formula) if self.in_space else []
        new = {side.name for pair in pairs for side in pair if isinstance(side, Name)}
        own = {name for pair in pairs for side in pair for name in side.names()}
        return {name for name in own if "[" in name} <= self.known | new

    def has_all_of(self, formula: Formula) -> bool:
        """Whether all that stands in a step stands before it, but for a new name that it gives."""
        given = {node for pair in self.premises for side in pair for node in side.nodes()}
        pairs = self.pairs(formula)
        new = {left for left, _ in pairs if isinstance(left, Name)}
        own = (node for pair in pairs for side in pair for node in side.nodes())
        atoms = {node for node in own if isinstance(node, Name | Derivative | Partial)}
        rated = {node.argument for node in atoms if isinstance(node, Derivative)}
        total = {node for node in atoms if isinstance(node, Partial) and node.argument in rated}
        return atoms - rated - total <= given | new | {Name(PI), *self._total(pairs)}

    def _total(self, pairs: Sequence[Pair]) -> set[Formula]:
        """The rates of functions that a step gives by their partial derivatives."""
        return {left for left, right in pairs if isinstance(left, Derivative)}

    def agrees(self) -> bool:
        """Whether what stands before a step holds together: else it may be of several cases."""
        return self.solved(0).agrees(self.premises)

    def is_unit(self, name: str) -> bool:
        """Whether a name stands for 0, 1 or -1: nobody sees whether it is a factor."""
        with suppress(*NO_VALUE):
            value = self.solved(0).sample.value(Name(name))
            return is_zero(value * (value * value - 1))
        return False

    def sample(self, seed: int) -> Sample:
        """A sample at which all is free; a function of what moves does so, too."""
        sample = Sample(seed, {}, (), {}, self._primed)
        partials = (node for node in self.nodes if isinstance(node, Partial))
        pairs = ((sample.key(one.argument), one.by) for one in partials)
        slopes = frozenset((*key, by) for key, by in pairs if key)
        keys = [sample.key(rate) for rate in self.rates]
        rated = {(key[0], key[-1]) for key in keys if key}
        rated |= {(key[0], by) for key in slopes for name, by in rated if (name,) == key[1:]}
        found = Sample(seed, {}, rated, self._fields, self._primed)
        found.slopes, found.arguments = slopes, self._arguments
        return found

    @cached_property
    def _fields(self) -> dict[str, frozenset[str]]:
        """The functions of which a rate is printed by those of all that they are functions of."""
        total = (pair for pair in self.premises if isinstance(pair[0], Derivative))
        found = [fields_of([pair]) for pair in total]
        return {name: by for one in found for name, by in one.items() if len(by) > 1}

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
        self.pairs = before.pairs(formula)

    def fails(self) -> bool:
        """Whether it says something of what is known, and that is false."""
        seeds = range(1 + POLES if self._integrated else 1)
        return next((found for found in map(self._at, seeds) if found is not None), True) is False

    def follows(self) -> bool:
        """Whether it says something of what is known, and that is true, at all samples.

        At some of them an integral may have no value.
        """
        held, seeds = 0, range(SAMPLES + POLES if self._integrated else SAMPLES)
        for found in map(self._at, seeds):
            if found is False or (found is None and not self._integrated):
                return False
            held += bool(found)
            if held == SAMPLES:
                return True
        return False

    def _at(self, seed: int) -> bool | None:
        """Whether the step holds at a sample; ``None`` if it says nothing there."""
        with suppress(*NO_VALUE):
            solved, given = self.before.solved(seed), self.solving
            telling = self._integral or [*self._telling()]
            exact = solved.holds(telling, self._fields, of_chain=len(self.pairs) > 1)
            if isinstance(given, Name):
                return exact or self._solves(given, seed)
            if self._expansions and exact is None:
                return all(self._expands(one, seed) for one in self._expansions)
            if given is not None and exact is None:
                return self._solves(given, seed)
            if exact is None or (not exact and self._integrated):
                moving = [pair for pair in self._rates if not is_zero(solved.sample.value(pair[0]))]
                return solved.holds(moving, self._fields) if moving else exact
            return exact
        return None

    @cached_property
    def _expansions(self) -> list[Expansion]:
        """What it expands, unless that is a new name."""
        written = (each for one in written_out(self.formula) for each in expansions_of(one))
        return [
            one
            for one in written
            if not isinstance(one.whole, Name) or one.whole.name in self.before.known
        ]

    def _expands(self, expansion: Expansion, seed: int) -> bool:
        """Whether an expansion holds where some letter is small, or large."""
        for samples, whole in self.before.expanded(expansion, seed):
            with suppress(*NO_VALUE):
                terms = [[one.value(term) for one in samples] for term in expansion.terms]
                if holds(whole, terms):
                    return True
        return False

    def _telling(self) -> Iterator[Pair]:
        """The equations that say more than what a new name on the right is."""
        known, fields = {*self.before.known, PI, INFINITE}, {*map(Name, self._fields)}
        for left, right in self.pairs:
            known |= left.names()
            total = isinstance(left, Derivative) and left.argument in fields
            if total or right.names() <= known:
                yield left, right

    @cached_property
    def _integrated(self) -> bool:
        """Whether an integral stands in the step, which may be one by what moves."""
        return any(has_integral(side) for pair in self.pairs for side in pair)

    @cached_property
    def _rates(self) -> list[Pair]:
        """The derivatives of both sides, by what derives before: a step may integrate them."""
        marks = {rate.mark for rate in self.before.rates}
        if len(marks) != 1 or len(self.pairs) != 1:
            return []
        (mark,), ((left, right),) = marks, self.pairs
        if isinstance(left, Name | Derivative | Number):
            return []
        constant = isinstance(right, Name) and right.name != variable_of(mark, "")
        if constant and Derivative(right, mark) not in self.before.rates:
            return [(Derivative(left, mark), Number(0))]
        return [(Derivative(left, mark), Derivative(right, mark))]

    @cached_property
    def solving(self) -> Formula | None:
        """What is given by the step, and of which only derivatives stand before it."""
        match self.pairs:
            case [(Name() | Derivative() as left, right)] if left not in right.nodes():
                others = [pair for pair in self.before.premises if left in pair]
                if not others and any(_derives(left, pair) for pair in self.before.premises):
                    return left
        return None

    def _solves(self, given: Formula, seed: int) -> bool | None:
        """Whether what is given solves the last equation of its derivatives."""
        equations = [pair for pair in self.before.premises if _derives(given, pair)]
        own = given
        while isinstance(own, Derivative):
            own = own.argument
        rest = [pair for pair in self.before.premises if pair not in equations and own not in pair]
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
        return fields_of(self.pairs)


def _is_of_one(node: Formula) -> bool:
    """Whether a node is a function of one argument, but an integral: it may be a factor."""
    return isinstance(node, Application) and len(node.arguments) == 1


def _derives(given: Formula, pair: Pair) -> bool:
    """Whether a name, or a derivative of one, is derived in an equation."""
    for node in (node for side in pair for node in side.nodes()):
        if isinstance(node, Derivative | Partial) and node.argument == given:
            return True
    return False
