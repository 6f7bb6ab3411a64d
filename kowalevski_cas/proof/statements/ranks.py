"""Claims about dimension and independence: ranks at an exact point."""

from __future__ import annotations

from kowalevski_cas.claims import (
    Dimension,
    Independence,
)
from kowalevski_cas.claims.dimension import Set
from kowalevski_cas.claims.formulas import members
from kowalevski_cas.proof.parts import Parts
from kowalevski_cas.proof.statements.kinds import (
    sides_of,
    state,
)
from kowalevski_cas.paper.texts import Printed


@state.register
def _dimension(claim: Dimension, parts: Parts) -> None:
    _rank(claim, parts, (), claim.dimension)
    parts.notes.append("the set is a manifold of this dimension near the point")


@state.register
def _independence(claim: Independence, parts: Parts) -> None:
    _rank(claim, parts, claim.functions, None)


def _rank(claim: Set, parts: Parts, functions: tuple[Printed, ...], dimension: int | None) -> None:
    space = parts.space(claim.scene)
    levels, trees = (
        [space.tree(members(space.stage.relation(printed))[0]) for printed in places]
        for places in (claim.levels, functions)
    )
    parts.rank(space, levels, trees, sides_of(space, claim.equations), dimension)
