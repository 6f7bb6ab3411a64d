r"""Polynomials as sums of squares times what is not negative, by semidefinite programs.

Nobody believes what they find: it is an identity of polynomials, and checked as one.
"""

from __future__ import annotations

from collections.abc import Sequence

from flint import fmpq_mpoly, fmpq_mpoly_ctx

from kowalevski_cas.algebra.polynomials import TooLarge
from kowalevski_cas.search.gram import GramEquations, Representation

MOST_WEIGHTS = 2
"""Of how many weights products are taken."""


def represent(
    target: fmpq_mpoly, weights: Sequence[fmpq_mpoly], known: Sequence[fmpq_mpoly] = ()
) -> Representation | None:
    """A polynomial as a sum of squares times weights, up to multiples of what is known.

    Without the extra ``squares`` none is looked for.
    """
    try:
        import clarabel  # noqa: F401 # whether it is there
    except ImportError:
        return None
    if target.is_zero():
        return None
    there, back = _coordinates(weights, target.context())
    target, weights, known = (
        target.compose(*there),
        [one.compose(*there) for one in weights],
        [one.compose(*there) for one in known],
    )
    for size in range(min(len(weights), MOST_WEIGHTS) + 1):
        try:
            equations = GramEquations(target, weights, known, size)
        except TooLarge:
            return None
        if (found := equations.solve()) is not None:
            return found.composed(back)
    return None


def _coordinates(
    weights: Sequence[fmpq_mpoly], context: fmpq_mpoly_ctx
) -> tuple[list[fmpq_mpoly], list[fmpq_mpoly]]:
    """Linear coordinates in which weights are variables, as far as that goes, and the way back.

    So a chain of inequalities is a product of half lines.
    """
    there, back = [*context.gens()], [*context.gens()]
    taken: set[int] = set()
    for weight in weights:
        own = weight.compose(*there)
        free = [k for k, d in enumerate(own.degrees()) if d and k not in taken]
        if own.total_degree() != 1 or not free:
            continue
        slope = own.derivative(free[0])
        gen = context.gens()[free[0]]
        taken.add(free[0])
        solved = (gen - (own - slope * gen)) / slope.leading_coefficient()
        images = [solved if k == free[0] else one for k, one in enumerate(context.gens())]
        there = [one.compose(*images) for one in there]
        back[free[0]] = weight
    return there, back
