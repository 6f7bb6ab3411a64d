"""Lax pairs: the equations of motion in matrices, with invariants that are integrals."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import accumulate, repeat

from kowalevski_cas.notation import Formula, Partial
from kowalevski_cas.paper.claims.forms import function, vanishes
from kowalevski_cas.paper.claims.identity import Identity
from kowalevski_cas.paper.elaborate import Elaboration
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.matrices import product, rows, trace
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.problem.goals import Fails, Goal


class LaxPair(Identity):
    r"""The printed equation :math:`L'=LM-ML` holds, and gives an integral.

    The traces of the powers of L, which is printed at ``matrix``, are constant along the motion
    then. One of them is not constant by itself: a matrix that is zero, constant or nilpotent has
    no other ones, and says nothing of the motion.
    """

    matrix: Printed

    def goals(self, on: Elaborations) -> Iterator[Goal]:
        yield from super().goals(on)
        space = on(self.scene)
        matrix = rows(function(on, space, self.matrix), space)
        # by Newton's identities these determine all eigenvalues: higher powers say nothing new
        traces = [trace(power) for power in accumulate(repeat(matrix, len(matrix)), product)]
        moving = next((trace for trace in traces if _varies(trace, space)), None)
        chosen = traces if moving is None else [moving]
        slopes = (Partial(trace, name) for trace in chosen for name in space.variables)
        yield Fails(space, (tuple(map(vanishes, slopes)),))


def _varies(formula: Formula, space: Elaboration) -> bool:
    """Whether a formula is not constant by itself."""
    value = space.finder.scalar(formula)
    return any(not space.finder.partial(value, name).is_zero for name in space.variables)
