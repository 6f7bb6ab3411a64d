r"""Critical equations: the derivatives of a function along a level surface."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import combinations, permutations

from kowalevski_cas.arithmetic.derivation import gradient
from kowalevski_cas.arithmetic.numbers import rational
from kowalevski_cas.arithmetic.polynomials import Terms
from kowalevski_cas.arithmetic.tower import Element
from kowalevski_cas.claims.cases import System
from kowalevski_cas.notation import Formula, Relation
from kowalevski_cas.stage import Stage, StageError, scalar
from kowalevski_cas.paper.texts import Printed, Texts

PYTHAGOREAN = Fraction(3, 5)
Weights = tuple[int, ...] | None


@dataclass(frozen=True)
class CriticalEquations:
    r"""A printed function f, ``equations`` of a set, and a surface ``level`` of the form g = v.

    Weights of the variables are found under which the equations and g are
    homogeneous, and f is made homogeneous by powers of g/v, which is 1 on the
    surface. The derivatives :math:`g_i\partial_j-g_j\partial_i`, and
    :math:`\partial_i` where g is free of the variable, do not see these powers,
    and span the tangent space: by Euler's relation the gradient of g does not
    vanish where v is non-zero. With ``zero_level`` f = 0 is one more equation.
    """

    texts: Texts
    printed: Printed
    equations: tuple[Printed, ...]
    level: Printed
    zero_level: bool
    weights: Weights = None

    def function(self, stage: Stage) -> Element:
        """The printed function."""
        return scalar(self.texts.formula(self.printed), stage)

    def goals(self, stage: Stage) -> list[Element]:
        """The left minus the right sides of the equations of the set."""
        return [_difference(self._sides(printed, stage)) for printed in self.equations]

    def surface(self, stage: Stage) -> tuple[Element, Element]:
        """Both sides of the equation of the surface."""
        return self._sides(self.level, stage)

    def beside(self, stage: Stage) -> Element:
        """What vanishes on the surface."""
        return _difference(self.surface(stage))

    def sections(self, stage: Stage) -> Iterator[list[Element]]:
        """Planes that a quadric meets in rational points: a coordinate 0, another one 3/5."""
        names = stage.scene.variables
        slopes = zip(names, gradient(self.surface(stage)[0], names), strict=True)
        for first, second in permutations([n for n, slope in slopes if not slope.is_zero], 2):
            shifted = stage.ring.generator(second) - stage.ring.number(PYTHAGOREAN)
            yield [stage.ring.generator(first), shifted]
        yield []

    def rates(self, stage: Stage) -> list[Element]:
        """The derivatives of the function as it is printed."""
        return self.derivatives(stage, self.function(stage))

    def _sides(self, printed: Printed, stage: Stage) -> tuple[Element, Element]:
        formula = self.texts.formula(printed)
        if not isinstance(formula, Relation):
            raise StageError(f"an equation is expected at {printed.place}")
        left, right = formula.members[:2]
        return scalar(left, stage), scalar(right, stage)

    def homogeneous(self, stage: Stage) -> Element | None:
        """The function made homogeneous; ``None`` if that is impossible."""
        function = self.function(stage)
        level, value = self.surface(stage)
        weights = self.weights
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

    def found_weights(self, stage: Stage) -> Weights:
        """The weights of the variables; this searches, with FLINT."""
        from kowalevski_cas.search.weights import weights

        elements = [*self.goals(stage), self.surface(stage)[0]]
        return weights([element.terms().get(0, {}) for element in elements])

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

    def system(self, stage: Stage) -> System:
        """The critical equations and consequences of them, the set, and what is granted."""
        function = self.homogeneous(stage)
        assert function is not None
        critical = self.derivatives(stage, function)
        targets = [*critical, *(_dot(field, critical) for field in self.fields(stage))]
        if self.zero_level:
            targets.append(function)
        granted = [scalar(locus, stage) for locus in self.loci(stage)]
        return System(stage.ring, targets, self.goals(stage), [*granted, self.surface(stage)[0]])

    def fields(self, stage: Stage) -> list[list[Element]]:
        """Gradients of the equations, and their cross products, in the variables that are free."""
        names = stage.scene.variables
        slopes = zip(names, gradient(self.surface(stage)[0], names), strict=True)
        free = tuple(name for name, slope in slopes if slope.is_zero)
        fields = [gradient(goal, free) for goal in self.goals(stage)]
        if len(free) == 3:
            fields += [_cross(a, b) for a, b in combinations(fields, 2)]
        return fields

    @staticmethod
    def loci(stage: Stage) -> list[Formula]:
        """What is assumed not to vanish; where it does, the statement is tried once more."""
        return list(stage.landmarks())


def _difference(sides: tuple[Element, Element]) -> Element:
    return sides[0] - sides[1]


def _weight(exponents: Sequence[int], weights: Sequence[int]) -> int:
    return sum(e * w for e, w in zip(exponents, weights, strict=True))


def _dot(field: Sequence[Element], rates: Sequence[Element]) -> Element:
    """A combination of the first of the rates."""
    total = rates[0].ring.zero
    for component, rate in zip(field, rates[: len(field)], strict=True):
        total = total + component * rate
    return total


def _cross(a: Sequence[Element], b: Sequence[Element]) -> list[Element]:
    return [a[i] * b[j] - a[j] * b[i] for i, j in ((1, 2), (2, 0), (0, 1))]
