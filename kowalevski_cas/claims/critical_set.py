r"""Critical sets: where all derivatives of a function along a level surface vanish."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import partial
from itertools import combinations, combinations_with_replacement, islice

from kowalevski_cas.arithmetic.derivation import gradient
from kowalevski_cas.arithmetic.numbers import rational
from kowalevski_cas.arithmetic.polynomials import Terms
from kowalevski_cas.arithmetic.tower import Element
from kowalevski_cas.claims.bench import Bench
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
    locus_of,
    refuted,
    show,
    show_number,
)
from kowalevski_cas.claims.membership import combination, combination_steps
from kowalevski_cas.notation import to_latex
from kowalevski_cas.proof.cases import Case
from kowalevski_cas.proof.outcome import Condition, Counterexample, Step, Verdict
from kowalevski_cas.stage import Stage, scalar
from kowalevski_cas.texts import Printed, Texts

Weights = tuple[int, ...] | None
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
        weights = self._weights(bench)
        row = self._forward(bench, weights)
        if row is None:
            moving = self._moving_point(bench)
            return refuted(moving) if moving else Finding(Verdict.UNDECIDED)
        case = self._cases(bench, weights)
        if not self._system(stage, weights).holds(case):
            return Finding(Verdict.UNDECIDED, message="a split into cases does not hold")
        steps = self._steps(row, case, stage) if bench.explain else []
        if any(one.kind == "open" for one in case.nodes()):
            off = self._point_off_the_set(bench, case, weights)
            if off is None:
                return Finding(Verdict.UNDECIDED, message="a case is left open")
            return replace(refuted(off, steps), message=self._on_zero_level(bench))
        conditions = dict.fromkeys(c.tex for c in conditions_of(row, stage))
        needed = set(case.granted())
        conditions |= {tex: None for k, tex in enumerate(_loci(stage)) if k in needed}
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

    def homogeneous(self, stage: Stage, weights: Weights) -> Element | None:
        """The function made homogeneous; ``None`` if that is impossible."""
        function = self.function(stage)
        level, value = self.surface(stage)
        if weights is None or not rational(value) or function.denominator or function.is_zero:
            return None
        parts: dict[int, Terms] = {}
        for exponents, coefficient in function.terms()[0].items():
            parts.setdefault(_weight(exponents, weights), {})[exponents] = coefficient
        (unit,) = {_weight(exponents, weights) for exponents in level.terms()[0]}
        ratio = level * value.inverse()
        total = stage.ring.zero
        for weight, part in parts.items():
            power, rest = divmod(max(parts) - weight, unit)
            if rest:
                return None
            total = total + stage.ring.from_terms({0: part}) * ratio**power
        return total

    def _weights(self, bench: Bench) -> Weights:
        def search(finder: Bench) -> Weights:
            from kowalevski_cas.search.weights import weights

            stage = finder.stage(self.scene)
            elements = [*self.goals(stage), self.surface(stage)[0]]
            return weights([element.terms().get(0, {}) for element in elements])

        return bench.found(("weights", self.id), search)

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

    def _system(self, stage: Stage, weights: Weights) -> System:
        """The critical equations and consequences of them, the set, and what is granted."""
        function = self.homogeneous(stage, weights)
        assert function is not None
        critical = self.derivatives(stage, function)
        goals, level = self.goals(stage), self.surface(stage)[0]
        names = stage.scene.variables
        slopes = zip(names, gradient(level, names), strict=True)
        free = tuple(name for name, slope in slopes if slope.is_zero)
        fields = [gradient(goal, free) for goal in goals]
        if len(free) == 3:
            fields += [_cross(a, b) for a, b in combinations(fields, 2)]
        targets = [*critical, *(_dot(field, critical) for field in fields)]
        if self.zero_level:
            targets.append(function)
        granted = [scalar(stage.formula(tex), stage) for tex in _loci(stage)]
        return System(stage.ring, targets, goals, [*granted, level])

    # -- both directions -------------------------------------------------------

    def _forward(self, bench: Bench, weights: Weights) -> list[Element] | None:
        if self.homogeneous(bench.stage(self.scene), weights) is None:
            return None

        def target(stage: Stage) -> Element:
            return self.homogeneous(stage, weights) or stage.ring.zero

        def products(stage: Stage) -> list[Element]:
            return [a * b for a, b in combinations_with_replacement(self.goals(stage), 2)]

        return combination(bench, self.scene, (self.id, "forward"), target, products, self.main)

    def _cases(self, bench: Bench, weights: Weights) -> Case:
        def search(finder: Bench) -> Case:
            from kowalevski_cas.search.cases import Splitter

            stage = finder.stage(self.scene)
            system = self._system(stage, weights)
            zero = stage.ring.polynomials.zero
            targets, goals, granted = (
                [element.parts.get(0, zero) for element in elements]
                for elements in (system.targets, system.goals, system.granted)
            )
            return Splitter(stage.ring.polynomials, targets, goals, granted).case()

        level = "zero level" if self.zero_level else "any level"
        return Case.read(bench.found(("cases", self.id, level), search))

    # -- points where it fails -------------------------------------------------

    def _moving_point(self, bench: Bench) -> Counterexample | None:
        """A point of the set, off the loci, that is not critical."""
        loci = _loci(bench.stage(self.scene))

        def pairs(stage: Stage) -> list[tuple[Element, Element]]:
            off = _product(stage, loci)
            rates = self.derivatives(stage, self.function(stage))
            return [(rate * off, stage.ring.zero) for rate in rates]

        def zero(stage: Stage) -> list[Element]:
            level, value = self.surface(stage)
            return [*self.goals(stage), level - value]

        times = "".join(f" times ${tex}$" for tex in loci)
        words = f"a derivative of the function{times} at this point of the set, and zero"
        return counterexample(bench, self.scene, self.id, pairs, zero, words)

    def _where_it_fails(self, bench: Bench, tex: str) -> Condition:
        """A condition with a point of its locus that lies on the set and is not critical."""
        condition = Condition(tex, f"${tex}\\ne 0$: it is divided by")
        locus = locus_of(condition, bench.stage(self.scene))
        if locus is None:
            return condition

        def there(stage: Stage) -> list[Element]:
            return stage.equations(locus.equations)

        def goal(stage: Stage, k: int) -> Element:
            return self.goals(stage)[k]

        left = [
            k
            for k in range(len(self.equations))
            if combination(bench, self.scene, (self.id, locus.words, k), partial(goal, k=k), there)
            is None
        ]

        def zero(stage: Stage) -> list[Element]:
            level, value = self.surface(stage)
            return [*there(stage), level - value, *(goal(stage, k) for k in left)]

        def pairs(stage: Stage) -> list[tuple[Element, Element]]:
            rates = self.derivatives(stage, self.function(stage))
            return [(rate, stage.ring.zero) for rate in rates]

        words = "a derivative of the function along the surface at this point of the set, and zero"
        found = counterexample(bench, self.scene, (self.id, locus.words), pairs, zero, words)
        if found is None:
            return condition
        return Condition(tex, f"it fails for {locus.words}", found)

    def _point_off_the_set(
        self, bench: Bench, case: Case, weights: Weights
    ) -> Counterexample | None:
        """A critical point where an equation of the set fails, in one of the open cases."""
        if not bench.refute:
            return None

        def search(finder: Bench) -> Point | None:
            from kowalevski_cas.search.real import real_points

            stage = finder.stage(self.scene)
            system = self._system(stage, weights)
            level, value = self.surface(stage)
            cases = [one for one in case.nodes() if one.kind == "open"]
            for one in sorted(cases, key=lambda one: sum(map(len, one.known))):
                known = [system.element(terms) for terms in one.known]
                for point in islice(real_points(stage, [*known, level - value]), TRIES):
                    if self._is_off(system, AtPoint(stage, point)) is not None:
                        return point
            return None

        point = bench.found(("critical point", self.id), search)
        if point is None:
            return None
        stage = bench.stage(self.scene)
        at = AtPoint(stage, point)
        failing = self._is_off(self._system(stage, weights), at)
        level, value = self.surface(stage)
        if failing is None or not at(level - value).is_zero:
            return None
        words = (
            "all derivatives of the function along the surface vanish at this point; "
            f"left minus right side of {self.equations[failing].place} there, and zero"
        )
        left = show_number(at(self.goals(stage)[failing]))
        return Counterexample(at.shown(), left, "0", words)

    @staticmethod
    def _is_off(system: System, at: AtPoint) -> int | None:
        """The equation that fails at a point where all targets vanish and nothing granted does."""
        if any(at(expression).is_zero for expression in system.granted):
            return None
        if any(not at(target).is_zero for target in system.targets):
            return None
        return next((k for k, goal in enumerate(system.goals) if not at(goal).is_zero), None)

    def _on_zero_level(self, bench: Bench) -> str:
        """The nearest true statement, if it is the one on the zero level."""
        finding = replace(self, zero_level=True).decide(bench)
        if self.zero_level or not finding.verdict.green:
            return ""
        where = ", ".join(f"${condition.tex}\\ne 0$" for condition in finding.conditions)
        return f"it holds among the critical points where the function vanishes, for {where}"

    # -- the report --------------------------------------------------------------

    def _steps(self, row: Sequence[Element], case: Case, stage: Stage) -> list[Step]:
        names = [f"({printed.place})" for printed in self.equations]
        products = [a + b for a, b in combinations_with_replacement(names, 2)]
        steps = combination_steps("the function made homogeneous", row, stage, products)
        for one in case.nodes():
            known = ",\\ ".join(f"{_shown(terms, stage)}=0" for terms in one.known)
            where = f"For ${known}$" if known else "Everywhere"
            if one.kind == "split":
                factors = [rf"\left({_shown(f, stage)}\right)" for f, _ in one.reductions[0].factors]
                steps.append(Step(f"{where} it follows that", "".join(factors) + "=0"))
            elif one.kind == "open":
                steps.append(Step(f"{where} all derivatives vanish, and no more follows."))
        return steps

    def neighbours(self, texts: Texts) -> Iterator[Neighbour]:
        if not self.zero_level:
            words = "only the critical points where the function vanishes"
            yield Neighbour(words, replace(self, zero_level=True), texts)
        yield from super().neighbours(texts)

    def places(self) -> Iterator[Printed]:
        yield from super().places()
        yield from (*self.equations, self.level)


def _loci(stage: Stage) -> list[str]:
    return [to_latex(formula) for formula in stage.landmarks()]


def _weight(exponents: Sequence[int], weights: Sequence[int]) -> int:
    return sum(e * w for e, w in zip(exponents, weights, strict=True))


def _shown(terms: Terms, stage: Stage) -> str:
    return show(stage.ring.from_terms({0: terms}), stage)


def _dot(field: Sequence[Element], rates: Sequence[Element]) -> Element:
    """A combination of the first of the rates."""
    total = rates[0].ring.zero
    for component, rate in zip(field, rates[: len(field)], strict=True):
        total = total + component * rate
    return total


def _cross(a: Sequence[Element], b: Sequence[Element]) -> list[Element]:
    return [a[i] * b[j] - a[j] * b[i] for i, j in ((1, 2), (2, 0), (0, 1))]


def _product(stage: Stage, factors: Sequence[str]) -> Element:
    result = stage.ring.one
    for tex in factors:
        result = result * scalar(stage.formula(tex), stage)
    return result
