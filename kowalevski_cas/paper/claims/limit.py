"""Limits: a specialisation commutes with the derivation of a cofactor matrix."""

from __future__ import annotations

from collections.abc import Iterator

from kowalevski_cas.notation import Formula, Negative, edits, times, total
from kowalevski_cas.paper.claims.claim import Claim, Neighbour
from kowalevski_cas.paper.claims.forms import (
    ONE,
    entries,
    equations,
    matrix,
    minus,
    names_in,
    rate,
    vanishes,
)
from kowalevski_cas.paper.claims.invariant_relations import InvariantRelations
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.matrices import Rows, diagonal, matrix_times_column, product
from kowalevski_cas.paper.texts import Texts
from kowalevski_cas.problem.goals import Exists, Follows, Goal, identity


class Limit(Claim):
    r"""The cofactor matrix of ``general`` goes over into the one of ``special``.

    On the scene of the limit let F be the general functions and e those of the
    special system. There is an invertible T with F = T e, and where e vanishes
    :math:`\dot T + T N = \kappa M T`, M being the matrix of the general system, N that of the
    special one, and :math:`\kappa` the ratio of the times, if there are two. M and N are regular on
    their sets, and M, N, T and its inverse where e vanishes.
    """

    general: InvariantRelations
    special: InvariantRelations

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        size = len(self.special.relations)
        m, n, t, s = (matrix(letter, size) for letter in "MNTS")
        space = on(self.scene)
        special = equations(on, space, self.special.relations)
        general = [minus(sides) for sides in equations(on, space, self.general.relations)]
        through = matrix_times_column(t, [minus(sides) for sides in special])
        # S is named to be the inverse, so that T is invertible wherever both are regular
        inverse = tuple(entries((product(t, s), diagonal([ONE] * size))))
        same = map(vanishes, self._rest(on, m, n, t))
        goals = (
            *self.general.moves_by(m, on),
            *self.special.moves_by(n, on),
            identity(space, *zip(general, through, strict=True)),
            identity(space, *inverse),
            Follows(space, ((*inverse, *same),), special),
        )
        yield Exists(goals, tuple(name for matrix in (m, n, t, s) for name in names_in(matrix)))

    def _rest(self, on: Elaborations, m: Rows, n: Rows, t: Rows) -> Iterator[Formula]:
        """The entries of the difference."""
        space = on(self.scene)
        clock = self.scene.clock
        scale = space.plain(on.texts.time_change(clock).rate) if clock is not None else ONE
        for rows in zip(t, product(t, n), product(m, t), strict=True):
            for a, b, c in zip(*rows, strict=True):
                yield total((rate(a), b, Negative(times(scale, c))))

    def neighbours(self, texts: Texts, wanted: Formula | None = None) -> Iterator[Neighbour]:
        for printed in self.special.relations:
            for edit in edits(texts.statement(printed), texts.vocabulary, wanted=wanted):
                if edit.kind == "sign":
                    yield Neighbour(edit.words, self, texts, printed, edit)
