r"""Equilibria: how many states of rest there are for given values of the integrals."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from fractions import Fraction

from kowalevski_cas.arithmetic.present import fraction_formula
from kowalevski_cas.arithmetic.tower import Element
from kowalevski_cas.claims.bench import Bench
from kowalevski_cas.claims.claim import Finding, Neighbour, refuted
from kowalevski_cas.claims.formulas import equal, scaled, show
from kowalevski_cas.claims.real_roots import System, degree, form_of
from kowalevski_cas.claims.rest import Rest
from kowalevski_cas.claims.states_of_rest import (
    StatesOfRest,
    Values,
    in_own_names,
    in_unknowns,
    proportional,
)
from kowalevski_cas.notation import Name, Number, Power, to_latex
from kowalevski_cas.proof.outcome import Condition, Counterexample, Step, Verdict
from kowalevski_cas.proof.roots import Roots, Sign
from kowalevski_cas.stage import Stage, scalar
from kowalevski_cas.paper.texts import Texts


@dataclass(frozen=True, eq=False)
class Equilibria(StatesOfRest):
    r"""For given values of the ``levels`` there are exactly ``count`` states of rest.

    What the scene declares non-zero is granted. The equations of rest are linear
    and are solved; what remains is solved by the roots of one equation, all of
    which are real and distinct by the minors of Hermite. Factors that vanish only
    where something granted does
    need no condition; all others become conditions, and on their locus more than
    ``count`` exact states of rest are looked for.

    Outside the computation: Hermite's theorem, and that a sum of squares is not
    negative.
    """

    beyond_points = "how many roots of an equation are real cannot be seen at points"

    def decide(self, bench: Bench) -> Finding:
        """Solve the system by one root, and show that all roots are real and distinct."""
        stage = bench.stage(self.scene)
        rest = Rest(stage, self.fixed)
        system = self.system(rest, bench.texts)
        if system is None:
            return Finding(Verdict.UNDECIDED, message="the parameters are not independent")
        found = bench.found(("roots", self.id), self._roots)
        if found is None:
            return Finding(Verdict.UNDECIDED, message="no separating form was found")
        roots = Roots.read(found)
        if not system.holds(roots):
            return Finding(Verdict.UNDECIDED, message="not all roots are shown to be real")
        steps = self._steps(roots, stage, rest, system) if bench.explain else []
        if degree(roots.eliminant) != self.count:
            all_of_them = self._all(bench, rest, system, roots)
            return refuted(all_of_them, steps) if all_of_them else Finding(Verdict.UNDECIDED)
        granted = self._granted(stage, system, roots)
        needed = [sign for k, sign in enumerate(roots.signs) if k not in granted]
        conditions = tuple(self._condition(bench, rest, system, roots, sign) for sign in needed)
        return Finding(
            Verdict.CONDITIONAL if conditions else Verdict.PROVED, conditions, tuple(steps)
        )

    def _roots(self, finder: Bench) -> Roots | None:
        from kowalevski_cas.search.real_roots import real_roots

        system = self.system(Rest(finder.stage(self.scene), self.fixed), finder.texts)
        return None if system is None else real_roots(system)

    # -- conditions --------------------------------------------------------------

    def _granted(self, stage: Stage, system: System, roots: Roots) -> set[int]:
        """The factors that vanish only where something granted does.

        These are what the scene grants, and sums of squares of variables with
        which it would vanish.
        """
        inner = self.on_constants(stage)
        granted = [scalar(formula, inner) for formula in inner.granted()]
        found = {
            k
            for k, sign in enumerate(roots.signs)
            if any(proportional(self.shown(stage, system, sign.factor), g) for g in granted)
        }
        everywhere = system.into(system.everywhere)
        values = [everywhere(system.element(roots.signs[k].factor)) for k in found]
        for k, sign in enumerate(roots.signs):
            squared = [e for _, base in sign.in_variables if len(base) == 1 for e in base]
            gone = {e.index(1) for e in squared if sum(e) == 1}
            if len(gone) == len(sign.in_variables) and any(_vanishes(v, gone) for v in values):
                found.add(k)
        return found

    def _condition(
        self, bench: Bench, rest: Rest, system: System, roots: Roots, sign: Sign
    ) -> Condition:
        """A factor that must not vanish, with more states of rest where it does."""
        stage = rest.stage
        shown = self.shown(stage, system, sign.factor)
        inner = self.on_constants(stage)
        locus = next(
            (one for one, formula in zip(stage.scene.loci, stage.landmarks(), strict=True)
             if proportional(shown, scalar(formula, inner))),
            None,
        )  # fmt: skip
        if locus is None:
            return Condition(in_own_names(shown), "otherwise roots coincide or are lost")
        others = [roots.signs[k].factor for k in self._granted(stage, system, roots)]

        def search(finder: Bench) -> list[Values] | None:
            from kowalevski_cas.search.exact_solutions import many, value

            levels = in_unknowns(system)
            return many(
                levels, len(rest.free), self.count + 1,
                lambda at: value(sign.factor, (0, *at)) == 0
                and all(value(other, (0, *at)) != 0 for other in others),
            )  # fmt: skip

        points = bench.found(("equilibria", self.id, locus.words), search)
        words = f"the number of states of rest that are listed, and the one claimed; {locus.words}"
        found = None
        if points and bench.refute:
            found = self.exhibit(rest, system, points, words, [sign.factor], others)
        condition = stage.formula(locus.condition)
        return Condition(condition, f"it fails for {locus.words}", found)

    # -- exact states of rest ----------------------------------------------------

    def _all(self, bench: Bench, rest: Rest, system: System, roots: Roots) -> Counterexample | None:
        """All states of rest for values of the integrals for which they are rational."""
        needed = [sign.factor for sign in roots.signs]

        def search(finder: Bench) -> list[Values] | None:
            from kowalevski_cas.search.exact_solutions import all_solutions, value

            return all_solutions(
                roots.eliminant, in_unknowns(system),
                lambda at: all(value(terms, (0, *at)) != 0 for terms in needed),
            )  # fmt: skip

        if not bench.refute:
            return None
        points = bench.found(("equilibria", self.id, "all"), search)
        words = "the number of states of rest, all of which are listed, and the one claimed"
        if not points or len(points) != degree(roots.eliminant):
            return None
        return self.exhibit(rest, system, points, words, [], needed)

    # -- the report ----------------------------------------------------------------

    def _steps(self, roots: Roots, stage: Stage, rest: Rest, system: System) -> list[Step]:
        found = roots.eliminant
        form = to_latex(show(form_of(found, system.unknowns), stage))
        equation = in_own_names(self.shown(stage, system, found.equation))
        steps = [Step(f"The states of rest are given by the roots of an equation for $s={form}$:",
                      (equal(equation, Number(0)),))]  # fmt: skip
        for name, below, above in zip(rest.free, found.denominators, found.numerators, strict=True):
            left, right = (in_own_names(self.shown(stage, system, t)) for t in (below, above))
            solved = equal(scaled(left, Name(name)), right)
            steps.append(Step(f"${name}$ through $s$:", (solved,)))
        shown = [in_own_names(self.shown(stage, system, sign.factor)) for sign in roots.signs]
        minors = []
        for content, powers in roots.products[: degree(found)]:
            factors = zip(shown, powers, strict=True)
            used = (f if p == 1 else Power(f, Number(p)) for f, p in factors if p)
            minors.append(scaled(fraction_formula(Fraction(content)), *used))
        text = "The minors of Hermite, with factors that are sums of squares:"
        steps.append(Step(text, tuple(minors)))
        for k in self._granted(stage, system, roots):
            with_it = [bool(powers[k]) for _, powers in roots.products[: degree(found)]]
            number = with_it.index(True) if True in with_it else 0
            if number and all(with_it[number:]):
                text = f"Granted not to vanish; where it does, only {number} roots are different:"
                steps.append(Step(text, (shown[k],)))
        return steps

    def neighbours(self, texts: Texts) -> Iterator[Neighbour]:
        own = self.count
        for count in dict.fromkeys((own + 1, own - 1, 2 * own, own // 2)):
            yield Neighbour(f"{count} instead of {self.count}", replace(self, count=count), texts)


def _vanishes(element: Element, gone: set[int]) -> bool:
    """Whether an element vanishes when these generators do."""
    return all(any(exponents[k] for k in gone) for exponents in element.terms().get(0, {}))
