"""Which kinds of claims are known of maps, on constraints, and where functions may be any."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import fields
from typing import Any, NamedTuple

from kowalevski_cas.paper.claims import (
    Casimir,
    Claim,
    FirstIntegral,
    Identity,
    Implication,
    Inequality,
    Involution,
    Jacobi,
)
from kowalevski_cas.paper.claims.maps import OF_MAPS
from kowalevski_cas.system.printed_law import PrintedLaw

STATIC = (Identity, Implication, Jacobi, Casimir, Involution)
"""What is claimed of functions, whatever moves."""

OF_FUNCTIONS = (Identity, FirstIntegral, Jacobi)
"""What is claimed where a function may be any one: no dependence of several, and no set."""

BY_CASES = (Identity, Implication, Inequality, FirstIntegral)
"""What is claimed where equations of motion are printed by cases: nothing of what leaves one."""


class Stated(NamedTuple):
    """A kind of claim, what it says, and its attributes."""

    kind: type[Claim]
    says: str
    attributes: dict[str, Any]


def stated_of(law: PrintedLaw, stated: Stated) -> Stated:
    """What a claim states of a law; raises ``ValueError`` for a kind that is not known of it."""
    kind, _, attributes = stated
    if law.conventions.functions and (kind not in OF_FUNCTIONS or any(attributes.values())):
        names = ", ".join(one.name for one in law.conventions.functions)
        raise ValueError(f"{kind.__name__} is not known where {names} may be any function")
    if law.images:
        stated = _of_map(law.images, *stated)
    elif "images" in {field.name for field in fields(kind)}:
        raise ValueError(f"this is no map, but a motion; {kind.__name__} is not known of it")
    return _on_constraints(law.constraints, *stated) if law.constraints else stated


def _of_map(
    images: Sequence[tuple[str, str]], kind: type[Claim], says: str, attributes: dict[str, Any]
) -> Stated:
    """What is claimed of a map; raises ``ValueError`` for a kind that is about motions."""
    kind = OF_MAPS.get(kind, kind)
    own = {field.name for field in fields(kind)}
    attributes = {key: value for key, value in attributes.items() if value or key in own}
    unknown = attributes.keys() - own
    if unknown or (kind not in STATIC and "images" not in own):
        raise ValueError(f"{kind.__name__} is not known of maps: {says}")
    for motion, map_ in (("along every motion", "under the map"), ("no motion", "no step")):
        says = says.replace(motion, map_)
    return Stated(kind, says, {**attributes, **({"images": images} if "images" in own else {})})


def _on_constraints(
    constraints: Sequence[str], kind: type[Claim], says: str, attributes: dict[str, Any]
) -> Stated:
    """What is claimed on the constraints; raises ``ValueError`` if the kind knows no set."""
    kind = Implication if kind is Identity else kind
    of = next((f.name for f in fields(kind) if f.name in ("given", "relations")), "")
    if not of:
        raise ValueError(f"{kind.__name__} is not known on constraints: {says}")
    where = ", ".join(f"${one}$" for one in constraints)
    known = several(attributes.get(of, ()))
    return Stated(kind, f"{says}, where {where}", {**attributes, of: (*known, *constraints)})


def several(formulas: Any) -> tuple[Any, ...]:
    """Formulas as a tuple, also if it is one."""
    return tuple(formulas) if isinstance(formulas, tuple | list) else (formulas,)
