r"""Equilibria: how many states of rest there are for given values of the integrals."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction

from kowalevski_cas.arithmetic.numbers import number_ring
from kowalevski_cas.arithmetic.polynomials import Terms
from kowalevski_cas.arithmetic.present import formula_of
from kowalevski_cas.arithmetic.tower import Element, Ring
from kowalevski_cas.claims.bench import Bench
from kowalevski_cas.claims.claim import Claim, Finding, Neighbour, refuted, show_number
from kowalevski_cas.claims.real_roots import System, degree, form_of
from kowalevski_cas.claims.rest import Rest
from kowalevski_cas.notation import Formula, Vocabulary, to_latex
from kowalevski_cas.proof.outcome import Condition, Counterexample, Point, Step, Verdict
from kowalevski_cas.proof.roots import Roots, Sign
from kowalevski_cas.stage import Stage, scalar
from kowalevski_cas.texts import Printed, Texts

Values = tuple[Fraction, ...]


@dataclass(frozen=True, eq=False)
class Equilibria(Claim):
    r"""For given values of the ``levels`` there are exactly ``count`` states of rest.

    ``fixed`` are the variables that vanish at rest; ``levels`` are printed
    integrals with their values, which are the parameters. What the scene declares
    non-zero is granted. The equations of rest that are linear are solved; the rest
    of the system is solved by the roots of one equation, whose number of real
    roots is that of Hermite. Factors that vanish only where something granted does
    need no condition; all others become conditions, and on their locus more than
    ``count`` exact states of rest are looked for.

    Outside the computation: Hermite's theorem, and that a sum of squares is not
    negative.
    """

    fixed: tuple[str, ...]
    levels: tuple[Printed, ...]
    count: int

    def decide(self, bench: Bench) -> Finding:
        """Solve the system by one root, and show that all roots are real and distinct."""
        stage = bench.stage(self.scene)
        rest = Rest(stage, self.fixed)
        system = self._system(rest)
        if system is None:
            return Finding(Verdict.UNDECIDED, message="the parameters are not independent")
        found = bench.found(("roots", self.id), self._roots)
        if found is None:
            return Finding(Verdict.UNDECIDED, message="no separating form was found")
        roots = Roots.read(found)
        if not system.holds(roots):
            return Finding(Verdict.UNDECIDED, message="the roots are not all real, or not shown to be")
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

    # -- the system ------------------------------------------------------------

    def _sides(self, stage: Stage, side: int) -> list[Formula]:
        return [stage.relation(printed).members[side] for printed in self.levels]

    def _system(self, rest: Rest) -> System | None:
        """The system for the states of rest; ``None`` if there is a parameter on its left side."""
        stage, ring = rest.stage, rest.stage.ring
        everywhere = [scalar(formula, stage) for formula in self._sides(stage, 0)]
        constants = [ring.polynomials.generators.index(c) for c in stage.scene.constants]
        for element in (*everywhere, *stage.field.values()):
            if element.denominator or element.parts.keys() - {0}:
                return None
            if any(exponents[k] for exponents in element.terms().get(0, {}) for k in constants):
                return None
        own = {name: ring.generator(name) for name in rest.free}
        at_rest = rest.at(ring, own)
        return System([at_rest(level) for level in everywhere], list(own.values()), everywhere)

    def _roots(self, finder: Bench) -> Roots | None:
        from kowalevski_cas.search.real_roots import real_roots

        system = self._system(Rest(finder.stage(self.scene), self.fixed))
        return None if system is None else real_roots(system)

    def _constants(self, stage: Stage) -> Stage:
        """The scene in a ring of its constants and the form s."""
        ring = Ring(stage.arithmetic(("s", *stage.scene.constants)))
        image = {name: ring.generator(name) for name in stage.scene.constants}
        return Stage(stage.scene, stage.arithmetic, stage.texts, ring, image)

    def _shown(self, stage: Stage, system: System, terms: Terms) -> Element:
        """A polynomial in the form and the parameters, with the printed values of the levels."""
        inner = self._constants(stage)
        values = [scalar(formula, inner) for formula in self._sides(stage, 1)]
        return system.into(values, inner.ring.generator("s"))(system.element(terms))

    # -- conditions --------------------------------------------------------------

    def _granted(self, stage: Stage, system: System, roots: Roots) -> set[int]:
        """The factors that vanish only where something granted does.

        These are what the scene grants, and sums of squares of variables with
        which it would vanish.
        """
        inner = self._constants(stage)
        granted = [scalar(formula, inner) for formula in inner.granted()]
        found = {
            k
            for k, sign in enumerate(roots.signs)
            if any(_proportional(self._shown(stage, system, sign.factor), g) for g in granted)
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
        shown = self._shown(stage, system, sign.factor)
        inner = self._constants(stage)
        locus = next(
            (one for one, formula in zip(stage.scene.loci, stage.landmarks(), strict=True)
             if _proportional(shown, scalar(formula, inner))),
            None,
        )  # fmt: skip
        if locus is None:
            tex = _latex(shown)
            return Condition(tex, f"${tex}\\ne 0$: otherwise roots coincide or are lost")
        tex = to_latex(stage.formula(locus.condition))
        others = [roots.signs[k].factor for k in self._granted(stage, system, roots)]

        def search(finder: Bench) -> list[Values] | None:
            from kowalevski_cas.search.exact_solutions import many, value

            levels = _in_unknowns(system)
            return many(
                levels, len(rest.free), self.count + 1,
                lambda at: value(sign.factor, (0, *at)) == 0
                and all(value(other, (0, *at)) != 0 for other in others),
            )  # fmt: skip

        points = bench.found(("equilibria", self.id, locus.words), search)
        words = f"the number of states of rest that are listed, and the one claimed; {locus.words}"
        found = None
        if points and bench.refute:
            found = self._exhibit(rest, system, points, words, [sign.factor], others)
        return Condition(tex, f"it fails for {locus.words}", found)

    # -- exact states of rest ----------------------------------------------------

    def _all(self, bench: Bench, rest: Rest, system: System, roots: Roots) -> Counterexample | None:
        """All states of rest for values of the integrals for which they are rational."""
        needed = [sign.factor for sign in roots.signs]

        def search(finder: Bench) -> list[Values] | None:
            from kowalevski_cas.search.exact_solutions import all_solutions, value

            return all_solutions(
                roots.eliminant, _in_unknowns(system),
                lambda at: all(value(terms, (0, *at)) != 0 for terms in needed),
            )  # fmt: skip

        if not bench.refute:
            return None
        points = bench.found(("equilibria", self.id, "all"), search)
        words = "the number of states of rest, all of which are listed, and the one claimed"
        if not points or len(points) != degree(roots.eliminant):
            return None
        return self._exhibit(rest, system, points, words, [], needed)

    def _exhibit(
        self,
        rest: Rest,
        system: System,
        points: Sequence[Values],
        words: str,
        zero: Sequence[Terms],
        nonzero: Sequence[Terms],
    ) -> Counterexample | None:
        """Distinct states of rest with the same values of the levels, if that is what they are."""
        stage = rest.stage
        numbers = number_ring(stage.arithmetic)
        shown: dict[str, str] = {}
        if len(set(points)) != len(points):
            return None
        first: list[Element] = []
        for k, point in enumerate(points, 1):
            values = {n: numbers.number(x) for n, x in zip(rest.free, point, strict=True)}
            at = rest.at(numbers, values)
            levels = [at(level) for level in system.everywhere]
            first = first or levels
            if any(not at(rate).is_zero for rate in stage.field.values()):
                return None
            if any(not (a - b).is_zero for a, b in zip(first, levels, strict=True)):
                return None
            for name, components in stage.scene.vectors.items():
                if set(components) - set(self.fixed):
                    row = ",".join(show_number(at(stage.ring.generator(c))) for c in components)
                    shown[f"{name}^{{({k})}}"] = f"({row})"
        into = system.into(first)
        if any(not into(system.element(terms)).is_zero for terms in zero):
            return None
        if any(into(system.element(terms)).is_zero for terms in nonzero):
            return None
        names = (to_latex(formula) for formula in self._sides(stage, 1))
        heads = {n: show_number(value) for n, value in zip(names, first, strict=True)}
        return Counterexample(Point(heads | shown), str(len(points)), str(self.count), words)

    # -- the report ----------------------------------------------------------------

    def _steps(self, roots: Roots, stage: Stage, rest: Rest, system: System) -> list[Step]:
        found = roots.eliminant
        form = to_latex(formula_of(form_of(found, system.unknowns), stage.texts.vocabulary))
        equation = _latex(self._shown(stage, system, found.equation))
        steps = [Step(f"The states of rest are given by the roots of an equation for $s={form}$:",
                      f"{equation}=0")]  # fmt: skip
        for name, below, above in zip(rest.free, found.denominators, found.numerators, strict=True):
            left, right = (_latex(self._shown(stage, system, t)) for t in (below, above))
            steps.append(Step(f"${name}$ through $s$:", rf"\left({left}\right){name}={right}"))
        shown = [_latex(self._shown(stage, system, sign.factor)) for sign in roots.signs]
        minors = []
        for number, powers in roots.products[: degree(found)]:
            factors = [rf"\left({f}\right)^{{{p}}}" for f, p in zip(shown, powers, strict=True) if p]
            minors.append(rf"{number}\,{''.join(factors)}")
        steps.append(Step("The minors of Hermite, products of sums of squares:", r",\ ".join(minors)))
        return steps

    def neighbours(self, texts: Texts) -> Iterator[Neighbour]:
        for count in dict.fromkeys((self.count + 1, self.count - 1, 2 * self.count, self.count // 2)):
            yield Neighbour(f"{count} instead of {self.count}", replace(self, count=count), texts)

    def places(self) -> Iterator[Printed]:
        yield from super().places()
        yield from self.levels


def _in_unknowns(system: System) -> list[Terms]:
    """The levels as polynomials in the unknowns only."""
    places = [next(iter(u.terms()[0])).index(1) for u in system.unknowns]
    return [
        {tuple(exponents[k] for k in places): value for exponents, value in level.terms()[0].items()}
        for level in system.levels
    ]


def _proportional(first: Element, second: Element) -> bool:
    """Whether two polynomials differ by a number."""
    a, b = first.terms().get(0, {}), second.terms().get(0, {})
    if not a or not b or max(a) != max(b):
        return False
    ratio = first.ring.number(a[max(a)] / b[max(b)])
    return (first - ratio * second).is_zero


def _vanishes(element: Element, gone: set[int]) -> bool:
    """Whether an element vanishes when these generators do."""
    return all(any(exponents[k] for k in gone) for exponents in element.terms().get(0, {}))


def _latex(element: Element) -> str:
    names = frozenset(element.ring.polynomials.generators)
    return to_latex(formula_of(element, Vocabulary(scalars=names)))
