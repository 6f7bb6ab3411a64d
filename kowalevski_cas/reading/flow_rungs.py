"""What a statement may claim of the flow: its divergence, points of rest, linear parts."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import product
from typing import Any

from kowalevski_cas.paper.claims import (
    CharacteristicEquation,
    Claim,
    Divergence,
    Eigenvalue,
    Frequency,
    FrequencyEquation,
    LinearPart,
    Period,
    PreservedMeasure,
    RestPoint,
    RestPoints,
    TraceOrDeterminant,
)
from kowalevski_cas.reading.angles_at_rest import equations_of_point, is_angle
from kowalevski_cas.reading.fixed_points import FIXED, equations_of_fixed_point
from kowalevski_cas.reading.kinematics import is_free
from kowalevski_cas.reading.law import Law
from kowalevski_cas.reading.linear_parts import (
    DETERMINANT,
    MATRIX,
    TRACE,
    equations_of,
    matrix_point,
    point_of,
    point_of_number,
)
from kowalevski_cas.reading.rest_points import (
    MARKED,
    POINT,
    in_marked_letters,
    law_of_points,
    marked,
)
from kowalevski_cas.reading.rung import Rung, RungMaker, places
from kowalevski_cas.reading.small_oscillations import (
    CHARACTERISTIC,
    FREQUENCY,
    OF_LINEAR_PART,
    equation_of_root,
    is_damped,
    is_of_equation,
    is_period,
    letters_for,
    linear_before,
    may_be_of_frequencies,
    places_of,
    prints_square,
)
from kowalevski_cas.reading.statements import SourceStatement
from kowalevski_cas.reading.tried import variable_of

_OF_REST = (POINT, MARKED, FIXED)
OF_FIELD = (*OF_LINEAR_PART, *_OF_REST, "divergence", "measure")
"""The kinds of the roles of what is claimed of the field."""


def of_field(at: RungMaker) -> Iterator[Rung]:
    """What is said of the field: of its linear part, where it vanishes, or of its flow."""
    if at.role.kind in OF_LINEAR_PART:
        yield from _of_linear_part(at)
    elif at.role.kind in _OF_REST:
        yield from _of_rest(at)
    else:
        yield from _of_flow(at)


def _of_linear_part(at: RungMaker) -> Iterator[Rung]:
    """What is said of the linear part at the point of which the words speak."""
    item, known = at.item, at.known
    about: dict[str, Any] = {}
    kind: type[Claim]
    equation: SourceStatement | None = None
    place = places_of
    if at.role.kind == FREQUENCY:
        period = is_period(item)
        kind, about = Period if period else Frequency, {"is_square": prints_square(item)}
        word = "period" if period else "frequency"
        says = f"this is the {word} of small oscillations near this point"
    elif at.role.kind == CHARACTERISTIC:
        kind, about = CharacteristicEquation, {"variable": variable_of(item, known)}
        says = "this is the characteristic equation of the linear part at this point"
    elif at.role.kind in (TRACE, DETERMINANT):
        kind, place = TraceOrDeterminant, point_of_number
        about = {"is_trace": at.role.kind == TRACE}
        says = f"this is the {at.role.kind} of the linear part at this point"
    elif at.role.kind == MATRIX:
        kind, place = LinearPart, matrix_point
        says = "this is the matrix of the linear part"
    else:
        kind = Eigenvalue
        if (equation := equation_of_root(item, known)) is None:
            place = point_of
        says = "this is an eigenvalue of the linear part at this point"
    only_called = at.role.kind == FREQUENCY and is_of_equation(item, known)
    point = () if only_called else place(equation or item, known)
    law = law_of_points(item, known) or next(law for law in known.laws if not law.images)
    rows = () if point else linear_before(item, known)
    if rows:
        law = Law(rows, known.names)
        point = equations_of(dict.fromkeys(law.variables, "0"), item, law, known)
    if kind is Eigenvalue and not (point or rows):
        raise ValueError("not all coordinates of the point are printed")
    kinds = [(kind, says)]
    if at.role.kind == CHARACTERISTIC and may_be_of_frequencies(item, known):
        kinds.append((FrequencyEquation, "this is the equation of the frequencies near this point"))
    letters = letters_for(item, known)
    for (own, words), assumptions in product(kinds, at.ways()):
        rung = at.rung(
            own, words, assumptions, (), (item, *law.rows, *point), law if rows else None,
            printed=item.printed, relations=places(point), **about,
        )  # fmt: skip
        yield replace(
            rung, constants=tuple(one for one in rung.constants if one not in letters),
            is_stronger=only_called
            or (issubclass(kind, Frequency) and any(map(is_damped, law.rows))),
        )  # fmt: skip


def _of_rest(at: RungMaker) -> Iterator[Rung]:
    """That nothing moves at a point that is printed by its coordinates, or in marked letters.

    A map does not move what a letter without its steps gives.
    """
    item, known = at.item, at.known
    if at.role.kind == FIXED:
        law, point = equations_of_fixed_point(item, known)
        says = "the map does not move this point"
        yield at.rung(
            RestPoints, says, at.supposed, (), point, law,
            printed=item.printed, relations=places(point),
        )  # fmt: skip
        return
    rest = law_of_points(item, known)
    assert rest is not None
    says = "nothing moves at this point"
    if at.role.kind == MARKED:
        point = tuple(in_marked_letters(marked(item, rest, known), item, known))
    else:
        point = equations_of_point(item, rest, known)
    angles = any(is_angle(name, rest) for name in rest.variables)
    for assumptions in at.ways():
        if at.role.kind == POINT and not angles:
            yield at.rung(RestPoint, says, assumptions, (), (item, *rest.rows))
            continue
        yield at.rung(
            RestPoints, says, assumptions, (), (*point, *rest.rows),
            printed=item.printed, relations=places(point),
        )  # fmt: skip


def _of_flow(at: RungMaker) -> Iterator[Rung]:
    """What the divergence of the field is, or that the flow preserves a measure.

    The measure is one in the variables of which the rates are printed.
    """
    laws = [law for law in at.known.laws if not law.change]
    law = at.stage.law(at.item, [at.item]) or (laws[0] if len(laws) == 1 else None)
    if law is None or is_free(law):
        raise ValueError("of which of the equations of motion is this said?")
    for assumptions in at.ways():
        if at.role.kind == "divergence":
            says = "this is the divergence of the field"
            yield at.rung(Divergence, says, assumptions, law=law)
            continue
        rated = (name for row in law.rows for name in row.rates)
        coordinates = dict.fromkeys(law.names.scalars(rated)) if law.momenta else ()
        says = "the flow preserves the measure with this density"
        items = (at.item, *law.momenta)
        yield at.rung(
            PreservedMeasure, says, assumptions, (), items, law, coordinates=(*coordinates,)
        )
