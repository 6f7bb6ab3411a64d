"""Dimension and independence, by exact ranks of differentials at exact points."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import combinations, islice

from kowalevski_cas.arithmetic.derivation import gradient
from kowalevski_cas.arithmetic.numbers import rank
from kowalevski_cas.arithmetic.points import ExactPoint, Question
from kowalevski_cas.arithmetic.tower import Element
from kowalevski_cas.claims.bench import Bench, Key
from kowalevski_cas.claims.claim import Claim, Finding, Neighbour, ask, green, refuted
from kowalevski_cas.claims.conditions import conditions_of
from kowalevski_cas.claims.formulas import equation, members
from kowalevski_cas.claims.membership import combination
from kowalevski_cas.claims.points import AtPoint
from kowalevski_cas.notation import Number, Relation, to_latex
from kowalevski_cas.proof.outcome import Condition, Counterexample, Step, Verdict
from kowalevski_cas.paper.scene import Locus
from kowalevski_cas.stage import Stage, scalar
from kowalevski_cas.paper.texts import Printed, Texts

TRIES = 3
"""At how many points the rank is taken at most; one with full rank is enough."""


@dataclass(frozen=True, eq=False)
class Set(Claim):
    """What claims about a set have in common.

    ``levels`` are printed integrals whose values are fixed, ``equations`` the
    printed equations of the set.
    """

    levels: tuple[Printed, ...]
    equations: tuple[Printed, ...]

    def constraints(self, stage: Stage) -> list[Element]:
        """The left sides of the equations of the set."""
        return [equation(printed, stage) for printed in self.equations]

    def level_functions(self, stage: Stage) -> list[Element]:
        """The integrals whose values are fixed."""
        return [scalar(members(stage.relation(p))[0], stage) for p in self.levels]

    def rank_at_a_point(
        self, bench: Bench, key: Key, locus: Locus | None, functions: Sequence[int] | None = None
    ) -> tuple[int, AtPoint] | None:
        """The largest rank found of the differentials, and the point where it was taken.

        ``functions`` are the indices of the equations to be used, all if ``None``.
        """

        def system(stage: Stage) -> list[Element]:
            equations = self.constraints(stage)
            chosen = equations if functions is None else [equations[k] for k in functions]
            there = stage.equations(locus.equations) if locus is not None else []
            return [*self.level_functions(stage), *chosen, *there, *self.extra(stage)]

        def search(finder: Bench) -> ExactPoint | None:
            from kowalevski_cas.search.real import real_points

            stage = finder.stage(self.scene)
            zero = self.constraints(stage)
            if functions is not None:
                zero = [zero[k] for k in functions]
            if locus is not None:
                zero = [*zero, *stage.equations(locus.equations)]
            avoid = [scalar(formula, stage) for formula in stage.granted()]
            best: tuple[int, ExactPoint] | None = None
            for point in islice(real_points(stage, zero, avoid), TRIES):
                found = _rank(stage, system(stage), AtPoint(stage, point))
                if best is None or found > best[0]:
                    best = (found, point)
                if found == len(system(stage)):
                    break
            return best[1] if best else None

        point = bench.found(("rank", self.id, key), search)
        if point is None:
            return None
        stage = bench.stage(self.scene)
        at = AtPoint(stage, point)
        on_set = self.constraints(stage)
        if functions is not None:
            on_set = [on_set[k] for k in functions]
        if any(not at(element).is_zero for element in on_set):
            return None
        return _rank(stage, system(stage), at), at

    def rank_of(self, bench: Bench, rank: int) -> Question:
        """Whether all differentials have this rank on the set."""
        stage = bench.stage(self.scene)
        system = [*self.level_functions(stage), *self.constraints(stage), *self.extra(stage)]
        rows = [gradient(function, self.scene.variables) for function in system]
        return ask(stage, given=self.constraints, rows=rows, rank=rank)

    def extra(self, stage: Stage) -> list[Element]:
        """Further functions whose differentials take part."""
        return []

    def places(self) -> Iterator[Printed]:
        yield from super().places()
        yield from (*self.levels, *self.equations)


@dataclass(frozen=True, eq=False)
class Dimension(Set):
    """The set has this dimension: its equations have independent differentials at a point of it."""

    dimension: int

    def decide(self, bench: Bench) -> Finding:
        """Take the rank at an exact point; then on each locus where the set may be larger."""
        found = self.rank_at_a_point(bench, "generic", None)
        if found is None:
            return Finding(Verdict.UNDECIDED, message="no exact point of the set was found")
        stage = bench.stage(self.scene)
        number = len(self.scene.variables)
        value, at = found
        full = len(self.levels) + len(self.equations)
        if value < full:
            return Finding(Verdict.UNDECIDED, message="dependent equations at the points tried")
        witness = self._witness(at, number - value, number)
        if number - value != self.dimension:
            return refuted(witness)
        steps = [Step(
            f"At {_values(at)}, {full} differentials are independent in the space of dimension "
            f"{number}, so that the set near it is a manifold of dimension {number - value}",
        )] if bench.explain else []  # fmt: skip
        conditions = [*conditions_of(self.constraints(stage), stage)]
        for locus in self.scene.loci:
            conditions += self._on_locus(bench, locus)
        return green(tuple(conditions), steps)

    def questions(self, bench: Bench) -> Iterator[Question]:
        yield self.rank_of(bench, len(self.scene.variables) - self.dimension)

    def _on_locus(self, bench: Bench, locus: Locus) -> list[Condition]:
        """A condition, if on the locus some equations say nothing and the dimension is another."""
        rest = [k for k in range(len(self.equations)) if not self._is_empty(bench, locus, k)]
        if len(rest) == len(self.equations):
            return []
        found = self.rank_at_a_point(bench, locus.words, locus, rest)
        number = len(self.scene.variables)
        if found is None or number - found[0] == self.dimension:
            return []
        words = f"for {locus.words} the set has dimension {number - found[0]}"
        condition = bench.stage(self.scene).formula(locus.condition)
        return [Condition(condition, words, self._witness(found[1], number - found[0], number))]

    def _is_empty(self, bench: Bench, locus: Locus, index: int) -> bool:
        """Whether an equation of the set holds everywhere on the locus."""
        row = combination(
            bench,
            self.scene,
            (self.id, locus.words, index),
            lambda stage: self.constraints(stage)[index],
            lambda stage: stage.equations(locus.equations),
        )
        return row is not None

    def _witness(self, at: AtPoint, dimension: int, number: int) -> Counterexample:
        words = "the dimension by the rank at this point, and the dimension claimed"
        return Counterexample(at.shown(), Number(dimension), Number(self.dimension), words)

    def neighbours(self, texts: Texts) -> Iterator[Neighbour]:
        for dimension in (self.dimension - 1, self.dimension + 1):
            claim = replace(self, dimension=dimension)
            yield Neighbour(f"dimension {dimension} instead of {self.dimension}", claim, texts)


@dataclass(frozen=True, eq=False)
class Independence(Set):
    """Functions are independent on the set: their differentials and those of the set are.

    ``functions`` are the first members of printed equations.
    """

    functions: tuple[Printed, ...]

    def places(self) -> Iterator[Printed]:
        yield from super().places()
        yield from self.functions

    def extra(self, stage: Stage) -> list[Element]:
        return [scalar(members(stage.relation(p))[0], stage) for p in self.functions]

    def decide(self, bench: Bench) -> Finding:
        """Take the rank of all differentials at an exact point of the set."""
        found = self.rank_at_a_point(bench, "independence", None)
        if found is None:
            return Finding(Verdict.UNDECIDED, message="no exact point of the set was found")
        value, at = found
        stage = bench.stage(self.scene)
        full = len(self.levels) + len(self.equations) + len(self.functions)
        if value < full:
            # A low rank at a few points proves nothing; parallel differentials do.
            if not self._is_redundant(stage):
                return Finding(Verdict.UNDECIDED, message="dependent at the points tried")
            words = "the rank of the differentials, here as everywhere, and that for independence"
            return refuted(Counterexample(at.shown(), Number(value), Number(full), words))
        steps = [Step(
            f"At {_values(at)}, all {full} differentials are independent",
        )] if bench.explain else []  # fmt: skip
        return green(conditions_of(self.constraints(stage), stage), steps)

    def questions(self, bench: Bench) -> Iterator[Question]:
        yield self.rank_of(bench, len(self.levels) + len(self.equations) + len(self.functions))

    def _is_redundant(self, stage: Stage) -> bool:
        """Whether the differentials of two functions or levels are parallel everywhere."""
        functions = [*self.extra(stage), *self.level_functions(stage)]
        rows = [gradient(function, self.scene.variables) for function in functions]
        return any(
            all((f[i] * g[j] - f[j] * g[i]).is_zero for i, j in combinations(range(len(f)), 2))
            for f, g in combinations(rows, 2)
        )

    def neighbours(self, texts: Texts) -> Iterator[Neighbour]:
        first, *_ = self.functions
        claim = replace(self, functions=(*self.functions, first))
        yield Neighbour("with one of the functions taken twice", claim, texts)


def _rank(stage: Stage, functions: list[Element], at: AtPoint) -> int:
    names = stage.scene.variables
    return rank([[at(partial) for partial in gradient(f, names)] for f in functions])


def _values(at: AtPoint) -> str:
    """A point, as words for the report."""
    pairs = (Relation((name, value), ("=",)) for name, value in at.values_shown().items())
    return ", ".join(f"${to_latex(pair)}$" for pair in pairs)
