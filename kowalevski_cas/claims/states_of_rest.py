r"""States of rest for given values of integrals: the system for them, and exact ones."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction

from kowalevski_cas.arithmetic.numbers import number_ring, show_number
from kowalevski_cas.arithmetic.polynomials import Terms
from kowalevski_cas.arithmetic.present import formula_of
from kowalevski_cas.arithmetic.tower import Element, Ring
from kowalevski_cas.claims.claim import Claim
from kowalevski_cas.claims.real_roots import System
from kowalevski_cas.claims.rest import Rest
from kowalevski_cas.notation import Formula, Name, Number, Relation, Vector, Vocabulary
from kowalevski_cas.proof.outcome import Counterexample, Point, Value
from kowalevski_cas.stage import Stage, scalar
from kowalevski_cas.paper.texts import Printed, Texts

Values = tuple[Fraction, ...]


@dataclass(frozen=True, eq=False)
class StatesOfRest(Claim):
    """What a claim about states of rest stands on.

    ``fixed`` are the variables that vanish at rest; ``levels`` are printed
    integrals with their values, which are the parameters; ``count`` is the number
    of states that is claimed.
    """

    fixed: tuple[str, ...]
    levels: tuple[Printed, ...]
    count: int

    def sides(self, texts: Texts, side: int) -> list[Formula]:
        """The left sides of the levels, the integrals (0), or the right ones, their values (1)."""
        relations = [texts.formula(printed) for printed in self.levels]
        return [relation.members[side] for relation in relations if isinstance(relation, Relation)]

    def system(self, rest: Rest, texts: Texts) -> System | None:
        """The system for the states of rest; ``None`` if there is a parameter on its left side."""
        stage, ring = rest.stage, rest.stage.ring
        everywhere = [scalar(formula, stage) for formula in self.sides(texts, 0)]
        constants = [ring.polynomials.generators.index(c) for c in stage.scene.constants]
        for element in (*everywhere, *stage.field.values()):
            if element.denominator or element.parts.keys() - {0}:
                return None
            if any(exponents[k] for exponents in element.terms().get(0, {}) for k in constants):
                return None
        own = {name: ring.generator(name) for name in rest.free}
        at_rest = rest.at(ring, own)
        levels = [at_rest(level) for level in everywhere]
        return System(levels, list(own.values()), everywhere, self.sides(texts, 1))

    def on_constants(self, stage: Stage) -> Stage:
        """The scene in a ring of its constants and the form s."""
        ring = Ring(stage.arithmetic(("s", *stage.scene.constants)))
        image = {name: ring.generator(name) for name in stage.scene.constants}
        return Stage(stage.scene, stage.arithmetic, stage.texts, ring, image)

    def shown(self, stage: Stage, system: System, terms: Terms) -> Element:
        """A polynomial in the form and the parameters, with the printed values of the levels."""
        inner = self.on_constants(stage)
        values = [scalar(formula, inner) for formula in system.values]
        return system.into(values, inner.ring.generator("s"))(system.element(terms))

    def exhibit(
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
        shown: dict[Formula, Value] = {}
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
                    row = (show_number(at(stage.ring.generator(c))) for c in components)
                    shown[Name(f"{name}_{k}")] = Vector(tuple(row))
        into = system.into(first)
        if any(not into(system.element(terms)).is_zero for terms in zero):
            return None
        if any(into(system.element(terms)).is_zero for terms in nonzero):
            return None
        heads = {f: show_number(value) for f, value in zip(system.values, first, strict=True)}
        there, claimed = Number(len(points)), Number(self.count)
        return Counterexample(Point({**heads, **shown}), there, claimed, words)

    def places(self) -> Iterator[Printed]:
        yield from super().places()
        yield from self.levels


def in_unknowns(system: System) -> list[Terms]:
    """The levels as polynomials in the unknowns only."""
    places = [next(iter(u.terms()[0])).index(1) for u in system.unknowns]
    return [
        {tuple(e[k] for k in places): value for e, value in level.terms()[0].items()}
        for level in system.levels
    ]


def proportional(first: Element, second: Element) -> bool:
    """Whether two polynomials differ by a number."""
    a, b = first.terms().get(0, {}), second.terms().get(0, {})
    if not a or not b or max(a) != max(b):
        return False
    ratio = first.ring.number(a[max(a)] / b[max(b)])
    return (first - ratio * second).is_zero


def in_own_names(element: Element) -> Formula:
    """An element in the names of its ring."""
    names = frozenset(element.ring.polynomials.generators)
    return formula_of(element, Vocabulary(scalars=names))
