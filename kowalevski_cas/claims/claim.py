"""What every kind of claim has in common."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from functools import lru_cache

from kowalevski_cas.arithmetic.numbers import Substitution, gaussian, number_ring, show_number
from kowalevski_cas.arithmetic.points import Question
from kowalevski_cas.arithmetic.present import formula_of
from kowalevski_cas.arithmetic.tower import Element, Ring
from kowalevski_cas.claims.bench import Bench, Key
from kowalevski_cas.dataclass import dataclass
from kowalevski_cas.notation import Constant, Edit, Formula, Relation, edits, to_latex
from kowalevski_cas.proof.outcome import Condition, Correction, Counterexample, Point, Step, Verdict
from kowalevski_cas.scene import Locus, Scene
from kowalevski_cas.stage import Stage, StageError, scalar
from kowalevski_cas.stage.evaluate import Triple, Value
from kowalevski_cas.texts import Printed, Texts

Shape = frozenset[object]
"""A polynomial up to a constant factor, as a key."""


@dataclass(frozen=True)
class Finding:
    """The verdict on a claim in one arithmetic, with its evidence.

    ``correction`` is the nearest true statement where the claim itself proves
    one; a formula that is one edit away is searched for elsewhere. ``chance`` and
    ``radius`` are those of an outcome.
    """

    verdict: Verdict
    conditions: tuple[Condition, ...] = ()
    steps: tuple[Step, ...] = ()
    counterexample: Counterexample | None = None
    message: str = ""
    correction: Correction | None = None
    chance: float | None = None
    radius: float | None = None


@dataclass(frozen=True)
class Neighbour:
    """A statement that differs a little: a mutant, or a candidate for a correction."""

    words: str
    claim: Claim
    texts: Texts
    printed: Printed | None = None
    edit: Edit | None = None


@dataclass(frozen=True, eq=False)
class Claim(ABC):
    """One statement of the paper, on its scene.

    ``printed`` is the place of the formula, if the claim is one formula;
    ``words`` says what is claimed.
    """

    id: str
    scene: Scene
    printed: Printed | None
    words: str

    @abstractmethod
    def decide(self, bench: Bench) -> Finding:
        """Decide the claim in the arithmetic of the bench."""

    beyond_points = ""
    """What is claimed and cannot be seen at points, if there is something."""

    def residuals(self, formula: Formula, stage: Stage) -> list[Element] | None:
        """Elements that vanish if the formula is true in place of the printed one.

        ``None`` if the kind of claim has no such test, so that a neighbour has
        to be decided in full.
        """
        return None

    def questions(self, bench: Bench) -> Iterator[Question]:
        """What can be asked at points; the claim is false if one answer is no."""
        if self.printed is not None:
            stage = bench.stage(self.scene)
            residuals = self.residuals(bench.texts.formula(self.printed), stage)
            if residuals is not None:
                yield ask(stage, residuals)

    def places(self) -> Iterator[Printed]:
        """The places of the paper that the claim names, its own first; not those of its scene."""
        if self.printed is not None:
            yield self.printed

    def expressions(self) -> Iterator[str]:
        """The expressions, in LaTeX, that the claim names besides those at its places."""
        yield from ()

    def scenes(self) -> Iterator[Scene]:
        """The scenes that the claim needs."""
        yield self.scene

    def neighbours(self, texts: Texts) -> Iterator[Neighbour]:
        """Statements one edit away, the most plausible corrections first."""
        names = frozenset(self.scene.names()) - {*self.scene.undefined}
        for printed in self.establishes():
            for edit in edits(texts.statement(printed), texts.vocabulary, names):
                yield Neighbour(edit.words, self, texts.edited(printed, edit), printed, edit)

    def establishes(self) -> Iterator[Printed]:
        """The places that are right if the claim is."""
        if self.printed is not None:
            yield self.printed


def ask(
    stage: Stage,
    residuals: Sequence[Element] = (),
    given: Callable[[Stage], Sequence[Element]] = lambda stage: (),
    rows: Sequence[Sequence[Element]] = (),
    rank: int = 0,
    somewhere: Sequence[Element] = (),
) -> Question:
    """A question to points of a stage of programs; see :class:`Question`."""
    from kowalevski_cas.stage.programs import ProgramStage, programs

    assert isinstance(stage, ProgramStage)
    return Question(
        stage.programs,
        residuals=programs(residuals),
        given=programs(given(stage)),
        rows=[programs(row) for row in rows],
        rank=rank,
        somewhere=programs(somewhere),
    )


def members(relation: Relation) -> list[Formula]:
    """The members of a chain of equalities that are formulas, not the word ``const``."""
    return [member for member in relation.members if not isinstance(member, Constant)]


def components(value: Value) -> tuple[Element, ...]:
    """A scalar or a vector as a tuple of scalars."""
    return tuple(value) if isinstance(value, Triple) else (value,)


def differences(left: Value, right: Value) -> list[Element]:
    """The components of the difference of two scalars or of two vectors."""
    pairs = zip(components(left), components(right), strict=True)
    return [a - b for a, b in pairs]


def equation(printed: Printed, stage: Stage) -> Element:
    """The left side minus the right side of a printed equation, which has these two only."""
    relation = stage.relation(printed)
    if len(relation.members) != 2 or r"\ne" in relation.signs:
        raise StageError(f"an equation with two sides is expected at {printed.place}")
    left, right = relation.members
    return scalar(left, stage) - scalar(right, stage)


def equations(places: Sequence[Printed], stage: Stage) -> list[Element]:
    """The left sides minus the right sides of printed equations."""
    return [equation(printed, stage) for printed in places]


def show(element: Element, stage: Stage) -> str:
    """An element in the names of its stage, as LaTeX."""
    return to_latex(formula_of(element, stage.texts.vocabulary))


def conditions_of(elements: Sequence[Element], stage: Stage) -> tuple[Condition, ...]:
    """What the denominators of these elements assume to be non-zero, each factor once."""
    ring = stage.ring
    indices = sorted({index for element in elements for index in element.denominator})
    if not indices:
        return ()
    granted, names = _declared(stage)
    shown: dict[str, None] = {}
    divisors = [Element(ring, {0: ring.divisors[index]}, {}) for index in indices]
    known = {_shape(divisor) for divisor in divisors if len(divisor.terms()[0]) == 1}.union(granted)
    for divisor in divisors:
        shape = _shape(divisor)
        if shape in granted:
            continue
        if shape not in names and shape not in known:
            divisor = _without(divisor, known)
        if divisor is not ring.one:
            shown[to_latex(names[shape]) if shape in names else show(divisor, stage)] = None
    for first, second in stage.scene.conjugates:
        if first in shown and second in shown:
            del shown[second]
            shown = {(f"{first}{second}" if tex == first else tex): None for tex in shown}
    return tuple(Condition(tex, "the formulas divide by it") for tex in shown)


@lru_cache(maxsize=64)
def _declared(stage: Stage) -> tuple[frozenset[Shape], dict[Shape, Formula]]:
    """What a scene takes for granted not to vanish, and its names for conditions, by shapes."""
    granted = frozenset(_shape(scalar(formula, stage)) for formula in stage.granted())
    return granted, {_shape(scalar(formula, stage)): formula for formula in stage.landmarks()}


def _without(divisor: Element, known: set[Shape]) -> Element:
    """A polynomial without its factors that are known, which all are after that."""
    from kowalevski_cas.search.factors import irreducible_factors

    ring, result = divisor.ring, divisor.ring.one
    factors = irreducible_factors(divisor.terms()[0])
    new = [(f, e) for terms, e in factors if _shape(f := ring.from_terms({0: terms})) not in known]
    known.update(_shape(factor) for factor, _ in new)
    whole = all(value.denominator == 1 for value in divisor.terms()[0].values())
    if whole and len(new) == len(factors) and all(exponent == 1 for _, exponent in new):
        return divisor
    for factor, _ in new:
        result = result * factor
    return result


def locus_of(condition: Condition, stage: Stage) -> Locus | None:
    """The declared locus where a condition is violated, if there is one."""
    for locus in stage.scene.loci:
        if to_latex(stage.formula(locus.condition)) == condition.tex:
            return locus
    return None


def _shape(element: Element) -> Shape:
    """A polynomial up to a constant factor, as a key."""
    parts = element.terms()
    lead = next((parts[m][max(parts[m])] for m in sorted(parts)), Fraction(1))
    return frozenset(
        (mask, exponents, (scaled := value / lead).numerator, scaled.denominator)
        for mask, terms in parts.items()
        for exponents, value in terms.items()
    )


def green(conditions: tuple[Condition, ...], steps: Sequence[Step] = ()) -> Finding:
    """A finding for a statement that holds, perhaps under conditions."""
    verdict = Verdict.CONDITIONAL if conditions else Verdict.PROVED
    return Finding(verdict, conditions, tuple(steps))


def refuted(counterexample: Counterexample, steps: Sequence[Step] = ()) -> Finding:
    """A finding for a statement that an exact point refutes."""
    return Finding(Verdict.REFUTED, (), tuple(steps), counterexample)


class AtPoint:
    """The values of elements of a stage at an exact point, in the arithmetic of the stage."""

    def __init__(self, stage: Stage, point: dict[str, tuple[Fraction, Fraction]]) -> None:
        self.stage = stage
        self.numbers: Ring = number_ring(stage.arithmetic)
        self.values = {name: gaussian(self.numbers, *value) for name, value in point.items()}
        self.value = Substitution(stage.ring, self.values, self.numbers)

    def __call__(self, element: Element) -> Element:
        return self.value(element)

    def shown(self) -> Point:
        """The point, to be printed: the variables and constants, then the roots."""
        stage, scene = self.stage, self.stage.scene
        names = [*scene.variables, *scene.constants, *scene.undefined, *scene.roots]
        values = {
            name: self.values.get(name) or self(scalar(stage.formula(name), stage))
            for name in names
        }
        return Point({name: show_number(value) for name, value in values.items()})


def counterexample(
    bench: Bench,
    scene: Scene,
    key: Key,
    pairs: Callable[[Stage], Sequence[tuple[Element, Element]]],
    zero: Callable[[Stage], Sequence[Element]] = lambda stage: (),
    words: str = "",
) -> Counterexample | None:
    """An exact point where ``zero`` vanishes and the members of a pair differ.

    The point is found with FLINT and both values are computed in the arithmetic
    of the bench; ``None`` if no such point was found.
    """
    if not bench.refute:
        return None

    def search(finder: Bench) -> dict[str, tuple[Fraction, Fraction]] | None:
        from kowalevski_cas.search.real import real_points

        stage = finder.stage(scene)
        left_right = pairs(stage)
        differing = [a - b for a, b in left_right if not (a - b).is_zero]
        if not differing:
            return None
        for point in real_points(stage, zero(stage), ()):
            at = AtPoint(stage, point)
            try:
                if not at(differing[0]).is_zero:
                    return point
            except ZeroDivisionError:
                continue
        return None

    point = bench.found(("counterexample", key), search)
    if point is None:
        return None
    stage = bench.stage(scene)
    at = AtPoint(stage, point)
    if any(not at(element).is_zero for element in zero(stage)):
        return None
    for left, right in pairs(stage):
        a, b = at(left), at(right)
        if not (a - b).is_zero:
            return Counterexample(at.shown(), show_number(a), show_number(b), words)
    return None


__all__ = [
    "AtPoint",
    "Claim",
    "Finding",
    "Neighbour",
    "ask",
    "components",
    "conditions_of",
    "counterexample",
    "differences",
    "equation",
    "equations",
    "green",
    "locus_of",
    "members",
    "refuted",
    "show",
    "show_number",
]
