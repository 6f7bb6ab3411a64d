"""Claims about a Poisson bracket: Jacobi's identity, Casimir functions, involution, integrability.

The bracket is the one that the scene prints for its variables.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations, pairwise

from kowalevski_cas.notation import (
    Formula,
    Name,
    Negative,
    Number,
    PoissonBracket,
    Relation,
    times,
    total,
)
from kowalevski_cas.notation.edits import substitute
from kowalevski_cas.paper.claims.claim import Claim
from kowalevski_cas.paper.claims.first_integral import FirstIntegral
from kowalevski_cas.paper.claims.forms import function, rate, vanishes
from kowalevski_cas.paper.components import sides
from kowalevski_cas.paper.elaborate import Elaboration
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.names import BRACKET, head
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.problem.goals import Fails, Goal, Rank, identity
from kowalevski_cas.problem.space import Equation, Meaningless


class Jacobi(Claim):
    """The printed bracket satisfies Jacobi's identity."""

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        yield from _jacobi(on(self.scene))

    def establishes(self) -> Iterator[Printed]:
        for name, place in self.scene.definitions.items():
            if head(name)[0] == BRACKET:
                yield place


class Casimir(Claim):
    """The bracket of the printed function with every function vanishes; it is not constant.

    A value may be printed of it, as of a first integral; then the function has it at a real point.
    """

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        space = on(self.scene)
        integral = FirstIntegral(self.id, self.scene, "", printed=self.printed)
        chain = integral.constants(on, space)
        valued = len(chain) == 1 and isinstance(on.texts.formula(self.own), Relation)
        valued &= self.own not in self.scene.definitions.values()
        printed = chain[0] if valued else function(on, space, self.own)
        yield identity(space, *_central(space, [printed]))
        yield Rank(space, (space.plain(printed),), (), 1)
        if valued:
            yield from integral.levels(on)


class Involution(Claim):
    """The brackets of the printed functions with each other vanish."""

    functions: tuple[Printed, ...]

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        if len(self.functions) < 2:
            raise Meaningless("two functions at least are in involution")
        space = on(self.scene)
        functions = [function(on, space, place) for place in self.functions]
        yield identity(space, *commutation(space, functions))

    def establishes(self) -> Iterator[Printed]:
        yield from self.functions


class OfAllFunctions(Claim):
    r"""What is printed of any function, its rate or its brackets, holds for every variable.

    Both derive: so :math:`\dot f=\{f,H\}` holds for all functions f, whose name is ``of``.
    """

    of: str

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        space = on(self.scene)
        members = on.texts.relation(self.own).members
        chains = ([substitute(m, {self.of: Name(x)}) for m in members] for x in space.variables)
        yield identity(space, *(pair for one in chains for pair in pairwise(sides(one, space))))


class LiouvilleIntegrable(Claim):
    """The motion is integrable in the sense of Liouville, by ``integrals`` and ``casimirs``.

    Each variable moves by its bracket with the first of the integrals. The bracket satisfies
    Jacobi's identity; the integrals are in involution, and all functions are independent at a real
    point. There are as many integrals as half the rank of the bracket, which is its largest
    possible one at a real point.
    """

    integrals: tuple[Printed, ...]
    casimirs: tuple[Printed, ...] = ()

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        space = on(self.scene)
        integrals, casimirs = (
            [function(on, space, place) for place in places]
            for places in (self.integrals, self.casimirs)
        )
        if not integrals:
            raise Meaningless("the first of the integrals is the Hamiltonian: there is none")
        variables = [Name(name) for name in space.variables]
        size, rank = len(variables), 2 * len(integrals)
        if size != rank + len(casimirs):
            raise Meaningless(
                f"{size} variables, {len(casimirs)} Casimir functions and {len(integrals)} "
                "integrals: the variables are to be the Casimir functions and twice the integrals"
            )
        moves = ((rate(x), _bracket(space, x, integrals[0])) for x in variables)
        yield identity(space, *moves)
        # in two variables every bracket satisfies it
        if size > 2:
            yield from _jacobi(space)
        if casimirs:
            yield identity(space, *_central(space, casimirs))
        if len(integrals) > 1:
            yield identity(space, *commutation(space, integrals))
        functions = tuple(map(space.plain, (*integrals, *casimirs)))
        # with it the bracket has no larger rank: so many independent functions commute with
        # everything
        yield Rank(space, functions, (), len(functions))
        # a skew matrix has its rank in a principal minor too, and this is the square of the
        # Pfaffian
        minors = (pfaffian(space, some) for some in combinations(variables, rank))
        yield Fails(space, (tuple(map(vanishes, minors)),))

    def establishes(self) -> Iterator[Printed]:
        yield from (*self.integrals, *self.casimirs)


def _bracket(space: Elaboration, left: Formula, right: Formula) -> Formula:
    return space.plain(PoissonBracket(left, right))


def _jacobi(space: Elaboration) -> Iterator[Goal]:
    """Jacobi's identity, for all variables."""
    if len(space.variables) < 3:
        raise Meaningless("every bracket of two variables satisfies Jacobi's identity")
    equations = []
    for x, y, z in combinations(map(Name, space.variables), 3):
        turned = ((x, y, z), (y, z, x), (z, x, y))
        terms = (_bracket(space, a, PoissonBracket(b, c)) for a, b, c in turned)
        equations.append(vanishes(total(terms)))
    yield identity(space, *equations)


def _central(space: Elaboration, functions: Sequence[Formula]) -> Iterator[Equation]:
    """That functions commute with every variable."""
    for f in functions:
        yield from (vanishes(_bracket(space, f, Name(x))) for x in space.variables)


def commutation(space: Elaboration, functions: Sequence[Formula]) -> Iterator[Equation]:
    """That functions commute with each other."""
    return (vanishes(_bracket(space, f, g)) for f, g in combinations(functions, 2))


def pfaffian(space: Elaboration, variables: Sequence[Formula]) -> Formula:
    """The Pfaffian of the brackets of an even number of variables, by its first row."""
    if not variables:
        return Number(1)
    first, *others = variables
    terms = []
    for k, other in enumerate(others):
        rest = pfaffian(space, [*others[:k], *others[k + 1 :]])
        term = times(_bracket(space, first, other), rest)
        terms.append(Negative(term) if k % 2 else term)
    return total(terms)
