"""Relations of constants that a claim misses: it fails for most values, and holds for some.

What a failing identity says of the constants alone is a common factor of all its coefficients, by
the monomials in the variables. Where that vanishes, the identity holds.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator
from contextlib import suppress
from dataclasses import dataclass, replace
from random import Random

from flint import fmpq_mpoly

from kowalevski_cas.algebra.flint import with_values
from kowalevski_cas.algebra.polynomials import Polynomials
from kowalevski_cas.algebra.present import formula_of
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.notation import Formula, Name, NotationError, Sum, to_latex
from kowalevski_cas.notation import Relation as Equation
from kowalevski_cas.paper.claims import Claim, Neighbour
from kowalevski_cas.paper.derivation import Derivation
from kowalevski_cas.paper.elaborate import Elaboration
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.paper.texts import Display, Printed, Texts
from kowalevski_cas.problem.goals import Follows
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.verify.statement import Statement

POINTS = 2
"""At how many points factors are sought."""
LARGEST = 100
"""The coordinates of these points are less."""


@dataclass(frozen=True)
class ConstantRelation:
    """A relation that gives a constant of a scene by the others."""

    constant: str
    formula: Formula
    scene: Scene

    @property
    def words(self) -> str:
        """What is to be supposed."""
        return f"suppose ${to_latex(self.formula)}$"

    @property
    def place(self) -> Printed:
        """Where it would be printed."""
        tex = to_latex(self.formula)
        return Display(f"supposed {tex}", tex, "", source="supposed")[1]

    def concerns(self, scene: Scene) -> bool:
        """Whether the constants of the relation are constants of a scene with the same motion."""
        return scene.field == self.scene.field and self.formula.names() <= {*scene.constants}

    def neighbour(self, claim: Claim, texts: Texts) -> Neighbour:
        """A claim where this is supposed."""
        kept = tuple(name for name in claim.scene.constants if name != self.constant)
        scene = replace(claim.scene, constants=kept).naming(self.constant, self.place)
        return Neighbour(self.words, replace(claim, scene=scene), texts, self.place)


def supposes(scene: Scene, derivation: Derivation, texts: Texts) -> bool:
    """Whether a scene gives what is a constant on another scene a value by constants."""
    constants = {name for other in derivation.scenes() for name in other.constants}
    known = constants - {*scene.variables} - {part for v in scene.vectors.values() for part in v}
    places = (place for name, place in scene.definitions.items() if name in known)
    return any(texts.statement(place).formula.names() <= known for place in places)


def relations(statement: Statement) -> Iterator[ConstantRelation]:
    """The relations of constants by which all identities of a statement hold.

    Each is linear in one constant, and has two terms at least: that a constant vanishes, or what
    is defined by constants, or a sum of them in the claim, leaves nothing of what it stands before.
    """
    with suppress(NotationError, Meaningless, ZeroDivisionError):
        space = statement.on(statement.claim.scene)
        named = [*_named_differences(space), *_printed_sums(statement, space)]
        for factor in common_factors(statement, space.constants):
            if not any(all(not divmod(part, factor)[1] for part in parts) for parts in named):
                yield from _solve(space, factor, statement.claim.scene)


def common_factors(statement: Statement, constants: Collection[str]) -> Iterator[fmpq_mpoly]:
    """The irreducible polynomials in these constants where all identities of a statement hold.

    They have several terms, and are of the ring of the scene of its claim.
    """
    space = statement.on(statement.claim.scene)
    values = [
        value
        for goal in statement.claimed
        if type(goal) is Follows and goal.space is space and not goal.given
        for value in space.finder.differences(goal.conclusions[0])
    ]
    parts = [part for value in values for part in value.parts.values()]
    return _factors(space.finder.ring.polynomials, parts, constants)


def _named_differences(space: Elaboration) -> list[tuple[fmpq_mpoly, ...]]:
    """The numerators of what the scene defines, as I_31 = I_3 − I_1, by the roots in them."""
    found = []
    for name in space.scene.definitions:
        with suppress(NotationError, Meaningless, ZeroDivisionError):
            found.append(tuple(space.finder.scalar(Name(name)).parts.values()))
    return [parts for parts in found if parts]


def _printed_sums(statement: Statement, space: Elaboration) -> Iterator[tuple[fmpq_mpoly, ...]]:
    """The numerators of the sums of constants that the places of a claim print, by their roots."""
    for place in statement.claim.places():
        for node in space.texts.statement(place).formula.nodes():
            if isinstance(node, Sum) and node.names() <= {*space.constants}:
                with suppress(NotationError, Meaningless, ZeroDivisionError):
                    yield tuple(space.finder.scalar(node).parts.values())


def _factors(
    ring: Polynomials, polynomials: list[fmpq_mpoly], constants: Collection[str]
) -> Iterator[fmpq_mpoly]:
    """The irreducible common factors of polynomials that have constants only, and several terms.

    Where all else has values they are factors still: few values leave hardly any others.
    """
    moving = [k for k, name in enumerate(ring.generators) if name not in constants]
    common, random = ring.zero, Random(0)
    for polynomial in sorted(polynomials, key=len):  # most have none, and the shortest tells it
        for _ in range(POINTS):
            values = {place: random.randrange(1, LARGEST) for place in moving}
            common = common.gcd(with_values(polynomial, values))
            if common.is_constant() and not common.is_zero():
                return
    for factor, _ in [] if common.is_zero() else common.factor()[1]:
        if len(factor) > 1 and not any(divmod(polynomial, factor)[1] for polynomial in polynomials):
            yield factor


def _solve(space: Elaboration, factor: fmpq_mpoly, scene: Scene) -> Iterator[ConstantRelation]:
    """The relation that a polynomial vanishes, solved for a constant in which it is linear."""
    ring = space.finder.ring
    names = ring.polynomials.generators
    for place in sorted(ring.polynomials.occurring_places(factor), key=lambda k: names[k]):
        linear = factor.derivative(place)
        if names[place] not in scene.constants or not linear.is_constant():
            continue
        rest = Element(ring, {0: factor - linear * ring.polynomials.generator(place)}, {})
        value = rest * Element(ring, {0: -linear}, {}).inverse()
        shown = formula_of(value, space.texts.vocabulary)
        yield ConstantRelation(names[place], Equation((Name(names[place]), shown), ("=",)), scene)
        return
