"""Constant roots: a root of an equation that is a combination of constants of the motion."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from itertools import islice, product

from kowalevski_cas.arithmetic.derivation import along
from kowalevski_cas.arithmetic.numbers import rational, square_root
from kowalevski_cas.arithmetic.points import ExactPoint, Question
from kowalevski_cas.arithmetic.present import fraction_formula
from kowalevski_cas.arithmetic.tower import Element
from kowalevski_cas.claims.bench import Bench
from kowalevski_cas.claims.claim import Claim, Finding, ask, green, refuted
from kowalevski_cas.claims.conditions import conditions_of
from kowalevski_cas.claims.formulas import equal, equation, scaled, total
from kowalevski_cas.claims.points import AtPoint
from kowalevski_cas.proof.outcome import Counterexample, Step, Verdict
from kowalevski_cas.stage import Stage, StageError, scalar
from kowalevski_cas.stage.change import solve

Guess = list[Fraction]
Sample = tuple[ExactPoint, list[Fraction], list[Fraction]]
"""A point, the two roots there, and the values of the basis."""

SPARE = 3
"""At how many further points a combination has to fit before it is tried as an identity."""


@dataclass(frozen=True, eq=False)
class ConstantRoot(Claim):
    """The printed quadratic equation for ``unknown`` has a root that is constant on the scene.

    The root is sought as a combination with rational coefficients of ``basis``,
    expressions that are constants of the motion: from its two values at exact
    points. That it is a root is then checked as an identity.
    """

    unknown: str
    basis: tuple[str, ...]

    def decide(self, bench: Bench) -> Finding:
        """Find the combination at exact points, and prove that it is a root."""
        stage = bench.stage(self.scene)
        guess = bench.found(("constant", self.id), self._search)
        if guess is None:
            found = self._inconsistent(bench)
            return refuted(found) if found else Finding(Verdict.UNDECIDED)
        value = self._value(guess, stage)
        if not value.is_zero:
            return Finding(Verdict.UNDECIDED, message="the combination fits points only")
        terms = [
            scaled(fraction_formula(c), stage.formula(tex))
            for c, tex in zip(guess, self.basis, strict=True)
            if c
        ]
        root = equal(stage.formula(self.unknown), total(terms))
        steps = [Step("The constant root that the program found:", (root,))]
        return green(conditions_of([value], stage), steps if bench.explain else ())

    def _value(self, guess: Guess, stage: Stage) -> Element:
        """The value of the equation at a combination."""
        root = stage.ring.zero
        for coefficient, tex in zip(guess, self.basis, strict=True):
            term = scalar(stage.formula(tex), stage)
            root = root + stage.ring.number(coefficient) * term
        constant, linear, quadratic = self._coefficients(stage)
        return constant + linear * root + quadratic * root * root

    def questions(self, bench: Bench) -> Iterator[Question]:
        """Whether the combination that exact points give is a root."""
        guess = bench.found(("constant", self.id), self._search)
        if guess is not None:
            stage = bench.stage(self.scene)
            yield ask(stage, [self._value(guess, stage)])

    def expressions(self) -> Iterator[str]:
        yield from self.basis

    def _coefficients(self, stage: Stage) -> tuple[Element, Element, Element]:
        """The coefficients of the equation as a polynomial in the unknown."""
        assert self.printed is not None
        full = equation(self.printed, stage)
        one, half = stage.ring.one, stage.half
        first = along(full, {self.unknown: one})
        quadratic = along(first, {self.unknown: one}) * half
        unknown = scalar(stage.formula(self.unknown), stage)
        linear = first - quadratic * unknown - quadratic * unknown
        return full - linear * unknown - quadratic * unknown * unknown, linear, quadratic

    def _samples(self, stage: Stage) -> Iterator[Sample]:
        """Points where both roots are rational, the two roots, and the values of the basis."""
        from kowalevski_cas.search.real import real_points

        coefficients = self._coefficients(stage)
        basis = [scalar(stage.formula(tex), stage) for tex in self.basis]
        for point in real_points(stage):
            at = AtPoint(stage, point)
            try:
                values = [rational(at(e)) for e in (*coefficients, *basis)]
            except ZeroDivisionError:
                continue
            if any(value is None for value in values):
                continue
            c, b, a, *known = [value for value in values if value is not None]
            root = square_root(b * b - 4 * a * c) if a else None
            if root is not None:
                yield point, [(-b - root) / (2 * a), (-b + root) / (2 * a)], known

    def _search(self, finder: Bench) -> Guess | None:
        """A combination that fits more points than are needed to determine it."""
        stage = finder.stage(self.scene)
        samples = list(islice(self._samples(stage), len(self.basis) + SPARE))
        guesses = self._guesses(stage, samples)
        return next((guess for guess, misfit in guesses if misfit is None), None)

    def _guesses(
        self, stage: Stage, samples: list[Sample]
    ) -> Iterator[tuple[Guess, Sample | None]]:
        """The combinations through roots at the first points, each with a point that it misses."""
        size, ring = len(self.basis), stage.ring
        if len(samples) < size + SPARE:
            return
        for roots in product(*(roots for _, roots, _ in samples[:size])):
            rows = [[ring.number(v) for v in known] for _, _, known in samples[:size]]
            try:
                solution = solve(rows, [ring.number(root) for root in roots])
            except StageError:
                return
            guess = [rational(value) or Fraction(0) for value in solution]
            missed = (s for s in samples[size:] if _value(guess, s[2]) not in s[1])
            yield guess, next(missed, None)

    def _inconsistent(self, bench: Bench) -> Counterexample | None:
        """A point where a combination is no root, if each combination misses some point.

        At the first points one of the two roots has to be the combination; so
        all choices are tried, and every one has to fail.
        """
        stage = bench.finder.stage(self.scene)
        samples = list(islice(self._samples(stage), len(self.basis) + SPARE))
        guesses = list(self._guesses(stage, samples))
        if not bench.refute or not guesses or any(missed is None for _, missed in guesses):
            return None
        guess, missed = guesses[0]
        assert missed is not None
        point, roots, known = missed
        words = (
            "a combination that is a root at other points, and a root here; "
            f"none of the {len(guesses)} possible ones fits all points"
        )
        left, right = fraction_formula(_value(guess, known)), fraction_formula(roots[0])
        shown = AtPoint(bench.stage(self.scene), point).shown()
        return Counterexample(shown, left, right, words)


def _value(guess: Guess, known: list[Fraction]) -> Fraction:
    return sum((g * v for g, v in zip(guess, known, strict=True)), Fraction(0))
