r"""Angles that are given at points of rest: what moves by their sines is known up to a turn.

So :math:`\theta=\pi` is an equilibrium of :math:`\ddot\theta=-\sin\theta` if nothing moves where
:math:`\sin\theta=\sin\pi` and :math:`\cos\theta=\cos\pi`.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from kowalevski_cas.notation import Application, Derivative, Formula, Name, to_latex
from kowalevski_cas.notation.functions import FAMILY_OF
from kowalevski_cas.reading.known import Known
from kowalevski_cas.reading.law import Law
from kowalevski_cas.reading.linear_parts import equations_of
from kowalevski_cas.reading.rest_points import coordinates, is_of_family
from kowalevski_cas.reading.statements import SourceStatement
from kowalevski_cas.reading.unprinted import unprinted

UP_TO_A_TURN = "an angle that moves by its sine and cosine, which are those of this value"


def up_to_turns(
    equations: Iterable[SourceStatement], law: Law, known: Known
) -> tuple[SourceStatement, ...]:
    """Some equations, with those of sines and cosines for those that give angles."""
    return tuple(each for one in equations for each in _of_equation(one, law, known))


def equations_of_point(
    item: SourceStatement, law: Law, known: Known
) -> tuple[SourceStatement, ...]:
    """The equations of a point that is printed by its coordinates."""
    point = coordinates(item, law, known, free=is_of_family(item))
    values = dict(zip(law.variables, map(to_latex, point), strict=True))
    return up_to_turns(equations_of(values, item, law, known), law, known)


def _of_equation(one: SourceStatement, law: Law, known: Known) -> Iterator[SourceStatement]:
    *angles, value = one.members
    if known.varying(value.names()) or not all(
        isinstance(angle, Name) and is_angle(angle.name, law) for angle in angles
    ):
        yield one
        return
    for number, angle in enumerate(angles, 1):
        for function in ("sin", "cos"):
            id = f"{function}-{number}-of-{one.printed.display.id}"
            tex = rf"\{function}{{{to_latex(angle)}}}=\{function}\left({to_latex(value)}\right)"
            yield unprinted(known.paper, id, tex, one, UP_TO_A_TURN)


def is_angle(name: str, law: Law) -> bool:
    """Whether a variable stands in a law under sines, cosines and the like, and nowhere else."""
    sides = [member for row in law.rows for member in row.members]
    under = (
        node
        for side in sides
        for node in side.nodes()
        if isinstance(node, Application) and _is_of_angles(node)
    )
    return any(name in node.names() for node in under) and not any(
        _stands_alone(name, side) for side in sides
    )


def _stands_alone(name: str, formula: Formula) -> bool:
    """Whether a name stands in a formula neither under functions of angles nor as a rate."""
    inner = formula
    while isinstance(inner, Derivative):
        inner = inner.argument
    if isinstance(inner, Name):
        return inner is formula and inner.name == name
    return not _is_of_angles(inner) and any(_stands_alone(name, one) for one in inner.children())


def _is_of_angles(formula: Formula) -> bool:
    """Whether a formula is a function that knows parts of a turn, as the sine does."""
    family = FAMILY_OF.get(formula.function) if isinstance(formula, Application) else None
    return family is not None and bool(family.angles)
