r"""Critical sets: where all derivatives of a function along a level surface vanish."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import partial
from itertools import combinations_with_replacement

from kowalevski_cas.arithmetic.points import Question
from kowalevski_cas.arithmetic.polynomials import Terms
from kowalevski_cas.arithmetic.tower import Element
from kowalevski_cas.claims.bench import Bench
from kowalevski_cas.claims.claim import Claim, Finding, Neighbour, ask, green, refuted
from kowalevski_cas.claims.conditions import conditions_of, locus_of
from kowalevski_cas.claims.critical_equations import CriticalEquations, Weights
from kowalevski_cas.claims.formulas import equal, scaled, show
from kowalevski_cas.claims.membership import combination, combination_steps, label
from kowalevski_cas.claims.witness import witness
from kowalevski_cas.notation import Formula, Number, edits, to_latex
from kowalevski_cas.proof.cases import Case
from kowalevski_cas.proof.outcome import Condition, Correction, Counterexample, Step, Verdict
from kowalevski_cas.stage import Stage, scalar
from kowalevski_cas.paper.texts import Printed, Texts

MOVING = "a derivative of the function along the surface at this point of the set, and zero"
CRITICAL = (
    "all derivatives of the function along the surface vanish at this point; "
    "left minus right side of {} there, and zero"
)


@dataclass(frozen=True, eq=False)
class CriticalSet(Claim):
    r"""``equations`` define exactly the critical points of the printed function on a surface.

    ``level`` is the printed equation of the surface; with ``zero_level`` only the
    critical points at which the function vanishes are meant. ``main`` are sets of
    variables in which the division is tried.

    *Forward*: the function, made homogeneous, is a combination of products of two
    of the equations, so that its differential vanishes with them.

    *Converse*: a tree of cases. Its targets are the derivatives along the surface
    and the combinations of them along the gradients, and the cross product of the
    gradients, of the equations in the variables of which the surface is free.
    Every split is an identity that is checked. An open leaf is a set of critical
    points on which the equations do not hold; an exact point of it refutes.

    The loci of the scene are assumed away, and tried once more. Two things rest on
    words: a real product vanishes only with a factor, a sum of squares only with
    each square.
    """

    equations: tuple[Printed, ...]
    level: Printed
    main: tuple[tuple[str, ...], ...] = ()
    zero_level: bool = False

    def decide(self, bench: Bench) -> Finding:
        """Divide the function by products of the equations, then split into cases."""
        stage = bench.stage(self.scene)
        problem = self.problem(bench)
        row = self.forward(bench, problem)
        if row is None:
            moving = self._moving_point(bench, problem)
            return refuted(moving) if moving else Finding(Verdict.UNDECIDED)
        case = self.cases(bench, problem)
        if not problem.system(stage).holds(case):
            return Finding(Verdict.UNDECIDED, message="a split into cases does not hold")
        steps = self._steps(row, case, stage) if bench.explain else []
        if any(one.kind == "open" for one in case.nodes()):
            off = self._point_off_the_set(bench, problem, case)
            if off is None:
                return Finding(Verdict.UNDECIDED, message="a case is left open")
            return replace(refuted(off, steps), correction=self._on_zero_level(bench))
        conditions = dict.fromkeys(c.expression for c in conditions_of(row, stage))
        needed = set(case.granted())
        conditions |= {locus: None for k, locus in enumerate(problem.loci(stage)) if k in needed}
        shown = tuple(self._where_it_fails(bench, problem, one) for one in conditions)
        return green(shown, steps)

    beyond_points = "whether other points are critical cannot be seen at points of the set"

    def questions(self, bench: Bench) -> Iterator[Question]:
        stage, problem = bench.stage(self.scene), self.problem(bench)

        def given(stage: Stage) -> list[Element]:
            return [*problem.goals(stage), problem.beside(stage)]

        yield ask(stage, problem.rates(stage), given)

    def problem(self, bench: Bench) -> CriticalEquations:
        """The equations as the texts of the bench print them, with weights that were found."""
        assert self.printed is not None
        problem = CriticalEquations(
            bench.texts, self.printed, self.equations, self.level, self.zero_level
        )

        def search(finder: Bench) -> Weights:
            return problem.found_weights(finder.stage(self.scene))

        return replace(problem, weights=bench.found(("weights", self.id), search))

    # -- both directions -------------------------------------------------------

    def forward(self, bench: Bench, problem: CriticalEquations) -> list[Element] | None:
        """The function, made homogeneous, as a combination of products of the equations."""
        if problem.homogeneous(bench.stage(self.scene)) is None:
            return None

        def target(stage: Stage) -> Element:
            return problem.homogeneous(stage) or stage.ring.zero

        def products(stage: Stage) -> list[Element]:
            return [a * b for a, b in combinations_with_replacement(problem.goals(stage), 2)]

        return combination(
            bench,
            self.scene,
            (self.id, "forward"),
            target,
            products,
            self.main,
            problem.goals,
        )

    def cases(self, bench: Bench, problem: CriticalEquations) -> Case:
        """The tree of cases that leads from the critical equations to the set."""

        def search(finder: Bench) -> Case:
            from kowalevski_cas.search.cases import Splitter

            stage = finder.stage(self.scene)
            system = problem.system(stage)
            polynomials = stage.ring.polynomials
            targets, goals, granted = (
                [element.parts.get(0, polynomials.zero) for element in elements]
                for elements in (system.targets, system.goals, system.granted)
            )
            return Splitter(polynomials, targets, goals, granted).case()

        level = "zero level" if self.zero_level else "any level"
        return Case.read(bench.found(("cases", self.id, level), search))

    # -- points where it fails -------------------------------------------------

    def _moving_point(self, bench: Bench, problem: CriticalEquations) -> Counterexample | None:
        """A point of the set, off the loci, that is not critical."""

        def off(stage: Stage) -> list[Element]:
            return [scalar(locus, stage) for locus in problem.loci(stage)]

        def on(stage: Stage) -> list[Element]:
            return [*problem.goals(stage), problem.beside(stage)]

        return witness(
            bench, self.scene, (self.id, "moving"), on, problem.rates, lambda index: MOVING, off,
            sections=problem.sections,
        )  # fmt: skip

    def _where_it_fails(
        self, bench: Bench, problem: CriticalEquations, expression: Formula
    ) -> Condition:
        """A condition with a point of its locus that lies on the set and is not critical."""
        condition = Condition(expression, "the formulas divide by it")
        locus = locus_of(condition, bench.stage(self.scene))
        if locus is None:
            return condition

        def goal(stage: Stage, k: int) -> Element:
            return problem.goals(stage)[k]

        def there(stage: Stage) -> list[Element]:
            return stage.equations(locus.equations)

        def on(stage: Stage) -> list[Element]:
            left = (g for k, g in enumerate(problem.goals(stage)) if k not in implied)
            return [*there(stage), problem.beside(stage), *left]

        implied = {
            k
            for k in range(len(self.equations))
            if combination(
                bench, self.scene, (self.id, locus.words, k),
                partial(goal, k=k), there,
            )
        }  # fmt: skip
        key = (self.id, locus.words)
        found = witness(bench, self.scene, key, on, problem.rates, lambda index: MOVING)
        return (
            replace(condition, words=f"it fails for {locus.words}", witness=found)
            if found
            else condition
        )

    def _point_off_the_set(
        self, bench: Bench, problem: CriticalEquations, case: Case
    ) -> Counterexample | None:
        """A critical point where an equation of the set fails, in one of the open cases."""
        cases = [one for one in case.nodes() if one.kind == "open"]
        for k, one in enumerate(sorted(cases, key=lambda one: sum(map(len, one.known)))):

            def known(stage: Stage, one: Case = one) -> list[Element]:
                given = [stage.ring.from_terms({0: terms}) for terms in one.known]
                return [*given, problem.beside(stage)]

            found = witness(
                bench, self.scene, (self.id, "critical", k), known, problem.goals,
                lambda index: CRITICAL.format(self.equations[index].place),
                lambda stage: problem.system(stage).granted,
                lambda stage: problem.system(stage).targets,
            )  # fmt: skip
            if found is not None:
                return found
        return None

    def _on_zero_level(self, bench: Bench) -> Correction | None:
        """The nearest true statement, if it is the one on the zero level."""
        if self.zero_level:
            return None
        finding = replace(self, zero_level=True).decide(bench)
        if not finding.verdict.green:
            return None
        assert self.printed is not None
        return Correction(
            formulas=(equal(bench.texts.formula(self.printed), Number(0)),),
            words="it holds among the critical points at which the function vanishes",
            verdict=finding.verdict,
            conditions=finding.conditions,
        )

    # -- the report --------------------------------------------------------------

    def _steps(self, row: Sequence[Element], case: Case, stage: Stage) -> list[Step]:
        products = combinations_with_replacement(map(label, self.equations), 2)
        steps = combination_steps("the function made homogeneous", row, stage, products)
        for one in case.nodes():
            known = (to_latex(equal(_shown(terms, stage), Number(0))) for terms in one.known)
            where = f"For ${'$, $'.join(known)}$" if one.known else "Everywhere"
            if one.kind == "split":
                factors = one.reductions[0].factors
                shown = scaled(Number(1), *(_shown(factor, stage) for factor, _ in factors))
                steps.append(Step(f"{where} it follows that", (equal(shown, Number(0)),)))
            elif one.kind == "open":
                steps.append(Step(f"{where} no more follows: these points are critical."))
        return steps

    def neighbours(self, texts: Texts) -> Iterator[Neighbour]:
        if not self.zero_level:
            words = "only the critical points where the function vanishes"
            yield Neighbour(words, replace(self, zero_level=True), texts)
        assert self.printed is not None
        for edit in edits(texts.statement(self.printed), texts.vocabulary):
            edited = texts.edited(self.printed, edit)
            yield Neighbour(edit.words, self, edited, self.printed, edit)

    def places(self) -> Iterator[Printed]:
        yield from super().places()
        yield from (*self.equations, self.level)

    def establishes(self) -> Iterator[Printed]:
        """Nothing: the function is what it is, whatever its critical points are."""
        yield from ()


def _shown(terms: Terms, stage: Stage) -> Formula:
    return show(stage.ring.from_terms({0: terms}), stage)
