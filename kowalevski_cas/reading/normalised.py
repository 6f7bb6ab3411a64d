r"""Normalisations, as :math:`2L=-1` of a geodesic: the value of an integral fixes the parameter.

A value holds on one level, and follows from nothing: words suppose it of all motions of which they
speak, as those of light, for which it is another one.
"""

from __future__ import annotations

import re

from kowalevski_cas.notation import Derivative, Formula, Name, Number, Power
from kowalevski_cas.reading.cues import cue
from kowalevski_cas.reading.known import ASSUMPTION, NORMALISED, Known, StatementRole
from kowalevski_cas.reading.phrases import clause, is_number
from kowalevski_cas.reading.statements import SourceStatement

_PARAMETER = re.compile(
    r"\b(?:paramet(?:er|ri[sz])|\bparamétr|параметр)\w*\b[^.;§]*"
    r"\b(?:arc[\s-]*length|proper\s+time|unit\s+speed|длин\w+\s+дуги|собственн\w+\s+врем\w+)"
    r"|\b(?:arc[\s-]*length|proper\s+time|длин\w+\s+дуги|собственн\w+\s+врем\w+)\b[^.;§]*"
    r"\b(?:as\s+(?:the\s+)?|is\s+(?:the\s+)?|[-—–]+\s*)(?:parameter|параметр)",
    re.IGNORECASE,
)
"""Words by which the parameter of a curve is its length: its tangent is a unit vector."""


def normalisation(item: SourceStatement, known: Known) -> StatementRole | None:
    """A number for what moves, of which words say that the motion is normalised by it."""
    if said := _of_length(item):
        return StatementRole(ASSUMPTION, f"“{said}” supposes it of curves", NORMALISED, ())
    if len(item.members) != 2 or not known.laws or cue("deduced", item.before):
        return None
    values = [member for member in item.members if is_number([member])]
    varying = known.varying(item.names)
    of_motion = item.derives or any(map(known.is_defined, varying))
    if len(values) != 1 or not of_motion or not (said := cue("normalised", clause(item))):
        return None
    if item.rates and item.derives and len(item.rates) == 1 and values == [Number(0)]:
        return None  # what is at rest
    return StatementRole(ASSUMPTION, f"“{said}” supposes it of the motion", NORMALISED, ())


def _of_length(item: SourceStatement) -> str:
    """The words before a statement by which the square of a tangent is one."""
    if len(item.members) != 2 or Number(1) not in item.members:
        return ""
    said = _PARAMETER.search(item.before)
    rated = item.rates or any("'" in name for name in item.names)
    if not said or _GOES_ON.search(item.before, said.end()):
        return ""
    return said[0] if rated and all(map(_is_of_squares, item.members)) else ""


_GOES_ON = re.compile(r"§[^§]*\w{2}")
"""Words behind a formula that say something of the next one."""


def _is_of_squares(formula: Formula) -> bool:
    """Whether derivatives stand in a formula only where something is squared."""
    if isinstance(formula, Power) and formula.exponent == Number(2):
        return True
    rate = isinstance(formula, Derivative) or (isinstance(formula, Name) and "'" in formula.name)
    return not rate and all(map(_is_of_squares, formula.children()))


def is_of_other_parameter(item: SourceStatement, known: Known) -> bool:
    """Whether t is a coordinate, and what holds of the parameter of the motion was not told here.

    So it is where nothing is normalised before a statement, or only other motions, as those of
    light may be.
    """
    if not known.paper.coordinate_time:
        return False
    before = [one for one in known.sets(item) if known.roles[one].name == ASSUMPTION]
    here = any(one.section is item.section for one in before)
    start = max((one.sentence[1] for one in before), default=0)
    words = known.paper.prose.between(start, item.typed.end)
    return not before or (not here and bool(cue("of light", words)))
