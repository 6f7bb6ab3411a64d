"""Critical sets in a certificate: both directions, and a critical point off the set."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import combinations, combinations_with_replacement, islice

from kowalevski_cas.arithmetic.derivation import gradient
from kowalevski_cas.arithmetic.tower import Element
from kowalevski_cas.claims import CriticalSet
from kowalevski_cas.claims.critical_equations import CriticalEquations
from kowalevski_cas.claims.points import AtPoint
from kowalevski_cas.proof.parts import TRIES, Equation, Parts
from kowalevski_cas.proof.spaces import SpaceWriter
from kowalevski_cas.proof.splits import Prover, Row
from kowalevski_cas.proof.statements.kinds import deny, state
from kowalevski_cas.proof.trees import CertificateError, Tree
from kowalevski_cas.stage import Stage


@state.register
def state_critical_set(claim: CriticalSet, parts: Parts) -> None:
    """The derivatives along the surface vanish on the set, and only there.

    For a claim that a point refutes this is stated where the function vanishes.
    """
    bench = parts.bench.finder
    problem = claim.problem(bench)
    case = claim.cases(bench, problem)
    if any(one.kind == "open" for one in case.nodes()) and not claim.zero_level:
        state_critical_set(replace(claim, zero_level=True), parts)
        return
    products = claim.forward(bench, problem)
    if products is None:
        raise CertificateError("the function is no combination of products of the equations")
    space = parts.space(claim.scene)
    stage = space.stage
    level, goals = space.sides(claim.level), [space.sides(p) for p in claim.equations]
    critical = _critical(claim, space)
    along = _Surface(problem, stage)
    forward = along.forward(products)
    at = _point_of_the_set(problem, stage)
    parts.follows(space, critical, [*goals, level], forward, at=at)
    system = problem.system(stage)
    place = len(critical)
    prover = Prover(system, along.targets(), place, problem.surface(stage)[1], space.element)
    proof = prover.proof(case, place + 1, [])
    parts.follows(space, goals, [*critical, level], proof=proof, at=at)
    parts.notes.append(
        "the derivatives are those along the surface, for the gradient of its left side, "
        "which by Euler's relation does not vanish there, gives the normal direction"
    )


@deny.register
def deny_critical_set(claim: CriticalSet, parts: Parts) -> None:
    """A critical point on the surface at which an equation of the set fails."""
    bench = parts.bench.finder
    space = parts.space(claim.scene)
    problem = claim.problem(bench)
    for k in range(len(list(claim.cases(bench, problem).nodes()))):
        point = bench.found(("witness", (claim.id, "critical", k)), lambda finder: None)
        if point is None:
            continue
        at = AtPoint(space.stage, point)
        failing = (
            p for p in claim.equations if not at(space.difference(space.sides(p))[0]).is_zero
        )
        if (printed := next(failing, None)) is not None:
            given = [*_critical(claim, space), space.sides(claim.level)]
            parts.differ(space, space.sides(printed), given, at)
            return
    raise CertificateError("no critical point off the set was found")


def _point_of_the_set(problem: CriticalEquations, stage: Stage) -> AtPoint:
    """A point of the set, on the surface, where what is granted does not vanish."""
    from kowalevski_cas.search.real import real_points

    system = problem.system(stage)
    for section in problem.sections(stage):
        zero = [*system.goals, problem.beside(stage)]
        for point in islice(real_points(stage, [*zero, *section], system.granted), TRIES):
            at = AtPoint(stage, point)
            on = all(at(element).is_zero for element in zero)
            if on and not any(at(element).is_zero for element in system.granted):
                return at
    raise CertificateError("no point of the set was found")


def _critical(claim: CriticalSet, space: SpaceWriter) -> list[Equation]:
    """The derivatives of the printed function along the surface are zero, perhaps it is, too."""
    assert claim.printed is not None
    names = claim.scene.variables
    function, surface = [n for n in "fgpquv" if n not in {*claim.scene.names()}][:2]
    trees = space.tree(space.stage.texts.formula(claim.printed)), space.sides(claim.level)[0]
    for name, tree in zip((function, surface), trees, strict=True):
        space.abbreviate(name, tree)
    for name in names:
        space.need(name)
    slopes = gradient(space.value(trees[1])[0], names)
    on = [name for name, slope in zip(names, slopes, strict=True) if not slope.is_zero]
    rates: list[Tree] = [["d", name, function] for name in names if name not in on]
    for first, second in combinations(on, 2):
        one = ["*", ["d", first, surface], ["d", second, function]]
        other = ["*", ["d", second, surface], ["d", first, function]]
        rates.append(["+", one, ["-", other]])
    return [[tree, 0] for tree in [*rates, *([function] if claim.zero_level else [])]]


class _Surface:
    """The printed function and its homogeneous form, which agree on the surface."""

    def __init__(self, problem: CriticalEquations, stage: Stage) -> None:
        self.problem, self.stage = problem, stage
        function = problem.function(stage)
        homogeneous = problem.homogeneous(stage)
        if homogeneous is None:
            raise CertificateError("the function cannot be made homogeneous")
        self.count = len(problem.derivatives(stage, function))
        self.excess = [
            self._over_the_level(b - a)
            for a, b in zip(self._rates(function), self._rates(homogeneous), strict=True)
        ]

    def _rates(self, element: Element) -> Row:
        """The derivatives along the surface; the element as well, if its zeros are meant."""
        rates = self.problem.derivatives(self.stage, element)
        return [*rates, element] if self.problem.zero_level else rates

    def _over_the_level(self, element: Element) -> Element:
        """The quotient by the difference of the sides of the surface."""
        ring, beside = self.stage.ring, self.problem.beside(self.stage)
        zero = ring.polynomials.zero
        quotient, rest = divmod(element.parts.get(0, zero), beside.parts[0])
        if not ring.polynomials.is_zero(rest) or element.denominator:
            raise CertificateError("the function differs from its homogeneous form on the surface")
        return ring.element({0: quotient}, {})

    def forward(self, products: Sequence[Element]) -> list[Row]:
        """The rates as combinations of the equations, and of the surface, last."""
        goals = self.problem.goals(self.stage)
        zero = self.stage.ring.zero
        rows = [[zero] * len(goals) for _ in self.excess]
        pairs = list(combinations_with_replacement(range(len(goals)), 2))
        slopes = [self.problem.derivatives(self.stage, goal) for goal in goals]
        for factor, (i, j) in zip(products, pairs, strict=True):
            for k, change in enumerate(self.problem.derivatives(self.stage, factor)):
                rows[k][j] = rows[k][j] + change * goals[i] + factor * slopes[i][k]
                rows[k][i] = rows[k][i] + factor * slopes[j][k]
            if self.problem.zero_level:
                rows[-1][j] = rows[-1][j] + factor * goals[i]
        return [[*row, -excess] for row, excess in zip(rows, self.excess, strict=True)]

    def targets(self) -> list[Row]:
        """The targets of the tree of cases, as combinations of the rates and the surface."""
        ring, size = self.stage.ring, len(self.excess)
        rates = [
            [*(ring.one if k == j else ring.zero for j in range(size)), excess]
            for k, excess in enumerate(self.excess)
        ]
        fields = []
        for field in self.problem.fields(self.stage):
            row = [ring.zero] * (size + 1)
            for component, rate in zip(field, rates[: len(field)], strict=True):
                row = [a + component * b for a, b in zip(row, rate, strict=True)]
            fields.append(row)
        return [*rates[: self.count], *fields, *rates[self.count :]]
