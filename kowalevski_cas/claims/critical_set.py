r"""Critical sets: where all derivatives of a function along a level surface vanish."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import combinations, combinations_with_replacement, islice

from kowalevski_cas.arithmetic.derivation import gradient
from kowalevski_cas.arithmetic.numbers import rational
from kowalevski_cas.arithmetic.polynomials import Terms
from kowalevski_cas.arithmetic.tower import Element
from kowalevski_cas.claims.bench import Bench, Key
from kowalevski_cas.claims.cases import System
from kowalevski_cas.claims.claim import (
    AtPoint,
    Claim,
    Finding,
    Neighbour,
    conditions_of,
    counterexample,
    equation,
    green,
    refuted,
    show,
)
from kowalevski_cas.claims.membership import combination, combination_steps
from kowalevski_cas.notation import to_latex
from kowalevski_cas.proof.cases import Case
from kowalevski_cas.proof.outcome import Condition, Counterexample, Step, Verdict
from kowalevski_cas.stage import Stage, scalar
from kowalevski_cas.texts import Printed, Texts

Point = dict[str, object]
TRIES = 40
"""How many points of a case are looked at."""


@dataclass(frozen=True, eq=False)
class CriticalSet(Claim):
    r"""``equations`` define exactly the critical points of the printed function f on a level surface.

    With ``zero_level`` only the critical points on f = 0 are meant. ``level`` is
    the printed equation g = v of the surface. Weights of the variables under which
    the equations and g are homogeneous are found, and f is made homogeneous by
    powers of g/v, which are 1 on the surface; the derivatives
    :math:`g_i\partial_j-g_j\partial_i`, and :math:`\partial_i` where g is free of
    the variable, do not see them. They span the tangent space where the gradient
    of g is non-zero, which Euler's relation gives for v non-zero.

    *Forward*: f is a combination of the products of two of the equations, so that
    its differential vanishes with them. *Converse*: a tree of cases. Its targets
    are the derivatives, and the derivatives along the gradients and the cross
    product of the gradients of the equations in the variables that are not in g;
    every split is an identity that is checked. The loci of the scene are assumed
    away and tried once more. What rests on words: that a real product vanishes
    only with a factor, and a sum of squares only with each square.
    """

    equations: tuple[Printed, ...]
    level: Printed
    main: tuple[tuple[str, ...], ...] = ()
    zero_level: bool = False

    def decide(self, bench: Bench) -> Finding:
        """Divide the function by products of the equations, then split into cases."""
        stage = bench.stage(self.scene)
        function = self.homogeneous(bench)
        row = None if function is None else self._forward(bench)
        if function is None or row is None:
            found = self._moving_point(bench)
            return refuted(found) if found else Finding(Verdict.UNDECIDED)
        case = self._cases(bench)
        system = self._system(bench, stage)
        if not system.holds(case):
            return Finding(Verdict.UNDECIDED, message="a case split does not hold")
        steps: list[Step] = []
        if bench.explain:
            products = self._product_names()
            steps = combination_steps("the homogeneous function", row, stage, products)
            steps += self._steps(case, stage)
        if any(one.kind == "open" for one in case.nodes()):
            off = self._point_off_the_set(bench, case) if bench.refute else None
            if off is None:
                return Finding(Verdict.UNDECIDED, message="a case is left open")
            return replace(refuted(off, steps), message=self._on_zero_level(bench))
        used = [g for k, g in enumerate(self._conditions(stage)) if k in set(case.granted())]
        conditions = dict.fromkeys(c.tex for c in conditions_of(row, stage))
        conditions |= dict.fromkeys(used)
        return green(tuple(self._where_it_fails(bench, tex) for tex in conditions), steps)

    # -- the function and its derivatives --------------------------------------

    def function(self, stage: Stage) -> Element:
        """The printed function."""
        assert self.printed is not None
        return scalar(stage.texts.formula(self.printed), stage)

    def goals(self, stage: Stage) -> list[Element]:
        """The left sides of the equations of the set."""
        return [equation(printed, stage) for printed in self.equations]

    def surface(self, stage: Stage) -> tuple[Element, Element]:
        """Both sides of the equation of the surface."""
        left, right = stage.relation(self.level).members[:2]
        return scalar(left, stage), scalar(right, stage)

    def homogeneous(self, bench: Bench) -> Element | None:
        """The function made homogeneous; ``None`` if that is impossible."""

        def search(finder: Bench) -> tuple[int, ...] | None:
            from kowalevski_cas.search.weights import weights

            stage = finder.stage(self.scene)
            parts = [*self.goals(stage), self.surface(stage)[0]]
            return weights([element.terms().get(0, {}) for element in parts])

        stage = bench.stage(self.scene)
        function = self.function(stage)
        of = bench.found(("weights", self.id, *self.equations), search)
        level, value = self.surface(stage)
        if of is None or not rational(value) or function.denominator or function.is_zero:
            return None
        by_weight: dict[int, Terms] = {}
        for exponents, coefficient in function.terms().get(0, {}).items():
            by_weight.setdefault(_weight(exponents, of), {})[exponents] = coefficient
        (unit,) = {_weight(exponents, of) for exponents in level.terms()[0]}
        ratio, highest = level * value.inverse(), max(by_weight)
        total = stage.ring.zero
        for weight, part in by_weight.items():
            power, rest = divmod(highest - weight, unit)
            if rest:
                return None
            total = total + stage.ring.from_terms({0: part}) * ratio**power
        return total

    def derivatives(self, stage: Stage, function: Element) -> list[Element]:
        """The derivatives along a frame of tangent fields, those free of the level first."""
        names = stage.scene.variables
        slopes = gradient(self.surface(stage)[0], names)
        partial = gradient(function, names)
        on = [k for k, slope in enumerate(slopes) if not slope.is_zero]
        free = [partial[k] for k in range(len(names)) if k not in on]
        return free + [
            slopes[i] * partial[j] - slopes[j] * partial[i] for i, j in combinations(on, 2)
        ]

    def _system(self, bench: Bench, stage: Stage) -> System:
        """The critical equations and consequences of them, the set, and what is granted."""
        function = self.homogeneous(bench)
        assert function is not None
        critical = self.derivatives(stage, function)
        goals = self.goals(stage)
        level = self.surface(stage)[0]
        names = [
            name
            for name, slope in zip(
                stage.scene.variables, gradient(level, stage.scene.variables), strict=True
            )
            if slope.is_zero
        ]
        slopes = [gradient(goal, tuple(names)) for goal in goals]
        fields = [*slopes]
        if len(names) == 3:
            fields += [_cross(a, b) for a, b in combinations(slopes, 2)]
        targets = [*critical, *(_dot(field, critical) for field in fields)]
        if self.zero_level:
            targets.append(function)
        granted = [scalar(stage.formula(tex), stage) for tex in self._conditions(stage)]
        return System(stage.ring, targets, goals, [*granted, level])

    @staticmethod
    def _conditions(stage: Stage) -> list[str]:
        return [to_latex(formula) for formula in stage.landmarks()]

    # -- both directions -------------------------------------------------------

    def _forward(self, bench: Bench) -> list[Element] | None:
        def target(stage: Stage) -> Element:
            finder = bench if stage is bench.stage(self.scene) else bench.finder
            function = self.homogeneous(finder)
            assert function is not None
            return function

        def products(stage: Stage) -> list[Element]:
            return [a * b for a, b in combinations_with_replacement(self.goals(stage), 2)]

        return combination(bench, self.scene, self._key("forward"), target, products, self.main)

    def _cases(self, bench: Bench) -> Case:
        def search(finder: Bench) -> Case:
            from kowalevski_cas.search.cases import Splitter

            stage = finder.stage(self.scene)
            system = self._system(finder, stage)
            zero = stage.ring.polynomials.zero
            targets, goals, granted = (
                [element.parts.get(0, zero) for element in elements]
                for elements in (system.targets, system.goals, system.granted)
            )
            return Splitter(stage.ring.polynomials, targets, goals, granted).case()

        return Case.read(bench.found(self._key("cases"), search))

    def _key(self, kind: str) -> Key:
        return (kind, self.id, "zero level" if self.zero_level else "everywhere")
