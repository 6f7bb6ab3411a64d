"""Constant roots: a root of an equation that is a combination of constants of the motion."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from itertools import islice, product

from kowalevski_cas.arithmetic.derivation import along
from kowalevski_cas.arithmetic.numbers import rational, square_root
from kowalevski_cas.arithmetic.present import fraction_formula
from kowalevski_cas.arithmetic.tower import Element
from kowalevski_cas.claims.bench import Bench
from kowalevski_cas.claims.claim import (
    AtPoint,
    Claim,
    Finding,
    conditions_of,
    equation,
    green,
    refuted,
    show,
)
from kowalevski_cas.notation import to_latex
from kowalevski_cas.proof.outcome import Counterexample, Step, Verdict
from kowalevski_cas.stage import Stage, scalar
from kowalevski_cas.stage.change import solve

ExactPoint = dict[str, tuple[Fraction, Fraction]]
Guess = list[Fraction]

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
        root = stage.ring.zero
        for coefficient, tex in zip(guess, self.basis, strict=True):
            term = scalar(stage.formula(tex), stage)
            root = root + stage.ring.number(coefficient) * term
        constant, linear, quadratic = self._coefficients(stage)
        value = constant + linear * root + quadratic * root * root
        if not value.is_zero:
            return Finding(Verdict.UNDECIDED, message="the combination fits points only")
        terms = [
            rf"{show(stage.ring.number(c), stage)}\,{tex}"
            for c, tex in zip(guess, self.basis, strict=True)
            if c
        ]
        shown = " + ".join(terms).replace("+ -", "- ")
        steps = [Step("The constant root that the program found:", f"{self.unknown} = {shown}")]
        return green(conditions_of([value], stage), steps if bench.explain else ())

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

    def _samples(self, stage: Stage) -> Iterator[tuple[ExactPoint, list[Fraction], list[Fraction]]]:
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
        stage = finder.stage(self.scene)
        size = len(self.basis)
        samples = list(islice(self._samples(stage), size + SPARE))
        if len(samples) < size + SPARE:
            return None
        ring = stage.ring
        for roots in product(*(roots for _, roots, _ in samples[:size])):
            rows = [[ring.number(v) for v in known] for _, _, known in samples[:size]]
            try:
                solution = solve(rows, [ring.number(root) for root in roots])
            except ValueError:
                return None
            guess = [rational(value) or Fraction(0) for value in solution]
            if all(_fits(guess, roots, known) for _, roots, known in samples[size:]):
                return guess
        return None

    def _inconsistent(self, bench: Bench) -> Counterexample | None:
        """A point with two roots through which no combination passes that fits the others."""
        stage = bench.stage(self.scene)
        sample = next(self._samples(bench.finder.stage(self.scene)), None)
        if sample is None or not bench.refute:
            return None
        point, roots, _ = sample
        numbers = [to_latex(fraction_formula(root)) for root in roots]
        words = (
            "the two roots at this point; no combination of the constants is one of them throughout"
        )
        return Counterexample(AtPoint(stage, point).shown(), numbers[0], numbers[1], words)


def _fits(guess: Guess, roots: list[Fraction], known: list[Fraction]) -> bool:
    return sum((g * v for g, v in zip(guess, known, strict=True)), Fraction(0)) in roots
