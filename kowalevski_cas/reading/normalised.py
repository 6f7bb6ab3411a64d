r"""Normalisations, as :math:`2L=-1` of a geodesic: the value of an integral fixes the parameter.

A value holds on one level, and follows from nothing: words suppose it of all motions of which they
speak, as those of light, for which it is another one.
"""

from __future__ import annotations

from kowalevski_cas.notation import Number
from kowalevski_cas.reading.cues import cue
from kowalevski_cas.reading.known import ASSUMPTION, NORMALISED, Known, StatementRole
from kowalevski_cas.reading.phrases import clause, is_number
from kowalevski_cas.reading.statements import SourceStatement


def normalisation(item: SourceStatement, known: Known) -> StatementRole | None:
    """A number for what moves, of which words say that the motion is normalised by it."""
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
