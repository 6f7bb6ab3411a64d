"""Dimension and independence: manifolds by independent differentials, at each of their points."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cache

from kowalevski_cas.notation import Conjugate, Formula, Name, Partial, times, total
from kowalevski_cas.paper.claims.claim import Claim, Neighbour
from kowalevski_cas.paper.claims.forms import equations, first_member, minus, vanishes
from kowalevski_cas.paper.elaborate import Elaboration
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.paper.texts import Printed, Texts
from kowalevski_cas.problem.evidence import At, Denial, Evidence, Minors
from kowalevski_cas.problem.finder import finder_of
from kowalevski_cas.problem.goals import Follows, Goal, Rank
from kowalevski_cas.problem.space import Meaningless


class Dimension(Claim):
    r"""The set is a manifold of this dimension, on each level of some integrals.

    ``levels`` are printed integrals whose values are fixed, ``equations`` the printed
    equations of the set. At a real point of it the differentials of all these are independent,
    and so many that the dimension is left; and at every point they are independent: a
    combination :math:`\sum\lambda_k\,df_k=0` has no coefficients but zero. The real dimension
    is meant: a complex equation has to come with its conjugate.
    """

    levels: tuple[Printed, ...]
    equations: tuple[Printed, ...]
    dimension: int

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        space = on(self.scene)
        levels = tuple(first_member(on, space, printed) for printed in self.levels)
        given = equations(on, space, self.equations)
        functions = [*levels, *map(minus, given)]
        values = [space.finder.scalar(function) for function in functions]
        check_conjugates(functions, space)
        yield Rank(space, levels, given, len(space.variables) - self.dimension)
        multipliers = [Name(name) for name in self._multipliers]
        combined = (
            vanishes(
                total(
                    times(m, Partial(f, name)) for m, f in zip(multipliers, functions, strict=True)
                )
            )
            for name in space.variables
            if any(not space.finder.partial(value, name).is_zero for value in values)
        )
        yield Follows(
            on(self._with_multipliers), (tuple(map(vanishes, multipliers)),), (*given, *combined)
        )

    def search(self, goals: Sequence[Goal]) -> Mapping[int, Evidence]:
        """That no combination of the differentials vanishes, by a Gröbner basis."""
        from kowalevski_cas.search.regular import regular

        rank, everywhere = goals
        assert isinstance(rank, Rank) and isinstance(everywhere, Follows)
        at = finder_of(everywhere.space)
        found = regular(
            everywhere,
            at,
            (*rank.functions, *map(minus, rank.given)),
            self._multipliers,
            [*at.granted, *(at.scalar(condition) for _, condition in at.setting.loci)],
        )
        return {} if found is None else {1: found}

    def refuted_by(self, denial: Denial) -> bool:
        """Only by a point near which the dimension is another one.

        A set may be a manifold where the differentials of its equations are dependent.
        """
        return denial.goal == 0 and isinstance(denial.evidence, At)

    def scenes(self) -> Iterator[Scene]:
        yield from (self.scene, self._with_multipliers)

    @property
    def _multipliers(self) -> tuple[str, ...]:
        count = len(self.levels) + len(self.equations)
        return tuple(rf"\lambda_{k}" for k in range(1, count + 1))

    @property
    def _with_multipliers(self) -> Scene:
        return _with_constants(self.scene, self._multipliers)


def check_conjugates(functions: Sequence[Formula], space: Elaboration) -> None:
    """Refuse a function whose conjugate is none of the others, up to the sign."""
    values = [space.finder.scalar(function) for function in functions]
    for function in functions:
        bar = space.finder.scalar(Conjugate(function))
        if not any((bar - value).is_zero or (bar + value).is_zero for value in values):
            raise Meaningless(
                "a function of the set is complex, and its conjugate is not among the others: "
                "give the equations for both, for the real dimension counts both"
            )


# settings are kept by the scene itself: asked for again, it has to be the same one
@cache
def _with_constants(scene: Scene, multipliers: tuple[str, ...]) -> Scene:
    """The scene with more constants: complex ones, if it has complex variables."""
    if not scene.conjugates:
        return scene.having(constants=multipliers)
    bars = tuple(rf"\mu_{k}" for k, _ in enumerate(multipliers, 1))
    pairs = tuple(zip(multipliers, bars, strict=True))
    return scene.having(constants=(*multipliers, *bars), conjugates=pairs)


class Independence(Claim):
    """Functions are independent on a dense part of the set, on each level of some integrals.

    ``functions`` are the first members of printed equations. The set has to be a graph: its
    ``equations`` say the same as those in ``graph``, which give some variables by the others. So
    each piece of it lies over all of these, and a minor that does not vanish at one point, whatever
    the signs of the roots in it are, vanishes on no open part.
    """

    levels: tuple[Printed, ...]
    equations: tuple[Printed, ...]
    functions: tuple[Printed, ...]
    graph: tuple[Printed, ...] = ()

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        space, others = on(self.scene), on(_over(self.scene, self.graph))
        given, graph = (equations(on, space, places) for places in (self.equations, self.graph))
        if given or graph:
            yield Follows(space, (graph,), given)
            yield Follows(space, (given,), graph)
            own = tuple(first_member(on, space, p) for p in (*self.levels, *self.functions))
            yield Rank(space, own, given, len(own) + len(self.graph))
        functions = tuple(first_member(on, others, p) for p in (*self.levels, *self.functions))
        yield Rank(others, functions, (), len(functions))

    def refuted_by(self, denial: Denial) -> bool:
        """Only if the functions are dependent on the set itself, which need not be this graph."""
        on_set = 2 if self.equations or self.graph else 0
        return isinstance(denial.evidence, Minors) and denial.goal == on_set

    def scenes(self) -> Iterator[Scene]:
        yield from (self.scene, _over(self.scene, self.graph))

    def neighbours(self, texts: Texts, wanted: Formula | None = None) -> Iterator[Neighbour]:
        first, *_ = self.functions
        claim = replace(self, functions=(*self.functions, first))
        yield Neighbour("with one of the functions taken twice", claim, texts)


# the same scene whenever it is asked for, as settings are kept by it
@cache
def _over(scene: Scene, graph: tuple[Printed, ...]) -> Scene:
    """The scene over which a set is a graph."""
    return scene.solved(*graph) if graph else scene
