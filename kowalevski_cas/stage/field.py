"""Vector fields as printed equations of motion give them."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kowalevski_cas.arithmetic.tower import Element
from kowalevski_cas.notation import (
    Derivative,
    Formula,
    Name,
    Number,
    Product,
    Relation,
    Vector,
)
from kowalevski_cas.stage.evaluate import StageError, Triple, evaluate, scalar
from kowalevski_cas.paper.texts import Printed

if TYPE_CHECKING:
    from kowalevski_cas.stage.stage import Stage


def printed_field(equations: tuple[Printed, ...], stage: Stage) -> dict[str, Element]:
    r"""The components that printed equations give to the derivatives on their left sides.

    The left side is a derivative with a factor: ``\dot\alpha``, ``2\dot\omega_1``,
    ``\mathbf{I}\dot\omega``. Components of variables that the scene sets to zero
    must vanish.
    """
    field: dict[str, Element] = {}
    for printed in equations:
        relation = stage.relation(printed)
        name, factor = _left_side(relation, printed)
        components = stage.scene.vectors.get(name, (name,))
        if name in stage.scene.vectors:
            factor = _with_ones(factor, Vector((Number(1),) * len(components)))
        else:
            factor = _with_ones(factor, Number(1))
        below = evaluate(factor, stage)
        above = evaluate(relation.members[1], stage)
        belows = below if isinstance(below, Triple) else (below,)
        aboves = above if isinstance(above, Triple) else (above,)
        if not len(components) == len(aboves) == len(belows):
            raise StageError(f"vectors and scalars are mixed up in the equation at {printed.place}")
        for component, numerator, divisor in zip(components, aboves, belows, strict=True):
            field[component] = numerator / divisor
    for component in [name for name in field if name not in stage.scene.variables]:
        if not field.pop(component).is_zero:
            raise StageError(f"{component} = 0 is not preserved by the equations", component)
    return field


def _left_side(relation: Relation, printed: Printed) -> tuple[str, Formula]:
    """The variable that is differentiated on the left, and the left side itself."""
    left = relation.members[0]
    factors = left.factors if isinstance(left, Product) else (left,)
    match [f.argument for f in factors if isinstance(f, Derivative)]:
        case [Name(name)]:
            return name, left
    raise StageError(f"the equation at {printed.place} has no derivative of a name on its left")


def _with_ones(left: Formula, ones: Formula) -> Formula:
    if isinstance(left, Product):
        return Product(tuple(ones if isinstance(f, Derivative) else f for f in left.factors))
    return ones


def time_scale(printed: Printed, stage: Stage, conjugated: bool = False) -> Element:
    r"""The factor :math:`\kappa` of a printed change of time, :math:`\tau=\kappa t`."""
    right = stage.relation(printed).members[1]
    if not isinstance(right, Product) or right.factors[-1] != Name("t"):
        raise StageError(f"the equation at {printed.place} is no multiple of t")
    return scalar(Product((*right.factors[:-1], Number(1))), stage, conjugated)
